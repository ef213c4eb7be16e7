// What all batches of one solve share.
#pragma once

#include "../constraint/contact_rows.hpp"
#include "../constraint/kernels.hpp"
#include "../constraint/solver_body.hpp"
#include "../data/core.hpp"
#include "../island/batches.hpp"
#include "../solver/hits.hpp"
#include "../solver/solve_numbers.hpp"
#include "../solver/tree_solve.hpp"

namespace islet::detail {

struct Solve {
    Core& core;
    const Plan& plan;
    SolveNumbers numbers;
    SolverBody* bodies = nullptr;     // by slot
    SolverMotion* motions = nullptr;  // by slot
    std::byte* joint_rows = nullptr;
    TreeLink* links = nullptr;
    std::byte* blocks = nullptr;  // ContactRows<block_lanes>
    ContactRows<1>* overflow = nullptr;
    PlanIndex* landing = nullptr;  // room for the numbers of blocks with contacts that land; null where contacts are solved one by one
    float* residuals = nullptr;    // m/s, by island; null if not wanted
    Hit* hits = nullptr;           // by contact; null if not wanted

    PrepareInput input() const { return {core.manifolds, core.poses, plan.slot_of, bodies, motions, numbers.step}; }
};

/// How a sweep treats a contact without a colour.
ISLET_PART const SweepNumbers& numbers_alone(const Solve& s, const ContactRows<1>& r, const SweepNumbers& dynamic, const SweepNumbers& ground) {
    if (is_positive(s.bodies[r.body_a[0]].inv_mass) && is_positive(s.bodies[r.body_b[0]].inv_mass)) return dynamic;
    return s.numbers.is_ordered || !is_positive(ground.bias_rate) ? ground : s.numbers.ground_alone;
}

/// One sweep over contacts without a colour.
template <class Kernel>
void solve_alone(const Solve& s, ContactRows<1>* rows, std::uint32_t count, const SweepNumbers& dynamic, const SweepNumbers& ground) {
    for (std::uint32_t i = 0; i < count; ++i) Kernel::solve(s.bodies, rows + i, 1, numbers_alone(s, rows[i], dynamic, ground));
}

}  // namespace islet::detail
