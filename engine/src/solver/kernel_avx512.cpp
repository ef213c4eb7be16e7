// The kernels for sixteen lanes, compiled for AVX-512 (math/avx512.hpp).
#include "../exact.hpp"

#include "../math/avx512.hpp"

#include "../constraint/contact.hpp"
#include "../constraint/joint_runs.hpp"

namespace islet::detail {

#if defined(ISLET_AVX512)
template struct ContactKernel<16>;
template void solve_joints<16>(JointKernel, SolverBody*, std::byte*, std::uint32_t, const JointSweep&);
#endif

}  // namespace islet::detail

ISLET_AVX512_END
