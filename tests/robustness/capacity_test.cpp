// Pools filled to their last place and beyond: running out is reported, changes nothing else, and loses nothing that was there before.
#include "refusal.hpp"

namespace {

using namespace islet;
using namespace islet::test;

// Runs a call that finds no room: the world must be as before.
template <class Call>
void expect_full(TestWorld& w, Error error, Call&& call) {
    w.errors.clear();
    const std::uint64_t before = w->hash();
    call();
    EXPECT_EQ(w->hash(), before) << "a call that found no room changed the world";
    EXPECT_EQ(w.errors, std::vector<Error>{error});
    EXPECT_EQ(w->last_error(), error);
    EXPECT_EQ(w->validate(), nullptr);
}

// -- bodies, shapes, geometries --------------------------------------------------------------------------------------------------------

TEST(Capacity, BodiesFillTheirPoolToTheLastPlace) {
    TestWorld w({.bodies = 5, .shapes = 5, .contacts = 5});
    std::vector<BodyId> ids;
    for (int i = 0; i < 5; ++i) ids.push_back(w->create_body({}));
    for (const BodyId id : ids) EXPECT_TRUE(w->is_valid(id));
    EXPECT_TRUE(w.errors.empty());
    expect_full(w, Error::bodies_full, [&] { EXPECT_FALSE(w->create_body({})); });
    w->destroy_body(ids[2]);
    const BodyId again = w->create_body({});
    EXPECT_EQ(again.index1, ids[2].index1);
    EXPECT_NE(again, ids[2]);
    expect_full(w, Error::bodies_full, [&] { EXPECT_FALSE(w->create_body({})); });
    EXPECT_EQ(w->body_count(), 5u);
}

TEST(Capacity, ShapesFillTheirPoolToTheLastPlace) {
    TestWorld w({.bodies = 2, .shapes = 3, .contacts = 5});
    const BodyId body = w->create_body({});
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(w->create_shape(body, Circle{{static_cast<float>(i), 0}, 0.5f}));
    EXPECT_EQ(w->shape_count(), 3u);
    expect_full(w, Error::shapes_full, [&] {
        EXPECT_FALSE(w->create_shape(body, Circle{{0, 0}, 0.5f})) << "a geometry that is stored already";
    });
    w->destroy_shape(w.shape_of(body));
    EXPECT_TRUE(w->create_shape(body, make_box(1, 1)));
    EXPECT_EQ(w->shape_count(), 3u);
}

TEST(Capacity, AShapeThatFindsNoRoomLeavesNoGeometryBehind) {
    // More room for geometries than for shapes, so that the geometry alone would fit.
    TestWorld w({.bodies = 1, .shapes = 2, .contacts = 1, .geometries = 8});
    const BodyId body = w->create_body({});
    w->create_shape(body, Circle{{0, 0}, 1});
    w->create_shape(body, Circle{{0, 0}, 2});
    for (int i = 3; i < 30; ++i)
        expect_full(w, Error::shapes_full, [&] { EXPECT_FALSE(w->create_shape(body, Circle{{0, 0}, static_cast<float>(i)})); });
}

TEST(Capacity, GeometriesFillTheirPoolToTheLastPlaceAndEqualOnesNeedOne) {
    TestWorld w({.bodies = 1, .shapes = 20, .contacts = 1, .geometries = 2});
    const BodyId body = w->create_body({});
    std::vector<ShapeId> boxes;
    for (int i = 0; i < 8; ++i) boxes.push_back(w->create_shape(body, make_box(1, 1)));
    EXPECT_TRUE(w->create_shape(body, make_box(1, 2)));
    EXPECT_TRUE(w.errors.empty()) << "nine shapes of two geometries must fit";
    expect_full(w, Error::geometries_full, [&] { EXPECT_FALSE(w->create_shape(body, make_box(1, 3))); });
    // The place comes free with the last shape that uses it.
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        expect_full(w, Error::geometries_full, [&] { EXPECT_FALSE(w->create_shape(body, make_box(1, 3))); });
        w->destroy_shape(boxes[i]);
    }
    EXPECT_TRUE(w->create_shape(body, make_box(1, 3)));
}

