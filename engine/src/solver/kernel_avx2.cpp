// The kernels for eight lanes, compiled for AVX2 (math/avx2.hpp).
#include "../exact.hpp"

#include "../math/avx2.hpp"

#include "../constraint/contact.hpp"
#include "../constraint/joint_runs.hpp"

namespace islet::detail {

#if defined(ISLET_AVX2)
template struct ContactKernel<8>;
template void solve_joints<8>(JointKernel, SolverBody*, std::byte*, std::uint32_t, const JointSweep&);
#endif

}  // namespace islet::detail

ISLET_AVX2_END
