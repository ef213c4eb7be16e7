// Half-spaces in snapshots, deltas, recordings and forged images.
#include <gtest/gtest.h>

#include <limits>

#include "bodies/geometry_pool.hpp"
#include "islet/recording.hpp"
#include "islet/snapshot.hpp"
#include "support/forge.hpp"
#include "support/test_world.hpp"

namespace islet::test {
namespace {

constexpr float floor_offset = -0.3125f;  // m, a number that stands nowhere else in an image

/// Three things on two half-spaces: a floor, and a wall on a kinematic body that comes nearer.
void fill(TestWorld& w) {
    w.add(HalfSpace{{0, 1}, floor_offset}, Vec2{}, {}, BodyType::static_body);
    const BodyId wall = w.add(HalfSpace{{-0.6f, 0.8f}, 0}, Vec2{4, 0}, {}, BodyType::kinematic);
    w->set_linear_velocity(wall, {-0.5f, 0});
    w.add_box({0, 0.5f});
    w.add_circle({1.5f, 0.7f});
    w.add_capsule({-2, 1});
}

void step(TestWorld& w, int steps) {
    for (int i = 0; i < steps; ++i) w->step(1.0f / 60);
}

TEST(HalfSpaceImages, AWorldGoesOnFromASnapshotAndFromADelta) {
    TestWorld w;
    fill(w);
    step(w, 20);
    const Image from = save(*w);
    step(w, 20);
    const Image to = save(*w);
    Image delta_bytes(max_delta_bytes(to.bytes().size())), applied(to.bytes().size());
    const std::size_t packed = delta(from.bytes(), to.bytes(), delta_bytes.bytes());
    ASSERT_GT(packed, 0u);
    ASSERT_EQ(apply(from.bytes(), delta_bytes.bytes().first(packed), applied.bytes()), to.bytes().size());
    EXPECT_TRUE(applied == to);

    TestWorld loaded;
    ASSERT_TRUE(loaded->load(applied.bytes()));
    EXPECT_EQ(loaded->validate(), nullptr);
    step(w, 60);
    step(loaded, 60);
    EXPECT_EQ(loaded->hash(), w->hash());
    ASSERT_TRUE(w->restore(to.bytes()));
    step(w, 60);
    EXPECT_EQ(w->hash(), loaded->hash());
}

TEST(HalfSpaceImages, ARecordingMakesMovesAndRefusesThemAgain) {
    TestWorld w;
    Image recorded(std::size_t{1} << 18);
    ASSERT_TRUE(w->start_recording(recorded.bytes()));
    fill(w);
    step(w, 10);
    const ShapeId floor = w.shape_of(w->body_at(0));
    w->set_half_space(floor, {{0.6f, 0.8f}, 0.25f});
    step(w, 10);
    w->set_half_space(floor, {{2, 0}, 0});        // not unit
    w->create_shape(w->body_at(2), HalfSpace{});  // of a dynamic body
    w->set_circle(floor, {{0, -1}, 1});
    step(w, 10);
    const std::size_t bytes = w->stop_recording();

    TestWorld other;
    const ReplayResult result = replay(*other, recorded.bytes().first(bytes));
    EXPECT_EQ(result.end, ReplayEnd::complete);
    EXPECT_EQ(result.steps, 30u);
    EXPECT_EQ(other->hash(), w->hash());
}

/// Where in an image the floor's geometry begins, in words.
std::size_t place_of_floor(const Image& image) {
    for (std::size_t i = 6; i < image.bytes().size() / 4; ++i)
        if (word(image, i) == __builtin_bit_cast(std::uint32_t, floor_offset) && word(image, i - 1) == __builtin_bit_cast(std::uint32_t, 1.0f)) return i - 6;
    return 0;
}

/// The image with another half-space for the floor, its hash and its checksum right.
Image with_floor(Image image, const HalfSpace& floor) {
    const std::size_t place = place_of_floor(image);
    detail::Geometry g;
    std::memcpy(static_cast<void*>(&g), image.bytes().data() + 4 * place, sizeof g);
    g.half_space = floor;
    g.hash = detail::geometry_hash(g);
    std::memcpy(image.bytes().data() + 4 * place, &g, sizeof g);
    seal(image.bytes());
    return image;
}

TEST(HalfSpaceImages, OneThatBreaksItsRulesIsRefusedThoughItsSumsAreRight) {
    TestWorld w;
    fill(w);
    step(w, 20);
    const Image image = save(*w);
    ASSERT_NE(place_of_floor(image), 0u);
    TestWorld victim;
    ASSERT_TRUE(victim->load(with_floor(image, {{0, 1}, floor_offset}).bytes()));
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    for (const HalfSpace& floor : {HalfSpace{{0, 2}, floor_offset}, HalfSpace{{0, 0}, floor_offset}, HalfSpace{{nan, 1}, floor_offset}, HalfSpace{{0, 1}, nan},
                                   HalfSpace{{0, 1}, inf}, HalfSpace{{0, 1}, 1.1e7f}}) {
        EXPECT_FALSE(victim->load(with_floor(image, floor).bytes())) << floor.normal.x << ' ' << floor.normal.y << ' ' << floor.offset;
        EXPECT_EQ(victim->last_error(), Error::unsound_image);
        EXPECT_EQ(victim->validate(), nullptr);
    }
}

}  // namespace
}  // namespace islet::test