TEST(Capacity, AChainIsMadeWholeOrNotAtAll) {
    std::vector<Vec2> points;
    for (int i = 0; i < 6; ++i) points.push_back({static_cast<float>(i), static_cast<float>(i * i)});
    {
        TestWorld w({.bodies = 1, .shapes = 4, .contacts = 1});
        const BodyId body = w->create_body({});
        expect_full(w, Error::shapes_full, [&] { EXPECT_EQ(w->create_chain(body, points, false), 0u); });
        EXPECT_EQ(w->create_chain(body, std::span(points).first(5), false), 4u) << "four segments fit exactly";
    }
    {
        TestWorld w({.bodies = 1, .shapes = 20, .contacts = 1, .geometries = 4});
        const BodyId body = w->create_body({});
        expect_full(w, Error::geometries_full, [&] { EXPECT_EQ(w->create_chain(body, points, false), 0u); });
        EXPECT_EQ(w->shape_count(), 0u);
        EXPECT_EQ(w->create_chain(body, std::span(points).first(5), false), 4u);
    }
}

// -- contacts --------------------------------------------------------------------------------------------------------------------------

// A row of boxes on the ground, apart from each other: one contact each.
struct Row : TestWorld {
    explicit Row(std::uint32_t contacts, int boxes) : TestWorld({.bodies = 64, .shapes = 64, .contacts = contacts}) {
        add_ground();
        for (int i = 0; i < boxes; ++i) all.push_back(add_box({2.0f * static_cast<float>(i), 0.5f}));
    }
    std::vector<BodyId> all;
};

TEST(Capacity, ContactsFillTheirPoolToTheLastPlace) {
    Row w(8, 8);
    w.step(30);
    EXPECT_EQ(w->contact_count(), 8u);
    EXPECT_EQ(w->report().dropped_contacts, 0u);
    EXPECT_TRUE(w.errors.empty());
    for (const BodyId id : w.all) EXPECT_NEAR(w->position(id).y, 0.5f, 0.01f);
}

TEST(Capacity, EveryContactBeyondTheLastPlaceIsCountedOnceAndReported) {
    Row w(5, 8);
    for (int i = 0; i < 10; ++i) {
        w.errors.clear();
        w.step();
        EXPECT_EQ(w->contact_count(), 5u);
        EXPECT_EQ(w->report().dropped_contacts, 3u) << "in step " << i;
        EXPECT_EQ(w.errors, std::vector<Error>{Error::contacts_full}) << "once a step";
        EXPECT_EQ(w->validate(), nullptr);
    }
    int standing = 0;
    for (const BodyId id : w.all) standing += w->position(id).y > 0.49f ? 1 : 0;
    EXPECT_EQ(standing, 5);
}

TEST(Capacity, NothingThatExistedBeforeIsLost) {
    Row w(4, 4);
    w.step(10);
    const std::vector<ContactInfo> before = w.contacts();
    ASSERT_EQ(before.size(), 4u);
    for (int i = 0; i < 4; ++i) w.add_box({-20.0f - 2.0f * static_cast<float>(i), 0.5f});
    for (int i = 0; i < 20; ++i) {
        w.step();
        const std::vector<ContactInfo> now = w.contacts();
        ASSERT_EQ(now.size(), 4u);
        for (std::size_t k = 0; k < 4; ++k) EXPECT_TRUE(now[k].shape_a == before[k].shape_a && now[k].shape_b == before[k].shape_b);
    }
    for (const BodyId id : w.all) EXPECT_NEAR(w->position(id).y, 0.5f, 0.01f);
}

TEST(Capacity, DroppedContactsAreMadeWhenRoomComes) {
    Row w(5, 8);
    w.step(2);
    ASSERT_EQ(w->report().dropped_contacts, 3u);
    // Room by destroying bodies that stand.
    int freed = 0;
    for (const BodyId id : w.all) {
        if (w->position(id).y < 0.4999f || freed == 3) continue;
        w->destroy_body(id);
        ++freed;
    }
    w.step();
    EXPECT_EQ(w->report().dropped_contacts, 0u);
    EXPECT_EQ(w->contact_count(), 5u);
    w.errors.clear();
    w.step(60);
    EXPECT_TRUE(w.errors.empty());
    int standing = 0;
    for (const BodyId id : w.bodies()) standing += w->position(id).y > 0.49f ? 1 : 0;
    EXPECT_EQ(standing, 5);
}

