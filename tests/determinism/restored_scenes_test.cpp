// Going back: for every scene there is, at random steps, a world that is restored goes on as if nothing had happened, in its own memory and in
// that of another world.
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "golden.hpp"
#include "physics/measure.hpp"
#include "support/image.hpp"
#include "support/random.hpp"
#include "support/test_world.hpp"

namespace islet::test {
namespace {

using samples::IsletEngine;
using samples::Scene;
using samples::SceneInfo;

constexpr int detour = 3;  // steps away from the path that a restored world has taken before

// More room in the pools; but as many geometries, for a scene has no room to spare there.
Capacity larger_than(const Capacity& c) {
    return {c.bodies + 5, c.shapes + 70, 2 * c.contacts + 1, c.joints + 3, c.geometries != 0 ? c.geometries : c.shapes};
}

// Fills a world with things of its own, none of which may show once it has taken over another's state.
void occupy(TestWorld& w) {
    w.add_ground();
    const std::uint32_t count = w->capacity().bodies < 20 ? w->capacity().bodies : 20;
    for (std::uint32_t i = 1; i < count; ++i) w.add_circle({0.3f * static_cast<float>(i), 2 + 0.4f * static_cast<float>(i)}, 0.3f);
    for (int i = 0; i < 60; ++i) w->step(1.0f / 60);
}

// What a world does next: hashes of some steps, the events of each, and the ids it hands out after them.
struct Future {
    std::vector<std::uint64_t> numbers;
    friend bool operator==(const Future&, const Future&) = default;
};

Future future_of(World& w, float dt) {
    Future f;
    const auto add_id = [&](auto id) { f.numbers.insert(f.numbers.end(), {id.index1, id.generation}); };
    for (int i = 0; i < detour; ++i) {
        w.step(dt);
        f.numbers.push_back(w.hash());
        for (const TouchEvent& e : w.begin_touch_events()) add_id(e.shape_a), add_id(e.shape_b);
        for (const TouchEvent& e : w.end_touch_events()) add_id(e.shape_a), add_id(e.shape_b);
        for (const BodyId id : w.moved_bodies()) add_id(id);
        for (const BodyId id : w.slept_bodies()) add_id(id);
        for (const JointBreakEvent& e : w.broken_joints()) add_id(e.joint);
    }
    // As many new bodies as are destroyed, so that a world without room to spare takes the same way as one with more; far from all others.
    for (int i = 0; i < 2; ++i) {
        std::uint32_t last = w.capacity().bodies - 1;
        while (last > 0 && (!w.body_at(last) || w.type(w.body_at(last)) == BodyType::static_body)) --last;
        const std::uint32_t shapes = w.shapes(w.body_at(last), {});
        w.destroy_body(w.body_at(last));
        const BodyId body = w.create_body({.type = BodyType::dynamic, .position = {9000, 10.0f * static_cast<float>(i)}});
        add_id(body);
        if (shapes > 0) add_id(w.create_shape(body, Circle{{}, 0.7f + 0.1f * static_cast<float>(i)}));
    }
    w.step(dt);
    f.numbers.push_back(w.hash());
    return f;
}

class EveryScene : public testing::TestWithParam<SceneInfo> {};

TEST_P(EveryScene, RestoredGoesOnAsIfNothingHadHappened) {
    const SceneInfo& info = GetParam();
    const golden::Table table = golden::read(golden::file());
    const bool large = std::string(info.group) == "benchmark";
    const std::vector<golden::Checkpoint> checkpoints = golden::checkpoints_of(table, info);
    const golden::Checkpoint due = large || slow_build ? checkpoints.front() : checkpoints.back();

    Random random(2026);
    std::set<int> points;
    const int wanted = std::min(slow_build ? 4 : 20, due.steps);
    while (static_cast<int>(points.size()) < wanted) points.insert(static_cast<int>(random.below(static_cast<std::uint32_t>(due.steps))));

    const Scene scene = info.make();
    IsletEngine engine;
    engine.load(scene);
    World& world = engine.world();
    TestWorld other(larger_than(world.capacity()), scene.world);
    occupy(other);
    for (int step = 0; step < due.steps; ++step) {
        if (points.contains(step)) {
            const Image image = save(world);
            const std::uint64_t hash = world.hash();
            const Future future = future_of(world, scene.dt);

            ASSERT_TRUE(world.restore(image.bytes())) << describe(world.last_error());
            ASSERT_EQ(world.hash(), hash) << "restored at step " << step;
            ASSERT_TRUE(future_of(world, scene.dt) == future) << "the same world took another way from step " << step;

            ASSERT_TRUE(other->load(image.bytes())) << describe(other->last_error());
            ASSERT_EQ(other->hash(), hash) << "loaded at step " << step;
            const char* broken = other->validate();
            ASSERT_EQ(broken, nullptr) << broken;
            ASSERT_TRUE(future_of(*other, scene.dt) == future) << "another world took another way from step " << step;
            ASSERT_TRUE(world.restore(image.bytes()));
        }
        engine.advance(scene, step, scene.dt);
    }
    EXPECT_EQ(golden::hex(world.hash()), golden::hex(due.hash)) << "after all detours";
}

INSTANTIATE_TEST_SUITE_P(Rollback, EveryScene, testing::ValuesIn(samples::catalogue()), [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace islet::test
