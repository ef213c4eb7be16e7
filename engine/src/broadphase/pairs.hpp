// Finding pairs: every two shapes whose fat boxes began to overlap get a contact.
#pragma once

#include "../collide/manifold.hpp"
#include "../data/core.hpp"
#include "../math/scalar.hpp"

namespace islet::detail {

inline constexpr float max_box_margin = 0.05f;  // m, by which a fat box exceeds its shape: so far a body can move before its pairs are found anew

/// Creates contacts for the shapes whose fat boxes changed since the last call, and for fast bodies with the static shapes they may reach within dt.
/// The cost follows what moved; nothing moved costs nothing. Pairs that find no room are counted in report.dropped_contacts and tried again in every
/// later call. The search ends once as many were dropped as the capacity has contacts, so its cost does not grow with the number of pairs that find no room.
void find_pairs(Core& core, float dt);

/// Of two bodies that move no more than this in a step, m, a contact is made early enough at speculative_distance: an old answer that they are apart
/// may be a quarter of it off for either, and 2 mm each may be lacking in the end.
inline constexpr float fast_way = 0.25f * speculative_distance + 0.4f * linear_slop;

/// What gravity and forces do to a body while nothing holds it, m/s^2.
inline Vec2 pull_on(const Core& core, std::uint32_t body) {
    const float inv_mass = core.poses[body].inv_mass;
    return inv_mass > 0 ? core.bodies[body].gravity_scale * core.state->gravity + inv_mass * core.motions[body].force : Vec2{0, 0};
}

/// How two bodies come together within a step, as far as nothing else touches them: the smaller one seen from the other.
struct Approach {
    Vec2 way;        // m, that B goes from A
    float turn = 0;  // m, by which its points may depart from that, turning or being pulled

    float most() const { return abs(way.x) + abs(way.y) + turn; }  // m, at least as far as any of them goes
};

inline constexpr float pull_share = 0.625f;  // of what a pull would do in a whole step from its start: four substeps add up to so much

/// `fall` (m): what gravity adds, 0 for bodies that hold each other.
inline Approach approach_of(const Pose& a, const Pose& b, const Motion& ma, const Motion& mb, float dt, float fall) {
    const bool a_is_smaller = a.max_extent < b.max_extent;
    const Vec2 way = dt * (mb.v - ma.v - cross(a_is_smaller ? mb.w : ma.w, b.center - a.center));
    return {way, min(dt * abs(mb.w - ma.w), 2.0f) * min(a.max_extent, b.max_extent) + fall};
}

/// What gravity adds to a way within dt, m.
inline float fall_in(const Core& core, float dt) { return pull_share * dt * dt * (abs(core.state->gravity.x) + abs(core.state->gravity.y)); }

/// True if shape A has no end, and B's fat box, moved on by its way within dt, does not come near it: they need no contact, though their boxes meet.
bool keeps_from_endless(const Core& core, std::uint32_t shape_a, std::uint32_t shape_b, float dt);

/// How far a body comes within a step as long as nothing touches it.
struct Way {
    Vec2 move;       // m, of its centre
    float turn = 0;  // m, by which its points may depart from that, turning
};

/// True if two shapes whose boxes do not meet may come together within dt.
bool may_meet(const Core& core, std::uint32_t shape_a, std::uint32_t shape_b, float dt);

/// A fast body is alone (pose_alone) if nothing at rest is so near to its shapes, m: while it goes no farther there is nothing it could pass through.
inline float surroundings(const Pose& pose) { return 4.0f * pose.max_extent; }

/// Marks a shape's fat box as changed.
void mark_moved(Core& core, std::uint32_t shape);

}  // namespace islet::detail
