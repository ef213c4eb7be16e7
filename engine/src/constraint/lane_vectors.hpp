// The two bodies of a contact or joint as lanes: what the kernels are written in.
#pragma once

#include "../constraint/solver_body.hpp"
#include "../math/lane_vec.hpp"
#include "../math/scalar.hpp"

namespace islet::detail {

/// A vector given along n and along t = right_perp(n).
template <class F>
ISLET_LANE LaneVec<F> in_world(LaneVec<F> n, F along_n, F along_t) {
    return {n.x * along_n + n.y * along_t, n.y * along_n - n.x * along_t};
}

/// 1 / k, or 0 where k is not above 0.
template <class L>
ISLET_LANE_SHARED typename L::F inverse_or_zero(typename L::F k) {
    const typename L::F zero = L::splat(0.0f);
    return select(k > zero, L::splat(1.0f) / k, zero);
}

/// What an impulse does to a velocity: inverse mass times impulse, and nothing at all where the inverse mass is 0, even if the impulse has overflowed.
/// Static and kinematic bodies are shared by the joints of a colour, so not even 0 * inf may reach them.
template <class L>
ISLET_LANE typename L::F effect(typename L::F inv_mass, typename L::F impulse) {
    const typename L::F zero = L::splat(0.0f);
    return select(inv_mass > zero, inv_mass * impulse, zero);
}
template <class L>
ISLET_LANE LaneVec<typename L::F> effect(typename L::F inv_mass, LaneVec<typename L::F> impulse) {
    return {effect<L>(inv_mass, impulse.x), effect<L>(inv_mass, impulse.y)};
}

/// v turned by the angle d, |d| <= pi/2: by the series of sine and cosine, whose error is below 2e-4 there and 1e-9 up to 0.2 rad.
template <class L>
ISLET_LANE LaneVec<typename L::F> turn(typename L::F d, LaneVec<typename L::F> v) {
    using F = typename L::F;
    const F z = d * d;
    const F s = d * (L::splat(1.0f) - z * (L::splat(1.0f / 6) - z * (L::splat(1.0f / 120) - z * L::splat(1.0f / 5040))));
    const F c = L::splat(1.0f) - z * (L::splat(0.5f) - z * (L::splat(1.0f / 24) - z * L::splat(1.0f / 720)));
    return {c * v.x - s * v.y, s * v.x + c * v.y};
}

/// Writes four words back to each of two bodies, from the word `first` on. Those that cannot be pushed (`ma`, `mb`: inverse masses of 0) are only ever read:
/// constraints of one colour share them, and may be solved on several threads. The fourth word is as it was. `words`: how many one count of `body_a` and
/// `body_b` stands for.
template <class L, std::uint32_t first, std::uint32_t words = slot_words, class Slot>
ISLET_LANE void scatter_pushed(SolverBody* bodies, const Slot* body_a, const Slot* body_b, typename L::F ma, typename L::F mb, const typename L::F (&out_a)[4],
                               const typename L::F (&out_b)[4]) {
    float* const base = reinterpret_cast<float*>(bodies) + first;
    if constexpr (L::width == 1) {
        float* const a = base + std::size_t{words} * body_a[0];
        float* const b = base + std::size_t{words} * body_b[0];
        if (is_positive(ma)) a[0] = out_a[0], a[1] = out_a[1], a[2] = out_a[2];
        if (is_positive(mb)) b[0] = out_b[0], b[1] = out_b[1], b[2] = out_b[2];
    } else {
        const auto put = [&](const Slot* body, typename L::F inv_mass, const typename L::F(&out)[4]) ISLET_INLINED_LAMBDA {
            const std::uint32_t pushed = L::positive(inv_mass);
            if (pushed == (1u << L::width) - 1) {
                L::template scatter4<words>(base, body, out);
            } else if (pushed != 0) {
                L::template scatter4_where<words>(pushed, base, body, out);
            }
        };
        put(body_a, ma, out_a);
        put(body_b, mb, out_b);
    }
}

/// The two bodies of a block of contacts or joints. As in the papers, v and w are velocities, m and i inverse masses and inertias.
template <class L>
struct BodyPair {
    using F = typename L::F;
    LaneVec<F> va, vb;    // m/s
    F wa, wb;             // rad/s
    F ma, mb, ia, ib;     // 1/kg, 1/(kg m^2)
    LaneVec<F> dpa, dpb;  // m that the centre has gone since the step began
    F dqa, dqb;           // rad turned since the step began

