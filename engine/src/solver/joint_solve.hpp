// The joints' part of the solve, run by run, for any width of lanes.
//
// A program that makes no joints does not link this part. The functions are referenced weakly, which takes nothing from an archive. Only the functions that
// make joints call link_joint_solve, which takes all of it. A program without it has no joints, so it never calls these functions. (Where a linker knows no
// weak references, the functions are ordinary ones and always linked.)
#pragma once

#include "../constraint/joint_rows.hpp"
#include "../island/batches.hpp"
#include "../math/inlining.hpp"

namespace islet::detail {

/// Bytes of the run's rows when `lanes` joints are solved at a time.
ISLET_OPTIONAL std::size_t joint_run_bytes_of(const JointRun& run, std::uint32_t lanes);
/// Fills the rows of the joints listed, and adds their warm starts to the bodies.
ISLET_OPTIONAL void prepare_joint_run(const JointRun& run, std::uint32_t lanes, std::byte* rows, const std::uint32_t* joints, const JointInput& in);
/// One sweep.
ISLET_OPTIONAL void solve_joint_run(const JointRun& run, std::uint32_t lanes, SolverBody* bodies, std::byte* rows, const JointSweep& sweep);
/// Writes the impulses back to the joints, for the next step.
ISLET_OPTIONAL void store_joint_run(const JointRun& run, std::uint32_t lanes, std::byte* rows, const JointOutput& out);

/// Takes room for the rows of every run of joints, and notes where each run's begin.
ISLET_PART std::byte* place_joint_rows(const Plan& plan, std::uint32_t lanes, Arena& arena) {
    std::size_t bytes = 0;
    for (std::uint32_t i = 0; has_joints && i < plan.run_count; ++i) {
        JointRun& r = plan.runs[i];
        r.offset = bytes;
        bytes += joint_run_bytes_of(r, lanes);
        bytes = (bytes + 63) / 64 * 64;
    }
    return arena.take<std::byte>(bytes);
}

/// Does nothing. A program that refers to it links the functions above.
void link_joint_solve();
/// True if the program has linked them.
inline bool joint_solve_is_linked() { return ISLET_IS_LINKED(solve_joint_run); }

}  // namespace islet::detail
