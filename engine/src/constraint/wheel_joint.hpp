// Wheel joint: B's point stays on a line fixed in A, sprung along it; B turns freely, or by a motor.
//
// With d, u and n as in prismatic_joint.hpp:
//     C = n . d     J = (-n, -(d + ra) x n, n, rb x n)      m, one row
//     x = u . d     the strut: spring and limits            m
//     y = qb - qa   J = (0, -1, 0, 1): motor and friction   rad
// Source: Box2D's wheel joint for what it offers; the rows are those of revolute_joint.hpp and prismatic_joint.hpp.
#pragma once

#include "../constraint/prismatic_joint.hpp"

namespace islet::detail {

template <std::uint32_t W>
struct alignas(W * 4) WheelRows {
    JointEnds<W> ends;
    Applied<W> applied;
    float ux[W], uy[W];      // the line's direction when the step began
    float across[W];         // N s
    CoordinateRows<W> free;  // spring and limits of the strut, motor and friction of the wheel
};

template <std::uint32_t W>
WarmStart prepare(WheelRows<W>& r, std::uint32_t lane, const Joint& j, const JointPose& p, const JointInput& in) {
    const Vec2 u = {p.qa.c, p.qa.s};
    r.ux[lane] = u.x;
    r.uy[lane] = u.y;
    set_coordinate(r.free, lane, j, in);
    r.across[lane] = in.numbers.swept_warm * j.impulse.x;
    const float along = r.free.spring[lane] + r.free.low[lane] - r.free.high[lane];
    const float turning = r.free.motor[lane] + r.free.friction[lane];
    return {along * u + r.across[lane] * left_perp(u), turning};
}

template <class L>
ISLET_LANE void solve(JointBodies<L>& s, const JointArms<L>& arms, WheelRows<L::width>& r, const JointSweep& n) {
    using F = typename L::F;
    const LaneVec<F> arm = arms.d + arms.ra;
    const LaneVec<F> u = turn<L>(s.dqa, load<L>(r.ux, r.uy));
    const DirectionRow<L> along(s, u, arm, arms.rb);
    const DirectionRow<L> across(s, left_perp(u), arm, arms.rb);
    const F p = L::load(r.across);
    const F strut = L::load(r.free.spring) + L::load(r.free.low) - L::load(r.free.high);
    const F turning = L::load(r.free.motor) + L::load(r.free.friction);
    const LaneVec<F> total = strut * along.e + p * across.e;
    aim<L>(s, n, total, cross(arm, total) + turning, cross(arms.rb, total) + turning);

    s.push_angular(solve_motor_and_friction<L>(r.free, s.ia + s.ib, s.wb - s.wa, n));
    along.push(s, solve_spring_and_limits<L>(r.free, dot(u, arms.d), along.k, along.speed(s), along.bend(s, arms), n));

    const F residual = across.speed(s) + curve<L>(across.bend(s, arms), n) + L::splat(n.soft.rate) * dot(across.e, arms.d);
    const F delta = rigid_delta<L>(n, across.k, residual, p);
    L::store(r.across, p + delta);
    across.push(s, delta);
}

template <std::uint32_t W>
void store(const WheelRows<W>& r, std::uint32_t lane, Joint& j, const JointOutput& out) {
    get_coordinate(r.free, lane, j, out, is_torn(r, lane));
    j.impulse = {r.across[lane], 0};
    j.torque_impulse = r.free.motor[lane] + r.free.friction[lane];
}

template <>
struct JointKind<JointType::wheel> : LineJoint {
    static JointKernel kernel(const Joint&) { return JointKernel::wheel; }

    template <class Rows>
    static void add_rows(Rows& rows) {
        const Vec2 u = axis(rows.p);
        rows.motor_and_friction(rows.turning());
        rows.spring_and_limits(rows.along_line(u), coordinate(rows.j, rows.p), rows.j.target);
        rows.add_rigid(rows.along_line(left_perp(u)), rows.j.impulse.x);
    }
    /// A zigzag from A's to B's point, a ring with spokes that turns with B; limits are bars across the axis.
    template <class Pen>
    static void draw(const Pen& pen, const Joint& j) {
        pen.zigzag(pen.at.a, pen.at.b);
        pen.limits_along(j, pen.direction(pen.at.qa));
        const Vec2 spoke = pen.size * pen.direction(pen.at.qb);
        pen.circle(pen.at.b, pen.size, pen.direction(pen.at.qb));
        pen.bar(pen.at.b, spoke);
        pen.bar(pen.at.b, left_perp(spoke));
    }
};

}  // namespace islet::detail
