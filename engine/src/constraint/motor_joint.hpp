// Motor joint: drives B relative to A, to a velocity or softly to a pose, within a force and a torque.
//
//     C1, C2 = (xb + rb) - (xa + ra)     m,    Cdot - velocity,           |lambda| <= h max_force
//     C3     = qb - qa                   rad,  Cdot - angular velocity,   |lambda| <= h max_torque
//     K as in weld_joint.hpp, the point solved as a block, the angle apart.
// The mouse joint is the same with A's point in the world and no torque: see mouse_joint.hpp.
#pragma once

#include "../constraint/coordinate.hpp"

namespace islet::detail {

template <std::uint32_t W>
struct alignas(W * 4) DriveRows {
    JointEnds<W> ends;
    Applied<W> applied;
    float angle[W];                  // rad, when the step began
    float turning[W];                // N m s; the linear impulse is what is applied
    float vx[W], vy[W], spin[W];     // m/s in the world, rad/s
    float max_p[W], max_turning[W];  // N s, N m s over a substep
    float linear_rate[W], linear_mass_scale[W], linear_impulse_scale[W];
    float angular_rate[W], angular_mass_scale[W], angular_impulse_scale[W];
};

/// Softness of a drive: of its frequency, or, with none, of a rigid velocity.
ISLET_SHARED Softness drive_softness(float hertz, float damping_ratio, float h) { return is_positive(hertz) ? make_soft(hertz, damping_ratio, h) : Softness{}; }

template <std::uint32_t W>
WarmStart prepare(DriveRows<W>& r, std::uint32_t lane, const Joint& j, const JointPose& p, const JointInput& in) {
    const float h = in.numbers.h;
    const Softness linear = drive_softness(j.linear_hertz, j.linear_damping_ratio, h);
    const Softness angular = drive_softness(j.angular_hertz, j.angular_damping_ratio, h);
    r.angle[lane] = angle_of(p);
    r.linear_rate[lane] = linear.rate;
    r.linear_mass_scale[lane] = linear.mass_scale;
    r.linear_impulse_scale[lane] = linear.impulse_scale;
    r.angular_rate[lane] = angular.rate;
    r.angular_mass_scale[lane] = angular.mass_scale;
    r.angular_impulse_scale[lane] = angular.impulse_scale;
    const Vec2 velocity = rotate(p.qa, {within_bound(j.velocity.x), within_bound(j.velocity.y)});
    r.vx[lane] = velocity.x;
    r.vy[lane] = velocity.y;
    r.spin[lane] = within_bound(j.motor_speed);
    r.max_p[lane] = h * j.motor_max;
    r.max_turning[lane] = h * j.max_torque;
    r.turning[lane] = in.numbers.swept_warm * j.angular_impulse;
    return {in.numbers.swept_warm * j.impulse, r.turning[lane]};
}

template <class L>
ISLET_LANE void solve(JointBodies<L>& s, const JointArms<L>& arms, DriveRows<L::width>& r, const JointSweep& n) {
    using F = typename L::F;
    const LaneVec<F>&ra = arms.ra, &rb = arms.rb;
    const F t = L::load(r.turning);
    aim_arms<L>(s, n, cross(ra, s.p) + t, cross(rb, s.p) + t);

    const F zero = L::splat(0.0f), one = L::splat(1.0f), omega = L::splat(n.omega);
    {
        const F error = L::load(r.angle) + s.dqb - s.dqa;
        const F wanted = inverse_or_zero<L>(s.ia + s.ib) * (s.wb - s.wa - L::load(r.spin) + L::load(r.angular_rate) * error);
        const F bound = L::load(r.max_turning);
        const F free = t - omega * (L::load(r.angular_mass_scale) * wanted + L::load(r.angular_impulse_scale) * t);
        const F next = clamp_lanes<L>(free, -bound, bound);
        s.push_angular(next - t);
        L::store(r.turning, next);
    }
    const PointMass<F> k = point_mass<L>(s, ra, rb);
    const LaneVec<F> residual = s.point_velocity(ra, rb) - load<L>(r.vx, r.vy) + L::load(r.linear_rate) * arms.d;
    const LaneVec<F> wanted = solve_2x2<L>(k.k11, k.k12, k.k22, residual);
    const F mass_scale = omega * L::load(r.linear_mass_scale), impulse_scale = omega * L::load(r.linear_impulse_scale);
    LaneVec<F> next = {s.p.x - mass_scale * wanted.x - impulse_scale * s.p.x, s.p.y - mass_scale * wanted.y - impulse_scale * s.p.y};
    const F bound = L::load(r.max_p);
    const F size = L::sqrt(dot(next, next));
    next = select(size > bound, bound / select(size > zero, size, one), one) * next;
    const LaneVec<F> delta = next - s.p;
    s.push(delta, cross(ra, delta), cross(rb, delta));
}

template <std::uint32_t W>
void store(const DriveRows<W>& r, std::uint32_t lane, Joint& j, const JointOutput&) {
    j.impulse = j.force_impulse;
    j.angular_impulse = j.torque_impulse = r.turning[lane];
}

/// The rows of motor and mouse joints. The engine's softness of the point is a multiple of its K, a matrix: along K's principal axes it is diagonal. A
/// rigid drive has its first row along the impulse it gives, so that one that gives all it has is at the bound of that row alone, as the engine bounds the
/// impulse's length.
struct DriveJoint : AnyJoint {
    static constexpr bool has_softness = true, has_strength = true;

