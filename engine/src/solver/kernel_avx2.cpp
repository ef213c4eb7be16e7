// The kernel for eight lanes, compiled for AVX2 (math/avx2.hpp).
#include "../exact.hpp"

#include "../math/avx2.hpp"

#include "../constraint/contact.hpp"
#include "../constraint/joint_runs.hpp"

namespace islet::detail {

#if defined(ISLET_AVX2)
void prepare_8(const PrepareInput& in, ContactRows<8>* rows, std::uint32_t count) { ContactKernel<Lane8>::prepare(in, rows, count); }
void solve_8(SolverBody* bodies, ContactRows<8>* rows, std::uint32_t count, const SweepNumbers& numbers) {
    ContactKernel<Lane8>::solve(bodies, rows, count, numbers);
}
void restitute_8(SolverBody* bodies, ContactRows<8>* rows, std::uint32_t count, float threshold) {
    ContactKernel<Lane8>::restitute(bodies, rows, count, threshold);
}
void store_8(ContactManifold* manifolds, const ContactRows<8>* rows, std::uint32_t count) { ContactKernel<Lane8>::store(manifolds, rows, count); }
void solve_joints_8(JointKernel kernel, SolverBody* bodies, std::byte* rows, std::uint32_t blocks, const JointSweep& sweep) {
    solve_joints<Lane8>(kernel, bodies, rows, blocks, sweep);
}
#endif

}  // namespace islet::detail

ISLET_AVX2_END
