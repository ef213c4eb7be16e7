// The defaults of all structs but those of joints in C are those of C++.
//
// Made by bindings/c/generate.py; do not edit.
#include <gtest/gtest.h>
#include <islet/islet.h>

#include <islet/islet.hpp>
#include <islet/fleet.hpp>
#include <islet/island.hpp>

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

void expect_same(const IsletJointId& c, const islet::JointId& cpp) {
    EXPECT_EQ(c.index1, cpp.index1);
    EXPECT_EQ(c.generation, cpp.generation);
}

void expect_same(const IsletQueryFilter& c, const islet::QueryFilter& cpp) {
    EXPECT_EQ(c.category, cpp.category);
    EXPECT_EQ(c.mask, cpp.mask);
    EXPECT_EQ(c.sensors, cpp.sensors);
}

void expect_same(const IsletCapsule& c, const islet::Capsule& cpp) {
    expect_same(c.point1, cpp.point1);
    expect_same(c.point2, cpp.point2);
    EXPECT_EQ(c.radius, cpp.radius);
}

extern "C" IsletRot default_rot_of_c(void);
TEST(Defaults, OfRot) {
    const islet::Rot cpp = {};
    for (const IsletRot& c : {islet_default_rot(), default_rot_of_c()}) {
        expect_same(c, cpp);
    }
}

extern "C" IsletTransform default_transform_of_c(void);
TEST(Defaults, OfTransform) {
    const islet::Transform cpp = {};
    for (const IsletTransform& c : {islet_default_transform(), default_transform_of_c()}) {
        expect_same(c.p, cpp.p);
        expect_same(c.q, cpp.q);
    }
}

extern "C" IsletCircle default_circle_of_c(void);
TEST(Defaults, OfCircle) {
    const islet::Circle cpp = {};
    for (const IsletCircle& c : {islet_default_circle(), default_circle_of_c()}) {
        expect_same(c.center, cpp.center);
        EXPECT_EQ(c.radius, cpp.radius);
    }
}

extern "C" IsletCapsule default_capsule_of_c(void);
TEST(Defaults, OfCapsule) {
    const islet::Capsule cpp = {};
    for (const IsletCapsule& c : {islet_default_capsule(), default_capsule_of_c()}) {
        expect_same(c, cpp);
    }
}

extern "C" IsletHalfSpace default_half_space_of_c(void);
TEST(Defaults, OfHalfSpace) {
    const islet::HalfSpace cpp = {};
    for (const IsletHalfSpace& c : {islet_default_half_space(), default_half_space_of_c()}) {
        expect_same(c.normal, cpp.normal);
        EXPECT_EQ(c.offset, cpp.offset);
    }
}

extern "C" IsletDrawStyle default_draw_style_of_c(void);
TEST(Defaults, OfDrawStyle) {
    const islet::DrawStyle cpp = {};
    for (const IsletDrawStyle& c : {islet_default_draw_style(), default_draw_style_of_c()}) {
        EXPECT_EQ(c.color, cpp.color);
        EXPECT_EQ(int(c.part), int(cpp.part));
        EXPECT_EQ(c.solid, cpp.solid);
        EXPECT_EQ(c.slot, cpp.slot);
    }
}

