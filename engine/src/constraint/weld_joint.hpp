// Weld joint: a frame of B stays on a frame of A.
//
//     C1, C2 = (xb + rb) - (xa + ra)     m
//     C3     = qb - qa                   rad
//     K      = [A, b; b^T, c]: A the point's K (joint_rows.hpp), b = (-ia ra.y - ib rb.y, ia ra.x + ib rb.x), c = ia + ib
// All three rows are solved as a block: scale K delta + G delta = -(scale Cdot + kick C + G lambda), row by row. A soft row is a SplitSpring (softness.hpp)
// with G = (1 - scale) k, where k is the mean of A's diagonal, or c. A rigid row has the joints' common softness: scale = 1, kick = rate,
// G = k impulse_scale / mass_scale.
#pragma once

#include "../constraint/joint_parts.hpp"
#include "../constraint/joint_rows.hpp"
#include "../constraint/softness.hpp"

namespace islet::detail {

template <std::uint32_t W>
struct alignas(W * 4) WeldRows {
    JointEnds<W> ends;
    Applied<W> applied;
    float angle[W];    // rad, when the step began
    float turning[W];  // N m s; the linear impulse is what is applied
    SpringRows<W> linear, angular;
    float held_x[W], held_y[W], held_turning[W];  // N s, N m s: (1 - late) `held`
};

ISLET_LANE_SHARED float give_of(const Softness& s) { return s.impulse_scale / max(s.mass_scale, 1.0e-12f); }

/// A row of the weld in this sweep.
template <class L>
struct WeldRow {
    using F = typename L::F;
    F scale, kick, give, early;  // early: 1 - late
    ISLET_LANE WeldRow(const SpringRows<L::width>& r, const JointSweep& n) {
        const F zero = L::splat(0.0f), one = L::splat(1.0f), stored = L::load(r.kick), late = L::load(r.late);
        const auto rigid = stored < zero;
        scale = L::load(r.scale);
        kick = select(rigid, L::splat(n.soft.rate), n.biased ? stored : late * stored);
        give = select(rigid, L::splat(give_of(n.soft)), one - scale);
        early = one - late;
    }
};

constexpr float point_reach = 2, angle_reach = 1;  // A's largest entry is up to twice the mean

/// Fills a lane, rigid where there is no frequency.
template <std::uint32_t W>
ISLET_SHARED void soften(SpringRows<W>& r, std::uint32_t lane, float hertz, float damping_ratio, float reach, const StepNumbers& n) {
    set_spring(r, lane, is_positive(hertz) ? split_spring(hertz, damping_ratio, reach, n.h, n.relaxes) : SplitSpring{-1, 1, 1});
}

template <std::uint32_t W>
WarmStart prepare(WeldRows<W>& r, std::uint32_t lane, const Joint& j, const JointPose& p, const JointInput& in) {
    r.angle[lane] = angle_of(p);
    const float crowd = crowd_of(j, in.poses, in.bodies_in);
    soften(r.linear, lane, j.linear_hertz, j.linear_damping_ratio, crowd * point_reach, in.numbers);
    soften(r.angular, lane, j.angular_hertz, j.angular_damping_ratio, crowd * angle_reach, in.numbers);
    r.turning[lane] = in.numbers.swept_warm * j.angular_impulse;
    return {in.numbers.swept_warm * j.impulse, r.turning[lane]};
}

template <class L>
ISLET_LANE void solve(JointBodies<L>& s, const JointArms<L>& arms, WeldRows<L::width>& r, const JointSweep& n) {
    using F = typename L::F;
    const LaneVec<F>&ra = arms.ra, &rb = arms.rb;
    const F t = L::load(r.turning);
    aim_arms<L>(s, n, cross(ra, s.p) + t, cross(rb, s.p) + t);

    const WeldRow<L> point(r.linear, n), turn(r.angular, n);
    const PointMass<F> k = point_mass<L>(s, ra, rb);
    const F k33 = s.ia + s.ib;
    const LaneVec<F> b = {-(s.ia * ra.y) - s.ib * rb.y, s.ia * ra.x + s.ib * rb.x};
    const F g = point.give * L::splat(0.5f) * (k.k11 + k.k22);
    const F g3 = turn.give * k33;

    const LaneVec<F> q = s.point_curvature(ra, rb);
    const LaneVec<F> speed = s.point_velocity(ra, rb) + LaneVec<F>{curve<L>(q.x, n), curve<L>(q.y, n)};
    LaneVec<F> held = {L::splat(0.0f), L::splat(0.0f)};
    F held_turning = L::splat(0.0f);
    if (!n.biased) {
        held = load<L>(r.held_x, r.held_y);
        held_turning = L::load(r.held_turning);
    }
    const LaneVec<F> r12 = point.scale * speed + point.kick * arms.d + g * (s.p - held);
    const F r3 = turn.scale * (s.wb - s.wa) + turn.kick * (L::load(r.angle) + s.dqb - s.dqa) + g3 * (t - held_turning);

    // The angle is eliminated. With s and s3 the scales: (s A + g - s s3 b b^T / (s3 k33 + g3)) delta = -(r12 - s b r3 / (s3 k33 + g3)).
    const F inv = inverse_or_zero<L>(turn.scale * k33 + g3);
    const LaneVec<F> e = inv * b, f = (point.scale * turn.scale) * b;
    const LaneVec<F> wanted =
        solve_2x2<L>(point.scale * k.k11 + g - f.x * e.x, point.scale * k.k12 - f.x * e.y, point.scale * k.k22 + g - f.y * e.y, r12 - (point.scale * r3) * e);
    const LaneVec<F> delta = {-(L::splat(n.omega) * wanted.x), -(L::splat(n.omega) * wanted.y)};
    const F delta3 = -(L::splat(n.omega) * (inv * (r3 - turn.scale * dot(b, wanted))));
    L::store(r.turning, t + delta3);
    s.push(delta, cross(ra, delta) + delta3, cross(rb, delta) + delta3);
    if (n.biased) {
        store<L>(r.held_x, r.held_y, point.early * s.p);
        L::store(r.held_turning, turn.early * (t + delta3));
    }
}

template <std::uint32_t W>
void store(const WeldRows<W>& r, std::uint32_t lane, Joint& j, const JointOutput&) {
    j.impulse = j.force_impulse;
    j.angular_impulse = j.torque_impulse = r.turning[lane];
}

template <>
struct JointKind<JointType::weld> : AnyJoint {
    static constexpr bool has_softness = true;

