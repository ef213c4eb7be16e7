// Coulomb friction: when bodies hold, how they slide, and when sliding turns into rolling.
#include <gtest/gtest.h>

#include <cmath>

#include "measure.hpp"

namespace islet::test {
namespace {

// A block on a plane tilted by `slope` that falls to the right. The block is low, so that it does not tip.
struct Slope {
    TestWorld world{roomy, sleepless()};
    BodyId block;
    Vec2 down;

    Slope(double slope, float mu) {
        const Rot q = make_rot(static_cast<float>(-slope));
        down = rotate(q, {1, 0});
        BodyDef plane;
        plane.angle = static_cast<float>(-slope);
        world.add(make_box(200, 1), plane, rough(mu));
        block = world.add(make_box(0.5f, 0.25f), dynamic_at(rotate(q, {-100, 1.25f}), static_cast<float>(-slope)), rough(mu));
    }
    double speed() const { return double(dot(world->linear_velocity(block), down)); }
    double place() const { return double(dot(world->center_of_mass(block), down)); }
};

TEST(Friction, BoxRestsBelowTheCriticalAngle) {
    // Holds while tan(slope) < mu. Half a degree below, nothing moves but by the settling of the contact: less than a millimetre in 5 s.
    for (const float mu : {0.2f, 0.5f, 0.8f}) {
        Slope slope(std::atan(double(mu)) - 0.5 * double(pi) / 180, mu);
        slope.world.step(30);
        const double start = slope.place();
        slope.world.step(300);
        EXPECT_NEAR(slope.place(), start, 1e-3) << "mu " << mu;
        EXPECT_NEAR(slope.speed(), 0, 1e-3) << "mu " << mu;
    }
}

TEST(Friction, BoxSlidesAboveTheCriticalAngle) {
    // a = g (sin - mu cos), measured from half a second on, when the contact has settled. The tolerance, 1 % of the friction's part
    // g mu cos, is what the normal force wavers by as the box's contact points move on.
    for (const float mu : {0.2f, 0.5f, 0.8f}) {
        for (const double degrees : {0.5, 5.0}) {
            const double angle = std::atan(double(mu)) + degrees * double(pi) / 180;
            Slope slope(angle, mu);
            slope.world.step(30);
            const double start = slope.speed();
            slope.world.step(120);
            const double due = g * (std::sin(angle) - double(mu) * std::cos(angle));
            EXPECT_NEAR((slope.speed() - start) / 2, due, 0.01 * g * double(mu) * std::cos(angle))
                << "mu " << mu << ", " << degrees << " over";
        }
    }
}

TEST(Friction, ASlidingBoxSlowsByMuG) {
    // v = v0 - mu g t: stops after v0 / (mu g) s and v0^2 / (2 mu g) m. The box is set down, so its contact carries its weight from the
    // first step; one step's way, v0 dt, is allowed, and 1 % of the deceleration.
    constexpr float mu = 0.4f;
    constexpr double v0 = 6;
    TestWorld world(roomy, sleepless());
    world.add_ground(0, 100, rough(mu));
    BodyDef def = dynamic_at({0, 0.25f});
    def.linear_velocity = {static_cast<float>(v0), 0};
    const BodyId box = world.add(make_box(0.5f, 0.25f), def, rough(mu));
    world.step(10);
    const double early = double(world->linear_velocity(box).x);
    world.step(60);
    EXPECT_NEAR(early - double(world->linear_velocity(box).x), double(mu) * g, 0.01 * double(mu) * g);
    world.step(60);
    EXPECT_NEAR(double(world->linear_velocity(box).x), 0, 1e-4);
    EXPECT_NEAR(double(world->position(box).x), v0 * v0 / (2 * double(mu) * g), v0 / 60);
}

TEST(Friction, ADecelerationDoesNotDependOnTheMass) {
    constexpr float mu = 0.4f;
    TestWorld world(roomy, sleepless());
    world.add_ground(0, 100, rough(mu));
    double speeds[2];
    int i = 0;
    for (const float density : {0.1f, 100.0f}) {
        ShapeDef def = rough(mu);
        def.density = density;
        BodyDef body = dynamic_at({30 * static_cast<float>(i), 0.25f});
        body.linear_velocity = {5, 0};
        const BodyId box = world.add(make_box(0.5f, 0.25f), body, def);
        world.step(60);
        speeds[i++] = double(world->linear_velocity(box).x);
    }
    EXPECT_NEAR(speeds[0], speeds[1], 0.01);
}

// A body that slides at 6 m/s without turning, and is let run until it rolls.
double end_speed(bool ring) {
    constexpr float mu = 0.3f, radius = 0.5f;
    TestWorld world(roomy, sleepless());
    world.add_ground(0, 100, rough(mu));
    BodyDef def = dynamic_at({-50, radius});
    def.linear_velocity = {6, 0};
    const BodyId disc = world.add(Circle{{}, radius}, def, rough(mu));
    if (ring) world->set_mass(disc, {1, {0, 0}, radius * radius});
    world.step(180);
    const double v = double(world->linear_velocity(disc).x);
    EXPECT_NEAR(-double(world->angular_velocity(disc)) * double(radius), v, 0.01) << "still slips";
    return v;
}

TEST(Friction, ASlidingDiscRollsInTheEndAtTwoThirdsOfItsSpeed) {
    // Angular momentum about a point of the ground is kept: m v0 r = m v r + I v / r, so v = v0 / (1 + I / (m r^2)): 2/3 for a disc,
    // 1/2 for a ring, whatever mu is. 0.5 % for the drag of lever arms that are kept while the body rolls on.
    EXPECT_NEAR(end_speed(false), 4, 0.005 * 6);
    EXPECT_NEAR(end_speed(true), 3, 0.005 * 6);
}

TEST(Friction, ASlidingDiscRollsAfterTheTimeOfTheFormula) {
    // Slip v - w r starts at v0 and falls by mu g (1 + m r^2 / I) = 3 mu g per second: v0 / (3 mu g). Two steps are allowed.
    constexpr float mu = 0.2f;
    TestWorld world(roomy, sleepless());
    world.add_ground(0, 100, rough(mu));
    BodyDef def = dynamic_at({-50, 0.5f});
    def.linear_velocity = {3, 0};
    const BodyId disc = world.add(Circle{{}, 0.5f}, def, rough(mu));
    int steps = 0;
    while (steps < 600 && double(world->linear_velocity(disc).x) + double(world->angular_velocity(disc)) * 0.5 > 0.02) {
        world.step();
        ++steps;
    }
    EXPECT_NEAR(steps / 60.0, 3 / (3 * double(mu) * g), 2.0 / 60);
}

TEST(Friction, TwoShapesMixByTheGeometricMean) {
    // sqrt(0.9 * 0.4) = 0.6: seen in the contact, and in the deceleration of 6 m/s^2 within 1 %.
    TestWorld world(roomy, sleepless());
    world.add_ground(0, 100, rough(0.9f));
    BodyDef def = dynamic_at({0, 0.25f});
    def.linear_velocity = {8, 0};
    const BodyId box = world.add(make_box(0.5f, 0.25f), def, rough(0.4f));
    world.step(10);
    ASSERT_EQ(world.contacts().size(), 1u);
    EXPECT_NEAR(double(world.contacts()[0].friction), 0.6, 1e-6);
    const double early = double(world->linear_velocity(box).x);
    world.step(60);
    EXPECT_NEAR(early - double(world->linear_velocity(box).x), 6, 0.06);
}

TEST(Friction, WithoutItABoxSlidesForEver) {
    // Nothing acts along the ground: v stays. One smooth surface is enough, as sqrt(0 * mu) = 0.
    TestWorld world(roomy, sleepless());
    world.add_ground(0, 100, rough(0));
    BodyDef def = dynamic_at({-50, 0.25f});
    def.linear_velocity = {8, 0};
    const BodyId box = world.add(make_box(0.5f, 0.25f), def, rough(1));
    world.step(600);
    // The normal is that of a flat box: it has no sideways part but for rounding and the settling of the box, 1e-3 m/s.
    EXPECT_NEAR(double(world->linear_velocity(box).x), 8, 1e-3);
    EXPECT_NEAR(double(world->position(box).x), 30, 0.02);
}

TEST(Friction, PulledBelowItsLimitABoxStays) {
    // A pull of 0.9 mu m g holds; one of 1.1 mu m g accelerates by 0.1 mu g (5 % of mu g for the wavering of the normal force).
    constexpr float mu = 0.5f;
    for (const double pull : {0.9, 1.1}) {
        TestWorld world(roomy, sleepless());
        world.add_ground(0, 100, rough(mu));
        const BodyId box = world.add_box({0, 0.25f}, 0.5f, 0.25f, rough(mu));
        const double force = pull * double(mu) * double(world->mass(box)) * g;
        world.step(10);
        for (int i = 0; i < 120; ++i) {
            // Low on the box, so that it does not tip.
            const Vec2 at = world->position(box) - Vec2{0, 0.25f};
            world->apply_force(box, {static_cast<float>(force), 0}, at);
            world.step();
        }
        const double due = pull < 1 ? 0 : (pull - 1) * double(mu) * g * 2;
        EXPECT_NEAR(double(world->linear_velocity(box).x), due, pull < 1 ? 1e-3 : 0.05 * double(mu) * g * 2) << "pull " << pull;
    }
}

}  // namespace
}  // namespace islet::test
