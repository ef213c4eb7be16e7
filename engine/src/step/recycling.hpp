// If two bodies have hardly moved relative to each other since their contact's manifold was made, the contact keeps the manifold. (The idea of recycling
// contacts is that of Box2D 3.2, which credits the persistent manifolds of PhysX.) The measure here is how far the two surfaces have slipped at the contact
// points.
//
// A kept manifold keeps its normal and lever arms in the world; only its separations follow the bodies. This does more than save time. Over a few hundredths of
// a radian it leaves out the geometric stiffness of a loaded contact, which a Gauss-Seidel solver cannot balance in a few sweeps. With the exact geometry in
// each step, a column of 30 boxes buckles within ten seconds, as it does in Box2D 3.2 without recycling. The faces of moving bodies also keep their manifold
// while a load presses them into each other, because separations follow that motion exactly. Made anew for it, a column of 100 boxes takes up its own lean
// again and again as it settles, and falls. Faces of parts that lean on each other may slip further, if friction holds them: the cards of a house creep as it
// settles, and with the exact geometry they would not stop.
//
// But a normal that lags behind bodies which turn together holds them like a spring between them and the world: cargo would brake its swing, and no box would
// slide off a board before that has tilted by 0.1 rad. So where both bodies turn faster than a column leans, the manifold turns with them. What other
// bodies are at, too, as at the stones of an arch and the cards of a house, must turn faster for that.
#pragma once

#include "../collide/manifold.hpp"
#include "../data/core.hpp"
#include "../graph/contact_lanes.hpp"
#include "../math/inlining.hpp"
#include "../math/scalar.hpp"

namespace islet::detail {

inline constexpr float contact_load_rate = 0.07f;            // 1/s, at which the load of a contact follows the force that it bears
inline constexpr float worth_learning = 0.4f * linear_slop;  // m; a contact that would rise by less learns its load slowly
inline constexpr float learning_tilt = 0.01f;                // sine of the angle between gravity and the normal of a face that learns, at most
inline constexpr float learning_friction = 0.5f;             // its friction, as a share of its load, at most
inline constexpr float roll_rate = 0.05f;                    // rad/s of two bodies against each other from which on a round shape rolls
inline constexpr float most_roll = 0.1f;                     // rad in a step; faster things are not followed: bridges that roll at their banks would be thrown

// How the load of a contact follows the force that it bore in the last step. It is slow: a pile moves as if its contacts did not know their load. But when an
// island has come to rest (pose_learns), level faces, as those of columns and walls, learn their load at once. So a stack rises by most of what it has sunk by
// before it falls asleep. (Ten boxes then lie 0.01 m too low instead of 0.03, thirty 0.07 m instead of 0.29, and a brick wall of 20 rows 0.025 m. If tilted
// faces and corners learn too, a pile of 500 boxes slides into another one, and sleeps seconds later. Loads that are followed quickly in every step pump up the
// sway of a wall of 30 rows to 0.8 m/s, even if that is done in quiet islands only.)
struct LoadFollower {
    LoadRate rate;
    float force = 0;  // 1/s, what the impulses of the last substep come to
    float give = 0;   // s^2, by which a contact gives way: 1 / omega^2
    Vec2 gravity;     // m/s^2

