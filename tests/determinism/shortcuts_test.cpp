// What spares a fast body a look at its surroundings, or a search for an impact, says what they would have said, as far out as worlds reach: a build without
// them (ISLET_WITHOUT=shortcuts) must give the same bits.
#include <gtest/gtest.h>

#include "bodies/bounds.hpp"
#include "broadphase/pairs.hpp"
#include "shapes/manifolds.hpp"
#include "step/clear_way.hpp"
#include "step/continuous.hpp"
#include "support/random.hpp"
#include "support/test_world.hpp"

namespace islet::test {
namespace {

constexpr float far_out[] = {0, 1e3f, 3e4f, 1e5f, 1e6f, 9e6f};  // m from the origin

// A slow rod falls, point first, on a wall about as far away as a body is taken to be alone, so fast that it has not looked so far ahead; with or without a
// thing around it that it passes through.
TEST(Shortcuts, WhoIsAloneMovesAsIfItWereNot) {
    Random random(2);
    std::uint32_t stopped = 0;
    for (int i = 0; i < 12'000; ++i) {
        const float out = far_out[i % 6], radius = random.between(0.05f, 2);
        const Rot q = make_rot(random.one_in(2) ? 0 : random.between(-pi, pi));
        const Vec2 center{out, random.between(-out, out)}, ahead = rotate(q, {1, 0});
        const float way = radius * random.between(3.7f, 4.05f) - 1e-7f * random.between(-2, 2) * out;
        const float gap = radius * random.between(4.6f, 5.1f) + 1e-7f * random.between(-4, 4) * out;
        const auto thrown = [&](bool alone) {
            WorldDef def;
            def.gravity = 60 * 60 / 0.625f * way * ahead;  // which it falls in four substeps
            def.max_speed = 1e4f;
            TestWorld w({.bodies = 3, .shapes = 3, .contacts = 2}, def);
            BodyDef rod;
            rod.type = BodyType::dynamic;
            rod.position = center;
            rod.linear_velocity = 0.01f * ahead;
            const BodyId body = w.add(Segment{radius * ahead, -radius * ahead}, rod);
            w.add(make_offset_box(0.01f, 3 * radius, {{}, q}), center + gap * ahead, {}, BodyType::static_body);
            ShapeDef unseen;
            unseen.filter = {.category = 0, .mask = 0};
            if (!alone) w.add_circle(center, 10 * radius, unseen, BodyType::static_body);
            w.step();
            return w->center_of_mass(body);
        };
        const Vec2 end = thrown(true);
        ASSERT_EQ(end, thrown(false)) << "trial " << i << ", " << out << " m out";
        if (distance(end, center) < 0.99f * way) ++stopped;
    }
    EXPECT_GT(stopped, 1000u);
}

// A ring of points, some of them close together, so that faces are long and short.
Polygon some_polygon(Random& random, float size) {
    Vec2 points[max_polygon_vertices];
    const std::uint32_t count = 3 + random.below(max_polygon_vertices - 2);
    const Vec2 middle = size * Vec2{random.between(-1, 1), random.between(-1, 1)};
    float angle = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        angle += random.between(0.1f, 1) * 6.0f / static_cast<float>(count);
        points[i] = middle + rotate(make_rot(angle), {size, 0});
    }
    return make_polygon(compute_hull({points, count}), random.one_in(2) ? 0 : size * random.between(0, 0.5f));
}

void add_thing(Random& random, World& world, BodyId body, float size) {
    const auto near = [&] { return size * Vec2{random.between(-1, 1), random.between(-1, 1)}; };
    switch (random.below(5)) {
        case 0: world.create_shape(body, Circle{near(), size * random.between(0.1f, 1)}); break;
        case 1: world.create_shape(body, Capsule{near(), near() + Vec2{size, 0}, size * random.between(0.1f, 0.5f)}); break;
        case 2: world.create_shape(body, some_polygon(random, size)); break;
        case 3: world.create_shape(body, Segment{near(), near() + Vec2{0, size}}); break;
        default: world.create_shape(body, make_box(size * random.between(0.1f, 1), size * random.between(0.1f, 1))); break;
    }
}

void add_wall(Random& random, World& world, BodyId body, float size) {
    const Vec2 end = {size * random.between(0.2f, 4), 0};
    const Vec2 points[] = {end + Vec2{size, 0}, end, -end, -end - Vec2{size, 0}};
    switch (random.below(4)) {
        case 0: world.create_shape(body, Segment{-end, end}); break;
        case 1: world.create_shape(body, Capsule{-end, end, size * random.between(0.1f, 0.5f)}); break;
        case 2: world.create_shape(body, some_polygon(random, 2 * size)); break;
        default: world.create_chain(body, points, false); break;
    }
}

TEST(Shortcuts, WhatKeepsClearOfAWallIsStoppedByItInNoSearch) {
    Random random(3);
    std::uint32_t clear = 0, free = 0, stopped = 0;
    for (int i = 0; i < 60'000; ++i) {
        const float out = far_out[i % 6], size = random.between(0.05f, 1);
        const Vec2 place{out, random.between(-out, out)};
        TestWorld w({.bodies = 2, .shapes = 4, .contacts = 2});
        BodyDef def;
        def.position = place;
        def.angle = random.one_in(3) ? 0 : random.between(-pi, pi);
        const BodyId wall = w->create_body(def);
        add_wall(random, *w, wall, size);
        def.type = BodyType::dynamic;
        def.position = place + rotate(make_rot(def.angle), {size * random.between(-3, 3), size * random.between(-3, 3)});
        const Rot along = make_rot(def.angle + random.between(-0.4f, 0.4f));
        def.angle = random.between(-pi, pi);
        const BodyId body = w->create_body(def);
        add_thing(random, *w, body, size);

        const detail::Core& core = detail::Core::of(*w);
        const std::uint32_t b = body.index1 - 1, of_wall = wall.index1 - 1;
        if (core.bodies[b].shape_head == detail::null_index || core.bodies[of_wall].shape_head == detail::null_index) continue;  // no hull
        const float turn = random.one_in(3) ? 0 : random.between(-1.5f, 1.5f) * (random.one_in(2) ? 1 : 0.1f);
        const detail::BodyPath way{core.poses[b].center, core.poses[b].q, rotate(along, {size * random.between(-3, 3) * (random.one_in(2) ? 1 : 0.1f), 0}),
                                   turn};
        const detail::ClearWay clear_way = detail::clear_way_of(way, core.poses[b].max_extent, core.bodies[b].min_extent, 0.125f * detail::linear_slop);
        const std::uint32_t shape = core.bodies[b].shape_head;
        for (std::uint32_t s = core.bodies[of_wall].shape_head; s != detail::null_index; s = core.shapes[s].next) {
            const bool keeps = detail::keeps_clear(clear_way, core.geometries[core.shapes[shape].geometry], core.bodies[b].local_center,
                                                   core.geometries[core.shapes[s].geometry], detail::body_transform(core, of_wall));
            const float end = detail::stop_time(core, shape, way, s, detail::at_rest(core, of_wall), 1);
            ASSERT_TRUE(!keeps || end == detail::no_impact) << "trial " << i << ", " << out << " m out, stopped at " << end;
            clear += keeps ? 1u : 0u;
            free += end == detail::no_impact ? 1u : 0u;
            stopped += end < 1 ? 1u : 0u;
        }
    }
    EXPECT_GT(clear, 10'000u);
    EXPECT_GT(free, clear);
    EXPECT_GT(stopped, 1000u);
}

// What stays_alone (broadphase/pairs.cpp) counts with.
TEST(Shortcuts, AFatBoxReachesNoFartherThanThreeExtentsAndItsMargins) {
    Random random(4);
    float most = 0;  // of what is allowed
    for (int trial = 0; trial < 60; ++trial) {
        const float out = far_out[trial % 5];
        TestWorld w({.bodies = 40, .shapes = 120, .contacts = 400});
        for (int i = 0; i < 40; ++i) {
            BodyDef def;
            def.type = BodyType::dynamic;
            def.position = {out + random.between(-20, 20), random.between(-20, 20)};
            def.angle = random.between(-pi, pi);
            def.linear_velocity = {random.between(-20, 20), random.between(-20, 20)};
            def.angular_velocity = random.between(-20, 20);
            const BodyId body = w->create_body(def);
            for (std::uint32_t n = 1 + random.below(3); n > 0; --n) add_thing(random, *w, body, random.between(0.05f, 1));
        }
        for (int step = 0; step < 40; ++step) {
            w.step();
            const detail::Core& core = detail::Core::of(*w);
            for (const BodyId id : w.bodies()) {
                const detail::Pose& pose = core.poses[id.index1 - 1];
                const float inexact = 1e-6f * (abs(pose.center.x) + abs(pose.center.y));
                const float allowed = 3 * pose.max_extent + 2 * (detail::max_box_margin + detail::speculative_distance) + inexact;
                for (std::uint32_t s = core.bodies[id.index1 - 1].shape_head; s != detail::null_index; s = core.shapes[s].next) {
                    const Vec2 lower = pose.center - core.boxes[s].lower, upper = core.boxes[s].upper - pose.center;
                    const float reach = max(max(lower.x, lower.y), max(upper.x, upper.y));
                    ASSERT_LE(reach, allowed) << "trial " << trial << ", step " << step;
                    most = max(most, reach / allowed);
                }
            }
        }
    }
    EXPECT_GT(most, 0.4f);
}

}  // namespace
}  // namespace islet::test
