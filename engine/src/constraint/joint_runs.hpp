// Runs: blocks of joints of one kernel, side by side. Here a run is handed to the kernel of its joints.
#pragma once

#include "constraint/distance.hpp"
#include "constraint/gear.hpp"
#include "constraint/motor.hpp"
#include "constraint/prismatic.hpp"
#include "constraint/pulley.hpp"
#include "constraint/revolute.hpp"
#include "constraint/weld.hpp"
#include "constraint/wheel.hpp"

namespace islet::detail {

inline JointKernel kernel_of(const Joint& j) {
    switch (j.joint_type()) {
        case JointType::revolute: return revolute_kernel(j);
        case JointType::prismatic: return JointKernel::slider;
        case JointType::distance: return JointKernel::distance;
        case JointType::weld: return JointKernel::weld;
        case JointType::wheel: return JointKernel::wheel;
        case JointType::motor:
        case JointType::mouse: return JointKernel::drive;
        case JointType::pulley: return JointKernel::pulley;
        case JointType::gear: break;
    }
    return JointKernel::gear;
}

/// Calls visit(rows) with a pointer to the blocks of the run's kind.
template <std::uint32_t W, class Visit>
ISLET_LANE auto visit_rows(JointKernel kernel, std::byte* rows, Visit&& visit) {
    // A kernel whose joints are left out of the build is not even compiled.
    switch (kernel) {
        case JointKernel::point:
            if constexpr (has_kernel(JointKernel::point)) return visit(reinterpret_cast<PointRows<W>*>(rows));
            break;
        case JointKernel::hinge:
            if constexpr (has_kernel(JointKernel::hinge)) return visit(reinterpret_cast<HingeRows<W>*>(rows));
            break;
        case JointKernel::slider:
            if constexpr (has_kernel(JointKernel::slider)) return visit(reinterpret_cast<SliderRows<W>*>(rows));
            break;
        case JointKernel::distance:
            if constexpr (has_kernel(JointKernel::distance)) return visit(reinterpret_cast<DistanceRows<W>*>(rows));
            break;
        case JointKernel::weld:
            if constexpr (has_kernel(JointKernel::weld)) return visit(reinterpret_cast<WeldRows<W>*>(rows));
            break;
        case JointKernel::wheel:
            if constexpr (has_kernel(JointKernel::wheel)) return visit(reinterpret_cast<WheelRows<W>*>(rows));
            break;
        case JointKernel::drive:
            if constexpr (has_kernel(JointKernel::drive)) return visit(reinterpret_cast<DriveRows<W>*>(rows));
            break;
        case JointKernel::pulley:
            if constexpr (has_kernel(JointKernel::pulley)) return visit(reinterpret_cast<PulleyRows<W>*>(rows));
            break;
        case JointKernel::gear: break;
    }
    if constexpr (has_kernel(JointKernel::gear) || !has_joints) return visit(reinterpret_cast<GearRows<1>*>(rows));
    __builtin_unreachable();
}

template <std::uint32_t W>
std::size_t joint_block_bytes(JointKernel kernel) {
    return visit_rows<W>(kernel, nullptr, [](auto* r) { return sizeof(*r); });
}

/// Fills the blocks from the joints named, null_index in the padding, and adds their warm starts to the bodies.
template <std::uint32_t W>
void prepare_joints(JointKernel kernel, std::byte* rows, std::uint32_t blocks, const std::uint32_t* joints, const JointInput& in) {
    visit_rows<W>(kernel, rows, [&](auto* r) {
        using Rows = std::remove_pointer_t<decltype(r)>;
        static_assert(sizeof(Rows) <= joint_row_bytes * W);
        std::memset(static_cast<void*>(r), 0, blocks * sizeof(Rows));
        for (std::uint32_t i = 0; i < blocks; ++i) {
            if constexpr (std::is_same_v<Rows, GearRows<1>>) {
                prepare(r[i], 0, joints[i], in);
            } else {
                for (std::uint32_t lane = 0; lane < W; ++lane) {
                    r[i].ends.joint[lane] = null_index;
                    if (joints[i * W + lane] != null_index) prepare(r[i], lane, joints[i * W + lane], in);
                }
            }
        }
    });
}

/// One sweep.
template <class L>
void solve_joints(JointKernel kernel, SolverBody* bodies, std::byte* rows, std::uint32_t blocks, const JointSweep& sweep) {
    visit_rows<L::width>(kernel, rows, [&](auto* r) {
        if constexpr (L::width == 1 || !std::is_same_v<std::remove_pointer_t<decltype(r)>, GearRows<1>>)
            for (std::uint32_t i = 0; i < blocks; ++i) solve<L>(bodies, r[i], sweep);
    });
}

/// Writes the impulses back for the next step.
template <std::uint32_t W>
void store_joints(JointKernel kernel, std::byte* rows, std::uint32_t blocks, const JointOutput& out) {
    visit_rows<W>(kernel, rows, [&](auto* r) {
        for (std::uint32_t i = 0; i < blocks; ++i) {
            if constexpr (std::is_same_v<std::remove_pointer_t<decltype(r)>, GearRows<1>>) {
                store(r[i], 0, out.joints[r[i].joint], out);
                forget_unsound(out.joints[r[i].joint]);
            } else {
                for (std::uint32_t lane = 0; lane < W; ++lane) {
                    if (r[i].ends.joint[lane] == null_index) continue;
                    Joint& j = out.joints[r[i].ends.joint[lane]];
                    store(r[i], lane, j, out);
                    forget_unsound(j);
                }
            }
        }
    });
}

}  // namespace islet::detail
