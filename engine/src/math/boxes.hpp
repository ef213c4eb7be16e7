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

/// A box as a processor holds it best: in one vector, if it has vectors. (Compilers put an Aabb together in memory, and take it apart again.)
///   hold, as_box       make one of an Aabb, and the other way round
///   expand_held        expand()
///   is_inside          contains()
///   room_in            how far the inner box may move before it leaves the outer one, m; negative if it is not inside
#if ISLET_MAX_LANES == 1
using HeldBox = Aabb;
inline const HeldBox& hold(const Aabb& box) { return box; }
inline const Aabb& as_box(const HeldBox& box) { return box; }
inline HeldBox expand_held(const HeldBox& box, float margin) { return expand(box, margin); }
inline bool is_inside(const HeldBox& outer, const HeldBox& inner) { return contains(outer, inner); }
inline float room_in(const HeldBox& outer, const HeldBox& inner) {
    const Vec2 below = inner.lower - outer.lower, above = outer.upper - inner.upper;
    return min(min(below.x, below.y), min(above.x, above.y));
}
#else
using HeldBox = f4;
ISLET_LANE HeldBox hold(const Aabb& box) { return load4(&box.lower.x); }
ISLET_LANE Aabb as_box(HeldBox box) { return __builtin_bit_cast(Aabb, box); }
ISLET_LANE HeldBox expand_held(HeldBox box, float margin) { return box + f4{-margin, -margin, margin, margin}; }
ISLET_LANE bool is_inside(HeldBox outer, HeldBox inner) { return mask_bits(__builtin_shufflevector(outer <= inner, outer >= inner, 0, 1, 6, 7)) == 15u; }
ISLET_LANE float room_in(HeldBox outer, HeldBox inner) {
    const f4 rooms = __builtin_shufflevector(inner - outer, outer - inner, 0, 1, 6, 7);
    const f4 less = min(rooms, __builtin_shufflevector(rooms, rooms, 2, 3, 0, 1));
    return min(less[0], less[1]);
}
#endif

}  // namespace islet::detail
