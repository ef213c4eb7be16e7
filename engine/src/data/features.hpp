// What this build has (islet/config.hpp), as constants; and hints by which the compiler leaves out what cannot happen in it.
#pragma once

#include "islet/config.hpp"
#include "islet/geometry.hpp"
#include "islet/joints.hpp"

/// Before a declaration: whoever calls the function does not make the linker take it from an archive; someone else must. Callers have to know from the
/// world's state that someone did.
#if defined(__ELF__)
#define ISLET_OPTIONAL [[gnu::weak]]
/// Whether someone did.
#define ISLET_IS_LINKED(function) (&(function) != nullptr)
#else
#define ISLET_OPTIONAL
#define ISLET_IS_LINKED(function) true
#endif

// 1 if a macro is defined as 1 (-DNAME) or as nothing (#define NAME), 0 if it is defined as anything else or not at all. (A name that is 1 makes
// ISLET_BEFORE_1, which is two arguments, and pushes the 1 to second place.)
#define ISLET_BEFORE_1 0,
#define ISLET_BEFORE_ 0,
#define ISLET_SECOND(first, second, ...) second
#define ISLET_SECOND_OF(before) ISLET_SECOND(before 1, 0, 0)
#define ISLET_PASTED(value) ISLET_SECOND_OF(ISLET_BEFORE_##value)
#define ISLET_IS_SET(name) ISLET_PASTED(name)

namespace islet::detail {

inline constexpr bool has_engine = true;
inline constexpr bool in_profile_small = true;
inline constexpr bool in_profile_full = ISLET_SMALL == 0;
inline constexpr bool in_profile_hinges = in_profile_full || ISLET_IS_SET(ISLET_WITH_joints) != 0 || ISLET_IS_SET(ISLET_WITH_revolute_joints) != 0;
#define ISLET_HAS(name, needs, profile) \
    inline constexpr bool has_##name = has_##needs && (in_profile_##profile || ISLET_IS_SET(ISLET_WITH_##name) != 0) && ISLET_IS_SET(ISLET_WITHOUT_##name) == 0;
ISLET_FEATURES(ISLET_HAS)
#undef ISLET_HAS

constexpr bool has_shape(ShapeType type) {
#define ISLET_HAS_SHAPE(name, Type, feature, ...) \
    if (type == ShapeType::name) return has_##feature;
    ISLET_SHAPE_TYPES(ISLET_HAS_SHAPE)
#undef ISLET_HAS_SHAPE
    return false;
}

constexpr bool has_joint(JointType type) {
#define ISLET_HAS_JOINT(name, definition)                                                                                    \
    if (type == JointType::name)                                                                                             \
        return (in_profile_full || ISLET_IS_SET(ISLET_WITH_joints) != 0 || ISLET_IS_SET(ISLET_WITH_##name##_joints) != 0) && \
               ISLET_IS_SET(ISLET_WITHOUT_joints) == 0 && ISLET_IS_SET(ISLET_WITHOUT_##name##_joints) == 0;
    ISLET_JOINT_TYPES(ISLET_HAS_JOINT)
#undef ISLET_HAS_JOINT
    return false;
}

#define ISLET_OR_SHAPE_CUT(name, ...) || !has_shape(ShapeType::name)
#define ISLET_OR_JOINT(name, definition) || has_joint(JointType::name)
#define ISLET_OR_JOINT_CUT(name, definition) || !has_joint(JointType::name)
inline constexpr bool has_all_shapes = !(false ISLET_SHAPE_TYPES(ISLET_OR_SHAPE_CUT));
inline constexpr bool has_joints = false ISLET_JOINT_TYPES(ISLET_OR_JOINT);
inline constexpr bool has_all_joints = !(false ISLET_JOINT_TYPES(ISLET_OR_JOINT_CUT));
#undef ISLET_OR_SHAPE_CUT
#undef ISLET_OR_JOINT
#undef ISLET_OR_JOINT_CUT

/// The type itself; one that is left out cannot be met. (Type by type: of a table the compiler would learn nothing.)
constexpr ShapeType known(ShapeType type) {
#define ISLET_KNOWN(name, Type, feature, ...) \
    if (!has_##feature && type == ShapeType::name) ISLET_UNREACHABLE();
    ISLET_SHAPE_TYPES(ISLET_KNOWN)
#undef ISLET_KNOWN
    return type;
}
constexpr JointType known(JointType type) {
#define ISLET_KNOWN(name, definition) \
    if (!has_joint(JointType::name) && type == JointType::name) ISLET_UNREACHABLE();
    ISLET_JOINT_TYPES(ISLET_KNOWN)
#undef ISLET_KNOWN
    return type;
}

}  // namespace islet::detail
