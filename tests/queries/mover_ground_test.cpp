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

// The contacts' force on the ground, N.
float force_on(const TestWorld& w, BodyId ground) {
    float force = 0;
    for (const ContactInfo& c : w.contacts()) {
        if (w->body(c.shape_a) != ground && w->body(c.shape_b) != ground) continue;
        for (std::uint32_t i = 0; i < c.point_count; ++i) force += c.points[i].normal_impulse * 4 / dt;
    }
    return force;
}

TEST(Mover, ALightBodyThatRestsBearsItsWholeWeight) {
    for (const float mass : {8.0f, 15.0f, 70.0f}) {
        for (const float offset : {-0.5f, 0.0f, 0.4f}) {
            SCOPED_TRACE(mass);
            SCOPED_TRACE(offset);
            TestWorld w(test::roomy, {.gravity = {0, -10}});
            const BodyId ground = w.add_ground(0);
            BodyId top;
            for (const float y : {0.25f, 0.75f, 1.25f}) top = w.add_box({0, y}, 0.6f, 0.25f, {.density = mass / 0.6f});
            Hero hero(w, {offset, 1.5f + gap});
            hero.step({}, 120);
            hero.steps_in_air = 0;
            for (int i = 0; i < 60; ++i) {
                hero.step({});
                ASSERT_NEAR(force_on(w, ground), (3 * mass + 70) * 10, 0.03f * (3 * mass + 70) * 10);
            }
            EXPECT_EQ(hero.state.ground, top);
            EXPECT_EQ(hero.steps_in_air, 0);
        }
    }
}

// A mover drops onto a body and goes where that goes: no faster than from a fall of 3 m.
void expect_slow_ride(TestWorld& w, BodyId body, Vec2 feet, int steps, float fastest) {
    Hero hero(w, feet);
    hero.def = {};
    for (int i = 0; i < steps; ++i) {
        const Vec2 from = hero.state.position;
        hero.step({});
        ASSERT_LE(distance(hero.state.position, from), 8 * dt) << "step " << i;
        ASSERT_LE(length(hero.state.velocity), 8) << "step " << i;
        ASSERT_LE(length(w->linear_velocity(body)) + 0.5f * std::abs(w->angular_velocity(body)), fastest) << "step " << i;
    }
}

TEST(Mover, IsNotThrownByABallThatRollsAwayBelowIt) {
    for (const float size : {0.2f, 0.35f, 0.6f}) {
        for (const float mass : {0.1f, 0.5f, 2.0f, 10.0f, 70.0f}) {
            for (int k = 0; k < 10; ++k) {
                SCOPED_TRACE(testing::Message() << size << " m, " << mass << " kg, start " << k);
                TestWorld w(test::roomy, {.gravity = {0, -10}});
                w.add_ground(0);
                const BodyId ball = w.add_circle({0, size}, size, {.density = mass / (pi * size * size)});
                expect_slow_ride(w, ball, {0.02f * static_cast<float>(k + 1), 2 * size + 0.3f}, 120, 12);
                if (HasFatalFailure()) return;
            }
        }
    }
}

TEST(Mover, IsNotThrownByAPlankThatGivesWay) {
    for (const float mass : {2.0f, 8.0f, 40.0f, 200.0f}) {
        for (int k = 0; k < 10; ++k) {
            SCOPED_TRACE(testing::Message() << mass << " kg, start " << k);
            TestWorld w(test::roomy, {.gravity = {0, -10}});
            const BodyId ground = w->create_body({});
            const BodyId plank = w.add_box({0, 0}, 2, 0.1f, {.density = mass / 0.8f});
            RevoluteJointDef hinge;
            hinge.base = {.body_a = ground, .body_b = plank};
            w->create_joint(hinge);
            expect_slow_ride(w, plank, {0.1f + 0.18f * static_cast<float>(k), 0.3f}, 60, 4);
            if (HasFatalFailure()) return;
        }
    }
}

TEST(Mover, ThrowsNoLightCratesAbout) {
    for (const float density : {1.0f, 4.0f, 20.0f}) {
        for (int k = 0; k < 8; ++k) {
            SCOPED_TRACE(testing::Message() << density << " kg/m^2, start " << k);
            TestWorld w(test::roomy, {.gravity = {0, -10}});
            w.add_ground(0);
            for (int i = 0; i < 4; ++i) w.add_box({0, 0.25f + 0.5f * static_cast<float>(i)}, 0.25f, 0.25f, {.density = density});
            for (int i = 0; i < 6; ++i) w.add_box({1 + 0.6f * static_cast<float>(i), 0.3f}, 0.28f, 0.28f, {.density = density});
            Hero hero(w, {0.05f * static_cast<float>(k), 2.3f});
            hero.def = {};
            for (int i = 0; i < 400; ++i) {
                hero.step({.walk = i < 100 ? 0.0f : 2.0f});
                ASSERT_LE(length(hero.state.velocity), 8) << "step " << i;
                for (const BodyId body : w.bodies()) ASSERT_LE(length(w->linear_velocity(body)), 8) << "step " << i;
            }
        }
    }
}

