// What the bits may not depend on: the memory a world is made in, objects that were there before, who looks on; and what the hash must notice.
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "support/test_world.hpp"

namespace islet::test {
namespace {

constexpr float dt = 1.0f / 60;
constexpr Capacity heap_capacity{.bodies = 96, .shapes = 160, .contacts = 768};

struct Objects {
    std::vector<BodyId> bodies;  // in the order they were made
};

// A pit with a chain floor, a kinematic paddle, and a heap of all kinds of shapes that falls into it; some have several shapes, restitution,
// rolling resistance or damping.
Objects fill(World& world) {
    Objects made;
    const BodyId pit = world.create_body({});
    std::vector<Vec2> floor;
    for (int x = 8; x >= -8; --x) floor.push_back({static_cast<float>(x), 0.125f * static_cast<float>(x * x % 5)});
    world.create_chain(pit, floor, false);
    world.create_shape(pit, make_offset_box(0.5f, 4, {{-7, 4}, {}}));
    world.create_shape(pit, make_offset_box(0.5f, 4, {{7, 4}, {}}));
    made.bodies.push_back(pit);
    BodyDef paddle;
    paddle.type = BodyType::kinematic;
    paddle.position = {0, 2};
    paddle.angular_velocity = 1.5f;
    made.bodies.push_back(world.create_body(paddle));
    world.create_shape(made.bodies.back(), make_rounded_box(2, 0.1f, 0.05f));
    for (int i = 0; i < 48; ++i) {
        BodyDef def;
        def.type = BodyType::dynamic;
        def.position = {static_cast<float>(i % 6) * 1.5f - 4, 4 + 1.25f * static_cast<float>(i / 6)};
        def.angle = 0.25f * static_cast<float>(i);
        def.linear_velocity = {static_cast<float>(i % 5) - 2, 0};
        def.angular_damping = i % 7 == 0 ? 0.5f : 0;
        const BodyId id = world.create_body(def);
        ShapeDef shape;
        shape.friction = 0.25f * static_cast<float>(i % 4);
        shape.restitution = i % 4 == 1 ? 0.5f : 0;
        shape.rolling_resistance = i % 5 == 0 ? 0.1f : 0;
        switch (i % 4) {
        case 0: world.create_shape(id, Circle{{}, 0.375f}, shape); break;
        case 1: world.create_shape(id, make_box(0.5f, 0.25f), shape); break;
        case 2: world.create_shape(id, Capsule{{-0.25f, 0}, {0.25f, 0}, 0.25f}, shape); break;
        default:
            world.create_shape(id, make_box(0.125f, 0.5f), shape);
            world.create_shape(id, make_offset_box(0.5f, 0.125f, {{0, 0.25f}, {}}), shape);
        }
        made.bodies.push_back(id);
    }
    return made;
}

std::uint64_t hash_after(World& world, int steps) {
    for (int i = 0; i < steps; ++i) world.step(dt);
    return world.hash();
}

// -- memory ------------------------------------------------------------------------------------------------------------------------

TEST(Memory, WhatTheBlockHeldBeforeChangesNothing) {
    std::vector<std::uint64_t> hashes;
    std::mt19937 random(7);
    for (const int kind : {0, 1, 2, 3}) {
        Block block(world_bytes(heap_capacity));
        for (std::byte& b : block.span())
            b = kind == 0 ? std::byte{0} : kind == 1 ? std::byte{0xff} : kind == 2 ? static_cast<std::byte>(random()) : std::byte{0x7f};
        World* world = World::create(block.span(), heap_capacity, {});
        ASSERT_NE(world, nullptr);
        fill(*world);
        hashes.push_back(world->hash());
        hashes.push_back(hash_after(*world, 1));
        hashes.push_back(hash_after(*world, 240));
    }
    for (std::size_t i = 3; i < hashes.size(); ++i) EXPECT_EQ(hashes[i], hashes[i % 3]) << "memory " << i / 3;
}

TEST(Memory, AWorldMadeOverAnotherIsLikeNew) {
    Block block(world_bytes(heap_capacity));
    World* world = World::create(block.span(), heap_capacity, {});
    fill(*world);
    const std::uint64_t first = hash_after(*world, 150);
    world = World::create(block.span(), heap_capacity, {});
    fill(*world);
    EXPECT_EQ(hash_after(*world, 150), first);
}

TEST(Memory, TwoWorldsSideBySideDoNotDisturbEachOther) {
    TestWorld a(heap_capacity), b(heap_capacity), alone(heap_capacity);
    fill(*a);
    fill(*b);
    fill(*alone);
    for (int i = 0; i < 120; ++i) {
        a.step();
        b.step(1, i % 2 == 0 ? dt : 0.5f * dt);
    }
    EXPECT_EQ(a->hash(), hash_after(*alone, 120));
    EXPECT_NE(a->hash(), b->hash());
}

// -- history -----------------------------------------------------------------------------------------------------------------------

TEST(History, TheSameCallsGiveTheSameBits) {
    // Objects come and go during the run, the same ones in the same order.
    const auto live = [](World& world) {
        const Objects made = fill(world);
        std::vector<BodyId> bodies = made.bodies;
        std::mt19937 random(3);
        for (int i = 0; i < 300; ++i) {
            if (i % 10 == 5) {
                const std::size_t at = 2 + random() % (bodies.size() - 2);
                world.destroy_body(bodies[at]);
                BodyDef def;
                def.type = BodyType::dynamic;
                def.position = {static_cast<float>(random() % 8) - 4, 12};
                bodies[at] = world.create_body(def);
                world.create_shape(bodies[at], make_box(0.25f, 0.5f));
            }
            if (i % 40 == 20) {
                const BodyId id = bodies[2 + random() % (bodies.size() - 2)];
                world.set_type(id, BodyType::static_body);
                world.set_type(id, BodyType::dynamic);
                world.set_transform(id, {0, 10}, 0.5f);
            }
            world.step(dt);
        }
        EXPECT_EQ(world.validate(), nullptr);
        return world.hash();
    };
    std::uint64_t first = 0;
    for (const std::uint32_t lanes : {1u, 4u, 8u, 16u}) {
        WorldDef def;
        def.lanes = lanes;
        TestWorld world(heap_capacity, def);
        const std::uint64_t hash = live(*world);
        if (first == 0) first = hash;
        EXPECT_EQ(hash, first) << "lanes " << lanes;
    }
}

TEST(History, DestroyingAndRecreatingInTheSameOrderGivesEqualWorlds) {
    // Two worlds, both emptied and filled again: the slots, ids and bits are the same.
    std::uint64_t hashes[2];
    for (std::uint64_t& hash : hashes) {
        TestWorld world(heap_capacity);
        const Objects made = fill(*world);
        world.step(90);
        for (const BodyId id : made.bodies) world->destroy_body(id);
        EXPECT_EQ(world->body_count(), 0u);
        EXPECT_EQ(world->contact_count(), 0u);
        fill(*world);
        hash = hash_after(*world, 200);
    }
    EXPECT_EQ(hashes[0], hashes[1]);
}

TEST(History, ARefilledWorldMovesLikeAFreshOne) {
    // Emptied last made first, the free slots stand in the order of a fresh world. Ids differ (their generations count on), motion does not.
    TestWorld fresh(heap_capacity), used(heap_capacity);
    Objects made = fill(*used);
    for (std::size_t i = made.bodies.size(); i-- > 0;) used->destroy_body(made.bodies[i]);
    made = fill(*used);
    const Objects first = fill(*fresh);
    for (int i = 0; i < 200; ++i) {
        fresh.step();
        used.step();
    }
    for (std::size_t i = 0; i < made.bodies.size(); ++i) {
        EXPECT_EQ(made.bodies[i].index1, first.bodies[i].index1);
        EXPECT_EQ(used->transform(made.bodies[i]), fresh->transform(first.bodies[i])) << "body " << i;
        EXPECT_EQ(used->linear_velocity(made.bodies[i]), fresh->linear_velocity(first.bodies[i])) << "body " << i;
    }
}

// -- looking on --------------------------------------------------------------------------------------------------------------------

// All that a step reports, as text.
std::string all_events(const World& world) {
    const StepReport& r = world.report();
    std::string text;
    const auto add = [&](std::uint64_t n) { text += std::to_string(n) + " "; };
    for (const std::uint32_t n : {r.bodies, r.awake_bodies, r.shapes, r.contacts, r.touching_contacts, r.recycled_contacts,
                                  r.dropped_contacts, r.dropped_events, r.islands, r.colors, r.overflow_contacts})
        add(n);
    const auto events = [&](std::span<const TouchEvent> list) {
        text += "| ";
        for (const TouchEvent& e : list) add(e.shape_a.index1), add(e.shape_b.index1);
    };
    events(world.begin_touch_events());
    events(world.end_touch_events());
    const auto bodies = [&](std::span<const BodyId> list) {
        text += "| ";
        for (const BodyId& id : list) add(id.index1);
    };
    bodies(world.moved_bodies());
    bodies(world.slept_bodies());
    return text;
}

TEST(Reports, EventsAndHashesComeInTheSameOrderAtEveryWidth) {
    std::vector<std::string> stories[3];
    std::vector<std::uint64_t> hashes[3];
    std::size_t events = 0;
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}, std::size_t{2}}) {
        WorldDef def;
        def.lanes = i == 0 ? 1 : i == 1 ? 4 : 8;
        TestWorld world(heap_capacity, def);
        fill(*world);
        for (int step = 0; step < 400; ++step) {
            world.step();
            stories[i].push_back(all_events(*world));
            events += world->begin_touch_events().size() + world->end_touch_events().size() + world->slept_bodies().size();
            if (step % 10 == 9) hashes[i].push_back(world->hash());
        }
    }
    EXPECT_GT(events, 300u) << "too little happened to prove anything";
    for (const std::size_t i : {1, 2}) {
        EXPECT_EQ(hashes[i], hashes[0]);
        for (std::size_t step = 0; step < stories[0].size(); ++step) ASSERT_EQ(stories[i][step], stories[0][step]) << "step " << step;
    }
}

TEST(Hash, ReadingTheWorldChangesNothing) {
    TestWorld watched(heap_capacity), alone(heap_capacity);
    fill(*watched);
    fill(*alone);
    for (int i = 0; i < 120; ++i) {
        watched.step();
        (void)watched->hash();
        (void)watched->validate();
        (void)watched.contacts();
        for (const BodyId id : watched.bodies()) (void)watched->velocity_at(id, {1, 2});
    }
    EXPECT_EQ(watched->hash(), hash_after(*alone, 120));
}

}  // namespace
}  // namespace islet::test
