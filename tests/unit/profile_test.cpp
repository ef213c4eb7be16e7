// What a world tells of its own work: the times of a step's stages, and the counters.
#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "support/busy_world.hpp"
#include "support/test_world.hpp"

namespace {

using namespace islet;
using namespace islet::test;

/// A clock that shows what it is told to, and looks at the world each time it is asked.
struct Watch {
    std::vector<std::uint64_t> times;
    std::size_t calls = 0;
    const World* world = nullptr;
    struct Sight {
        std::uint32_t contacts;
        std::size_t touches;
        float height;
    };
    std::vector<Sight> sights;

    static std::uint64_t read(void* context) {
        Watch& w = *static_cast<Watch*>(context);
        if (w.world != nullptr) {
            const BodyId crate = w.world->body_at(1);
            w.sights.push_back({w.world->contact_count(), w.world->begin_touch_events().size(), w.world->position(crate).y});
        }
        return w.times[w.calls++ % w.times.size()];
    }
};

TEST(Profile, EachStageGetsTheTicksBetweenItsEnds) {
    Watch watch;
    watch.times = {1000, 1001, 1011, 1111, 2111, 12111};
    TestWorld w(roomy, {.clock = Watch::read, .clock_context = &watch});
    w.add_ground();
    w.add_box({0, 0.5f});
    for (int i = 0; i < 2; ++i) {
        w.step();
        const StepProfile& p = w->profile();
        EXPECT_EQ(p.pairs, 1u);
        EXPECT_EQ(p.collide, 10u);
        EXPECT_EQ(p.islands, 100u);
        EXPECT_EQ(p.solve, 1000u);
        EXPECT_EQ(p.finish, 10000u);
        EXPECT_EQ(p.total, 11111u);
    }
    EXPECT_EQ(watch.calls, 12u);
}

// A tick counter of 32 bits that runs over in the middle of a step is no more than arithmetic modulo 2^64 if its reader widens it; one of 64 bits is
// right by itself.
TEST(Profile, AClockMayRunOver) {
    Watch watch;
    watch.times = {~std::uint64_t{0} - 2, 5, 6, 7, 8, 9};
    TestWorld w(roomy, {.clock = Watch::read, .clock_context = &watch});
    w.step();
    EXPECT_EQ(w->profile().pairs, 8u);
    EXPECT_EQ(w->profile().total, 12u);
}

TEST(Profile, TheStagesAreWhatTheyAreCalled) {
    Watch watch;
    watch.times = {0};
    TestWorld w;
    w.add_ground();
    w.add_box({0, 0.5f});
    w->set_linear_velocity(w.bodies()[1], {0, 1});
    watch.world = w.get();
    w->set_clock(Watch::read, &watch);
    w.step();
    ASSERT_EQ(watch.sights.size(), 6u);
    EXPECT_EQ(watch.sights[0].contacts, 0u);
    EXPECT_EQ(watch.sights[1].contacts, 1u) << "pairs are found before the second look at the clock";
    EXPECT_EQ(watch.sights[1].touches, 0u);
    EXPECT_EQ(watch.sights[3].touches, 0u);
    EXPECT_EQ(watch.sights[4].touches, 1u) << "what touches is told after the solve";
    EXPECT_EQ(watch.sights[4].height, 0.5f);
    EXPECT_GT(watch.sights[5].height, 0.5f) << "bodies are in their new places before the last";
}

TEST(Profile, WithoutAClockThereAreNoTimes) {
    TestWorld w;
    w.add_box({0, 0.5f});
    w.step();
    EXPECT_EQ(w->profile().total, 0u);
    Watch watch;
    watch.times = {0, 1, 2, 3, 4, 5};
    w->set_clock(Watch::read, &watch);
    w.step();
    EXPECT_EQ(w->profile().total, 5u);
    w->set_clock(nullptr);
    EXPECT_EQ(w->profile().total, 0u);
    w.step();
    EXPECT_EQ(w->profile().total, 0u);
    EXPECT_EQ(watch.calls, 6u);
}

TEST(Profile, TheClockIsNotPartOfTheWorld) {
    Watch watch;
    watch.times = {3, 1, 4, 1, 5, 9, 2, 6};
    TestWorld timed(busy_capacity, {.clock = Watch::read, .clock_context = &watch}), plain{busy_capacity};
    fill_busy(*timed);
    fill_busy(*plain);
    std::vector<std::byte> image(plain->snapshot_bytes());
    ASSERT_EQ(plain->save(image), image.size());
    for (int i = 0; i < 30; ++i) {
        timed.step();
        plain.step();
        ASSERT_EQ(timed->hash(), plain->hash());
    }
    const std::size_t calls = watch.calls;
    ASSERT_TRUE(timed->restore(image));
    timed.step();
    EXPECT_EQ(watch.calls, calls + 6) << "a world that went back still has its clock";
}

TEST(Counters, AreThoseOfTheWorld) {
    TestWorld w{busy_capacity};
    fill_busy(*w);
    const WorldCounters counters = w->counters();
    EXPECT_EQ(counters.bytes, world_bytes(busy_capacity));
    EXPECT_EQ(counters.snapshot_bytes, w->snapshot_bytes());
    std::uint32_t constraints = counters.uncolored, resting = 0;
    for (const std::uint32_t n : counters.colors) constraints += n;
    EXPECT_EQ(constraints, w.contacts().size() + w->joint_count());
    EXPECT_EQ(counters.uncolored, 1u);  // the gear
    ShapeId shapes[16];
    for (const BodyId body : w.bodies())
        if (!w->is_awake(body)) resting += w->shapes(body, shapes);
    EXPECT_EQ(counters.tree_shapes, resting);
    // An AVL tree of n leaves has at least log2 n and at most 1.44 log2 n levels of branches.
    ASSERT_GE(resting, 8u);
    EXPECT_GE(counters.tree_height, 4u);
    EXPECT_LE(counters.tree_height, 8u);
}

TEST(Counters, GeometriesAreCountedOnce) {
    TestWorld w;
    EXPECT_EQ(w->counters().geometries, 0u);
    EXPECT_EQ(w->counters().tree_height, 0u);
    for (int i = 0; i < 5; ++i) w.add_box({2 * static_cast<float>(i), 0});
    w.add_circle({0, 5});
    EXPECT_EQ(w->counters().geometries, 2u);
    w.add_ground();
    EXPECT_EQ(w->counters().tree_height, 1u);
}

TEST(Counters, EachColourIsCounted) {
    TestWorld w;
    w.add_ground();
    for (int i = 0; i < 5; ++i) w.add_box({0, 0.5f + static_cast<float>(i)});
    w.step(10);
    // Boxes in a column take two colours in turns, from one end, and the ground's contact one from the other end.
    const WorldCounters counters = w->counters();
    std::vector<std::uint32_t> used;
    for (const std::uint32_t n : counters.colors)
        if (n != 0) used.push_back(n);
    EXPECT_EQ(used, (std::vector<std::uint32_t>{2, 2, 1}));
    EXPECT_EQ(counters.colors[constraint_color_count - 1], 1u);
}

}  // namespace
