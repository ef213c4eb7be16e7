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
#if ISLET_MAX_LANES == 1
    return meet(a, b);
#else
    const f4 bounds = __builtin_bit_cast(f4, a), others = __builtin_bit_cast(f4, b);
    const f4 opposite = __builtin_shufflevector(others, others, 2, 3, 0, 1);
    return mask_bits(__builtin_shufflevector(bounds <= opposite, bounds >= opposite, 0, 1, 6, 7)) == 15u;
#endif
}
/// merge()
ISLET_SHARED Aabb both(const Aabb& a, const Aabb& b) { return merge(a, b); }
/// The box that a box covers on a way, on which its points turn by up to `turn` (m, at least 0) more.
ISLET_LANE Aabb swept(const Aabb& box, Vec2 way, float turn) {
#if ISLET_MAX_LANES == 1
    return expand(both(box, {box.lower + way, box.upper + way}), turn);
#else
    const f4 from = __builtin_bit_cast(f4, box), to = from + f4{way.x, way.y, way.x, way.y};
    return __builtin_bit_cast(Aabb, __builtin_shufflevector(min(from, to) - turn, max(from, to) + turn, 0, 1, 6, 7));
#endif
}
/// m between two boxes along the axis along which they are farther apart; negative if they overlap.
ISLET_LANE float gap_between(const Aabb& a, const Aabb& b) {
    return max(max(b.lower.x - a.upper.x, a.lower.x - b.upper.x), max(b.lower.y - a.upper.y, a.lower.y - b.upper.y));
}
/// The box of two points.
ISLET_SHARED Aabb box_around(Vec2 a, Vec2 b) { return {min(a, b), max(a, b)}; }

}  // namespace islet::detail