// Two pairs of discs that overlap, and room for one contact: the other is dropped in every step.
struct TwoPairs : TestWorld {
    TwoPairs() : TestWorld({.bodies = 8, .shapes = 8, .contacts = 1}, floating()) {
        for (int i = 0; i < 4; ++i) discs[i] = add_circle({i % 2 == 0 ? 0 : 0.95f, i < 2 ? 0.0f : 50.0f});
        step(2);
    }
    static WorldDef floating() {
        WorldDef def;
        def.gravity = {0, 0};
        def.solver.contact_push_speed = 0;  // what overlaps stays where it is
        return def;
    }
    BodyId discs[4];
};

TEST(Capacity, ADroppedContactTakesThePlaceOfOneWhoseBodiesFlyApart) {
    for (const float speed : {2.0f, 20.0f}) {
        SCOPED_TRACE(speed);
        TwoPairs w;
        ASSERT_EQ(w->report().dropped_contacts, 1u);
        ASSERT_EQ(w->contact_count(), 1u);
        const bool first_has_it = w.contacts().at(0).shape_a == w.shape_of(w.discs[0]);
        const int leaver = first_has_it ? 0 : 2;
        w->set_linear_velocity(w.discs[leaver + 1], {speed, 0});
        w.step(60);
        ASSERT_EQ(w->contact_count(), 1u);
        EXPECT_EQ(w->report().dropped_contacts, 0u) << "a contact is kept though its bodies are far apart";
        const std::vector<ContactInfo> contacts = w.contacts();
        ASSERT_EQ(contacts.size(), 1u);
        EXPECT_EQ(contacts[0].shape_a, w.shape_of(w.discs[2 - leaver]));
        EXPECT_EQ(w->validate(), nullptr);
    }
}

TEST(Capacity, NoContactIsLeftWhenAllBodiesFlyApartWhileOneIsMissing) {
    TwoPairs w;
    w->set_linear_velocity(w.discs[1], {20, 0});
    w->set_linear_velocity(w.discs[3], {20, 0});
    w.step(60);
    EXPECT_EQ(w->contact_count(), 0u);
    EXPECT_EQ(w->report().dropped_contacts, 0u);
    EXPECT_EQ(w->validate(), nullptr);
}

TEST(Capacity, ABoxLandsInThePlaceOfOneThatLeft) {
    TestWorld w({.bodies = 8, .shapes = 8, .contacts = 2});
    w.add_ground();
    const BodyId leaver = w.add_box({0, 0.5f});
    w.add_box({3, 0.5f});
    w.step(5);
    ASSERT_EQ(w->contact_count(), 2u);
    const BodyId arriving = w.add_box({6, 5});
    w->set_linear_velocity(leaver, {0, 30});  // back after 6 s
    w.step(100);
    EXPECT_NEAR(w->position(arriving).y, 0.5f, 0.01f);
    EXPECT_EQ(w->report().dropped_contacts, 0u);
    w.step(300);
    EXPECT_GT(w->report().dropped_contacts, 0u) << "no room for a third";
    EXPECT_LT(w->position(leaver).y, 0.3f) << "nothing pushes it out of the ground";
    EXPECT_GT(w->position(leaver).y, -0.01f) << "but it came too fast to be let through";
    EXPECT_NEAR(w->position(arriving).y, 0.5f, 0.01f);
}

TEST(Capacity, TheSameContactsAreDroppedInEveryRun) {
    const auto run = [](std::uint32_t lanes) {
        WorldDef def;
        def.lanes = lanes;
        TestWorld w({.bodies = 128, .shapes = 128, .contacts = 60}, def);
        w.add_ground();
        for (int i = 0; i < 100; ++i) w.add_box({0.9f * static_cast<float>(i % 10), 0.5f + 1.01f * static_cast<float>(i / 10)});
        std::vector<std::uint64_t> history;
        for (int i = 0; i < 60; ++i) {
            w.step();
            EXPECT_GT(w->report().dropped_contacts, 0u);
            EXPECT_GE(w->contact_count(), 50u) << "room is used as soon as it comes";
            const char* broken = w->validate();
            EXPECT_EQ(broken, nullptr) << broken;
            history.push_back(w->hash());
            history.push_back(w->report().dropped_contacts);
        }
        EXPECT_TRUE(w.is_finite());
        return history;
    };
    const auto first = run(0);
    EXPECT_EQ(first, run(0));
    EXPECT_EQ(first, run(1));
}

