// Places built of several static or turning pieces, and random polygons that are thrown into them: for tests, and for islet_random_rooms.
#pragma once

#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "harness/overlap.hpp"
#include "physics/measure.hpp"
#include "support/random.hpp"

namespace islet::test {

inline constexpr double most_overlap = 0.01;  // m: what a user does not see; twice the slop that contacts keep

using samples::overlap_of;
using samples::Outline;
using samples::outline_of;

/// A world of static or turning pieces and of polygons that are thrown at them.
struct Site {
    TestWorld world;
    struct Piece {
        BodyId body;
        Polygon shape;
    };
    std::vector<Piece> pieces, thrown;
    ShapeDef material;
    std::map<std::pair<std::size_t, std::size_t>, int> deep_for;  // steps that a pair has been deep and slow
    int longest_deep = 0;                                         // the longest of these
    double deepest = 0;                                           // m, of any pair in any step that was looked at

    explicit Site(float friction = 0.3f, WorldDef def = sleepless()) : world({.bodies = 64, .shapes = 128, .contacts = 1024}, def), material(rough(friction)) {}

    void add_piece(const Polygon& shape, Vec2 at, float angle = 0) {
        BodyDef def;
        def.position = at;
        def.angle = angle;
        pieces.push_back({world.add(shape, def, material), shape});
    }
    void add_to(BodyId body, const Polygon& shape) {
        world->create_shape(body, shape, material);
        pieces.push_back({body, shape});
    }
    BodyId throw_in(const Polygon& shape, const BodyDef& def) {
        const BodyId id = world.add(shape, def, material);
        thrown.push_back({id, shape});
        return id;
    }

    /// Every pair of a thrown polygon and a piece.
    void look() {
        std::vector<Outline> fixed;
        for (const Piece& p : pieces) fixed.push_back(outline_of(p.shape, world->transform(p.body)));
        for (std::size_t i = 0; i < thrown.size(); ++i) {
            const Outline hull = outline_of(thrown[i].shape, world->transform(thrown[i].body));
            const bool slow = length(world->linear_velocity(thrown[i].body)) < 1;  // m/s
            for (std::size_t k = 0; k < fixed.size(); ++k) {
                const double overlap = overlap_of(fixed[k], hull);
                deepest = std::fmax(deepest, overlap);
                int& steps = deep_for[{i, k}];
                steps = overlap > most_overlap && slow ? steps + 1 : 0;
                longest_deep = std::max(longest_deep, steps);
            }
        }
    }
    void run(int steps) {
        for (int i = 0; i < steps; ++i) {
            world.step();
            look();
        }
    }
};

/// A convex polygon of 3 to 8 corners, 0.1 to 0.8 m across and no thinner than a fifth of that.
inline Polygon random_polygon(Random& random, std::uint32_t corners) {
    for (;;) {
        const float radius = random.between(0.15f, 0.4f);
        std::array<Vec2, 8> points;
        for (std::uint32_t i = 0; i < corners; ++i) {
            const Rot q = make_rot(2 * pi * (static_cast<float>(i) + random.between(-0.4f, 0.4f)) / static_cast<float>(corners));
            points[i] = radius * random.between(0.7f, 1) * Vec2{q.c, q.s};
        }
        const Polygon p = make_polygon(compute_hull({points.data(), corners}));
        if (p.count == corners) return p;
    }
}

inline BodyDef random_throw(Random& random, Vec2 lower, Vec2 upper, float speed) {
    const Vec2 at = {random.between(lower.x, upper.x), random.between(lower.y, upper.y)};  // one after the other, whatever the compiler
    BodyDef def = dynamic_at(at, random.between(-pi, pi));
    def.linear_velocity = {random.between(-speed, speed), random.between(-speed, speed)};
    def.angular_velocity = random.between(-5, 5);
    return def;
}

/// A room of four walls of 2 cm that cross at their ends, 4 m by 3 m.
inline void build_crossing_walls(Site& site, Random& random) {
    for (const float side : {-1.0f, 1.0f}) {
        site.add_piece(make_box(0.01f, 1.5f + random.between(0.01f, 0.2f)), {side * 2, 0});
        site.add_piece(make_box(2 + random.between(0.01f, 0.2f), 0.01f), {0, side * 1.5f});
    }
}

enum class Ground { room, ramps, groove, stairs, gears };

inline void build(Site& site, Ground ground, Random& random) {
    // All within a box of thick walls.
    site.add_piece(make_box(4, 0.5f), {0, -0.5f});
    for (const float side : {-1.0f, 1.0f}) site.add_piece(make_box(0.5f, 4), {side * 3.5f, 3});
    const auto add_gear = [&](Vec2 at, float spin) {
        BodyDef def;
        def.type = BodyType::kinematic;
        def.position = at;
        def.angular_velocity = spin;
        const BodyId gear = site.world->create_body(def);
        for (int i = 0; i < 4; ++i) site.add_to(gear, make_offset_box(0.9f, 0.12f, {{0, 0}, make_rot(pi / 4 * static_cast<float>(i))}));
        std::array<Vec2, 8> hub;
        for (int i = 0; i < 8; ++i) hub[std::size_t(i)] = 0.6f * Vec2{make_rot(pi / 4 * static_cast<float>(i)).c, make_rot(pi / 4 * static_cast<float>(i)).s};
        site.add_to(gear, make_polygon(compute_hull(hub)));
    };
    switch (ground) {
        case Ground::room:
            for (int i = 0; i < 5; ++i) {
                const Vec2 half = {random.between(0.2f, 1), random.between(0.2f, 1)}, at = {random.between(-3, 3), random.between(0, 2)};
                site.add_piece(make_box(half.x, half.y), at, random.one_in(2) ? 0 : random.between(-pi, pi));
            }
            break;
        case Ground::ramps:
            for (const float side : {-1.0f, 1.0f}) {
                const float foot = random.between(0.2f, 2), top = random.between(0.3f, 1.5f);
                const Vec2 corners[] = {{side * foot, 0}, {side * 3, 0}, {side * 3, top}};
                site.add_piece(make_polygon(compute_hull(corners)), {0, 0});
            }
            break;
        case Ground::groove:
            for (const float side : {-1.0f, 1.0f}) {
                const float angle = random.between(10, 60) * pi / 180;
                const Rot q = make_rot(angle);
                site.add_piece(make_box(4, 0.5f), {side * (3 * q.c + 0.5f * q.s), 0.5f + 3 * q.s - 0.5f * q.c}, side * angle);
            }
            break;
        case Ground::stairs: {
            const float rise = random.between(0.1f, 0.4f), tread = random.between(0.2f, 0.6f);
            for (int i = 0; i < 6; ++i) {
                const float x = -1 + tread * static_cast<float>(i), h = rise * static_cast<float>(i + 1);
                const bool slab = random.one_in(2);
                site.add_piece(make_box(0.5f * tread, slab ? 0.5f * rise : 0.5f * h), {x, slab ? h - 0.5f * rise : 0.5f * h});
            }
            break;
        }
        case Ground::gears:
            // The one that turns has room around it, so that it cannot crush what falls beside it.
            add_gear({-2, 0.6f}, 0);
            add_gear({2, 0.6f}, 0);
            add_gear({0, 2.8f}, random.between(-0.5f, 0.5f));
            break;
    }
}

}  // namespace islet::test
