// Recordings: every scene, with all its script does, replayed in another world to the same hash after each step.
#include <gtest/gtest.h>

#include <string>

#include "golden.hpp"
#include "harness/world_recording.hpp"
#include "physics/measure.hpp"
#include "support/test_world.hpp"

namespace islet::test {
namespace {

using samples::IsletEngine;
using samples::Scene;
using samples::SceneInfo;

class Recorded : public testing::TestWithParam<SceneInfo> {};

TEST_P(Recorded, SceneIsReplayedToTheSameHashesAtAnyNumberOfLanes) {
    const SceneInfo& info = GetParam();
    const golden::Table table = golden::read(golden::file());
    const bool large = std::string(info.group) == "benchmark";
    const std::vector<golden::Checkpoint> checkpoints = golden::checkpoints_of(table, info);
    const int steps = (large || slow_build ? checkpoints.front() : checkpoints.back()).steps;

    const Scene scene = info.make();
    IsletEngine engine;
    engine.load(scene);
    samples::WorldRecording recording(engine.world());
    for (int step = 0; step < steps; ++step) {
        engine.advance(scene, step, scene.dt);
        recording.after_step();
    }
    const std::uint64_t hash = engine.world().hash();
    const std::span<const std::byte> bytes = recording.finish();
    ASSERT_FALSE(bytes.empty());
    EXPECT_EQ(engine.world().hash(), hash) << "recording changes nothing";

    RecordingInfo head;
    ASSERT_EQ(read_recording(bytes, head), Error::none);
    for (const std::uint32_t lanes : {1u, 4u, 8u, 16u, 0u}) {
        WorldDef def = {.lanes = lanes};
        TestWorld other(lanes != 0 ? head.needed : head.capacity, def);
        const ReplayResult result = replay(*other, bytes);
        ASSERT_EQ(result.end, ReplayEnd::complete) << describe(result.error) << " step " << result.steps << ", body " << result.body.index1;
        EXPECT_EQ(result.steps, std::uint64_t(steps));
        EXPECT_EQ(golden::hex(other->hash()), golden::hex(hash));
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Recorded, testing::ValuesIn(samples::catalogue()), [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace islet::test
