#include "solver/ordered_sweep.hpp"

#include "constraint/contact.hpp"

namespace islet::detail {

extern template struct ContactKernel<Lane1>;

namespace {

// A normal row of the pair as the block solve needs it: w = K (x - old) + speed + bias + softness x.
struct NormalRow {
    float speed, softness;  // with its bias; a softness as in K + softness on the diagonal
};

// The two normal impulses of a contact, exactly.
void solve_pair(SolverBody& a, SolverBody& b, ContactRows<1>& r, const SweepNumbers& n) {
    const Vec2 normal = {r.nx[0], r.ny[0]};
    const float vn = dot(normal, b.v - a.v), moved = dot(normal, b.dp - a.dp) + b.dq * r.dt[0];
    float at[2], bt[2], old[2], k[2];
    NormalRow row[2];
    for (std::uint32_t i = 0; i < 2; ++i) {
        const ContactRows<1>::Point& p = r.points[i];
        at[i] = p.at[0];
        bt[i] = at[i] + r.dt[0];
        old[i] = p.normal_impulse[0];
        const float s = p.separation[0] + moved + at[i] * (b.dq - a.dq);
        const bool soft = n.bias_rate > 0 && s <= 0;
        // The kernel's row in the form of a linear problem: divided by its mass_scale, which is K / (K + softness).
        const float bias = s > 0 ? s * n.inv_h : n.bias_rate > 0 ? max(n.bias_rate * min(s + n.slop, 0.0f), -n.push_speed) / n.mass_scale : 0;
        row[i].speed = vn + b.w * bt[i] - a.w * at[i] + bias;
        k[i] = a.inv_mass + b.inv_mass + a.inv_inertia * at[i] * at[i] + b.inv_inertia * bt[i] * bt[i];
        row[i].softness = soft ? k[i] * (1 / n.mass_scale - 1) : 0;
    }
    const float k01 = a.inv_mass + b.inv_mass + a.inv_inertia * at[0] * at[1] + b.inv_inertia * bt[0] * bt[1];
    const float m00 = k[0] + row[0].softness, m11 = k[1] + row[1].softness;
    const float q0 = row[0].speed - k[0] * old[0] - k01 * old[1], q1 = row[1].speed - k01 * old[0] - k[1] * old[1];

    float x[2] = {old[0], old[1]};  // should rounding leave no case
    const float det = m00 * m11 - k01 * k01;
    const float both0 = k01 * q1 - m11 * q0, both1 = k01 * q0 - m00 * q1;  // times det
    if (det > 1.0e-6f * m00 * m11 && both0 >= 0 && both1 >= 0) {
        x[0] = both0 / det;
        x[1] = both1 / det;
    } else if (q0 <= 0 && q1 * m00 >= k01 * q0) {
        x[0] = m00 > 0 ? -q0 / m00 : 0;
        x[1] = 0;
    } else if (q1 <= 0 && q0 * m11 >= k01 * q1) {
        x[0] = 0;
        x[1] = m11 > 0 ? -q1 / m11 : 0;
    } else if (q0 >= 0 && q1 >= 0) {
        x[0] = x[1] = 0;
    }
    const float d0 = x[0] - old[0], d1 = x[1] - old[1];
    for (std::uint32_t i = 0; i < 2; ++i) {
        r.points[i].normal_impulse[0] = x[i];
        if (r.is_bouncy()) r.peak[i][0] = max(r.peak[i][0], x[i]);
    }
    const Vec2 push = (d0 + d1) * normal;
    a.v -= a.inv_mass * push;
    a.w -= a.inv_inertia * (at[0] * d0 + at[1] * d1);
    b.v += b.inv_mass * push;
    b.w += b.inv_inertia * (bt[0] * d0 + bt[1] * d1);
}

void solve_one(SolverBody* bodies, ContactRows<1>& r, const SweepNumbers& numbers, bool block) {
    ContactKernel<Lane1>::solve(bodies, &r, 1, numbers);
    if (block && r.two_points) solve_pair(bodies[r.body_a[0]], bodies[r.body_b[0]], r, numbers);
}

}  // namespace

void solve_in_order(SolverBody* bodies, ContactRows<1>* rows, std::uint32_t count, const SweepNumbers& dynamic, const SweepNumbers& ground, bool block) {
    for (std::uint32_t i = 0; i < count; ++i) {
        ContactRows<1>& r = rows[i];
        const bool both_move = bodies[r.body_a[0]].inv_mass > 0 && bodies[r.body_b[0]].inv_mass > 0;
        solve_one(bodies, r, both_move ? dynamic : ground, block);
    }
}

}  // namespace islet::detail
