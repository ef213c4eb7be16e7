// Revolute joint, a hinge: a point of B stays on a point of A.
//
//     C    = (xb + rb) - (xa + ra)                   m, two rows solved as a block
//     Cdot = vb + wb x rb - va - wa x ra             m/s
//     K    = point_mass in joint_rows.hpp            1/kg
// The coordinate left free is the angle of frame B in frame A, continuous past a full turn:
//     x    = qb - qa,  J = (-1, 1) on (wa, wb),  K = ia + ib
// Spring, limits, motor and friction act on it (coordinate.hpp). Source: Catto, "Iterative Dynamics with Temporal Coherence", GDC 2005.
#pragma once

#include "../constraint/coordinate.hpp"
#include "../math/inlining.hpp"

namespace islet::detail {

/// A hinge on which nothing acts. The impulse is what is applied.
template <std::uint32_t W>
struct alignas(W * 4) PointRows {
    JointEnds<W> ends;
    Applied<W> applied;
    float angle[W];  // rad, roughly, when the step began
};

template <std::uint32_t W>
struct alignas(W * 4) HingeRows {
    JointEnds<W> ends;
    Applied<W> applied;
    float angle[W];  // rad, when the step began
    CoordinateRows<W> free;
};

/// The angle of q to 0.08 rad, without a branch.
ISLET_SHARED float rough_angle(Rot q) {
    const float quarter = q.s / (abs(q.c) + abs(q.s));  // of a turn, from the x axis
    return 0.5f * pi * (q.c >= 0 ? quarter : (q.s < 0 ? -2.0f : 2.0f) - quarter);
}

/// The angle, roughly, continuous past full turns.
inline float rough_coordinate(const Joint& j, const JointPose& p) { return unwrap(rough_angle(inv_mul(p.qa, p.qb)), j.coordinate); }

template <std::uint32_t W>
WarmStart prepare(PointRows<W>& r, std::uint32_t lane, const Joint& j, const JointPose& p, const JointInput& in) {
    // Nothing here needs the angle, but full turns are counted for readers and gears: a rough one tells how many there were (5 % of a step of
    // 19 800 hinges; the exact one, 12 %).
    r.angle[lane] = rough_coordinate(j, p);
    return {in.numbers.swept_warm * j.impulse, 0};
}

template <std::uint32_t W>
WarmStart prepare(HingeRows<W>& r, std::uint32_t lane, const Joint& j, const JointPose& p, const JointInput& in) {
    r.angle[lane] = unwrap(angle_of(p), j.coordinate);
    const float turning = set_coordinate(r.free, lane, j, in);
    return {in.numbers.swept_warm * j.impulse, turning};
}

template <class L>
ISLET_LANE void solve(JointBodies<L>& s, const JointArms<L>& arms, PointRows<L::width>&, const JointSweep& n) {
    aim_arms<L>(s, n, cross(arms.ra, s.p), cross(arms.rb, s.p));
    solve_point<L>(s, arms.ra, arms.rb, arms.d, n);
}

template <class L>
ISLET_LANE void solve(JointBodies<L>& s, const JointArms<L>& arms, HingeRows<L::width>& r, const JointSweep& n) {
    using F = typename L::F;
    const F turning = coordinate_impulse<L>(r.free);
    aim_arms<L>(s, n, cross(arms.ra, s.p) + turning, cross(arms.rb, s.p) + turning);

    const F k = s.ia + s.ib;
    const F x = L::load(r.angle) + s.dqb - s.dqa;
    s.push_angular(solve_motor_and_friction<L>(r.free, k, s.wb - s.wa, n));
    s.push_angular(solve_spring_and_limits<L>(r.free, x, k, s.wb - s.wa, L::splat(0.0f), n));
    solve_point<L>(s, arms.ra, arms.rb, arms.d, n);
}

/// How far B turned in A within the step.
template <std::uint32_t W>
float turned_by(const JointEnds<W>& r, std::uint32_t lane, const JointOutput& out) {
    return out.solved[r.body_b[lane]].dq - out.solved[r.body_a[lane]].dq;
}

template <std::uint32_t W>
void store(const PointRows<W>& r, std::uint32_t lane, Joint& j, const JointOutput& out) {
    j.impulse = j.force_impulse;
    j.torque_impulse = 0;
    j.coordinate = r.angle[lane] + turned_by(r.ends, lane, out);
}

template <std::uint32_t W>
void store(const HingeRows<W>& r, std::uint32_t lane, Joint& j, const JointOutput& out) {
    j.impulse = j.force_impulse;
    get_coordinate(r.free, lane, j, out);
    j.torque_impulse = coordinate_impulse(j);
    j.coordinate = r.angle[lane] + turned_by(r.ends, lane, out);
}

template <>
struct JointKind<JointType::revolute> : AnyJoint {
    static constexpr bool has_coordinate = true, has_friction = true, counts_turns = true;

    static bool take(const Core&, Joint& j, const RevoluteJointDef& def) {
        fill_coordinate(j, def.spring, def.limit, def.motor);
        j.friction = def.friction;
        return true;
    }
    static JointKernel kernel(const Joint& j) { return coordinate_parts(j) == 0 ? JointKernel::point : JointKernel::hinge; }
    static float coordinate(const Joint& j, const JointPose& p) { return unwrap(angle_of(p), j.coordinate); }
    static float speed(const JointPose&, const JointMotion& m) { return m.wb - m.wa; }
    static JointError error(const Core&, const Joint& j, const JointPose& p) { return {length(gap_of(p)), beyond_limit(j, coordinate(j, p))}; }

    template <class Rows>
    static void add_rows(Rows& rows) {
        const auto free = rows.turning();
        rows.motor_and_friction(free);
        rows.spring_and_limits(free, coordinate(rows.j, rows.p), rows.j.target);
        rows.point();
    }
    /// A ring around A's point. With a limit, spring or motor a hand that turns with B, and the limits' directions in A.
    template <class Pen>
    static void draw(const Pen& pen, const Joint& j) {
        pen.circle(pen.at.a, 0.5f * pen.size, pen.direction(pen.at.qb));
        if (coordinate_parts(j) != 0) pen.segment(pen.at.a, pen.at.a + pen.size * pen.direction(pen.at.qb));
        pen.limits_around(j);
    }
};

}  // namespace islet::detail
