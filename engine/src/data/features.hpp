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

namespace islet::detail {

inline constexpr bool is_lean = ISLET_LEAN != 0;
inline constexpr bool has_engine = true;
inline constexpr bool has_polygons = ISLET_POLYGONS != 0;
inline constexpr bool has_capsules = ISLET_CAPSULES != 0;
inline constexpr bool has_segments = ISLET_SEGMENTS != 0;
inline constexpr bool has_chains = ISLET_CHAINS != 0;
inline constexpr bool has_restitution = ISLET_RESTITUTION != 0;
inline constexpr bool has_surfaces = ISLET_SURFACES != 0;
inline constexpr bool has_sleep = ISLET_SLEEP != 0;
inline constexpr bool has_continuous = ISLET_CONTINUOUS != 0;
inline constexpr bool has_sensors = ISLET_SENSORS != 0;
inline constexpr bool has_hits = ISLET_HITS != 0;
inline constexpr bool has_hooks = ISLET_HOOKS != 0;
inline constexpr bool has_one_way = ISLET_ONE_WAY != 0;
inline constexpr bool has_queries = ISLET_QUERIES != 0;
inline constexpr bool has_mover = ISLET_MOVER != 0 && has_queries;
inline constexpr bool has_recorder = ISLET_RECORDER != 0;
inline constexpr bool has_tuning = ISLET_TUNING != 0;
inline constexpr bool has_profile = ISLET_PROFILE != 0;

constexpr bool has_shape(ShapeType type) {
#define ISLET_HAS_SHAPE(name, Type, feature, ...) \
    if (type == ShapeType::name) return has_##feature;
    ISLET_SHAPE_TYPES(ISLET_HAS_SHAPE)
#undef ISLET_HAS_SHAPE
    return false;
}

constexpr bool has_joint(JointType type) {
    switch (type) {
        case JointType::revolute: return ISLET_REVOLUTE_JOINTS != 0;
        case JointType::prismatic: return ISLET_PRISMATIC_JOINTS != 0;
        case JointType::distance: return ISLET_DISTANCE_JOINTS != 0;
        case JointType::weld: return ISLET_WELD_JOINTS != 0;
        case JointType::wheel: return ISLET_WHEEL_JOINTS != 0;
        case JointType::motor: return ISLET_MOTOR_JOINTS != 0;
        case JointType::mouse: return ISLET_MOUSE_JOINTS != 0;
        case JointType::pulley: return ISLET_PULLEY_JOINTS != 0;
        case JointType::gear: return ISLET_GEAR_JOINTS != 0;
    }
    return false;
}

inline constexpr bool has_joints = has_joint(JointType::revolute) || has_joint(JointType::prismatic) || has_joint(JointType::distance) ||
                                   has_joint(JointType::weld) || has_joint(JointType::wheel) || has_joint(JointType::motor) || has_joint(JointType::mouse) ||
                                   has_joint(JointType::pulley) || has_joint(JointType::gear);

inline constexpr bool has_all_shapes = has_polygons && has_capsules && has_segments && has_chains;
inline constexpr bool has_all_joints = has_joint(JointType::revolute) && has_joint(JointType::prismatic) && has_joint(JointType::distance) &&
                                       has_joint(JointType::weld) && has_joint(JointType::wheel) && has_joint(JointType::motor) &&
                                       has_joint(JointType::mouse) && has_joint(JointType::pulley) && has_joint(JointType::gear);

/// The type itself; one that is left out cannot be met. (Type by type: of a table the compiler would learn nothing.)
constexpr ShapeType known(ShapeType type) {
#define ISLET_KNOWN(name, Type, feature, ...) \
    if (!has_##feature && type == ShapeType::name) __builtin_unreachable();
    ISLET_SHAPE_TYPES(ISLET_KNOWN)
#undef ISLET_KNOWN
    return type;
}
constexpr JointType known(JointType type) {
    if (!has_joint(JointType::revolute) && type == JointType::revolute) __builtin_unreachable();
    if (!has_joint(JointType::prismatic) && type == JointType::prismatic) __builtin_unreachable();
    if (!has_joint(JointType::distance) && type == JointType::distance) __builtin_unreachable();
    if (!has_joint(JointType::weld) && type == JointType::weld) __builtin_unreachable();
    if (!has_joint(JointType::wheel) && type == JointType::wheel) __builtin_unreachable();
    if (!has_joint(JointType::motor) && type == JointType::motor) __builtin_unreachable();
    if (!has_joint(JointType::mouse) && type == JointType::mouse) __builtin_unreachable();
    if (!has_joint(JointType::pulley) && type == JointType::pulley) __builtin_unreachable();
    if (!has_joint(JointType::gear) && type == JointType::gear) __builtin_unreachable();
    return type;
}

}  // namespace islet::detail
