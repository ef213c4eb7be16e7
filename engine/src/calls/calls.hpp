// The table of the calls that change a world, which recordings write and replays read: a name, the function, and the types of its arguments.
//
// A call's place in the table is its number in recordings. New calls go to the end; a changed one needs a new recording_version.
#pragma once

#include "../data/core.hpp"

// clang-format off
#define ISLET_CALLS(X) \
    X(step, step, float) \
    X(set_gravity, set_gravity, Vec2) \
    X(set_solver, set_solver, SolverDef) \
    X(enable_sleep, enable_sleep, bool) \
    X(enable_continuous, enable_continuous, bool) \
    X(set_hit_threshold, set_hit_threshold, float) \
    X(explode, explode, ExplosionDef) \
    X(create_body, create_body, BodyDef) \
    X(destroy_body, destroy_body, BodyId) \
    X(set_transform, set_transform, BodyId, Vec2, float) \
    X(set_linear_velocity, set_linear_velocity, BodyId, Vec2) \
    X(set_angular_velocity, set_angular_velocity, BodyId, float) \
    X(set_body_target, set_target, BodyId, Transform, float) \
    X(apply_force, apply_force, BodyId, Vec2, Vec2) \
    X(apply_force_to_center, apply_force_to_center, BodyId, Vec2) \
    X(apply_torque, apply_torque, BodyId, float) \
    X(apply_linear_impulse, apply_linear_impulse, BodyId, Vec2, Vec2) \
    X(apply_linear_impulse_to_center, apply_linear_impulse_to_center, BodyId, Vec2) \
    X(apply_angular_impulse, apply_angular_impulse, BodyId, float) \
    X(set_type, set_type, BodyId, BodyType) \
    X(set_mass, set_mass, BodyId, MassData) \
    X(reset_mass, reset_mass, BodyId) \
    X(set_linear_damping, set_linear_damping, BodyId, float) \
    X(set_angular_damping, set_angular_damping, BodyId, float) \
    X(set_gravity_scale, set_gravity_scale, BodyId, float) \
    X(set_fixed_rotation, set_fixed_rotation, BodyId, bool) \
    X(lock_x, lock_x, BodyId, bool) \
    X(lock_y, lock_y, BodyId, bool) \
    X(set_enabled, set_enabled, BodyId, bool) \
    X(set_bullet, set_bullet, BodyId, bool) \
    X(enable_body_sleep, enable_sleep, BodyId, bool) \
    X(set_sleep_threshold, set_sleep_threshold, BodyId, float) \
    X(wake, wake, BodyId) \
    X(set_body_user_data, set_user_data, BodyId, std::uint64_t) \
    X(create_circle, create_shape, BodyId, Circle, ShapeDef) \
    X(create_capsule, create_shape, BodyId, Capsule, ShapeDef) \
    X(create_segment, create_shape, BodyId, Segment, ShapeDef) \
    X(create_polygon, create_shape, BodyId, Polygon, ShapeDef) \
    X(create_chain_segment, create_shape, BodyId, ChainSegment, ShapeDef) \
    X(create_chain, create_chain, BodyId, span<const Vec2>, bool, ShapeDef) \
    X(destroy_shape, destroy_shape, ShapeId) \
    X(set_circle, set_circle, ShapeId, Circle) \
    X(set_capsule, set_capsule, ShapeId, Capsule) \
    X(set_segment, set_segment, ShapeId, Segment) \
    X(set_polygon, set_polygon, ShapeId, Polygon) \
    X(set_density, set_density, ShapeId, float) \
    X(set_friction, set_friction, ShapeId, float) \
    X(set_restitution, set_restitution, ShapeId, float) \
    X(set_rolling_resistance, set_rolling_resistance, ShapeId, float) \
    X(set_tangent_speed, set_tangent_speed, ShapeId, float) \
    X(set_material, set_material, ShapeId, SurfaceMaterial) \
    X(enable_sensor_events, enable_sensor_events, ShapeId, bool) \
    X(enable_hit_events, enable_hit_events, ShapeId, bool) \
    X(enable_pre_solve, enable_pre_solve, ShapeId, bool) \
    X(apply_wind, apply_wind, ShapeId, WindDef) \
    X(set_filter, set_filter, ShapeId, Filter) \
    X(set_shape_user_data, set_user_data, ShapeId, std::uint64_t) \
    X(create_revolute_joint, create_joint, RevoluteJointDef) \
    X(create_prismatic_joint, create_joint, PrismaticJointDef) \
    X(create_distance_joint, create_joint, DistanceJointDef) \
    X(create_weld_joint, create_joint, WeldJointDef) \
    X(create_wheel_joint, create_joint, WheelJointDef) \
    X(create_motor_joint, create_joint, MotorJointDef) \
    X(create_mouse_joint, create_joint, MouseJointDef) \
    X(create_pulley_joint, create_joint, PulleyJointDef) \
    X(create_gear_joint, create_joint, GearJointDef) \
    X(destroy_joint, destroy_joint, JointId) \
    X(set_frames, set_frames, JointId, JointFrame, JointFrame) \
    X(set_collide_connected, set_collide_connected, JointId, bool) \
    X(set_break, set_break, JointId, float, float) \
    X(set_joint_user_data, set_user_data, JointId, std::uint64_t) \
    X(set_spring, set_spring, JointId, JointSpring) \
    X(set_limit, set_limit, JointId, JointLimit) \
    X(set_motor, set_motor, JointId, JointMotor) \
    X(set_joint_friction, set_joint_friction, JointId, float) \
    X(set_joint_length, set_joint_length, JointId, float) \
    X(set_joint_velocity, set_joint_velocity, JointId, Vec2, float) \
    X(set_joint_strength, set_joint_strength, JointId, float, float) \
    X(set_joint_target, set_target, JointId, Vec2) \
    X(set_one_way, set_one_way, ShapeId, Vec2) \
    X(create_angle_joint, create_joint, AngleJointDef) \
    X(set_ratchet, set_ratchet, JointId, JointRatchet) \
    X(create_half_space, create_shape, BodyId, HalfSpace, ShapeDef) \
    X(set_half_space, set_half_space, ShapeId, HalfSpace) \
    X(set_restitution_threshold, set_restitution_threshold, float) \
    X(set_max_speed, set_max_speed, float) \
    X(set_pose, set_transform, BodyId, Transform) \
    X(sleep, sleep, BodyId) \
    X(set_chain_segment, set_chain_segment, ShapeId, ChainSegment) \
    X(set_sensor, set_sensor, ShapeId, bool) \
    X(set_softness, set_softness, JointId, JointSoftness) \
    X(set_grounds, set_grounds, JointId, Vec2, Vec2) \
    X(set_joint_ratio, set_joint_ratio, JointId, float) \
    X(apply_force_no_wake, apply_force, BodyId, Vec2, Vec2, bool) \
    X(apply_force_to_center_no_wake, apply_force_to_center, BodyId, Vec2, bool) \
    X(apply_torque_no_wake, apply_torque, BodyId, float, bool) \
    X(apply_linear_impulse_no_wake, apply_linear_impulse, BodyId, Vec2, Vec2, bool) \
    X(apply_linear_impulse_to_center_no_wake, apply_linear_impulse_to_center, BodyId, Vec2, bool) \
    X(apply_angular_impulse_no_wake, apply_angular_impulse, BodyId, float, bool) \
    X(enable_seamless_floors, enable_seamless_floors, bool)
