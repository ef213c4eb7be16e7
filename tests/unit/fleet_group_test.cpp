// Fleets solve small worlds side by side, their contacts in shared lanes. Each world must still come to the bits of a world by itself, whatever the others of
// its group hold.
#include <gtest/gtest.h>

#include <iterator>
#include <memory>
#include <vector>

#include "islet/fleet.hpp"
#include "islet/recording.hpp"
#include "islet/snapshot.hpp"
#include "support/random.hpp"
#include "support/task_threads.hpp"
#include "support/test_world.hpp"

namespace {

using namespace islet;
using namespace islet::test;

constexpr float frame = 1.0f / 60;
constexpr Capacity capacity{.bodies = 64, .shapes = 64, .contacts = 384, .joints = 16, .geometries = 16};

BodyId add(World& world, Vec2 at, float radius, const ShapeDef& shape, BodyType type = BodyType::dynamic) {
    BodyDef def;
    def.type = type;
    def.position = at;
    const BodyId body = world.create_body(def);
    radius < 0 ? world.create_shape(body, make_box(-radius, -radius), shape) : world.create_shape(body, Circle{{0, 0}, radius}, shape);
    return body;
}

void add_floor(World& world) { world.create_shape(world.create_body({}), make_offset_box(50, 1, {{0, -1}, {}}), {}); }

// What a world can hold, each kind by itself so that a group has them side by side.
using Content = void (*)(World&, Random&);

void nothing(World&, Random&) {}

void pyramid(World& world, Random& random) {
    add_floor(world);
    const auto rows = 2 + random.below(4);
    for (std::uint32_t row = 0; row < rows; ++row)
        for (std::uint32_t i = row; i < rows; ++i)
            add(world, {static_cast<float>(i) - 0.5f * static_cast<float>(row), 0.5f + static_cast<float>(row)}, -0.5f, {});
}

void rain(World& world, Random& random) {
    add_floor(world);
    for (int i = 0; i < 20; ++i) add(world, {random.between(-3, 3), random.between(1, 6)}, random.between(-0.4f, 0.4f) < 0 ? -0.3f : 0.3f, {});
}

void bouncing_and_rolling(World& world, Random& random) {
    add_floor(world);
    for (int i = 0; i < 12; ++i) {
        ShapeDef shape;
        shape.restitution = random.one_in(2) ? random.between(0.2f, 0.9f) : 0.0f;
        shape.rolling_resistance = random.one_in(2) ? 0.1f : 0.0f;
        shape.tangent_speed = random.one_in(3) ? 1.0f : 0.0f;
        add(world, {random.between(-3, 3), random.between(1, 6)}, random.one_in(2) ? 0.3f : -0.3f, shape);
    }
}

/// More contacts on one body than there are colours.
void crowded_plate(World& world, Random&) {
    add_floor(world);
    BodyDef def;
    def.type = BodyType::dynamic;
    def.position = {0, 0.5f};
    world.create_shape(world.create_body(def), make_box(6, 0.5f), {});
    for (int i = 0; i < 30; ++i) add(world, {-5.8f + 0.4f * static_cast<float>(i), 1.2f}, 0.19f, {});
}

void joined(World& world, Random& random) {
    add_floor(world);
    BodyId last = add(world, {0, 5}, 0.1f, {}, BodyType::static_body);
    for (int i = 1; i < 8; ++i) {
        const BodyId next = add(world, {0.5f * static_cast<float>(i), 5}, i == 7 && random.one_in(2) ? 0.6f : 0.15f, {});
        RevoluteJointDef hinge;
        hinge.base = {.body_a = last, .body_b = next, .frame_a = {{0.25f, 0}, {}}, .frame_b = {{-0.25f, 0}, {}}};
        if (i == 3) hinge.motor = {.enable = true, .speed = 3, .max_force = 5};
        if (i != 1 || random.one_in(2)) world.create_joint(hinge);
        last = next;
    }
    rain(world, random);
}

/// Columns of bodies in two halves, each of which touches the next in several contacts.
void in_pieces(World& world, Random& random) {
    add_floor(world);
    for (int i = 0; i < 6; ++i) {
        const BodyId body = world.create_body({.type = BodyType::dynamic, .position = {random.between(-0.01f, 0.01f), 0.5f + static_cast<float>(i)}});
        for (const float x : {-0.25f, 0.25f}) world.create_shape(body, make_offset_box(0.25f, 0.5f, {{x, 0}, {}}), {});
    }
}

/// Welds between falling boxes, some of which break as they land.
void breaking(World& world, Random& random) {
    add_floor(world);
    for (int i = 0; i < 6; ++i) {
        const Vec2 at = {2.0f * static_cast<float>(i), random.between(1, 3)};
        WeldJointDef weld;
        weld.base = {.body_a = add(world, at, -0.3f, {}), .body_b = add(world, at + Vec2{0.6f, 0}, -0.3f, {}), .frame_a = {{0.3f, 0}, {}}};
        weld.base.frame_b = {{-0.3f, 0}, {}};
        weld.base.break_force = random.between(1, 200);
        world.create_joint(weld);
    }
}

void guided(World& world, Random& random) {
    rain(world, random);
    const BodyId mover = add(world, {-4, 0.5f}, -0.5f, {}, BodyType::kinematic);
    world.set_linear_velocity(mover, {1, 0});
    world.lock_x(add(world, {5, 1}, -0.5f, {}), true);
}

void with_hit_events(World& world, Random& random) {
    add_floor(world);
    ShapeDef shape;
    shape.hit_events = true;
    for (int i = 0; i < 8; ++i) add(world, {random.between(-3, 3), random.between(2, 6)}, -0.3f, shape);
}

void of_other_numbers(World& world, Random& random) {
    SolverDef solver;
    solver.substeps = 2 + random.below(3);
    solver.iterations = 1 + random.below(2);
    solver.shock = random.one_in(3) ? 0.5f : 0.0f;
    solver.tolerance = random.one_in(3) ? 0.001f : 0.0f;
    solver.sweep_order = random.one_in(3) ? SweepOrder::as_found : SweepOrder::colored;
    world.set_solver(solver);
    pyramid(world, random);
}

void of_other_limits(World& world, Random& random) {
    random.one_in(2) ? world.set_max_speed(3) : world.set_restitution_threshold(0.1f);
    world.set_gravity({1, -10});
    bouncing_and_rolling(world, random);
}

void of_other_gravity(World& world, Random& random) {
    world.set_gravity({random.between(-3, 3), -10});
    rain(world, random);
}

constexpr Content contents[] = {nothing,         pyramid,         rain, bouncing_and_rolling, crowded_plate, joined, guided, with_hit_events, of_other_numbers,
                                of_other_limits, of_other_gravity, in_pieces, breaking};

/// A fleet, and as many worlds by themselves to which the same is done.
struct Twins {
    Block block;
    Fleet* fleet;
    std::vector<std::unique_ptr<TestWorld>> alone;
    std::vector<std::byte> image = std::vector<std::byte>(max_snapshot_bytes(capacity));

