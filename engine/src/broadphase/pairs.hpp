// Finding pairs: two shapes whose fat boxes begin to overlap get a contact.
#pragma once

#include "../collide/manifold.hpp"
#include "../data/core.hpp"
#include "../math/scalar.hpp"
#include "../shapes/shape_types.hpp"

namespace islet::detail {

inline constexpr float max_box_margin = 0.05f;  // m, by which a fat box exceeds its shape: how far a body can move before its pairs are found anew

/// Creates contacts for shapes whose fat boxes changed since the last call, and for fast bodies with the static shapes that they may reach within dt. Only
/// boxes that changed cost time. Pairs that find no room are counted in report.dropped_contacts; each later call tries them again. The search ends once it has
/// dropped as many pairs as the capacity has contacts, so its cost does not grow with the number of pairs without room.
void find_pairs(Core& core, float dt);

/// m in a step. For two bodies that move no farther, a contact made at speculative_distance comes early enough: an old result that they are apart may be a
/// quarter of that distance off for each body, and each may sink in by 2 mm in the end.
inline constexpr float fast_way = 0.25f * speculative_distance + 0.4f * linear_slop;

/// The acceleration by gravity and forces of a body that nothing holds, m/s^2.
inline Vec2 pull_on(const Core& core, std::uint32_t body) {
    const float inv_mass = core.poses[body].inv_mass;
    return is_positive(inv_mass) ? core.bodies[body].gravity_scale * core.state->gravity + inv_mass * core.motions[body].force : Vec2{0, 0};
}

/// How two bodies approach each other within a step, if nothing else touches them: the way of the smaller one, seen from the other.
struct Approach {
    Vec2 way;        // m, that B goes from A
    float turn = 0;  // m, by which turning and forces may add to the way of its points

    float most() const { return abs(way.x) + abs(way.y) + turn; }  // m, at least the way of any point
};

/// Share of a pull's way in a step that bodies really go: velocities change in four substeps, each before the move, (1 + 2 + 3 + 4) / 16.
inline constexpr float pull_share = 0.625f;

/// `fall` (m) is the way that gravity adds; 0 for bodies that hold each other.
ISLET_SHARED Approach approach_of(const Pose& a, const Pose& b, const Motion& ma, const Motion& mb, float dt, float fall) {
    const bool a_is_smaller = a.max_extent < b.max_extent;
    const Vec2 way = dt * (mb.v - ma.v - cross(a_is_smaller ? mb.w : ma.w, b.center - a.center));
    return {way, min(dt * abs(mb.w - ma.w), 2.0f) * min(a.max_extent, b.max_extent) + fall};
}

/// The way that gravity adds within dt, m.
inline float fall_in(const Core& core, float dt) { return pull_share * dt * dt * (abs(core.state->gravity.x) + abs(core.state->gravity.y)); }

/// False if a shape with this fat box has an end. One without reaches endless_reach to at least one side, and no less than -max_position to the other.
inline constexpr float widest_box = 0.5f * endless_reach;  // m
inline bool may_be_endless(const Aabb& box) { return has_endless && box.upper.x - box.lower.x > widest_box; }

/// True if shape A has no end, and B's fat box, moved on by its way within dt, does not come near it: they need no contact, though their boxes meet.
bool keeps_from_endless(const Core& core, std::uint32_t shape_a, std::uint32_t shape_b, float dt);

/// How far a body goes within a step if nothing touches it.
struct Way {
    Vec2 move;       // m, of its centre
    float turn = 0;  // m, by which turning may add to the way of its points
};

/// True if a body may leave its fat boxes within this step.
inline bool may_leave(const Pose& pose) { return has_continuous && (pose.flags & pose_leaves) != 0; }

/// True if shapes of two bodies whose fat boxes do not meet may come together within dt.
bool may_meet(const Core& core, std::uint32_t body_a, const Aabb& box_a, std::uint32_t body_b, const Aabb& box_b, float dt);

/// m. A fast body is alone (pose_alone) if nothing at rest is so near to its shapes. While it goes no farther, it cannot pass through anything at rest.
inline float surroundings(const Pose& pose) { return 4.0f * pose.max_extent; }

/// Marks a shape's fat box as changed. If several threads mark shapes at once (ISLET_SHARES_WORDS), each those of its own bodies, each passes a counter
/// `marked`, and adds it with add_marked when it is done.
void mark_moved(Core& core, std::uint32_t shape, std::uint32_t* marked = nullptr);
void add_marked(Core& core, std::uint32_t marked);

}  // namespace islet::detail