    static bool take(const Core&, Joint& j, const WeldJointDef& def) {
        fill_softness(j, def);
        return true;
    }
    static JointKernel kernel(const Joint&) { return JointKernel::weld; }
    static JointError error(const Core&, const Joint& j, const JointPose& p) {
        return {j.linear_hertz > 0 ? 0 : length(gap_of(p)), j.angular_hertz > 0 ? 0 : abs(angle_of(p))};
    }

    /// The softness of a spring in a row that is exported, where all of the damper acts before the move.
    template <class Rows>
    static Softness row_softness(const Rows& rows, float hertz, float damping_ratio, float reach) {
        const float crowd = crowd_of(rows.j, rows.to.core.poses, rows.to.core.bodies);
        return softness_of(split_spring(hertz, damping_ratio, crowd * reach, rows.to.h, false));
    }
    template <class Rows>
    static void add_rows(Rows& rows) {
        const Joint& j = rows.j;
        auto x = rows.along({1, 0}, rows.p.ra), y = rows.along({0, 1}, rows.p.ra);
        const bool soft_point = j.linear_hertz > 0, soft_angle = j.angular_hertz > 0;
        if (soft_point) {
            const Softness soft = row_softness(rows, j.linear_hertz, j.linear_damping_ratio, point_reach);
            const float k = 0.5f * (rows.to.coupling(x, x) + rows.to.coupling(y, y));
            rows.soften(x, soft, gap_of(rows.p).x, k);
            rows.soften(y, soft, gap_of(rows.p).y, k);
        }
        rows.add_unbounded(x, soft_point ? Rows::spring_row : Rows::joint_row, j.impulse.x);
        rows.add_unbounded(y, soft_point ? Rows::spring_row : Rows::joint_row, j.impulse.y);
        auto angle = rows.turning();
        if (soft_angle) {
            const Softness soft = row_softness(rows, j.angular_hertz, j.angular_damping_ratio, angle_reach);
            rows.soften(angle, soft, angle_of(rows.p), rows.to.coupling(angle, angle));
        }
        rows.add_unbounded(angle, soft_angle ? Rows::spring_row : Rows::joint_row, j.angular_impulse);
    }
    /// A square with its diagonals, fixed to A.
    template <class Pen>
    static void draw(const Pen& pen, const Joint&) {
        pen.square(pen.at.a, pen.at.qa, 0.5f * pen.size);
        const Vec2 x = 0.5f * pen.size * pen.direction(pen.at.qa), y = left_perp(x);
        pen.bar(pen.at.a, x + y);
        pen.bar(pen.at.a, x - y);
    }
};

}  // namespace islet::detail
