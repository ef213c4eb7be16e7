// The graph of contacts: each body is a node, and each pair of shapes with overlapping fat boxes is a contact between two nodes. The set of pairs says whether
// two shapes already have a contact; where memory is small, the lists of their bodies do.
#pragma once

#include "../data/core.hpp"
#include "../graph/constraint_list.hpp"
#include "../graph/hooks.hpp"

namespace islet::detail {

/// Calls visit(contact, side) for each contact of a body, newest first; `visit` may destroy that contact.
template <class Visit>
void for_each_contact(const Core& core, std::uint32_t body, Visit&& visit) {
    for_each_constraint(core.contacts, core.bodies[body].contact_head, visit);
}

/// The body at the other end of a contact.
inline std::uint32_t other_body(const Core& core, std::uint32_t contact, std::uint32_t side) {
    return side == 0 ? core.manifolds[contact].body_b : core.manifolds[contact].body_a;
}

/// True if the two shapes may have a contact: their bodies differ, both are enabled and at least one is dynamic, their geometries collide, their filters agree,
/// and no joint forbids it. For a sensor: one of the bodies is not static, the other shape is no sensor and has sensor_events, and the filters agree.
bool may_collide(const Core& core, std::uint32_t shape_1, std::uint32_t shape_2);

/// True unless there is a filter hook that says no.
inline bool is_allowed(const Core& core, std::uint32_t shape_1, std::uint32_t shape_2) {
    return !has_hooks || core.hooks.filter == nullptr || is_allowed_by_hook(core, shape_1, shape_2);
}

/// True if the first of two shapes is the one that their contact calls A.
bool in_contact_order(const Core& core, std::uint32_t shape_1, std::uint32_t shape_2);

/// True if two shapes have a contact.
bool find_in_lists(const Core& core, std::uint32_t shape_1, std::uint32_t shape_2);
inline bool have_contact(const Core& core, std::uint32_t shape_1, std::uint32_t shape_2) {
    return has_pair_set ? core.pairs.contains(PairSet::key(shape_1, shape_2)) : find_in_lists(core, shape_1, shape_2);
}

/// Adds a contact, not yet touching. False if the pool is full.
bool create_contact(Core& core, std::uint32_t shape_1, std::uint32_t shape_2);

/// Removes a contact and its colour. If it touched, an end event is recorded.
void destroy_contact(Core& core, std::uint32_t contact);

/// Counts in how many contacts with nearly the same normal (of the 16 newest) two moving bodies touch, and notes it in all. Call it after one of them,
/// `contact`, began or ended to touch.
void count_sharers(Core& core, std::uint32_t contact);

/// Mixes the two shapes' materials: friction, and whether restitution, rolling resistance or a tangent speed act. Changes of the pre_solve hook are lost.
void mix_materials(Core& core, std::uint32_t contact);

/// Drops the end events that the last step reported; those of calls made since stay.
void drop_told_ends(Core& core);

/// Fills in a touching contact as the user reads it, at the bodies' present poses (contact_info.cpp).
void read_contact(const Core& core, std::uint32_t contact, ContactInfo& out);

void record_end_event(Core& core, std::uint32_t contact);
/// False, with the error recorded and counted, if the array of end events is full.
bool has_room_for_end(Core& core);
/// The same for begin events.
bool has_room_for_begin(Core& core);
/// Notes that a touch or an overlap begins. It is told at the end of the step, for until then the solve works where the event will be.
void note_begin(Core& core, std::uint32_t contact);

/// How two bodies stand to each other. The difference of their centres is exact far from the origin, too.
struct Stand {
    Vec2 offset;  // m, from A's centre to B's
    Rot a, b;
};

/// The pose of B's body frame in A's, for bodies that stand so.
inline Transform pose_between(const Core& core, std::uint32_t body_a, std::uint32_t body_b, const Stand& stand) {
    const Rot turn = inv_mul(stand.a, stand.b);
    return {inv_rotate(stand.a, stand.offset) + core.bodies[body_a].local_center - rotate(turn, core.bodies[body_b].local_center), turn};
}

/// How two bodies stand now.
inline Stand stand_now(const Core& core, std::uint32_t body_a, std::uint32_t body_b) {
    const Pose& a = core.poses[body_a];
    const Pose& b = core.poses[body_b];
    return {b.center - a.center, a.q, b.q};
}

/// The slip at a contact point: how far B's material has moved relative to A's since the manifold was made, m. Its rate of change is their relative velocity.
inline Vec2 slip_of(const ContactManifold& m, std::uint32_t point, const Pose& a, const Pose& b) {
    const Vec2 ra = m.anchors[point];
    const Vec2 rb = ra - m.offset;
    return (b.center - a.center) + rotate(b.q * inverse(m.rotation_b), rb) - rotate(a.q * inverse(m.rotation_a), ra);
}

}  // namespace islet::detail
