// The kernels for eight lanes, compiled for AVX2 (math/avx2.hpp).
#include "../exact.hpp"

#include "../math/avx2.hpp"

#include "../constraint/contact.hpp"
#include "../constraint/joint_runs.hpp"
#include "../solver/body_vectors.hpp"
#include "../solver/update_kernels.hpp"

namespace islet::detail {

#if defined(ISLET_AVX2)
template struct ContactKernel<8>;

ContactKinds LoneKernel8::prepare(const PrepareInput& in, Rows* rows, std::uint32_t count) { return prepare_blocks<1>(in, rows, count); }
void LoneKernel8::solve(SolverBody* bodies, Rows* rows, std::uint32_t count, const SweepNumbers& numbers) { solve_blocks<1>(bodies, rows, count, numbers); }

KeptTouching keep_touching_8(const ContactsInLanes& in, const std::uint32_t* contact) { return keep_touching<Lane8>(in, contact); }
void tell_apart_8(const ContactsInLanes& in, const std::uint32_t* contact, ToldApart& out) { tell_apart<Lane8>(in, contact, out); }
void remake_8(const ContactsInLanes& in, PairKind kind, const LanePairs& pairs, Remade& out) { out = remake<Lane8>(in, kind, pairs); }

template void solve_joints<8>(JointKernel, SolverBody*, std::byte*, std::uint32_t, const JointSweep&);

#if ISLET_BODY_VECTORS
std::uint32_t integrate_velocities_8(const VelocityVectors& all, std::uint32_t slot, std::uint32_t end_slot) {
    slot = integrate_vectors<TwoBodies>(all, slot, end_slot);
    return slot + 1 == end_slot ? integrate_vectors<OneBody>(all, slot, end_slot) : slot;
}
std::uint32_t integrate_positions_8(const WayVectors& all, std::uint32_t slot, std::uint32_t end_slot) {
    slot = integrate_vectors<TwoBodies>(all, slot, end_slot);
    return slot + 1 == end_slot ? integrate_vectors<OneBody>(all, slot, end_slot) : slot;
}
std::uint32_t read_bodies_8(const BodyInput& in, std::uint32_t slot, std::uint32_t end_slot) { return read_bodies<Lane8>(in, slot, end_slot); }
std::uint32_t write_bodies_8(const BodyOutput& out, std::uint32_t slot, std::uint32_t end_slot) { return write_bodies<Lane8>(out, slot, end_slot); }
#endif
#endif

}  // namespace islet::detail

ISLET_AVX2_END
