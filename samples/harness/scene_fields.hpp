// The fields of a scene file, by the names they have in the engine's definitions: one list of each, for reading and for writing.
//
// `io(name, value, usual)` is called for each field; `usual` is the value of one that a file does not name.
#pragma once

#include "scene.hpp"

namespace islet::samples {

/// The names of an enumeration's values in files, in order.
template <class Enum>
inline constexpr const char* const* enum_names = nullptr;

inline constexpr const char* body_type_names[] = {"static", "kinematic", "dynamic", nullptr};
template <>
inline constexpr const char* const* enum_names<BodyType> = body_type_names;
inline constexpr const char* schedule_names[] = {"soft", "classic", nullptr};
template <>
inline constexpr const char* const* enum_names<Schedule> = schedule_names;
inline constexpr const char* joint_trees_names[] = {"off", "automatic", "all", nullptr};
template <>
inline constexpr const char* const* enum_names<JointTrees> = joint_trees_names;
inline constexpr const char* sweep_order_names[] = {"colored", "as_found", "upward", "downward", nullptr};
template <>
inline constexpr const char* const* enum_names<SweepOrder> = sweep_order_names;

/// By the order of SceneGeometry and of JointDef.
inline constexpr const char* geometry_names[] = {"circle", "capsule", "segment", "polygon", "chain", "half_space", nullptr};
inline constexpr const char* joint_names[] = {"revolute", "prismatic", "distance", "weld", "wheel", "motor", "mouse", "pulley", "gear", "angle", nullptr};

/// Both const for a writer; a reader fills `d` in.
template <class Io, class D>
void fields(Io& io, D& d, const SolverDef& usual) requires std::is_same_v<std::remove_const_t<D>, SolverDef> {
    io("schedule", d.schedule, usual.schedule);
    io("substeps", d.substeps, usual.substeps);
    io("iterations", d.iterations, usual.iterations);
    io("relax_iterations", d.relax_iterations, usual.relax_iterations);
    io("contact_hertz", d.contact_hertz, usual.contact_hertz);
    io("contact_damping_ratio", d.contact_damping_ratio, usual.contact_damping_ratio);
    io("contact_push_speed", d.contact_push_speed, usual.contact_push_speed);
    io("joint_hertz", d.joint_hertz, usual.joint_hertz);
    io("joint_damping_ratio", d.joint_damping_ratio, usual.joint_damping_ratio);
    io("baumgarte", d.baumgarte, usual.baumgarte);
    io("omega", d.omega, usual.omega);
    io("warm_start", d.warm_start, usual.warm_start);
    io("joint_trees", d.joint_trees, usual.joint_trees);
    io("joint_tree_load", d.joint_tree_load, usual.joint_tree_load);
    io("sweep_order", d.sweep_order, usual.sweep_order);
    io("block_contacts", d.block_contacts, usual.block_contacts);
    io("shock", d.shock, usual.shock);
    io("measure_residual", d.measure_residual, usual.measure_residual);
    io("tolerance", d.tolerance, usual.tolerance);
}

template <class Io, class D>
void fields(Io& io, D& d, const WorldDef& usual) requires std::is_same_v<std::remove_const_t<D>, WorldDef> {
    io("gravity", d.gravity, usual.gravity);
    io("solver", d.solver, usual.solver);
    io("enable_sleep", d.enable_sleep, usual.enable_sleep);
    io("restitution_threshold", d.restitution_threshold, usual.restitution_threshold);
    io("max_speed", d.max_speed, usual.max_speed);
    io("hit_threshold", d.hit_threshold, usual.hit_threshold);
    io("continuous", d.continuous, usual.continuous);
}

template <class Io, class D>
void fields(Io& io, D& d, const BodyDef& usual) requires std::is_same_v<std::remove_const_t<D>, BodyDef> {
    io("type", d.type, usual.type);
    io("position", d.position, usual.position);
    io("angle", d.angle, usual.angle);
    io("linear_velocity", d.linear_velocity, usual.linear_velocity);
    io("angular_velocity", d.angular_velocity, usual.angular_velocity);
    io("linear_damping", d.linear_damping, usual.linear_damping);
    io("angular_damping", d.angular_damping, usual.angular_damping);
    io("gravity_scale", d.gravity_scale, usual.gravity_scale);
    io("sleep_threshold", d.sleep_threshold, usual.sleep_threshold);
    io("enable_sleep", d.enable_sleep, usual.enable_sleep);
    io("awake", d.awake, usual.awake);
    io("fixed_rotation", d.fixed_rotation, usual.fixed_rotation);
    io("lock_x", d.lock_x, usual.lock_x);
    io("lock_y", d.lock_y, usual.lock_y);
    io("enabled", d.enabled, usual.enabled);
    io("bullet", d.bullet, usual.bullet);
    io("user_data", d.user_data, usual.user_data);
}

template <class Io, class D>
void fields(Io& io, D& d, const Filter& usual) requires std::is_same_v<std::remove_const_t<D>, Filter> {
    io("category", d.category, usual.category);
    io("mask", d.mask, usual.mask);
    io("group", d.group, usual.group);
}

template <class Io, class D>
void fields(Io& io, D& d, const ShapeDef& usual) requires std::is_same_v<std::remove_const_t<D>, ShapeDef> {
    io("friction", d.friction, usual.friction);
    io("restitution", d.restitution, usual.restitution);
    io("rolling_resistance", d.rolling_resistance, usual.rolling_resistance);
    io("tangent_speed", d.tangent_speed, usual.tangent_speed);
    io("density", d.density, usual.density);
    io("filter", d.filter, usual.filter);
    io("sensor", d.sensor, usual.sensor);
    io("sensor_events", d.sensor_events, usual.sensor_events);
    io("hit_events", d.hit_events, usual.hit_events);
    io("pre_solve", d.pre_solve, usual.pre_solve);
    io("one_way", d.one_way, usual.one_way);
    io("material", d.material, usual.material);
    io("user_data", d.user_data, usual.user_data);
}

template <class Io, class D>
void fields(Io& io, D& d, const Circle& usual) requires std::is_same_v<std::remove_const_t<D>, Circle> {
    io("center", d.center, usual.center);
    io("radius", d.radius, usual.radius);
}

template <class Io, class D>
void fields(Io& io, D& d, const Capsule& usual) requires std::is_same_v<std::remove_const_t<D>, Capsule> {
    io("point1", d.point1, usual.point1);
    io("point2", d.point2, usual.point2);
    io("radius", d.radius, usual.radius);
}

template <class Io, class D>
void fields(Io& io, D& d, const Segment& usual) requires std::is_same_v<std::remove_const_t<D>, Segment> {
    io("point1", d.point1, usual.point1);
    io("point2", d.point2, usual.point2);
}

template <class Io, class D>
void fields(Io& io, D& d, const HalfSpace& usual) requires std::is_same_v<std::remove_const_t<D>, HalfSpace> {
    io("normal", d.normal, usual.normal);
    io("offset", d.offset, usual.offset);
}

template <class Io, class D>
void fields(Io& io, D& d, const Chain& usual) requires std::is_same_v<std::remove_const_t<D>, Chain> {
    io("points", d.points, usual.points);
    io("loop", d.loop, usual.loop);
}

template <class Io, class D>
void fields(Io& io, D& d, const JointFrame& usual) requires std::is_same_v<std::remove_const_t<D>, JointFrame> {
    io("position", d.position, usual.position);
    io("angle", d.angle, usual.angle);
}

template <class Io, class D>
void fields(Io& io, D& d, const JointSpring& usual) requires std::is_same_v<std::remove_const_t<D>, JointSpring> {
    io("enable", d.enable, usual.enable);
    io("hertz", d.hertz, usual.hertz);
    io("damping_ratio", d.damping_ratio, usual.damping_ratio);
    io("target", d.target, usual.target);
}

template <class Io, class D>
void fields(Io& io, D& d, const JointLimit& usual) requires std::is_same_v<std::remove_const_t<D>, JointLimit> {
    io("enable", d.enable, usual.enable);
    io("lower", d.lower, usual.lower);
    io("upper", d.upper, usual.upper);
}

template <class Io, class D>
void fields(Io& io, D& d, const JointMotor& usual) requires std::is_same_v<std::remove_const_t<D>, JointMotor> {
    io("enable", d.enable, usual.enable);
    io("speed", d.speed, usual.speed);
    io("max_force", d.max_force, usual.max_force);
}

template <class Io, class D>
void fields(Io& io, D& d, const JointRatchet& usual) requires std::is_same_v<std::remove_const_t<D>, JointRatchet> {
    io("step", d.step, usual.step);
    io("phase", d.phase, usual.phase);
}

/// Any joint: the fields its definition has, those of its base as if they were its own.
template <class Io, class D>
void joint_fields(Io& io, D& d, const std::remove_const_t<D>& usual) {
    if constexpr (requires { d.base; }) {
        io("frame_a", d.base.frame_a, usual.base.frame_a);
        io("frame_b", d.base.frame_b, usual.base.frame_b);
        io("collide_connected", d.base.collide_connected, usual.base.collide_connected);
        io("break_force", d.base.break_force, usual.base.break_force);
        io("break_torque", d.base.break_torque, usual.base.break_torque);
        io("user_data", d.base.user_data, usual.base.user_data);
    }
    if constexpr (requires { d.spring; }) io("spring", d.spring, usual.spring);
    if constexpr (requires { d.ratchet; }) io("ratchet", d.ratchet, usual.ratchet);
    if constexpr (requires { d.limit; }) io("limit", d.limit, usual.limit);
    if constexpr (requires { d.motor; }) io("motor", d.motor, usual.motor);
    if constexpr (requires { d.friction; }) io("friction", d.friction, usual.friction);
    if constexpr (requires { d.length; }) io("length", d.length, usual.length);
    if constexpr (requires { d.linear_velocity; }) {
        io("linear_velocity", d.linear_velocity, usual.linear_velocity);
        io("angular_velocity", d.angular_velocity, usual.angular_velocity);
        io("max_torque", d.max_torque, usual.max_torque);
    }
    if constexpr (requires { d.linear_hertz; }) {
        io("linear_hertz", d.linear_hertz, usual.linear_hertz);
        io("linear_damping_ratio", d.linear_damping_ratio, usual.linear_damping_ratio);
        io("angular_hertz", d.angular_hertz, usual.angular_hertz);
        io("angular_damping_ratio", d.angular_damping_ratio, usual.angular_damping_ratio);
    }
    if constexpr (requires { d.target; }) {
        io("target", d.target, usual.target);
        io("hertz", d.hertz, usual.hertz);
        io("damping_ratio", d.damping_ratio, usual.damping_ratio);
    }
    if constexpr (requires { d.max_force; }) io("max_force", d.max_force, usual.max_force);
    if constexpr (requires { d.ground_a; }) {
        io("ground_a", d.ground_a, usual.ground_a);
        io("ground_b", d.ground_b, usual.ground_b);
    }
    if constexpr (requires { d.ratio; }) io("ratio", d.ratio, usual.ratio);
    if constexpr (requires { d.break_torque; }) io("break_torque", d.break_torque, usual.break_torque);
    if constexpr (requires { d.user_data; }) io("user_data", d.user_data, usual.user_data);
}

/// Of a scene, but for its bodies and joints.
template <class Io, class D>
void fields(Io& io, D& d, const Scene& usual) requires std::is_same_v<std::remove_const_t<D>, Scene> {
    io("name", d.name, usual.name);
    io("steps", d.steps, usual.steps);
    io("dt", d.dt, usual.dt);
    io("view", d.view, usual.view);
    io("traced", d.traced, usual.traced);
    io("world", d.world, usual.world);
    io("extra_contacts", d.extra_contacts, usual.extra_contacts);
}

}  // namespace islet::samples
