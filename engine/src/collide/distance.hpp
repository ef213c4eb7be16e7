// How far two convex cores are apart, and where: what the step asks, in contact points and times of impact.
//
// A core is the convex hull of up to eight points. The answer is exact up to rounding. Queries ask another algorithm (difference.hpp), for two reasons: it
// knows the depth of an overlap, which this one does not; and its error is bounded by the lengths asked about, however nearly parallel the shapes are. This one
// looks at a few corners instead of merging all of both.
#pragma once

#include <cstdint>

#include "islet/geometry.hpp"

namespace islet::detail {

struct DistanceResult {
    Vec2 point_a;  // m: the closest points
    Vec2 point_b;
    Vec2 normal;                   // unit, from A to B; the zero vector when the cores touch or overlap
    float distance = 0;            // m; 0 when the cores overlap
    std::uint32_t count = 0;       // corners that carry the closest points: 1, 2, or 3 when the cores overlap
    std::uint8_t index_a[3] = {};  // those corners; the same index twice means that a vertex, not an edge, is closest
    std::uint8_t index_b[3] = {};
};

/// Closest points of two bare cores of 1 to 8 points, in any order, that are given in one frame.
DistanceResult core_distance(const Vec2* a, std::uint32_t count_a, const Vec2* b, std::uint32_t count_b);

}  // namespace islet::detail
