// How far impulses are from a solution.
//
// Solving one constraint alone, with all others as they are, changes nothing if and only if its impulse and its relative velocity are feasible and
// complementary. So the change that a solve would still make is a natural residual (Cottle, Pang and Stone, "The Linear Complementarity Problem", 1992: 1.5.8,
// here with the constraint's own mass as scale). It is found by trial: the kernel solves each block of rows, the bodies are compared, and all is put back.
// The residual is the change of a body's velocity, so constraints of any kind and mass compare.
//
// The change of an impulse since the last sweep would be no such measure: it is also small where a method creeps.
#pragma once

#include <cstring>

#include "../constraint/solver_body.hpp"
#include "../math/scalar.hpp"

namespace islet::detail {

/// Most slots that one block of rows may name: four for a gear, two for each lane of other constraints.
inline constexpr std::uint32_t most_trial_slots = 2 * (max_block_lanes > 2 ? max_block_lanes : 2);

/// m/s: by how much the velocity of a body changed. A turn counts by its speed at the radius of gyration.
inline float velocity_change(const SolverBody& before, const SolverBody& after) {
    const Vec2 dv = after.v - before.v;
    const float dw = after.w - before.w;
    const float turning = is_positive(before.inv_inertia) && dw != 0 ? before.inv_mass / before.inv_inertia * dw * dw : 0;
    return sqrt(dot(dv, dv) + turning);
}

/// The largest residual; it also stands for one that overflowed.
inline constexpr float no_residual = 3.0e38f;

/// A block of rows and the bodies that it may push, as they are before the trial.
struct Trial {
    std::byte* rows;  // all that the solve changes besides the bodies
    std::size_t bytes;
    std::uint32_t slots[most_trial_slots];  // in any order and number
    std::uint32_t count = 0;
    SolverBody before[most_trial_slots];
    alignas(16) std::byte saved[max_block_lanes * (row_bytes > joint_row_bytes ? row_bytes : joint_row_bytes)];

    Trial(std::byte* from, std::size_t n) : rows(from), bytes(n) {}
    void add(std::uint32_t slot) { slots[count++] = slot; }
};

/// Call begin_trial, solve the block, and call end_trial. It puts all back, and raises the residuals of the block's islands to the change that it found.
inline void begin_trial(Trial& t, const SolverBody* bodies) {
    for (std::uint32_t i = 0; i < t.count; ++i) t.before[i] = bodies[t.slots[i]];
    std::memcpy(t.saved, t.rows, t.bytes);
}
inline void end_trial(const Trial& t, SolverBody* bodies, const PlanIndex* island_of, float* residuals) {
    for (std::uint32_t i = 0; i < t.count; ++i) {
        const std::uint32_t slot = t.slots[i];
        if (is_positive(t.before[i].inv_mass)) {
            float& residual = residuals[island_of[slot]];
            const float change = velocity_change(t.before[i], bodies[slot]);
            if (!(change <= residual)) residual = change < no_residual ? change : no_residual;
        }
    }
    for (std::uint32_t i = 0; i < t.count; ++i)
        if (is_positive(t.before[i].inv_mass)) bodies[t.slots[i]] = t.before[i];  // the other bodies are only read
    std::memcpy(t.rows, t.saved, t.bytes);
}

}  // namespace islet::detail
