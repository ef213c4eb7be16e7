#include "../exact.hpp"

#include "../solver/joint_solve.hpp"

#include "../constraint/joint_runs.hpp"
#include "../solver/tree_solve.hpp"

namespace islet::detail {

namespace {

// Runs without a colour are solved one by one.
std::uint32_t lanes_of(const JointRun& run, std::uint32_t lanes) { return run.color == no_color ? 1 : lanes; }

template <class Sixteen, class Eight>
inline constexpr bool are_two = sizeof(Sixteen) == 2 * sizeof(Eight) || std::is_same_v<Sixteen, Eight>;
#define ISLET_PAIRED(name, Rows, there) static_assert(are_two<Rows<16>, Rows<8>>);
ISLET_JOINT_KERNELS(ISLET_PAIRED)
#undef ISLET_PAIRED

/// Calls visit(Width, blocks, rows, joints before them) for a run. Where sixteen joints are solved at once, its blocks of eight go two by two, and one that is
/// left over by itself.
template <class Visit>
void over_blocks(const JointRun& run, std::uint32_t lanes, std::byte* rows, Visit&& visit) {
    std::uint32_t width = lanes_of(run, lanes), paired = 0;  // blocks
    if constexpr (max_lanes > max_block_lanes) {
        if (width == max_lanes) {
            paired = run.blocks & ~1u;
            if (paired != 0) visit(Width<max_lanes>{}, paired / 2, rows, 0u);
            if (paired == run.blocks) return;
            rows += paired / 2 * joint_block_bytes<max_lanes>(run.kernel);
            width = max_block_lanes;
        }
    }
    with_lanes(width, [&](auto w) { visit(w, run.blocks - paired, rows, paired * w); });
}

}  // namespace

std::size_t joint_run_bytes_of(const JointRun& run, std::uint32_t lanes) {
    return run.blocks * with_lanes(lanes_of(run, lanes), [&](auto w) { return joint_block_bytes<w>(run.kernel); });
}

void prepare_joint_run(const JointRun& run, std::uint32_t lanes, std::byte* rows, const std::uint32_t* joints, const JointInput& in) {
    over_blocks(run, lanes, rows, [&](auto w, std::uint32_t blocks, std::byte* first, std::uint32_t before) {
        prepare_joints<w>(run.kernel, first, blocks, joints + before, in);
    });
}

void solve_joint_run(const JointRun& run, std::uint32_t lanes, SolverBody* bodies, std::byte* rows, const JointSweep& of_colors) {
    JointSweep sweep = of_colors;
    if (run.color == no_color) sweep.soft = sweep.soft_alone;
    over_blocks(run, lanes, rows,
                [&](auto w, std::uint32_t blocks, std::byte* first, std::uint32_t) { solve_joints<w>(run.kernel, bodies, first, blocks, sweep); });
}

void store_joint_run(const JointRun& run, std::uint32_t lanes, std::byte* rows, const JointOutput& out) {
    over_blocks(run, lanes, rows, [&](auto w, std::uint32_t blocks, std::byte* first, std::uint32_t) { store_joints<w>(run.kernel, first, blocks, out); });
}

void link_joint_solve() {
    link_joint_trees();
    link_tree_solve();
}

}  // namespace islet::detail