    LoadFollower(const State& state, float dt) : gravity(state.gravity) {
        if (!(state.last_substep > 0)) return;
        const float share = min(contact_load_rate * dt, 1.0f);
        rate.keep = 1 - share;
        rate.gain = share / state.last_substep;
        force = 1.0f / state.last_substep;
        const float omega = 2.0f * pi * min(state.solver.contact_hertz, 0.125f * static_cast<float>(state.solver.substeps) / dt);
        give = 1.0f / (omega * omega);
    }
    void follow(ContactManifold& m) const {
        if ((m.flags & contact_special) != 0 || m.count() == 0) return;
        const float load = rate.keep * m.load + rate.gain * (m.normal_impulse[0] + m.normal_impulse[1]);
        m.load = load >= 0 && load < most_load ? load : 0;
    }
    // `inv_mass` (1/kg) is that of both bodies together.
    void learn(ContactManifold& m, float inv_mass) const {
        const float impulse = m.normal_impulse[0] + m.normal_impulse[1];
        if ((m.flags & contact_special) != 0 || m.count() != 2) return;
        if (!(abs(cross(m.normal, gravity)) < learning_tilt * abs(dot(m.normal, gravity)))) return;
        if (abs(m.tangent_impulse[0] + m.tangent_impulse[1]) > learning_friction * impulse) return;
        const float load = force * impulse;
        if (load < most_load && give * inv_mass * abs(load - m.load) > worth_learning) m.load = load;
    }
};

// True if one of the two bodies is not dynamic.
ISLET_SHARED bool has_floor(const Pose& a, const Pose& b) { return !(min(a.inv_mass, b.inv_mass) > 0); }

// True if the surfaces have slipped by less than `most` at the points of a contact that has `count` of them, 1 or 2.
ISLET_PART bool has_kept_points(const ContactManifold& m, const Pose& a, const Pose& b, std::uint32_t count, Rot turn_a, Rot turn_b, float most) {
    // As one body turns against the other, points that are not in the manifold may come near, by at most the smaller body's size times the turn. They were
    // apart by more than the speculative distance.
    const float turn = abs(turn_b.s * turn_a.c - turn_b.c * turn_a.s);
    const float size = min(a.max_extent, b.max_extent);
    const float reach = most - 2.0f * size * turn;
    if (reach <= 0) return false;
    // Faces of moving bodies that are pressed into each other do not slip: separations follow. (slip_of, with what both points share worked out once.)
    const Vec2 shift = b.center - a.center - rotate(turn_b, m.offset);
    const Rot apart = {turn_b.c - turn_a.c, turn_b.s - turn_a.s};
    for (std::uint32_t i = 0; i < count; ++i) {
        const Vec2 slip = shift + rotate(apart, m.anchors[i]);
        if (length_squared(slip) <= reach * reach) continue;
        const float sunk = clamp(dot(slip, m.normal), -0.5f * size, 0.0f);
        if (count != 2 || has_floor(a, b) || length_squared(slip) - sunk * sunk > reach * reach) return false;
    }
    return true;
}

// True if neither body has turned far since the manifold was made.
ISLET_PART bool have_turned_little(Rot turn_a, Rot turn_b) { return !(min(turn_a.c, turn_b.c) < 0 || max(abs(turn_a.s), abs(turn_b.s)) > recycle_turn); }

// True if the manifold may turn with two bodies that turn at these rates, rad/s, if it lags. `floor`: one of them is not dynamic.
ISLET_PART bool turn_together(float wa, float wb, bool floor) { return wa * wb > 0 && min(abs(wa), abs(wb)) > (floor ? turn_rate : level_turn_rate); }

// Turns the manifold, with all that it holds of how the bodies stood, as far as the bodies have turned together. (It then lags by half a step in the mean.
// Turned ahead by that much, it would keep the spin of two bodies that are pressed together; but pressed hard, they would gain spin.)
ISLET_SHARED void turn_along(const Core& core, ContactManifold& m, const Pose& a, const Pose& b) {
    const Rot turn = inv_mul(m.rotation_a, a.q);
    if (abs(turn.s) <= least_lag) return;
    const float wa = core.motions[m.body_a].w, wb = core.motions[m.body_b].w, slower = min(abs(wa), abs(wb));
    const bool floor = has_floor(a, b);
    if (!turn_together(wa, wb, floor)) return;
    const Vec2 gravity = core.state->gravity;
    const bool level =
        m.count() == 2 && m.sharers() == 1 && abs(cross(m.normal, gravity)) <= level_face * abs(dot(m.normal, gravity)) && abs(wa - wb) < turn_alike * slower;
    if (!floor && !level && !(slower > wedged_turn_rate)) return;
    const float p = m.normal_impulse[0], q = m.normal_impulse[1];
    const bool on_face = level && min(p, q) > bearing_share * max(p, q);
    const float pace = sqrt(length(gravity) / min(a.max_extent, b.max_extent));
    if (!floor && !on_face && !(slower > held_turn * pace) && is_between_others(core.bodies, m)) return;
    m.normal = rotate(turn, m.normal);
    m.normal = (1.5f - 0.5f * length_squared(m.normal)) * m.normal;  // a unit vector, however often it is turned
    m.offset = rotate(turn, m.offset);
    for (Vec2& anchor : m.anchors) anchor = rotate(turn, anchor);
    m.rotation_a = a.q;
    m.rotation_b = normalize(turn * m.rotation_b);
}

/// True if the manifold was made for where the bodies stood.
ISLET_PART bool may_recycle(const ContactManifold& m) { return (m.flags & (contact_posed | contact_ahead | contact_rolls)) == contact_posed; }

// True if two bodies whose contact has no points have not come so much nearer that it could get some: the bound of the relative motion of any two of their
// points stays well within the speculative distance.
ISLET_PART bool stay_apart(const ContactManifold& m, const Pose& a, const Pose& b, Rot turn_a, Rot turn_b) {
    const Vec2 shift = b.center - a.center - m.offset;
    const float reach = 0.5f * speculative_distance - a.max_extent * abs(turn_a.s) - b.max_extent * abs(turn_b.s);
    return reach > 0 && length_squared(shift) < reach * reach;
}

inline bool can_recycle(const Core& core, const ContactManifold& m, const Pose& a, const Pose& b) {
    if (!may_recycle(m)) return false;
    const Rot turn_a = inv_mul(m.rotation_a, a.q);
    const Rot turn_b = inv_mul(m.rotation_b, b.q);
    if (!have_turned_little(turn_a, turn_b)) return false;
    const std::uint32_t count = m.count();
    if (count == 0) return stay_apart(m, a, b, turn_a, turn_b);
    // With two points the manifold has all that there are; with one, others may come near.
    float most = recycle_distance;
    for (bool creeps = false;; creeps = true) {
        if (has_kept_points(m, a, b, count, turn_a, turn_b, most)) return true;
        const float rubs = abs(m.tangent_impulse[0] + m.tangent_impulse[1]), pressed = m.normal_impulse[0] + m.normal_impulse[1];
        if (creeps || count != 2 || has_floor(a, b) || !(rubs < sticking_share * m.friction * pressed) || !is_between_others(core.bodies, m)) return false;
        most = max(recycle_distance, min(most_creep, creep_share * min(a.max_extent, b.max_extent)));
    }
}

// True if nothing but how the bodies have moved can keep the contact from being settled.
ISLET_PART bool may_be_settled(const ContactManifold& m, const Pose& a, const Pose& b) {
    const std::uint32_t asked = m.flags & asked_flags, states = a.flags | b.flags;
    if (m.count() != 0) return asked == settled_flags && (states & pose_learns) == 0;
    return max_lanes > 1 && asked == apart_flags && (states & (pose_learns | pose_fast)) == 0;
}

// True if the contact is as before, and all that an update does is to keep its manifold, if the boxes of its shapes still meet. Of most contacts of a pile
// two tests tell that. (False says nothing; builds for one lane, which may be small, say it of more contacts.) `motions` are those of all bodies.
ISLET_PART bool is_settled(const Motion* motions, const ContactManifold& m, const Pose& a, const Pose& b) {
    if (!may_be_settled(m, a, b)) return false;
    const std::uint32_t count = m.count();
    const Rot turn_a = inv_mul(m.rotation_a, a.q), turn_b = inv_mul(m.rotation_b, b.q);
    if (!have_turned_little(turn_a, turn_b)) return false;
    if (count == 0) return stay_apart(m, a, b, turn_a, turn_b);
    if (abs(turn_a.s) > least_lag && (max_lanes == 1 || turn_together(motions[m.body_a].w, motions[m.body_b].w, has_floor(a, b)))) return false;
    return has_kept_points(m, a, b, count, turn_a, turn_b, recycle_distance);
}

}  // namespace islet::detail
