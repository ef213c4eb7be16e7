// The defaults of C are those of C++.
//
// Made by bindings/c/generate.py; do not edit.
#include <gtest/gtest.h>
#include <islet/islet.h>

#include <islet/islet.hpp>
#include <islet/island.hpp>
#include <islet/mover.hpp>

namespace {

void expect_same(const IsletVec2& c, const islet::Vec2& cpp) {
    EXPECT_EQ(c.x, cpp.x);
    EXPECT_EQ(c.y, cpp.y);
}

void expect_same(const IsletRot& c, const islet::Rot& cpp) {
    EXPECT_EQ(c.c, cpp.c);
    EXPECT_EQ(c.s, cpp.s);
}

void expect_same(const IsletAabb& c, const islet::Aabb& cpp) {
    expect_same(c.lower, cpp.lower);
    expect_same(c.upper, cpp.upper);
}

void expect_same(const IsletFilter& c, const islet::Filter& cpp) {
    EXPECT_EQ(c.category, cpp.category);
    EXPECT_EQ(c.mask, cpp.mask);
    EXPECT_EQ(c.group, cpp.group);
}

void expect_same(const IsletShapeId& c, const islet::ShapeId& cpp) {
    EXPECT_EQ(c.index1, cpp.index1);
    EXPECT_EQ(c.generation, cpp.generation);
}

void expect_same(const IsletContactInfo& c, const islet::ContactInfo& cpp) {
    expect_same(c.shape_a, cpp.shape_a);
    expect_same(c.shape_b, cpp.shape_b);
    expect_same(c.normal, cpp.normal);
    EXPECT_EQ(c.point_count, cpp.point_count);
    EXPECT_EQ(c.friction, cpp.friction);
    EXPECT_EQ(c.restitution, cpp.restitution);
}

void expect_same(const IsletBodyId& c, const islet::BodyId& cpp) {
    EXPECT_EQ(c.index1, cpp.index1);
    EXPECT_EQ(c.generation, cpp.generation);
}

void expect_same(const IsletJointFrame& c, const islet::JointFrame& cpp) {
    expect_same(c.position, cpp.position);
    EXPECT_EQ(c.angle, cpp.angle);
}

void expect_same(const IsletJointBase& c, const islet::JointBase& cpp) {
    expect_same(c.body_a, cpp.body_a);
    expect_same(c.body_b, cpp.body_b);
    expect_same(c.frame_a, cpp.frame_a);
    expect_same(c.frame_b, cpp.frame_b);
    EXPECT_EQ(c.collide_connected, cpp.collide_connected);
    EXPECT_EQ(c.break_force, cpp.break_force);
    EXPECT_EQ(c.break_torque, cpp.break_torque);
    EXPECT_EQ(c.user_data, cpp.user_data);
}

void expect_same(const IsletJointSpring& c, const islet::JointSpring& cpp) {
    EXPECT_EQ(c.enable, cpp.enable);
    EXPECT_EQ(c.hertz, cpp.hertz);
    EXPECT_EQ(c.damping_ratio, cpp.damping_ratio);
    EXPECT_EQ(c.target, cpp.target);
}

void expect_same(const IsletJointLimit& c, const islet::JointLimit& cpp) {
    EXPECT_EQ(c.enable, cpp.enable);
    EXPECT_EQ(c.lower, cpp.lower);
    EXPECT_EQ(c.upper, cpp.upper);
}

void expect_same(const IsletJointMotor& c, const islet::JointMotor& cpp) {
    EXPECT_EQ(c.enable, cpp.enable);
    EXPECT_EQ(c.speed, cpp.speed);
    EXPECT_EQ(c.max_force, cpp.max_force);
}

void expect_same(const IsletJointId& c, const islet::JointId& cpp) {
    EXPECT_EQ(c.index1, cpp.index1);
    EXPECT_EQ(c.generation, cpp.generation);
}

void expect_same(const IsletJointRatchet& c, const islet::JointRatchet& cpp) {
    EXPECT_EQ(c.step, cpp.step);
    EXPECT_EQ(c.phase, cpp.phase);
}

void expect_same(const IsletCapsule& c, const islet::Capsule& cpp) {
    expect_same(c.point1, cpp.point1);
    expect_same(c.point2, cpp.point2);
    EXPECT_EQ(c.radius, cpp.radius);
}

void expect_same(const IsletQueryFilter& c, const islet::QueryFilter& cpp) {
    EXPECT_EQ(c.category, cpp.category);
    EXPECT_EQ(c.mask, cpp.mask);
    EXPECT_EQ(c.sensors, cpp.sensors);
}

TEST(Defaults, OfRot) { expect_same(islet_default_rot(), {}); }

TEST(Defaults, OfTransform) {
    const IsletTransform c = islet_default_transform();
    [[maybe_unused]] const islet::Transform cpp = {};
    expect_same(c.p, cpp.p);
    expect_same(c.q, cpp.q);
}

TEST(Defaults, OfCircle) {
    const IsletCircle c = islet_default_circle();
    [[maybe_unused]] const islet::Circle cpp = {};
    expect_same(c.center, cpp.center);
    EXPECT_EQ(c.radius, cpp.radius);
}

TEST(Defaults, OfCapsule) { expect_same(islet_default_capsule(), {}); }

TEST(Defaults, OfHalfSpace) {
    const IsletHalfSpace c = islet_default_half_space();
    [[maybe_unused]] const islet::HalfSpace cpp = {};
    expect_same(c.normal, cpp.normal);
    EXPECT_EQ(c.offset, cpp.offset);
}

TEST(Defaults, OfDrawStyle) {
    const IsletDrawStyle c = islet_default_draw_style();
    [[maybe_unused]] const islet::DrawStyle cpp = {};
    EXPECT_EQ(c.color, cpp.color);
    EXPECT_EQ(int(c.part), int(cpp.part));
    EXPECT_EQ(c.solid, cpp.solid);
    EXPECT_EQ(c.slot, cpp.slot);
}

TEST(Defaults, OfDebugDraw) {
    const IsletDebugDraw c = islet_default_debug_draw();
    [[maybe_unused]] const islet::DebugDraw cpp = {};
    EXPECT_EQ(c.struct_size, sizeof c);
    EXPECT_EQ(c.reserved, 0u);
    EXPECT_TRUE(c.polygon == nullptr && cpp.polygon == nullptr);
    EXPECT_TRUE(c.circle == nullptr && cpp.circle == nullptr);
    EXPECT_TRUE(c.capsule == nullptr && cpp.capsule == nullptr);
    EXPECT_TRUE(c.segment == nullptr && cpp.segment == nullptr);
    EXPECT_TRUE(c.point == nullptr && cpp.point == nullptr);
    EXPECT_TRUE(c.text == nullptr && cpp.text == nullptr);
    EXPECT_EQ(c.context, cpp.context);
    expect_same(c.view, cpp.view);
    EXPECT_EQ(c.size, cpp.size);
    EXPECT_EQ(c.impulse_scale, cpp.impulse_scale);
    EXPECT_EQ(c.shapes, cpp.shapes);
    EXPECT_EQ(c.joints, cpp.joints);
    EXPECT_EQ(c.contacts, cpp.contacts);
    EXPECT_EQ(c.normals, cpp.normals);
    EXPECT_EQ(c.impulses, cpp.impulses);
    EXPECT_EQ(c.boxes, cpp.boxes);
    EXPECT_EQ(c.fat_boxes, cpp.fat_boxes);
    EXPECT_EQ(c.tree, cpp.tree);
    EXPECT_EQ(c.centers, cpp.centers);
    EXPECT_EQ(c.names, cpp.names);
    EXPECT_EQ(int(c.body_colors), int(cpp.body_colors));
    EXPECT_EQ(c.constraint_colors, cpp.constraint_colors);
    EXPECT_TRUE(c.poses == nullptr && cpp.poses == nullptr);
}

TEST(Defaults, OfFormatInfo) {
    const IsletFormatInfo c = islet_default_format_info();
    [[maybe_unused]] const islet::FormatInfo cpp = {};
    EXPECT_EQ(c.struct_size, sizeof c);
    EXPECT_EQ(int(c.kind), int(cpp.kind));
    EXPECT_EQ(c.format, cpp.format);
    EXPECT_EQ(c.readable, cpp.readable);
    EXPECT_EQ(c.in_recording, cpp.in_recording);
    EXPECT_EQ(c.other_byte_order, cpp.other_byte_order);
}

TEST(Defaults, OfTaskSystem) {
    const IsletTaskSystem c = islet_default_task_system();
    [[maybe_unused]] const islet::TaskSystem cpp = {};
    EXPECT_EQ(c.struct_size, sizeof c);
    EXPECT_EQ(c.reserved, 0u);
    EXPECT_TRUE(c.parallel_for == nullptr && cpp.parallel_for == nullptr);
    EXPECT_EQ(c.context, cpp.context);
    EXPECT_EQ(c.workers, cpp.workers);
}

TEST(Defaults, OfCapacity) {
    const IsletCapacity c = islet_default_capacity();
    [[maybe_unused]] const islet::Capacity cpp = {};
    EXPECT_EQ(c.struct_size, sizeof c);
    EXPECT_EQ(c.bodies, cpp.bodies);
    EXPECT_EQ(c.shapes, cpp.shapes);
    EXPECT_EQ(c.contacts, cpp.contacts);
    EXPECT_EQ(c.joints, cpp.joints);
    EXPECT_EQ(c.geometries, cpp.geometries);
    EXPECT_EQ(c.hits, cpp.hits);
}

TEST(Defaults, OfHooks) {
    const IsletHooks c = islet_default_hooks();
    [[maybe_unused]] const islet::Hooks cpp = {};
    EXPECT_EQ(c.struct_size, sizeof c);
    EXPECT_EQ(c.reserved, 0u);
    EXPECT_TRUE(c.filter == nullptr && cpp.filter == nullptr);
    EXPECT_TRUE(c.pre_solve == nullptr && cpp.pre_solve == nullptr);
    EXPECT_TRUE(c.mix_friction == nullptr && cpp.mix_friction == nullptr);
    EXPECT_TRUE(c.mix_restitution == nullptr && cpp.mix_restitution == nullptr);
    EXPECT_EQ(c.context, cpp.context);
}

TEST(Defaults, OfSolverDef) {
    const IsletSolverDef c = islet_default_solver_def();
    [[maybe_unused]] const islet::SolverDef cpp = {};
    EXPECT_EQ(c.struct_size, sizeof c);
    EXPECT_EQ(int(c.schedule), int(cpp.schedule));
    EXPECT_EQ(c.substeps, cpp.substeps);
    EXPECT_EQ(c.iterations, cpp.iterations);
    EXPECT_EQ(c.relax_iterations, cpp.relax_iterations);
    EXPECT_EQ(c.contact_hertz, cpp.contact_hertz);
    EXPECT_EQ(c.contact_damping_ratio, cpp.contact_damping_ratio);
    EXPECT_EQ(c.contact_push_speed, cpp.contact_push_speed);
    EXPECT_EQ(c.joint_hertz, cpp.joint_hertz);
    EXPECT_EQ(c.joint_damping_ratio, cpp.joint_damping_ratio);
    EXPECT_EQ(c.baumgarte, cpp.baumgarte);
    EXPECT_EQ(c.omega, cpp.omega);
    EXPECT_EQ(c.warm_start, cpp.warm_start);
    EXPECT_EQ(int(c.joint_trees), int(cpp.joint_trees));
    EXPECT_EQ(c.joint_tree_load, cpp.joint_tree_load);
    EXPECT_EQ(int(c.sweep_order), int(cpp.sweep_order));
    EXPECT_EQ(c.block_contacts, cpp.block_contacts);
    EXPECT_EQ(c.shock, cpp.shock);
    EXPECT_EQ(c.measure_residual, cpp.measure_residual);
    EXPECT_EQ(c.tolerance, cpp.tolerance);
}

TEST(Defaults, OfWorldDef) {
    const IsletWorldDef c = islet_default_world_def();
    [[maybe_unused]] const islet::WorldDef cpp = {};
    EXPECT_EQ(c.struct_size, sizeof c);
    EXPECT_EQ(c.reserved, 0u);
    expect_same(c.gravity, cpp.gravity);
    EXPECT_EQ(c.solver, nullptr);
    EXPECT_EQ(c.enable_sleep, cpp.enable_sleep);
    EXPECT_EQ(c.restitution_threshold, cpp.restitution_threshold);
    EXPECT_EQ(c.max_speed, cpp.max_speed);
    EXPECT_EQ(c.hit_threshold, cpp.hit_threshold);
    EXPECT_EQ(c.continuous, cpp.continuous);
    EXPECT_EQ(c.lanes, cpp.lanes);
    EXPECT_TRUE(c.error_hook == nullptr && cpp.error_hook == nullptr);
    EXPECT_EQ(c.error_context, cpp.error_context);
    EXPECT_EQ(c.hooks, nullptr);
    EXPECT_EQ(c.tasks, nullptr);
    EXPECT_TRUE(c.clock == nullptr && cpp.clock == nullptr);
    EXPECT_EQ(c.clock_context, cpp.clock_context);
}

TEST(Defaults, OfBodyDef) {
    const IsletBodyDef c = islet_default_body_def();
    [[maybe_unused]] const islet::BodyDef cpp = {};
    EXPECT_EQ(c.struct_size, sizeof c);
    EXPECT_EQ(c.reserved, 0u);
    EXPECT_EQ(int(c.type), int(cpp.type));
    expect_same(c.position, cpp.position);
    EXPECT_EQ(c.angle, cpp.angle);
    expect_same(c.linear_velocity, cpp.linear_velocity);
    EXPECT_EQ(c.angular_velocity, cpp.angular_velocity);
    EXPECT_EQ(c.linear_damping, cpp.linear_damping);
    EXPECT_EQ(c.angular_damping, cpp.angular_damping);
    EXPECT_EQ(c.gravity_scale, cpp.gravity_scale);
    EXPECT_EQ(c.sleep_threshold, cpp.sleep_threshold);
    EXPECT_EQ(c.enable_sleep, cpp.enable_sleep);
    EXPECT_EQ(c.awake, cpp.awake);
    EXPECT_EQ(c.fixed_rotation, cpp.fixed_rotation);
    EXPECT_EQ(c.lock_x, cpp.lock_x);
    EXPECT_EQ(c.lock_y, cpp.lock_y);
    EXPECT_EQ(c.enabled, cpp.enabled);
    EXPECT_EQ(c.bullet, cpp.bullet);
    EXPECT_EQ(c.user_data, cpp.user_data);
}

TEST(Defaults, OfFilter) { expect_same(islet_default_filter(), {}); }

TEST(Defaults, OfSurfaceMaterial) {
    const IsletSurfaceMaterial c = islet_default_surface_material();
    [[maybe_unused]] const islet::SurfaceMaterial cpp = {};
    EXPECT_EQ(c.friction, cpp.friction);
    EXPECT_EQ(c.restitution, cpp.restitution);
    EXPECT_EQ(c.rolling_resistance, cpp.rolling_resistance);
    EXPECT_EQ(c.tangent_speed, cpp.tangent_speed);
    EXPECT_EQ(c.id, cpp.id);
}

TEST(Defaults, OfShapeDef) {
    const IsletShapeDef c = islet_default_shape_def();
    [[maybe_unused]] const islet::ShapeDef cpp = {};
    EXPECT_EQ(c.struct_size, sizeof c);
    EXPECT_EQ(c.reserved, 0u);
    EXPECT_EQ(c.friction, cpp.friction);
    EXPECT_EQ(c.restitution, cpp.restitution);
    EXPECT_EQ(c.rolling_resistance, cpp.rolling_resistance);
    EXPECT_EQ(c.tangent_speed, cpp.tangent_speed);
    EXPECT_EQ(c.density, cpp.density);
    expect_same(c.filter, cpp.filter);
    EXPECT_EQ(c.sensor, cpp.sensor);
    EXPECT_EQ(c.sensor_events, cpp.sensor_events);
    EXPECT_EQ(c.hit_events, cpp.hit_events);
    EXPECT_EQ(c.pre_solve, cpp.pre_solve);
    expect_same(c.one_way, cpp.one_way);
    EXPECT_EQ(c.material, cpp.material);
    EXPECT_EQ(c.user_data, cpp.user_data);
}

TEST(Defaults, OfExplosionDef) {
    const IsletExplosionDef c = islet_default_explosion_def();
    [[maybe_unused]] const islet::ExplosionDef cpp = {};
    EXPECT_EQ(c.struct_size, sizeof c);
    expect_same(c.position, cpp.position);
    EXPECT_EQ(c.radius, cpp.radius);
    EXPECT_EQ(c.falloff, cpp.falloff);
    EXPECT_EQ(c.impulse_per_length, cpp.impulse_per_length);
    EXPECT_EQ(c.mask, cpp.mask);
}

TEST(Defaults, OfWindDef) {
    const IsletWindDef c = islet_default_wind_def();
    [[maybe_unused]] const islet::WindDef cpp = {};
    EXPECT_EQ(c.struct_size, sizeof c);
    expect_same(c.velocity, cpp.velocity);
    EXPECT_EQ(c.drag, cpp.drag);
    EXPECT_EQ(c.lift, cpp.lift);
    EXPECT_EQ(c.density, cpp.density);
    EXPECT_EQ(c.wake, cpp.wake);
}

TEST(Defaults, OfStepReport) {
    const IsletStepReport c = islet_default_step_report();
    [[maybe_unused]] const islet::StepReport cpp = {};
    EXPECT_EQ(c.struct_size, sizeof c);
    EXPECT_EQ(c.bodies, cpp.bodies);
    EXPECT_EQ(c.awake_bodies, cpp.awake_bodies);
    EXPECT_EQ(c.shapes, cpp.shapes);
    EXPECT_EQ(c.contacts, cpp.contacts);
    EXPECT_EQ(c.touching_contacts, cpp.touching_contacts);
    EXPECT_EQ(c.recycled_contacts, cpp.recycled_contacts);
    EXPECT_EQ(c.dropped_contacts, cpp.dropped_contacts);
    EXPECT_EQ(c.dropped_events, cpp.dropped_events);
    EXPECT_EQ(c.dropped_hits, cpp.dropped_hits);
    EXPECT_EQ(c.islands, cpp.islands);
    EXPECT_EQ(c.colors, cpp.colors);
    EXPECT_EQ(c.overflow_contacts, cpp.overflow_contacts);
    EXPECT_EQ(c.batches, cpp.batches);
    EXPECT_EQ(c.joints, cpp.joints);
    EXPECT_EQ(c.awake_joints, cpp.awake_joints);
    EXPECT_EQ(c.overflow_joints, cpp.overflow_joints);
    EXPECT_EQ(c.sweeps, cpp.sweeps);
    EXPECT_EQ(c.residual, cpp.residual);
}

TEST(Defaults, OfStepProfile) {
    const IsletStepProfile c = islet_default_step_profile();
    [[maybe_unused]] const islet::StepProfile cpp = {};
    EXPECT_EQ(c.struct_size, sizeof c);
    EXPECT_EQ(c.reserved, 0u);
    EXPECT_EQ(c.pairs, cpp.pairs);
    EXPECT_EQ(c.collide, cpp.collide);
    EXPECT_EQ(c.islands, cpp.islands);
    EXPECT_EQ(c.solve, cpp.solve);
    EXPECT_EQ(c.finish, cpp.finish);
    EXPECT_EQ(c.total, cpp.total);
}

TEST(Defaults, OfWorldCounters) {
    const IsletWorldCounters c = islet_default_world_counters();
    [[maybe_unused]] const islet::WorldCounters cpp = {};
    EXPECT_EQ(c.struct_size, sizeof c);
    EXPECT_EQ(c.reserved, 0u);
    EXPECT_EQ(c.bytes, cpp.bytes);
    EXPECT_EQ(c.snapshot_bytes, cpp.snapshot_bytes);
    EXPECT_EQ(c.geometries, cpp.geometries);
    EXPECT_EQ(c.tree_shapes, cpp.tree_shapes);
    EXPECT_EQ(c.tree_height, cpp.tree_height);
    EXPECT_EQ(c.uncolored, cpp.uncolored);
}

TEST(Defaults, OfPreSolve) {
    const IsletPreSolve c = islet_default_pre_solve();
    [[maybe_unused]] const islet::PreSolve cpp = {};
    expect_same(c.contact, cpp.contact);
    EXPECT_EQ(c.enabled, cpp.enabled);
    EXPECT_EQ(c.friction, cpp.friction);
    EXPECT_EQ(c.tangent_speed, cpp.tangent_speed);
}

TEST(Defaults, OfJointSoftness) {
    const IsletJointSoftness c = islet_default_joint_softness();
    [[maybe_unused]] const islet::JointSoftness cpp = {};
    EXPECT_EQ(c.linear_hertz, cpp.linear_hertz);
    EXPECT_EQ(c.linear_damping_ratio, cpp.linear_damping_ratio);
    EXPECT_EQ(c.angular_hertz, cpp.angular_hertz);
    EXPECT_EQ(c.angular_damping_ratio, cpp.angular_damping_ratio);
}

TEST(Defaults, OfRevoluteJointDef) {
    const IsletRevoluteJointDef c = islet_default_revolute_joint_def();
    [[maybe_unused]] const islet::RevoluteJointDef cpp = {};
    EXPECT_EQ(c.struct_size, sizeof c);
    EXPECT_EQ(c.reserved, 0u);
    expect_same(c.base, cpp.base);
    expect_same(c.spring, cpp.spring);
    expect_same(c.limit, cpp.limit);
    expect_same(c.motor, cpp.motor);
    EXPECT_EQ(c.friction, cpp.friction);
}

TEST(Defaults, OfPrismaticJointDef) {
    const IsletPrismaticJointDef c = islet_default_prismatic_joint_def();
    [[maybe_unused]] const islet::PrismaticJointDef cpp = {};
    EXPECT_EQ(c.struct_size, sizeof c);
    EXPECT_EQ(c.reserved, 0u);
    expect_same(c.base, cpp.base);
    expect_same(c.spring, cpp.spring);
    expect_same(c.limit, cpp.limit);
    expect_same(c.motor, cpp.motor);
    EXPECT_EQ(c.friction, cpp.friction);
}

TEST(Defaults, OfDistanceJointDef) {
    const IsletDistanceJointDef c = islet_default_distance_joint_def();
    [[maybe_unused]] const islet::DistanceJointDef cpp = {};
    EXPECT_EQ(c.struct_size, sizeof c);
    EXPECT_EQ(c.reserved, 0u);
    expect_same(c.base, cpp.base);
    EXPECT_EQ(c.length, cpp.length);
    expect_same(c.spring, cpp.spring);
    expect_same(c.limit, cpp.limit);
    expect_same(c.motor, cpp.motor);
}

TEST(Defaults, OfWeldJointDef) {
    const IsletWeldJointDef c = islet_default_weld_joint_def();
    [[maybe_unused]] const islet::WeldJointDef cpp = {};
    EXPECT_EQ(c.struct_size, sizeof c);
    EXPECT_EQ(c.reserved, 0u);
    expect_same(c.base, cpp.base);
    EXPECT_EQ(c.linear_hertz, cpp.linear_hertz);
    EXPECT_EQ(c.linear_damping_ratio, cpp.linear_damping_ratio);
    EXPECT_EQ(c.angular_hertz, cpp.angular_hertz);
    EXPECT_EQ(c.angular_damping_ratio, cpp.angular_damping_ratio);
}

TEST(Defaults, OfWheelJointDef) {
    const IsletWheelJointDef c = islet_default_wheel_joint_def();
    [[maybe_unused]] const islet::WheelJointDef cpp = {};
    EXPECT_EQ(c.struct_size, sizeof c);
    EXPECT_EQ(c.reserved, 0u);
    expect_same(c.base, cpp.base);
    expect_same(c.spring, cpp.spring);
    expect_same(c.limit, cpp.limit);
    expect_same(c.motor, cpp.motor);
    EXPECT_EQ(c.friction, cpp.friction);
}

TEST(Defaults, OfMotorJointDef) {
    const IsletMotorJointDef c = islet_default_motor_joint_def();
    [[maybe_unused]] const islet::MotorJointDef cpp = {};
    EXPECT_EQ(c.struct_size, sizeof c);
    EXPECT_EQ(c.reserved, 0u);
    expect_same(c.base, cpp.base);
    expect_same(c.linear_velocity, cpp.linear_velocity);
    EXPECT_EQ(c.angular_velocity, cpp.angular_velocity);
    EXPECT_EQ(c.max_force, cpp.max_force);
    EXPECT_EQ(c.max_torque, cpp.max_torque);
    EXPECT_EQ(c.linear_hertz, cpp.linear_hertz);
    EXPECT_EQ(c.linear_damping_ratio, cpp.linear_damping_ratio);
    EXPECT_EQ(c.angular_hertz, cpp.angular_hertz);
    EXPECT_EQ(c.angular_damping_ratio, cpp.angular_damping_ratio);
}

TEST(Defaults, OfMouseJointDef) {
    const IsletMouseJointDef c = islet_default_mouse_joint_def();
    [[maybe_unused]] const islet::MouseJointDef cpp = {};
    EXPECT_EQ(c.struct_size, sizeof c);
    EXPECT_EQ(c.reserved, 0u);
    expect_same(c.body, cpp.body);
    expect_same(c.target, cpp.target);
    EXPECT_EQ(c.hertz, cpp.hertz);
    EXPECT_EQ(c.damping_ratio, cpp.damping_ratio);
    EXPECT_EQ(c.max_force, cpp.max_force);
    EXPECT_EQ(c.user_data, cpp.user_data);
}

TEST(Defaults, OfPulleyJointDef) {
    const IsletPulleyJointDef c = islet_default_pulley_joint_def();
    [[maybe_unused]] const islet::PulleyJointDef cpp = {};
    EXPECT_EQ(c.struct_size, sizeof c);
    EXPECT_EQ(c.reserved, 0u);
    expect_same(c.base, cpp.base);
    expect_same(c.ground_a, cpp.ground_a);
    expect_same(c.ground_b, cpp.ground_b);
    EXPECT_EQ(c.ratio, cpp.ratio);
}

TEST(Defaults, OfGearJointDef) {
    const IsletGearJointDef c = islet_default_gear_joint_def();
    [[maybe_unused]] const islet::GearJointDef cpp = {};
    EXPECT_EQ(c.struct_size, sizeof c);
    EXPECT_EQ(c.reserved, 0u);
    expect_same(c.joint1, cpp.joint1);
    expect_same(c.joint2, cpp.joint2);
    EXPECT_EQ(c.ratio, cpp.ratio);
    EXPECT_EQ(c.break_torque, cpp.break_torque);
    EXPECT_EQ(c.user_data, cpp.user_data);
}

TEST(Defaults, OfAngleJointDef) {
    const IsletAngleJointDef c = islet_default_angle_joint_def();
    [[maybe_unused]] const islet::AngleJointDef cpp = {};
    EXPECT_EQ(c.struct_size, sizeof c);
    EXPECT_EQ(c.reserved, 0u);
    expect_same(c.base, cpp.base);
    expect_same(c.spring, cpp.spring);
    expect_same(c.limit, cpp.limit);
    expect_same(c.motor, cpp.motor);
    EXPECT_EQ(c.friction, cpp.friction);
    expect_same(c.ratchet, cpp.ratchet);
}

TEST(Defaults, OfRowEnd) {
    const IsletRowEnd c = islet_default_row_end();
    [[maybe_unused]] const islet::RowEnd cpp = {};
    EXPECT_EQ(c.body, cpp.body);
    expect_same(c.linear, cpp.linear);
    EXPECT_EQ(c.angular, cpp.angular);
}

TEST(Defaults, OfQueryFilter) { expect_same(islet_default_query_filter(), {}); }

TEST(Defaults, OfMoverDef) {
    const IsletMoverDef c = islet_default_mover_def();
    [[maybe_unused]] const islet::MoverDef cpp = {};
    EXPECT_EQ(c.struct_size, sizeof c);
    EXPECT_EQ(c.reserved, 0u);
    expect_same(c.capsule, cpp.capsule);
    expect_same(c.up, cpp.up);
    EXPECT_EQ(c.gravity_scale, cpp.gravity_scale);
    EXPECT_EQ(c.max_slope, cpp.max_slope);
    EXPECT_EQ(c.step_height, cpp.step_height);
    EXPECT_EQ(c.snap_distance, cpp.snap_distance);
    EXPECT_EQ(c.ground_acceleration, cpp.ground_acceleration);
    EXPECT_EQ(c.air_acceleration, cpp.air_acceleration);
    EXPECT_EQ(c.mass, cpp.mass);
    EXPECT_EQ(c.max_push_force, cpp.max_push_force);
    expect_same(c.filter, cpp.filter);
    EXPECT_TRUE(c.collides == nullptr && cpp.collides == nullptr);
    EXPECT_EQ(c.context, cpp.context);
}

TEST(Defaults, OfMoverInput) {
    const IsletMoverInput c = islet_default_mover_input();
    [[maybe_unused]] const islet::MoverInput cpp = {};
    EXPECT_EQ(c.struct_size, sizeof c);
    EXPECT_EQ(c.walk, cpp.walk);
    EXPECT_EQ(c.jump, cpp.jump);
}

TEST(Defaults, OfRecordingInfo) {
    const IsletRecordingInfo c = islet_default_recording_info();
    [[maybe_unused]] const islet::RecordingInfo cpp = {};
    EXPECT_EQ(c.struct_size, sizeof c);
    EXPECT_EQ(c.reserved, 0u);
    EXPECT_EQ(c.capacity, nullptr);
    EXPECT_EQ(c.needed, nullptr);
    EXPECT_EQ(c.bytes, cpp.bytes);
    EXPECT_EQ(c.bodies, cpp.bodies);
}

TEST(Defaults, OfReplayResult) {
    const IsletReplayResult c = islet_default_replay_result();
    [[maybe_unused]] const islet::ReplayResult cpp = {};
    EXPECT_EQ(c.struct_size, sizeof c);
    EXPECT_EQ(c.reserved, 0u);
    EXPECT_EQ(int(c.end), int(cpp.end));
    EXPECT_EQ(int(c.error), int(cpp.error));
    EXPECT_EQ(c.steps, cpp.steps);
    EXPECT_EQ(c.recorded_hash, cpp.recorded_hash);
    EXPECT_EQ(c.hash, cpp.hash);
    expect_same(c.body, cpp.body);
}

TEST(Defaults, OfSnapshotInfo) {
    const IsletSnapshotInfo c = islet_default_snapshot_info();
    [[maybe_unused]] const islet::SnapshotInfo cpp = {};
    EXPECT_EQ(c.struct_size, sizeof c);
    EXPECT_EQ(c.reserved, 0u);
    EXPECT_EQ(c.bytes, cpp.bytes);
    EXPECT_EQ(c.capacity, nullptr);
    EXPECT_EQ(c.used, nullptr);
}

}  // namespace
