// The formula for scratch memory (scratch_bytes, islet/layout.hpp) against what the stages take: worlds full to the last slot, of many capacities. A stage
// that takes more than there is traps (memory/arena.hpp), and so ends the test.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "data/core.hpp"
#include "islet/island.hpp"
#include "support/joint_world.hpp"
#include "support/random.hpp"
#include "support/test_world.hpp"

namespace {

using namespace islet;
using islet::test::Random;
using islet::test::TestWorld;

constexpr float dt = 1.0f / 60;

void run_all(void*, std::uint32_t count, void (*task)(void*, std::uint32_t), void* data) {
    for (std::uint32_t i = 0; i < count; ++i) task(data, i);
}

/// Everything that takes scratch of its own is asked for: a residual, shock, hits, workers, trees of hinges.
WorldDef greedy(Random& random) {
    WorldDef def;
    def.gravity = {0, -1};
    constexpr std::uint32_t lanes[] = {0, 1, 4, 8, 16};
    def.lanes = lanes[random.below(5)];
    def.solver.substeps = 1;
    def.solver.joint_trees = JointTrees::all;
    def.solver.measure_residual = true;
    def.solver.shock = random.one_in(2) ? 0.3f : 0;
    def.solver.sweep_order = random.one_in(3) ? SweepOrder::upward : SweepOrder::colored;
    def.solver.block_contacts = random.one_in(4);
    if (random.one_in(2)) def.tasks = {run_all, nullptr, 4};
    return def;
}

/// As many of everything as there is room for. All shapes overlap, so all pairs of bodies are contacts as long as there is room.
struct FullWorld : TestWorld {
    FullWorld(const Capacity& c, Random& random) : TestWorld(c, greedy(random)) {
        World& w = **this;
        const auto place = [&] { return Vec2{random.between(-0.3f, 0.3f), random.between(-0.3f, 0.3f)}; };
        const auto add_shape = [&](BodyId body) { return bool(w.create_shape(body, Circle{{}, 0.5f + 0.01f * random.between(0, 1)}, {.hit_events = true})); };
        for (std::uint32_t i = 0; i < c.bodies; ++i) {
            all.push_back(w.create_body({.type = BodyType::dynamic, .position = place(), .linear_velocity = place()}));
            add_shape(all.back());
        }
        while (add_shape(all[random.below(c.bodies)])) {}
        if (c.bodies > 1) add_joints(c, random);
    }

    // A tree of hinges, then joints of other types; they let their bodies touch.
    void add_joints(const Capacity& c, Random& random) {
        World& w = **this;
        for (std::uint32_t i = 1; i < c.bodies && w.joint_count() < c.joints; ++i) test::join(w, JointType::revolute, all[i], all[random.below(i)], true);
        while (w.joint_count() < c.joints) {
            const std::uint32_t a = random.below(c.bodies), b = (a + 1 + random.below(c.bodies - 1)) % c.bodies;
            test::join(w, test::joint_types[random.below(8)], all[a], all[b], true);
        }
    }

    // Every stage and every other call that uses scratch memory.
    void use_scratch() {
        World& w = **this;
        for (int i = 0; i < 3; ++i) w.step(dt);
        ASSERT_EQ(w.validate(), nullptr);
        IslandProblem problem;
        w.export_island(all.front(), dt, {}, problem);
        w.enable_sleep(false);  // wakes islands
    }

    std::vector<BodyId> all;
};

/// Of different shapes: few contacts for many bodies, many for few, several shapes a body, with joints and without.
Capacity any_capacity(Random& random) {
    Capacity c;
    c.bodies = 1 + random.below(random.one_in(2) ? 12 : 90);
    c.shapes = c.bodies + random.below(random.one_in(3) ? 400 : 20);
    const std::uint32_t pairs = c.bodies * (c.bodies - 1) / 2;
    c.contacts = 1 + random.below(std::max(1u, std::min(pairs, random.one_in(3) ? 5000u : 60u)));
    c.joints = c.bodies == 1 || random.one_in(3) ? 0 : random.below(2 * c.bodies);
    if (random.one_in(4)) c.hits = random.below(8 * c.contacts);  // whose room serves as scratch until a step ends
    if (random.one_in(4)) c.events = 1 + random.below(c.contacts);
    return c;
}

TEST(Scratch, IsEnoughToExportAnIslandWhereThereIsRoomForManyHits) {
    // Then the step's end decides how much scratch there is, which is little: an island takes more.
    Random random(13);
    constexpr Capacity contacts{.bodies = 58, .shapes = 58, .contacts = 1600, .hits = 6400};
    constexpr Capacity joints{.bodies = 3, .shapes = 3, .contacts = 3, .joints = 1500, .hits = 40000};
    for (const Capacity& c : {contacts, joints}) {
        FullWorld w(c, random);
        w.use_scratch();
    }
}

TEST(Scratch, IsEnoughForFullWorldsOfAnyCapacity) {
    Random random(11);
    int full = 0;
    for (int i = 0; i < 300; ++i) {
        const Capacity c = any_capacity(random);
        SCOPED_TRACE(testing::Message() << c.bodies << " bodies, " << c.shapes << " shapes, " << c.contacts << " contacts, " << c.joints << " joints");
        FullWorld w(c, random);
        ASSERT_EQ(w->body_count(), c.bodies);
        ASSERT_EQ(w->shape_count(), c.shapes);
        ASSERT_EQ(w->joint_count(), c.joints);
        w.use_scratch();
        full += w->contact_count() == c.contacts ? 1 : 0;
    }
    EXPECT_GT(full, 200) << "the test hardly fills a pool of contacts";
}

#if GTEST_HAS_DEATH_TEST
// The test above would notice: with a third less scratch, stages of full worlds trap.
TEST(ScratchDeathTest, IsNotMuchMoreThanFullWorldsTake) {
    GTEST_FLAG_SET(death_test_style, "fast");
    for (const Capacity& c : {Capacity{.bodies = 90, .shapes = 90, .contacts = 4000}, Capacity{.bodies = 40, .shapes = 4000, .contacts = 1}}) {
        Random random(12);
        EXPECT_DEATH(
            {
                FullWorld w(c, random);
                detail::Core& core = detail::Core::of(*w);
                core.scratch_end -= detail::scratch_bytes(c) / 3 / 64 * 64;
                w.use_scratch();
            },
            "");
    }
}
#endif

}  // namespace
