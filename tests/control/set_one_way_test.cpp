// Turning a shape into a one-way platform, round, and back while something stands on it; and taking its hold away by a filter.
#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "support/test_world.hpp"

namespace islet::test {
namespace {

constexpr float deck_top = 5;  // m

enum class Rider { box, ball, capsule, stack };

/// Something that has come to rest on a deck 5 m above a floor.
struct Deck {
    TestWorld world;
    ShapeId deck;
    BodyId rider;    // the lowest body on the deck
    BodyId bystander;  // rests on the floor, apart

    Deck(Rider kind, Vec2 one_way, BodyType type = BodyType::static_body) {
        world.add_ground(0, 100);
        ShapeDef def;
        def.one_way = one_way;
        deck = world.shape_of(world.add(make_box(5, 0.1f), Vec2{0, deck_top - 0.1f}, def, type));
        switch (kind) {
        case Rider::box: rider = world.add_box({0, deck_top + 0.3f}, 0.5f, 0.3f); break;
        case Rider::ball: rider = world.add_circle({0, deck_top + 0.3f}, 0.3f); break;
        case Rider::capsule: rider = world.add_capsule({0, deck_top + 0.2f}, 0.3f, 0.2f); break;
        case Rider::stack:
            rider = world.add_box({0, deck_top + 0.5f});
            for (int i = 1; i < 10; ++i) world.add_box({0, deck_top + 0.5f + static_cast<float>(i)});
            break;
        }
        bystander = world.add_box({20, 0.5f});
        world.step(600);
    }
    float lowest() const { return world->aabb(world.shape_of(rider)).lower.y; }
};

constexpr Rider riders[] = {Rider::box, Rider::ball, Rider::capsule, Rider::stack};

struct TakeAway {
    const char* name;
    Vec2 before;  // the deck's one-way direction until then
    std::function<void(Deck&)> call;
};

const TakeAway ways_to_fall[] = {
    {"turned round", {0, 1}, [](Deck& d) { d.world->set_one_way(d.deck, {0, -1}); }},
    {"made one-way, downwards", {}, [](Deck& d) { d.world->set_one_way(d.deck, {0, -1}); }},
    {"filter of the deck", {0, 1}, [](Deck& d) { d.world->set_filter(d.deck, {.mask = 0}); }},
    {"filter of the rider", {0, 1}, [](Deck& d) { d.world->set_filter(d.world.shape_of(d.rider), {.group = -1}), d.world->set_filter(d.deck, {.group = -1}); }},
};

TEST(SetOneWay, WhatRestsOnTheShapeWakesAndFallsWhenItHoldsNoLonger) {
    for (const TakeAway& way : ways_to_fall) {
        for (const Rider kind : riders) {
            for (const BodyType type : {BodyType::static_body, BodyType::kinematic}) {
                SCOPED_TRACE(std::string(way.name) + ", rider " + std::to_string(int(kind)) + (type == BodyType::static_body ? "" : ", kinematic"));
                Deck d(kind, way.before, type);
                ASSERT_FALSE(d.world->is_awake(d.rider));
                ASSERT_FALSE(d.world->is_awake(d.bystander));
                ASSERT_NEAR(d.lowest(), deck_top, 0.02f);
                way.call(d);
                EXPECT_TRUE(d.world->is_awake(d.rider));
                EXPECT_FALSE(d.world->is_awake(d.bystander)) << "the floor has not changed";
                d.world.step(180);
                EXPECT_NEAR(d.lowest(), 0, 0.02f);
                EXPECT_EQ(d.world->validate(), nullptr);
            }
        }
    }
}

TEST(SetOneWay, WhatStandsOnTheShapeGoesOnStandingIfItIsAboveInTheNewDirection) {
    // Along a direction that is tilted, a corner of the deck is farther than what stands in its middle: nothing there is above.
    const Vec2 directions[] = {{0, 1}, {0, 3}, {0.6f, 0.8f}, {-0.6f, 0.8f}, {1, 0}};
    for (const Vec2 before : {Vec2{}, Vec2{0, 1}}) {
        for (const Vec2 after : directions) {
            for (const Rider kind : riders) {
                SCOPED_TRACE("rider " + std::to_string(int(kind)) + ", before " + std::to_string(before.y) + ", after " + std::to_string(after.x));
                Deck d(kind, before);
                const float stood = d.lowest();
                d.world->set_one_way(d.deck, after);
                EXPECT_TRUE(d.world->is_awake(d.rider)) << "what it stands on has changed";
                d.world.step(300);
                if (after.x == 0) EXPECT_NEAR(d.lowest(), stood, 1e-3f);
                else EXPECT_NEAR(d.lowest(), 0, 0.02f);
                EXPECT_EQ(d.world->validate(), nullptr);
            }
        }
    }
}

TEST(SetOneWay, TakenBackItHoldsFromAllSidesAgain) {
    Deck d(Rider::box, {0, 1});
    d.world->set_one_way(d.deck, {});
    d.world->set_transform(d.rider, {0, deck_top - 2}, 0);
    d.world->set_linear_velocity(d.rider, {0, 15});
    float highest = 0;
    for (int i = 0; i < 240; ++i) {
        d.world.step();
        highest = std::max(highest, d.world->position(d.rider).y);
    }
    EXPECT_LT(highest, deck_top - 0.2f - 0.25f);
}

}  // namespace
}  // namespace islet::test
