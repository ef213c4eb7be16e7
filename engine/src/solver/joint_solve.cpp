#include "../exact.hpp"

#include "../solver/joint_solve.hpp"

#include "../constraint/joint_runs.hpp"
#include "../solver/tree_solve.hpp"

namespace islet::detail {

#if ISLET_MAX_LANES >= 8
void solve_joints_8(JointKernel kernel, SolverBody* bodies, std::byte* rows, std::uint32_t blocks, const JointSweep& sweep);  // kernel_avx2.cpp
#endif

namespace {

// Calls visit with the width as a constant. Runs without a colour are solved one by one.
template <class Visit>
ISLET_LANE auto with_width(const JointRun& run, std::uint32_t lanes, Visit&& visit) {
    switch (run.color == no_color ? 1 : lanes) {
#if ISLET_MAX_LANES >= 8
        case 8: return visit(std::integral_constant<std::uint32_t, 8>{});
#endif
#if ISLET_MAX_LANES >= 4
        case 4: return visit(std::integral_constant<std::uint32_t, 4>{});
#endif
        default: return visit(std::integral_constant<std::uint32_t, 1>{});
    }
}

}  // namespace

std::size_t joint_run_bytes_of(const JointRun& run, std::uint32_t lanes) {
    return run.blocks * with_width(run, lanes, [&](auto w) { return joint_block_bytes<w>(run.kernel); });
}

void prepare_joint_run(const JointRun& run, std::uint32_t lanes, std::byte* rows, const std::uint32_t* joints, const JointInput& in) {
    with_width(run, lanes, [&](auto w) { prepare_joints<w>(run.kernel, rows, run.blocks, joints, in); });
}

void solve_joint_run(const JointRun& run, std::uint32_t lanes, SolverBody* bodies, std::byte* rows, const JointSweep& sweep) {
    with_width(run, lanes, [&](auto w) {
        if constexpr (w == 1) { solve_joints<Lane1>(run.kernel, bodies, rows, run.blocks, sweep); }
#if ISLET_MAX_LANES >= 4
        if constexpr (w == 4) { solve_joints<Lane4>(run.kernel, bodies, rows, run.blocks, sweep); }
#endif
#if ISLET_MAX_LANES >= 8
        if constexpr (w == 8) { solve_joints_8(run.kernel, bodies, rows, run.blocks, sweep); }
#endif
    });
}

void store_joint_run(const JointRun& run, std::uint32_t lanes, std::byte* rows, const JointOutput& out) {
    with_width(run, lanes, [&](auto w) { store_joints<w>(run.kernel, rows, run.blocks, out); });
}

void link_joint_solve() {
    link_joint_trees();
    link_tree_solve();
}

}  // namespace islet::detail
