// Gear joint: couples the coordinates of two hinges or sliders.
//
//     C = (c1 + ratio c2) - constant        rad or m, as c1
// where for a hinge c = qb - qa with J = (0, -1, 0, 1), and for a slider c = u . d with J = (-u, -(d + ra) x u, u, rb x u) (prismatic_joint.hpp). So up to
// four bodies share the row, and one body may be in it twice, as the frame that carries both gears:
//     K = sum over the bodies of m |sum of u|^2 + i (sum of s)^2
// The Jacobian is taken at the start of the step. Gears are few and hold more than two bodies, so they are solved one by one, without a colour.
#pragma once

#include "../constraint/revolute_joint.hpp"
#include "../math/inlining.hpp"

namespace islet::detail {

template <std::uint32_t W>
struct GearRows {
    static_assert(W == 1, "gears are solved one by one");
    JointEnds<W> ends;         // only the joint is used
    std::uint32_t slots[4];    // A and B of joint 1, A and B of joint 2; 0 where a body came before
    float ux[4], uy[4], s[4];  // the row's entries for each
    float c;                   // m or rad, when the step began
    float mass;                // 1 / K
    float impulse;
};

/// A joint's coordinate when a step begins, and its row.
struct GearSide {
    float c;
    Vec2 u;  // 0 for a hinge
    float sa, sb;
};

ISLET_SHARED GearSide gear_side(const Joint& j, const JointPose& p) {
    if (j.joint_type() == JointType::revolute) return {JointKind<JointType::revolute>::coordinate(j, p), {0, 0}, 1, 1};
    const Vec2 u = {p.qa.c, p.qa.s};
    return {dot(u, gap_of(p)), u, cross(gap_of(p) + p.ra, u), cross(p.rb, u)};
}

/// Adds a body's entries to the row, to those that it has already if it came before.
ISLET_SHARED void add_entry(GearRows<1>& r, std::uint32_t i, std::uint32_t slot, Vec2 u, float s) {
    r.slots[i] = slot;
    for (std::uint32_t before = 0; before < i; ++before) {
        if (r.slots[before] != slot || slot == 0) continue;
        r.ux[before] += u.x;
        r.uy[before] += u.y;
        r.s[before] += s;
        r.slots[i] = 0;
        u = {0, 0};
        s = 0;
    }
    r.ux[i] = u.x;
    r.uy[i] = u.y;
    r.s[i] = s;
}

inline WarmStart prepare(GearRows<1>& r, std::uint32_t, const Joint& j, const JointPose&, const JointInput& in) {
    for (std::uint32_t side = 0; side < 2; ++side) {
        const Joint& geared = in.joints[side == 0 ? j.joint1 : j.joint2];
        const GearSide g = gear_side(geared, pose_of(geared, in.poses, in.bodies_in));
        const float ratio = side == 0 ? 1.0f : j.ratio;
        add_entry(r, 2 * side, in.slot_of[geared.body_a], -ratio * g.u, -ratio * g.sa);
        add_entry(r, 2 * side + 1, in.slot_of[geared.body_b], ratio * g.u, ratio * g.sb);
        r.c = side == 0 ? g.c : r.c + ratio * g.c - j.length;
    }
    r.impulse = in.numbers.swept_warm * j.impulse.x;
    float k = 0;
    for (std::uint32_t i = 0; i < 4; ++i) {
        const SolverBody& b = in.bodies[r.slots[i]];
        k += b.inv_mass * (r.ux[i] * r.ux[i] + r.uy[i] * r.uy[i]) + b.inv_inertia * r.s[i] * r.s[i];
    }
    r.mass = inverse_or_zero<Lane1>(k);
    for (std::uint32_t i = 0; i < 4; ++i) {
        SolverBody& b = in.bodies[r.slots[i]];
        if (!is_positive(b.inv_mass)) continue;  // only read: see scatter_pushed
        b.warm_v += (b.inv_mass * r.impulse) * Vec2{r.ux[i], r.uy[i]};
        b.warm_w += b.inv_inertia * r.impulse * r.s[i];
    }
    return {};
}

template <class L>
void solve(SolverBody* bodies, GearRows<1>& r, const JointSweep& n) {
    float speed = 0;
    float c = r.c;
    for (std::uint32_t i = 0; i < 4; ++i) {
        const SolverBody& b = bodies[r.slots[i]];
        const Vec2 u = {r.ux[i], r.uy[i]};
        speed += dot(u, b.v) + r.s[i] * b.w;
        c += dot(u, b.dp) + r.s[i] * b.dq;
    }
    const float delta = -(n.omega * n.soft.mass_scale * r.mass * (speed + n.soft.rate * c)) - n.omega * n.soft.impulse_scale * r.impulse;
    r.impulse += delta;
    for (std::uint32_t i = 0; i < 4; ++i) {
        SolverBody& b = bodies[r.slots[i]];
        if (!is_positive(b.inv_mass)) continue;
        b.v += effect<Lane1>(b.inv_mass, delta) * Vec2{r.ux[i], r.uy[i]};
        b.w += effect<Lane1>(b.inv_inertia, delta) * r.s[i];
    }
}

inline void store(const GearRows<1>& r, std::uint32_t, Joint& j, const JointOutput&) {
    j.impulse = {r.impulse, 0};
    j.force_impulse = {0, 0};
    j.torque_impulse = r.impulse;
}

template <std::uint32_t>
using LoneGearRows = GearRows<1>;

template <>
struct JointKind<JointType::gear> : AnyJoint {
    static constexpr bool has_frames = false, has_base = false, has_ratio = true;

    static const char* fault(const Joint& j) { return j.ratio != 0 && abs(j.ratio) <= max_ratio ? nullptr : "a joint's ratio is out of range"; }
    static JointKernel kernel(const Joint&) { return JointKernel::gear; }
    static JointError error(const Core& core, const Joint& j, const JointPose&) {
        const auto side = [&](std::uint32_t joint) { return gear_side(core.joints[joint], pose_of(core.joints[joint], core.poses, core.bodies)).c; };
        const float error = abs(side(j.joint1) + j.ratio * side(j.joint2) - j.length);
        const bool linear = core.joints[j.joint1].joint_type() == JointType::prismatic;
        return linear ? JointError{error, 0} : JointError{0, error};
    }

    template <class Rows>
    static void add_rows(Rows& rows) {
        auto row = rows.none();
        float ratio = 1;
        for (const std::uint32_t joint : {rows.j.joint1, rows.j.joint2}) {
            const Joint& geared = rows.to.core.joints[joint];
            const GearSide side = gear_side(geared, pose_of(geared, rows.to.core.poses, rows.to.core.bodies));
            rows.to.add_end(row, geared.body_a, -ratio * side.u, -ratio * side.sa);
            rows.to.add_end(row, geared.body_b, ratio * side.u, ratio * side.sb);
            ratio = rows.j.ratio;
        }
        rows.add_rigid(row, rows.j.impulse.x);
    }
    /// A toothed ring around B's point of each of its two joints, and dashes between them.
    template <class Pen>
    static void draw(const Pen& pen, const Joint&) {
        pen.toothed_ring(pen.at.a, pen.at.qa);
        pen.toothed_ring(pen.at.b, pen.at.qb);
        pen.dashes(pen.at.a, pen.at.b);
    }
};

}  // namespace islet::detail
