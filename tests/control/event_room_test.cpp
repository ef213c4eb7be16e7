// Capacity::events: room for touches that begin, and for as many that end.
#include <gtest/gtest.h>

#include <vector>

#include "support/test_world.hpp"

namespace islet::test {
namespace {

constexpr std::uint32_t balls = 5;
constexpr Capacity with_room(std::uint32_t events) { return {.bodies = 8, .shapes = 8, .contacts = 16, .events = events}; }

// Balls that touch the ground at once.
std::vector<BodyId> drop_balls(World& world) {
    world.create_shape(world.create_body({}), make_box(20, 1));
    std::vector<BodyId> made;
    for (std::uint32_t i = 0; i < balls; ++i) {
        made.push_back(world.create_body({.type = BodyType::dynamic, .position = {static_cast<float>(2 * i), 1.5f}}));
        world.create_shape(made.back(), Circle{{}, 0.5f});
    }
    world.step(1.0f / 60);
    return made;
}

TEST(EventRoom, IsThatOfAllContactsIfNoneIsGiven) {
    TestWorld world(with_room(0));
    drop_balls(*world);
    EXPECT_EQ(world->begin_touch_events().size(), balls);
    EXPECT_EQ(world->report().dropped_events, 0u);
    EXPECT_EQ(world->last_error(), Error::none);
    EXPECT_EQ(world_bytes(with_room(0)), world_bytes(with_room(16)));
    EXPECT_EQ(world_bytes(with_room(0)), world_bytes(with_room(1000))) << "more than contacts cannot begin";
    EXPECT_LT(world_bytes(with_room(2)), world_bytes(with_room(0)));
    EXPECT_FALSE(is_valid(with_room(max_capacity + 1)));
}

TEST(EventRoom, TouchesWithoutRoomAreDroppedAndCountedAndChangeNothingElse) {
    TestWorld world(with_room(2)), whole(with_room(0));
    const std::vector<BodyId> made = drop_balls(*world), same = drop_balls(*whole);
    EXPECT_EQ(world->begin_touch_events().size(), 2u);
    EXPECT_EQ(world->report().dropped_events, balls - 2);
    EXPECT_EQ(world->last_error(), Error::events_full);
    EXPECT_EQ(world->hash(), whole->hash());

    // Touches that end, in calls: as many are told as there is room for.
    for (std::uint32_t i = 0; i < 3; ++i) {
        world->destroy_body(made[i]);
        whole->destroy_body(same[i]);
    }
    EXPECT_EQ(world->validate(), nullptr);
    world->step(1.0f / 60);
    whole->step(1.0f / 60);
    EXPECT_EQ(world->end_touch_events().size(), 2u);
    EXPECT_EQ(whole->end_touch_events().size(), 3u);
    EXPECT_EQ(world->hash(), whole->hash()) << "what was told is not part of the state";
    EXPECT_EQ(world->validate(), nullptr);
}

TEST(EventRoom, BeginningsOfSensorsShareIt) {
    TestWorld world(with_room(3));
    world->create_shape(world->create_body({}), Circle{{4, 1.5f}, 6}, {.sensor = true});
    drop_balls(*world);
    EXPECT_EQ(world->begin_touch_events().size() + world->sensor_begin_events().size(), 3u);
    EXPECT_EQ(world->report().dropped_events, 2 * balls - 3);
}

TEST(EventRoom, AnImageFitsIfItsWaitingEndsDo) {
    TestWorld whole(with_room(0)), small(with_room(2));
    const std::vector<BodyId> made = drop_balls(*whole);
    std::vector<std::byte> image(whole->snapshot_bytes());
    whole->save(image);
    EXPECT_TRUE(small->load(image));
    EXPECT_EQ(small->hash(), whole->hash());
    for (std::uint32_t i = 0; i < 3; ++i) whole->destroy_body(made[i]);  // three touches wait to be told
    image.resize(whole->snapshot_bytes());
    whole->save(image);
    small->clear_error();
    EXPECT_FALSE(small->load(image));
    EXPECT_EQ(small->last_error(), Error::image_too_large);
}

}  // namespace
}  // namespace islet::test
