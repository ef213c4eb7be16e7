#include "../exact.hpp"

#include "../calls/recorder.hpp"
#include "../solver/solver_def.hpp"

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
