// Recordings in files: no more memory is taken than what they hold can fill, and none beyond the limit.
#include <cstdio>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "harness/world_recording.hpp"
#include "islet/replay_file.hpp"
#include "support/forge.hpp"
#include "support/test_world.hpp"
#include "calls/recorder.hpp"

namespace islet::test {
namespace {

TEST(ReplayFile, TakesNoMoreMemoryThanTheFileCouldFill) {
    TestWorld w({.bodies = 100, .shapes = 100, .contacts = 400});
    samples::AlignedBytes tape(1 << 16);
    ASSERT_TRUE(w->start_recording(tape.span()));
    w.add_ground();
    for (int i = 0; i < 20; ++i) w.add_box({0.8f * static_cast<float>(i), 1});
    w.step(20);
    const std::size_t size = w->stop_recording();
    ASSERT_NE(size, 0u);
    // The file says that its world had room for all there can be: 8 GB.
    std::byte* image = tape.span().data() + sizeof(detail::RecordingHead);
    detail::ImageHeader h;
    std::memcpy(&h, image, sizeof h);
    h.set_capacity({.bodies = max_capacity, .shapes = max_capacity, .contacts = max_capacity, .joints = max_capacity});
    std::memcpy(image, &h, sizeof h);
    seal({image, static_cast<std::size_t>(h.head.length)});
    const std::string path = testing::TempDir() + "islet_replay_test.rec";
    std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(tape.span().data()), static_cast<std::streamsize>(size));

    const tools::Replayed replayed = tools::replay_file(path, ~std::uint64_t{0}, 0, 1'000'000);
    EXPECT_EQ(replayed.error, "");
    EXPECT_EQ(replayed.result.end, ReplayEnd::complete);
    EXPECT_EQ(replayed.result.steps, 20u);
    EXPECT_EQ(replayed.hash, w->hash());
    const tools::Replayed refused = tools::replay_file(path, ~std::uint64_t{0}, 0, 1000);
    EXPECT_NE(refused.error.find("--memory-limit"), std::string::npos) << refused.error;
    std::remove(path.c_str());
}

}  // namespace
}  // namespace islet::test