// clang-format on

namespace islet::detail {

enum class Call : std::uint32_t {
    stepped,  // the result of a step
    ended,    // the end of a recording
    image,    // the world was taken back to a snapshot
#define ISLET_NAME(name, function, ...) name,
    ISLET_CALLS(ISLET_NAME)
#undef ISLET_NAME
};

/// Whether a call leaves the plan of a step as it is, but for bodies that it wakes and joint trees that it makes stale, which is noted there.
constexpr bool keeps_plan_of(Call call) {
    switch (call) {
        case Call::step:
        case Call::set_gravity:
        case Call::set_hit_threshold:
        case Call::set_restitution_threshold:
        case Call::set_max_speed:
        case Call::set_linear_velocity:
        case Call::set_angular_velocity:
        case Call::set_body_target:
        case Call::apply_force:
        case Call::apply_force_to_center:
        case Call::apply_torque:
        case Call::apply_linear_impulse:
        case Call::apply_linear_impulse_to_center:
        case Call::apply_angular_impulse:
        case Call::apply_force_no_wake:
        case Call::apply_force_to_center_no_wake:
        case Call::apply_torque_no_wake:
        case Call::apply_linear_impulse_no_wake:
        case Call::apply_linear_impulse_to_center_no_wake:
        case Call::apply_angular_impulse_no_wake:
        case Call::apply_wind:
        case Call::wake:
        case Call::set_spring:
        case Call::set_limit:
        case Call::set_motor:
        case Call::set_joint_length:
        case Call::set_joint_velocity:
        case Call::set_joint_strength:
        case Call::set_joint_target:
        case Call::set_body_user_data:
        case Call::set_shape_user_data:
        case Call::set_joint_user_data: return true;
        default: return false;
    }
}

/// The header of a recording, at the start of the caller's memory. A snapshot follows, and then the calls, in words of 32 bits.
struct RecordingHead {
    std::uint32_t magic = 0;
    std::uint32_t version = 0;
    std::uint64_t image_bytes = 0;
    std::uint64_t size = 0;    // bytes of the memory; of a recording that has ended, of the part used
    std::uint64_t used = 0;    // bytes
    std::uint64_t sum = 0;     // of all words since the snapshot
    std::uint32_t bodies = 0;  // 1: each step has a hash of each awake body
    std::uint32_t full = 0;    // 1: there was no more room
};

// -- arguments as words ---------------------------------------------------------------------------------------------------------------
//
// members(visit, value) calls visit with the value's members, in an order that is part of the format.

// clang-format off
template <class V> constexpr void members(V& v, Vec2& a) { v(a.x, a.y); }
template <class V> constexpr void members(V& v, Rot& a) { v(a.c, a.s); }
template <class V> constexpr void members(V& v, Transform& a) { v(a.p, a.q); }
template <class V> constexpr void members(V& v, BodyId& a) { v(a.index1, a.generation); }
template <class V> constexpr void members(V& v, ShapeId& a) { v(a.index1, a.generation); }
template <class V> constexpr void members(V& v, JointId& a) { v(a.index1, a.generation); }
template <class V> constexpr void members(V& v, Filter& a) { v(a.category, a.mask, a.group); }
template <class V> constexpr void members(V& v, MassData& a) { v(a.mass, a.center, a.inertia); }
template <class V> constexpr void members(V& v, SurfaceMaterial& a) { v(a.friction, a.restitution, a.rolling_resistance, a.tangent_speed, a.id); }
template <class V> constexpr void members(V& v, ExplosionDef& a) { v(a.position, a.radius, a.falloff, a.impulse_per_length, a.mask); }
template <class V> constexpr void members(V& v, WindDef& a) { v(a.velocity, a.drag, a.lift, a.density, a.wake); }
template <class V> constexpr void members(V& v, Circle& a) { v(a.center, a.radius); }
template <class V> constexpr void members(V& v, Capsule& a) { v(a.point1, a.point2, a.radius); }
template <class V> constexpr void members(V& v, Segment& a) { v(a.point1, a.point2); }
template <class V> constexpr void members(V& v, ChainSegment& a) { v(a.ghost1, a.segment, a.ghost2); }
template <class V> constexpr void members(V& v, HalfSpace& a) { v(a.normal, a.offset); }
template <class V> constexpr void members(V& v, Polygon& a) {
    for (Vec2& p : a.vertices) v(p);
    for (Vec2& p : a.normals) v(p);
    v(a.centroid, a.radius, a.count);
}
template <class V> constexpr void members(V& v, SolverDef& a) {
    v(a.schedule, a.substeps, a.iterations, a.relax_iterations, a.contact_hertz, a.contact_damping_ratio, a.contact_push_speed, a.joint_hertz,
      a.joint_damping_ratio, a.baumgarte, a.omega, a.warm_start, a.joint_trees, a.joint_tree_load, a.sweep_order, a.block_contacts, a.shock,
      a.measure_residual, a.tolerance);
}
template <class V> constexpr void members(V& v, BodyDef& a) {
    v(a.type, a.position, a.angle, a.linear_velocity, a.angular_velocity, a.linear_damping, a.angular_damping, a.gravity_scale, a.sleep_threshold,
      a.enable_sleep, a.awake, a.fixed_rotation, a.lock_x, a.lock_y, a.enabled, a.bullet, a.user_data);
}
template <class V> constexpr void members(V& v, ShapeDef& a) {
    v(a.friction, a.restitution, a.rolling_resistance, a.tangent_speed, a.density, a.filter, a.sensor, a.sensor_events, a.hit_events, a.pre_solve,
      a.one_way, a.material, a.user_data);
}
template <class V> constexpr void members(V& v, JointFrame& a) { v(a.position, a.angle); }
template <class V> constexpr void members(V& v, JointSpring& a) { v(a.enable, a.hertz, a.damping_ratio, a.target); }
template <class V> constexpr void members(V& v, JointSoftness& a) {
    v(a.linear_hertz, a.linear_damping_ratio, a.angular_hertz, a.angular_damping_ratio);
}
template <class V> constexpr void members(V& v, JointLimit& a) { v(a.enable, a.lower, a.upper); }
template <class V> constexpr void members(V& v, JointMotor& a) { v(a.enable, a.speed, a.max_force); }
template <class V> constexpr void members(V& v, JointBase& a) {
    v(a.body_a, a.body_b, a.frame_a, a.frame_b, a.collide_connected, a.break_force, a.break_torque, a.user_data);
}
template <class V> constexpr void members(V& v, RevoluteJointDef& a) { v(a.base, a.spring, a.limit, a.motor, a.friction); }
template <class V> constexpr void members(V& v, PrismaticJointDef& a) { v(a.base, a.spring, a.limit, a.motor, a.friction); }
template <class V> constexpr void members(V& v, DistanceJointDef& a) { v(a.base, a.length, a.spring, a.limit, a.motor); }
template <class V> constexpr void members(V& v, WeldJointDef& a) {
    v(a.base, a.linear_hertz, a.linear_damping_ratio, a.angular_hertz, a.angular_damping_ratio);
}
template <class V> constexpr void members(V& v, WheelJointDef& a) { v(a.base, a.spring, a.limit, a.motor, a.friction); }
template <class V> constexpr void members(V& v, MotorJointDef& a) {
    v(a.base, a.linear_velocity, a.angular_velocity, a.max_force, a.max_torque, a.linear_hertz, a.linear_damping_ratio, a.angular_hertz,
      a.angular_damping_ratio);
}
template <class V> constexpr void members(V& v, MouseJointDef& a) { v(a.body, a.target, a.hertz, a.damping_ratio, a.max_force, a.user_data); }
template <class V> constexpr void members(V& v, PulleyJointDef& a) { v(a.base, a.ground_a, a.ground_b, a.ratio); }
template <class V> constexpr void members(V& v, JointRatchet& a) { v(a.step, a.phase); }
template <class V> constexpr void members(V& v, AngleJointDef& a) { v(a.base, a.spring, a.limit, a.motor, a.friction, a.ratchet); }
template <class V> constexpr void members(V& v, GearJointDef& a) { v(a.joint1, a.joint2, a.ratio, a.break_torque, a.user_data); }
// clang-format on

/// Nothing; only its type counts, to find out what has members.
struct NoVisit {
    template <class... T>
    void operator()(T&...);
};
template <class T, class = void>
inline constexpr bool has_members = false;
template <class T>
inline constexpr bool has_members<T, decltype(members(*static_cast<NoVisit*>(nullptr), *static_cast<T*>(nullptr)))> = true;

}  // namespace islet::detail
