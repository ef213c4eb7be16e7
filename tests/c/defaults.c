// The defaults as a program in C gets them, for the tests in C++.
//
// Made by bindings/c/generate.py; do not edit.
#include <islet/islet.h>

IsletRot default_rot_of_c(void);
IsletRot default_rot_of_c(void) { return islet_default_rot(); }
IsletTransform default_transform_of_c(void);
IsletTransform default_transform_of_c(void) { return islet_default_transform(); }
IsletCircle default_circle_of_c(void);
IsletCircle default_circle_of_c(void) { return islet_default_circle(); }
IsletCapsule default_capsule_of_c(void);
IsletCapsule default_capsule_of_c(void) { return islet_default_capsule(); }
IsletHalfSpace default_half_space_of_c(void);
IsletHalfSpace default_half_space_of_c(void) { return islet_default_half_space(); }
IsletDrawStyle default_draw_style_of_c(void);
IsletDrawStyle default_draw_style_of_c(void) { return islet_default_draw_style(); }
IsletDebugDraw default_debug_draw_of_c(void);
IsletDebugDraw default_debug_draw_of_c(void) { return islet_default_debug_draw(); }
IsletTaskSystem default_task_system_of_c(void);
IsletTaskSystem default_task_system_of_c(void) { return islet_default_task_system(); }
IsletCapacity default_capacity_of_c(void);
IsletCapacity default_capacity_of_c(void) { return islet_default_capacity(); }
IsletHooks default_hooks_of_c(void);
IsletHooks default_hooks_of_c(void) { return islet_default_hooks(); }
IsletSolverDef default_solver_def_of_c(void);
IsletSolverDef default_solver_def_of_c(void) { return islet_default_solver_def(); }
IsletWorldDef default_world_def_of_c(void);
IsletWorldDef default_world_def_of_c(void) { return islet_default_world_def(); }
IsletBodyDef default_body_def_of_c(void);
IsletBodyDef default_body_def_of_c(void) { return islet_default_body_def(); }
IsletFilter default_filter_of_c(void);
IsletFilter default_filter_of_c(void) { return islet_default_filter(); }
IsletSurfaceMaterial default_surface_material_of_c(void);
IsletSurfaceMaterial default_surface_material_of_c(void) { return islet_default_surface_material(); }
IsletShapeDef default_shape_def_of_c(void);
IsletShapeDef default_shape_def_of_c(void) { return islet_default_shape_def(); }
IsletExplosionDef default_explosion_def_of_c(void);
IsletExplosionDef default_explosion_def_of_c(void) { return islet_default_explosion_def(); }
IsletWindDef default_wind_def_of_c(void);
IsletWindDef default_wind_def_of_c(void) { return islet_default_wind_def(); }
IsletStepReport default_step_report_of_c(void);
IsletStepReport default_step_report_of_c(void) { return islet_default_step_report(); }
IsletStepProfile default_step_profile_of_c(void);
IsletStepProfile default_step_profile_of_c(void) { return islet_default_step_profile(); }
IsletWorldCounters default_world_counters_of_c(void);
IsletWorldCounters default_world_counters_of_c(void) { return islet_default_world_counters(); }
IsletPreSolve default_pre_solve_of_c(void);
IsletPreSolve default_pre_solve_of_c(void) { return islet_default_pre_solve(); }
IsletJointSoftness default_joint_softness_of_c(void);
IsletJointSoftness default_joint_softness_of_c(void) { return islet_default_joint_softness(); }
IsletRevoluteJointDef default_revolute_joint_def_of_c(void);
IsletRevoluteJointDef default_revolute_joint_def_of_c(void) { return islet_default_revolute_joint_def(); }
IsletPrismaticJointDef default_prismatic_joint_def_of_c(void);
IsletPrismaticJointDef default_prismatic_joint_def_of_c(void) { return islet_default_prismatic_joint_def(); }
IsletDistanceJointDef default_distance_joint_def_of_c(void);
IsletDistanceJointDef default_distance_joint_def_of_c(void) { return islet_default_distance_joint_def(); }
IsletWeldJointDef default_weld_joint_def_of_c(void);
IsletWeldJointDef default_weld_joint_def_of_c(void) { return islet_default_weld_joint_def(); }
IsletWheelJointDef default_wheel_joint_def_of_c(void);
IsletWheelJointDef default_wheel_joint_def_of_c(void) { return islet_default_wheel_joint_def(); }
IsletMotorJointDef default_motor_joint_def_of_c(void);
IsletMotorJointDef default_motor_joint_def_of_c(void) { return islet_default_motor_joint_def(); }
IsletMouseJointDef default_mouse_joint_def_of_c(void);
IsletMouseJointDef default_mouse_joint_def_of_c(void) { return islet_default_mouse_joint_def(); }
IsletPulleyJointDef default_pulley_joint_def_of_c(void);
IsletPulleyJointDef default_pulley_joint_def_of_c(void) { return islet_default_pulley_joint_def(); }
IsletGearJointDef default_gear_joint_def_of_c(void);
IsletGearJointDef default_gear_joint_def_of_c(void) { return islet_default_gear_joint_def(); }
IsletAngleJointDef default_angle_joint_def_of_c(void);
IsletAngleJointDef default_angle_joint_def_of_c(void) { return islet_default_angle_joint_def(); }
IsletQueryFilter default_query_filter_of_c(void);
IsletQueryFilter default_query_filter_of_c(void) { return islet_default_query_filter(); }
IsletDrive default_drive_of_c(void);
IsletDrive default_drive_of_c(void) { return islet_default_drive(); }
IsletSense default_sense_of_c(void);
IsletSense default_sense_of_c(void) { return islet_default_sense(); }
IsletFormatInfo default_format_info_of_c(void);
IsletFormatInfo default_format_info_of_c(void) { return islet_default_format_info(); }
IsletRowEnd default_row_end_of_c(void);
IsletRowEnd default_row_end_of_c(void) { return islet_default_row_end(); }
IsletMoverDef default_mover_def_of_c(void);
IsletMoverDef default_mover_def_of_c(void) { return islet_default_mover_def(); }
IsletMoverInput default_mover_input_of_c(void);
IsletMoverInput default_mover_input_of_c(void) { return islet_default_mover_input(); }
IsletRecordingInfo default_recording_info_of_c(void);
IsletRecordingInfo default_recording_info_of_c(void) { return islet_default_recording_info(); }
IsletReplayResult default_replay_result_of_c(void);
IsletReplayResult default_replay_result_of_c(void) { return islet_default_replay_result(); }
IsletSnapshotInfo default_snapshot_info_of_c(void);
IsletSnapshotInfo default_snapshot_info_of_c(void) { return islet_default_snapshot_info(); }