// -- one-way platforms that move -------------------------------------------------------------------------------------------------------

TEST(Mover, AOneWayPlatformThatRisesCatchesIt) {
    for (const float speed : {-2.0f, 0.0f, 1.0f, 2.0f, 4.0f, 6.0f}) {
        for (int k = 0; k < 15; ++k) {
            SCOPED_TRACE(testing::Message() << speed << " m/s, start " << k);
            TestWorld w(test::roomy, {.gravity = {0, -10}});
            const BodyId lift = w.add_box({0, 0}, 5, 0.1f, {.one_way = {0, 1}}, BodyType::kinematic);
            w->set_linear_velocity(lift, {0, speed});
            MoverState state{.position = {0, 0.1f + gap}};
            for (int i = 0; i < 120; ++i) {
                w->step(dt);
                ASSERT_TRUE(step_mover(*w, {}, state, {.jump = i == 10 ? 3 + 0.2f * static_cast<float>(k) : 0}, dt));
                ASSERT_GE(state.position.y, w->position(lift).y + 0.1f) << "step " << i;
            }
            EXPECT_EQ(state.ground, lift);
        }
    }
}

TEST(Mover, AOneWayPlatformThatMovesLetsItPassFromBelow) {
    for (const float speed : {-1.0f, 0.5f, 1.5f}) {
        for (int k = 0; k < 10; ++k) {
            SCOPED_TRACE(testing::Message() << speed << " m/s, start " << k);
            TestWorld w(test::roomy, {.gravity = {0, -10}});
            const BodyId ground = w.add_ground(0);
            const BodyId lift = w.add_box({0, 2 + 0.03f * static_cast<float>(k) - speed * 0.5f}, 5, 0.1f, {.one_way = {0, 1}}, BodyType::kinematic);
            w->set_linear_velocity(lift, {0, speed});
            // A small jump ends on the ground again, also if the head was in the platform.
            MoverState state{.position = {0, gap}};
            for (int i = 0; i < 60; ++i) {
                w->step(dt);
                ASSERT_TRUE(step_mover(*w, {}, state, {.jump = i == 10 ? 4.0f : 0}, dt));
                ASSERT_EQ(state.squeezed, 0u);
            }
            EXPECT_EQ(state.ground, ground);
            // A high one ends on the platform.
            for (int i = 0; i < 120; ++i) {
                if (w->position(lift).y < 1) w->set_linear_velocity(lift, {0, 0});
                w->step(dt);
                ASSERT_TRUE(step_mover(*w, {}, state, {.jump = i == 10 ? 13.0f : 0}, dt));
            }
            for (int i = 0; i < 120; ++i) {
                w->step(dt);
                ASSERT_TRUE(step_mover(*w, {}, state, {}, dt));
            }
            EXPECT_EQ(state.ground, lift);
        }
    }
}

// -- what comes down on it -------------------------------------------------------------------------------------------------------------

TEST(Mover, ACrateThatFallsOnItsHeadMovesItNoFasterThanItLeavesAnOverlap) {
    for (const float size : {0.25f, 0.4f, 0.6f}) {
        for (const float height : {0.5f, 2.0f, 6.0f}) {
            for (int k = 0; k < 15; ++k) {
                SCOPED_TRACE(testing::Message() << size << " m, from " << height << " m, start " << k);
                TestWorld w(test::roomy, {.gravity = {0, -10}});
                w.add_ground(0);
                w.add_box({-0.21f + 0.03f * static_cast<float>(k), 1.8f + size + height}, size, size, {.density = 30});
                MoverState state{.position = {0, gap}};
                for (int i = 0; i < 200; ++i) {
                    const Vec2 from = state.position;
                    w->step(dt);
                    ASSERT_TRUE(step_mover(*w, {}, state, {}, dt));
                    ASSERT_LE(distance(state.position, from), 0.1f) << "step " << i;
                }
                EXPECT_EQ(state.squeezed, 0u) << "it has left the crate";
            }
        }
    }
}

TEST(Mover, APlatformThatComesDownOnItMovesItNoFasterThanItself) {
    for (const float half_width : {0.3f, 1.0f, 5.0f}) {
        for (const float speed : {0.5f, 2.0f, 8.0f}) {
            for (int k = 0; k < 10; ++k) {
                SCOPED_TRACE(testing::Message() << half_width << " m, " << speed << " m/s, start " << k);
                TestWorld w;
                w.add_ground(0);
                const BodyId platform = w.add_box({0.1f * half_width * static_cast<float>(k - 5), 2.5f}, half_width, 0.3f, {}, BodyType::kinematic);
                w->set_linear_velocity(platform, {0, -speed});
                MoverState state{.position = {0, gap}};
                bool squeezed = false;
                for (int i = 0; i < 240; ++i) {
                    const Vec2 from = state.position;
                    w->step(dt);
                    ASSERT_TRUE(step_mover(*w, {}, state, {}, dt));
                    ASSERT_LE(distance(state.position, from), speed * dt + 0.12f) << "step " << i;
                    squeezed = squeezed || state.squeezed != 0;
                }
                EXPECT_TRUE(squeezed);
            }
        }
    }
}

}  // namespace
