// Springs of joints against the exact solution of the damped oscillator.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "measure.hpp"
#include "support/joint_world.hpp"

namespace islet::test {
namespace {

constexpr double substep = 1.0 / 240;  // s, at the default four substeps

/// x(t) of x'' + 2 z w x' + w^2 x = 0 from x = 1 at rest.
double exact_swing(double w, double z, double t) {
    if (z < 1) {
        const double d = w * std::sqrt(1 - z * z);
        return std::exp(-z * w * t) * (std::cos(d * t) + z * w / d * std::sin(d * t));
    }
    if (z == 1) return std::exp(-w * t) * (1 + w * t);
    const double s = std::sqrt(z * z - 1), r1 = -w * (z - s), r2 = -w * (z + s);
    return (r2 * std::exp(r1 * t) - r1 * std::exp(r2 * t)) / (r2 - r1);
}

struct Case {
    float hertz, damping_ratio;
};
const Case cases[] = {{0.5f, 0}, {0.5f, 0.1f}, {1, 0}, {1, 0.1f}, {1, 0.5f}, {1, 0.7f}, {1, 1}, {1, 2}, {2, 0.05f}, {2, 0.5f}, {2, 1}, {5, 0.3f}, {5, 1}};

/// Largest difference from the exact swing over two periods, of a coordinate that starts at `start` from its target.
template <class Position>
double worst_difference(TestWorld& world, const Case& c, double start, Position&& position) {
    const double w = 2 * std::numbers::pi * double(c.hertz), z = double(c.damping_ratio);
    double worst = 0;
    const int steps = static_cast<int>(120 / double(c.hertz));
    for (int i = 1; i <= steps; ++i) {
        world.step();
        worst = std::fmax(worst, std::abs(position() / start - exact_swing(w, z, i * double(step_time))));
    }
    return worst;
}

// Taking the first force a whole substep at once shifts the swing by half a substep: w h / 2 at most, and a little for the damper.
double allowed(const Case& c) { return 0.55 * 2 * std::numbers::pi * double(c.hertz) * substep + 0.002; }

TEST(JointSpring, OfASliderSwingsAndDecaysAsTheExactSolution) {
    for (const Case& c : cases) {
        SCOPED_TRACE(testing::Message() << c.hertz << " Hz, " << c.damping_ratio);
        TestWorld world(room_for_joints, weightless());
        const BodyId wall = world->create_body({}), body = world.add_circle({1, 0});
        const JointId j = world->create_joint(PrismaticJointDef{
            .base = {.body_a = wall, .body_b = body}, .spring = {.enable = true, .hertz = c.hertz, .damping_ratio = c.damping_ratio}});
        EXPECT_LT(worst_difference(world, c, 1, [&] { return double(world->joint_position(j)); }), allowed(c));
    }
}

TEST(JointSpring, OfAHingeSwingsAndDecaysAsTheExactSolution) {
    for (const Case& c : cases) {
        SCOPED_TRACE(testing::Message() << c.hertz << " Hz, " << c.damping_ratio);
        TestWorld world(room_for_joints, weightless());
        const BodyId wall = world->create_body({}), body = world.add(make_box(1, 0.1f), dynamic_at({0, 0}, 0.5f));
        const JointId j = world->create_joint(RevoluteJointDef{
            .base = {.body_a = wall, .body_b = body}, .spring = {.enable = true, .hertz = c.hertz, .damping_ratio = c.damping_ratio}});
        EXPECT_LT(worst_difference(world, c, 0.5, [&] { return double(world->joint_position(j)); }), allowed(c));
    }
}

TEST(JointSpring, OfADistanceJointSwingsAboutItsLength) {
    // Both bodies move; the frequency is that of the pair, whatever its masses.
    for (const Case& c : cases) {
        SCOPED_TRACE(testing::Message() << c.hertz << " Hz, " << c.damping_ratio);
        TestWorld world(room_for_joints, weightless());
        const BodyId light = world.add_circle({0, 0}, 0.2f), heavy = world.add_circle({3.5f, 0}, 0.5f, dense(7));
        world->create_joint(DistanceJointDef{.base = {.body_a = light, .body_b = heavy},
                                             .length = 3,
                                             .spring = {.enable = true, .hertz = c.hertz, .damping_ratio = c.damping_ratio}});
        const auto stretch = [&] { return double(world->position(heavy).x) - double(world->position(light).x) - 3; };
        EXPECT_LT(worst_difference(world, c, 0.5, stretch), allowed(c));
    }
}

TEST(JointSpring, OfAWheelCarriesACarByForceOverStiffness) {
    // A body of mass m on a spring of frequency f rests m g / k = g / (2 pi f)^2 below its target, exactly.
    TestWorld world(room_for_joints, sleepless());
    const BodyId wall = world->create_body({}), body = world.add_circle({0, 0});
    const float hertz = 2;
    const JointId j = world->create_joint(WheelJointDef{
        .base = {.body_a = wall, .body_b = body, .frame_a = {{}, pi / 2}}, .spring = {.enable = true, .hertz = hertz, .damping_ratio = 0.7f}});
    world.step(300);
    const double w = 2 * std::numbers::pi * double(hertz);
    EXPECT_NEAR(double(world->joint_position(j)), -g / (w * w), 1e-5);
    EXPECT_NEAR(double(world->joint_force(j).y), double(world->mass(body)) * g, 0.01 * double(world->mass(body)) * g);
}

TEST(JointSpring, OfAWeldBendsBackAtItsFrequency) {
    // Implicit in both sweeps, so it decays faster than its ratio says; the frequency must still be right within a tenth.
    TestWorld world(room_for_joints, weightless());
    const BodyId wall = world->create_body({}), plank = world.add(make_box(1, 0.1f), dynamic_at({0, 0}, 0.3f));
    const float hertz = 1;
    world->create_joint(WeldJointDef{.base = {.body_a = wall, .body_b = plank}, .angular_hertz = hertz, .angular_damping_ratio = 0.05f});
    double before = 0.3, crossed = 0;
    for (int i = 1; i < 60 && crossed == 0; ++i) {
        world.step();
        const double now = double(world->angle(plank));
        if (now <= 0) crossed = (i - now / (now - before)) * double(step_time);
        before = now;
    }
    EXPECT_NEAR(crossed, 0.25 / double(hertz), 0.025);  // a quarter of a period
}

TEST(JointSpring, MouseJointBringsItsPointToTheTargetAndNoForceMoreThanAllowed) {
    TestWorld world(room_for_joints, sleepless());
    const BodyId box = world.add_box({0, 0});
    world->set_angular_damping(box, 4);  // or it would swing below its corner for long
    const double weight = double(world->mass(box)) * g;
    const JointId j = world->create_joint(MouseJointDef{.body = box, .target = {0.4f, 0.4f}, .max_force = static_cast<float>(3 * weight)});
    world->set_target(j, {2, 3});
    double strongest = 0;
    for (int i = 0; i < 900; ++i) {
        world.step();
        strongest = std::fmax(strongest, double(length(world->joint_force(j))));
    }
    EXPECT_LE(strongest, 3 * weight * 1.0001);
    EXPECT_GT(strongest, 2.9 * weight) << "the bound was never reached: the test shows nothing";
    // It hangs below the target by what its weight stretches the spring: m_eff g / k, a few centimetres at 5 Hz.
    EXPECT_NEAR(double(world->anchor_b(j).x), 2, 0.01);
    EXPECT_NEAR(double(world->anchor_b(j).y), 3, 0.03);
    // The force balances the weight, the corner hangs above the centre.
    EXPECT_NEAR(double(world->joint_force(j).y) / weight, 1, 0.01);
    EXPECT_NEAR(double(world->center_of_mass(box).x), 2, 0.05);
}

}  // namespace
}  // namespace islet::test
