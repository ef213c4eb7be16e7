// Bodies that touch nothing: gravity, forces, torques, impulses, damping and the speed limit against their closed formulas.
#include <gtest/gtest.h>

#include <cmath>

#include "measure.hpp"

namespace islet::test {
namespace {

constexpr int substeps = 4;  // of the default schedule

TEST(FreeFall, IsTheSemiImplicitEulerSumToTheLastBit) {
    // With g = 8, dt = 1/64 and h = dt / 4 = 1/256 every number is a short binary fraction, so nothing is rounded and, after n substeps,
    //     v = v0 - g h n,    y = y0 + v0 h n - g h^2 n (n + 1) / 2    exactly. Tolerance: none.
    WorldDef def = weightless();
    def.gravity = {0, -8};
    TestWorld world({.bodies = 1, .shapes = 1, .contacts = 1}, def);
    BodyDef ball = dynamic_at({3, 100});
    ball.linear_velocity = {2, 5};
    const BodyId id = world.add(Circle{}, ball);
    for (int i = 1; i <= 128; ++i) {
        world.step(1, 1.0f / 64);
        const double h = 1.0 / 256, n = substeps * i;
        ASSERT_EQ(double(world->linear_velocity(id).y), 5 - 8 * h * n) << "step " << i;
        ASSERT_EQ(double(world->position(id).y), 100 + 5 * h * n - 8 * h * h * n * (n + 1) / 2) << "step " << i;
        ASSERT_EQ(double(world->position(id).x), 3 + 2 * h * n) << "step " << i;
        ASSERT_EQ(world->linear_velocity(id).x, 2.0f);
    }
}

TEST(FreeFall, StaysWithinHalfASubstepsFallOfTheParabola) {
    // The sum above less the parabola y0 - g t^2 / 2 is -g t h / 2: the integrator's whole error. Rounding adds, over n substeps, at most
    // n eps y to the place and n eps v to the speed; 1e-3 m covers both.
    for (const float dt : {1.0f / 30, 1.0f / 60, 1.0f / 240}) {
        TestWorld world({.bodies = 1, .shapes = 1, .contacts = 1}, sleepless());
        const BodyId id = world.add_circle({0, 50});
        const int steps = static_cast<int>(std::lround(2 / dt));
        world.step(steps, dt);
        const double t = steps * double(dt), h = double(dt) / substeps;
        const double error = double(world->position(id).y) - (50 - g * t * t / 2);
        EXPECT_NEAR(error, -g * t * h / 2, 1e-3) << "dt " << dt;
        EXPECT_LE(std::abs(error), g * t * h / 2 + 1e-3) << "dt " << dt;
    }
}

TEST(FreeFall, GravityScaleScalesGravity) {
    // v = s g t. The speed is rounded once a substep: 240 eps v, 3e-4 m/s.
    TestWorld world(roomy, sleepless());
    for (const float scale : {-1.0f, 0.0f, 0.5f, 1.0f, 3.0f}) {
        BodyDef def = dynamic_at({20 * scale, 0});
        def.gravity_scale = scale;
        const BodyId id = world.add(Circle{}, def);
        EXPECT_EQ(world->gravity_scale(id), scale);
    }
    world.step(60);
    for (const BodyId id : world.bodies()) {
        const double due = -g * double(world->gravity_scale(id));
        EXPECT_NEAR(double(world->linear_velocity(id).y), due, 3e-4 * std::abs(due) + 1e-9);
    }
}

TEST(FreeFall, MassDoesNotMatter) {
    TestWorld world(roomy, sleepless());
    ShapeDef heavy;
    heavy.density = 1000;
    const BodyId a = world.add_circle({0, 0}), b = world.add_circle({5, 0}, 0.5f, heavy);
    world.step(120);
    EXPECT_EQ(world->position(a).y, world->position(b).y);
    EXPECT_EQ(world->linear_velocity(a), world->linear_velocity(b));
}

TEST(Damping, FollowsTheImplicitFormula) {
    // Implicit Euler: v <- v / (1 + h c) each substep, so v = v0 / (1 + h c)^n, and w likewise. Each substep rounds the factor and the
    // product, 2 n eps in all, relative.
    for (const float c : {0.1f, 1.0f, 10.0f}) {
        TestWorld world({.bodies = 1, .shapes = 1, .contacts = 1}, weightless());
        BodyDef def = dynamic_at({});
        def.linear_velocity = {3, -4};
        def.angular_velocity = 2;
        def.linear_damping = c;
        def.angular_damping = 2 * c;
        const BodyId id = world.add(make_box(0.5f, 0.5f), def);
        world.step(60);
        const int n = 60 * substeps;
        const double h = double(step_time) / substeps, keep = std::pow(1 + h * double(c), -n),
                     keep_turn = std::pow(1 + 2 * h * double(c), -n);
        EXPECT_NEAR(double(world->linear_velocity(id).x), 3 * keep, 3 * keep * 2 * n * eps) << "c " << c;
        EXPECT_NEAR(double(world->linear_velocity(id).y), -4 * keep, 4 * keep * 2 * n * eps) << "c " << c;
        EXPECT_NEAR(double(world->angular_velocity(id)), 2 * keep_turn, 2 * keep_turn * 2 * n * eps) << "c " << c;
    }
}

TEST(Damping, GivesATerminalSpeed) {
    // v' = g - c v ends at v = g / c; implicit Euler has the same fixed point. Reached to within rounding, 1e-5 relative.
    TestWorld world({.bodies = 1, .shapes = 1, .contacts = 1}, sleepless());
    BodyDef def = dynamic_at({});
    def.linear_damping = 4;
    const BodyId id = world.add(Circle{}, def);
    world.step(600);
    // Damping acts after gravity within a substep: the fixed point of v <- (v - g h) / (1 + h c) is -g / c.
    EXPECT_NEAR(double(world->linear_velocity(id).y), -g / 4, 1e-5 * g);
}

TEST(Forces, AConstantForceAcceleratesByForceOverMass) {
    // v = F t / m, x = F t (t + h) / (2 m). Rounding once a substep: n eps, relative.
    TestWorld world({.bodies = 1, .shapes = 1, .contacts = 1}, weightless());
    const BodyId id = world.add_box({0, 0}, 0.5f, 0.25f, dense(3));
    const double m = double(world->mass(id));
    EXPECT_NEAR(m, 1.5, 1e-6);
    for (int i = 0; i < 60; ++i) {
        world->apply_force_to_center(id, {4, -2});
        world.step();
    }
    const double h = double(step_time) / substeps, tolerance = 240 * eps * 8;
    EXPECT_NEAR(double(world->linear_velocity(id).x), 4 / m, tolerance);
    EXPECT_NEAR(double(world->linear_velocity(id).y), -2 / m, tolerance);
    EXPECT_NEAR(double(world->position(id).x), 4 * (1 + h) / (2 * m), tolerance);
    EXPECT_EQ(world->angular_velocity(id), 0.0f);
    // Forces act over one step only.
    const Vec2 v = world->linear_velocity(id);
    world.step(10);
    EXPECT_EQ(world->linear_velocity(id), v);
}

TEST(Forces, AConstantTorqueTurnsByTorqueOverInertia) {
    // w = T t / I, angle = T t (t + h) / (2 I), I = m (a^2 + b^2) / 12. Rounding once a substep, and a rotation is renormalised once a
    // step: 480 eps, relative; a turn of d is short by d^5 / 45 (see integrate in math.hpp), at most 1e-6 over this second.
    TestWorld world({.bodies = 1, .shapes = 1, .contacts = 1}, weightless());
    const BodyId id = world.add_box({0, 0}, 0.5f, 0.25f, dense(3));
    const double inertia = 1.5 * (1.0 + 0.25) / 12;
    EXPECT_NEAR(double(world->rotational_inertia(id)), inertia, 1e-7);
    for (int i = 0; i < 60; ++i) {
        world->apply_torque(id, 0.5f);
        world.step();
    }
    const double h = double(step_time) / substeps;
    EXPECT_NEAR(double(world->angular_velocity(id)), 0.5 / inertia, 480 * eps * 4);
    EXPECT_NEAR(double(world->angle(id)), 0.5 * (1 + h) / (2 * inertia), 480 * eps * 4 + 1e-6);
    EXPECT_EQ(world->linear_velocity(id), (Vec2{0, 0}));
}

TEST(Forces, AForceOffTheCentreAlsoTurns) {
    // v = F t / m and w = (r x F) t / I over one step of t = 1/60 s. A handful of roundings.
    TestWorld world({.bodies = 1, .shapes = 1, .contacts = 1}, weightless());
    const BodyId id = world.add_box({2, 1}, 0.5f, 0.5f);
    world->apply_force(id, {0, 3}, {2.5f, 1});
    world.step();
    EXPECT_NEAR(double(world->linear_velocity(id).y), 3.0 / 60, 1e-7);
    EXPECT_NEAR(double(world->angular_velocity(id)), 0.5 * 3 / 60 / (1.0 / 6), 1e-6);
}

TEST(Impulses, ChangeVelocitiesAtOnce) {
    // dv = P / m, dw = (r x P) / I.
    TestWorld world({.bodies = 1, .shapes = 1, .contacts = 1}, weightless());
    const BodyId id = world.add_box({2, 1}, 0.5f, 0.5f, dense(2));
    world->apply_linear_impulse(id, {3, 0}, {2, 1.25f});
    EXPECT_NEAR(double(world->linear_velocity(id).x), 1.5, 1e-6);
    EXPECT_NEAR(double(world->angular_velocity(id)), -0.25 * 3 / (2.0 / 6), 1e-6);
    world->apply_linear_impulse_to_center(id, {0, -2});
    EXPECT_NEAR(double(world->linear_velocity(id).y), -1, 1e-6);
    const double before = double(world->angular_velocity(id));
    world->apply_angular_impulse(id, 1);
    EXPECT_NEAR(double(world->angular_velocity(id)) - before, 3, 1e-6);
}

TEST(SpeedLimit, HoldsEveryBodyAndKeepsItsDirection) {
    // |v| <= max_speed; scaling the vector rounds it by 2 eps.
    WorldDef def = sleepless();
    def.max_speed = 50;
    TestWorld world(roomy, def);
    BodyDef thrown = dynamic_at({0, 0});
    thrown.linear_velocity = {300, 400};
    thrown.gravity_scale = 0;
    const BodyId fast = world.add(Circle{}, thrown), falling = world.add_circle({20, 0});
    world.step();
    EXPECT_NEAR(double(world->linear_velocity(fast).x), 30, 1e-4);
    EXPECT_NEAR(double(world->linear_velocity(fast).y), 40, 1e-4);
    EXPECT_NEAR(double(length(world->position(fast))), 50.0 / 60, 1e-4);
    world.step(600);
    EXPECT_NEAR(double(world->linear_velocity(falling).y), -50, 1e-4);
}

TEST(Kinematic, MovesByItsVelocityAndNothingElse) {
    // x = v t, angle = w t; gravity, forces and impulses do not touch it. One rounding a step.
    TestWorld world(roomy, sleepless());
    BodyDef def;
    def.type = BodyType::kinematic;
    def.linear_velocity = {1, 0.5f};
    def.angular_velocity = 0.25f;
    const BodyId id = world.add(make_box(1, 1), def);
    for (int i = 0; i < 120; ++i) {
        world->apply_force_to_center(id, {100, 100});
        world->apply_linear_impulse_to_center(id, {10, 10});
        world.step();
    }
    EXPECT_EQ(world->linear_velocity(id), (Vec2{1, 0.5f}));
    EXPECT_NEAR(double(world->position(id).x), 2, 120 * 2 * eps);
    EXPECT_NEAR(double(world->position(id).y), 1, 120 * 2 * eps);
    EXPECT_NEAR(double(world->angle(id)), 0.5, 120 * 4 * eps);
}

}  // namespace
}  // namespace islet::test
