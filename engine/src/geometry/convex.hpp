// The limits of what counts as a shape and as a mass, and the test for a convex polygon.
#pragma once

#include <cstdint>

#include "../math/inlining.hpp"
#include "islet/geometry.hpp"
#include "islet/types.hpp"

namespace islet::detail {

// m: segments, capsule axes and the edges of a computed hull are longer than this. The solver lets shapes sink into each other by as much,
// so anything shorter has no direction worth speaking of.
inline constexpr float min_length = 0.005f;

// m: no coordinate, radius or extent of a shape is larger, so that the fourth powers in an inertia stay far from overflow.
inline constexpr float max_coordinate = max_position;

/// False for NaN as well.
ISLET_INLINE bool in_range(float a) { return abs(a) <= max_coordinate; }
ISLET_SHARED bool in_range(Vec2 a) { return in_range(a.x) && in_range(a.y); }
ISLET_INLINE bool is_radius(float r) { return r >= 0 && r <= max_coordinate; }

/// True of two points that a line can be drawn through.
ISLET_SHARED bool are_apart(Vec2 a, Vec2 b) { return in_range(a) && in_range(b) && distance_squared(a, b) > min_length * min_length; }

/// The index after i in a loop of count.
ISLET_INLINE std::uint32_t next(std::uint32_t i, std::uint32_t count) { return i + 1 < count ? i + 1 : 0; }

/// True if every point lies strictly to the left of every edge it is not an end of: convex, counter-clockwise, going round just once,
/// no two points alike and no three in a line.
bool is_strictly_convex(span<const Vec2> points);

/// True of a polygon that make_box or its like made: a rectangle by its normals, exactly, and by its corners, but for rounding.
bool is_box(const Polygon& p);

ISLET_SHARED bool is_density(float density) { return density >= 0 && is_finite(density); }

/// A density may be finite and still too much for the shape: no mass rather than an infinite one.
ISLET_SHARED MassData checked(const MassData& m) { return is_finite(m.mass) && is_finite(m.inertia) ? m : MassData{}; }

}  // namespace islet::detail
