// A body that several contacts hold at once: by faces that are not centred under the load, by legs, by pieces of a floor.
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

using Parts = std::vector<Polygon>;

Polygon hull(std::span<const Vec2> points, float scale = 1) {
    std::vector<Vec2> scaled;
    for (const Vec2 p : points) scaled.push_back(scale * p);
    return make_polygon(compute_hull(scaled));
}
Polygon box_at(Vec2 center, float hx, float hy) { return make_offset_box(hx, hy, {center, {}}); }

void add_parts(World& w, BodyId body, const Parts& parts, const ShapeDef& def = {}) {
    for (const Polygon& part : parts) w.create_shape(body, part, def);
}

/// A table, 2 wide and 2 high: a board on two legs.
Parts table(float scale) { return {box_at({0, 0.8f * scale}, scale, 0.2f * scale), box_at({-0.8f * scale, -0.2f * scale}, 0.2f * scale, 0.8f * scale),
                                   box_at({0.8f * scale, -0.2f * scale}, 0.2f * scale, 0.8f * scale)}; }

// -- columns whose faces are not centred under the load --

struct Brick {
    const char* name;
    std::vector<Vec2> corners;  // of a brick 2 wide and 2 high
};
const Brick bricks[] = {
    {"a top corner cut off", {{-1, -1}, {1, -1}, {1, 0.6f}, {0.6f, 1}, {-1, 1}}},
    {"a lower corner cut off", {{-1, -0.6f}, {-0.6f, -1}, {1, -1}, {1, 1}, {-1, 1}}},
    {"a narrow top at one side", {{-1, -1}, {1, -1}, {0.8f, 1}, {-1, 1}}},
    {"a pentagon without symmetry", {{-1, -1}, {1, -1}, {1.1f, 0.2f}, {0.8f, 1}, {-0.9f, 1}}},
    {"a parallelogram", {{-1, -1}, {1, -1}, {1.1f, 1}, {-0.9f, 1}}},
};

/// The column's bodies, from below.
std::vector<BodyId> add_column(TestWorld& world, const Parts& brick, float height, int count, Random& random) {
    std::vector<BodyId> column;
    for (int i = 0; i < count; ++i) {
        const float x = height * random.between(-0.004f, 0.004f);
        column.push_back(world->create_body({.type = BodyType::dynamic, .position = {x, height * (static_cast<float>(i) + 0.5f)}}));
        add_parts(*world, column.back(), brick);
    }
    return column;
}

// The centre of each brick's mass is over the face below it, so statics lets the column stand. Which side is cut must not matter either.
TEST(SeveralContacts, ColumnsStandOnFacesThatAreNotCentred) {
    for (const Brick& brick : bricks) {
        for (const float height : {0.2f, 0.5f}) {
            for (const float mirror : {-1.0f, 1.0f}) {
                for (std::uint64_t start = 0; start < 2; ++start) {
                    SCOPED_TRACE(std::string(brick.name) + ", height " + std::to_string(height) + ", mirrored " + std::to_string(mirror) + ", start " +
                                 std::to_string(start));
                    WorldDef def;
                    def.enable_sleep = false;
                    TestWorld world(roomy, def);
                    world.add_ground();
                    std::vector<Vec2> corners = brick.corners;
                    for (Vec2& p : corners) p.x *= mirror;
                    Random random(start);
                    const std::vector<BodyId> column = add_column(world, {hull(corners, 0.5f * height)}, height, 20, random);
                    std::vector<float> began;
                    for (const BodyId id : column) began.push_back(world->center_of_mass(id).x);
                    world.step(20 * 60);
                    float drift = 0;
                    for (std::size_t i = 0; i < column.size(); ++i) drift = std::max(drift, std::abs(world->center_of_mass(column[i]).x - began[i]));
                    EXPECT_LT(drift, 0.1f * height);  // by five times as much, its top would be over the edge
                }
            }
        }
    }
}

// A tower of tables is its own mirror image, so nothing prefers a side: from no start does it lean by more than 2 cm.
TEST(SeveralContacts, TowersOnTwoLegsLeanToNoSide) {
    for (std::uint64_t start = 0; start < 4; ++start) {
        SCOPED_TRACE(start);
        WorldDef def;
        def.enable_sleep = false;
        TestWorld world(roomy, def);
        world.add_ground();
        Random random(start);
        const std::vector<BodyId> tower = add_column(world, table(0.25f), 0.5f, 20, random);
        const float began = world->position(tower.back()).x;
        world.step(20 * 60);
        EXPECT_NEAR(world->position(tower.back()).x, began, 0.02f);
    }
}

// -- columns of bodies that are made of pieces --

