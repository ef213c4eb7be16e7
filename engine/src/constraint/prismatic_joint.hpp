// Prismatic joint, a slider: B's point stays on a line fixed in A, and B does not turn in A.
//
// With d = xb + rb - xa - ra from A's point to B's, u the line's direction and n = left_perp(u), both turning with A:
//     C1 = n . d         J = (-n, -(d + ra) x n, n, rb x n)      m
//     C2 = qb - qa       J = (0, -1, 0, 1)                       rad
// are solved as a block, K = [m + ia sa^2 + ib sb^2, ia sa + ib sb; ., ia + ib] with m = ma + mb, sa = (d + ra) x n, sb = rb x n. The coordinate
// left free is
//     x  = u . d         J = (-u, -(d + ra) x u, u, rb x u)      m
// Second derivatives from velocities alone: for a direction e fixed in A, q = e . (wa^2 ra - wb^2 rb) + 2 wa left_perp(e) . ddot - wa^2 e . d.
// Source: as revolute_joint.hpp.
#pragma once

#include "../constraint/coordinate.hpp"

namespace islet::detail {

template <std::uint32_t W>
struct alignas(W * 4) SliderRows {
    JointEnds<W> ends;
    Applied<W> applied;
    float ux[W], uy[W];           // the line's direction when the step began
    float angle[W];               // rad, when the step began
    float across[W], turning[W];  // N s, N m s
    CoordinateRows<W> free;
};

template <std::uint32_t W>
WarmStart prepare(SliderRows<W>& r, std::uint32_t lane, const Joint& j, const JointPose& p, const JointInput& in) {
    const Vec2 u = {p.qa.c, p.qa.s};
    const Vec2 n = left_perp(u);
    r.ux[lane] = u.x;
    r.uy[lane] = u.y;
    r.angle[lane] = angle_of(p);
    const float along = set_coordinate(r.free, lane, j, in);
    r.across[lane] = in.numbers.swept_warm * j.impulse.x;
    r.turning[lane] = in.numbers.swept_warm * j.angular_impulse;
    return {along * u + r.across[lane] * n, r.turning[lane]};
}

template <class L>
ISLET_LANE void solve(JointBodies<L>& s, const JointArms<L>& arms, SliderRows<L::width>& r, const JointSweep& n) {
    using F = typename L::F;
    const LaneVec<F> arm = arms.d + arms.ra;
    const LaneVec<F> u = turn<L>(s.dqa, load<L>(r.ux, r.uy));
    const DirectionRow<L> along(s, u, arm, arms.rb);
    const DirectionRow<L> across(s, left_perp(u), arm, arms.rb);
    F p1 = L::load(r.across), p2 = L::load(r.turning);
    const LaneVec<F> total = coordinate_impulse<L>(r.free) * along.e + p1 * across.e;
    aim<L>(s, n, total, cross(arm, total) + p2, cross(arms.rb, total) + p2);

    along.push(s, solve_motor_and_friction<L>(r.free, along.k, along.speed(s), n));
    along.push(s, solve_spring_and_limits<L>(r.free, dot(u, arms.d), along.k, along.speed(s), along.bend(s, arms), n));

    const F zero = L::splat(0.0f), rate = L::splat(n.soft.rate);
    const F k12 = s.ia * across.sa + s.ib * across.sb;
    const F k22 = select(s.ia + s.ib > zero, s.ia + s.ib, L::splat(1.0f));  // both bodies may be unable to turn
    const LaneVec<F> residual = {across.speed(s) + curve<L>(across.bend(s, arms), n) + rate * dot(across.e, arms.d),
                                 s.wb - s.wa + rate * (L::load(r.angle) + s.dqb - s.dqa)};
    const LaneVec<F> wanted = solve_2x2<L>(across.k, k12, k22, residual);
    const F mass_scale = L::splat(n.omega * n.soft.mass_scale), impulse_scale = L::splat(n.omega * n.soft.impulse_scale);
    const F delta1 = -(mass_scale * wanted.x) - impulse_scale * p1;
    const F delta2 = -(mass_scale * wanted.y) - impulse_scale * p2;
    L::store(r.across, p1 + delta1);
    L::store(r.turning, p2 + delta2);
    across.push(s, delta1);
    s.push_angular(delta2);
}

/// True if B's point was more than 5 cm off the line when the step began. (Telescopes that jut out under 200 times their mass and more come apart at their
/// rails. What their limits then bear, taken for a lasting load, threw them at 400 m/s.)
template <class Rows>
bool is_torn(const Rows& r, std::uint32_t lane) {
    const auto& e = r.ends;
    const Vec2 d = {e.dx[lane] + e.rbx[lane] - e.rax[lane], e.dy[lane] + e.rby[lane] - e.ray[lane]};
    return abs(cross({r.ux[lane], r.uy[lane]}, d)) > 10 * linear_slop;
}

template <std::uint32_t W>
void store(const SliderRows<W>& r, std::uint32_t lane, Joint& j, const JointOutput& out) {
    get_coordinate(r.free, lane, j, out, is_torn(r, lane));
    j.impulse = {r.across[lane], 0};
    j.angular_impulse = j.torque_impulse = r.turning[lane];
}

/// A slide along A's x axis: of prismatic and wheel joints.
struct LineJoint : AnyJoint {
    static constexpr bool has_coordinate = true, has_friction = true;

