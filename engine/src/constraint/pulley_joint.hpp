// Pulley joint: a rope from A's point over two fixed points to B's.
//
// With sa = xa + ra - ground_a, la = |sa|, ua = sa / la, and the same for b:
//     C = constant - la - ratio lb                            m
//     J = (-ua, -ra x ua, -ratio ub, -ratio rb x ub)
//     K = ma + ia (ra x ua)^2 + ratio^2 (mb + ib (rb x ub)^2)
//     q = -(arc of a) - ratio (arc of b), arc = -w^2 u . r + (|v|^2 - (u . v)^2) / l with v the point's velocity
// lambda > 0 is the rope's tension; it may push as well. Source: Catto's Box2D 2 (b2PulleyJoint) for the constraint.
#pragma once

#include "../calls/checks.hpp"
#include "../constraint/joint_rows.hpp"

namespace islet::detail {

/// One side of the rope.
template <std::uint32_t W>
struct RopeRows {
    float x[W], y[W];             // m, from the fixed point to the body's centre when the step began
    float px[W], py[W], turn[W];  // N s, N m s: impulse on the body as last applied
};

template <std::uint32_t W>
struct alignas(W * 4) PulleyRows {
    JointEnds<W> ends;  // dx, dy are not used
    RopeRows<W> a, b;
    float ratio[W], constant[W];  // constant: m
    float tension[W];             // N s
};

template <std::uint32_t W>
ISLET_SHARED void prepare(RopeRows<W>& r, std::uint32_t lane, SolverBody& body, Vec2 from_ground, Vec2 arm, float tension) {
    const Vec2 p = -tension * normalize(from_ground + arm);
    r.x[lane] = from_ground.x;
    r.y[lane] = from_ground.y;
    r.px[lane] = p.x;
    r.py[lane] = p.y;
    r.turn[lane] = cross(arm, p);
    add_warm_start(body, p, r.turn[lane]);
}

template <std::uint32_t W>
WarmStart prepare(PulleyRows<W>& r, std::uint32_t lane, const Joint& j, const JointPose& p, const JointInput& in) {
    const float tension = in.numbers.swept_warm * j.impulse.x;
    r.ratio[lane] = j.ratio;
    r.constant[lane] = j.length;
    r.tension[lane] = tension;
    prepare(r.a, lane, in.bodies[r.ends.body_a[lane]], in.poses[j.body_a].center - j.ground_a, p.ra, tension);
    prepare(r.b, lane, in.bodies[r.ends.body_b[lane]], in.poses[j.body_b].center - j.ground_b, p.rb, tension * j.ratio);
    return {};
}

/// One side of the rope and its body.
template <class L>
struct RopeSide {
    using F = typename L::F;
    LaneVec<F> v;
    F w, inv_mass, inv_inertia;
    LaneVec<F> r, u;
    F length, s, k, arc;
    LaneVec<F> p;  // applied so far
    F t;

