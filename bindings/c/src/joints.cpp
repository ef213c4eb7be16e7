// Functions of islet.h: joints.
//
// Made by bindings/c/generate.py; do not edit.
#include "glue.hpp"

using namespace islet;
using namespace islet::c;

extern "C" {

IsletJointBreakEventSpan islet_world_broken_joints(const IsletWorld* world) {
    if (world == nullptr) return {};
    const auto found = of(world).broken_joints();
    return {cast<const IsletJointBreakEvent>(found.data()), found.size()};
}

IsletJointId islet_create_revolute_joint(IsletWorld* world, const IsletRevoluteJointDef* def) {
    if (world == nullptr) return out(JointId{});
    Room<RevoluteJointDef> def_room;
    const RevoluteJointDef* def_taken = take<RevoluteJointDef>(world, def, def_room);
    if (def_taken == nullptr) return out(JointId{});
    return out(of(world).create_joint(*def_taken));
}

IsletJointId islet_create_prismatic_joint(IsletWorld* world, const IsletPrismaticJointDef* def) {
    if (world == nullptr) return out(JointId{});
    Room<PrismaticJointDef> def_room;
    const PrismaticJointDef* def_taken = take<PrismaticJointDef>(world, def, def_room);
    if (def_taken == nullptr) return out(JointId{});
    return out(of(world).create_joint(*def_taken));
}

IsletJointId islet_create_distance_joint(IsletWorld* world, const IsletDistanceJointDef* def) {
    if (world == nullptr) return out(JointId{});
    Room<DistanceJointDef> def_room;
    const DistanceJointDef* def_taken = take<DistanceJointDef>(world, def, def_room);
    if (def_taken == nullptr) return out(JointId{});
    return out(of(world).create_joint(*def_taken));
}

IsletJointId islet_create_weld_joint(IsletWorld* world, const IsletWeldJointDef* def) {
    if (world == nullptr) return out(JointId{});
    Room<WeldJointDef> def_room;
    const WeldJointDef* def_taken = take<WeldJointDef>(world, def, def_room);
    if (def_taken == nullptr) return out(JointId{});
    return out(of(world).create_joint(*def_taken));
}

IsletJointId islet_create_wheel_joint(IsletWorld* world, const IsletWheelJointDef* def) {
    if (world == nullptr) return out(JointId{});
    Room<WheelJointDef> def_room;
    const WheelJointDef* def_taken = take<WheelJointDef>(world, def, def_room);
    if (def_taken == nullptr) return out(JointId{});
    return out(of(world).create_joint(*def_taken));
}

IsletJointId islet_create_motor_joint(IsletWorld* world, const IsletMotorJointDef* def) {
    if (world == nullptr) return out(JointId{});
    Room<MotorJointDef> def_room;
    const MotorJointDef* def_taken = take<MotorJointDef>(world, def, def_room);
    if (def_taken == nullptr) return out(JointId{});
    return out(of(world).create_joint(*def_taken));
}

IsletJointId islet_create_mouse_joint(IsletWorld* world, const IsletMouseJointDef* def) {
    if (world == nullptr) return out(JointId{});
    Room<MouseJointDef> def_room;
    const MouseJointDef* def_taken = take<MouseJointDef>(world, def, def_room);
    if (def_taken == nullptr) return out(JointId{});
    return out(of(world).create_joint(*def_taken));
}

IsletJointId islet_create_pulley_joint(IsletWorld* world, const IsletPulleyJointDef* def) {
    if (world == nullptr) return out(JointId{});
    Room<PulleyJointDef> def_room;
    const PulleyJointDef* def_taken = take<PulleyJointDef>(world, def, def_room);
    if (def_taken == nullptr) return out(JointId{});
    return out(of(world).create_joint(*def_taken));
}

IsletJointId islet_create_gear_joint(IsletWorld* world, const IsletGearJointDef* def) {
    if (world == nullptr) return out(JointId{});
    Room<GearJointDef> def_room;
    const GearJointDef* def_taken = take<GearJointDef>(world, def, def_room);
    if (def_taken == nullptr) return out(JointId{});
    return out(of(world).create_joint(*def_taken));
}

IsletJointId islet_create_angle_joint(IsletWorld* world, const IsletAngleJointDef* def) {
    if (world == nullptr) return out(JointId{});
    Room<AngleJointDef> def_room;
    const AngleJointDef* def_taken = take<AngleJointDef>(world, def, def_room);
    if (def_taken == nullptr) return out(JointId{});
    return out(of(world).create_joint(*def_taken));
}

IsletError islet_destroy_joint(IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).destroy_joint(in<JointId>(joint));
    return end(world, before);
}

