// Rolling down slopes, resistance to rolling, and surfaces that run like a belt.
#include <gtest/gtest.h>

#include <cmath>

#include "measure.hpp"

namespace islet::test {
namespace {

constexpr float radius = 0.5f;

// A disc on a plane tilted by `slope` that falls to the right, with rolling resistance `resistance` and inertia k m r^2.
struct Roller {
    TestWorld world{roomy, sleepless()};
    BodyId disc;
    Vec2 down;

    explicit Roller(double slope, double k, float resistance = 0) {
        const Rot q = make_rot(static_cast<float>(-slope));
        down = rotate(q, {1, 0});
        BodyDef plane;
        plane.angle = static_cast<float>(-slope);
        world.add(make_box(200, 1), plane, rough(0.9f));
        ShapeDef def = rough(0.9f);
        def.rolling_resistance = resistance;
        disc = world.add(Circle{{}, radius}, dynamic_at(rotate(q, {-100, 1 + radius})), def);
        world->set_mass(disc, {2, {0, 0}, static_cast<float>(k) * 2 * radius * radius});
    }
    double speed() const { return double(dot(world->linear_velocity(disc), down)); }
    double slip() const { return speed() + double(world->angular_velocity(disc)) * double(radius); }
    /// Over `steps` steps, after 20 in which the contact settles.
    double acceleration(int steps = 120) {
        world.step(20);
        const double start = speed();
        world.step(steps);
        return (speed() - start) / (steps * double(step_time));
    }
};

TEST(Rolling, BodiesAccelerateByTheirShareOfGSin) {
    // a = g sin / (1 + k) for inertia k m r^2: 2/3 for a disc, 1/2 for a ring, 5/7 for a ball's k = 2/5. 1 %: the lever arms of a contact
    // are kept while the body rolls on by up to a hundredth of a metre.
    const double slope = 12 * double(pi) / 180;
    for (const double k : {0.5, 1.0, 0.4}) {
        Roller roller(slope, k);
        const double due = g * std::sin(slope) / (1 + k);
        EXPECT_NEAR(roller.acceleration(), due, 0.01 * due) << "k " << k;
        EXPECT_NEAR(roller.slip(), 0, 0.01 * roller.speed()) << "k " << k;
    }
}

TEST(RollingResistance, HoldsADiscOnASlopeGentlerThanItself) {
    // The resisting torque is at most c r N, the one of gravity about the contact m g sin r: holds while tan(slope) < c.
    constexpr float c = 0.1f;
    Roller gentle(std::atan(0.9 * double(c)), 0.5, c), steep(std::atan(1.5 * double(c)), 0.5, c);
    gentle.world.step(300);
    EXPECT_NEAR(gentle.speed(), 0, 1e-3);
    // Steeper, a = (g sin - c g cos) / (1 + k), within 2 % of g sin.
    const double slope = std::atan(1.5 * double(c));
    EXPECT_NEAR(steep.acceleration(), g * (std::sin(slope) - double(c) * std::cos(slope)) / 1.5, 0.02 * g * std::sin(slope));
}

TEST(RollingResistance, StopsADiscOnTheFlat) {
    // a = -c g / (1 + k): 2/3 c g for a disc. 2 % for the same lever arms.
    constexpr float c = 0.06f;
    Roller roller(0, 0.5, c);
    roller.world->set_linear_velocity(roller.disc, {3, 0});
    roller.world->set_angular_velocity(roller.disc, -3 / radius);
    const double due = double(c) * g / 1.5;
    EXPECT_NEAR(roller.acceleration(), -due, 0.02 * due);
    roller.world.step(600);
    EXPECT_NEAR(roller.speed(), 0, 1e-3);
    EXPECT_NEAR(double(roller.world->angular_velocity(roller.disc)), 0, 1e-3);
}

TEST(RollingResistance, WithoutItADiscRollsOn) {
    Roller roller(0, 0.5);
    roller.world->set_linear_velocity(roller.disc, {3, 0});
    roller.world->set_angular_velocity(roller.disc, -3 / radius);
    roller.world.step(600);
    // 1 %: see above.
    EXPECT_NEAR(roller.speed(), 3, 0.03);
}

TEST(TangentSpeed, ABeltCarriesABoxAtItsSpeed) {
    // Friction acts until the box moves with the surface: to v = belt speed after v / (mu g) s.
    for (const float speed : {2.0f, -3.0f}) {
        TestWorld world(roomy, sleepless());
        ShapeDef belt = rough(0.5f);
        belt.tangent_speed = speed;
        world.add_ground(0, 100, belt);
        const BodyId box = world.add_box({0, 0.25f}, 0.5f, 0.25f, rough(0.5f));
        // While it slips, it gains mu g, within 2 %.
        world.step(6);
        const double early = double(world->linear_velocity(box).x);
        world.step(6);
        EXPECT_NEAR(std::abs(double(world->linear_velocity(box).x) - early), 0.5 * g * 0.1, 0.01 * g * 0.1 + 0.02) << "speed " << speed;
        world.step(180);
        EXPECT_NEAR(std::abs(double(world->linear_velocity(box).x)), std::abs(double(speed)), 1e-3) << "speed " << speed;
        // Along right_perp of the ground's outward normal: what lies on a floor moves to +x at a positive speed.
        EXPECT_GT(double(world->linear_velocity(box).x) * double(speed), 0) << "speed " << speed;
        EXPECT_NEAR(double(world->angle(box)), 0, 1e-2);
    }
}

TEST(TangentSpeed, OfTwoShapesAdd) {
    // A belt of 2 m/s under a box with a belt of its own, of 1 m/s, on its lower side.
    TestWorld world(roomy, sleepless());
    ShapeDef belt = rough(0.5f), track = rough(0.5f);
    belt.tangent_speed = 2;
    track.tangent_speed = 1;
    world.add_ground(0, 100, belt);
    const BodyId box = world.add_box({0, 0.25f}, 0.5f, 0.25f, track);
    world.step(180);
    EXPECT_NEAR(std::abs(double(world->linear_velocity(box).x)), 3, 1e-3);
}

TEST(TangentSpeed, ABeltUphillHoldsWhatItsFrictionCanCarry) {
    // With mu > tan(slope) a box on the belt climbs at the belt's speed.
    TestWorld world(roomy, sleepless());
    const float slope = 0.2f;
    const Rot q = make_rot(slope);
    ShapeDef belt = rough(0.6f);
    belt.tangent_speed = 1;
    BodyDef plane;
    plane.angle = slope;
    world.add(make_box(50, 1), plane, belt);
    const BodyId box = world.add(make_box(0.5f, 0.25f), dynamic_at(rotate(q, {0, 1.25f}), slope), rough(0.6f));
    world.step(180);
    // The plane rises to the right, and so does the box.
    const double along = double(dot(rotate(q, {1, 0}), world->linear_velocity(box)));
    EXPECT_NEAR(along, 1, 1e-2);
}

}  // namespace
}  // namespace islet::test