    ISLET_LANE RopeSide(const SolverBody* bodies, const std::uint32_t* slots, LaneVec<F> arm, const RopeRows<L::width>& rows) {
        typename L::template Columns<8> b;
        L::template gather8<sizeof(SolverBody) / 4>(reinterpret_cast<const float*>(bodies), slots, b);
        v = {b[0], b[1]};
        w = b[2];
        inv_mass = b[3];
        inv_inertia = b[7];
        r = turn<L>(b[6], arm);
        const LaneVec<F> d = load<L>(rows.x, rows.y) + LaneVec<F>{b[4], b[5]} + r;
        length = L::sqrt(dot(d, d));
        const F inv = inverse_or_zero<L>(length);
        u = inv * d;
        s = cross(r, u);
        k = inv_mass + inv_inertia * s * s;
        const LaneVec<F> velocity = v + cross(w, r);
        const F along = dot(u, velocity);
        arc = inv * (dot(velocity, velocity) - along * along) - w * w * dot(u, r);
        p = load<L>(rows.px, rows.py);
        t = L::load(rows.turn);
    }
    ISLET_LANE void push(LaneVec<F> impulse, F angular) {
        p = p + impulse;
        t = t + angular;
        v = v + effect<L>(inv_mass, impulse);
        w = w + effect<L>(inv_inertia, angular);
    }
    /// Makes what was applied a pull along u as it is now.
    ISLET_LANE void aim(F pull) {
        const LaneVec<F> now = pull * u;
        push(now - p, cross(r, now) - t);
    }
    ISLET_LANE F speed() const { return dot(u, v) + s * w; }
    ISLET_LANE void store(RopeRows<L::width>& rows) const {
        detail::store<L>(rows.px, rows.py, p);
        L::store(rows.turn, t);
    }
};

template <class L>
ISLET_LANE_SHARED void solve(SolverBody* bodies, PulleyRows<L::width>& r, const JointSweep& n) {
    using F = typename L::F;
    RopeSide<L> a(bodies, r.ends.body_a, load<L>(r.ends.rax, r.ends.ray), r.a);
    RopeSide<L> b(bodies, r.ends.body_b, load<L>(r.ends.rbx, r.ends.rby), r.b);
    const F ratio = L::load(r.ratio);
    const F tension = L::load(r.tension);
    if (n.biased) {
        a.aim(-tension);
        b.aim(-(ratio * tension));
    }

    const F speed = -a.speed() - ratio * b.speed();
    const F c = L::load(r.constant) - a.length - ratio * b.length;
    const F residual = speed - curve<L>(a.arc + ratio * b.arc, n) + L::splat(n.soft.rate) * c;
    const F k = a.k + ratio * ratio * b.k;
    const F delta = rigid_delta<L>(n, k, residual, tension);
    L::store(r.tension, tension + delta);
    a.push((-delta) * a.u, -(a.s * delta));
    b.push((-(ratio * delta)) * b.u, -(ratio * b.s * delta));
    a.store(r.a);
    b.store(r.b);
    const F out_a[4] = {a.v.x, a.v.y, a.w, a.inv_mass};
    const F out_b[4] = {b.v.x, b.v.y, b.w, b.inv_mass};
    scatter_pushed<L, 0>(bodies, r.ends.body_a, r.ends.body_b, a.inv_mass, b.inv_mass, out_a, out_b);
}

template <std::uint32_t W>
void store(const PulleyRows<W>& r, std::uint32_t lane, Joint& j, const JointOutput&) {
    j.impulse = {r.tension[lane], 0};
    j.force_impulse = {r.b.px[lane], r.b.py[lane]};
    j.torque_impulse = 0;
}

/// Measures a pulley's constant. False, with the error recorded, if an end is too short to have a direction.
ISLET_SHARED bool measure_rope(const Core& core, Joint& j) {
    const auto end = [&](std::uint32_t body, Vec2 local, Vec2 ground) {
        return distance(transform_point({core.bodies[body].origin, core.poses[body].q}, local), ground);
    };
    const float a = end(j.body_a, j.local_a, j.ground_a), b = end(j.body_b, j.local_b, j.ground_b);
    j.length = a + j.ratio * b;
    return check(core, a >= linear_slop && b >= linear_slop, Error::out_of_range);
}

template <>
struct JointKind<JointType::pulley> : AnyJoint {
    static constexpr bool has_frames = false, has_ratio = true;

    static bool take(const Core& core, Joint& j, const PulleyJointDef& def) {
        j.ground_a = def.ground_a;
        j.ground_b = def.ground_b;
        j.ratio = def.ratio;
        return check_position(core, def.ground_a) && check_position(core, def.ground_b) && check_range(core, def.ratio, 0, max_ratio) &&
               check(core, def.ratio > 0, Error::out_of_range);
    }
    static const char* fault(const Joint& j) { return j.ratio > 0 && j.ratio <= max_ratio ? nullptr : "a joint's ratio is out of range"; }
    static JointKernel kernel(const Joint&) { return JointKernel::pulley; }
    static JointError error(const Core& core, const Joint& j, const JointPose& p) {
        const float a = length(core.poses[j.body_a].center + p.ra - j.ground_a);
        const float b = length(core.poses[j.body_b].center + p.rb - j.ground_b);
        return {abs(a + j.ratio * b - j.length), 0};
    }

    template <class Rows>
    static void add_rows(Rows& rows) {
        const Joint& j = rows.j;
        const Vec2 ua = normalize(rows.to.core.poses[j.body_a].center + rows.p.ra - j.ground_a);
        const Vec2 ub = normalize(rows.to.core.poses[j.body_b].center + rows.p.rb - j.ground_b);
        auto row = rows.none();
        rows.to.add_end(row, j.body_a, -ua, -cross(rows.p.ra, ua));
        rows.to.add_end(row, j.body_b, -j.ratio * ub, -j.ratio * cross(rows.p.rb, ub));
        rows.add_rigid(row, j.impulse.x);
    }
    /// The rope over two rings.
    template <class Pen>
    static void draw(const Pen& pen, const Joint& j) {
        pen.segment(pen.at.a, j.ground_a);
        pen.segment(j.ground_a, j.ground_b);
        pen.segment(j.ground_b, pen.at.b);
        pen.circle(j.ground_a, 0.5f * pen.size, {1, 0});
        pen.circle(j.ground_b, 0.5f * pen.size, {1, 0});
    }
    template <class Add>
    static void reach(Add&& add, const Joint& j, const JointPlace&) {
        add(j.ground_a);
        add(j.ground_b);
    }
};

}  // namespace islet::detail
