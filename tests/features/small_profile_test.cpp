// Worlds of the small profile, whose contacts have indices of 16 bits: how many there may be, and images that would not fit.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <vector>

#include <islet/islet.hpp>

#include "state/image.hpp"
#include "support/forge.hpp"
#include "support/image.hpp"

namespace {

using namespace islet;
using namespace islet::test;

static_assert(sizeof(detail::Contact) == 20 && sizeof(detail::ContactManifold) == 92, "this engine has wide contacts, which are tested elsewhere");

TEST(SmallWorld, HasAsManyContactsAsSixteenBitsCanListAtBothEnds) {
    const Capacity most{.bodies = 65535, .shapes = 65535, .contacts = 32767};
    EXPECT_TRUE(is_valid(most));
    std::vector<std::byte> memory(world_bytes(most) + world_alignment);
    void* at = memory.data();
    std::size_t room = memory.size();
    ASSERT_NE(std::align(world_alignment, world_bytes(most), at, room), nullptr);
    World* const world = World::create({static_cast<std::byte*>(at), world_bytes(most)}, most, {});
    ASSERT_NE(world, nullptr);
    // Pairs of circles that overlap, a contact each: the last are numbered by the largest indices.
    for (std::uint32_t pair = 0; pair < most.contacts; ++pair) {
        const Vec2 place = {3.0f * static_cast<float>(pair % 200), 3.0f * static_cast<float>(pair / 200)};
        world->create_shape(world->create_body({.type = BodyType::dynamic, .position = place}), Circle{{}, 0.5f});
        world->create_shape(world->create_body({.type = BodyType::dynamic, .position = place + Vec2{0.9f, 0}}), Circle{{}, 0.5f});
    }
    world->set_gravity({0, 0});
    world->step(1.0f / 60);
    EXPECT_EQ(world->last_error(), Error::none);
    EXPECT_EQ(world->report().contacts, most.contacts);
    EXPECT_EQ(world->validate(), nullptr);
    const Image image = save(*world);
    const std::uint64_t hash = world->hash();
    world->step(1.0f / 60);
    EXPECT_NE(world->hash(), hash);
    EXPECT_TRUE(world->load(image.bytes()));
    EXPECT_EQ(world->hash(), hash);
}

TEST(SmallWorld, WithMoreIsRefused) {
    EXPECT_FALSE(is_valid({.bodies = 65536, .shapes = 10, .contacts = 10}));
    EXPECT_FALSE(is_valid({.bodies = 10, .shapes = 65536, .contacts = 10}));
    EXPECT_FALSE(is_valid({.bodies = 10, .shapes = 10, .contacts = 32768}));
    EXPECT_STREQ(find_fault(Capacity{.bodies = 10, .shapes = 65536, .contacts = 10}).field, "shapes");
    EXPECT_STREQ(find_fault(Capacity{.bodies = 10, .shapes = 10, .contacts = 32768}).field, "contacts");
}

constexpr Capacity capacity{.bodies = 12, .shapes = 12, .contacts = 40};

void fill(World& world) {
    world.create_shape(world.create_body({.position = {0, -1}}), make_box(20, 1));
    BodyId third{};
    for (int i = 0; i < 8; ++i) {
        const auto height = static_cast<float>(i);
        const BodyId box = world.create_body({.type = BodyType::dynamic, .position = {0.1f * height, 0.5f + height}});
        world.create_shape(box, make_box(0.5f, 0.5f));
        if (i == 2) third = box;
    }
    for (int i = 0; i < 30; ++i) world.step(1.0f / 60);
    world.destroy_body(third);  // leaves free slots of contacts behind
}

// Where the records of contacts, or their manifolds, begin in an image, in words.
template <class Record>
std::size_t first_word(const Image& image) {
    const detail::ImageHeader h = header_of(image.bytes());
    std::size_t at = sizeof h, found = 0;
    detail::ImageView nothing;
    for_each_part(nothing, h, [&](auto& array, std::size_t bytes) {
        if constexpr (std::is_same_v<std::remove_reference_t<decltype(array)>, const Record*>) found = at;
        at += bytes;
    });
    return found / 4;
}

// An index that differs from a sound one above the 16 bits that would be kept of it.
TEST(SmallWorld, RefusesImagesWhoseIndicesAreWider) {
    StaticWorld<capacity> source_memory, victim_memory;
    World& source = source_memory.create({.enable_sleep = false, .continuous = false, .seamless_floors = false});
    World& victim = victim_memory.create({.enable_sleep = false, .continuous = false, .seamless_floors = false});
    fill(source);
    ASSERT_EQ(source.last_error(), Error::none);
    const Image sound = save(source);
    const std::uint32_t used = header_of(sound.bytes()).used.contacts;
    ASSERT_TRUE(victim.load(sound.bytes()));
    const std::uint64_t hash = victim.hash();
    EXPECT_EQ(hash, source.hash());

    std::vector<std::size_t> words;
    std::uint32_t free_slots = 0;
    for (std::uint32_t i = 0; i < used; ++i) {
        free_slots += word(sound, first_word<detail::ImageContact>(sound) + 8 * i + 6) % 2 == 0 ? 1 : 0;  // by its generation
        for (std::size_t field = 0; field < 6; ++field) words.push_back(first_word<detail::ImageContact>(sound) + 8 * i + field);
        for (std::size_t field = 0; field < 2; ++field) words.push_back(first_word<detail::ImageManifold>(sound) + 24 * i + field);
    }
    EXPECT_GT(free_slots, 0u);
    EXPECT_GT(used, free_slots);
    for (const std::size_t i : words) {
        Image forged = sound;
        set_word(forged, i, word(sound, i) ^ 0x10000u);
        seal(forged.bytes());
        EXPECT_FALSE(victim.load(forged.bytes())) << i;
        EXPECT_EQ(victim.last_error(), Error::unsound_image);
        ASSERT_EQ(victim.hash(), hash) << i;
    }
    EXPECT_TRUE(victim.load(sound.bytes()));
}

}  // namespace
