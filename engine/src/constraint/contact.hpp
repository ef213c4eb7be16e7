// The projected Gauss-Seidel kernel for contacts, written once over lanes.
//
// Solving a row: residual -> delta -> clamp the accumulated impulse -> apply. For the normal row of a point, with relative velocity vn,
//     delta  = -m (mass_scale vn + bias) - impulse_scale lambda,     lambda' = max(lambda + delta, 0)
// and for its tangent row, with the normal impulse just found,
//     delta  = -m (vt - surface speed),                              lambda' = clamp(lambda + delta, -mu lambda_n, mu lambda_n).
// mass_scale and impulse_scale make the contact soft: a spring and damper integrated implicitly (Catto, "Soft Constraints", GDC 2011; the
// substeps with a relaxing sweep follow Catto, "Solver2D", 2024, and Macklin and others, "Small Steps in Physics Simulation", 2019).
//
// Velocities of the two bodies are projected onto the contact's frame once and updated there row by row; the bodies get the summed impulse.
#pragma once

#include "../constraint/contact_rows.hpp"
#include "../constraint/lane_vectors.hpp"
#include "../math/lanes.hpp"
#include "../math/scalar.hpp"

namespace islet::detail {

inline constexpr std::uint32_t manifold_words = sizeof(ContactManifold) / 4;
inline constexpr std::uint32_t body_words = sizeof(SolverBody) / 4;
inline constexpr std::uint32_t restitution_passes = 6;
inline constexpr std::uint32_t motion_words = sizeof(SolverMotion) / 4;

/// Where prepare finds its inputs.
struct PrepareInput {
    const ContactManifold* manifolds;
    const Pose* poses;
    const std::uint32_t* slot_of;  // solver slot of a body
    SolverBody* bodies;
    const SolverMotion* motions;
    StepNumbers numbers;
};

template <class L>
struct ContactKernel {
    static constexpr std::uint32_t W = L::width;
    using F = typename L::F;
    using Rows = ContactRows<W>;