extern "C" IsletDebugDraw default_debug_draw_of_c(void);
TEST(Defaults, OfDebugDraw) {
    const islet::DebugDraw cpp = {};
    for (const IsletDebugDraw& c : {islet_default_debug_draw(), default_debug_draw_of_c()}) {
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
}

extern "C" IsletTaskSystem default_task_system_of_c(void);
TEST(Defaults, OfTaskSystem) {
    const islet::TaskSystem cpp = {};
    for (const IsletTaskSystem& c : {islet_default_task_system(), default_task_system_of_c()}) {
        EXPECT_EQ(c.struct_size, sizeof c);
        EXPECT_EQ(c.reserved, 0u);
        EXPECT_TRUE(c.parallel_for == nullptr && cpp.parallel_for == nullptr);
        EXPECT_EQ(c.context, cpp.context);
        EXPECT_EQ(c.workers, cpp.workers);
        EXPECT_TRUE(c.ready_workers == nullptr && cpp.ready_workers == nullptr);
    }
}

extern "C" IsletCapacity default_capacity_of_c(void);
TEST(Defaults, OfCapacity) {
    const islet::Capacity cpp = {};
    for (const IsletCapacity& c : {islet_default_capacity(), default_capacity_of_c()}) {
        EXPECT_EQ(c.struct_size, sizeof c);
        EXPECT_EQ(c.bodies, cpp.bodies);
        EXPECT_EQ(c.shapes, cpp.shapes);
        EXPECT_EQ(c.contacts, cpp.contacts);
        EXPECT_EQ(c.joints, cpp.joints);
        EXPECT_EQ(c.geometries, cpp.geometries);
        EXPECT_EQ(c.hits, cpp.hits);
        EXPECT_EQ(c.events, cpp.events);
    }
}

extern "C" IsletHooks default_hooks_of_c(void);
TEST(Defaults, OfHooks) {
    const islet::Hooks cpp = {};
    for (const IsletHooks& c : {islet_default_hooks(), default_hooks_of_c()}) {
        EXPECT_EQ(c.struct_size, sizeof c);
        EXPECT_EQ(c.reserved, 0u);
        EXPECT_TRUE(c.filter == nullptr && cpp.filter == nullptr);
        EXPECT_TRUE(c.pre_solve == nullptr && cpp.pre_solve == nullptr);
        EXPECT_TRUE(c.mix_friction == nullptr && cpp.mix_friction == nullptr);
        EXPECT_TRUE(c.mix_restitution == nullptr && cpp.mix_restitution == nullptr);
        EXPECT_EQ(c.context, cpp.context);
    }
}

extern "C" IsletSolverDef default_solver_def_of_c(void);
TEST(Defaults, OfSolverDef) {
    const islet::SolverDef cpp = {};
    for (const IsletSolverDef& c : {islet_default_solver_def(), default_solver_def_of_c()}) {
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
}

extern "C" IsletWorldDef default_world_def_of_c(void);
TEST(Defaults, OfWorldDef) {
    const islet::WorldDef cpp = {};
    for (const IsletWorldDef& c : {islet_default_world_def(), default_world_def_of_c()}) {
        EXPECT_EQ(c.struct_size, sizeof c);
        EXPECT_EQ(c.reserved, 0u);
        expect_same(c.gravity, cpp.gravity);
        EXPECT_EQ(c.solver, nullptr);
        EXPECT_EQ(c.enable_sleep, cpp.enable_sleep);
        EXPECT_EQ(c.restitution_threshold, cpp.restitution_threshold);
        EXPECT_EQ(c.max_speed, cpp.max_speed);
        EXPECT_EQ(c.hit_threshold, cpp.hit_threshold);
        EXPECT_EQ(c.continuous, cpp.continuous);
        EXPECT_EQ(c.seamless_floors, cpp.seamless_floors);
        EXPECT_EQ(c.lanes, cpp.lanes);
        EXPECT_TRUE(c.error_hook == nullptr && cpp.error_hook == nullptr);
        EXPECT_EQ(c.error_context, cpp.error_context);
        EXPECT_EQ(c.hooks, nullptr);
        EXPECT_EQ(c.tasks, nullptr);
        EXPECT_TRUE(c.clock == nullptr && cpp.clock == nullptr);
        EXPECT_EQ(c.clock_context, cpp.clock_context);
    }
}

extern "C" IsletBodyDef default_body_def_of_c(void);
TEST(Defaults, OfBodyDef) {
    const islet::BodyDef cpp = {};
    for (const IsletBodyDef& c : {islet_default_body_def(), default_body_def_of_c()}) {
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
}

extern "C" IsletFilter default_filter_of_c(void);
TEST(Defaults, OfFilter) {
    const islet::Filter cpp = {};
    for (const IsletFilter& c : {islet_default_filter(), default_filter_of_c()}) {
        expect_same(c, cpp);
    }
}

extern "C" IsletSurfaceMaterial default_surface_material_of_c(void);
TEST(Defaults, OfSurfaceMaterial) {
    const islet::SurfaceMaterial cpp = {};
    for (const IsletSurfaceMaterial& c : {islet_default_surface_material(), default_surface_material_of_c()}) {
        EXPECT_EQ(c.friction, cpp.friction);
        EXPECT_EQ(c.restitution, cpp.restitution);
        EXPECT_EQ(c.rolling_resistance, cpp.rolling_resistance);
        EXPECT_EQ(c.tangent_speed, cpp.tangent_speed);
        EXPECT_EQ(c.id, cpp.id);
    }
}

extern "C" IsletShapeDef default_shape_def_of_c(void);
TEST(Defaults, OfShapeDef) {
    const islet::ShapeDef cpp = {};
    for (const IsletShapeDef& c : {islet_default_shape_def(), default_shape_def_of_c()}) {
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
}

extern "C" IsletExplosionDef default_explosion_def_of_c(void);
TEST(Defaults, OfExplosionDef) {
    const islet::ExplosionDef cpp = {};
    for (const IsletExplosionDef& c : {islet_default_explosion_def(), default_explosion_def_of_c()}) {
        EXPECT_EQ(c.struct_size, sizeof c);
        expect_same(c.position, cpp.position);
        EXPECT_EQ(c.radius, cpp.radius);
        EXPECT_EQ(c.falloff, cpp.falloff);
        EXPECT_EQ(c.impulse_per_length, cpp.impulse_per_length);
        EXPECT_EQ(c.mask, cpp.mask);
    }
}

extern "C" IsletWindDef default_wind_def_of_c(void);
TEST(Defaults, OfWindDef) {
    const islet::WindDef cpp = {};
    for (const IsletWindDef& c : {islet_default_wind_def(), default_wind_def_of_c()}) {
        EXPECT_EQ(c.struct_size, sizeof c);
        expect_same(c.velocity, cpp.velocity);
        EXPECT_EQ(c.drag, cpp.drag);
        EXPECT_EQ(c.lift, cpp.lift);
        EXPECT_EQ(c.density, cpp.density);
        EXPECT_EQ(c.wake, cpp.wake);
    }
}

extern "C" IsletStepReport default_step_report_of_c(void);
TEST(Defaults, OfStepReport) {
    const islet::StepReport cpp = {};
    for (const IsletStepReport& c : {islet_default_step_report(), default_step_report_of_c()}) {
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
}

extern "C" IsletStepProfile default_step_profile_of_c(void);
TEST(Defaults, OfStepProfile) {
    const islet::StepProfile cpp = {};
    for (const IsletStepProfile& c : {islet_default_step_profile(), default_step_profile_of_c()}) {
        EXPECT_EQ(c.struct_size, sizeof c);
        EXPECT_EQ(c.reserved, 0u);
        EXPECT_EQ(c.pairs, cpp.pairs);
        EXPECT_EQ(c.collide, cpp.collide);
        EXPECT_EQ(c.islands, cpp.islands);
        EXPECT_EQ(c.solve, cpp.solve);
        EXPECT_EQ(c.finish, cpp.finish);
        EXPECT_EQ(c.total, cpp.total);
    }
}

extern "C" IsletWorldCounters default_world_counters_of_c(void);
TEST(Defaults, OfWorldCounters) {
    const islet::WorldCounters cpp = {};
    for (const IsletWorldCounters& c : {islet_default_world_counters(), default_world_counters_of_c()}) {
        EXPECT_EQ(c.struct_size, sizeof c);
        EXPECT_EQ(c.reserved, 0u);
        EXPECT_EQ(c.bytes, cpp.bytes);
        EXPECT_EQ(c.snapshot_bytes, cpp.snapshot_bytes);
        EXPECT_EQ(c.geometries, cpp.geometries);
        EXPECT_EQ(c.tree_shapes, cpp.tree_shapes);
        EXPECT_EQ(c.tree_height, cpp.tree_height);
        EXPECT_EQ(c.uncolored, cpp.uncolored);
    }
}

extern "C" IsletPreSolve default_pre_solve_of_c(void);
TEST(Defaults, OfPreSolve) {
    const islet::PreSolve cpp = {};
    for (const IsletPreSolve& c : {islet_default_pre_solve(), default_pre_solve_of_c()}) {
        expect_same(c.contact, cpp.contact);
        EXPECT_EQ(c.enabled, cpp.enabled);
        EXPECT_EQ(c.friction, cpp.friction);
        EXPECT_EQ(c.tangent_speed, cpp.tangent_speed);
    }
}

extern "C" IsletQueryFilter default_query_filter_of_c(void);
TEST(Defaults, OfQueryFilter) {
    const islet::QueryFilter cpp = {};
    for (const IsletQueryFilter& c : {islet_default_query_filter(), default_query_filter_of_c()}) {
        expect_same(c, cpp);
    }
}

extern "C" IsletDrive default_drive_of_c(void);
TEST(Defaults, OfDrive) {
    const islet::Drive cpp = {};
    for (const IsletDrive& c : {islet_default_drive(), default_drive_of_c()}) {
        EXPECT_EQ(int(c.kind), int(cpp.kind));
        expect_same(c.body, cpp.body);
        expect_same(c.joint, cpp.joint);
        EXPECT_EQ(c.scale, cpp.scale);
    }
}

extern "C" IsletSense default_sense_of_c(void);
TEST(Defaults, OfSense) {
    const islet::Sense cpp = {};
    for (const IsletSense& c : {islet_default_sense(), default_sense_of_c()}) {
        EXPECT_EQ(int(c.kind), int(cpp.kind));
        expect_same(c.body, cpp.body);
        expect_same(c.joint, cpp.joint);
        expect_same(c.origin, cpp.origin);
        expect_same(c.translation, cpp.translation);
        expect_same(c.filter, cpp.filter);
    }
}

extern "C" IsletFormatInfo default_format_info_of_c(void);
TEST(Defaults, OfFormatInfo) {
    const islet::FormatInfo cpp = {};
    for (const IsletFormatInfo& c : {islet_default_format_info(), default_format_info_of_c()}) {
        EXPECT_EQ(c.struct_size, sizeof c);
        EXPECT_EQ(int(c.kind), int(cpp.kind));
        EXPECT_EQ(c.format, cpp.format);
        EXPECT_EQ(c.readable, cpp.readable);
        EXPECT_EQ(c.in_recording, cpp.in_recording);
        EXPECT_EQ(c.other_byte_order, cpp.other_byte_order);
    }
}

extern "C" IsletRowEnd default_row_end_of_c(void);
TEST(Defaults, OfRowEnd) {
    const islet::RowEnd cpp = {};
    for (const IsletRowEnd& c : {islet_default_row_end(), default_row_end_of_c()}) {
        EXPECT_EQ(c.body, cpp.body);
        expect_same(c.linear, cpp.linear);
        EXPECT_EQ(c.angular, cpp.angular);
    }
}

extern "C" IsletMoverDef default_mover_def_of_c(void);
TEST(Defaults, OfMoverDef) {
    const islet::MoverDef cpp = {};
    for (const IsletMoverDef& c : {islet_default_mover_def(), default_mover_def_of_c()}) {
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
}

extern "C" IsletMoverInput default_mover_input_of_c(void);
TEST(Defaults, OfMoverInput) {
    const islet::MoverInput cpp = {};
    for (const IsletMoverInput& c : {islet_default_mover_input(), default_mover_input_of_c()}) {
        EXPECT_EQ(c.struct_size, sizeof c);
        EXPECT_EQ(c.walk, cpp.walk);
        EXPECT_EQ(c.jump, cpp.jump);
    }
}

extern "C" IsletRecordingInfo default_recording_info_of_c(void);
TEST(Defaults, OfRecordingInfo) {
    const islet::RecordingInfo cpp = {};
    for (const IsletRecordingInfo& c : {islet_default_recording_info(), default_recording_info_of_c()}) {
        EXPECT_EQ(c.struct_size, sizeof c);
        EXPECT_EQ(c.reserved, 0u);
        EXPECT_EQ(c.capacity, nullptr);
        EXPECT_EQ(c.needed, nullptr);
        EXPECT_EQ(c.bytes, cpp.bytes);
        EXPECT_EQ(c.bodies, cpp.bodies);
    }
}

extern "C" IsletReplayResult default_replay_result_of_c(void);
TEST(Defaults, OfReplayResult) {
    const islet::ReplayResult cpp = {};
    for (const IsletReplayResult& c : {islet_default_replay_result(), default_replay_result_of_c()}) {
        EXPECT_EQ(c.struct_size, sizeof c);
        EXPECT_EQ(c.reserved, 0u);
        EXPECT_EQ(int(c.end), int(cpp.end));
        EXPECT_EQ(int(c.error), int(cpp.error));
        EXPECT_EQ(c.steps, cpp.steps);
        EXPECT_EQ(c.recorded_hash, cpp.recorded_hash);
        EXPECT_EQ(c.hash, cpp.hash);
        expect_same(c.body, cpp.body);
    }
}

extern "C" IsletSnapshotInfo default_snapshot_info_of_c(void);
TEST(Defaults, OfSnapshotInfo) {
    const islet::SnapshotInfo cpp = {};
    for (const IsletSnapshotInfo& c : {islet_default_snapshot_info(), default_snapshot_info_of_c()}) {
        EXPECT_EQ(c.struct_size, sizeof c);
        EXPECT_EQ(c.reserved, 0u);
        EXPECT_EQ(c.bytes, cpp.bytes);
        EXPECT_EQ(c.capacity, nullptr);
        EXPECT_EQ(c.used, nullptr);
    }
}

}  // namespace
