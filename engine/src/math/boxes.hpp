// Functions on boxes that many places call: a build for size keeps one copy of each.
#pragma once

#include "../math/inlining.hpp"
#include "../math/lanes.hpp"
#include "islet/config.hpp"
#include "islet/math.hpp"

namespace islet::detail {

/// overlaps()
ISLET_SHARED bool meet(const Aabb& a, const Aabb& b) { return overlaps(a, b); }
/// The same as one comparison of four numbers, where the processor has vectors: for searches, most of whose boxes are beside the question, so that no branch
/// could be guessed.
ISLET_LANE bool meet_at_once(const Aabb& a, const Aabb& b) {
    if constexpr (ISLET_MAX_LANES == 1) return meet(a, b);
    constexpr float all = __builtin_inff();
    const f4 bounds = __builtin_bit_cast(f4, a);
    return mask_bits((bounds <= f4{b.upper.x, b.upper.y, all, all}) & (bounds >= f4{-all, -all, b.lower.x, b.lower.y})) == 15u;
}
/// merge()
ISLET_SHARED Aabb both(const Aabb& a, const Aabb& b) { return merge(a, b); }
/// The box of two points.
ISLET_SHARED Aabb box_around(Vec2 a, Vec2 b) { return {min(a, b), max(a, b)}; }

}  // namespace islet::detail
