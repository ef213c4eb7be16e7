// Settings of the solver keep the bits: whatever the order of sweeps, block contacts, shock propagation and tolerance, a world goes the same way with any
// lanes, with tasks in any order, and from a snapshot.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "harness/engine.hpp"
#include "harness/scene.hpp"
#include "scenes/catalogue.hpp"
#include "support/test_world.hpp"
#include "workers/thread_pool.hpp"

namespace islet::test {
namespace {

struct Setting {
    const char* name;
    SolverDef def;
};

SolverDef with(void (*change)(SolverDef&)) {
    SolverDef def;
    change(def);
    return def;
}

const Setting settings[] = {
    {"AsFound", with([](SolverDef& d) { d.sweep_order = SweepOrder::as_found; })},
    {"Upward", with([](SolverDef& d) { d.sweep_order = SweepOrder::upward; })},
    {"Downward", with([](SolverDef& d) { d.sweep_order = SweepOrder::downward; })},
    {"Block", with([](SolverDef& d) { d.block_contacts = true; })},
    {"Shock", with([](SolverDef& d) { d.shock = 0.5f; })},
    {"Measured", with([](SolverDef& d) { d.measure_residual = true; })},
    {"Tolerance", with([](SolverDef& d) { d.iterations = d.relax_iterations = 8; d.tolerance = 1e-3f; })},
    {"ClassicAll", with([](SolverDef& d) {
         d.schedule = Schedule::classic;
         d.substeps = 1;
         d.iterations = 6;
         d.sweep_order = SweepOrder::upward;
         d.block_contacts = d.measure_residual = true;
         d.shock = 0.3f;
         d.tolerance = 1e-2f;
         d.joint_trees = JointTrees::all;
     })},
};

constexpr int steps = 60;

struct Seen {
    std::uint64_t hash;
    std::vector<float> residuals;
    friend bool operator==(const Seen&, const Seen&) = default;
};

Seen play(const char* scene_name, const SolverDef& solver, std::uint32_t lanes, const TaskSystem& tasks, bool through_snapshot = false) {
    samples::Scene scene = samples::find_scene(scene_name)->make();
    scene.world.solver = solver;
    scene.world.lanes = lanes;
    scene.world.tasks = tasks;
    samples::IsletEngine engine;
    engine.load(scene);
    for (int step = 0; step < steps; ++step) {
        engine.advance(scene, step, scene.dt);
        if (!through_snapshot || step != steps / 2) continue;
        std::vector<std::byte> image(engine.world().snapshot_bytes());
        EXPECT_EQ(engine.world().save(image), image.size());
        engine.advance(scene, step + 1, scene.dt);
        EXPECT_TRUE(engine.world().restore(image));
    }
    Seen seen{engine.world().hash(), {}};
    for (std::uint32_t i = 0; i < engine.world().capacity().bodies; ++i)
        if (const BodyId id = engine.world().body_at(i)) seen.residuals.push_back(engine.world().residual(id));
    EXPECT_EQ(engine.world().validate(), nullptr);
    return seen;
}

class SolverSettings : public testing::TestWithParam<Setting> {};

TEST_P(SolverSettings, KeepTheBits) {
    for (const char* scene : {"pyramid", "ragdoll", "mass_ratio"}) {
        const Seen one = play(scene, GetParam().def, 1, {});
        EXPECT_EQ(play(scene, GetParam().def, 4, {}), one) << scene << ", 4 lanes";
        EXPECT_EQ(play(scene, GetParam().def, 8, {}), one) << scene << ", 8 lanes";
        EXPECT_EQ(play(scene, GetParam().def, 16, {}), one) << scene << ", 16 lanes";
        EXPECT_EQ(play(scene, GetParam().def, 0, {}, true).hash, one.hash) << scene << ", from a snapshot";
        samples::ThreadPool pool(4);
        EXPECT_EQ(play(scene, GetParam().def, 0, pool.tasks()), one) << scene << ", 4 workers";
    }
}

TEST_P(SolverSettings, KeepTheBitsOfManyIslandsOnWorkers) {
    samples::ThreadPool pool(4);
    EXPECT_EQ(play("confined", GetParam().def, 0, pool.tasks()), play("confined", GetParam().def, 0, {}));
}

INSTANTIATE_TEST_SUITE_P(Determinism, SolverSettings, testing::ValuesIn(settings), [](const auto& test) { return std::string(test.param.name); });

void backwards(void*, std::uint32_t count, void (*task)(void*, std::uint32_t), void* data) {
    for (std::uint32_t i = count; i-- > 0;) task(data, i);
}

// A box that rested with 1e30 kg weighs nothing all at once: its push overflows, and must not reach other islands by way of the ground they share.
TEST(Settings, AnOverflowUnderABlockStaysInItsIsland) {
    const auto play = [](const TaskSystem& tasks) {
        WorldDef def;
        def.enable_sleep = false;
        def.tasks = tasks;
        def.solver.block_contacts = true;
        def.solver.sweep_order = SweepOrder::downward;
        TestWorld w({.bodies = 2000, .shapes = 2000, .contacts = 8000}, def);
        const BodyId ground = w.add_ground(0, 5000);
        const BodyId heavy = w.add_box({0, 0.5f});
        w->set_mass(heavy, {1e30f, {0, 0}, 1e30f / 6});
        for (int i = 0; i < 800; ++i) w.add_box({10 + 2 * static_cast<float>(i), 0.5f});
        for (int i = 0; i < 60; ++i) w->step(1.0f / 60);
        EXPECT_GT(w->report().batches, 2u) << "all are solved together: this test shows nothing";
        w->create_shape(ground, make_offset_box(1, 0.5f, {{0, 2.499f}, {}}));
        w->set_mass(heavy, {1e-12f, {0, 0}, 1e-12f});
        for (int i = 0; i < 4; ++i) w->step(1.0f / 60);
        return w->hash();
    };
    EXPECT_EQ(play({backwards, nullptr, 2}), play({}));
}

// Bodies of next to no mass that hardly turn: their residual must be a number, and one that does not depend on what is tried after what.
TEST(Settings, AResidualIsANumberOfWhateverBodies) {
    const auto play = [](std::uint32_t lanes) {
        WorldDef def;
        def.enable_sleep = false;
        def.lanes = lanes;
        def.solver.iterations = def.solver.relax_iterations = 8;
        def.solver.tolerance = 1e-2f;
        TestWorld w(roomy, def);
        w.add_ground();
        for (int i = 0; i < 30; ++i) {
            const auto row = static_cast<float>(i / 6);
            const BodyId box = w.add_box({static_cast<float>(i % 6) + 0.3f * static_cast<float>(i / 6 % 2), 0.5f + row});
            if (i % 5 == 1) w->set_mass(box, {1e-9f, {0, 0}, 1e30f});
        }
        std::vector<std::uint64_t> hashes;
        for (int i = 0; i < 40; ++i) {
            w->step(1.0f / 60);
            hashes.push_back(w->hash());
            for (const BodyId id : w.bodies()) EXPECT_EQ(w->residual(id), w->residual(id)) << "not a number";
        }
        return hashes;
    };
    const std::vector<std::uint64_t> one = play(1);
    EXPECT_EQ(play(4), one);
    EXPECT_EQ(play(8), one);
}

}  // namespace
}  // namespace islet::test
