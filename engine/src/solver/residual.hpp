// How far impulses are from a solution.
//
// Solving one constraint alone, all others as they are, changes nothing if and only if its part of the problem is solved: its impulse and its relative
// velocity are feasible and complementary. So what a solve would still change is a natural residual (Cottle, Pang and Stone, "The Linear Complementarity
// Problem", 1992: 1.5.8, here with the constraint's own mass as scale), and it is found by trying: each block of rows is solved by the kernel that sweeps it,
// the bodies are compared, and all is put back. It is measured in what a body's velocity would change by, so that constraints of any kind and mass compare.
//
// The change an impulse made since the sweep before would be no such measure: it is small too where a method only creeps.
#pragma once

#include "constraint/solver_body.hpp"
#include "math/scalar.hpp"

namespace islet::detail {

/// Most slots that one block of rows may name: four a gear, two any other constraint in lanes.
inline constexpr std::uint32_t most_trial_slots = 2 * (max_lanes > 2 ? max_lanes : 2);

/// m/s: by how much the velocity of a body changed, turning at its radius of gyration.
inline float velocity_change(const SolverBody& before, const SolverBody& after) {
    const Vec2 dv = after.v - before.v;
    const float dw = after.w - before.w;
    const float turning = before.inv_inertia > 0 ? before.inv_mass / before.inv_inertia * dw * dw : 0;
    return sqrt(dot(dv, dv) + turning);
}

/// Solves a block of rows and takes it back: raises the residual of each of its islands to what changed. `slots` are those of the bodies it may push, in any
/// order and number; `rows` all that solving changes besides.
template <class Solve>
void try_block(SolverBody* bodies, const std::uint32_t* slots, std::uint32_t count, std::byte* rows, std::size_t row_bytes_used,
               const std::uint32_t* island_of, float* residuals, Solve&& solve) {
    SolverBody before[most_trial_slots];
    alignas(16) std::byte saved[max_lanes * (row_bytes > joint_row_bytes ? row_bytes : joint_row_bytes)];
    for (std::uint32_t i = 0; i < count; ++i) before[i] = bodies[slots[i]];
    std::memcpy(saved, rows, row_bytes_used);
    solve();
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t slot = slots[i];
        if (before[i].inv_mass > 0) {
            float& residual = residuals[island_of[slot]];
            residual = max(residual, velocity_change(before[i], bodies[slot]));
        }
    }
    for (std::uint32_t i = 0; i < count; ++i) bodies[slots[i]] = before[i];
    std::memcpy(rows, saved, row_bytes_used);
}

}  // namespace islet::detail
