#include "../exact.hpp"

#include "../solver/ordered_sweep.hpp"

#include "../constraint/contact_bounce.hpp"
#include "../constraint/kernels.hpp"
#include "../island/height_order.hpp"
#include "../math/inlining.hpp"

namespace islet::detail {

namespace {

// All batches share the slot of static bodies, so bodies that cannot be pushed are never written to.
ISLET_SHARED void push_body(SolverBody& body, Vec2 impulse, float turning) {
    if (!is_positive(body.inv_mass)) return;
    body.v += body.inv_mass * impulse;
    body.w += body.inv_inertia * turning;
}

// Finds the two normal impulses x of a contact exactly. Their residuals are w_i = sum over j of K_ij (x_j - old_j) + speed_i + softness_i x_i, with the bias in
// speed_i.
void solve_pair(SolverBody& a, SolverBody& b, ContactRows<1>& r, const SweepNumbers& n) {
    const Vec2 normal = r.manifold->normal;
    const float vn = dot(normal, b.v - a.v), moved = dot(normal, b.dp - a.dp) + b.dq * r.rn_ab[0];
    float rna[2], rnb[2], old[2], speed[2], k[2], m[2];  // m: K_ii + softness_i
    for (std::uint32_t i = 0; i < 2; ++i) {
        const ContactRows<1>::Point& p = r.points[i];
        rna[i] = p.rna[0];
        rnb[i] = rna[i] + r.rn_ab[0];
        old[i] = r.manifold->normal_impulse[i];
        const float s = p.separation[0] + moved + rna[i] * (b.dq - a.dq);
        speed[i] = vn + b.w * rnb[i] - a.w * rna[i];
        m[i] = k[i] = a.inv_mass + b.inv_mass + a.inv_inertia * rna[i] * rna[i] + b.inv_inertia * rnb[i] * rnb[i];
        if (s > 0) {
            speed[i] += s * n.inv_h;
        } else if (n.bias_rate > 0) {
            // The kernel's row in the form of a linear problem: divided by its mass_scale, which is K / (K + softness).
            speed[i] += max(n.bias_rate * min(s + n.slop, 0.0f), -n.push_speed) / n.mass_scale;
            m[i] = k[i] / n.mass_scale;
            if (r.sharing() != 0) m[i] = k[i] + sharers_of<Lane1>(r) * (m[i] - k[i]);
        }
    }
    const float k01 = a.inv_mass + b.inv_mass + a.inv_inertia * rna[0] * rna[1] + b.inv_inertia * rnb[0] * rnb[1], m00 = m[0], m11 = m[1];
    const float q0 = speed[0] - k[0] * old[0] - k01 * old[1], q1 = speed[1] - k01 * old[0] - k[1] * old[1];

    float x[2] = {old[0], old[1]};  // kept if rounding leaves no case
    const float det = m00 * m11 - k01 * k01;
    const float both0 = k01 * q1 - m11 * q0, both1 = k01 * q0 - m00 * q1;  // times det
    if (det > 1.0e-6f * m00 * m11 && both0 >= 0 && both1 >= 0) {
        x[0] = both0 / det;
        x[1] = both1 / det;
    } else if (q0 <= 0 && q1 * m00 >= k01 * q0) {
        x[0] = -q0 / m00;
        x[1] = 0;
    } else if (q1 <= 0 && q0 * m11 >= k01 * q1) {
        x[0] = 0;
        x[1] = -q1 / m11;
    } else if (q0 >= 0 && q1 >= 0) {
        x[0] = x[1] = 0;
    }
    const float d0 = x[0] - old[0], d1 = x[1] - old[1];
    for (std::uint32_t i = 0; i < 2; ++i) {
        r.manifold->normal_impulse[i] = x[i];
        if (r.is_bouncy()) note_impulse<Lane1>(r, i, x[i]);
    }
    const Vec2 push = (d0 + d1) * normal;
    push_body(a, -push, -(rna[0] * d0 + rna[1] * d1));
    push_body(b, push, rnb[0] * d0 + rnb[1] * d1);
}

void solve_one(SolverBody* bodies, ContactRows<1>& r, const SweepNumbers& numbers, bool block) {
    ContactKernel<1>::solve(bodies, &r, 1, numbers);
    if (block && r.two_points) solve_pair(bodies[r.body_a[0]], bodies[r.body_b[0]], r, numbers);
}

}  // namespace

void solve_in_order(SolverBody* bodies, ContactRows<1>* rows, std::uint32_t count, const SweepNumbers& dynamic, const SweepNumbers& ground, bool block) {
    for (std::uint32_t i = 0; i < count; ++i) {
        ContactRows<1>& r = rows[i];
        const bool both_move = is_positive(bodies[r.body_a[0]].inv_mass) && is_positive(bodies[r.body_b[0]].inv_mass);
        solve_one(bodies, r, both_move ? dynamic : ground, block);
    }
}

}  // namespace islet::detail
