// Fleets in C and in C++: the fleet of fleets.c once more, with equal hashes and observations after each round; and what C refuses.
#include "fleets.h"

#include <gtest/gtest.h>
#include <islet/fleet.hpp>
#include <islet/islet.hpp>

#include <memory>
#include <vector>

namespace {

using namespace islet;

StaticWorld<Capacity{.bodies = 16, .shapes = 16, .contacts = 64, .joints = 8}> yard_storage;

/// The same as Yard in fleets.c.
struct CppYard {
    World& world = yard_storage.create({});
    BodyId cart, pole, box;
    JointId hinge;

    BodyId box_at(Vec2 p, float half_width, float half_height) {
        const BodyId body = world.create_body({.type = BodyType::dynamic, .position = p});
        world.create_shape(body, make_box(half_width, half_height));
        return body;
    }
    CppYard() {
        world.create_shape(world.create_body({.position = {0, -1}}), make_box(50, 1));
        cart = box_at({0, 0.25f}, 0.5f, 0.25f);
        pole = box_at({0, 1}, 0.05f, 0.5f);
        box = box_at({2, 3}, 0.5f, 0.5f);
        hinge = world.create_joint(RevoluteJointDef{.base = {.body_a = cart, .body_b = pole, .frame_a = {{0, 0.25f}}, .frame_b = {{0, -0.5f}}},
                                                    .motor = {.enable = true, .max_force = 2}});
    }
};

TEST(Fleets, ComeToTheSameBitsFromCAndFromCpp) {
    const auto of_c = std::make_unique<FleetStory>();
    ASSERT_TRUE(tell_fleet_story(of_c.get()));

    CppYard yard;
    const std::size_t bytes = Fleet::bytes(fleet_worlds, yard.world.capacity(), 3);
    EXPECT_EQ(of_c->bytes, bytes);
    struct alignas(world_alignment) Line {
        std::byte bytes[world_alignment];
    };
    std::vector<Line> block(bytes / sizeof(Line) + 1);
    Fleet* const fleet = Fleet::create(std::as_writable_bytes(std::span(block)), yard.world, fleet_worlds);
    ASSERT_NE(fleet, nullptr);
    const Drive drives[] = {{.kind = DriveKind::force_x, .body = yard.cart, .scale = 30},
                            {.kind = DriveKind::motor_speed, .joint = yard.hinge, .scale = 3},
                            {.kind = DriveKind::torque, .body = yard.box, .scale = 5}};
    const Sense senses[] = {{.kind = SenseKind::position, .body = yard.box},
                            {.kind = SenseKind::rotation, .body = yard.pole},
                            {.kind = SenseKind::velocity, .body = yard.box},
                            {.kind = SenseKind::angular_velocity, .body = yard.pole},
                            {.kind = SenseKind::joint, .joint = yard.hinge},
                            {.kind = SenseKind::touching, .body = yard.pole},
                            {.kind = SenseKind::ray, .body = yard.box, .translation = {0, -4}}};
    const Variation variation[] = {{.body = yard.box, .position = {0.5f, 0}, .velocity = {0, 2}, .angular_velocity = 1}};
    const std::uint8_t mask[fleet_worlds] = {1, 1, 0, 1, 0, 1, 1, 0, 1, 1, 1, 0, 0, 1, 1, 1, 0, 1, 0};
    const std::uint32_t parents[fleet_worlds] = {0, 0, 2, 2, 2, 5, 5, 7, 8, 2, 0, 11, 11, 8, 14, 15, 14, 5, 18};
    alignas(8) static std::byte image[1 << 16];
    const std::span<const std::byte> saved(image, yard.world.save(image));
    float actions[fleet_worlds * fleet_drives], observations[fleet_worlds * fleet_columns];
    for (unsigned round = 0; round < fleet_rounds; ++round) {
        fleet_actions(round, actions);
        FleetStep what{.repeat = 1 + round % 3, .drives = drives, .actions = actions};
        if (round % 2 == 1) what.mask = mask;
        ASSERT_EQ(fleet->step(what), Error::none);
        Error error = Error::none;
        if (round % 10 == 4) error = fleet->reset(round % fleet_worlds, saved, round, variation);
        if (round % 10 == 6) error = fleet->copy(3, 1);
        if (round % 10 == 8) error = fleet->fork(parents);
        ASSERT_EQ(error, Error::none);
        ASSERT_EQ(fleet->observe(senses, observations), Error::none);
        for (std::uint32_t k = 0; k < fleet_worlds; ++k) ASSERT_EQ(of_c->hashes[round][k], (*fleet)[k].hash()) << "round " << round << ", world " << k;
        for (std::size_t i = 0; i < std::size(observations); ++i)
            ASSERT_EQ(of_c->observations[round][i], observations[i]) << "round " << round << ", number " << i;
    }
    EXPECT_NE((*fleet)[5].hash(), (*fleet)[2].hash()) << "the actions do nothing";
}

TEST(Fleets, RefuseWhatIsWrongInC) { EXPECT_EQ(refuse_fleet_calls(), 0); }

}  // namespace