    Twins(std::uint32_t worlds, std::uint32_t lanes, const TaskSystem& tasks) : block(Fleet::bytes(worlds, capacity, tasks.workers)) {
        const Block of_prototype(world_bytes(capacity));
        fleet = Fleet::create(block.span(), *World::create(of_prototype.span(), capacity, {.lanes = lanes}), worlds, tasks);
        for (std::uint32_t k = 0; k < worlds; ++k) alone.push_back(std::make_unique<TestWorld>(capacity, WorldDef{.lanes = lanes}));
    }
    World& of_fleet(std::uint32_t k) const { return (*fleet)[k]; }
    World& by_itself(std::uint32_t k) const { return **alone[k]; }
    void fill(std::uint32_t k, Content content, std::uint64_t seed) const {
        for (World* world : {&of_fleet(k), &by_itself(k)}) {
            Random random(seed);
            content(*world, random);
        }
    }
    void step(std::span<const std::uint8_t> mask, std::uint32_t repeat) const {
        ASSERT_EQ(fleet->step({.dt = frame, .repeat = repeat, .mask = mask}), Error::none);
        for (std::uint32_t k = 0; k < fleet->size(); ++k)
            for (std::uint32_t i = 0; (mask.empty() || mask[k] != 0) && i < repeat; ++i) by_itself(k).step(frame);
    }
    void copy(std::uint32_t from, std::uint32_t to) {
        ASSERT_EQ(fleet->copy(from, to), Error::none);
        ASSERT_TRUE(by_itself(to).restore(std::span<const std::byte>(image).first(by_itself(from).save(image))));
    }
    void reset(std::uint32_t k, std::uint32_t from) {
        const std::size_t bytes = by_itself(from).save(image);
        ASSERT_EQ(fleet->reset(k, std::span<const std::byte>(image).first(bytes)), Error::none);
        ASSERT_TRUE(by_itself(k).restore(std::span<const std::byte>(image).first(bytes)));
    }
    void expect_equal(const char* when) const {
        for (std::uint32_t k = 0; k < fleet->size(); ++k) {
            const World& a = of_fleet(k);
            const World& b = by_itself(k);
            ASSERT_EQ(a.hash(), b.hash()) << when << ", world " << k;
            const StepReport& ra = a.report();
            const StepReport& rb = b.report();
            ASSERT_EQ(ra.sweeps, rb.sweeps) << when << ", world " << k;
            ASSERT_EQ(ra.touching_contacts, rb.touching_contacts) << when << ", world " << k;
            ASSERT_EQ(ra.overflow_contacts, rb.overflow_contacts) << when << ", world " << k;
            ASSERT_EQ(a.begin_touch_events().size(), b.begin_touch_events().size()) << when << ", world " << k;
            ASSERT_EQ(a.hit_events().size(), b.hit_events().size()) << when << ", world " << k;
            ASSERT_EQ(a.broken_joints().size(), b.broken_joints().size()) << when << ", world " << k;
        }
    }
};

/// The numbers of lanes that this build and processor have.
std::vector<std::uint32_t> lanes_to_try() {
    std::vector<std::uint32_t> found;
    for (const std::uint32_t lanes : {1u, 4u, 8u, 16u})
        if (const TestWorld world(capacity, {.lanes = lanes}); world->lanes() == lanes) found.push_back(lanes);
    return found;
}

TEST(FleetGroups, WorldsOfAnyContentComeToTheBitsOfEachAlone) {
    constexpr std::uint32_t worlds = 27;
    std::uint32_t overflows = 0, hits = 0;
    std::vector<std::uint64_t> ends;  // hashes, with the first number of lanes and workers
    for (const std::uint32_t lanes : lanes_to_try()) {
        for (const std::uint32_t workers : {1u, 3u}) {
            Twins twins(worlds, lanes, threads(workers));
            Random random(1);
            for (std::uint32_t k = 0; k < worlds; ++k) twins.fill(k, contents[random.below(std::size(contents))], k);
            for (std::uint32_t k = 0; k < std::size(contents); ++k) twins.fill(worlds - 1 - k, contents[k], k);  // some on top of others
            for (int round = 0; round < 60; ++round) {
                std::vector<std::uint8_t> mask(worlds, 1);
                if (round % 2 != 0)
                    for (std::uint8_t& one : mask) one = random.one_in(3) ? 0 : 1;
                twins.step(mask, 1 + random.below(3));
                twins.expect_equal("after a step");
                for (std::uint32_t k = 0; k < worlds; ++k) {
                    overflows += twins.of_fleet(k).report().overflow_contacts;
                    hits += static_cast<std::uint32_t>(twins.of_fleet(k).hit_events().size());
                }
                if (round == 20) twins.copy(3, 12);
                if (round == 30) twins.reset(5, 13);
                if (round % 7 == 0) twins.fill(random.below(worlds), rain, static_cast<std::uint64_t>(round));
                if (HasFatalFailure()) return;
            }
            const bool is_first = ends.empty();
            for (std::uint32_t k = 0; k < worlds; ++k) {
                if (is_first) ends.push_back(twins.of_fleet(k).hash());
                EXPECT_EQ(twins.of_fleet(k).hash(), ends[k]) << "world " << k << ", " << lanes << " lanes, " << workers << " workers";
            }
        }
    }
    EXPECT_GT(overflows, 0u) << "no contact was without a colour";
    EXPECT_GT(hits, 0u);
}

TEST(FleetGroups, AWorldThatIsRecordedStepsByItself) {
    Twins twins(8, 0, {});
    for (std::uint32_t k = 0; k < 8; ++k) twins.fill(k, pyramid, k);
    std::vector<std::byte> recording(1 << 20);
    ASSERT_TRUE(twins.of_fleet(5).start_recording(recording));
    for (int i = 0; i < 30; ++i) twins.step({}, 2);
    twins.expect_equal("after a recording");
    EXPECT_EQ(twins.of_fleet(5).report().sweeps, twins.of_fleet(4).report().sweeps);
    EXPECT_GT(twins.of_fleet(5).stop_recording(), 60u);
}

// Worlds that a mask leaves out stay as they are to the last byte, though the others of their group step.
TEST(FleetGroups, WhatDoesNotStepIsNotTouched) {
    Twins twins(8, 0, {});
    for (std::uint32_t k = 0; k < 8; ++k) twins.fill(k, rain, k);
    const std::uint8_t mask[] = {1, 0, 1, 1, 0, 1, 1, 1};
    const std::uint64_t before = twins.of_fleet(1).hash();
    for (int i = 0; i < 60; ++i) twins.step(mask, 1);
    EXPECT_EQ(twins.of_fleet(1).hash(), before);
    twins.expect_equal("with a mask");
}

}  // namespace
