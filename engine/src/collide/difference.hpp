// The Minkowski difference of two convex shapes, which turns every question about two shapes into one about a point.
//
// Subtract each point of A from each point of B: the differences w = b - a fill a convex polygon of at most 16 corners, grown by both radii. A, moved by
// x, meets B just when x is in it. So the shapes' distance is that of the origin from the polygon, their depth of overlap how deep the origin lies in it, and
// A cast along d meets B where the ray from the origin along d meets the polygon.
//
//          ____                  ________
//         | B  |      A         /        |      the ray x = t d from the origin enters where A, moved by t d, touches B
//         |____|     /_|       |  B - A  |
//                              |________/    <---o
//
// Corners are differences of nearby numbers, so nothing is lost far from the origin, and there is no iteration that could fail to converge.
#pragma once

#include <cstdint>

#include "islet/query.hpp"

namespace islet::detail {

struct Difference {
    static constexpr std::uint32_t max_count = 2 * max_polygon_vertices;
    Vec2 points[max_count];  // m, counter-clockwise, no two neighbours alike
    std::uint8_t index_a[max_count];  // the corners of A and B that each is made of
    std::uint8_t index_b[max_count];
    std::uint32_t count = 0;
    float radius = 0;
};

/// A place on the difference's outline: on the way from corner k to the next one.
struct Place {
    std::uint32_t corner = 0;
    float along = 0;  // 0 to 1
};

/// The outline's place nearest to the origin.
struct Nearest {
    float distance = 0;  // m, from the rounded outline; negative inside
    Vec2 normal;         // unit, outward there
    Place place;
};

/// Where a ray from the origin meets the outline.
struct Impact {
    bool hit = false;
    float fraction = 0;
    Vec2 normal;           // unit, outward
    float separation = 0;  // m, negative if the ray starts inside
    Place place;
};

/// b - a; both must have 1 to 8 points.
Difference difference_of(const ShapeProxy& a, const ShapeProxy& b);
Nearest nearest(const Difference& w);
Impact impact(const Difference& w, Vec2 translation);
/// The point of A or B (its core, without the radius) that a place is made of.
Vec2 point_of(const Difference& w, const std::uint8_t* index, const Vec2* points, Place place);

/// cast_shape without checks of its arguments.
CastHit cast_proxy(const ShapeProxy& moving, Vec2 translation, const ShapeProxy& target);

}  // namespace islet::detail