// Of a contact that ended nothing is left but its event, so what waits to be told and what may end yet are never more than the contacts that fit.
TEST(Capacity, NoEndEventIsLost) {
    Row w(4, 4);
    w.step(5);
    // Each round the four contacts end by a call, and are made again: the events of one step and of the calls after it share the room.
    for (const BodyId id : w.all) w->set_transform(id, w->position(id), 0);
    EXPECT_EQ(w->end_touch_events().size(), 4u);
    EXPECT_TRUE(w.errors.empty());
    w.step();
    EXPECT_EQ(w->end_touch_events().size(), 4u) << "events of calls stay for the reader of the next step";
    // A copy does not have what was told already: it must make no difference.
    std::vector<std::byte> image(w->snapshot_bytes());
    ASSERT_EQ(w->save(image), image.size());
    Row copy(4, 4);
    ASSERT_TRUE(copy->load(image));
    for (const BodyId id : w.all) {
        w->destroy_body(id);
        copy->destroy_body(id);
        EXPECT_EQ(w->hash(), copy->hash());
    }
    EXPECT_EQ(w->end_touch_events().size(), 4u) << "those of the step give way";
    EXPECT_TRUE(w.errors.empty());
    EXPECT_EQ(w->report().dropped_events, 0u);
    EXPECT_EQ(w->validate(), nullptr);
    w.step();
    EXPECT_EQ(w->end_touch_events().size(), 4u);
    EXPECT_EQ(w->body_count(), 1u);
}

// -- the block -------------------------------------------------------------------------------------------------------------------------

TEST(Capacity, TheSmallestWorldWorks) {
    TestWorld w({.bodies = 1, .shapes = 1, .contacts = 1});
    const BodyId ball = w.add_circle({0, 0});
    w.step(60);
    EXPECT_NEAR(w->position(ball).y, -5.0f, 0.2f);
    EXPECT_EQ(w->validate(), nullptr);
}

TEST(Capacity, ABlockThatIsTooSmallOrMisalignedOrACapacityThatIsBadIsRefused) {
    constexpr Capacity good{.bodies = 3, .shapes = 3, .contacts = 3};
    constexpr std::size_t bytes = world_bytes(good);
    const Block block(bytes + 128);
    Error error = Error::none;
    EXPECT_NE(World::create(block.span().first(bytes), good, {}, &error), nullptr);
    EXPECT_EQ(error, Error::none);
    EXPECT_EQ(World::create(block.span().first(bytes - 1), good, {}, &error), nullptr);
    EXPECT_EQ(error, Error::block_too_small);
    EXPECT_EQ(World::create({}, good, {}, &error), nullptr);
    EXPECT_EQ(error, Error::block_too_small);
    for (const std::size_t shift : {1u, 4u, 8u, 16u, 32u, 63u}) {
        EXPECT_EQ(World::create(block.span().subspan(shift), good, {}, &error), nullptr);
        EXPECT_EQ(error, Error::block_misaligned) << shift;
    }
    for (std::uint32_t Capacity::*member : {&Capacity::bodies, &Capacity::shapes, &Capacity::contacts}) {
        Capacity bad = good;
        bad.*member = 0;
        EXPECT_EQ(World::create(block.span(), bad, {}, &error), nullptr);
        EXPECT_EQ(error, Error::bad_capacity);
    }
    for (std::uint32_t Capacity::*member :
         {&Capacity::bodies, &Capacity::shapes, &Capacity::contacts, &Capacity::joints, &Capacity::geometries}) {
        Capacity bad = good;
        bad.*member = max_capacity + 1;
        EXPECT_EQ(World::create(block.span(), bad, {}, &error), nullptr);
        EXPECT_EQ(error, Error::bad_capacity);
        bad.*member = 0xffffffffu;
        EXPECT_EQ(World::create(block.span(), bad, {}, &error), nullptr);
        EXPECT_EQ(error, Error::bad_capacity);
    }
}

