#include "../exact.hpp"

#include "../solver/joint_solve.hpp"

#include "../constraint/joint_runs.hpp"
#include "../solver/tree_solve.hpp"

namespace islet::detail {

namespace {

// Runs without a colour are solved one by one.
std::uint32_t lanes_of(const JointRun& run, std::uint32_t lanes) { return run.color == no_color ? 1 : lanes; }

}  // namespace

std::size_t joint_run_bytes_of(const JointRun& run, std::uint32_t lanes) {
    return run.blocks * with_lanes(lanes_of(run, lanes), [&](auto w) { return joint_block_bytes<w>(run.kernel); });
}

void prepare_joint_run(const JointRun& run, std::uint32_t lanes, std::byte* rows, const std::uint32_t* joints, const JointInput& in) {
    with_lanes(lanes_of(run, lanes), [&](auto w) { prepare_joints<w>(run.kernel, rows, run.blocks, joints, in); });
}

void solve_joint_run(const JointRun& run, std::uint32_t lanes, SolverBody* bodies, std::byte* rows, const JointSweep& sweep) {
    with_lanes(lanes_of(run, lanes), [&](auto w) { solve_joints<w>(run.kernel, bodies, rows, run.blocks, sweep); });
}

void store_joint_run(const JointRun& run, std::uint32_t lanes, std::byte* rows, const JointOutput& out) {
    with_lanes(lanes_of(run, lanes), [&](auto w) { store_joints<w>(run.kernel, rows, run.blocks, out); });
}

void link_joint_solve() {
    link_joint_trees();
    link_tree_solve();
}

}  // namespace islet::detail
