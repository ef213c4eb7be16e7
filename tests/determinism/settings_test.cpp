// Settings of the solver keep the bits: whatever the order of sweeps, block contacts, shock propagation and tolerance, a world goes the same way with any
// lanes, with tasks in any order, and from a snapshot.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "engine.hpp"
#include "scene.hpp"
#include "support/test_world.hpp"
#include "thread_pool.hpp"

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

class Settings : public testing::TestWithParam<Setting> {};

TEST_P(Settings, KeepTheBits) {
    for (const char* scene : {"pyramid", "ragdoll", "mass_ratio"}) {
        const Seen one = play(scene, GetParam().def, 1, {});
        EXPECT_EQ(play(scene, GetParam().def, 4, {}), one) << scene << ", 4 lanes";
        EXPECT_EQ(play(scene, GetParam().def, 8, {}), one) << scene << ", 8 lanes";
        EXPECT_EQ(play(scene, GetParam().def, 0, {}, true).hash, one.hash) << scene << ", from a snapshot";
        samples::ThreadPool pool(4);
        EXPECT_EQ(play(scene, GetParam().def, 0, pool.tasks()), one) << scene << ", 4 workers";
    }
}

TEST_P(Settings, KeepTheBitsOfManyIslandsOnWorkers) {
    samples::ThreadPool pool(4);
    EXPECT_EQ(play("confined", GetParam().def, 0, pool.tasks()), play("confined", GetParam().def, 0, {}));
}

INSTANTIATE_TEST_SUITE_P(Determinism, Settings, testing::ValuesIn(settings), [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace islet::test