    static JointKernel kernel(const Joint&) { return JointKernel::drive; }

    template <class Rows>
    static void add_point_rows(Rows& rows) {
        const Joint& j = rows.j;
        const JointPose& p = rows.p;
        const Softness soft = drive_softness(j.linear_hertz, j.linear_damping_ratio, rows.to.h);
        const Vec2 velocity = rotate(p.qa, {within_bound(j.velocity.x), within_bound(j.velocity.y)});
        Vec2 e = normalize(j.impulse);
        if (j.linear_hertz > 0) {
            const auto x = rows.along({1, 0}, p.ra), y = rows.along({0, 1}, p.ra);
            const Rot axis = make_rot(0.5f * islet::atan2(2.0f * rows.to.coupling(x, y), rows.to.coupling(x, x) - rows.to.coupling(y, y)));
            e = {axis.c, axis.s};
        } else if (e == Vec2{}) {
            e = {1, 0};
        }
        for (const Vec2 axis : {e, left_perp(e)}) {
            auto row = rows.along(axis, p.ra);
            row.bias -= dot(axis, velocity);
            rows.soften(row, soft, dot(axis, gap_of(p)), rows.to.coupling(row, row));
            rows.add_within(row, Rows::motor_row, rows.to.h * j.motor_max, dot(axis, j.impulse));
        }
    }
};

template <>
struct JointKind<JointType::motor> : DriveJoint {
    static bool take(const Core&, Joint& j, const MotorJointDef& def) {
        fill_softness(j, def);
        j.velocity = def.linear_velocity;
        j.motor_speed = def.angular_velocity;
        j.motor_max = def.max_force;
        j.max_torque = def.max_torque;
        return true;
    }

    template <class Rows>
    static void add_rows(Rows& rows) {
        const Joint& j = rows.j;
        const Softness soft = drive_softness(j.angular_hertz, j.angular_damping_ratio, rows.to.h);
        auto row = rows.turning();
        row.bias -= within_bound(j.motor_speed);
        rows.soften(row, soft, angle_of(rows.p), rows.to.coupling(row, row));
        rows.add_within(row, Rows::motor_row, rows.to.h * j.max_torque, j.angular_impulse);
        add_point_rows(rows);
    }
    /// The two frames as corners, and an arrow from A's to B's.
    template <class Pen>
    static void draw(const Pen& pen, const Joint&) {
        pen.frame(pen.at.a, pen.at.qa);
        pen.frame(pen.at.b, pen.at.qb);
        pen.segment(pen.at.a, pen.at.b);
        const Vec2 back = -0.5f * pen.size * normalize(pen.at.b - pen.at.a), across = 0.5f * left_perp(back);
        pen.segment(pen.at.b, pen.at.b + back + across);
        pen.segment(pen.at.b, pen.at.b + back - across);
    }
};

}  // namespace islet::detail
