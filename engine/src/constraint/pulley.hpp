// Pulley joint: a rope from A's point over two fixed points to B's.
//
// With sa = xa + ra - ground_a, la = |sa|, ua = sa / la, and the same for b:
//     C = constant - la - ratio lb                            m
//     J = (-ua, -ra x ua, -ratio ub, -ratio rb x ub)
//     K = ma + ia (ra x ua)^2 + ratio^2 (mb + ib (rb x ub)^2)
//     q = -(arc of a) - ratio (arc of b), arc = -w^2 u . r + (|v|^2 - (u . v)^2) / l with v the point's velocity
// lambda > 0 is the rope's tension; it may push as well. Source: Catto's Box2D 2 (b2PulleyJoint) for the constraint.
#pragma once

#include "constraint/joint_rows.hpp"

namespace islet::detail {

template <std::uint32_t W>
struct alignas(W * 4) PulleyRows {
    JointEnds<W> ends;                 // dx, dy are not used
    float ax[W], ay[W], bx[W], by[W];  // m, from the fixed points to the bodies' centres when the step began
    float ratio[W], constant[W];       // constant: m
    float tension[W];                  // N s
    float pax[W], pay[W], pbx[W], pby[W], applied_a[W], applied_b[W];  // impulses on A and B as last applied
};

template <std::uint32_t W>
void prepare(PulleyRows<W>& r, std::uint32_t lane, const Joint& j, const JointPose& p, const JointInput& in) {
    const Vec2 a = in.poses[j.body_a].center - j.ground_a;
    const Vec2 b = in.poses[j.body_b].center - j.ground_b;
    r.ax[lane] = a.x;
    r.ay[lane] = a.y;
    r.bx[lane] = b.x;
    r.by[lane] = b.y;
    r.ratio[lane] = j.ratio;
    r.constant[lane] = j.length;
    r.tension[lane] = in.numbers.warm * j.impulse.x;
    const Vec2 pa = -r.tension[lane] * normalize(a + p.ra);
    const Vec2 pb = -(r.tension[lane] * j.ratio) * normalize(b + p.rb);
    r.pax[lane] = pa.x;
    r.pay[lane] = pa.y;
    r.pbx[lane] = pb.x;
    r.pby[lane] = pb.y;
    r.applied_a[lane] = cross(p.ra, pa);
    r.applied_b[lane] = cross(p.rb, pb);
    SolverBody& body_a = in.bodies[r.ends.body_a[lane]];
    SolverBody& body_b = in.bodies[r.ends.body_b[lane]];
    add_warm_start(body_a, pa, r.applied_a[lane]);
    add_warm_start(body_b, pb, r.applied_b[lane]);
}

/// One side of the rope.
template <class L>
struct RopeSide {
    using F = typename L::F;
    LaneVec<F> r, u;
    F length, s, k, arc;

    ISLET_LANE RopeSide(LaneVec<F> from_ground, LaneVec<F> way, LaneVec<F> arm, LaneVec<F> v, F w, F inv_mass, F inv_inertia) : r(arm) {
        const LaneVec<F> d = from_ground + way + r;
        length = L::sqrt(dot(d, d));
        const F inv = inverse_or_zero<L>(length);
        u = inv * d;
        s = cross(r, u);
        k = inv_mass + inv_inertia * s * s;
        const LaneVec<F> velocity = v + cross(w, r);
        const F along = dot(u, velocity);
        arc = inv * (dot(velocity, velocity) - along * along) - w * w * dot(u, r);
    }
};

template <class L>
ISLET_LANE void solve(SolverBody* bodies, PulleyRows<L::width>& r, const JointSweep& n) {
    using F = typename L::F;
    constexpr std::uint32_t words = sizeof(SolverBody) / 4;
    F a[8], b[8];
    L::template gather8<words>(reinterpret_cast<const float*>(bodies), r.ends.body_a, a);
    L::template gather8<words>(reinterpret_cast<const float*>(bodies), r.ends.body_b, b);
    const LaneVec<F> ra = turn<L>(a[6], load<L>(r.ends.rax, r.ends.ray));
    const LaneVec<F> rb = turn<L>(b[6], load<L>(r.ends.rbx, r.ends.rby));
    LaneVec<F> va = {a[0], a[1]}, vb = {b[0], b[1]};
    F wa = a[2], wb = b[2];
    const RopeSide<L> side_a(load<L>(r.ax, r.ay), {a[4], a[5]}, ra, va, wa, a[3], a[7]);
    const RopeSide<L> side_b(load<L>(r.bx, r.by), {b[4], b[5]}, rb, vb, wb, b[3], b[7]);
    const F ratio = L::load(r.ratio);
    LaneVec<F> applied_a = load<L>(r.pax, r.pay), applied_b = load<L>(r.pbx, r.pby);
    F turning_a = L::load(r.applied_a), turning_b = L::load(r.applied_b);
    const auto push = [&](LaneVec<F> pa, LaneVec<F> pb, F ta, F tb) {
        applied_a = applied_a + pa;
        applied_b = applied_b + pb;
        turning_a = turning_a + ta;
        turning_b = turning_b + tb;
        va = va + effect<L>(a[3], pa);
        vb = vb + effect<L>(b[3], pb);
        wa = wa + effect<L>(a[7], ta);
        wb = wb + effect<L>(b[7], tb);
    };

    F tension = L::load(r.tension);
    const LaneVec<F> pa = (-tension) * side_a.u, pb = (-(ratio * tension)) * side_b.u;
    if (n.biased) push(pa - applied_a, pb - applied_b, cross(ra, pa) - turning_a, cross(rb, pb) - turning_b);

    const F speed = -(dot(side_a.u, va) + side_a.s * wa) - ratio * (dot(side_b.u, vb) + side_b.s * wb);
    const F c = L::load(r.constant) - side_a.length - ratio * side_b.length;
    const F residual = speed - curve<L>(side_a.arc + ratio * side_b.arc, n) + L::splat(n.soft.rate) * c;
    const F k = side_a.k + ratio * ratio * side_b.k;
    const F delta = -(L::splat(n.omega * n.soft.mass_scale) * inverse_or_zero<L>(k) * residual) - L::splat(n.omega * n.soft.impulse_scale) * tension;
    tension = tension + delta;
    push((-delta) * side_a.u, (-(ratio * delta)) * side_b.u, -(side_a.s * delta), -(ratio * side_b.s * delta));
    store<L>(r.pax, r.pay, applied_a);
    store<L>(r.pbx, r.pby, applied_b);
    L::store(r.applied_a, turning_a);
    L::store(r.applied_b, turning_b);

    L::store(r.tension, tension);
    const F out_a[4] = {va.x, va.y, wa, a[3]};
    const F out_b[4] = {vb.x, vb.y, wb, b[3]};
    scatter_pushed<L>(reinterpret_cast<float*>(bodies), r.ends.body_a, r.ends.body_b, a[3], b[3], out_a, out_b);
}

template <std::uint32_t W>
void store(const PulleyRows<W>& r, std::uint32_t lane, Joint& j, const JointOutput&) {
    j.impulse = {r.tension[lane], 0};
    j.force_impulse = {r.pbx[lane], r.pby[lane]};
    j.torque_impulse = 0;
}

}  // namespace islet::detail
