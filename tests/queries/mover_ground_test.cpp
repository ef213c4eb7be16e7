// The character mover among things that move: ground that carries it, and bodies that it pushes.
#include <gtest/gtest.h>

#include <cmath>

#include "hero.hpp"

namespace {

using namespace hero;

// -- moving ground ---------------------------------------------------------------------------------------------------------------------

TEST(Mover, RidesPlatformsThatMove) {
    for (const Vec2 velocity : {Vec2{2, 0}, Vec2{0, 2}, Vec2{0, -2}, Vec2{-1, 1}, Vec2{3, -1}}) {
        SCOPED_TRACE(velocity.x);
        TestWorld w;
        const BodyId platform = w.add_box({0, 0}, 2, 0.5f, {}, BodyType::kinematic);
        Hero hero(w, {0.7f, 0.5f + gap});
        hero.step({}, 3);
        ASSERT_EQ(hero.state.ground, platform);
        const Vec2 start = hero.state.position;
        w->set_linear_velocity(platform, velocity);
        hero.step({}, 90);
        EXPECT_LT(distance(hero.state.position, start + 1.5f * velocity), 1e-3f);
        EXPECT_EQ(hero.state.velocity, Vec2{}) << "relative to the platform";
        // Jumping off it takes its velocity along.
        hero.step({.jump = 4});
        EXPECT_LT(distance(hero.state.velocity, velocity + Vec2{0, 4 - 10 * dt}), 1e-3f);
        EXPECT_LE(hero.worst_overlap, 0);
    }
}

TEST(Mover, RidesATurningPlatformAsIfBoltedToIt) {
    for (const float turning : {0.5f, -0.5f}) {
        SCOPED_TRACE(turning);
        TestWorld w;
        const BodyId platform = w.add_box({0, 0}, 4, 0.5f, {}, BodyType::kinematic);
        Hero hero(w, {1.5f, 0.5f + gap});
        hero.step({}, 3);
        const Vec2 arm = hero.middle();  // from the platform's centre
        w->set_angular_velocity(platform, turning);
        hero.step({}, 72);
        const Rot q = make_rot(turning * 72 * dt);  // 0.6 rad
        EXPECT_LT(distance(hero.middle(), rotate(q, arm)), 5e-3f);
        EXPECT_EQ(hero.steps_in_air, 0);
        EXPECT_LE(hero.worst_overlap, 0.001f);
    }
}

TEST(Mover, AConveyorCarriesItWithItsSurface) {
    for (const float degrees : {0.0f, 20.0f, -20.0f}) {
        SCOPED_TRACE(degrees);
        TestWorld w;
        const Rot q = make_rot(degrees * pi / 180);
        w.add(make_offset_box(50, 1, {rotate(q, {0, -1}), q}), Vec2{0, 0}, {.tangent_speed = 2}, BodyType::static_body);
        Hero hero(w, rotate(q, {0, radius + gap}) - Vec2{0, radius});
        hero.step({}, 5);
        const Vec2 start = hero.state.position;
        hero.step({}, 60);
        EXPECT_LT(distance(hero.state.position, start + rotate(q, {2, 0})), 1e-3f) << "2 m/s, to the right, for a second";
        hero.step({.walk = -2}, 60);
        EXPECT_LT(distance(hero.state.position, start + rotate(q, {2, 0})), 1e-3f) << "walking against it, it stays where it is";
        EXPECT_LE(hero.worst_overlap, 0);
    }
}

TEST(Mover, APlatformThatTurnsTooSteepThrowsItOff) {
    TestWorld w;
    const BodyId platform = w.add_box({0, 10}, 4, 0.5f, {}, BodyType::kinematic);
    Hero hero(w, {1.5f, 10.5f + gap});
    hero.step({}, 3);
    w->set_angular_velocity(platform, -1);
    hero.step({}, 120);
    EXPECT_FALSE(hero.state.ground);
    EXPECT_LT(hero.state.position.y, 8);
    EXPECT_LE(hero.worst_overlap, 0.001f);
}

TEST(Mover, AWallThatMovesPushesItAlong) {
    TestWorld w;
    w.add_ground(0);
    const BodyId wall = w.add_box({-2, 1}, 0.5f, 1, {}, BodyType::kinematic);
    Hero hero(w, {0, gap});
    hero.step({}, 2);
    w->set_linear_velocity(wall, {1.5f, 0});
    hero.step({}, 180);
    // The wall's face went from -1.5 to 3.
    EXPECT_NEAR(hero.state.position.x, w->position(wall).x + 0.5f + radius + gap, 2e-3f);
    EXPECT_NEAR(hero.state.position.y, gap, 1e-3f);
    EXPECT_LE(hero.worst_overlap, 0.001f);
}

TEST(Mover, ALiftThatCrushesItSaysSo) {
    TestWorld w;
    w.add_box({0, 3.5f}, 5, 0.5f, {}, BodyType::static_body);  // underside at 3
    const BodyId lift = w.add_box({0, -0.5f}, 2, 0.5f, {}, BodyType::kinematic);
    Hero hero(w, {0, gap});
    hero.step({}, 2);
    w->set_linear_velocity(lift, {0, 1});
    hero.step({}, 60);
    EXPECT_EQ(hero.state.squeezed, 0u) << "0.2 m of room are left";
    EXPECT_LE(hero.worst_overlap, 0.001f);
    hero.step({}, 30);
    EXPECT_EQ(hero.state.squeezed, 1u);
    EXPECT_TRUE(is_finite(hero.state.position));
    w->set_linear_velocity(lift, {0, -1});
    hero.step({}, 60);
    EXPECT_EQ(hero.state.squeezed, 0u);
    EXPECT_EQ(hero.state.ground, lift);
}

// -- bodies ------------------------------------------------------------------------------------------------------------------------------

TEST(Mover, PushesAsHardAsItMay) {
    for (const float mass : {1.0f, 20.0f, 200.0f}) {
        SCOPED_TRACE(mass);
        TestWorld w(test::roomy, {.gravity = {0, -10}});
        w.add_ground(0, 100, {.friction = 0});
        const BodyId crate = w.add_box({2, 1}, 0.5f, 1, {.friction = 0, .density = 0.5f * mass});
        Hero hero(w, {1.5f - radius - gap - 1e-6f, gap});
        hero.step({}, 2);
        hero.step({.walk = 3});
        // The momentum that the two would share, but no more than the force can give in a step.
        const float together = mass * 70 / (mass + 70);
        const float want = std::min(3 * together, 400 * dt) / mass;
        EXPECT_NEAR(w->linear_velocity(crate).x, want, 1e-3f * want);
        hero.step({.walk = 3}, 120);
        const float in_time = 400 * 2 / mass;  // force times 2 s
        EXPECT_NEAR(w->linear_velocity(crate).x, std::min(3.0f, in_time), 0.1f);
        EXPECT_NEAR(w->angular_velocity(crate), 0, 1e-2f) << "without toppling it";
        EXPECT_LE(hero.worst_overlap, 0.002f);
    }
}

TEST(Mover, ACrateHeldByMoreFrictionThanItsForceIsAWall) {
    TestWorld w;
    w.add_ground(0, 100, {.friction = 1});
    const BodyId crate = w.add_box({2, 1}, 0.5f, 1, {.friction = 1, .density = 50});  // 100 kg: 1000 N of friction
    Hero hero(w, {0, gap});
    hero.step({.walk = 3}, 180);
    EXPECT_NEAR(w->position(crate).x, 2, 2e-3f);
    EXPECT_NEAR(hero.state.position.x, 1.5f - radius - gap, 5e-3f);
    EXPECT_LE(hero.worst_overlap, 0.002f);
}

TEST(Mover, ItsWeightLiesOnWhatItStandsOn) {
    TestWorld w(test::roomy, {.gravity = {0, -10}});
    w.add_ground(0);
    const BodyId crate = w.add_box({0, 0.5f}, 0.5f, 0.5f, {.density = 30});  // 30 kg
    Hero hero(w, {0, 1 + gap});
    hero.step({}, 120);
    EXPECT_EQ(hero.state.ground, crate);
    float force = 0;
    for (const ContactInfo& c : w.contacts()) {
        for (std::uint32_t i = 0; i < c.point_count; ++i) force += c.points[i].normal_impulse * 4 / dt;  // impulses are of one of 4 substeps
    }
    EXPECT_NEAR(force, (30 + 70) * 10, 20);
}

}  // namespace
