// Weld joint: a frame of B stays on a frame of A.
//
//     C1, C2 = (xb + rb) - (xa + ra)     m
//     C3     = qb - qa                   rad
//     K      = [A, b; b^T, c]: A the point's K (joint_rows.hpp), b = (-ia ra.y - ib rb.y, ia ra.x + ib rb.x), c = ia + ib
// All three rows are solved as a block. A soft row adds its compliance to the diagonal, (K + G) delta = -(Cdot + rate C + G lambda): the implicit
// spring of softness.hpp with G = K / a2, where K stands for the mean of A's diagonal, or c. Rigid rows have the joints' common softness.
#pragma once

#include "../constraint/joint_parts.hpp"
#include "../constraint/joint_rows.hpp"

namespace islet::detail {

template <std::uint32_t W>
struct alignas(W * 4) WeldRows {
    JointEnds<W> ends;
    Applied<W> applied;
    float angle[W];                                        // rad, when the step began
    float turning[W];                                      // N m s; the linear impulse is what is applied
    float linear_soft[W], linear_rate[W], linear_give[W];  // soft: 1 or 0; give: 1 / a2
    float angular_soft[W], angular_rate[W], angular_give[W];
};

ISLET_LANE_SHARED float give_of(const Softness& s) { return s.impulse_scale / max(s.mass_scale, 1.0e-12f); }

template <std::uint32_t W>
WarmStart prepare(WeldRows<W>& r, std::uint32_t lane, const Joint& j, const JointPose& p, const JointInput& in) {
    r.angle[lane] = angle_of(p);
    const Softness linear = make_soft(j.linear_hertz, j.linear_damping_ratio, in.numbers.h);
    const Softness angular = make_soft(j.angular_hertz, j.angular_damping_ratio, in.numbers.h);
    r.linear_soft[lane] = is_positive(j.linear_hertz) ? 1.0f : 0.0f;
    r.linear_rate[lane] = linear.rate;
    r.linear_give[lane] = give_of(linear);
    r.angular_soft[lane] = is_positive(j.angular_hertz) ? 1.0f : 0.0f;
    r.angular_rate[lane] = angular.rate;
    r.angular_give[lane] = give_of(angular);
    r.turning[lane] = in.numbers.warm * j.angular_impulse;
    return {in.numbers.warm * j.impulse, r.turning[lane]};
}

template <class L>
ISLET_LANE void solve(JointBodies<L>& s, const JointArms<L>& arms, WeldRows<L::width>& r, const JointSweep& n) {
    using F = typename L::F;
    const LaneVec<F>&ra = arms.ra, &rb = arms.rb;
    const F t = L::load(r.turning);
    aim_arms<L>(s, n, cross(ra, s.p) + t, cross(rb, s.p) + t);

    const F zero = L::splat(0.0f);
    const F rate = L::splat(n.soft.rate), give = L::splat(give_of(n.soft));
    const auto soft = L::load(r.linear_soft) > zero, springy = L::load(r.angular_soft) > zero;
    const PointMass<F> k = point_mass<L>(s, ra, rb);
    const F k33 = s.ia + s.ib;
    const LaneVec<F> b = {-(s.ia * ra.y) - s.ib * rb.y, s.ia * ra.x + s.ib * rb.x};
    const F g = select(soft, L::load(r.linear_give), give) * L::splat(0.5f) * (k.k11 + k.k22);
    const F g3 = select(springy, L::load(r.angular_give), give) * k33;

    const LaneVec<F> q = s.point_curvature(ra, rb);
    const LaneVec<F> speed = s.point_velocity(ra, rb) + LaneVec<F>{curve<L>(q.x, n), curve<L>(q.y, n)};
    const LaneVec<F> r12 = speed + select(soft, L::load(r.linear_rate), rate) * arms.d + g * s.p;
    const F r3 = s.wb - s.wa + select(springy, L::load(r.angular_rate), rate) * (L::load(r.angle) + s.dqb - s.dqa) + g3 * t;

    // The angle is eliminated: (A + g - b b^T / (k33 + g3)) delta = -(r12 - b r3 / (k33 + g3)).
    const F inv = inverse_or_zero<L>(k33 + g3);
    const LaneVec<F> e = inv * b;
    const LaneVec<F> wanted = solve_2x2<L>(k.k11 + g - b.x * e.x, k.k12 - b.x * e.y, k.k22 + g - b.y * e.y, r12 - r3 * e);
    const LaneVec<F> delta = {-(L::splat(n.omega) * wanted.x), -(L::splat(n.omega) * wanted.y)};
    const F delta3 = -(L::splat(n.omega) * (inv * (r3 - dot(b, wanted))));
    L::store(r.turning, t + delta3);
    s.push(delta, cross(ra, delta) + delta3, cross(rb, delta) + delta3);
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

    template <class Rows>
    static void add_rows(Rows& rows) {
        const Joint& j = rows.j;
        auto x = rows.along({1, 0}, rows.p.ra), y = rows.along({0, 1}, rows.p.ra);
        const bool soft_point = j.linear_hertz > 0, soft_angle = j.angular_hertz > 0;
        if (soft_point) {
            const Softness soft = make_soft(j.linear_hertz, j.linear_damping_ratio, rows.to.h);
            const float k = 0.5f * (rows.to.coupling(x, x) + rows.to.coupling(y, y));
            rows.soften(x, soft, gap_of(rows.p).x, k);
            rows.soften(y, soft, gap_of(rows.p).y, k);
        }
        rows.add_unbounded(x, soft_point ? Rows::spring_row : Rows::joint_row, j.impulse.x);
        rows.add_unbounded(y, soft_point ? Rows::spring_row : Rows::joint_row, j.impulse.y);
        auto angle = rows.turning();
        if (soft_angle) rows.soften(angle, make_soft(j.angular_hertz, j.angular_damping_ratio, rows.to.h), angle_of(rows.p), rows.to.coupling(angle, angle));
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