/// A square, 2 wide and 2 high.
struct Square {
    const char* name;
    float least_height;  // m, of a body of whose kind twenty are to stand
    Parts (*parts)(float scale);
};
const Square squares[] = {
    {"one piece", 0.2f, [](float s) { return Parts{box_at({0, 0}, s, s)}; }},
    {"two halves", 0.2f, [](float s) { return Parts{box_at({-0.5f * s, 0}, 0.5f * s, s), box_at({0.5f * s, 0}, 0.5f * s, s)}; }},
    {"two halves that overlap", 0.2f, [](float s) { return Parts{box_at({-0.48f * s, 0}, 0.52f * s, s), box_at({0.48f * s, 0}, 0.52f * s, s)}; }},
    {"two halves apart", 0.2f, [](float s) { return Parts{box_at({-0.51f * s, 0}, 0.49f * s, s), box_at({0.51f * s, 0}, 0.49f * s, s)}; }},
    {"three thirds", 0.5f,
     [](float s) {
         return Parts{box_at({-2 * s / 3, 0}, s / 3, s), box_at({0, 0}, s / 3, s), box_at({2 * s / 3, 0}, s / 3, s)};
     }},
    {"four quarters", 0.2f,
     [](float s) {
         Parts parts;
         for (const Vec2 at : {Vec2{-0.5f, -0.5f}, Vec2{0.5f, -0.5f}, Vec2{-0.5f, 0.5f}, Vec2{0.5f, 0.5f}}) parts.push_back(box_at(s * at, 0.5f * s, 0.5f * s));
         return parts;
     }},
    {"the same square twice", 1, [](float s) { return Parts{box_at({0, 0}, s, s), box_at({0, 0}, s, s)}; }},
    {"two triangles", 1,
     [](float s) {
         const Vec2 lower[] = {{-1, -1}, {1, -1}, {1, 1}}, upper[] = {{-1, -1}, {1, 1}, {-1, 1}};
         return Parts{hull(lower, s), hull(upper, s)};
     }},
};

// Into which pieces a body is cut is of no account to statics: twenty squares stand, as twenty of one piece do. Each of two such bodies touches the other in
// several contacts, up to seven.
TEST(SeveralContacts, ColumnsStandHoweverTheirBodiesAreCut) {
    for (const Square& square : squares)
        for (const float height : {0.2f, 0.5f, 1.0f})
            for (std::uint64_t start = 0; start < 3 && height >= square.least_height; ++start) {
                WorldDef def;
                def.enable_sleep = false;
                TestWorld world(roomy, def);
                world.add_ground();
                Random random(start);
                const std::vector<BodyId> column = add_column(world, square.parts(0.5f * height), height, 20, random);
                std::vector<float> began;
                for (const BodyId id : column) began.push_back(world->center_of_mass(id).x);
                world.step(20 * 60);
                float drift = 0;
                for (std::size_t i = 0; i < column.size(); ++i) drift = std::max(drift, std::abs(world->center_of_mass(column[i]).x - began[i]));
                EXPECT_LT(drift, 0.5f * height) << square.name << ", height " << height << ", start " << start;  // beyond, the top is over the edge
            }
}

// -- landings on several contacts at once --

enum class Footing { slab, vertex, chain, pillars };
constexpr const char* footing_names[] = {"slab", "chain with a vertex below", "chain of 5 cm pieces", "two pillars"};

void add_footing(TestWorld& world, Footing footing, const ShapeDef& def) {
    const BodyId ground = world->create_body({});
    std::vector<Vec2> line;
    switch (footing) {
        case Footing::slab: world->create_shape(ground, box_at({0, -1}, 10, 1), def); break;
        case Footing::vertex: line = {{5, 0}, {0.175f, 0}, {-5, 0}}; break;
        case Footing::chain:
            for (int i = 100; i >= -100; --i) line.push_back({0.05f * static_cast<float>(i) + 0.013f, 0});
            break;
        case Footing::pillars:
            world->create_shape(ground, box_at({-0.175f, -1}, 0.05f, 1), def);
            world->create_shape(ground, box_at({0.15f, -1}, 0.05f, 1), def);
            break;
    }
    if (!line.empty()) world->create_chain(ground, line, false, def);
}

struct Faller {
    const char* name;
    Parts parts;
    float lowest;  // m, of its lowest face from its origin, downwards
    std::vector<Circle> circles = {};
};
std::vector<Faller> fallers() {
    return {{"box", {make_box(0.25f, 0.25f)}, 0.25f},
            {"plank", {make_box(0.25f, 0.05f)}, 0.05f},
            {"two halves", {box_at({-0.125f, 0}, 0.125f, 0.25f), box_at({0.125f, 0}, 0.125f, 0.25f)}, 0.25f},
            {"table", table(0.25f), 0.25f},
            {"cart", {box_at({0, 0.05f}, 0.25f, 0.2f)}, 0.25f, {{{-0.15f, -0.15f}, 0.1f}, {{0.15f, -0.15f}, 0.1f}}}};
}

struct Fall {
    float tilt = 0;     // rad, the largest
    float end = 0;      // rad, after 3 s
    float rebound = 0;  // m, the highest that it comes after it has met the floor
};
Fall fall_flat(Footing footing, const Faller& faller, float drop, const ShapeDef& def, int steps) {
    TestWorld world;
    add_footing(world, footing, def);
    const BodyId id = world->create_body({.type = BodyType::dynamic, .position = {0, faller.lowest + drop}});
    add_parts(*world, id, faller.parts, def);
    for (const Circle& circle : faller.circles) world->create_shape(id, circle, def);
    Fall fall;
    bool met = false;
    for (int i = 0; i < steps; ++i) {
        world.step();
        fall.tilt = std::max(fall.tilt, std::abs(world->angle(id)));
        met = met || (i > 1 && world->linear_velocity(id).y > -0.1f);
        if (met) fall.rebound = std::max(fall.rebound, world->position(id).y - faller.lowest);
    }
    fall.end = std::abs(world->angle(id));
    return fall;
}