    /// Fills the rows of blocks whose `contact` entries are given, and adds the warm start velocity to the bodies' dp and dq. The material of special
    /// and bouncy contacts is filled in by the caller beforehand.
    static void prepare(const PrepareInput& in, Rows* rows, std::uint32_t count);
    /// One sweep.
    static void solve(SolverBody* bodies, Rows* rows, std::uint32_t count, const SweepNumbers& numbers);
    /// Gives bouncing contacts their rebound speed.
    static void restitute(SolverBody* bodies, Rows* rows, std::uint32_t count, float threshold);
    /// Writes the impulses back for the next step.
    static void store(ContactManifold* manifolds, const Rows* rows, std::uint32_t count);

private:
    /// Magnitude of the sum of a contact's impulses. It is not finite if any of them is not.
    static F size_of(const Rows& r);
};

template <class L>
void ContactKernel<L>::prepare(const PrepareInput& in, Rows* rows, std::uint32_t count) {
    const float* manifolds = reinterpret_cast<const float*>(in.manifolds);
    const float* poses = reinterpret_cast<const float*>(in.poses);
    const float* motions = reinterpret_cast<const float*>(in.motions);
    float* bodies = reinterpret_cast<float*>(in.bodies);
    const F zero = L::splat(0.0f);
    const F one = L::splat(1.0f);
    const F omega = L::splat(in.numbers.omega);
    const F warm = L::splat(in.numbers.warm);
    const F tiny = L::splat(1.0e-9f);
    const F dt_step = L::splat(in.numbers.dt);

    for (std::uint32_t block = 0; block < count; ++block) {
        Rows& r = rows[block];
        // Whole words first: who, and which lanes are live. A padded lane reads the first lane's contact and acts on slot 0 with no impulse.
        std::uint32_t contact[W], pose_a[W], pose_b[W];
        float live[W], second[W];
        r.two_points = r.special = r.bouncy = false;
        for (std::uint32_t i = 0; i < W; ++i) {
            // The next block's manifolds may be anywhere in memory.
            if (W > 1 && block + 1 < count && rows[block + 1].contact[i] != null_index) {
                const ContactManifold& soon = in.manifolds[rows[block + 1].contact[i]];
                __builtin_prefetch(&soon);
                __builtin_prefetch(&soon.rolling_impulse);
            }
            const bool is_live = W == 1 || r.contact[i] != null_index;  // single rows need no padding
            contact[i] = is_live ? r.contact[i] : r.contact[0];
            const ContactManifold& m = in.manifolds[contact[i]];
            pose_a[i] = m.body_a;
            pose_b[i] = m.body_b;
            r.body_a[i] = is_live ? in.slot_of[m.body_a] : 0;
            r.body_b[i] = is_live ? in.slot_of[m.body_b] : 0;
            live[i] = is_live ? 1.0f : 0.0f;
            second[i] = is_live && m.count() == 2 ? 1.0f : 0.0f;
            r.two_points |= second[i] != 0;
            r.special |= is_live && (m.flags & contact_special) != 0;
            r.bouncy |= is_live && (m.flags & (contact_bouncy | contact_hits)) != 0;
        }

        F m1[8], m2[8], m3[4];  // normal, offset, rotations | anchors, impulses | rolling impulse, separations, friction
        L::template gather8<manifold_words>(manifolds + 4, contact, m1);
        L::template gather8<manifold_words>(manifolds + 12, contact, m2);
        L::template gather4<manifold_words>(manifolds + 20, contact, m3);
        F pa[4], pb[4];  // centre, rotation
        L::template gather4<8>(poses, pose_a, pa);
        L::template gather4<8>(poses, pose_b, pb);
        F a[8], b[8];
        L::template gather8<body_words>(bodies, r.body_a, a);
        L::template gather8<body_words>(bodies, r.body_b, b);

        // How far the centres moved apart along the normal since the manifold was made, and how far each body has turned.
        const F nx = m1[0], ny = m1[1];
        const F moved = nx * ((pb[0] - pa[0]) - m1[2]) + ny * ((pb[1] - pa[1]) - m1[3]);
        const F ca = m1[4] * pa[2] + m1[5] * pa[3] - one, sa = m1[4] * pa[3] - m1[5] * pa[2];
        const F cb = m1[6] * pb[2] + m1[7] * pb[3] - one, sb = m1[6] * pb[3] - m1[7] * pb[2];
        const F dn = zero - (nx * m1[2] + ny * m1[3]), dt = zero - (ny * m1[2] - nx * m1[3]);
        L::store(r.nx, nx);
        L::store(r.ny, ny);
        L::store(r.friction, m3[3]);
        L::store(r.dn, dn);
        L::store(r.dt, dt);

        const F dvn = nx * (b[0] - a[0]) + ny * (b[1] - a[1]);
        const F mass = a[3] + b[3];
        F gain = zero;  // m/s^2, of the normal velocity
        if (r.is_bouncy()) {
            F ga[8], gb[8];
            L::template gather8<motion_words>(motions, r.body_a, ga);
            L::template gather8<motion_words>(motions, r.body_b, gb);
            gain = (nx * (gb[4] - ga[4]) + ny * (gb[5] - ga[5])) * L::splat(in.numbers.inv_h);
        }
        const F fastest = L::splat(-2.0f * in.numbers.max_speed);  // m/s, that two bodies can meet at, whatever pulls at them

        F sum_n = zero, sum_t = zero, wa = zero, wb = zero;
        const std::uint32_t points = r.two_points ? 2 : 1;
        for (std::uint32_t i = 0; i < points; ++i) {
            typename Rows::Point& p = r.points[i];
            const F on = L::load(i == 0 ? live : second);
            const F ax = m2[2 * i], ay = m2[2 * i + 1];
            const F an = nx * ax + ny * ay, at = ny * ax - nx * ay;
            const F bn = an + dn, bt = at + dt;
            const F turned = (cb * bn + sb * bt) - (ca * an + sa * at);
            L::store(p.an, an);
            L::store(p.at, at);
            L::store(p.separation, m3[1 + i] + moved + turned);

            const F kn = mass + a[7] * at * at + b[7] * bt * bt;
            const F kt = mass + a[7] * an * an + b[7] * bn * bn;
            const F usable = on * omega;
            L::store(p.normal_mass, select(kn > zero, usable / kn, zero));
            L::store(p.tangent_mass, select(kt > zero, usable / kt, zero));

            const F ln = on * warm * m2[4 + i], lt = on * warm * m2[6 + i];
            L::store(p.normal_impulse, ln);
            L::store(p.tangent_impulse, lt);
            sum_n = sum_n + ln;
            sum_t = sum_t + lt;
            wa = wa + (at * ln - an * lt);
            wb = wb + (bt * ln - bn * lt);
            if (r.is_bouncy()) {
                // The normal velocity at the moment the surfaces will meet, gravity and forces included until then.
                const F now = dvn + b[2] * bt - a[2] * at;
                const F gap = max(m3[1 + i] + moved + turned, zero);
                const F time = select(now < zero, min(gap / max(zero - now, tiny), dt_step), zero);
                const F meeting = now + time * gain;
                L::store(r.approach[i], select(meeting < fastest, fastest, meeting));
                L::store(r.peak[i], zero);
            }
        }
        if (r.is_special()) {
            // A contact without rolling resistance has no rolling impulse, though a neighbour in its block may have one, or it had one a step ago.
            const F k = a[7] + b[7];
            const auto rolls = L::load(r.rolling_resistance) > zero;
            L::store(r.rolling_mass, select(k > zero, omega / k, zero));
            const F rolling = select(rolls, warm * m3[0], zero);
            L::store(r.rolling_impulse, rolling);
            wa = wa + rolling;
            wb = wb + rolling;
        }

        // Warm start, kept apart from the velocities until the first substep has integrated them.
        const F px = nx * sum_n + ny * sum_t, py = ny * sum_n - nx * sum_t;
        const F out_a[4] = {a[4] - a[3] * px, a[5] - a[3] * py, a[6] - a[7] * wa, a[7]};
        const F out_b[4] = {b[4] + b[3] * px, b[5] + b[3] * py, b[6] + b[7] * wb, b[7]};
        scatter_pushed<L>(bodies + 4, r.body_a, r.body_b, a[3], b[3], out_a, out_b);
    }
}

template <class L>
void ContactKernel<L>::solve(SolverBody* bodies_in, Rows* rows, std::uint32_t count, const SweepNumbers& numbers) {
    float* bodies = reinterpret_cast<float*>(bodies_in);
    const F zero = L::splat(0.0f);
    const F one = L::splat(1.0f);
    const F inv_h = L::splat(numbers.inv_h);
    const F bias_rate = L::splat(numbers.bias_rate);
    const F mass_scale = L::splat(numbers.mass_scale);
    const F impulse_scale = L::splat(numbers.impulse_scale);
    const F push = L::splat(-numbers.push_speed);
    const F slop = L::splat(numbers.slop);
    const bool biased = numbers.bias_rate > 0;

    for (std::uint32_t block = 0; block < count; ++block) {
        Rows& r = rows[block];
        F a[8], b[8];
        L::template gather8<body_words>(bodies, r.body_a, a);
        L::template gather8<body_words>(bodies, r.body_b, b);
        const F nx = L::load(r.nx), ny = L::load(r.ny);
        const F dn = L::load(r.dn), dt = L::load(r.dt);
        const F mass = a[3] + b[3];
        const F vx = b[0] - a[0], vy = b[1] - a[1];
        F vn = nx * vx + ny * vy;
        F wa = a[2], wb = b[2];

        // How far the two surfaces moved apart along n: the row's Jacobian times the bodies' way. The part that does not depend on the point first.
        const F turn = b[6] - a[6];
        const F base = nx * (b[4] - a[4]) + ny * (b[5] - a[5]) + b[6] * dt;

        F sum_n = zero, total_n = zero;
        const std::uint32_t points = r.two_points ? 2 : 1;
        for (std::uint32_t i = 0; i < points; ++i) {
            typename Rows::Point& p = r.points[i];
            const F at = L::load(p.at);
            const F bt = at + dt;
            const F s = L::load(p.separation) + base + at * turn;
            const F m = L::load(p.normal_mass);
            const F old = L::load(p.normal_impulse);
            const F speed = vn + (wb * bt - wa * at);
            F delta;
            if (biased) {
                // Apart: may close the gap within the substep, no faster. Overlapping: pushed apart softly.
                const auto apart = s > zero;
                const F bias = select(apart, s * inv_h, max(bias_rate * min(s + slop, zero), push));
                const F scale = select(apart, one, mass_scale);
                delta = zero - m * (scale * speed + bias) - select(apart, zero, impulse_scale) * old;
            } else {
                delta = zero - m * (speed + max(s, zero) * inv_h);
            }
            const F lambda = max(old + delta, zero);
            delta = lambda - old;
            L::store(p.normal_impulse, lambda);
            if (r.is_bouncy()) L::store(r.peak[i], max(L::load(r.peak[i]), lambda));
            sum_n = sum_n + delta;
            total_n = total_n + lambda;
            vn = vn + mass * delta;
            wa = wa - a[7] * (at * delta);
            wb = wb + b[7] * (bt * delta);
        }

        F sum_t = zero;
        if (numbers.friction) {
            const F mu = L::load(r.friction);
            F vt = ny * vx - nx * vy;
            if (r.is_special()) vt = vt - L::load(r.tangent_speed);
            for (std::uint32_t i = 0; i < points; ++i) {
                typename Rows::Point& p = r.points[i];
                const F an = L::load(p.an);
                const F bn = an + dn;
                const F old = L::load(p.tangent_impulse);
                const F bound = mu * L::load(p.normal_impulse);
                const F speed = vt - (wb * bn - wa * an);
                const F lambda = max(min(old - L::load(p.tangent_mass) * speed, bound), zero - bound);
                const F delta = lambda - old;
                L::store(p.tangent_impulse, lambda);
                sum_t = sum_t + delta;
                vt = vt + mass * delta;
                wa = wa + a[7] * (an * delta);
                wb = wb - b[7] * (bn * delta);
            }
            if (r.is_special()) {
                const F old = L::load(r.rolling_impulse);
                const F resistance = L::load(r.rolling_resistance);
                const F bound = select(resistance > zero, resistance * total_n, zero);  // even if the normal impulse has overflowed
                const F lambda = max(min(old - L::load(r.rolling_mass) * (wb - wa), bound), zero - bound);
                const F delta = lambda - old;
                L::store(r.rolling_impulse, lambda);
                wa = wa - a[7] * delta;
                wb = wb + b[7] * delta;
            }
        }

        const F px = nx * sum_n + ny * sum_t, py = ny * sum_n - nx * sum_t;
        const F out_a[4] = {a[0] - a[3] * px, a[1] - a[3] * py, wa, a[3]};
        const F out_b[4] = {b[0] + b[3] * px, b[1] + b[3] * py, wb, b[3]};
        scatter_pushed<L>(bodies, r.body_a, r.body_b, a[3], b[3], out_a, out_b);
    }
}

template <class L>
void ContactKernel<L>::restitute(SolverBody* bodies_in, Rows* rows, std::uint32_t count, float threshold_in) {
    float* bodies = reinterpret_cast<float*>(bodies_in);
    const F zero = L::splat(0.0f);
    const F threshold = L::splat(-threshold_in);
    for (std::uint32_t block = 0; block < count; ++block) {
        Rows& r = rows[block];
        if (!r.is_bouncy()) continue;
        F a[8], b[8];
        L::template gather8<body_words>(bodies, r.body_a, a);
        L::template gather8<body_words>(bodies, r.body_b, b);
        const F nx = L::load(r.nx), ny = L::load(r.ny), dt = L::load(r.dt), e = L::load(r.restitution);
        F vn = nx * (b[0] - a[0]) + ny * (b[1] - a[1]);
        F wa = a[2], wb = b[2], sum = zero;
        // The two points of a manifold share the blow: a few passes over them solve their 2 x 2 problem, so that a box that lands flat bounces flat.
        const F second = r.two_points ? L::load(r.points[1].normal_mass) : zero;  // zero where a lane has one point: that one is solved once
        const std::uint32_t rows_to_solve = r.two_points ? 2 * restitution_passes : 1;
        for (std::uint32_t k = 0; k < rows_to_solve; ++k) {
            const std::uint32_t i = k & 1u;
            typename Rows::Point& p = r.points[i];
            const F at = L::load(p.at), bt = at + dt;
            const F approach = L::load(r.approach[i]);
            const F old = L::load(p.normal_impulse);
            const F speed = vn + (wb * bt - wa * at);
            F lambda = max(old - L::load(p.normal_mass) * (speed + e * approach), zero);
            // Only where the surfaces met (an impulse was needed) faster than the threshold, and the material bounces.
            lambda = select(approach < threshold, lambda, old);
            lambda = select(L::load(r.peak[i]) > zero, lambda, old);
            lambda = select(e > zero, lambda, old);
            if (k >= 2) lambda = select(second > zero, lambda, old);
            const F delta = lambda - old;
            L::store(p.normal_impulse, lambda);
            sum = sum + delta;
            vn = vn + (a[3] + b[3]) * delta;
            wa = wa - a[7] * (at * delta);
            wb = wb + b[7] * (bt * delta);
        }
        const F px = nx * sum, py = ny * sum;
        const F out_a[4] = {a[0] - a[3] * px, a[1] - a[3] * py, wa, a[3]};
        const F out_b[4] = {b[0] + b[3] * px, b[1] + b[3] * py, wb, b[3]};
        scatter_pushed<L>(bodies, r.body_a, r.body_b, a[3], b[3], out_a, out_b);
    }
}

template <class L>
typename L::F ContactKernel<L>::size_of(const Rows& r) {
    F sum = L::load(r.points[0].normal_impulse) + L::load(r.points[0].tangent_impulse);
    if (r.two_points) sum = sum + L::load(r.points[1].normal_impulse) + L::load(r.points[1].tangent_impulse);
    if (r.is_special()) sum = sum + L::load(r.rolling_impulse);
    return L::abs(sum);
}

template <class L>
void ContactKernel<L>::store(ContactManifold* manifolds, const Rows* rows, std::uint32_t count) {
    for (std::uint32_t block = 0; block < count; ++block) {
        const Rows& r = rows[block];
        for (std::uint32_t i = 0; i < W; ++i) {
            if (W > 1 && r.contact[i] == null_index) continue;
            ContactManifold& m = manifolds[r.contact[i]];
            m.normal_impulse[0] = r.points[0].normal_impulse[i];
            m.tangent_impulse[0] = r.points[0].tangent_impulse[i];
            if (m.count() == 2) {
                m.normal_impulse[1] = r.points[1].normal_impulse[i];
                m.tangent_impulse[1] = r.points[1].tangent_impulse[i];
            }
            m.rolling_impulse = (m.flags & contact_special) != 0 ? r.rolling_impulse[i] : 0;
        }
        const std::uint32_t sound = L::bits(size_of(r) < L::splat(unsound_impulse));
        if (sound == (1u << W) - 1) continue;
        for (std::uint32_t i = 0; i < W; ++i)
            if ((sound >> i & 1u) == 0 && (W == 1 || r.contact[i] != null_index)) manifolds[r.contact[i]].forget_impulses();
    }
}

extern template struct ContactKernel<Lane1>;  // kernel_scalar.cpp
#if ISLET_MAX_LANES >= 4
extern template struct ContactKernel<Lane4>;
#endif

}  // namespace islet::detail