    template <class Def>
    static bool take(const Core&, Joint& j, const Def& def) {
        fill_coordinate(j, def.spring, def.limit, def.motor);
        j.friction = def.friction;
        return true;
    }
    static Vec2 axis(const JointPose& p) { return {p.qa.c, p.qa.s}; }
    static float coordinate(const Joint&, const JointPose& p) { return dot(axis(p), gap_of(p)); }
    static float speed(const JointPose& p, const JointMotion& m) { return dot(axis(p), m.d_dot) + m.wa * dot(left_perp(axis(p)), gap_of(p)); }
    static JointError error(const Core&, const Joint& j, const JointPose& p) {
        return {max(abs(dot(left_perp(axis(p)), gap_of(p))), beyond_limit(j, coordinate(j, p))), 0};
    }
    template <class Add>
    static void reach(Add&& add, const Joint& j, const JointPlace& at) {
        reach_limits(add, j, at, {at.qa.c, at.qa.s});
    }
};

template <>
struct JointKind<JointType::prismatic> : LineJoint {
    static JointKernel kernel(const Joint&) { return JointKernel::slider; }
    static JointError error(const Core& core, const Joint& j, const JointPose& p) { return {LineJoint::error(core, j, p).linear, abs(angle_of(p))}; }

    template <class Rows>
    static void add_rows(Rows& rows) {
        const Vec2 u = axis(rows.p);
        const auto free = rows.along_line(u);
        rows.motor_and_friction(free);
        rows.spring_and_limits(free, coordinate(rows.j, rows.p), rows.j.target);
        rows.add_rigid(rows.along_line(left_perp(u)), rows.j.impulse.x);
        rows.add_rigid(rows.turning(), rows.j.angular_impulse);
    }
    /// A rail along the axis and a square that slides on it with B; limits are bars across the rail. The rail reaches from limit to limit, or a little
    /// past what slides on it.
    template <class Pen>
    static void draw(const Pen& pen, const Joint& j) {
        const Vec2 u = pen.direction(pen.at.qa);
        const float x = dot(pen.at.b - pen.at.a, u);
        const bool limited = (j.flags & joint_limit) != 0;
        const float low = limited ? max(j.lower, -max_position) : min(0.0f, x) - 2 * pen.size;
        const float high = limited ? min(j.upper, max_position) : max(0.0f, x) + 2 * pen.size;
        pen.segment(pen.at.a + low * u, pen.at.a + high * u);
        pen.limits_along(j, u);
        pen.square(pen.at.b, pen.at.qa, 0.25f * pen.size);
    }
};

}  // namespace islet::detail
