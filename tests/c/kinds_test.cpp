// For each kind of thing that a game does, a program in C (kinds.c) and the same in C++ come to one checksum of all that they were told.
#include "kinds.h"

#include <gtest/gtest.h>
#include <islet/islet.hpp>
#include <islet/lcp.hpp>

#include <cstring>

namespace {

using namespace islet;

StaticWorld<Capacity{.bodies = 1000, .shapes = 1000, .contacts = 6000}> storage;
std::uint64_t sum;

void note(std::uint64_t word) { sum = with_word(sum, word); }
void note(float value) {
    std::uint32_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    note(std::uint64_t{bits});
}
void note(Vec2 v) {
    note(v.x);
    note(v.y);
}
void note(span<const std::byte> bytes) {
    for (const std::byte byte : bytes) note(static_cast<std::uint64_t>(byte));
}
template <class T>
void note_number(T value) {
    note(static_cast<std::uint64_t>(value));
}

void step(World& world, int count) {
    for (int i = 0; i < count; ++i) world.step(1.0f / 60);
}

World& pyramid(int rows) {
    sum = 14695981039346656037u;
    World& world = storage.create();
    const Polygon box = make_box(0.5f, 0.5f);
    world.create_shape(world.create_body({}), make_box(60, 1));
    for (int row = 0; row < rows; ++row)
        for (int i = 0; i < rows - row; ++i)
            world.create_shape(world.create_body({.type = BodyType::dynamic, .position = {float(i) + 0.5f * float(row), 1.5f + float(row)}}), box);
    world.create_shape(world.create_body({.type = BodyType::dynamic, .position = {-8, 3}, .linear_velocity = {12, 0}}), Circle{}, {.hit_events = true});
    return world;
}

TEST(Kinds, StacksAreTheSameInC) {
    World& world = pyramid(5);
    for (int i = 0; i < 90; ++i) {
        world.step(1.0f / 60);
        note(world.hash());
    }
    EXPECT_EQ(stack_of_c(), sum);
}

TEST(Kinds, EventsAreTheSameInC) {
    World& world = pyramid(5);
    std::size_t hits = 0;
    for (int i = 0; i < 120; ++i) {
        world.step(1.0f / 60);
        for (const TouchEvent& e : world.begin_touch_events()) note_number(e.shape_a.index1 * 1000 + e.shape_b.index1);
        for (const TouchEvent& e : world.end_touch_events()) note_number(e.shape_a.index1 * 1000 + e.shape_b.index1);
        for (const HitEvent& e : world.hit_events()) {
            note(e.point);
            note(e.speed);
            ++hits;
        }
    }
    EXPECT_GT(hits, 0u);
    EXPECT_EQ(events_of_c(), sum);
}

TEST(Kinds, QueriesAreTheSameInC) {
    World& world = pyramid(5);
    for (int i = 0; i < 60; ++i) {
        world.step(1.0f / 60);
        const Vec2 near = {0.1f * float(i), 4};
        const QueryHit hit = world.cast_ray({-10, 0.1f * float(i)}, {20, 0});
        note_number(hit.shape.index1);
        note(hit.point);
        note(hit.normal);
        note(hit.fraction);
        const ClosestHit closest = world.closest(near, 3);
        note_number(closest.shape.index1);
        note(closest.distance);
        ShapeId found[8];
        const std::uint32_t count = world.overlap_shape(make_proxy(Circle{near, 1}), found);
        note_number(count);
        for (std::uint32_t k = 0; k < count && k < 8; ++k) note_number(found[k].index1);
    }
    EXPECT_EQ(queries_of_c(), sum);
}

TEST(Kinds, MoversAreTheSameInC) {
    World& world = pyramid(5);
    MoverState hero;
    hero.position = {-3, 2};
    for (int i = 0; i < 120; ++i) {
        world.step(1.0f / 60);
        note_number(step_mover(world, {}, hero, {.walk = 4, .jump = i % 40 == 39 ? 5.0f : 0.0f}, 1.0f / 60));
        note(hero.position);
        note(hero.velocity);
        note_number(hero.ground.index1);
    }
    EXPECT_EQ(mover_of_c(), sum);
}

TEST(Kinds, SnapshotsAndDeltasAreTheSameInC) {
    alignas(8) static std::byte before[1 << 16], after[1 << 16], packed[1 << 16], back[1 << 16];
    World& world = pyramid(5);
    step(world, 30);
    const std::size_t first = world.save(before);
    step(world, 30);
    const std::size_t second = world.save(after);
    const std::uint64_t reached = world.hash();
    const std::size_t bytes = delta({before, first}, {after, second}, packed);
    EXPECT_GT(bytes, 0u);
    note_number(first);
    note_number(second);
    note_number(bytes);
    note({packed, bytes});
    note_number(world.restore({before, first}));
    note(world.hash());
    note_number(apply({before, first}, {packed, bytes}, back));
    note_number(world.restore({back, second}));
    EXPECT_EQ(world.hash(), reached);
    note_number(world.hash() == reached);
    EXPECT_EQ(snapshots_of_c(), sum);
}

TEST(Kinds, RecordingsAreTheSameInC) {
    alignas(8) static std::byte tape[1 << 17];
    World& world = pyramid(5);
    note_number(world.start_recording(tape));
    for (int i = 0; i < 60; ++i) {
        world.set_gravity({0.1f * float(i % 5), -10});
        world.step(1.0f / 60);
    }
    const std::size_t bytes = world.stop_recording();
    note_number(bytes);
    note({tape, bytes});
    const ReplayResult result = replay(world, {tape, bytes});
    EXPECT_EQ(result.end, ReplayEnd::complete);
    note_number(result.end);
    note(result.steps);
    note(world.hash());
    EXPECT_EQ(recording_of_c(), sum);
}

TEST(Kinds, TasksAreTheSameInC) {
    World& world = pyramid(40);
    TaskSystem tasks;
    tasks.parallel_for = [](void*, std::uint32_t count, void (*task)(void*, std::uint32_t), void* data) {
        note_number(count);
        while (count > 0) task(data, --count);
    };
    tasks.workers = 3;
    world.set_tasks(tasks);
    note_number(world.last_error());
    const std::uint64_t before = sum;
    step(world, 10);
    EXPECT_NE(sum, before) << "no task was run";
    note(world.hash());
    EXPECT_EQ(tasks_of_c(), sum);
}

TEST(Kinds, DrawingsAreTheSameInC) {
    World& world = pyramid(5);
    DebugDraw draw;
    draw.polygon = [](span<const Vec2> corners, float radius, const DrawStyle& style, void*) {
        for (const Vec2 corner : corners) note(corner);
        note(radius);
        note_number(style.color);
    };
    draw.circle = [](Vec2 center, float radius, Vec2 axis, const DrawStyle& style, void*) {
        note(center);
        note(radius);
        note(axis);
        note_number(style.color);
    };
    draw.point = [](Vec2 point, const DrawStyle& style, void*) {
        note(point);
        note_number(style.part);
    };
    draw.contacts = true;
    step(world, 60);
    const std::uint64_t before = sum;
    world.draw(draw);
    EXPECT_NE(sum, before);
    EXPECT_EQ(drawing_of_c(), sum);
}

TEST(Kinds, MatricesAreTheSameInC) {
    const float m[] = {2, -1, 0, -1, 2, -1, 0, -1, 2}, q[] = {-1, 0.5f, -1};
    float x[3] = {};
    std::byte workspace[512];
    sum = 14695981039346656037u;
    lcp::Problem<float> problem;
    problem.dense.values = m;
    problem.q = q;
    note_number(lcp::solve(problem, {}, span<float>(x), span<std::byte>(workspace)).status);
    for (const float value : x) note(value);
    EXPECT_EQ(matrix_of_c(), sum);
}

}  // namespace
