// A recording whose calls an attacker changed, with all its sums made right: its calls are made, so the checks of calls, not of sums, must hold.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "support/forge_recording.hpp"
#include "support/random.hpp"
#include "support/test_world.hpp"

namespace islet::test {
namespace {

constexpr Capacity small_world{.bodies = 16, .shapes = 32, .contacts = 64, .joints = 4};

/// A box that is pushed before each of ten steps.
Image pushed_box() {
    TestWorld w(small_world);
    w.add_ground();
    const BodyId box = w.add_box({0, 0.5f});
    Image image(std::size_t{1} << 16);
    EXPECT_TRUE(w->start_recording(image.bytes()));
    for (int i = 0; i < 10; ++i) {
        w->apply_force_to_center(box, {5, 0});
        w->create_chain(w->body_at(0), std::vector<Vec2>{{3, 0}, {2, 1}, {1, 0}}, false);
        w.step();
    }
    const std::size_t bytes = w->stop_recording();
    Image recording(bytes);
    std::memcpy(recording.bytes().data(), image.bytes().data(), bytes);
    return recording;
}

std::size_t calls_of(const Image& recording) {
    detail::RecordingHead head;
    std::memcpy(&head, recording.bytes().data(), sizeof head);
    return detail::calls_at(head.image_bytes) / 4;
}

TEST(ForgedRecording, WithoutChangesSealingChangesNothing) {
    const Image original = pushed_box();
    Image sealed = original;
    EXPECT_EQ(seal_recording(sealed.bytes()).size(), 10u);
    EXPECT_TRUE(std::equal(original.bytes().begin(), original.bytes().end(), sealed.bytes().begin()));
}

TEST(ForgedRecording, AChangedCallIsRefusedWithWrongSumsAndMadeWithRightOnes) {
    const Image original = pushed_box();
    Image forged = original;
    const std::size_t x = calls_of(original) + 3;  // call, two words of the id, the force
    ASSERT_EQ(word(forged, x), __builtin_bit_cast(std::uint32_t, 5.0f));
    set_word(forged, x, __builtin_bit_cast(std::uint32_t, 500.0f));
    TestWorld w(small_world), there(small_world);
    EXPECT_EQ(replay(*w, forged.bytes()).end, ReplayEnd::refused);
    EXPECT_EQ(replay_forged(*w, forged.bytes()).end, ReplayEnd::complete);
    ASSERT_EQ(replay(*there, original.bytes()).end, ReplayEnd::complete);
    EXPECT_GT(w->position(w->body_at(1)).x, there->position(there->body_at(1)).x + 0.1f);
}

TEST(ForgedRecording, OfTwoThousandMostAreReplayedToTheEndAndAllLeaveASoundWorld) {
    const Image original = pushed_box();
    const std::size_t calls = calls_of(original), words = original.bytes().size() / 4;
    constexpr float evil[] = {0, -1, 1e30f, -1e30f, 1e-40f, 3e38f, std::numeric_limits<float>::infinity(), NAN, 1, 1e7f};
    int complete = 0;
    for (std::uint64_t seed = 0; seed < 2000; ++seed) {
        Random random(seed);
        Image forged = original;
        for (std::uint32_t i = 1 + random.below(3); i > 0; --i) {
            const std::size_t at = calls + random.below(static_cast<std::uint32_t>(words - calls));
            set_word(forged, at, random.one_in(4) ? random.below(90) : __builtin_bit_cast(std::uint32_t, evil[random.below(std::size(evil))]));
        }
        TestWorld w(small_world);
        const ReplayResult result = replay_forged(*w, forged.bytes());
        ASSERT_NE(result.end, ReplayEnd::differs) << seed;
        if (result.end == ReplayEnd::complete) ++complete;
        ASSERT_STREQ(w->validate(), nullptr) << seed;
        w.step(2);
        ASSERT_STREQ(w->validate(), nullptr) << seed;
    }
    EXPECT_GT(complete, 1000) << "words of ids and numbers are most of it";
}

}  // namespace
}  // namespace islet::test
