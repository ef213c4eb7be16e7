// How far two convex shapes are apart, and where.
//
// A shape here is the convex hull of up to eight points (its core), grown by a radius: a point is a circle, two points are a capsule. The
// answer is exact up to rounding for every such pair, which also makes it the base of shape casts, overlap queries and time of impact.
#pragma once

#include <cstdint>

#include "islet/geometry.hpp"

namespace islet::detail {

/// A convex core of 1 to 8 points in any order, grown by `radius` (m, >= 0).
struct ConvexProxy {
    Vec2 points[max_polygon_vertices];
    std::uint32_t count = 0;
    float radius = 0;
};

struct DistanceResult {
    Vec2 point_a;  // m, frame A: the closest points, on the rounded surfaces
    Vec2 point_b;
    Vec2 normal;                   // unit, from A to B; the zero vector when the cores touch or overlap
    float distance = 0;            // m, between the rounded surfaces; negative when only the rounding overlaps, -(sum of the radii) when the cores do
    std::uint32_t count = 0;       // corners that carry the closest points: 1, 2, or 3 when the cores overlap
    std::uint8_t index_a[3] = {};  // those corners; the same index twice means that a vertex, not an edge, is closest
    std::uint8_t index_b[3] = {};
};

/// Closest points of a and b, where b_in_a is the pose of b's frame in a's. Both counts must be at least 1.
DistanceResult distance(const ConvexProxy& a, const ConvexProxy& b, const Transform& b_in_a);

/// The same for two bare cores that are given in one frame.
DistanceResult core_distance(const Vec2* a, std::uint32_t count_a, const Vec2* b, std::uint32_t count_b);

}  // namespace islet::detail
