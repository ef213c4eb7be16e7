// Structs that carry their size: a program that was built when a struct was shorter goes on working, as if it gave the further fields their defaults.
#include <gtest/gtest.h>

#include "glue.hpp"

// A struct as it was, and as it is: two fields came later.
struct IsletToyDef {
    std::uint32_t struct_size;
    float width;
    float height;
    std::uint32_t color;
};

namespace islet::c {

struct ToyDef {
    float width = 1;
    float height = 2;
    std::uint32_t color = 3;
};
template <>
struct Twin<ToyDef> {
    using Type = IsletToyDef;
    static constexpr std::uint32_t start = 4;
};
template <>
struct First<ToyDef> {
    std::uint32_t struct_size;
    float width;
};

namespace {

TEST(GrownStructs, OfOlderProgramsGetTheDefaultsOfNewFields) {
    const IsletToyDef given = {8, 10, 20, 30};  // what follows the first field is not the program's
    Room<ToyDef> room;
    const ToyDef* taken = take<ToyDef>(nullptr, &given, room);
    ASSERT_NE(taken, nullptr);
    EXPECT_EQ(taken->width, 10);
    EXPECT_EQ(taken->height, 2);
    EXPECT_EQ(taken->color, 3u);
}

TEST(GrownStructs, OfProgramsBetweenKeepTheirFields) {
    const IsletToyDef given = {12, 10, 20, 30};
    Room<ToyDef> room;
    const ToyDef* taken = take<ToyDef>(nullptr, &given, room);
    ASSERT_NE(taken, nullptr);
    EXPECT_EQ(taken->height, 20);
    EXPECT_EQ(taken->color, 3u);
}

TEST(GrownStructs, OfThisVersionAreTakenAsTheyAre) {
    const IsletToyDef given = {16, 10, 20, 30};
    Room<ToyDef> room;
    const ToyDef* taken = take<ToyDef>(nullptr, &given, room);
    EXPECT_EQ(static_cast<const void*>(taken), &given.width);
}

TEST(GrownStructs, OfNoKnownSizeAreRefused) {
    Room<ToyDef> room;
    for (std::uint32_t size : {0u, 4u, 7u, 9u, 14u, 17u, 20u, 0xffffffffu}) {
        const IsletToyDef given = {size, 10, 20, 30};
        EXPECT_EQ(take<ToyDef>(nullptr, &given, room), nullptr) << size;
        EXPECT_FALSE(fits<ToyDef>(nullptr, &given)) << size;
    }
    EXPECT_EQ(take<ToyDef>(nullptr, nullptr, room), nullptr);
    EXPECT_FALSE(fits<ToyDef>(nullptr, nullptr));
}

TEST(GrownStructs, OfACallWithoutItsWorldAreRefused) {
    const IsletWorld* const none = nullptr;
    Room<ToyDef> room;
    for (std::uint32_t size : {8u, 12u, 16u}) {
        const IsletToyDef given = {size, 10, 20, 30};
        EXPECT_EQ(take<ToyDef>(none, &given, room), nullptr) << size;
        EXPECT_EQ(take_with<ToyDef>(none, &given, &given, room), nullptr) << size;
    }
    EXPECT_EQ(take_with<ToyDef>(none, &room, nullptr, room), nullptr);
}

TEST(GrownStructs, AreTakenWithWhatElseTheCallNeeds) {
    alignas(world_alignment) static std::byte block[20000];
    World* const made = World::create(block, {.bodies = 1, .shapes = 1, .contacts = 1}, {});
    ASSERT_NE(made, nullptr);
    IsletWorld* const world = cast<IsletWorld>(made);
    const IsletToyDef given = {12, 10, 20, 30};
    Room<ToyDef> room;
    EXPECT_EQ(take_with<ToyDef>(world, &given, nullptr, room)->width, 1);
    EXPECT_EQ(take_with<ToyDef>(world, &given, &given, room)->height, 20);
    EXPECT_EQ(made->last_error(), Error::none);
    EXPECT_EQ(take_with<ToyDef>(world, nullptr, &given, room), nullptr);
    EXPECT_EQ(static_cast<int>(made->last_error()), ISLET_ERROR_NULL_POINTER);
}

TEST(GrownStructs, GetNoMoreOfAResultThanTheyHaveRoomFor) {
    IsletToyDef to = {8, 0, 77, 88};
    ASSERT_TRUE(fits<ToyDef>(nullptr, &to));
    give<ToyDef>(&to, {5, 6, 7});
    EXPECT_EQ(to.width, 5);
    EXPECT_EQ(to.height, 77);
    EXPECT_EQ(to.color, 88u);
    to.struct_size = 16;
    give<ToyDef>(&to, {5, 6, 7});
    EXPECT_EQ(to.height, 6);
    EXPECT_EQ(to.color, 7u);
}

}  // namespace
}  // namespace islet::c