bool islet_joint_is_valid(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return false;
    return of(world).is_valid(in<JointId>(joint));
}

uint32_t islet_world_joint_count(const IsletWorld* world) {
    if (world == nullptr) return 0;
    return of(world).joint_count();
}

IsletJointId islet_world_joint_at(const IsletWorld* world, uint32_t slot) {
    if (world == nullptr) return out(JointId{});
    return out(of(world).joint_at(slot));
}

uint32_t islet_body_joints(const IsletWorld* world, IsletBodyId body, IsletJointId* out, size_t out_count) {
    if (world == nullptr) return 0;
    if (out == nullptr && out_count != 0) return refuse(world, ISLET_ERROR_NULL_POINTER), 0;
    return of(world).joints(in<BodyId>(body), span_of<JointId>(out, out_count));
}

IsletJointType islet_joint_type(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return out(JointType{});
    return out(of(world).joint_type(in<JointId>(joint)));
}

IsletBodyId islet_joint_body_a(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return out(BodyId{});
    return out(of(world).body_a(in<JointId>(joint)));
}

IsletBodyId islet_joint_body_b(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return out(BodyId{});
    return out(of(world).body_b(in<JointId>(joint)));
}

IsletJointFrame islet_joint_frame_a(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return out(JointFrame{});
    return out(of(world).frame_a(in<JointId>(joint)));
}

IsletJointFrame islet_joint_frame_b(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return out(JointFrame{});
    return out(of(world).frame_b(in<JointId>(joint)));
}

IsletError islet_joint_set_frames(IsletWorld* world, IsletJointId joint, const IsletJointFrame* frame_a, const IsletJointFrame* frame_b) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (frame_a == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER);
    if (frame_b == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER);
    const Error before = begin(world);
    of(world).set_frames(in<JointId>(joint), *cast<const JointFrame>(frame_a), *cast<const JointFrame>(frame_b));
    return end(world, before);
}

IsletVec2 islet_joint_anchor_a(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return out(Vec2{});
    return out(of(world).anchor_a(in<JointId>(joint)));
}

IsletVec2 islet_joint_anchor_b(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return out(Vec2{});
    return out(of(world).anchor_b(in<JointId>(joint)));
}

bool islet_joint_collide_connected(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return false;
    return of(world).collide_connected(in<JointId>(joint));
}

IsletError islet_joint_set_collide_connected(IsletWorld* world, IsletJointId joint, bool collide) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_collide_connected(in<JointId>(joint), collide);
    return end(world, before);
}

float islet_joint_break_force(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return 0;
    return of(world).break_force(in<JointId>(joint));
}

float islet_joint_break_torque(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return 0;
    return of(world).break_torque(in<JointId>(joint));
}

IsletError islet_joint_set_break(IsletWorld* world, IsletJointId joint, float force, float torque) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_break(in<JointId>(joint), force, torque);
    return end(world, before);
}

uint64_t islet_joint_user_data(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return 0;
    return of(world).user_data(in<JointId>(joint));
}

IsletError islet_joint_set_user_data(IsletWorld* world, IsletJointId joint, uint64_t data) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_user_data(in<JointId>(joint), data);
    return end(world, before);
}

float islet_joint_position(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return 0;
    return of(world).joint_position(in<JointId>(joint));
}

float islet_joint_speed(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return 0;
    return of(world).joint_speed(in<JointId>(joint));
}

IsletJointSpring islet_joint_spring(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return out(JointSpring{});
    return out(of(world).spring(in<JointId>(joint)));
}

IsletError islet_joint_set_spring(IsletWorld* world, IsletJointId joint, const IsletJointSpring* spring) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (spring == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER);
    const Error before = begin(world);
    of(world).set_spring(in<JointId>(joint), *cast<const JointSpring>(spring));
    return end(world, before);
}

IsletJointLimit islet_joint_limit(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return out(JointLimit{});
    return out(of(world).limit(in<JointId>(joint)));
}

IsletError islet_joint_set_limit(IsletWorld* world, IsletJointId joint, const IsletJointLimit* limit) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (limit == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER);
    const Error before = begin(world);
    of(world).set_limit(in<JointId>(joint), *cast<const JointLimit>(limit));
    return end(world, before);
}

IsletJointMotor islet_joint_motor(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return out(JointMotor{});
    return out(of(world).motor(in<JointId>(joint)));
}

IsletError islet_joint_set_motor(IsletWorld* world, IsletJointId joint, const IsletJointMotor* motor) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (motor == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER);
    const Error before = begin(world);
    of(world).set_motor(in<JointId>(joint), *cast<const JointMotor>(motor));
    return end(world, before);
}

