#include "../exact.hpp"

#include "../solver/solver_def.hpp"

#include "../calls/checks.hpp"
#include "../calls/recorder.hpp"
#include "../solver/ordered_sweep.hpp"

namespace islet::detail {

bool check_solver(const SolverDef& d, Error& error) {
    const bool finite = all_finite(d.contact_hertz, d.contact_damping_ratio, d.contact_push_speed, d.joint_hertz, d.joint_damping_ratio, d.baumgarte, d.omega,
                                   d.joint_tree_load, d.shock, d.tolerance);
    const bool sane = (d.schedule == Schedule::soft || d.schedule == Schedule::classic) && d.substeps >= 1 && d.substeps <= 64 && d.iterations >= 1 &&
                      d.iterations <= 256 && d.relax_iterations <= 256 && d.contact_hertz > 0 && d.contact_damping_ratio >= 0 && d.contact_push_speed >= 0 &&
                      d.joint_hertz > 0 && d.joint_damping_ratio >= 0 && d.baumgarte >= 0 && d.baumgarte <= 1 && d.omega > 0 && d.omega < 2 &&
                      d.joint_trees <= JointTrees::all && d.joint_tree_load >= 1 && d.sweep_order <= SweepOrder::downward && d.shock >= 0 &&
                      d.shock <= max_shock && d.tolerance >= 0;
    const bool cut = !has_tuning && needs_tuning(d);
    error = !finite ? Error::not_finite : !sane ? Error::out_of_range : cut ? Error::feature_cut : Error::none;
    return error == Error::none;
}

}  // namespace islet::detail

namespace islet {

using namespace detail;

void World::set_solver(const SolverDef& solver) {
    note_call<Call::set_solver>(core(), solver);
    Error error = Error::none;
    if (!check_open(core())) return;
    if (!check_solver(solver, error)) return core().fail(error);
    State& state = *core().state;
    const SolverState before = state.solver;
    state.solver = pack(solver);
    if (before.joint_trees != state.solver.joint_trees || before.joint_tree_load != state.solver.joint_tree_load) state.trees_stale = 1;
    forget_residuals(core());
}

}  // namespace islet