TEST(Capacity, NothingIsWrittenBeyondTheBlock) {
    constexpr Capacity capacity{.bodies = 40, .shapes = 40, .contacts = 90};
    constexpr std::size_t bytes = world_bytes(capacity);
    const Block block(bytes + 256);
    const std::span<std::byte> guard = block.span().subspan(bytes);
    for (std::byte& b : guard) b = std::byte{0x77};
    World* world = World::create(block.span().first(bytes), capacity, {});
    ASSERT_NE(world, nullptr);
    world->create_shape(world->create_body({}), make_box(100, 1));
    BodyDef def;
    def.type = BodyType::dynamic;
    while (world->body_count() < capacity.bodies) {
        def.position = {0.3f * static_cast<float>(world->body_count() % 6), 1.5f + 0.4f * static_cast<float>(world->body_count())};
        world->create_shape(world->create_body(def), make_box(0.3f, 0.3f));
    }
    for (int i = 0; i < 200; ++i) world->step(1.0f / 60);
    for (const std::byte b : guard) ASSERT_EQ(b, std::byte{0x77});
}

// -- what it costs ------------------------------------------------------------------------------------------------------------------

// All bodies at one place make pairs by the square of their number. Once there is no room the search for more goes on only as far as it counts.
TEST(Capacity, FullContactsCostNoMoreThanTheirNumber) {
    for (const bool asleep : {false, true}) {
        SCOPED_TRACE(asleep);
        constexpr std::uint32_t room = 500;
        std::uint32_t asked = 0;
        WorldDef def;
        def.gravity = {0, 0};
        def.solver.contact_push_speed = 0;
        def.hooks.filter = [](ShapeId, ShapeId, void* context) {
            ++*static_cast<std::uint32_t*>(context);
            return true;
        };
        def.hooks.context = &asked;
        TestWorld w({.bodies = 1000, .shapes = 1000, .contacts = room}, def);
        for (int i = 0; i < 1000; ++i) {
            BodyDef body;
            body.type = BodyType::dynamic;
            body.awake = !asleep || i < 500;
            w.add(Circle{{0, 0}, 0.5f}, body);
        }
        for (int i = 0; i < 5; ++i) {
            asked = 0;
            w.step();
            EXPECT_EQ(w->contact_count(), room);
            EXPECT_EQ(w->report().dropped_contacts, room) << "counted as far as the capacity";
            EXPECT_LE(asked, 2 * room) << "499 500 pairs are not looked at";
            EXPECT_EQ(w->validate(), nullptr);
        }
    }
}

TEST(Capacity, FastBodiesLookAheadNoFurtherThanTheirDroppedContactsAreCounted) {
    std::uint32_t asked = 0;
    WorldDef def;
    def.gravity = {0, 0};
    def.hooks.filter = [](ShapeId, ShapeId, void* context) {
        ++*static_cast<std::uint32_t*>(context);
        return true;
    };
    def.hooks.context = &asked;
    TestWorld w({.bodies = 300, .shapes = 300, .contacts = 10}, def);
    for (int i = 0; i < 100; ++i) w.add(make_box(0.1f, 1), {.position = {3 + 0.01f * static_cast<float>(i), 0}});
    for (int i = 0; i < 100; ++i) w.add(Circle{{0, 0}, 0.1f}, {.type = BodyType::dynamic, .position = {0.3f * static_cast<float>(i % 5), 0.25f * static_cast<float>(i / 5 % 4)}, .linear_velocity = {390, 0}});
    w.step();
    EXPECT_EQ(w->contact_count(), 10u);
    EXPECT_EQ(w->report().dropped_contacts, 10u);
    EXPECT_LE(asked, 20u);
}

TEST(Capacity, WhatIsDroppedDoesNotDependOnLanes) {
    const auto run = [](std::uint32_t lanes) {
        WorldDef def;
        def.lanes = lanes;
        def.gravity = {0, 0};
        TestWorld w({.bodies = 400, .shapes = 400, .contacts = 150}, def);
        for (int i = 0; i < 400; ++i) w.add_box({0.1f * static_cast<float>(i % 7), 0.3f * static_cast<float>(i % 31)});
        std::vector<std::uint64_t> history;
        for (int i = 0; i < 60; ++i) {
            w.step();
            history.push_back(w->hash());
            history.push_back(w->report().dropped_contacts);
        }
        return history;
    };
    const auto first = run(1);
    EXPECT_EQ(run(4), first);
    EXPECT_EQ(run(8), first);
}

}  // namespace
