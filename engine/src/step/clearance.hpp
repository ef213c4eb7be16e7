// How far two shapes are apart whose contact has no points. While their bodies have moved by less, the narrow phase need not look at them again.
//
// A clearance holds for where the bodies stood when the contact was noted last (ContactManifold::offset, rotation_a, rotation_b). It is too small rather than
// too large. It spares work and changes nothing else, so it is in no image: a world that was restored knows none, and takes the same steps.
#pragma once

#include "../collide/manifold.hpp"
#include "../data/core.hpp"
#include "../math/inlining.hpp"
#include "../math/scalar.hpp"
#include "../shapes/shape_types.hpp"

namespace islet::detail {

// m by which rounding may hide a point: that of the shapes, and that of shapes far from where their bodies are placed.
inline float inexact_by(const Core& core, const ContactManifold& m, const Pose& a, const Pose& b) {
    const Vec2 of_a = core.bodies[m.body_a].local_center, of_b = core.bodies[m.body_b].local_center;
    return linear_slop + 1e-5f * (a.max_extent + b.max_extent + abs(of_a.x) + abs(of_a.y) + abs(of_b.x) + abs(of_b.y));
}

/// Notes what the narrow phase found, as the bodies stand in the contact.
ISLET_PART void note_clearance(Core& core, std::uint32_t contact, const Manifold& found) {
    if constexpr (max_lanes > 1)
        if (found.count == 0) core.clearances[contact] = found.clearance;
}

/// m that the two shapes of a contact without points are apart at least, as the bodies `a` and `b` stand now, if that is more than `margin`; else 0. (No point
/// has moved farther than its body's centre, and by what it turned about that.)
ISLET_PART float clearance_now(const Core& core, std::uint32_t contact, const Pose& a, const Pose& b, float margin) {
    const ContactManifold& m = core.manifolds[contact];
    if ((m.flags & contact_posed) == 0) return 0;  // it is new, or a body's centre of mass is elsewhere in it now
    const float noted = core.clearances[contact];
    if (!(noted > margin)) return 0;
    const auto chord = [](Rot turn) { return abs(turn.s) + abs(1 - turn.c); };
    const float turned = a.max_extent * chord(inv_mul(m.rotation_a, a.q)) + b.max_extent * chord(inv_mul(m.rotation_b, b.q));
    const float clearance = noted - length(b.center - a.center - m.offset) - turned;
    return clearance > margin ? clearance : 0;
}

/// Notes that a contact without points has none, as the bodies stand now: what the narrow phase would leave behind (step/contact_update.cpp).
ISLET_SHARED void note_apart(ContactManifold& m, const Pose& a, const Pose& b) {
    m.forget_points();
    m.forget_impulses();
    m.ids = 0;
    m.anchors[0] = m.anchors[1] = {0, 0};
    m.offset = b.center - a.center;
    m.rotation_a = a.q;
    m.rotation_b = b.q;
    m.normal = rotate(a.q, {0, 0});  // zeros with the same signs
    m.flags |= contact_posed;
}

/// True if shape A of a contact is a piece of a chain.
inline bool is_link(const Core& core, const Contact& c) { return kind_of(core.geometries[core.shapes[c.shape_a].geometry]) == ShapeKind::front; }

}  // namespace islet::detail
