// All types of joints: what code that concerns every type asks the one at hand.
#pragma once

#include "../constraint/angle_joint.hpp"
#include "../constraint/distance_joint.hpp"
#include "../constraint/gear_joint.hpp"
#include "../constraint/motor_joint.hpp"
#include "../constraint/mouse_joint.hpp"
#include "../constraint/prismatic_joint.hpp"
#include "../constraint/pulley_joint.hpp"
#include "../constraint/revolute_joint.hpp"
#include "../constraint/weld_joint.hpp"
#include "../constraint/wheel_joint.hpp"

namespace islet::detail {

/// Calls visit(JointKind<type>{}). A type that is left out of the build is not even compiled.
template <class Visit>
ISLET_ALWAYS_INLINE inline auto with_kind(JointType type, Visit&& visit) {
    switch (type) {
#define ISLET_CASE(name, definition)                                                                         \
    case JointType::name:                                                                                    \
        if constexpr (has_joint(JointType::name) || !has_joints) return visit(JointKind<JointType::name>{}); \
        break;
        ISLET_JOINT_TYPES(ISLET_CASE)
#undef ISLET_CASE
    }
    ISLET_UNREACHABLE();
}

/// A set of types, as bits.
constexpr std::uint32_t joint_bit(JointType type) { return 1u << static_cast<std::uint32_t>(type); }

/// The types for which has(JointKind<type>{}) is true.
template <class Has>
constexpr std::uint32_t joints_that(Has&& has) {
    std::uint32_t set = 0;
#define ISLET_ADD_IF(name, definition) \
    if (has(JointKind<JointType::name>{})) set |= joint_bit(JointType::name);
    ISLET_JOINT_TYPES(ISLET_ADD_IF)
#undef ISLET_ADD_IF
    return set;
}
inline constexpr std::uint32_t with_coordinate = joints_that([](auto kind) { return kind.has_coordinate; });
inline constexpr std::uint32_t with_friction = joints_that([](auto kind) { return kind.has_friction; });
inline constexpr std::uint32_t with_length = joints_that([](auto kind) { return kind.has_length; });
inline constexpr std::uint32_t with_frames = joints_that([](auto kind) { return kind.has_frames; });
inline constexpr std::uint32_t with_base = joints_that([](auto kind) { return kind.has_base; });
inline constexpr std::uint32_t with_softness = joints_that([](auto kind) { return kind.has_softness; });
inline constexpr std::uint32_t with_strength = joints_that([](auto kind) { return kind.has_strength; });
inline constexpr std::uint32_t with_ratio = joints_that([](auto kind) { return kind.has_ratio; });
inline constexpr std::uint32_t with_turns = joints_that([](auto kind) { return kind.counts_turns; });

/// The coordinate of a joint that has one, now.
ISLET_SHARED float joint_coordinate(const Core& core, const Joint& j) {
    const JointPose p = pose_of(j, core.poses, core.bodies);
    return with_kind(j.joint_type(), [&](auto kind) {
        if constexpr (kind.has_coordinate) return kind.coordinate(j, p);
        return 0.0f;
    });
}

}  // namespace islet::detail
