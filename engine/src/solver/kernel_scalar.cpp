// The kernels for one lane, and for four where the target's baseline has vectors (SSE2, NEON, wasm-simd128).
#include "../exact.hpp"

#include "../constraint/contact.hpp"
#if ISLET_MAX_LANES >= 4
#include "../constraint/joint_runs.hpp"
#endif
#include "../solver/update_kernels.hpp"

namespace islet::detail {

template struct ContactKernel<1>;
#if ISLET_MAX_LANES >= 4
template struct ContactKernel<4>;
KeptTouching keep_touching_4(const ContactsInLanes& in, const std::uint32_t* contact) { return keep_touching<Lane4>(in, contact); }
void tell_apart_4(const ContactsInLanes& in, const std::uint32_t* contact, ToldApart& out) { tell_apart<Lane4>(in, contact, out); }
void remake_4(const ContactsInLanes& in, PairKind kind, const LanePairs& pairs, Remade& out) { out = remake<Lane4>(in, kind, pairs); }
template void solve_joints<4>(JointKernel, SolverBody*, std::byte*, std::uint32_t, const JointSweep&);
#endif

}  // namespace islet::detail