    template <std::uint32_t words = slot_words, class Slot>
    ISLET_PART void gather(const SolverBody* bodies, const Slot* body_a, const Slot* body_b) {
        typename L::template Columns<8> a, b;
        L::template gather8<words>(reinterpret_cast<const float*>(bodies), body_a, a);
        L::template gather8<words>(reinterpret_cast<const float*>(bodies), body_b, b);
        va = {a[0], a[1]};
        vb = {b[0], b[1]};
        wa = a[2];
        wb = b[2];
        ma = a[3];
        mb = b[3];
        dpa = {a[4], a[5]};
        dpb = {b[4], b[5]};
        dqa = a[6];
        dqb = b[6];
        ia = a[7];
        ib = b[7];
    }
    /// Writes the velocities back.
    template <std::uint32_t words = slot_words, class Slot>
    ISLET_PART void scatter(SolverBody* bodies, const Slot* body_a, const Slot* body_b) const {
        const F out_a[4] = {va.x, va.y, wa, ma};
        const F out_b[4] = {vb.x, vb.y, wb, mb};
        scatter_pushed<L, 0, words>(bodies, body_a, body_b, ma, mb, out_a, out_b);
    }
    /// Gives bodies that cannot be pushed the velocities that they had before: if an impulse has overflowed, they may be NaN.
    ISLET_PART void keep_unpushed(const BodyPair& before) {
        const F zero = L::splat(0.0f);
        va = {select(ma > zero, va.x, before.va.x), select(ma > zero, va.y, before.va.y)};
        vb = {select(mb > zero, vb.x, before.vb.x), select(mb > zero, vb.y, before.vb.y)};
        wa = select(ma > zero, wa, before.wa);
        wb = select(mb > zero, wb, before.wb);
    }
    /// Adds what warm starting does to the velocities: an impulse on B and its opposite on A, and an angular impulse on each, A turned against its own. (Before
    /// the first substep the words of dp and dq hold warm_v and warm_w.)
    template <std::uint32_t words = slot_words, class Slot>
    ISLET_PART void add_warm_start(SolverBody* bodies, const Slot* body_a, const Slot* body_b, LaneVec<F> impulse, F turning_a, F turning_b) const {
        const LaneVec<F> warm_va = dpa - ma * impulse, warm_vb = dpb + mb * impulse;
        const F out_a[4] = {warm_va.x, warm_va.y, dqa - ia * turning_a, ia};
        const F out_b[4] = {warm_vb.x, warm_vb.y, dqb + ib * turning_b, ib};
        scatter_pushed<L, 4, words>(bodies, body_a, body_b, ma, mb, out_a, out_b);
    }
};

/// The two bodies of a block of joints, and what the joints have applied to them.
template <class L>
struct JointBodies : BodyPair<L> {
    using F = typename L::F;
    using BodyPair<L>::va, BodyPair<L>::vb, BodyPair<L>::wa, BodyPair<L>::wb, BodyPair<L>::ma, BodyPair<L>::mb, BodyPair<L>::ia, BodyPair<L>::ib;
    LaneVec<F> p;  // N s: what the joint has applied so far, p and tb to B, -p and -ta to A
    F ta, tb;      // N m s

    // For small builds: one copy each, that all kinds of joints call.
    ISLET_LANE void gather(const SolverBody* bodies, const std::uint32_t* body_a, const std::uint32_t* body_b) { BodyPair<L>::gather(bodies, body_a, body_b); }
    ISLET_LANE void scatter(SolverBody* bodies, const std::uint32_t* body_a, const std::uint32_t* body_b) const {
        BodyPair<L>::scatter(bodies, body_a, body_b);
    }

    /// An impulse on B and its opposite on A, and an angular impulse on each: B turned by its own, A against its own.
    ISLET_LANE void push(LaneVec<F> impulse, F angular_a, F angular_b) {
        va = va - effect<L>(ma, impulse);
        vb = vb + effect<L>(mb, impulse);
        p = p + impulse;
        push_angular(angular_a, angular_b);
    }
    ISLET_LANE void push_angular(F angular_a, F angular_b) {
        wa = wa - effect<L>(ia, angular_a);
        wb = wb + effect<L>(ib, angular_b);
        ta = ta + angular_a;
        tb = tb + angular_b;
    }
    ISLET_LANE void push_angular(F t) { push_angular(t, t); }
    /// Velocity of the point at rb on B, less that of the point at ra on A.
    ISLET_LANE LaneVec<F> point_velocity(LaneVec<F> ra, LaneVec<F> rb) const { return vb - va + cross(wb, rb) - cross(wa, ra); }
    /// How the two points' velocities turn: the part of their relative acceleration that velocities alone decide.
    ISLET_LANE LaneVec<F> point_curvature(LaneVec<F> ra, LaneVec<F> rb) const { return (wa * wa) * ra - (wb * wb) * rb; }
};

}  // namespace islet::detail
