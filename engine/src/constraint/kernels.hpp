// The kernels: the functions that are compiled once for each width of lanes, with the instructions that this width needs.
//
//   width  lanes   compiled in
//   1      Lane1   solver/kernel_scalar.cpp; joints in solver/joint_solve.cpp, which a program without joints does not link
//   4      Lane4   solver/kernel_scalar.cpp, where the processor's baseline has vectors
//   8      Lane8   solver/kernel_avx2.cpp, and LoneKernel8
//   16     Lane16  solver/kernel_avx512.cpp: two blocks of eight that lie side by side in memory are one of sixteen
//
// World::create chooses a world's width (Core::lanes). with_lanes turns it into a constant.
#pragma once

#include "../constraint/contact_rows.hpp"
#include "../constraint/joint_rows.hpp"
#include "../math/inlining.hpp"

namespace islet::detail {

/// Where prepare finds its inputs.
struct PrepareInput {
    const ContactManifold* manifolds;
    const Pose* poses;
    const PlanIndex* slot_of;  // solver slot of a body
    SolverBody* bodies;
    const SolverMotion* motions;
    StepNumbers numbers;
};

/// In each sweep a contact whose shapes come together fast is solved up to so many more times: the blow takes one step, so the rows of a contact have no later
/// steps in which to correct what they do to each other.
inline constexpr std::uint8_t landing_passes = 5;

/// A body that lands on several contacts at once needs them to agree: each sweep is followed by so many over the contacts that land, alone. (Without them,
/// what fell flat on two pillars or on a chain of short segments overturned from one height in three. An even number, so that each contact begins the next
/// sweep with the point with which it would have begun.)
inline constexpr std::uint32_t landing_sweeps = 2;
static_assert(landing_sweeps % 2 == 0);

/// So many sweeps give bouncing contacts their rebound speed. (With one, a box that fell on a chain of short pieces with restitution 1 came back 1.4 times as
/// fast.)
inline constexpr std::uint32_t restitution_sweeps = 6;

inline constexpr std::uint32_t two_point_flag = 2u << contact_count_shift;  // of ContactManifold::flags; a contact has no more
inline constexpr std::uint32_t bouncy_flags = contact_bouncy | (has_hits ? std::uint32_t{contact_hits} : 0u);  // the same

/// The contacts of a block, their bodies and which points they have. A lane of the padding reads the first lane's contact; it acts on slot 0 with no impulse.
template <std::uint32_t W>
struct ContactLanes {
    std::uint32_t contact[W], body_a[W], body_b[W];
    float has_point[2][W];  // 1 or 0
};

/// Whether any contact of a batch lands, and whether any may bounce or reports hits.
struct ContactKinds {
    bool lands = false, bounces = false;

    void note(ContactKinds other) {
        lands = lands || other.lands;
        bounces = bounces || other.bounces;
    }
    template <std::uint32_t W>
    ISLET_INLINE void note(const ContactRows<W>& r) {
        note({any_lands(r), r.is_bouncy()});
    }
};

/// The contacts' kernel, W contacts at a time.
template <std::uint32_t width>
struct ContactKernel {
    static constexpr std::uint32_t W = width;
    using Rows = ContactRows<W>;

    /// Fills the rows of blocks, and adds the warm start to the bodies' warm_v and warm_w. The caller has filled in the `contact` entries, and the material
    /// of special and bouncy contacts. Returns the kinds of these contacts.
    static ContactKinds prepare(const PrepareInput& in, Rows* rows, std::uint32_t count);
    /// The same for one block whose contacts may be of several worlds: the caller has filled in all but the frame, the points and the rolling row. The lanes
    /// count contacts from in.manifolds, and bodies from in.poses.
    static void prepare_named(const PrepareInput& in, const ContactLanes<W>& lanes, Rows& r);
    /// One sweep, block by block.
    static void solve(SolverBody* bodies, Rows* rows, std::uint32_t count, const SweepNumbers& numbers);
    /// The same over blocks of one colour, which push no body in common: two at a time, where W > 1.
    static void solve_in_twos(SolverBody* bodies, Rows* rows, std::uint32_t count, const SweepNumbers& numbers);
    /// Solves those lanes of a block again that land and that the last pass changed. `changed`: a bit a lane.
    static void land(SolverBody* bodies, Rows& rows, std::uint32_t changed, const SweepNumbers& numbers);
    /// One sweep over the contacts that land, alone.
    static void land_again(SolverBody* bodies, Rows* rows, std::uint32_t count, const SweepNumbers& numbers);
    /// Gives bouncing contacts their rebound speed. Returns whether any bounces.
    static bool restitute(SolverBody* bodies, Rows* rows, std::uint32_t count, float threshold);
    /// Writes the impulses back to the manifolds, for the next step.
    static void store(ContactManifold* manifolds, const Rows* rows, std::uint32_t count);
};
extern template struct ContactKernel<1>;
extern template struct ContactKernel<4>;
extern template struct ContactKernel<8>;
extern template struct ContactKernel<16>;

/// One contact at a time, with AVX: an operation need not overwrite what it reads, which saves a tenth of the instructions.
struct LoneKernel8 : ContactKernel<1> {
    static ContactKinds prepare(const PrepareInput& in, Rows* rows, std::uint32_t count);
    static void solve(SolverBody* bodies, Rows* rows, std::uint32_t count, const SweepNumbers& numbers);
};
/// The kernel of contacts that are solved one by one beside others in so many lanes.
template <std::uint32_t beside>
using LoneKernel = std::conditional_t<beside == 8, LoneKernel8, ContactKernel<1>>;

/// One sweep over blocks of one colour.
template <class Kernel>
ISLET_INLINE void solve_color(SolverBody* bodies, typename Kernel::Rows* rows, std::uint32_t count, const SweepNumbers& numbers) {
    if constexpr (Kernel::W == 1) {
        Kernel::solve(bodies, rows, count, numbers);
    } else {
        Kernel::solve_in_twos(bodies, rows, count, numbers);
    }
}

/// One sweep over a run of joints of one kernel, W joints at a time.
template <std::uint32_t W>
void solve_joints(JointKernel kernel, SolverBody* bodies, std::byte* rows, std::uint32_t blocks, const JointSweep& sweep);
extern template void solve_joints<4>(JointKernel, SolverBody*, std::byte*, std::uint32_t, const JointSweep&);
extern template void solve_joints<8>(JointKernel, SolverBody*, std::byte*, std::uint32_t, const JointSweep&);
extern template void solve_joints<16>(JointKernel, SolverBody*, std::byte*, std::uint32_t, const JointSweep&);

/// A width of lanes as a type, so that it is known when the code is compiled.
template <std::uint32_t lanes>
struct Width {
    constexpr operator std::uint32_t() const { return lanes; }
};

/// Calls visit(Width) for a number of lanes that this build has, from `least` to `most`.
template <std::uint32_t least = 1, std::uint32_t most = max_block_lanes, class Visit>
ISLET_LANE auto with_lanes(std::uint32_t lanes, Visit&& visit) {
    if constexpr (most >= 16)
        if (lanes == 16) return visit(Width<16>{});
    if constexpr (max_lanes >= 8)
        if (lanes == 8) return visit(Width<8>{});
    if constexpr (max_lanes >= 4 && least < 4)
        if (lanes == 4) return visit(Width<4>{});
    return visit(Width<least>{});
}

}  // namespace islet::detail
