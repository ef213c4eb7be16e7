// How bodies move when they are told to: velocities, forces, impulses, damping, teleports. Against closed formulas.
#include <gtest/gtest.h>

#include <cmath>

#include "support/test_world.hpp"

namespace {

using namespace islet;
using namespace islet::test;

constexpr float dt = 1.0f / 60;

struct Space : TestWorld {  // without gravity
    Space() : TestWorld(roomy, floating()) {}
    static WorldDef floating() {
        WorldDef def;
        def.gravity = {0, 0};
        return def;
    }
};

TEST(Motion, AForceActsOverOneStepAndIsGone) {
    Space w;
    ShapeDef shape;
    shape.density = 2;
    const BodyId body = w.add_box({0, 0}, 0.5f, 0.5f, shape);  // 2 kg
    w->apply_force_to_center(body, {6, -12});
    EXPECT_EQ(w->linear_velocity(body), Vec2{}) << "not before the step";
    w.step();
    // v = F t / m; with n substeps the way is a t^2 (n + 1) / 2n.
    EXPECT_NEAR(w->linear_velocity(body).x, 6 * dt / 2, 1e-6f);
    EXPECT_NEAR(w->linear_velocity(body).y, -12 * dt / 2, 1e-6f);
    EXPECT_NEAR(w->position(body).x, 3 * dt * dt * 5 / 8, 1e-7f);
    EXPECT_EQ(w->angular_velocity(body), 0.0f);
    w.step();
    EXPECT_NEAR(w->linear_velocity(body).x, 6 * dt / 2, 1e-6f) << "it acted only once";
}

TEST(Motion, AForceOffCentreTurns) {
    Space w;
    const BodyId body = w.add_box({10, 0});
    const float inertia = w->rotational_inertia(body);
    w->apply_force(body, {0, 3}, {10.5f, 7});
    w->apply_torque(body, -1);
    w.step();
    EXPECT_NEAR(w->linear_velocity(body).y, 3 * dt, 1e-6f);
    EXPECT_NEAR(w->angular_velocity(body), (0.5f * 3 - 1) * dt / inertia, 1e-6f);
}

TEST(Motion, ForcesAddUp) {
    Space w;
    const BodyId body = w.add_box({0, 0});
    for (int i = 0; i < 4; ++i) w->apply_force_to_center(body, {1, 0});
    w->apply_force(body, {0, 2}, {0, 5});
    w.step();
    EXPECT_NEAR(w->linear_velocity(body).x, 4 * dt, 1e-6f);
    EXPECT_NEAR(w->linear_velocity(body).y, 2 * dt, 1e-6f);
}

TEST(Motion, AnImpulseActsAtOnce) {
    Space w;
    ShapeDef shape;
    shape.density = 4;
    const BodyId body = w.add_box({0, 0}, 0.5f, 0.5f, shape);
    const float inertia = w->rotational_inertia(body);
    w->apply_linear_impulse_to_center(body, {8, 4});
    EXPECT_EQ(w->linear_velocity(body), (Vec2{2, 1}));
    EXPECT_EQ(w->angular_velocity(body), 0.0f);
    w->apply_angular_impulse(body, 3);
    EXPECT_FLOAT_EQ(w->angular_velocity(body), 3 / inertia);
    w->apply_linear_impulse(body, {-8, -4}, {0, 0.5f});  // r x J = -0.5 * -8
    EXPECT_EQ(w->linear_velocity(body), Vec2{});
    EXPECT_FLOAT_EQ(w->angular_velocity(body), (3 + 4) / inertia);
}

TEST(Motion, PushesAreForDynamicBodiesOnly) {
    Space w;
    const BodyId body = w.add_box({0, 0}, 1, 1, {}, BodyType::kinematic);
    w->set_linear_velocity(body, {1, 0});
    w->apply_force_to_center(body, {100, 0});
    w->apply_linear_impulse_to_center(body, {100, 0});
    w->apply_angular_impulse(body, 100);
    w->apply_torque(body, 100);
    w.step(60);
    EXPECT_EQ(w->linear_velocity(body), (Vec2{1, 0}));
    EXPECT_EQ(w->angular_velocity(body), 0.0f);
    EXPECT_NEAR(w->position(body).x, 1, 1e-5f);
    EXPECT_TRUE(w.errors.empty());
}

TEST(Motion, ABodyOfFixedRotationDoesNotTurn) {
    Space w;
    const BodyId body = w.add_box({0, 0});
    w->set_angular_velocity(body, 2);
    w->set_fixed_rotation(body, true);
    EXPECT_EQ(w->angular_velocity(body), 0.0f);
    w->apply_linear_impulse(body, {1, 0}, {0, 0.5f});
    w->apply_torque(body, 10);
    w.step(10);
    EXPECT_EQ(w->angle(body), 0.0f);
    EXPECT_FLOAT_EQ(w->linear_velocity(body).x, 1);
    w->set_fixed_rotation(body, false);
    w->apply_angular_impulse(body, 1);
    EXPECT_FLOAT_EQ(w->angular_velocity(body), 6);
}

TEST(Motion, VelocityAtAPointIncludesTheTurning) {
    Space w;
    const BodyId body = w.add_box({1, 1});
    w->set_linear_velocity(body, {3, 0});
    w->set_angular_velocity(body, 2);
    EXPECT_EQ(w->velocity_at(body, {1, 1}), (Vec2{3, 0}));
    EXPECT_EQ(w->velocity_at(body, {1, 3}), (Vec2{3 - 2 * 2, 0}));
    EXPECT_EQ(w->velocity_at(body, {4, 1}), (Vec2{3, 2 * 3}));
}

TEST(Motion, FreeFallFollowsTheFormula) {
    TestWorld w;
    const BodyId body = w.add_box({0, 100});
    const BodyId light = w.add_box({5, 100});
    const BodyId weightless = w.add_box({10, 100});
    w->set_gravity_scale(light, 0.5f);
    w->set_gravity_scale(weightless, 0);
    w.step(60);
    // v = g t; symplectic Euler over N substeps: y = g t^2 / 2 (1 + 1 / N).
    const float factor = 1 + 1.0f / 240;
    EXPECT_NEAR(w->linear_velocity(body).y, -10, 1e-4f);
    EXPECT_NEAR(w->position(body).y, 100 - 5 * factor, 1e-3f);
    EXPECT_NEAR(w->position(light).y, 100 - 2.5f * factor, 1e-3f);
    EXPECT_EQ(w->position(weightless), (Vec2{10, 100}));
    w->set_gravity({3, 0});
    EXPECT_EQ(w->gravity(), (Vec2{3, 0}));
    w->set_linear_velocity(body, {0, 0});
    w.step(60);
    EXPECT_NEAR(w->linear_velocity(body).x, 3, 1e-4f);
}

TEST(Motion, DampingIsExponentialInTheLimit) {
    Space w;
    const BodyId body = w.add_box({0, 0});
    w->set_linear_velocity(body, {8, 0});
    w->set_angular_velocity(body, 4);
    w->set_linear_damping(body, 0.5f);
    w->set_angular_damping(body, 2);
    w.step(60);
    // Implicit: one factor 1 / (1 + h d) a substep.
    EXPECT_NEAR(w->linear_velocity(body).x, 8 * std::pow(1 + 0.5 / 240, -240), 1e-4);
    EXPECT_NEAR(w->angular_velocity(body), 4 * std::pow(1 + 2.0 / 240, -240), 1e-4);
    EXPECT_NEAR(w->linear_velocity(body).x, 8 * std::exp(-0.5), 0.01);
}

TEST(Motion, ABodyTurnsAboutItsCentreOfMass) {
    Space w;
    const BodyId body = w.add(make_offset_box(0.5f, 0.5f, {{1, 0}, {}}), Vec2{0, 0});
    w->set_angular_velocity(body, 1);
    w.step(60);
    EXPECT_LT(distance(w->center_of_mass(body), {1, 0}), 1e-5f);
    EXPECT_NEAR(w->angle(body), 1, 1e-4f);
    EXPECT_LT(distance(w->position(body), Vec2{1, 0} - Vec2{std::cos(1.0f), std::sin(1.0f)}), 1e-3f);
}

TEST(Motion, AngleStaysBetweenMinusPiAndPi) {
    Space w;
    const BodyId body = w.add_box({0, 0});
    w->set_angular_velocity(body, 5);
    for (int i = 1; i <= 300; ++i) {
        w.step();
        const float angle = w->angle(body);
        ASSERT_GT(angle, -pi);
        ASSERT_LE(angle, pi);
        ASSERT_NEAR(std::remainder(angle - 5 * dt * static_cast<float>(i), 2 * pi), 0, 2e-3f);
    }
}

TEST(Motion, TheSpeedLimitHolds) {
    WorldDef def = Space::floating();
    def.max_speed = 10;
    TestWorld w(roomy, def);
    const BodyId body = w.add_box({0, 0});
    w->set_linear_velocity(body, {30, 40});
    w.step();
    EXPECT_LT(distance(w->linear_velocity(body), {6, 8}), 1e-5f) << "the direction is kept";
    EXPECT_LT(length(w->position(body)), 10 * dt + 1e-5f);
}

TEST(Motion, TeleportingKeepsTheVelocityAndFindsContactsAnew) {
    TestWorld w;
    w.add_ground();
    const BodyId body = w.add_box({0, 0.5f});
    const BodyId mover = w.add_box({10, 5});
    w.step(30);
    EXPECT_EQ(w.contacts().size(), 1u);
    w->set_linear_velocity(body, {1, 2});
    w->set_transform(body, {-10, 20}, 1);
    EXPECT_EQ(w->position(body), (Vec2{-10, 20}));
    EXPECT_NEAR(w->angle(body), 1, 1e-6f);
    EXPECT_EQ(w->linear_velocity(body), (Vec2{1, 2}));
    EXPECT_EQ(w.contacts().size(), 0u);
    EXPECT_EQ(w->validate(), nullptr);
    w->set_transform(mover, {-10, 0.5f}, 0);
    w->set_linear_velocity(mover, {0, 0});
    w.step(1);
    EXPECT_EQ(w.contacts().size(), 1u) << "the contact at the new place is found in the next step";
    EXPECT_EQ(w->validate(), nullptr);
}

TEST(Motion, TheGroundMayBeTeleportedAway) {
    TestWorld w;
    const BodyId ground = w.add_ground();
    const BodyId body = w.add_box({0, 0.5f});
    w.step(120);
    ASSERT_FALSE(w->is_awake(body));
    w->set_transform(ground, {0, -6}, 0);
    EXPECT_TRUE(w->is_awake(body));
    w.step(120);
    EXPECT_NEAR(w->position(body).y, -4.5f, 0.01f);
}

TEST(Motion, MaterialsTakeEffectOnContactsThatExist) {
    TestWorld w;
    const BodyId ground = w.add_ground();
    const BodyId body = w.add_box({0, 0.5f});
    w.step(10);
    EXPECT_FLOAT_EQ(w.contacts().at(0).friction, 0.6f);
    w->set_friction(w.shape_of(body), 0);
    w->set_restitution(w.shape_of(ground), 0.25f);
    EXPECT_EQ(w.contacts().at(0).friction, 0.0f) << "the geometric mean";
    EXPECT_EQ(w.contacts().at(0).restitution, 0.25f) << "the larger";
    w->set_linear_velocity(body, {5, 0});
    w.step(60);
    EXPECT_NEAR(w->linear_velocity(body).x, 5, 0.01f) << "no friction, no loss";
    w->set_friction(w.shape_of(body), 0.6f);
    w.step(60);
    EXPECT_NEAR(w->linear_velocity(body).x, 0, 0.01f);
}

TEST(Motion, AConveyorCarriesWhatStandsOnIt) {
    TestWorld w;
    const BodyId ground = w.add_ground();
    const BodyId body = w.add_box({0, 0.5f});
    w.step(10);
    w->set_tangent_speed(w.shape_of(ground), 2);
    w.step(120);
    EXPECT_NEAR(std::fabs(w->linear_velocity(body).x), 2, 0.05f);
}

TEST(Motion, TheSolverCanBeChangedAtAnyTime) {
    TestWorld w;
    w.add_ground();
    const BodyId body = w.add_box({0, 0.5f});
    SolverDef classic;
    classic.schedule = Schedule::classic;
    classic.substeps = 1;
    classic.iterations = 10;
    w.step(10);
    w->set_solver(classic);
    EXPECT_EQ(w->solver().schedule, Schedule::classic);
    EXPECT_EQ(w->solver().iterations, 10u);
    w.step(60);
    EXPECT_NEAR(w->position(body).y, 0.5f, 0.01f);
    w->set_solver({});
    w.step(60);
    EXPECT_NEAR(w->position(body).y, 0.5f, 0.01f);
}

}  // namespace