// Without restitution what falls flat stays flat: the blows of all pieces together stop it. (Each alone would turn it: a box is over at 0.8 rad.)
TEST(SeveralContacts, WhatFallsFlatOnPiecesStaysFlat) {
    for (const Footing footing : {Footing::slab, Footing::vertex, Footing::chain, Footing::pillars}) {
        for (const Faller& faller : fallers()) {
            for (int height = 0; height < 12; ++height) {
                const float drop = 0.5f + 0.37f * static_cast<float>(height);
                SCOPED_TRACE(std::string(footing_names[static_cast<int>(footing)]) + ", " + faller.name + ", falls " + std::to_string(drop) + " m");
                if (footing == Footing::pillars && !faller.circles.empty()) continue;  // its wheels come down beside them
                const Fall fall = fall_flat(footing, faller, drop, {}, 180);
                EXPECT_LT(fall.tilt, 0.2f);
                EXPECT_LT(fall.end, 0.02f);
                EXPECT_LT(fall.rebound, 0.02f);
            }
        }
    }
}

// A body that falls by d with the restitution e comes back to e^2 d. (A step that ends between meeting and parting adds at most the way of one step.)
TEST(SeveralContacts, WhatBouncesOnPiecesComesBackAsHighAsTheRestitutionSays) {
    for (const Footing footing : {Footing::slab, Footing::vertex, Footing::chain, Footing::pillars}) {
        for (const Faller& faller : fallers()) {
            for (const float e : {0.3f, 0.6f, 1.0f}) {
                for (int height = 0; height < 5; ++height) {
                    const float drop = 1 + 0.73f * static_cast<float>(height), speed = std::sqrt(2 * static_cast<float>(g) * drop);
                    const std::string what = std::string(footing_names[static_cast<int>(footing)]) + ", " + faller.name;
                    SCOPED_TRACE(what + ", restitution " + std::to_string(e) + ", falls " + std::to_string(drop) + " m");
                    if (footing == Footing::pillars && !faller.circles.empty()) continue;
                    ShapeDef def;
                    def.restitution = e;
                    const int until = static_cast<int>((1 + e) * speed / static_cast<float>(g) / step_time);  // the first top
                    const Fall fall = fall_flat(footing, faller, drop, def, until);
                    EXPECT_NEAR(fall.rebound, e * e * drop, e * e * speed * step_time + 0.01f);
                    EXPECT_LT(fall.tilt, 0.1f);
                }
            }
        }
    }
}

// -- compound bodies in a valley --

// Shapes of one body must not take the valley's ground for something that stands on one of them: each part is held where it touches.
TEST(SeveralContacts, CompoundBodiesDoNotSinkIntoAValley) {
    const Parts u = {box_at({0, -0.0375f}, 0.05f, 0.0125f), box_at({-0.0375f, 0.0125f}, 0.0125f, 0.0375f), box_at({0.0375f, 0.0125f}, 0.0125f, 0.0375f)};
    const Parts l = {u[0], u[1]};
    const float slope = std::tan(20 * pi / 180);
    for (const Parts& parts : {u, l}) {
        for (const bool of_boxes : {false, true}) {
            Random random(1);
            for (int start = 0; start < 40; ++start) {
                SCOPED_TRACE(std::string(parts.size() == 3 ? "U" : "L") + (of_boxes ? ", boxes" : ", chain") + ", start " + std::to_string(start));
                TestWorld world(Capacity{.bodies = 4, .shapes = 16, .contacts = 64});
                const BodyId ground = world->create_body({});
                if (of_boxes) {
                    for (const float side : {-1.0f, 1.0f}) {
                        const std::vector<Vec2> wall = {{0, 0}, {side, slope}, {side, -1}, {0, -1}};
                        world->create_shape(ground, hull(wall));
                    }
                } else {
                    world->create_chain(ground, std::vector<Vec2>{{1, slope}, {0, 0}, {-1, slope}}, false);
                }
                BodyDef def;
                def.type = BodyType::dynamic;
                def.position = {random.between(-0.03f, 0.03f), random.between(0.15f, 0.5f)};
                def.angle = random.between(-3, 3);
                const BodyId body = world->create_body(def);
                add_parts(*world, body, parts);
                world.step(400);
                float sunk = 0;
                for (const Polygon& part : parts) {
                    for (std::uint32_t i = 0; i < part.count; ++i) {
                        const Vec2 p = transform_point(world->transform(body), part.vertices[i]);
                        sunk = std::max(sunk, (slope * std::abs(p.x) - p.y) / std::sqrt(1 + slope * slope));
                    }
                }
                EXPECT_LT(sunk, 0.005f);  // one linear slop
            }
        }
    }
}

}  // namespace
}  // namespace islet::test
