// Landing: what comes fast stops at the surface it meets. The floor's top is at y = 0 in the floor's frame, and how deep something sinks is how far
// its lowest corner is below it after any step. Allowed is one linear slop, 5 mm: what cannot be seen.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "measure.hpp"
#include "support/random.hpp"

namespace islet::test {
namespace {

constexpr float allowed_depth = 0.005f;  // m

struct Thing {
    const char* name;
    std::vector<std::vector<Vec2>> parts;  // one point: a circle; two: a capsule; more: a polygon
    float radius = 0;
};

std::vector<Vec2> rectangle(float x, float y, Vec2 at = {}) { return {at + Vec2{-x, -y}, at + Vec2{x, -y}, at + Vec2{x, y}, at + Vec2{-x, y}}; }

void add_parts(TestWorld& world, BodyId body, const Thing& thing) {
    for (const std::vector<Vec2>& p : thing.parts) {
        if (p.size() == 1)
            world->create_shape(body, Circle{p[0], thing.radius});
        else if (p.size() == 2)
            world->create_shape(body, Capsule{p[0], p[1], thing.radius});
        else
            world->create_shape(body, make_polygon(compute_hull(p), thing.radius));
    }
}

float lowest(const Thing& thing, const Transform& pose) {
    float low = 1e9f;
    for (const std::vector<Vec2>& part : thing.parts)
        for (const Vec2 p : part) low = std::min(low, transform_point(pose, p).y - thing.radius);
    return low;
}

enum class Ground { box, rising, sinking, heavy, light, segment, half_space };

BodyId add_ground(TestWorld& world, Ground ground, float meeting_after) {
    if (ground == Ground::segment) return world.add(Segment{{-20, 0}, {20, 0}}, Vec2{0, 0}, {}, BodyType::static_body);
    if (ground == Ground::half_space) return world.add(HalfSpace{}, Vec2{0, 0}, {}, BodyType::static_body);
    const Polygon slab = make_offset_box(ground == Ground::heavy || ground == Ground::light ? 4.0f : 20.0f, 1, {{0, -1}, {}});
    if (ground == Ground::box) return world.add(slab, Vec2{0, 0}, {}, BodyType::static_body);
    if (ground == Ground::heavy || ground == Ground::light) {
        world.add(make_offset_box(40, 1, {{0, -3}, {}}), Vec2{0, 0}, {}, BodyType::static_body);
        ShapeDef def;
        def.density = ground == Ground::heavy ? 10.0f : 1.0f;
        const BodyId id = world.add(slab, dynamic_at({0, 0}), def);
        world.step(60);
        return id;
    }
    BodyDef def;
    def.type = BodyType::kinematic;
    def.linear_velocity = {0, ground == Ground::rising ? 2.0f : -2.0f};
    def.position = {0, -meeting_after * def.linear_velocity.y};
    return world.add(slab, def);
}

// The deepest of 24 falls from 1 to 20 m, at angles from 0 to a quarter turn, two thirds of them turning.
float deepest(const Thing& thing, Ground ground) {
    float worst = 0;
    for (int k = 0; k < 24; ++k) {
        const float n = static_cast<float>(k);
        const float height = 1 + 19 * std::fmod(n * 0.618034f, 1.0f), angle = k % 4 == 0 ? 0 : 0.5f * pi * std::fmod(n * 0.7548777f, 1.0f);
        TestWorld world({.bodies = 4, .shapes = 8, .contacts = 32});
        const float speed = std::sqrt(20 * height);
        // The last 3 m of the fall are enough, begun in every phase of a step.
        const float fall = std::min(height, 3 + 0.01f * n), begun = std::sqrt(20 * (height - fall));
        const BodyId floor = add_ground(world, ground, (speed - begun) / 10);
        BodyDef def = dynamic_at({0.013f * n, world->position(floor).y * (ground == Ground::heavy || ground == Ground::light ? 1.0f : 0.0f) + fall}, angle);
        def.position.y -= lowest(thing, {{0, 0}, make_rot(angle)});
        def.linear_velocity = {0, -begun};
        def.angular_velocity = k % 3 == 0 ? 0 : 10 * (std::fmod(n * 0.5698403f, 1.0f) - 0.5f);
        const BodyId body = world->create_body(def);
        add_parts(world, body, thing);
        for (int i = 0; i < 120; ++i) {
            world.step();
            const Transform pose = inv_mul(world->transform(floor), world->transform(body));
            if (std::abs(pose.p.x) < 2.5f) worst = std::max(worst, -lowest(thing, pose));
        }
    }
    return worst;
}

class Landing : public testing::TestWithParam<Thing> {};

TEST_P(Landing, SinksByNoMoreThanCanBeSeen) {
    EXPECT_LE(deepest(GetParam(), Ground::box), allowed_depth) << "into a box";
    EXPECT_LE(deepest(GetParam(), Ground::segment), allowed_depth) << "into a segment";
    EXPECT_LE(deepest(GetParam(), Ground::half_space), allowed_depth) << "into a half-space";
    EXPECT_LE(deepest(GetParam(), Ground::sinking), allowed_depth) << "into a floor that sinks at 2 m/s";
    EXPECT_LE(deepest(GetParam(), Ground::rising), 2 * allowed_depth) << "into a floor that rises at 2 m/s";  // a triangle sinks by 5.7 mm
    EXPECT_LE(deepest(GetParam(), Ground::heavy), allowed_depth) << "into a heavy slab";
    EXPECT_LE(deepest(GetParam(), Ground::light), allowed_depth) << "into a light slab";
}

const Thing things[] = {{"box", {rectangle(0.5f, 0.5f)}},
                        {"small_box", {rectangle(0.25f, 0.25f)}},
                        {"large_box", {rectangle(1, 1)}},
                        {"plank", {rectangle(1, 0.05f)}},
                        {"triangle", {regular(3, 0.5f)}},
                        {"pentagon", {regular(5, 0.5f)}},
                        {"octagon", {regular(8, 0.5f)}},
                        {"circle", {{{0, 0}}}, 0.5f},
                        {"marble", {{{0, 0}}}, 0.1f},
                        {"capsule", {{{-0.5f, 0}, {0.5f, 0}}}, 0.25f},
                        {"rounded", {rectangle(0.4f, 0.4f)}, 0.1f},
                        {"compound", {rectangle(0.5f, 0.1f), rectangle(0.1f, 0.5f, {0.4f, 0.4f})}}};
INSTANTIATE_TEST_SUITE_P(Falls, Landing, testing::ValuesIn(things), [](const auto& test) { return std::string(test.param.name); });

TEST(LandingAtSpeed, APlateStopsAtTheFaceOfAWall) {
    // Flat against the wall, from 16 phases of a step; half a second later it still stands there.
    for (const float speed : {5.0f, 20.0f, 120.0f, 300.0f}) {
        for (int phase = 0; phase < 16; ++phase) {
            TestWorld world({.bodies = 4, .shapes = 4, .contacts = 8}, weightless());
            world.add(make_offset_box(1, 20, {{1, 0}, {}}), Vec2{0, 0}, {}, BodyType::static_body);
            BodyDef def = dynamic_at({-7 - speed / 60 * static_cast<float>(phase) / 16, 0});
            def.linear_velocity = {speed, 0};
            const BodyId plate = world.add(make_box(0.05f, 1), def);
            float deepest = -1e9f;
            for (int i = 0; i < static_cast<int>(7 * 60 / speed) + 30; ++i) {
                world.step();
                deepest = std::max(deepest, world->position(plate).x + 0.05f);
            }
            EXPECT_LE(deepest, allowed_depth) << speed << " m/s, phase " << phase;
            EXPECT_GE(deepest, -allowed_depth) << speed << " m/s, phase " << phase;
        }
    }
}

TEST(LandingAtSpeed, WhatFliesPastACornerIsNeitherStoppedNorTurned) {
    // A turning bar passes a post whose corner its tips miss by 2 cm, in every phase of a step.
    for (const float speed : {2.0f, 8.0f, 30.0f}) {
        for (int phase = 0; phase < 24; ++phase) {
            TestWorld world({.bodies = 4, .shapes = 4, .contacts = 8}, weightless());
            world.add(make_box(0.5f, 0.5f), Vec2{0, 0}, {}, BodyType::static_body);
            BodyDef def = dynamic_at({-3 - speed / 60 * static_cast<float>(phase) / 24, 0.5f + 0.02f + std::sqrt(0.16f + 0.0025f)});
            def.linear_velocity = {speed, 0};
            def.angular_velocity = 5;
            const float start = def.position.y;
            const BodyId bar = world.add(make_box(0.4f, 0.05f), def);
            std::size_t touches = 0;
            for (int i = 0; i < static_cast<int>(6 * 60 / speed) + 2; ++i) {
                world.step();
                touches += world->begin_touch_events().size();
            }
            EXPECT_NEAR(world->position(bar).y, start, 1e-4f) << speed << " m/s, phase " << phase;
            EXPECT_NEAR(world->angular_velocity(bar), 5, 1e-3f) << speed << " m/s, phase " << phase;
            EXPECT_EQ(touches, 0u) << speed << " m/s, phase " << phase;
        }
    }
}

TEST(LandingAtSpeed, TheTouchIsToldOfInTheStepInWhichItHappens) {
    // At 30 m/s the contact is made up to half a metre ahead; the touch and the hit are told of together, once.
    for (int phase = 0; phase < 16; ++phase) {
        TestWorld world({.bodies = 4, .shapes = 4, .contacts = 8}, weightless());
        world.add(make_offset_box(1, 20, {{1, 0}, {}}), Vec2{0, 0}, {}, BodyType::static_body);
        BodyDef def = dynamic_at({-3 - 0.5f * static_cast<float>(phase) / 16, 0});
        def.linear_velocity = {30, 0};
        ShapeDef tells;
        tells.hit_events = true;
        const BodyId ball = world.add(Circle{{}, 0.2f}, def, tells);
        std::size_t touches = 0, hits = 0;
        for (int i = 0; i < 20; ++i) {
            world.step();
            touches += world->begin_touch_events().size();
            hits += world->hit_events().size();
            EXPECT_EQ(touches, hits) << "phase " << phase << " step " << i;
            const float gap = -0.2f - world->position(ball).x;
            if (gap < 0.005f) { EXPECT_EQ(touches, 1u) << "phase " << phase << " step " << i; }
            if (gap > 0.021f) { EXPECT_EQ(touches, 0u) << "phase " << phase << " step " << i; }
        }
    }
}

TEST(LandingAtSpeed, NobodyIsPressedThroughTheWallsOfARoom) {
    // Ten seeds of 60 bodies of five kinds, in rooms of thin and of thick walls, under up to a thousand times the Earth's gravity.
    std::uint32_t outside = 0;
    for (const float half : {0.01f, 0.5f}) {
        for (const float gravity : {10.0f, 300.0f, 3000.0f, 10000.0f}) {
            for (std::uint64_t seed = 0; seed < 10; ++seed) {
                Random random(seed);
                WorldDef def;
                def.gravity = {0, -gravity};
                TestWorld world({.bodies = 64, .shapes = 80, .contacts = 2000}, def);
                const BodyId room = world->create_body({});
                for (const float side : {-1.0f, 1.0f}) {
                    world->create_shape(room, make_offset_box(half, 5 + 2 * half, {{side * (5 + half), 0}, {}}));
                    world->create_shape(room, make_offset_box(5 + 2 * half, half, {{0, side * (5 + half)}, {}}));
                }
                std::vector<BodyId> bodies;
                for (int i = 0; i < 60; ++i) {
                    const Vec2 at = {static_cast<float>(i % 8) - 3.5f + random.between(-0.1f, 0.1f),
                                     static_cast<float>(i / 8) - 4 + random.between(-0.1f, 0.1f)};
                    const BodyDef body = dynamic_at(at, random.between(-pi, pi));
                    switch (i % 5) {
                        case 0: bodies.push_back(world.add(make_box(0.3f, 0.2f), body)); break;
                        case 1: bodies.push_back(world.add(make_polygon(compute_hull(regular(3, 0.5f))), body)); break;
                        case 2: bodies.push_back(world.add(make_polygon(compute_hull(regular(8, 0.5f))), body)); break;
                        case 3: bodies.push_back(world.add(Circle{{}, 0.3f}, body)); break;
                        default: bodies.push_back(world.add(Capsule{{-0.2f, 0}, {0.2f, 0}, 0.15f}, body)); break;
                    }
                }
                for (int i = 0; i < 120; ++i) world.step();
                for (const BodyId id : bodies) {
                    const Vec2 p = world->center_of_mass(id);
                    if (std::max(std::abs(p.x), std::abs(p.y)) > 5) ++outside;
                }
            }
        }
    }
    EXPECT_EQ(outside, 0u);
}

}  // namespace
}  // namespace islet::test
