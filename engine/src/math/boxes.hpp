// Functions on boxes that many places call: a build for size keeps one copy of each.
#pragma once

#include "../math/inlining.hpp"
#include "islet/math.hpp"

namespace islet::detail {

/// overlaps()
ISLET_SHARED bool meet(const Aabb& a, const Aabb& b) { return overlaps(a, b); }
/// merge()
ISLET_SHARED Aabb both(const Aabb& a, const Aabb& b) { return merge(a, b); }
/// The box of two points.
ISLET_SHARED Aabb box_around(Vec2 a, Vec2 b) { return {min(a, b), max(a, b)}; }

}  // namespace islet::detail
