// One-way platforms that move, that bear heavy loads, and that meet other one-way shapes.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "support/random.hpp"
#include "support/test_world.hpp"

namespace islet::test {
namespace {

WorldDef sleepless() {
    WorldDef def;
    def.enable_sleep = false;
    return def;
}

ShapeDef holds_towards(Vec2 direction) {
    ShapeDef def;
    def.one_way = direction;
    return def;
}

// -- a platform that moves ---------------------------------------------------------------------------------------------------------------

// Seen from a platform that keeps its velocity, everything is as on one that stands still: whatever it lets pass and holds, and where on it that comes to rest.
TEST(OneWayPlatform, AtAnySteadyVelocityItHoldsAndLetsPassAsOneThatStandsStill) {
    int held = 0, fallen = 0;
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
        Random random(seed);
        const Vec2 drift = {random.between(-8, 8), random.between(-8, 8)};
        const float below = random.between(1, 3);
        const Vec2 throw_velocity = {random.between(-2, 2), random.one_in(2) ? random.between(9, 14) : random.between(2, 7)};
        const bool from_above = random.one_in(4);
        const float angle = random.between(-pi, pi);
        const int shape = static_cast<int>(random.below(3));
        bool stands[2];
        Vec2 place[2];
        float height = 0;
        for (const bool moves : {false, true}) {
            TestWorld w({.bodies = 4, .shapes = 4, .contacts = 8}, sleepless());
            const Vec2 with = moves ? drift : Vec2{};
            const BodyId platform = w.add(make_box(60, 0.1f), BodyDef{.type = BodyType::kinematic, .linear_velocity = with}, holds_towards({0, 1}));
            BodyDef def{.type = BodyType::dynamic, .position = {0, from_above ? below : -below}, .angle = angle};
            def.linear_velocity = with + (from_above ? Vec2{throw_velocity.x, -throw_velocity.y} : throw_velocity);
            const BodyId body = shape == 0   ? w.add(make_box(0.5f, 0.3f), def)
                                : shape == 1 ? w.add(Circle{{}, 0.3f}, def)
                                             : w.add(Capsule{{-0.3f, 0}, {0.3f, 0}, 0.2f}, def);
            float highest = -100;
            for (int i = 0; i < 240; ++i) {
                w.step();
                highest = std::max(highest, w->aabb(w.shape_of(body)).lower.y - w->position(platform).y - 0.1f);
            }
            place[moves] = w->position(body) - w->position(platform);
            stands[moves] = place[moves].y > 0;
            if (!moves) height = highest;
            EXPECT_EQ(w->validate(), nullptr);
        }
        if (height < 0.001f && height > -0.006f) continue;  // cleared by less than the slop: rounding decides
        EXPECT_EQ(stands[0], stands[1]) << "seed " << seed << ", height " << height;
        ++(stands[0] ? held : fallen);
        EXPECT_TRUE(stands[0] || !from_above) << "seed " << seed;
    }
    EXPECT_GT(held, 250);
    EXPECT_GT(fallen, 250);
}

// A lift: goes down below what lies on the floor, comes up and takes it along.
TEST(OneWayPlatform, ALiftComesFromAboveThroughWhatLiesOnTheFloorAndCarriesItUp) {
    for (const float speed : {0.3f, 1.0f, 4.0f}) {
        for (const float start : {0.0f, 0.004f, 0.011f, 0.37f}) {
            SCOPED_TRACE("speed " + std::to_string(speed) + ", start " + std::to_string(start));
            TestWorld w;
            // Two posts bear a plank of which the lift takes hold between them.
            w.add_box({-1, 0.5f}, 0.1f, 0.5f, {}, BodyType::static_body);
            w.add_box({1, 0.5f}, 0.1f, 0.5f, {}, BodyType::static_body);
            const BodyId plank = w.add_box({0, 1.05f}, 1.2f, 0.05f);
            const BodyId lift = w.add(make_box(0.6f, 0.05f), BodyDef{.type = BodyType::kinematic, .position = {0, 3 + start}}, holds_towards({0, 1}));
            w.step(90);
            w->set_linear_velocity(lift, {0, -speed});
            while (w->position(lift).y > 0.5f) {
                w.step();
                ASSERT_NEAR(w->position(plank).y, 1.05f, 0.01f) << "it passes, and pushes nothing";
            }
            w->set_linear_velocity(lift, {0, speed});
            while (w->position(lift).y < 4) w.step();
            w->set_linear_velocity(lift, {0, 0});
            w.step(240);
            EXPECT_NEAR(w->position(plank).y, w->position(lift).y + 0.1f, 0.01f);
            EXPECT_NEAR(w->position(plank).x, 0, 0.05f);
        }
    }
}

// What stands on it is carried as an ordinary platform carries it, through sudden turns and small hops.
TEST(OneWayPlatform, ItCarriesWhatStandsOnItAsAnOrdinaryPlatformDoes) {
    const Vec2 velocities[] = {{1, 0}, {-1, 0.5f}, {0, 2}, {0.5f, -2}, {3, 3}, {0, 8}};
    for (const Vec2 velocity : velocities) {
        for (int start = 0; start < 10; ++start) {
            SCOPED_TRACE(std::to_string(velocity.x) + " " + std::to_string(velocity.y) + ", start " + std::to_string(start));
            Vec2 place[2];
            for (const bool one_way : {false, true}) {
                TestWorld w;
                const BodyId platform = w.add(make_box(40, 0.1f), BodyDef{.type = BodyType::kinematic}, one_way ? holds_towards({0, 1}) : ShapeDef{});
                const BodyId rider = start % 2 == 0 ? w.add_box({0, 0.4f}, 0.3f, 0.3f) : w.add_circle({0, 0.4f}, 0.3f);
                w.step(30);
                for (int turn = 0; turn < 6; ++turn) {
                    w->set_linear_velocity(platform, turn % 2 == 0 ? velocity : -velocity);
                    w.step(40 + start);
                    // Where a body came from is judged by the velocities of the moment they meet (ShapeDef::one_way): no turn in the middle of a landing.
                    for (int i = 0; i < 60 && w.contacts().empty() && w->position(rider).y - w->position(platform).y < 1.4f; ++i) w.step();
                }
                w->set_linear_velocity(platform, {});
                w.step(60);
                place[one_way] = w->position(rider) - w->position(platform);
            }
            EXPECT_NEAR(place[1].x, place[0].x, 1e-3f);
            EXPECT_NEAR(place[1].y, place[0].y, 1e-3f);
        }
    }
}

// -- loads -------------------------------------------------------------------------------------------------------------------------------

TEST(OneWayPlatform, AThinOneHoldsAHeavyLoadOnALightBody) {
    for (const float thickness : {0.01f, 0.02f, 0.2f}) {
        for (const float ratio : {1.0f, 10.0f, 30.0f, 100.0f, 1000.0f}) {
            for (int kind = 0; kind < 8; ++kind) {
                const bool ball = kind % 2 != 0;
                const float drop = static_cast<float>(kind / 2);  // m
                SCOPED_TRACE("thickness " + std::to_string(thickness) + ", ratio " + std::to_string(ratio) + (ball ? ", ball" : ", box") + ", drop " + std::to_string(drop));
                TestWorld w(roomy, sleepless());
                w.add_ground(-10, 100);
                w.add(make_box(5, 0.5f * thickness), Vec2{0, -0.5f * thickness}, holds_towards({0, 1}), BodyType::static_body);
                const BodyId light[] = {ball ? w.add_circle({-1, 0.3f}, 0.3f) : w.add_box({-1, 0.3f}, 0.3f, 0.3f),
                                        ball ? w.add_circle({1, 0.3f}, 0.3f) : w.add_box({1, 0.3f}, 0.3f, 0.3f)};
                ShapeDef heavy;
                heavy.density = ratio;
                w.add_box({0, 1.1f + drop}, 2, 0.5f, heavy);
                w.step(600);
                for (const BodyId body : light) EXPECT_GT(w->position(body).y, 0);
            }
        }
    }
}

// -- two one-way shapes ------------------------------------------------------------------------------------------------------------------

// Each must hold the other: the platform above holds what comes from above; the falling body holds what comes to the side that its own direction points to.
TEST(OneWayPlatform, TwoOneWayShapesHoldEachOtherOnlyIfEachIsOnTheOthersSide) {
    const Vec2 directions[] = {{0, 1}, {0, -1}, {1, 0}, {0, 0}};
    for (const Vec2 platform : directions) {
        for (const Vec2 body : directions) {
            for (int start = 0; start < 10; ++start) {
                SCOPED_TRACE(std::to_string(platform.x) + " " + std::to_string(platform.y) + ", " + std::to_string(body.x) + " " + std::to_string(body.y) + ", " + std::to_string(start));
                TestWorld w;
                w.add_ground(-10, 100);
                w.add(make_box(5, 0.1f), Vec2{0, -0.1f}, holds_towards(platform), BodyType::static_body);
                const BodyId box = w.add(make_box(0.3f, 0.3f), Vec2{0, 1 + 0.37f * static_cast<float>(start)}, holds_towards(body));
                w.step(300);
                const bool stands = (platform.y > 0 || platform == Vec2{}) && (body.y < 0 || body == Vec2{});
                const bool on_floor = body.y < 0 || body == Vec2{};  // one that the floor is not above of falls through that too
                if (stands) EXPECT_NEAR(w->position(box).y, 0.3f, 0.01f);
                else if (on_floor) EXPECT_NEAR(w->position(box).y, -9.7f, 0.01f);
                else EXPECT_LT(w->position(box).y, -20);
                EXPECT_EQ(w->validate(), nullptr);
            }
        }
    }
}

// A one-way lid that falls, its open side up: it catches what falls onto it, and passes what it falls onto.
TEST(OneWayPlatform, ADynamicOneIsHeldByWhatItHoldsItselfAgainst) {
    TestWorld w;
    w.add_ground();
    const BodyId crate = w.add_box({0, 0.5f});
    const BodyId tray = w.add(make_box(3, 0.05f), Vec2{0, 3}, holds_towards({0, -1}));  // held from below: it lands on the crate
    w.step(240);
    EXPECT_NEAR(w->position(crate).y, 0.5f, 0.01f);
    EXPECT_NEAR(w->position(tray).y, 1.05f, 0.02f);
}

}  // namespace
}  // namespace islet::test
