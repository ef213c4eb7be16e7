// Runs: blocks of joints of one kernel, side by side. Here a run is handed to the kernel of its joints.
#pragma once

#include "../constraint/joint_kinds.hpp"
#include "../constraint/kernels.hpp"
#include "../math/inlining.hpp"

namespace islet::detail {

inline JointKernel kernel_of(const Joint& j) {
    return with_kind(j.joint_type(), [&](auto kind) { return kind.kernel(j); });
}

/// Calls visit(rows) with a pointer to the blocks of the run's kind.
template <std::uint32_t W, class Visit>
ISLET_LANE auto visit_rows(JointKernel kernel, std::byte* rows, Visit&& visit) {
    // A kernel whose joints are left out of the build is not even compiled.
    switch (kernel) {
#define ISLET_CASE(name, Rows, there)                                                                               \
    case JointKernel::name:                                                                                         \
        if constexpr (has_kernel(JointKernel::name) || !has_joints) return visit(reinterpret_cast<Rows<W>*>(rows)); \
        break;
        ISLET_JOINT_KERNELS(ISLET_CASE)
#undef ISLET_CASE
    }
    ISLET_UNREACHABLE();
}

template <std::uint32_t W>
std::size_t joint_block_bytes(JointKernel kernel) {
    return visit_rows<W>(kernel, nullptr, [](auto* r) { return sizeof(*r); });
}

/// What a joint applies lies right behind its ends, so that all kernels share the way there and back; pulleys and gears, which know no such pair of
/// impulses, go their own.
constexpr bool has_applied(JointKernel kernel) { return kernel < JointKernel::pulley; }
/// The same by the type of the rows.
template <class Rows, class = void>
inline constexpr bool rows_have_applied = false;
template <class Rows>
inline constexpr bool rows_have_applied<Rows, decltype(void(Rows::applied))> = true;
/// The impulse acts on A along a line of A, where B's anchor is, and not at A's own anchor.
constexpr bool acts_on_line(JointKernel kernel) { return kernel == JointKernel::slider || kernel == JointKernel::wheel; }
template <std::uint32_t W>
JointEnds<W>& ends_of(std::byte* row) {
    return *reinterpret_cast<JointEnds<W>*>(row);
}
template <std::uint32_t W>
Applied<W>& applied_of(std::byte* row) {
    return *reinterpret_cast<Applied<W>*>(row + sizeof(JointEnds<W>));
}

/// The lane, which is known when there is but one.
template <std::uint32_t W>
ISLET_LANE std::uint32_t known_lane(std::uint32_t lane) {
    return W > 1 ? lane : 0;
}

/// Calls body(with_row), where with_row(row, visit) calls visit with a row of the kernel. Of lanes side by side the kernel is picked once, so that the loop in
/// `body` is compiled for it; of single joints, or for the web, row by row, so that the loop stands there once.
template <std::uint32_t W, class Body>
void over_rows(JointKernel kernel, Body&& body) {
    if constexpr (W > 1 && !short_loops) {
        visit_rows<W>(kernel, nullptr, [&](auto* r) { body([](std::byte* row, auto&& visit) { return visit(reinterpret_cast<decltype(r)>(row)); }); });
    } else {
        body([kernel](std::byte* row, auto&& visit) { return visit_rows<W>(kernel, row, visit); });
    }
}

/// Fills the blocks from the joints named, null_index in the padding, and adds their warm starts to the bodies.
template <std::uint32_t W>
void prepare_joints(JointKernel kernel, std::byte* rows, std::uint32_t blocks, const std::uint32_t* joints, const JointInput& in) {
    const std::size_t block_bytes = joint_block_bytes<W>(kernel);
    std::memset(rows, 0, blocks * block_bytes);
    over_rows<W>(kernel, [&](auto&& with_row) {
        for (; blocks-- > 0; rows += block_bytes) {
            for (std::uint32_t lane = 0; lane < W; ++lane) {
                const std::uint32_t joint = *joints++;
                ends_of<W>(rows).joint[lane] = joint;
                if (W > 1 && joint == null_index) continue;
                const Joint& j = in.joints[joint];
                const JointPose p = pose_of(j, in.poses, in.bodies_in);
                set_ends(ends_of<W>(rows), lane, j, in, p);
                const WarmStart start = with_row(rows, [&](auto* r) {
                    static_assert(sizeof(*r) <= joint_row_bytes * W);
                    return prepare(*r, known_lane<W>(lane), j, p, in);
                });
                if (!has_applied(kernel)) continue;
                const Vec2 arm_a = acts_on_line(kernel) ? gap_of(p) + p.ra : p.ra;
                warm_start(applied_of<W>(rows), ends_of<W>(rows), lane, in, start.impulse, cross(arm_a, start.impulse) + start.turning,
                           cross(p.rb, start.impulse) + start.turning);
            }
        }
    });
}

template <std::uint32_t W>
void solve_joints(JointKernel kernel, SolverBody* bodies, std::byte* rows, std::uint32_t blocks, const JointSweep& sweep) {
    using L = LaneOf<W>;
    if constexpr (W > 1 && !short_loops) {
        visit_rows<W>(kernel, rows, [&](auto* r) {
            for (std::uint32_t i = 0; i < blocks; ++i) {
                if constexpr (rows_have_applied<std::remove_pointer_t<decltype(r)>>) {
                    JointBodies<L> s = gather<L>(bodies, r[i].ends, r[i].applied);
                    solve<L>(s, JointArms<L>(r[i].ends, s), r[i], sweep);
                    scatter<L>(bodies, r[i].ends, r[i].applied, s);
                } else if constexpr (!std::is_same_v<std::remove_pointer_t<decltype(r)>, GearRows<1>>) {
                    solve<L>(bodies, r[i], sweep);
                }
            }
        });
    } else {
        // One by one, speed matters less than that the way there and back is not repeated for every kernel; and for the web it is loaded once.
        const std::size_t block_bytes = joint_block_bytes<W>(kernel);
        for (; blocks-- > 0; rows += block_bytes) {
            if (!has_applied(kernel)) {
                visit_rows<W>(kernel, rows, [&](auto* r) {
                    using Rows = std::remove_pointer_t<decltype(r)>;
                    if constexpr (!rows_have_applied<Rows> && (W == 1 || !std::is_same_v<Rows, GearRows<1>>)) solve<L>(bodies, *r, sweep);
                });
                continue;
            }
            JointBodies<L> s = gather<L>(bodies, ends_of<W>(rows), applied_of<W>(rows));
            const JointArms<L> arms(ends_of<W>(rows), s);
            visit_rows<W>(kernel, rows, [&](auto* r) ISLET_IN_ONE_LOOP {
                if constexpr (rows_have_applied<std::remove_pointer_t<decltype(r)>>) solve<L>(s, arms, *r, sweep);
            });
            scatter<L>(bodies, ends_of<W>(rows), applied_of<W>(rows), s);
        }
    }
}

/// How many times a body's inertia swept joints may add to it where they stretch it (free_motion.hpp). In nets and rows of rods, whose forces change from step
/// to step, inertia without bound comes and goes with them, and makes energy: nets of discs under 120 times a disc's mass swung up at 3 to 12 m/s. Chains of
/// sliders and wheels under 300 times need all of it.
constexpr float most_stretch(JointKernel kernel) { return kernel == JointKernel::slider || kernel == JointKernel::wheel ? 1.0e37f : 2.0f; }

/// Writes the impulses back for the next step, or notes what tears in a substep before the last.
template <std::uint32_t W>
void store_joints(JointKernel kernel, std::byte* rows, std::uint32_t blocks, const JointOutput& out) {
    const std::size_t block_bytes = joint_block_bytes<W>(kernel);
    over_rows<W>(kernel, [&](auto&& with_row) {
        for (; blocks-- > 0; rows += block_bytes) {
            for (std::uint32_t lane = 0; lane < W; ++lane) {
                const JointEnds<W>& ends = ends_of<W>(rows);
                if (W > 1 && ends.joint[lane] == null_index) continue;
                Joint& joint = out.joints[ends.joint[lane]];
                if ((joint.flags & joint_torn) != 0 || (!out.ends && !joint.can_break())) continue;
                const auto write = [&](Joint& j) {
                    if (has_applied(kernel)) store_applied(applied_of<W>(rows), ends, lane, j, out, most_stretch(kernel));
                    with_row(rows, [&](auto* r) { store(*r, known_lane<W>(lane), j, out); });
                };
                if (out.ends) {
                    write(joint);
                    forget_unsound(joint);
                } else {
                    Joint borne = joint;
                    write(borne);
                    note_torn(joint, borne, out);
                }
            }
        }
    });
}

}  // namespace islet::detail
