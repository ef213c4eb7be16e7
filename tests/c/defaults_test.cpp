// The defaults of C are those of C++.
//
// Made by bindings/c/generate.py; do not edit.
#include <gtest/gtest.h>
#include <islet/islet.h>

#include <islet/islet.hpp>
#include <islet/island.hpp>
#include <islet/mover.hpp>

namespace {

TEST(Defaults, OfRot) {
    const IsletRot c = islet_default_rot();
    [[maybe_unused]] const islet::Rot cpp = {};
    EXPECT_EQ(c.c, cpp.c);
    EXPECT_EQ(c.s, cpp.s);
}

TEST(Defaults, OfTransform) {
    const IsletTransform c = islet_default_transform();
    [[maybe_unused]] const islet::Transform cpp = {};
    EXPECT_EQ(c.p.x, cpp.p.x);
    EXPECT_EQ(c.p.y, cpp.p.y);
    EXPECT_EQ(c.q.c, cpp.q.c);
    EXPECT_EQ(c.q.s, cpp.q.s);
}

TEST(Defaults, OfCircle) {
    const IsletCircle c = islet_default_circle();
    [[maybe_unused]] const islet::Circle cpp = {};
    EXPECT_EQ(c.center.x, cpp.center.x);
    EXPECT_EQ(c.center.y, cpp.center.y);
    EXPECT_EQ(c.radius, cpp.radius);
}

TEST(Defaults, OfCapsule) {
    const IsletCapsule c = islet_default_capsule();
    [[maybe_unused]] const islet::Capsule cpp = {};
    EXPECT_EQ(c.point1.x, cpp.point1.x);
    EXPECT_EQ(c.point1.y, cpp.point1.y);
    EXPECT_EQ(c.point2.x, cpp.point2.x);
    EXPECT_EQ(c.point2.y, cpp.point2.y);
    EXPECT_EQ(c.radius, cpp.radius);
}

TEST(Defaults, OfHalfSpace) {
    const IsletHalfSpace c = islet_default_half_space();
    [[maybe_unused]] const islet::HalfSpace cpp = {};
    EXPECT_EQ(c.normal.x, cpp.normal.x);
    EXPECT_EQ(c.normal.y, cpp.normal.y);
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
    EXPECT_EQ(c.view.lower.x, cpp.view.lower.x);
    EXPECT_EQ(c.view.lower.y, cpp.view.lower.y);
    EXPECT_EQ(c.view.upper.x, cpp.view.upper.x);
    EXPECT_EQ(c.view.upper.y, cpp.view.upper.y);
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
    EXPECT_EQ(c.solver, nullptr);
    EXPECT_EQ(c.hooks, nullptr);
    EXPECT_EQ(c.tasks, nullptr);
    EXPECT_EQ(c.gravity.x, cpp.gravity.x);
    EXPECT_EQ(c.gravity.y, cpp.gravity.y);
    EXPECT_EQ(c.enable_sleep, cpp.enable_sleep);
    EXPECT_EQ(c.restitution_threshold, cpp.restitution_threshold);
    EXPECT_EQ(c.max_speed, cpp.max_speed);
    EXPECT_EQ(c.hit_threshold, cpp.hit_threshold);
    EXPECT_EQ(c.continuous, cpp.continuous);
    EXPECT_EQ(c.lanes, cpp.lanes);
    EXPECT_TRUE(c.error_hook == nullptr && cpp.error_hook == nullptr);
    EXPECT_EQ(c.error_context, cpp.error_context);
    EXPECT_TRUE(c.clock == nullptr && cpp.clock == nullptr);
    EXPECT_EQ(c.clock_context, cpp.clock_context);
}

TEST(Defaults, OfBodyDef) {
    const IsletBodyDef c = islet_default_body_def();
    [[maybe_unused]] const islet::BodyDef cpp = {};
    EXPECT_EQ(c.struct_size, sizeof c);
    EXPECT_EQ(c.reserved, 0u);
    EXPECT_EQ(int(c.type), int(cpp.type));
    EXPECT_EQ(c.position.x, cpp.position.x);
    EXPECT_EQ(c.position.y, cpp.position.y);
    EXPECT_EQ(c.angle, cpp.angle);
    EXPECT_EQ(c.linear_velocity.x, cpp.linear_velocity.x);
    EXPECT_EQ(c.linear_velocity.y, cpp.linear_velocity.y);
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

TEST(Defaults, OfFilter) {
    const IsletFilter c = islet_default_filter();
    [[maybe_unused]] const islet::Filter cpp = {};
    EXPECT_EQ(c.category, cpp.category);
    EXPECT_EQ(c.mask, cpp.mask);
    EXPECT_EQ(c.group, cpp.group);
}

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
    EXPECT_EQ(c.filter.category, cpp.filter.category);
    EXPECT_EQ(c.filter.mask, cpp.filter.mask);
    EXPECT_EQ(c.filter.group, cpp.filter.group);
    EXPECT_EQ(c.sensor, cpp.sensor);
    EXPECT_EQ(c.sensor_events, cpp.sensor_events);
    EXPECT_EQ(c.hit_events, cpp.hit_events);
    EXPECT_EQ(c.pre_solve, cpp.pre_solve);
    EXPECT_EQ(c.one_way.x, cpp.one_way.x);
    EXPECT_EQ(c.one_way.y, cpp.one_way.y);
    EXPECT_EQ(c.material, cpp.material);
    EXPECT_EQ(c.user_data, cpp.user_data);
}

TEST(Defaults, OfExplosionDef) {
    const IsletExplosionDef c = islet_default_explosion_def();
    [[maybe_unused]] const islet::ExplosionDef cpp = {};
    EXPECT_EQ(c.struct_size, sizeof c);
    EXPECT_EQ(c.position.x, cpp.position.x);
    EXPECT_EQ(c.position.y, cpp.position.y);
    EXPECT_EQ(c.radius, cpp.radius);
    EXPECT_EQ(c.falloff, cpp.falloff);
    EXPECT_EQ(c.impulse_per_length, cpp.impulse_per_length);
    EXPECT_EQ(c.mask, cpp.mask);
}

TEST(Defaults, OfWindDef) {
    const IsletWindDef c = islet_default_wind_def();
    [[maybe_unused]] const islet::WindDef cpp = {};
    EXPECT_EQ(c.struct_size, sizeof c);
    EXPECT_EQ(c.velocity.x, cpp.velocity.x);
    EXPECT_EQ(c.velocity.y, cpp.velocity.y);
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
    EXPECT_EQ(c.contact.shape_a.index1, cpp.contact.shape_a.index1);
    EXPECT_EQ(c.contact.shape_a.generation, cpp.contact.shape_a.generation);
    EXPECT_EQ(c.contact.shape_b.index1, cpp.contact.shape_b.index1);
    EXPECT_EQ(c.contact.shape_b.generation, cpp.contact.shape_b.generation);
    EXPECT_EQ(c.contact.normal.x, cpp.contact.normal.x);
    EXPECT_EQ(c.contact.normal.y, cpp.contact.normal.y);
    EXPECT_EQ(c.contact.point_count, cpp.contact.point_count);
    EXPECT_EQ(c.contact.friction, cpp.contact.friction);
    EXPECT_EQ(c.contact.restitution, cpp.contact.restitution);
    EXPECT_EQ(c.enabled, cpp.enabled);
    EXPECT_EQ(c.friction, cpp.friction);
    EXPECT_EQ(c.tangent_speed, cpp.tangent_speed);
}

TEST(Defaults, OfRowEnd) {
    const IsletRowEnd c = islet_default_row_end();
    [[maybe_unused]] const islet::RowEnd cpp = {};
    EXPECT_EQ(c.body, cpp.body);
    EXPECT_EQ(c.linear.x, cpp.linear.x);
    EXPECT_EQ(c.linear.y, cpp.linear.y);
    EXPECT_EQ(c.angular, cpp.angular);
}

TEST(Defaults, OfRevoluteJointDef) {
    const IsletRevoluteJointDef c = islet_default_revolute_joint_def();
    [[maybe_unused]] const islet::RevoluteJointDef cpp = {};
    EXPECT_EQ(c.struct_size, sizeof c);
    EXPECT_EQ(c.reserved, 0u);
    EXPECT_EQ(c.base.body_a.index1, cpp.base.body_a.index1);
    EXPECT_EQ(c.base.body_a.generation, cpp.base.body_a.generation);
    EXPECT_EQ(c.base.body_b.index1, cpp.base.body_b.index1);
    EXPECT_EQ(c.base.body_b.generation, cpp.base.body_b.generation);
    EXPECT_EQ(c.base.frame_a.position.x, cpp.base.frame_a.position.x);
    EXPECT_EQ(c.base.frame_a.position.y, cpp.base.frame_a.position.y);
    EXPECT_EQ(c.base.frame_a.angle, cpp.base.frame_a.angle);
    EXPECT_EQ(c.base.frame_b.position.x, cpp.base.frame_b.position.x);
    EXPECT_EQ(c.base.frame_b.position.y, cpp.base.frame_b.position.y);
    EXPECT_EQ(c.base.frame_b.angle, cpp.base.frame_b.angle);
    EXPECT_EQ(c.base.collide_connected, cpp.base.collide_connected);
    EXPECT_EQ(c.base.break_force, cpp.base.break_force);
    EXPECT_EQ(c.base.break_torque, cpp.base.break_torque);
    EXPECT_EQ(c.base.user_data, cpp.base.user_data);
    EXPECT_EQ(c.spring.enable, cpp.spring.enable);
    EXPECT_EQ(c.spring.hertz, cpp.spring.hertz);
    EXPECT_EQ(c.spring.damping_ratio, cpp.spring.damping_ratio);
    EXPECT_EQ(c.spring.target, cpp.spring.target);
    EXPECT_EQ(c.limit.enable, cpp.limit.enable);
    EXPECT_EQ(c.limit.lower, cpp.limit.lower);
    EXPECT_EQ(c.limit.upper, cpp.limit.upper);
    EXPECT_EQ(c.motor.enable, cpp.motor.enable);
    EXPECT_EQ(c.motor.speed, cpp.motor.speed);
    EXPECT_EQ(c.motor.max_force, cpp.motor.max_force);
    EXPECT_EQ(c.friction, cpp.friction);
}

TEST(Defaults, OfPrismaticJointDef) {
    const IsletPrismaticJointDef c = islet_default_prismatic_joint_def();
    [[maybe_unused]] const islet::PrismaticJointDef cpp = {};
    EXPECT_EQ(c.struct_size, sizeof c);
    EXPECT_EQ(c.reserved, 0u);
    EXPECT_EQ(c.base.body_a.index1, cpp.base.body_a.index1);
    EXPECT_EQ(c.base.body_a.generation, cpp.base.body_a.generation);
    EXPECT_EQ(c.base.body_b.index1, cpp.base.body_b.index1);
    EXPECT_EQ(c.base.body_b.generation, cpp.base.body_b.generation);
    EXPECT_EQ(c.base.frame_a.position.x, cpp.base.frame_a.position.x);
    EXPECT_EQ(c.base.frame_a.position.y, cpp.base.frame_a.position.y);
    EXPECT_EQ(c.base.frame_a.angle, cpp.base.frame_a.angle);
    EXPECT_EQ(c.base.frame_b.position.x, cpp.base.frame_b.position.x);
    EXPECT_EQ(c.base.frame_b.position.y, cpp.base.frame_b.position.y);
    EXPECT_EQ(c.base.frame_b.angle, cpp.base.frame_b.angle);
    EXPECT_EQ(c.base.collide_connected, cpp.base.collide_connected);
    EXPECT_EQ(c.base.break_force, cpp.base.break_force);
    EXPECT_EQ(c.base.break_torque, cpp.base.break_torque);
    EXPECT_EQ(c.base.user_data, cpp.base.user_data);
    EXPECT_EQ(c.spring.enable, cpp.spring.enable);
    EXPECT_EQ(c.spring.hertz, cpp.spring.hertz);
    EXPECT_EQ(c.spring.damping_ratio, cpp.spring.damping_ratio);
    EXPECT_EQ(c.spring.target, cpp.spring.target);
    EXPECT_EQ(c.limit.enable, cpp.limit.enable);
    EXPECT_EQ(c.limit.lower, cpp.limit.lower);
    EXPECT_EQ(c.limit.upper, cpp.limit.upper);
    EXPECT_EQ(c.motor.enable, cpp.motor.enable);
    EXPECT_EQ(c.motor.speed, cpp.motor.speed);
    EXPECT_EQ(c.motor.max_force, cpp.motor.max_force);
    EXPECT_EQ(c.friction, cpp.friction);
}

TEST(Defaults, OfDistanceJointDef) {
    const IsletDistanceJointDef c = islet_default_distance_joint_def();
    [[maybe_unused]] const islet::DistanceJointDef cpp = {};
    EXPECT_EQ(c.struct_size, sizeof c);
    EXPECT_EQ(c.reserved, 0u);
    EXPECT_EQ(c.base.body_a.index1, cpp.base.body_a.index1);
    EXPECT_EQ(c.base.body_a.generation, cpp.base.body_a.generation);
    EXPECT_EQ(c.base.body_b.index1, cpp.base.body_b.index1);
    EXPECT_EQ(c.base.body_b.generation, cpp.base.body_b.generation);
    EXPECT_EQ(c.base.frame_a.position.x, cpp.base.frame_a.position.x);
    EXPECT_EQ(c.base.frame_a.position.y, cpp.base.frame_a.position.y);
    EXPECT_EQ(c.base.frame_a.angle, cpp.base.frame_a.angle);
    EXPECT_EQ(c.base.frame_b.position.x, cpp.base.frame_b.position.x);
    EXPECT_EQ(c.base.frame_b.position.y, cpp.base.frame_b.position.y);
    EXPECT_EQ(c.base.frame_b.angle, cpp.base.frame_b.angle);
    EXPECT_EQ(c.base.collide_connected, cpp.base.collide_connected);
    EXPECT_EQ(c.base.break_force, cpp.base.break_force);
    EXPECT_EQ(c.base.break_torque, cpp.base.break_torque);
    EXPECT_EQ(c.base.user_data, cpp.base.user_data);
    EXPECT_EQ(c.length, cpp.length);
    EXPECT_EQ(c.spring.enable, cpp.spring.enable);
    EXPECT_EQ(c.spring.hertz, cpp.spring.hertz);
    EXPECT_EQ(c.spring.damping_ratio, cpp.spring.damping_ratio);
    EXPECT_EQ(c.spring.target, cpp.spring.target);
    EXPECT_EQ(c.limit.enable, cpp.limit.enable);
    EXPECT_EQ(c.limit.lower, cpp.limit.lower);
    EXPECT_EQ(c.limit.upper, cpp.limit.upper);
    EXPECT_EQ(c.motor.enable, cpp.motor.enable);
    EXPECT_EQ(c.motor.speed, cpp.motor.speed);
    EXPECT_EQ(c.motor.max_force, cpp.motor.max_force);
}

TEST(Defaults, OfWeldJointDef) {
    const IsletWeldJointDef c = islet_default_weld_joint_def();
    [[maybe_unused]] const islet::WeldJointDef cpp = {};
    EXPECT_EQ(c.struct_size, sizeof c);
    EXPECT_EQ(c.reserved, 0u);
    EXPECT_EQ(c.base.body_a.index1, cpp.base.body_a.index1);
    EXPECT_EQ(c.base.body_a.generation, cpp.base.body_a.generation);
    EXPECT_EQ(c.base.body_b.index1, cpp.base.body_b.index1);
    EXPECT_EQ(c.base.body_b.generation, cpp.base.body_b.generation);
    EXPECT_EQ(c.base.frame_a.position.x, cpp.base.frame_a.position.x);
    EXPECT_EQ(c.base.frame_a.position.y, cpp.base.frame_a.position.y);
    EXPECT_EQ(c.base.frame_a.angle, cpp.base.frame_a.angle);
    EXPECT_EQ(c.base.frame_b.position.x, cpp.base.frame_b.position.x);
    EXPECT_EQ(c.base.frame_b.position.y, cpp.base.frame_b.position.y);
    EXPECT_EQ(c.base.frame_b.angle, cpp.base.frame_b.angle);
    EXPECT_EQ(c.base.collide_connected, cpp.base.collide_connected);
    EXPECT_EQ(c.base.break_force, cpp.base.break_force);
    EXPECT_EQ(c.base.break_torque, cpp.base.break_torque);
    EXPECT_EQ(c.base.user_data, cpp.base.user_data);
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
    EXPECT_EQ(c.base.body_a.index1, cpp.base.body_a.index1);
    EXPECT_EQ(c.base.body_a.generation, cpp.base.body_a.generation);
    EXPECT_EQ(c.base.body_b.index1, cpp.base.body_b.index1);
    EXPECT_EQ(c.base.body_b.generation, cpp.base.body_b.generation);
    EXPECT_EQ(c.base.frame_a.position.x, cpp.base.frame_a.position.x);
    EXPECT_EQ(c.base.frame_a.position.y, cpp.base.frame_a.position.y);
    EXPECT_EQ(c.base.frame_a.angle, cpp.base.frame_a.angle);
    EXPECT_EQ(c.base.frame_b.position.x, cpp.base.frame_b.position.x);
    EXPECT_EQ(c.base.frame_b.position.y, cpp.base.frame_b.position.y);
    EXPECT_EQ(c.base.frame_b.angle, cpp.base.frame_b.angle);
    EXPECT_EQ(c.base.collide_connected, cpp.base.collide_connected);
    EXPECT_EQ(c.base.break_force, cpp.base.break_force);
    EXPECT_EQ(c.base.break_torque, cpp.base.break_torque);
    EXPECT_EQ(c.base.user_data, cpp.base.user_data);
    EXPECT_EQ(c.spring.enable, cpp.spring.enable);
    EXPECT_EQ(c.spring.hertz, cpp.spring.hertz);
    EXPECT_EQ(c.spring.damping_ratio, cpp.spring.damping_ratio);
    EXPECT_EQ(c.spring.target, cpp.spring.target);
    EXPECT_EQ(c.limit.enable, cpp.limit.enable);
    EXPECT_EQ(c.limit.lower, cpp.limit.lower);
    EXPECT_EQ(c.limit.upper, cpp.limit.upper);
    EXPECT_EQ(c.motor.enable, cpp.motor.enable);
    EXPECT_EQ(c.motor.speed, cpp.motor.speed);
    EXPECT_EQ(c.motor.max_force, cpp.motor.max_force);
    EXPECT_EQ(c.friction, cpp.friction);
}

TEST(Defaults, OfMotorJointDef) {
    const IsletMotorJointDef c = islet_default_motor_joint_def();
    [[maybe_unused]] const islet::MotorJointDef cpp = {};
    EXPECT_EQ(c.struct_size, sizeof c);
    EXPECT_EQ(c.reserved, 0u);
    EXPECT_EQ(c.base.body_a.index1, cpp.base.body_a.index1);
    EXPECT_EQ(c.base.body_a.generation, cpp.base.body_a.generation);
    EXPECT_EQ(c.base.body_b.index1, cpp.base.body_b.index1);
    EXPECT_EQ(c.base.body_b.generation, cpp.base.body_b.generation);
    EXPECT_EQ(c.base.frame_a.position.x, cpp.base.frame_a.position.x);
    EXPECT_EQ(c.base.frame_a.position.y, cpp.base.frame_a.position.y);
    EXPECT_EQ(c.base.frame_a.angle, cpp.base.frame_a.angle);
    EXPECT_EQ(c.base.frame_b.position.x, cpp.base.frame_b.position.x);
    EXPECT_EQ(c.base.frame_b.position.y, cpp.base.frame_b.position.y);
    EXPECT_EQ(c.base.frame_b.angle, cpp.base.frame_b.angle);
    EXPECT_EQ(c.base.collide_connected, cpp.base.collide_connected);
    EXPECT_EQ(c.base.break_force, cpp.base.break_force);
    EXPECT_EQ(c.base.break_torque, cpp.base.break_torque);
    EXPECT_EQ(c.base.user_data, cpp.base.user_data);
    EXPECT_EQ(c.linear_velocity.x, cpp.linear_velocity.x);
    EXPECT_EQ(c.linear_velocity.y, cpp.linear_velocity.y);
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
    EXPECT_EQ(c.body.index1, cpp.body.index1);
    EXPECT_EQ(c.body.generation, cpp.body.generation);
    EXPECT_EQ(c.target.x, cpp.target.x);
    EXPECT_EQ(c.target.y, cpp.target.y);
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
    EXPECT_EQ(c.base.body_a.index1, cpp.base.body_a.index1);
    EXPECT_EQ(c.base.body_a.generation, cpp.base.body_a.generation);
    EXPECT_EQ(c.base.body_b.index1, cpp.base.body_b.index1);
    EXPECT_EQ(c.base.body_b.generation, cpp.base.body_b.generation);
    EXPECT_EQ(c.base.frame_a.position.x, cpp.base.frame_a.position.x);
    EXPECT_EQ(c.base.frame_a.position.y, cpp.base.frame_a.position.y);
    EXPECT_EQ(c.base.frame_a.angle, cpp.base.frame_a.angle);
    EXPECT_EQ(c.base.frame_b.position.x, cpp.base.frame_b.position.x);
    EXPECT_EQ(c.base.frame_b.position.y, cpp.base.frame_b.position.y);
    EXPECT_EQ(c.base.frame_b.angle, cpp.base.frame_b.angle);
    EXPECT_EQ(c.base.collide_connected, cpp.base.collide_connected);
    EXPECT_EQ(c.base.break_force, cpp.base.break_force);
    EXPECT_EQ(c.base.break_torque, cpp.base.break_torque);
    EXPECT_EQ(c.base.user_data, cpp.base.user_data);
    EXPECT_EQ(c.ground_a.x, cpp.ground_a.x);
    EXPECT_EQ(c.ground_a.y, cpp.ground_a.y);
    EXPECT_EQ(c.ground_b.x, cpp.ground_b.x);
    EXPECT_EQ(c.ground_b.y, cpp.ground_b.y);
    EXPECT_EQ(c.ratio, cpp.ratio);
}

TEST(Defaults, OfGearJointDef) {
    const IsletGearJointDef c = islet_default_gear_joint_def();
    [[maybe_unused]] const islet::GearJointDef cpp = {};
    EXPECT_EQ(c.struct_size, sizeof c);
    EXPECT_EQ(c.reserved, 0u);
    EXPECT_EQ(c.joint1.index1, cpp.joint1.index1);
    EXPECT_EQ(c.joint1.generation, cpp.joint1.generation);
    EXPECT_EQ(c.joint2.index1, cpp.joint2.index1);
    EXPECT_EQ(c.joint2.generation, cpp.joint2.generation);
    EXPECT_EQ(c.ratio, cpp.ratio);
    EXPECT_EQ(c.break_torque, cpp.break_torque);
    EXPECT_EQ(c.user_data, cpp.user_data);
}

TEST(Defaults, OfAngleJointDef) {
    const IsletAngleJointDef c = islet_default_angle_joint_def();
    [[maybe_unused]] const islet::AngleJointDef cpp = {};
    EXPECT_EQ(c.struct_size, sizeof c);
    EXPECT_EQ(c.reserved, 0u);
    EXPECT_EQ(c.base.body_a.index1, cpp.base.body_a.index1);
    EXPECT_EQ(c.base.body_a.generation, cpp.base.body_a.generation);
    EXPECT_EQ(c.base.body_b.index1, cpp.base.body_b.index1);
    EXPECT_EQ(c.base.body_b.generation, cpp.base.body_b.generation);
    EXPECT_EQ(c.base.frame_a.position.x, cpp.base.frame_a.position.x);
    EXPECT_EQ(c.base.frame_a.position.y, cpp.base.frame_a.position.y);
    EXPECT_EQ(c.base.frame_a.angle, cpp.base.frame_a.angle);
    EXPECT_EQ(c.base.frame_b.position.x, cpp.base.frame_b.position.x);
    EXPECT_EQ(c.base.frame_b.position.y, cpp.base.frame_b.position.y);
    EXPECT_EQ(c.base.frame_b.angle, cpp.base.frame_b.angle);
    EXPECT_EQ(c.base.collide_connected, cpp.base.collide_connected);
    EXPECT_EQ(c.base.break_force, cpp.base.break_force);
    EXPECT_EQ(c.base.break_torque, cpp.base.break_torque);
    EXPECT_EQ(c.base.user_data, cpp.base.user_data);
    EXPECT_EQ(c.spring.enable, cpp.spring.enable);
    EXPECT_EQ(c.spring.hertz, cpp.spring.hertz);
    EXPECT_EQ(c.spring.damping_ratio, cpp.spring.damping_ratio);
    EXPECT_EQ(c.spring.target, cpp.spring.target);
    EXPECT_EQ(c.limit.enable, cpp.limit.enable);
    EXPECT_EQ(c.limit.lower, cpp.limit.lower);
    EXPECT_EQ(c.limit.upper, cpp.limit.upper);
    EXPECT_EQ(c.motor.enable, cpp.motor.enable);
    EXPECT_EQ(c.motor.speed, cpp.motor.speed);
    EXPECT_EQ(c.motor.max_force, cpp.motor.max_force);
    EXPECT_EQ(c.friction, cpp.friction);
    EXPECT_EQ(c.ratchet.step, cpp.ratchet.step);
    EXPECT_EQ(c.ratchet.phase, cpp.ratchet.phase);
}

TEST(Defaults, OfQueryFilter) {
    const IsletQueryFilter c = islet_default_query_filter();
    [[maybe_unused]] const islet::QueryFilter cpp = {};
    EXPECT_EQ(c.category, cpp.category);
    EXPECT_EQ(c.mask, cpp.mask);
    EXPECT_EQ(c.sensors, cpp.sensors);
}

TEST(Defaults, OfMoverDef) {
    const IsletMoverDef c = islet_default_mover_def();
    [[maybe_unused]] const islet::MoverDef cpp = {};
    EXPECT_EQ(c.struct_size, sizeof c);
    EXPECT_EQ(c.reserved, 0u);
    EXPECT_EQ(c.capsule.point1.x, cpp.capsule.point1.x);
    EXPECT_EQ(c.capsule.point1.y, cpp.capsule.point1.y);
    EXPECT_EQ(c.capsule.point2.x, cpp.capsule.point2.x);
    EXPECT_EQ(c.capsule.point2.y, cpp.capsule.point2.y);
    EXPECT_EQ(c.capsule.radius, cpp.capsule.radius);
    EXPECT_EQ(c.up.x, cpp.up.x);
    EXPECT_EQ(c.up.y, cpp.up.y);
    EXPECT_EQ(c.gravity_scale, cpp.gravity_scale);
    EXPECT_EQ(c.max_slope, cpp.max_slope);
    EXPECT_EQ(c.step_height, cpp.step_height);
    EXPECT_EQ(c.snap_distance, cpp.snap_distance);
    EXPECT_EQ(c.ground_acceleration, cpp.ground_acceleration);
    EXPECT_EQ(c.air_acceleration, cpp.air_acceleration);
    EXPECT_EQ(c.mass, cpp.mass);
    EXPECT_EQ(c.max_push_force, cpp.max_push_force);
    EXPECT_EQ(c.filter.category, cpp.filter.category);
    EXPECT_EQ(c.filter.mask, cpp.filter.mask);
    EXPECT_EQ(c.filter.sensors, cpp.filter.sensors);
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
    EXPECT_EQ(c.body.index1, cpp.body.index1);
    EXPECT_EQ(c.body.generation, cpp.body.generation);
}

TEST(Defaults, OfSnapshotInfo) {
    const IsletSnapshotInfo c = islet_default_snapshot_info();
    [[maybe_unused]] const islet::SnapshotInfo cpp = {};
    EXPECT_EQ(c.struct_size, sizeof c);
    EXPECT_EQ(c.reserved, 0u);
    EXPECT_EQ(c.capacity, nullptr);
    EXPECT_EQ(c.used, nullptr);
    EXPECT_EQ(c.bytes, cpp.bytes);
}

}  // namespace