float islet_joint_friction(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return 0;
    return of(world).joint_friction(in<JointId>(joint));
}

IsletError islet_joint_set_friction(IsletWorld* world, IsletJointId joint, float friction) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_joint_friction(in<JointId>(joint), friction);
    return end(world, before);
}

float islet_joint_motor_force(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return 0;
    return of(world).motor_force(in<JointId>(joint));
}

IsletJointRatchet islet_joint_ratchet(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return out(JointRatchet{});
    return out(of(world).ratchet(in<JointId>(joint)));
}

IsletError islet_joint_set_ratchet(IsletWorld* world, IsletJointId joint, const IsletJointRatchet* ratchet) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (ratchet == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER);
    const Error before = begin(world);
    of(world).set_ratchet(in<JointId>(joint), *cast<const JointRatchet>(ratchet));
    return end(world, before);
}

float islet_joint_length(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return 0;
    return of(world).joint_length(in<JointId>(joint));
}

IsletError islet_joint_set_length(IsletWorld* world, IsletJointId joint, float length) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_joint_length(in<JointId>(joint), length);
    return end(world, before);
}

IsletJointSoftness islet_joint_softness(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return out(JointSoftness{});
    return out(of(world).softness(in<JointId>(joint)));
}

IsletError islet_joint_set_softness(IsletWorld* world, IsletJointId joint, const IsletJointSoftness* softness) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (softness == nullptr) return refuse(world, ISLET_ERROR_NULL_POINTER);
    const Error before = begin(world);
    of(world).set_softness(in<JointId>(joint), *cast<const JointSoftness>(softness));
    return end(world, before);
}

IsletVec2 islet_joint_linear_velocity(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return out(Vec2{});
    return out(of(world).joint_linear_velocity(in<JointId>(joint)));
}

float islet_joint_angular_velocity(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return 0;
    return of(world).joint_angular_velocity(in<JointId>(joint));
}

IsletError islet_joint_set_velocity(IsletWorld* world, IsletJointId joint, IsletVec2 linear, float angular) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_joint_velocity(in<JointId>(joint), in<Vec2>(linear), angular);
    return end(world, before);
}

float islet_joint_max_force(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return 0;
    return of(world).joint_max_force(in<JointId>(joint));
}

float islet_joint_max_torque(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return 0;
    return of(world).joint_max_torque(in<JointId>(joint));
}

IsletError islet_joint_set_strength(IsletWorld* world, IsletJointId joint, float max_force, float max_torque) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_joint_strength(in<JointId>(joint), max_force, max_torque);
    return end(world, before);
}

IsletVec2 islet_joint_target(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return out(Vec2{});
    return out(of(world).target(in<JointId>(joint)));
}

IsletError islet_joint_set_target(IsletWorld* world, IsletJointId joint, IsletVec2 target) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_target(in<JointId>(joint), in<Vec2>(target));
    return end(world, before);
}

IsletVec2 islet_joint_ground_a(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return out(Vec2{});
    return out(of(world).ground_a(in<JointId>(joint)));
}

IsletVec2 islet_joint_ground_b(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return out(Vec2{});
    return out(of(world).ground_b(in<JointId>(joint)));
}

IsletError islet_joint_set_grounds(IsletWorld* world, IsletJointId joint, IsletVec2 ground_a, IsletVec2 ground_b) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_grounds(in<JointId>(joint), in<Vec2>(ground_a), in<Vec2>(ground_b));
    return end(world, before);
}

float islet_joint_ratio(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return 0;
    return of(world).joint_ratio(in<JointId>(joint));
}

IsletError islet_joint_set_ratio(IsletWorld* world, IsletJointId joint, float ratio) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    const Error before = begin(world);
    of(world).set_joint_ratio(in<JointId>(joint), ratio);
    return end(world, before);
}

IsletJointId islet_gear_joint1(const IsletWorld* world, IsletJointId gear) {
    if (world == nullptr) return out(JointId{});
    return out(of(world).joint1(in<JointId>(gear)));
}

IsletJointId islet_gear_joint2(const IsletWorld* world, IsletJointId gear) {
    if (world == nullptr) return out(JointId{});
    return out(of(world).joint2(in<JointId>(gear)));
}

IsletVec2 islet_joint_force(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return out(Vec2{});
    return out(of(world).joint_force(in<JointId>(joint)));
}

float islet_joint_torque(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return 0;
    return of(world).joint_torque(in<JointId>(joint));
}

IsletJointError islet_joint_error(const IsletWorld* world, IsletJointId joint) {
    if (world == nullptr) return out(JointError{});
    return out(of(world).joint_error(in<JointId>(joint)));
}

}  // extern "C"
