// The character mover on courses whose geometry says where it must be.
#include <gtest/gtest.h>

#include <cmath>

#include "hero.hpp"

namespace {

using namespace hero;

// -- slopes --------------------------------------------------------------------------------------------------------------------------

TEST(Mover, WalksAlongSlopesUpTo50DegreesAtItsSpeed) {
    for (int degrees = -50; degrees <= 50; degrees += 5) {
        SCOPED_TRACE(degrees);
        TestWorld w;
        add_slope(w, static_cast<float>(degrees));
        const Rot q = make_rot(static_cast<float>(degrees) * pi / 180);
        // The middle of the lower end hovers at the radius and the gap above the face.
        Hero hero(w, rotate(q, {0, radius + gap}) - Vec2{0, radius});
        hero.step({}, 5);
        ASSERT_TRUE(hero.state.ground) << "it stands";
        const Vec2 start = hero.state.position;
        hero.step({}, 600);
        EXPECT_LT(distance(hero.state.position, start), 2e-5f) << "and does not creep";
        hero.step({.walk = 5}, 60);
        const Vec2 want = start + rotate(q, {5, 0});  // 5 m/s for one second
        EXPECT_LT(distance(hero.state.position, want), 1e-3f) << hero.state.position.x << ' ' << hero.state.position.y;
        EXPECT_NEAR(dot(hero.middle(), rotate(q, {0, 1})), radius + gap, 1e-4f);
        EXPECT_NEAR(length(hero.state.velocity), 5, 1e-3f);
        EXPECT_EQ(hero.steps_in_air, 0) << "it kept to the ground";
        EXPECT_LE(hero.worst_overlap, 0);
    }
}

TEST(Mover, DoesNotClimbSlopesThatAreTooSteepAndSlidesDownThem) {
    for (const float degrees : {55.0f, 65.0f, 75.0f, 85.0f}) {
        SCOPED_TRACE(degrees);
        TestWorld w;
        w.add_ground(0);
        add_slope(w, degrees);
        Hero hero(w, {-3, gap});
        hero.def.air_acceleration = 20;
        hero.step({.walk = 5}, 120);
        // Where the capsule touches both the floor and the slope: the angle's bisector.
        const float x = -(radius + gap) * std::tan(degrees * pi / 360);
        EXPECT_NEAR(hero.state.position.x, x, 2e-3f);
        EXPECT_NEAR(hero.state.position.y, gap, 1e-3f);
        EXPECT_LE(hero.worst_overlap, 0);
        // Dropped onto the slope it comes down to the same place, walking into it or not.
        for (const float walk : {0.0f, 5.0f}) {
            const Rot q = make_rot(degrees * pi / 180);
            hero.state = {};
            hero.state.position = rotate(q, {2, radius + gap + 0.1f}) - Vec2{0, radius};
            hero.step({.walk = walk}, 240);
            EXPECT_NEAR(hero.state.position.y, gap, 1e-3f) << walk;
            EXPECT_LE(hero.state.position.x, x + 2e-3f) << walk;
        }
        EXPECT_LE(hero.worst_overlap, 0);
    }
}

TEST(Mover, KeepsToTheGroundOverACrest) {
    // Up 40 degrees, level, down 40 degrees.
    TestWorld w;
    const float t = std::tan(40 * pi / 180);
    const Vec2 hill[] = {{-20, 0}, {-5, 0}, {0, 5 * t}, {4, 5 * t}, {9, 0}, {20, 0}};
    std::vector<Vec2> floor(std::rbegin(hill), std::rend(hill));  // solid below: from right to left
    const BodyId body = w->create_body({});
    ASSERT_EQ(w->create_chain(body, floor, false), 5u);
    Hero hero(w, {-8, gap});
    hero.step({}, 2);
    hero.steps_in_air = 0;
    hero.step({.walk = 6}, 300);
    EXPECT_EQ(hero.steps_in_air, 0);
    EXPECT_NEAR(hero.state.position.y, gap, 1e-3f);
    // Its feet went along 3 m, 5 / cos 40 up, 4 m, 5 / cos 40 down and the rest: only the corners are rounded, by less than the radius each.
    const float along = 6 * 5 - 3 - 2 * 5 / std::cos(40 * pi / 180) - 4;
    EXPECT_NEAR(hero.state.position.x, 9 + along, 4 * radius);
    EXPECT_LE(hero.worst_overlap, 0);
}

// -- floors of pieces, steps, gaps -----------------------------------------------------------------------------------------------------

TEST(Mover, FeelsNoSeams) {
    for (const bool chain : {false, true}) {
        SCOPED_TRACE(chain);
        TestWorld w;
        if (chain) {
            std::vector<Vec2> points;
            for (int i = 60; i >= -60; --i) points.push_back({0.37f * static_cast<float>(i), 0});
            w->create_chain(w->create_body({}), points, false);
        } else {
            for (int i = -40; i <= 40; ++i) w.add_box({0.5f * static_cast<float>(i), -0.25f}, 0.25f, 0.25f, {}, BodyType::static_body);
        }
        Hero hero(w, {-15, gap});
        hero.step({}, 2);
        const float start = hero.state.position.x;
        for (int i = 1; i <= 240; ++i) {
            hero.step({.walk = 7});
            ASSERT_NEAR(hero.state.position.y, gap, 1e-4f) << "at x = " << hero.state.position.x;
            ASSERT_NEAR(hero.state.position.x, start + 7 * dt * static_cast<float>(i), 1e-3f);
        }
        EXPECT_LE(hero.worst_overlap, 0);
    }
}

TEST(Mover, ClimbsStairsAndComesDownThem) {
    for (const float rise : {0.1f, 0.2f, 0.3f, 0.34f}) {
        SCOPED_TRACE(rise);
        TestWorld w;
        add_stairs(w, 8, rise, 0.5f);
        Hero hero(w, {0, gap});
        hero.step({}, 2);
        hero.steps_in_air = 0;
        hero.step({.walk = 3}, 240);
        EXPECT_GT(hero.state.position.x, 6.5f);
        EXPECT_NEAR(hero.state.position.y, 8 * rise + gap, 1e-3f) << "on top of the eighth step";
        hero.step({.walk = -3}, 300);
        EXPECT_EQ(hero.steps_in_air, 0) << "neither up nor down";
        EXPECT_LT(hero.state.position.x, 1.5f);
        EXPECT_NEAR(hero.state.position.y, gap, 1e-3f) << "down again";
        EXPECT_LE(hero.worst_overlap, 0);
    }
}

TEST(Mover, ClimbsEveryLowStepAtEveryWalkingSpeed) {
    for (int centimetres = 3; centimetres < 35; centimetres += 2) {
        for (const float speed : {0.1f, 0.2f, 0.3f, 0.5f, 0.8f, 1.0f, 2.0f, 5.0f}) {
            for (const float side : {-1.0f, 1.0f}) {
                for (int k = 0; k < 3; ++k) {
                    SCOPED_TRACE(testing::Message() << centimetres << " cm at " << side * speed << " m/s, start " << k);
                    const float top = 0.01f * static_cast<float>(centimetres);
                    TestWorld w;
                    w.add_ground(0);
                    w.add_box({side * 25, 0.5f * top}, 25, 0.5f * top, {}, BodyType::static_body);
                    MoverState state{.position = {side * (-0.35f - 0.007f * static_cast<float>(k)), gap}};
                    // It climbs round the edge with the round end, about half a metre.
                    const int steps = static_cast<int>(1.2f / (speed * dt)) + 10;
                    for (int i = 0; i < steps; ++i) {
                        const Vec2 from = state.position;
                        w->step(dt);
                        ASSERT_TRUE(step_mover(*w, {}, state, {.walk = side * speed}, dt));
                        ASSERT_TRUE(state.ground);
                        ASSERT_LE(std::abs(state.position.x - from.x), speed * dt + 2.1f * gap) << "step " << i;
                    }
                    ASSERT_NEAR(state.position.y, top + gap, 1e-3f) << state.position.x;
                }
            }
        }
    }
}

TEST(Mover, StandsStillHalfwayUpAnEdge) {
    for (const float side : {-1.0f, 1.0f}) {
        TestWorld w;
        w.add_ground(0);
        w.add_box({side * 25, 0.15f}, 25, 0.15f, {}, BodyType::static_body);
        Hero hero(w, {side * -0.32f, gap});
        for (int i = 0; i < 600 && hero.state.position.y < 0.1f; ++i) hero.step({.walk = side * 0.3f});
        hero.step({}, 2);
        const Vec2 there = hero.state.position;
        ASSERT_GT(there.y, 0.09f);
        hero.step({}, 120);
        EXPECT_LT(distance(hero.state.position, there), 1e-4f);
        EXPECT_LE(hero.worst_overlap, 0);
    }
}

TEST(Mover, DoesNotClimbStepsThatAreTooHigh) {
    TestWorld w;
    add_stairs(w, 1, 0.37f, 1);
    Hero hero(w, {0, gap});
    hero.step({.walk = 3}, 240);
    EXPECT_NEAR(hero.state.position.y, gap, 1e-3f);
    // Stopped by the step's edge, 0.37 m high and above the middle of the round end: by the wall below it.
    EXPECT_NEAR(hero.state.position.x, 2 - radius - gap, 2e-3f);
    EXPECT_LE(hero.worst_overlap, 0);
}

TEST(Mover, DoesNotClimbAStepUnderALowCeiling) {
    TestWorld w;
    add_stairs(w, 1, 0.3f, 1);
    // The capsule is 1.8 m tall; there are 2 m above the floor, 1.7 m above the step.
    w.add_box({0, 2.5f}, 50, 0.5f, {}, BodyType::static_body);
    Hero hero(w, {0, gap});
    hero.step({.walk = 3}, 240);
    EXPECT_LT(hero.state.position.x, 2);
    EXPECT_LE(hero.worst_overlap, 0);
}

TEST(Mover, WalksOverANarrowGapAndFallsIntoAWideOne) {
    TestWorld w;
    w.add_box({-10, -1}, 10, 1, {}, BodyType::static_body);
    w.add_box({10.2f, -1}, 10, 1, {}, BodyType::static_body);  // 0.2 m
    w.add_box({32.2f, -1}, 10, 1, {}, BodyType::static_body);  // 2 m
    Hero hero(w, {-2, gap});
    hero.step({}, 2);
    // Over the narrow gap the round end sinks in between the edges, by r - sqrt(r^2 - 0.1^2), with the gap as part of r.
    const float r = radius + gap;
    const float sinks = r - std::sqrt(r * r - 0.01f);
    float lowest = 1;
    for (int i = 0; i < 240; ++i) {
        hero.step({.walk = 1});
        lowest = std::min(lowest, hero.state.position.y);
    }
    EXPECT_NEAR(lowest, gap - sinks, 4e-3f);
    EXPECT_NEAR(hero.state.position.y, gap, 1e-3f);
    EXPECT_EQ(hero.steps_in_air, 0);
    hero.step({.walk = 4}, 320);
    EXPECT_LT(hero.state.position.y, -1.5f) << "the wide one it falls into";
    EXPECT_LE(hero.worst_overlap, 0);
}

TEST(Mover, LeavesALedgeLevelAndFallsAsBodiesDo) {
    TestWorld w;
    w.add_box({-10, 5}, 10, 1, {}, BodyType::static_body);  // its top at 6, its edge at 0
    w.add_ground(0);
    Hero hero(w, {-2, 6 + gap});
    hero.step({}, 2);
    while (hero.state.ground && hero.state.position.x < 3) hero.step({.walk = 5});
    ASSERT_FALSE(hero.state.ground);
    EXPECT_NEAR(hero.state.velocity.x, 5, 1e-3f);
    EXPECT_NEAR(hero.state.velocity.y, 0, 1e-3f) << "no jump and no dive";
    const Vec2 start = hero.state.position;
    int n = 0;
    for (; !hero.state.ground && n < 200; ++n) {
        hero.step({.walk = 5});
        if (hero.state.ground) break;
        const float k = static_cast<float>(n + 1);
        ASSERT_NEAR(hero.state.position.x, start.x + 5 * dt * k, 1e-3f);
        ASSERT_NEAR(hero.state.position.y, start.y - 5 * dt * dt * k * (k + 1), 2e-3f);  // g / 2 dt^2 n (n + 1)
    }
    EXPECT_NEAR(hero.state.position.y, gap, 1e-3f);
    EXPECT_LE(hero.worst_overlap, 0);
}

// -- jumps -----------------------------------------------------------------------------------------------------------------------------

TEST(Mover, JumpsAsHighAsItsSpeedSays) {
    TestWorld w;
    w.add_ground(0);
    Hero hero(w, {0, gap});
    hero.step({}, 2);
    ASSERT_TRUE(hero.state.ground);
    float highest = 0;
    hero.step({.jump = 6});
    for (int n = 1; n < 60; ++n) {
        const float k = static_cast<float>(n);
        const float want = gap + 6 * dt * k - 5 * dt * dt * k * (k + 1);
        if (want > gap) { ASSERT_NEAR(hero.state.position.y, want, 1e-4f) << n; }
        highest = std::max(highest, hero.state.position.y);
        hero.step({});
    }
    EXPECT_NEAR(highest, 36.0f / 20, 0.06f);  // v^2 / 2 g, less v dt / 2
    hero.step({}, 60);
    EXPECT_NEAR(hero.state.position.y, gap, 1e-4f);
    EXPECT_TRUE(hero.state.ground);
    EXPECT_EQ(hero.state.velocity, Vec2{});
}

TEST(Mover, ACeilingEndsAJump) {
    TestWorld w;
    w.add_ground(0);
    w.add_box({0, 3}, 5, 0.5f, {}, BodyType::static_body);  // its underside at 2.5
    Hero hero(w, {0, gap});
    hero.step({}, 2);
    hero.step({.jump = 9});
    float highest = 0;
    for (int i = 0; i < 60; ++i) {
        hero.step({});
        highest = std::max(highest, hero.state.position.y);
    }
    EXPECT_NEAR(highest, 2.5f - 1.8f - gap, 1e-3f);
    EXPECT_TRUE(hero.state.ground);
    EXPECT_LE(hero.worst_overlap, 0);
}

TEST(Mover, PassesOneWayPlatformsFromBelowAndStandsOnThem) {
    TestWorld w;
    w.add_ground(0);
    const BodyId platform = w.add_box({0, 1.5f}, 2, 0.1f, {}, BodyType::static_body);
    Hero hero(w, {0, gap});
    hero.def.collides = [](const Surface& s, void*) { return s.normal.y > 0.7f && s.separation > -0.05f; };
    hero.step({}, 2);
    hero.step({.jump = 7});
    hero.step({}, 120);
    EXPECT_EQ(hero.state.ground, platform);
    EXPECT_NEAR(hero.state.position.y, 1.6f + gap, 1e-3f);
}

TEST(Mover, FallsThroughAOneWayPlatformWhenToldTo) {
    TestWorld w;
    w.add_ground(0);
    const BodyId platform = w.add_box({0, 1.5f}, 2, 0.1f, {}, BodyType::static_body);
    Hero hero(w, {0, 1.6f + gap});
    struct Rule {
        const World& world;
        BodyId platform;
        bool drop = false;
    } rule{*w, platform};
    hero.def.collides = [](const Surface& s, void* context) {
        const Rule& it = *static_cast<Rule*>(context);
        return it.world.body(s.shape) != it.platform || (!it.drop && s.normal.y > 0.7f && s.separation > -0.05f);
    };
    hero.def.context = &rule;
    hero.step({}, 30);
    EXPECT_EQ(hero.state.ground, platform);
    rule.drop = true;
    hero.step({}, 20);
    rule.drop = false;
    hero.step({}, 60);
    EXPECT_NEAR(hero.state.position.y, gap, 1e-3f);
}

// -- walls and corners -------------------------------------------------------------------------------------------------------------------

TEST(Mover, StandsStillInCorners) {
    struct Corner {
        const char* what;
        float wall;     // degrees from the floor; above 90 it leans over
        float ceiling;  // degrees, 0: none
    };
    for (const Corner& corner : {Corner{"wall", 90, 0}, Corner{"overhang", 120, 0}, Corner{"steep slope", 70, 0}, Corner{"under a slope", 90, 20}}) {
        SCOPED_TRACE(corner.what);
        TestWorld w;
        w.add_ground(0);
        const Rot q = make_rot(corner.wall * pi / 180);
        w.add(make_offset_box(20, 1, {Vec2{3, 0} + rotate(q, {10, -1}), q}), Vec2{0, 0}, {}, BodyType::static_body);
        if (corner.ceiling > 0) {
            const Rot c = make_rot(-corner.ceiling * pi / 180);
            w.add(make_offset_box(20, 1, {Vec2{2.2f, 1.9f} + rotate(c, {0, 1}), c}), Vec2{0, 0}, {}, BodyType::static_body);
        }
        Hero hero(w, {0, gap});
        hero.step({.walk = 6}, 60);
        const Vec2 there = hero.state.position;
        EXPECT_GT(there.x, 1);
        for (int i = 0; i < 120; ++i) {
            hero.step({.walk = 6});
            ASSERT_LT(distance(hero.state.position, there), 1e-5f) << "it trembles, step " << i;
        }
        EXPECT_TRUE(hero.state.ground);
        EXPECT_LE(hero.worst_overlap, 0);
    }
}

TEST(Mover, HoldsInAWedgeOfTwoSteepSlopesAndCanJumpOut) {
    TestWorld w;
    add_slope(w, 65);
    add_slope(w, -65);
    Hero hero(w, {0, 3});
    hero.step({}, 180);
    // Both faces are touched: the middle is (r + gap) / cos 65 above the edge where they meet.
    EXPECT_NEAR(hero.middle().y, (radius + gap) / std::cos(65 * pi / 180), 3e-3f);
    EXPECT_NEAR(hero.middle().x, 0, 3e-3f);
    EXPECT_TRUE(hero.state.ground);
    const Vec2 there = hero.state.position;
    hero.step({}, 60);
    EXPECT_LT(distance(hero.state.position, there), 1e-4f);
    hero.step({.jump = 5}, 1);
    hero.step({}, 10);
    EXPECT_GT(hero.state.position.y, there.y + 0.4f);
    EXPECT_LE(hero.worst_overlap, 0);
}

TEST(Mover, NoSpeedTakesItThroughAThinWall) {
    TestWorld w;
    w.add_ground(0);
    w.add(Segment{{3, 0}, {3, 9}}, Vec2{0, 0}, {}, BodyType::static_body);
    for (const float speed : {50.0f, 400.0f, 20000.0f}) {
        Hero hero(w, {0, gap});
        hero.step({.walk = speed}, 5);
        EXPECT_NEAR(hero.state.position.x, 3 - radius - gap, 1e-3f) << speed;
        EXPECT_LE(hero.worst_overlap, 0);
    }
}

}  // namespace
