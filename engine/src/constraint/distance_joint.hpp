// Distance joint: a rod, a rope, a telescope or a spring between a point of A and a point of B.
//
// With d = xb + rb - xa - ra and u = d / |d|:
//     x = |d|     J = (-u, -ra x u, u, rb x u)     m
//     K = ma + mb + ia (ra x u)^2 + ib (rb x u)^2
//     q = u . (wa^2 ra - wb^2 rb) + (|ddot|^2 - xdot^2) / |d|      second derivative from velocities alone
// A rod keeps C = x - length; otherwise x is free within spring, limits and motor. Points that coincide have no direction and are left alone.
// Source: as revolute_joint.hpp.
#pragma once

#include "../calls/checks.hpp"
#include "../constraint/coordinate.hpp"

namespace islet::detail {

template <std::uint32_t W>
struct alignas(W * 4) DistanceRows {
    JointEnds<W> ends;
    Applied<W> applied;
    float length[W];  // m
    float rigid[W];   // 1: a rod
    float rod[W];     // N s
    CoordinateRows<W> free;
};

inline constexpr float least_distance = 1.0e-6f;  // m; below, a distance has no direction

inline bool is_rod(const Joint& j) { return (coordinate_parts(j) & (part_spring | part_limit | part_motor)) == 0; }

template <std::uint32_t W>
WarmStart prepare(DistanceRows<W>& r, std::uint32_t lane, const Joint& j, const JointPose& p, const JointInput& in) {
    const Vec2 d = gap_of(p);
    const float x = length(d);
    const Vec2 u = x > least_distance ? Vec2{d.x / x, d.y / x} : Vec2{};
    const bool rigid = is_rod(j);
    r.length[lane] = j.length;
    r.rigid[lane] = rigid ? 1.0f : 0.0f;
    const float along = set_coordinate(r.free, lane, j, in);
    r.free.target[lane] = j.length;
    r.rod[lane] = rigid ? in.numbers.swept_warm * j.impulse.x : 0;
    return {(along + r.rod[lane]) * u, 0};
}

template <class L>
ISLET_LANE void solve(JointBodies<L>& s, const JointArms<L>& arms, DistanceRows<L::width>& r, const JointSweep& n) {
    using F = typename L::F;
    const LaneVec<F>&ra = arms.ra, &rb = arms.rb, &d = arms.d;
    const F zero = L::splat(0.0f);
    const F x = L::sqrt(dot(d, d));
    const F inv_x = select(x > L::splat(least_distance), L::splat(1.0f) / x, zero);
    const LaneVec<F> u = inv_x * d;
    const DirectionRow<L> along(s, u, ra, rb);
    const F k = select(inv_x > zero, along.k, zero);
    const F rod = L::load(r.rod);
    const LaneVec<F> total = (rod + coordinate_impulse<L>(r.free)) * u;
    aim<L>(s, n, total, cross(ra, total), cross(rb, total));

    const LaneVec<F> d_dot = s.point_velocity(ra, rb);
    const F x_dot = dot(u, d_dot);
    const F bend = dot(u, s.point_curvature(ra, rb)) + inv_x * (dot(d_dot, d_dot) - x_dot * x_dot);
    along.push(s, solve_motor_and_friction<L>(r.free, k, along.speed(s), n));
    along.push(s, solve_spring_and_limits<L>(r.free, x, k, along.speed(s), bend, n));

    const F residual = along.speed(s) + curve<L>(bend, n) + L::splat(n.soft.rate) * (x - L::load(r.length));
    const F delta = rigid_delta<L>(n, L::load(r.rigid) * k, residual, rod);
    L::store(r.rod, rod + delta);
    along.push(s, delta);
}

template <std::uint32_t W>
void store(const DistanceRows<W>& r, std::uint32_t lane, Joint& j, const JointOutput& out) {
    get_coordinate(r.free, lane, j, out);
    j.impulse = {r.rod[lane], 0};
    j.torque_impulse = 0;
}

template <>
struct JointKind<JointType::distance> : AnyJoint {
    static constexpr bool has_coordinate = true, has_length = true;

    static bool take(const Core& core, Joint& j, const DistanceJointDef& def) {
        fill_coordinate(j, def.spring, def.limit, def.motor);
        j.length = def.length;
        return check_range(core, def.length, linear_slop, max_position);
    }
    static const char* fault(const Joint& j) { return j.length >= linear_slop && j.length <= max_position ? nullptr : "a rod's length is out of range"; }
    static JointKernel kernel(const Joint&) { return JointKernel::distance; }
    static float coordinate(const Joint&, const JointPose& p) { return length(gap_of(p)); }
    static float speed(const JointPose& p, const JointMotion& m) { return dot(normalize(gap_of(p)), m.d_dot); }
    static JointError error(const Core&, const Joint& j, const JointPose& p) {
        const float x = length(gap_of(p));
        return {is_rod(j) ? abs(x - j.length) : beyond_limit(j, x), 0};
    }

    template <class Rows>
    static void add_rows(Rows& rows) {
        const Vec2 d = gap_of(rows.p);
        const float x = length(d);
        if (!(x > least_distance)) return;  // no direction
        const auto free = rows.along({d.x / x, d.y / x}, rows.p.ra);
        rows.motor_and_friction(free);
        rows.spring_and_limits(free, x, rows.j.length);
        if (is_rod(rows.j)) rows.add_rigid(free, rows.j.impulse.x);
    }
    /// A line from point to point, or with a spring a zigzag; limits are bars across it.
    template <class Pen>
    static void draw(const Pen& pen, const Joint& j) {
        if ((j.flags & joint_spring) != 0) {
            pen.zigzag(pen.at.a, pen.at.b);
        } else {
            pen.segment(pen.at.a, pen.at.b);
        }
        pen.limits_along(j, normalize(pen.at.b - pen.at.a));
    }
    template <class Add>
    static void reach(Add&& add, const Joint& j, const JointPlace& at) {
        reach_limits(add, j, at, normalize(at.b - at.a));
    }
};

}  // namespace islet::detail
