// What a world tells after a step: touches that began and ended, who moved, who fell asleep, the report, the contacts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/test_world.hpp"

namespace {

using namespace islet;
using namespace islet::test;

bool is_pair(const TouchEvent& e, ShapeId a, ShapeId b) { return (e.shape_a == a && e.shape_b == b) || (e.shape_a == b && e.shape_b == a); }

// -- touching ----------------------------------------------------------------------------------------------------------------------------

TEST(Events, ATouchBeginsOnceAndEndsOnce) {
    TestWorld w;
    const ShapeId ground = w.shape_of(w.add_ground());
    const BodyId ball = w.add_circle({0, 2});
    int begun = 0, ended = 0, began_at = 0;
    for (int i = 1; i <= 120; ++i) {
        w.step();
        for (const TouchEvent& e : w->begin_touch_events()) {
            EXPECT_TRUE(is_pair(e, ground, w.shape_of(ball)));
            ++begun;
            began_at = i;
        }
        ended += static_cast<int>(w->end_touch_events().size());
        EXPECT_EQ(w.contacts().size(), static_cast<std::size_t>(begun - ended)) << "events and contacts agree";
    }
    EXPECT_EQ(begun, 1);
    EXPECT_EQ(ended, 0);
    EXPECT_NEAR(began_at, 33, 2) << "it falls 1.5 m in sqrt(0.3) s";
}

TEST(Events, AJumpEndsTheTouch) {
    TestWorld w;
    const ShapeId ground = w.shape_of(w.add_ground());
    const BodyId box = w.add_box({0, 0.5f});
    w.step(10);
    w->set_linear_velocity(box, {0, 3});
    std::size_t ended = 0;
    for (int i = 0; i < 10; ++i) {
        w.step();
        for (const TouchEvent& e : w->end_touch_events()) EXPECT_TRUE(is_pair(e, ground, w.shape_of(box)));
        ended += w->end_touch_events().size();
    }
    EXPECT_EQ(ended, 1u);
}

TEST(Events, DestroyingWhatTouchesEndsTheTouchAtOnceAndIsToldOnce) {
    TestWorld w;
    const ShapeId ground = w.shape_of(w.add_ground());
    const BodyId box = w.add_box({0, 0.5f});
    const ShapeId shape = w.shape_of(box);
    w.step(10);
    w->destroy_body(box);
    ASSERT_EQ(w->end_touch_events().size(), 1u);
    EXPECT_TRUE(is_pair(w->end_touch_events()[0], ground, shape));
    EXPECT_FALSE(w->is_valid(shape)) << "the id in the event is stale";
    w.step();
    ASSERT_EQ(w->end_touch_events().size(), 1u) << "it stays for who reads events only after steps";
    EXPECT_TRUE(is_pair(w->end_touch_events()[0], ground, shape));
    w.step();
    EXPECT_TRUE(w->end_touch_events().empty());
}

TEST(Events, EndsOfAStepAndOfCallsAfterItComeInTheirOrder) {
    TestWorld w;
    w.add_ground();
    std::vector<BodyId> boxes;
    for (int i = 0; i < 4; ++i) boxes.push_back(w.add_box({2.0f * static_cast<float>(i), 0.5f}));
    w.step(10);
    const std::vector<std::size_t> order = {2, 0, 3, 1};
    std::vector<ShapeId> expected;
    for (const std::size_t i : order) {
        expected.push_back(w.shape_of(boxes[i]));
        w->destroy_body(boxes[i]);
    }
    w.step();
    ASSERT_EQ(w->end_touch_events().size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
        const TouchEvent e = w->end_touch_events()[i];
        EXPECT_TRUE(e.shape_a == expected[i] || e.shape_b == expected[i]) << "event " << i;
    }
}

TEST(Events, ForbiddingAPairByItsFilterEndsTheTouch) {
    TestWorld w;
    w.add_ground();
    const BodyId box = w.add_box({0, 0.5f});
    w.step(10);
    w->set_filter(w.shape_of(box), {.mask = 0});
    EXPECT_EQ(w->end_touch_events().size(), 1u);
    EXPECT_EQ(w->contact_count(), 0u);
    w.step(30);
    EXPECT_LT(w->position(box).y, 0);
    w->set_filter(w.shape_of(box), {});
    w->set_transform(box, {0, 0.5f}, 0);
    w->set_linear_velocity(box, {});
    w.step();
    EXPECT_EQ(w.contacts().size(), 1u);
    EXPECT_EQ(w->validate(), nullptr);
}

TEST(Events, TouchesBeginInTheOrderOfTheirContacts) {
    const auto run = [](std::uint32_t lanes) {
        WorldDef def;
        def.lanes = lanes;
        TestWorld w(roomy, def);
        w.add_ground();
        for (int i = 0; i < 50; ++i) w.add_box({0.3f * static_cast<float>(i % 7), 1 + 1.1f * static_cast<float>(i)});
        std::vector<std::uint32_t> seen;
        for (int i = 0; i < 200; ++i) {
            w.step();
            for (const TouchEvent& e : w->begin_touch_events()) seen.insert(seen.end(), {1u, e.shape_a.index1, e.shape_b.index1});
            for (const TouchEvent& e : w->end_touch_events()) seen.insert(seen.end(), {2u, e.shape_a.index1, e.shape_b.index1});
        }
        return seen;
    };
    const auto first = run(0);
    EXPECT_GT(first.size(), 150u);
    EXPECT_EQ(first, run(1));
}

// -- moving and sleeping -----------------------------------------------------------------------------------------------------------------

TEST(Events, MovedBodiesAreTheAwakeOnesInTheOrderOfTheirSlots) {
    TestWorld w;
    w.add_ground();
    std::vector<BodyId> expected;
    for (int i = 0; i < 5; ++i) expected.push_back(w.add_circle({2.0f * static_cast<float>(i), 5}));
    expected.push_back(w.add_box({50, 5}, 1, 1, {}, BodyType::kinematic));
    w.step();
    EXPECT_TRUE(std::ranges::equal(w->moved_bodies(), expected));
    EXPECT_TRUE(w->slept_bodies().empty());
}

TEST(Sleep, AnIslandAtRestFallsAsleepAfterHalfASecondAndIsToldOnce) {
    TestWorld w;
    w.add_ground();
    const std::vector<BodyId> stack = {w.add_box({0, 0.5f}), w.add_box({0, 1.5f}), w.add_box({0, 2.5f})};
    int slept_at = 0;
    std::vector<BodyId> slept;
    for (int i = 1; i <= 120; ++i) {
        w.step();
        for (const BodyId id : w->slept_bodies()) {
            slept.push_back(id);
            slept_at = i;
            EXPECT_TRUE(std::ranges::count(w->moved_bodies(), id) == 1) << "the step moved it before it slept";
        }
    }
    EXPECT_EQ(slept, stack);
    EXPECT_GE(slept_at, 30);
    EXPECT_LE(slept_at, 60);
    for (const BodyId id : stack) {
        EXPECT_FALSE(w->is_awake(id));
        EXPECT_EQ(w->linear_velocity(id), Vec2{});
    }
    EXPECT_TRUE(w->moved_bodies().empty());
    EXPECT_EQ(w->report().awake_bodies, 0u);
    EXPECT_EQ(w.contacts().size(), 3u) << "sleeping contacts still touch";
    const std::uint64_t asleep = w->hash();
    w.step(10);
    EXPECT_EQ(w->hash(), asleep) << "nothing changes while all sleep";
}

TEST(Sleep, TheWholeIslandWakesTogether) {
    for (int way = 0; way < 10; ++way) {
        SCOPED_TRACE(way);
        TestWorld w;
        w.add_ground();
        const BodyId stack[] = {w.add_box({0, 0.5f}), w.add_box({0, 1.5f}), w.add_box({0, 2.5f})};
        const BodyId apart = w.add_box({20, 0.5f});
        w.step(120);
        ASSERT_EQ(w->report().awake_bodies, 0u);
        switch (way) {
        case 0: w->wake(stack[0]); break;
        case 1: w->set_linear_velocity(stack[1], {0.1f, 0}); break;
        case 2: w->apply_force_to_center(stack[2], {0, 1}); break;
        case 3: w->apply_angular_impulse(stack[0], 0.01f); break;
        case 4: w->set_transform(stack[2], {0, 2.5f}, 0); break;
        case 5: w->set_gravity_scale(stack[0], 0.5f); break;
        case 6: w->set_friction(w.shape_of(stack[0]), 0.1f); break;
        case 7: w->set_mass(stack[1], {3, {}, 1}); break;
        case 8: w->enable_sleep(stack[0], false); break;
        case 9: w->set_angular_velocity(stack[0], 0.1f); break;
        }
        for (const BodyId id : stack) EXPECT_TRUE(w->is_awake(id));
        EXPECT_FALSE(w->is_awake(apart)) << "another island";
        EXPECT_EQ(w->validate(), nullptr);
    }
}

TEST(Sleep, WhatLiesOnASurfaceWakesWhenTheSurfaceChanges) {
    for (int way = 0; way < 3; ++way) {
        SCOPED_TRACE(way);
        TestWorld w;
        // A slope that friction holds a box on, a floor, and a second shape of the same body that does not change.
        const BodyId ground = w->create_body({});
        const float angle = 0.3f;  // rad; friction holds up to atan 0.6 = 0.54
        const ShapeId floor = w->create_shape(ground, make_offset_box(5, 1, {{0, -1}, {}}));
        const ShapeId slope = w->create_shape(ground, make_offset_box(5, 1, {{20, 0}, make_rot(-angle)}));
        w->create_shape(ground, make_offset_box(5, 1, {{40, -1}, {}}));
        const BodyId on_floor = w.add_box({0, 0.5f}), apart = w.add_box({40, 0.5f});
        const Vec2 across = rotate(make_rot(-angle), {0, 1.5f});
        const BodyId on_slope = w.add(make_box(0.5f, 0.5f), BodyDef{.type = BodyType::dynamic, .position = Vec2{20, 0} + across, .angle = -angle});
        w.step(240);
        ASSERT_EQ(w->report().awake_bodies, 0u);
        const Vec2 before[] = {w->position(on_floor), w->position(on_slope)};
        switch (way) {
        case 0: w->set_tangent_speed(floor, 1); break;
        case 1: w->set_friction(slope, 0); break;
        case 2: w->set_material(slope, {.friction = 0}); break;
        }
        EXPECT_EQ(w->is_awake(on_floor), way == 0);
        EXPECT_EQ(w->is_awake(on_slope), way != 0);
        EXPECT_FALSE(w->is_awake(apart));
        w.step(60);
        if (way == 0) EXPECT_GT(std::fabs(w->position(on_floor).x - before[0].x), 0.5f);
        else EXPECT_LT(w->position(on_slope).y, before[1].y - 0.3f);
        EXPECT_STREQ(w->validate(), nullptr);
    }
}

TEST(Sleep, WhatTouchesADestroyedBodyWakes) {
    TestWorld w;
    w.add_ground();
    const BodyId lower = w.add_box({0, 0.5f});
    const BodyId upper = w.add_box({0, 1.5f});
    w.step(120);
    ASSERT_FALSE(w->is_awake(upper));
    w->destroy_body(lower);
    EXPECT_TRUE(w->is_awake(upper));
    w.step(60);
    EXPECT_NEAR(w->position(upper).y, 0.5f, 0.01f);
    w.step(120);
    ASSERT_FALSE(w->is_awake(upper));
    w->destroy_shape(w.shape_of(w->body_at(0)));  // the ground
    EXPECT_TRUE(w->is_awake(upper));
}

TEST(Sleep, ABodyThatFallsOnASleeperWakesIt) {
    TestWorld w;
    w.add_ground();
    const BodyId sleeper = w.add_box({0, 0.5f});
    w.step(120);
    ASSERT_FALSE(w->is_awake(sleeper));
    w.add_box({0, 4});
    bool woke = false;
    for (int i = 0; i < 60; ++i) {
        w.step();
        woke |= w->is_awake(sleeper);
        ASSERT_EQ(w->validate(), nullptr);
    }
    EXPECT_TRUE(woke);
}

TEST(Sleep, ABodyMayStartAsleepOrNeverSleep) {
    TestWorld w;
    w.add_ground();
    BodyDef def;
    def.type = BodyType::dynamic;
    def.position = {0, 5};
    def.awake = false;
    const BodyId floating = w.add(make_box(0.5f, 0.5f), def);
    def.position = {5, 0.5f};
    def.awake = true;
    def.enable_sleep = false;
    const BodyId restless = w.add(make_box(0.5f, 0.5f), def);
    const BodyId neighbor = w.add_box({5, 1.5f});
    w.step(200);
    EXPECT_EQ(w->position(floating), (Vec2{0, 5}));
    EXPECT_TRUE(w->is_awake(restless));
    EXPECT_TRUE(w->is_awake(neighbor)) << "it keeps its island awake";
    w->wake(floating);
    w.step(60);
    EXPECT_LT(w->position(floating).y, 1);
}

TEST(Sleep, TurnedOffForTheWorldItWakesEverything) {
    TestWorld w;
    w.add_ground();
    const BodyId box = w.add_box({0, 0.5f});
    w.step(120);
    ASSERT_FALSE(w->is_awake(box));
    w->enable_sleep(false);
    EXPECT_TRUE(w->is_awake(box));
    w.step(120);
    EXPECT_TRUE(w->is_awake(box));
    w->enable_sleep(true);
    w.step(120);
    EXPECT_FALSE(w->is_awake(box));
}

// -- the report and the contacts -----------------------------------------------------------------------------------------------------------

TEST(Report, CountsWhatTheStepFound) {
    TestWorld w;
    w.add_ground();
    for (int i = 0; i < 3; ++i) w.add_box({0, 0.5f + static_cast<float>(i)});  // one island, three contacts
    w.add_circle({10, 0.5f});                                                  // another
    w.add_circle({20, 5});                                                     // in the air
    w.step(2);
    const StepReport r = w->report();
    EXPECT_EQ(r.bodies, 6u);
    EXPECT_EQ(r.shapes, 6u);
    EXPECT_EQ(r.awake_bodies, 5u);
    EXPECT_EQ(r.contacts, 4u);
    EXPECT_EQ(r.contacts, w->contact_count());
    EXPECT_EQ(r.touching_contacts, 4u);
    EXPECT_EQ(r.islands, 3u);
    EXPECT_GE(r.colors, 3u) << "two between boxes, one for the ground";
    EXPECT_EQ(r.overflow_contacts, 0u);
    EXPECT_EQ(r.dropped_contacts, 0u);
    EXPECT_EQ(r.dropped_events, 0u);
    EXPECT_GE(r.batches, 1u);
    EXPECT_EQ(w->step_count(), 2u);
    w.step(5);
    EXPECT_EQ(w->report().recycled_contacts, 4u) << "nothing moves, so every manifold is kept";
}

TEST(Report, AContactSaysWhereAndHowHard) {
    TestWorld w;
    const ShapeId ground = w.shape_of(w.add_ground());
    const BodyId box = w.add_box({3, 0.5f}, 0.5f, 0.5f);
    w.step(60);
    const std::vector<ContactInfo> contacts = w.contacts();
    ASSERT_EQ(contacts.size(), 1u);
    const ContactInfo& c = contacts[0];
    EXPECT_TRUE(is_pair({c.shape_a, c.shape_b}, ground, w.shape_of(box)));
    const float up = c.shape_a == ground ? 1.0f : -1.0f;
    EXPECT_LT(distance(c.normal, {0, up}), 1e-4f) << "from a to b";
    ASSERT_EQ(c.point_count, 2u);
    float sum = 0;
    for (const ContactPoint& p : c.points) {
        EXPECT_NEAR(std::abs(p.point.x - 3), 0.5f, 0.01f);
        EXPECT_NEAR(p.point.y, 0, 0.01f);
        EXPECT_NEAR(p.separation, 0, 0.005f);
        sum += p.normal_impulse;
    }
    EXPECT_NE(c.points[0].feature, c.points[1].feature);
    // The weight over one substep: m g h.
    EXPECT_NEAR(sum, 1 * 10 / 240.0f, 1e-3f);
    EXPECT_FLOAT_EQ(c.friction, 0.6f);
}

TEST(Report, TheHashTellsWorldsApartAndEqualWorldsAreEqual) {
    const auto make = [](float x) {
        TestWorld w;
        w.add_ground();
        w.add_box({x, 3});
        w.step(30);
        return w->hash();
    };
    EXPECT_EQ(make(0), make(0));
    EXPECT_NE(make(0), make(1e-6f));
    TestWorld w;
    const std::uint64_t before = w->hash();
    w->set_gravity({0, -9.81f});
    EXPECT_NE(w->hash(), before);
    w->set_gravity({0, -10});
    EXPECT_EQ(w->hash(), before);
    SolverDef solver;
    solver.omega = 1.1f;
    w->set_solver(solver);
    EXPECT_NE(w->hash(), before);
}

}  // namespace
