// Functions of islet.h: joints.
//
// Made by bindings/c/generate.py; do not edit.
#include "glue.hpp"

using namespace islet;
using namespace islet::c;

extern "C" {

IsletJointBreakEventSpan islet_world_broken_joints(const IsletWorld* world) {
    span<const JointBreakEvent> found;
    if (world != nullptr) found = of(world).broken_joints();
    return {cast<const IsletJointBreakEvent>(found.data()), found.size()};
}

IsletJointId islet_create_revolute_joint(IsletWorld* world, const IsletRevoluteJointDef* def) {
    Room<RevoluteJointDef> def_room;
    const RevoluteJointDef* def_taken = nullptr;
    IsletJointId found = {};
    if ((def_taken = take<RevoluteJointDef>(world, def, def_room)) != nullptr) new (&found) JointId(of(world).create_joint(*def_taken));
    return found;
}

IsletJointId islet_create_prismatic_joint(IsletWorld* world, const IsletPrismaticJointDef* def) {
    Room<PrismaticJointDef> def_room;
    const PrismaticJointDef* def_taken = nullptr;
    IsletJointId found = {};
    if ((def_taken = take<PrismaticJointDef>(world, def, def_room)) != nullptr) new (&found) JointId(of(world).create_joint(*def_taken));
    return found;
}

IsletJointId islet_create_distance_joint(IsletWorld* world, const IsletDistanceJointDef* def) {
    Room<DistanceJointDef> def_room;
    const DistanceJointDef* def_taken = nullptr;
    IsletJointId found = {};
    if ((def_taken = take<DistanceJointDef>(world, def, def_room)) != nullptr) new (&found) JointId(of(world).create_joint(*def_taken));
    return found;
}

IsletJointId islet_create_weld_joint(IsletWorld* world, const IsletWeldJointDef* def) {
    Room<WeldJointDef> def_room;
    const WeldJointDef* def_taken = nullptr;
    IsletJointId found = {};
    if ((def_taken = take<WeldJointDef>(world, def, def_room)) != nullptr) new (&found) JointId(of(world).create_joint(*def_taken));
    return found;
}

IsletJointId islet_create_wheel_joint(IsletWorld* world, const IsletWheelJointDef* def) {
    Room<WheelJointDef> def_room;
    const WheelJointDef* def_taken = nullptr;
    IsletJointId found = {};
    if ((def_taken = take<WheelJointDef>(world, def, def_room)) != nullptr) new (&found) JointId(of(world).create_joint(*def_taken));
    return found;
}

IsletJointId islet_create_motor_joint(IsletWorld* world, const IsletMotorJointDef* def) {
    Room<MotorJointDef> def_room;
    const MotorJointDef* def_taken = nullptr;
    IsletJointId found = {};
    if ((def_taken = take<MotorJointDef>(world, def, def_room)) != nullptr) new (&found) JointId(of(world).create_joint(*def_taken));
    return found;
}

IsletJointId islet_create_mouse_joint(IsletWorld* world, const IsletMouseJointDef* def) {
    Room<MouseJointDef> def_room;
    const MouseJointDef* def_taken = nullptr;
    IsletJointId found = {};
    if ((def_taken = take<MouseJointDef>(world, def, def_room)) != nullptr) new (&found) JointId(of(world).create_joint(*def_taken));
    return found;
}

IsletJointId islet_create_pulley_joint(IsletWorld* world, const IsletPulleyJointDef* def) {
    Room<PulleyJointDef> def_room;
    const PulleyJointDef* def_taken = nullptr;
    IsletJointId found = {};
    if ((def_taken = take<PulleyJointDef>(world, def, def_room)) != nullptr) new (&found) JointId(of(world).create_joint(*def_taken));
    return found;
}

IsletJointId islet_create_gear_joint(IsletWorld* world, const IsletGearJointDef* def) {
    Room<GearJointDef> def_room;
    const GearJointDef* def_taken = nullptr;
    IsletJointId found = {};
    if ((def_taken = take<GearJointDef>(world, def, def_room)) != nullptr) new (&found) JointId(of(world).create_joint(*def_taken));
    return found;
}

IsletJointId islet_create_angle_joint(IsletWorld* world, const IsletAngleJointDef* def) {
    Room<AngleJointDef> def_room;
    const AngleJointDef* def_taken = nullptr;
    IsletJointId found = {};
    if ((def_taken = take<AngleJointDef>(world, def, def_room)) != nullptr) new (&found) JointId(of(world).create_joint(*def_taken));
    return found;
}

IsletError islet_destroy_joint(IsletWorld* world, IsletJointId joint) {
    if (begin(world)) of(world).destroy_joint(in<JointId>(joint));
    return end(world);
}

bool islet_joint_is_valid(const IsletWorld* world, IsletJointId joint) {
    bool found = {};
    if (world != nullptr) found = of(world).is_valid(in<JointId>(joint));
    return found;
}

uint32_t islet_world_joint_count(const IsletWorld* world) {
    uint32_t found = {};
    if (world != nullptr) found = of(world).joint_count();
    return found;
}

IsletJointId islet_world_joint_at(const IsletWorld* world, uint32_t slot) {
    IsletJointId found = {};
    if (world != nullptr) new (&found) JointId(of(world).joint_at(slot));
    return found;
}

uint32_t islet_body_joints(const IsletWorld* world, IsletBodyId body, IsletJointId* out, size_t out_count) {
    uint32_t found = {};
    if (world != nullptr && is_there(world, out, out_count)) found = of(world).joints(in<BodyId>(body), span_of<JointId>(out, out_count));
    return found;
}

IsletJointId islet_body_next_joint(const IsletWorld* world, IsletBodyId body, IsletJointId joint) {
    IsletJointId found = {};
    if (world != nullptr) new (&found) JointId(of(world).next_joint(in<BodyId>(body), in<JointId>(joint)));
    return found;
}

IsletJointType islet_joint_type(const IsletWorld* world, IsletJointId joint) {
    JointType found = {};
    if (world != nullptr) found = of(world).joint_type(in<JointId>(joint));
    return out(found);
}

IsletBodyId islet_joint_body_a(const IsletWorld* world, IsletJointId joint) {
    IsletBodyId found = {};
    if (world != nullptr) new (&found) BodyId(of(world).body_a(in<JointId>(joint)));
    return found;
}

IsletBodyId islet_joint_body_b(const IsletWorld* world, IsletJointId joint) {
    IsletBodyId found = {};
    if (world != nullptr) new (&found) BodyId(of(world).body_b(in<JointId>(joint)));
    return found;
}

IsletJointFrame islet_joint_frame_a(const IsletWorld* world, IsletJointId joint) {
    IsletJointFrame found = {};
    if (world != nullptr) new (&found) JointFrame(of(world).frame_a(in<JointId>(joint)));
    return found;
}

IsletJointFrame islet_joint_frame_b(const IsletWorld* world, IsletJointId joint) {
    IsletJointFrame found = {};
    if (world != nullptr) new (&found) JointFrame(of(world).frame_b(in<JointId>(joint)));
    return found;
}

IsletError islet_joint_set_frames(IsletWorld* world, IsletJointId joint, const IsletJointFrame* frame_a, const IsletJointFrame* frame_b) {
    if (begin(world) && is_there(world, frame_a) && is_there(world, frame_b))
        of(world).set_frames(in<JointId>(joint), *cast<const JointFrame>(frame_a), *cast<const JointFrame>(frame_b));
    return end(world);
}

IsletVec2 islet_joint_anchor_a(const IsletWorld* world, IsletJointId joint) {
    Vec2 found = {};
    if (world != nullptr) found = of(world).anchor_a(in<JointId>(joint));
    return out(found);
}

IsletVec2 islet_joint_anchor_b(const IsletWorld* world, IsletJointId joint) {
    Vec2 found = {};
    if (world != nullptr) found = of(world).anchor_b(in<JointId>(joint));
    return out(found);
}

bool islet_joint_collide_connected(const IsletWorld* world, IsletJointId joint) {
    bool found = {};
    if (world != nullptr) found = of(world).collide_connected(in<JointId>(joint));
    return found;
}

IsletError islet_joint_set_collide_connected(IsletWorld* world, IsletJointId joint, bool collide) {
    if (begin(world)) of(world).set_collide_connected(in<JointId>(joint), collide);
    return end(world);
}

float islet_joint_break_force(const IsletWorld* world, IsletJointId joint) {
    float found = {};
    if (world != nullptr) found = of(world).break_force(in<JointId>(joint));
    return found;
}

float islet_joint_break_torque(const IsletWorld* world, IsletJointId joint) {
    float found = {};
    if (world != nullptr) found = of(world).break_torque(in<JointId>(joint));
    return found;
}

IsletError islet_joint_set_break(IsletWorld* world, IsletJointId joint, float force, float torque) {
    if (begin(world)) of(world).set_break(in<JointId>(joint), force, torque);
    return end(world);
}

uint64_t islet_joint_user_data(const IsletWorld* world, IsletJointId joint) {
    uint64_t found = {};
    if (world != nullptr) found = of(world).user_data(in<JointId>(joint));
    return found;
}

IsletError islet_joint_set_user_data(IsletWorld* world, IsletJointId joint, uint64_t data) {
    if (begin(world)) of(world).set_user_data(in<JointId>(joint), data);
    return end(world);
}

float islet_joint_position(const IsletWorld* world, IsletJointId joint) {
    float found = {};
    if (world != nullptr) found = of(world).joint_position(in<JointId>(joint));
    return found;
}

float islet_joint_speed(const IsletWorld* world, IsletJointId joint) {
    float found = {};
    if (world != nullptr) found = of(world).joint_speed(in<JointId>(joint));
    return found;
}

IsletJointSpring islet_joint_spring(const IsletWorld* world, IsletJointId joint) {
    IsletJointSpring found = {};
    if (world != nullptr) new (&found) JointSpring(of(world).spring(in<JointId>(joint)));
    return found;
}

IsletError islet_joint_set_spring(IsletWorld* world, IsletJointId joint, const IsletJointSpring* spring) {
    if (begin(world) && is_there(world, spring)) of(world).set_spring(in<JointId>(joint), *cast<const JointSpring>(spring));
    return end(world);
}

IsletJointLimit islet_joint_limit(const IsletWorld* world, IsletJointId joint) {
    IsletJointLimit found = {};
    if (world != nullptr) new (&found) JointLimit(of(world).limit(in<JointId>(joint)));
    return found;
}

IsletError islet_joint_set_limit(IsletWorld* world, IsletJointId joint, const IsletJointLimit* limit) {
    if (begin(world) && is_there(world, limit)) of(world).set_limit(in<JointId>(joint), *cast<const JointLimit>(limit));
    return end(world);
}

IsletJointMotor islet_joint_motor(const IsletWorld* world, IsletJointId joint) {
    IsletJointMotor found = {};
    if (world != nullptr) new (&found) JointMotor(of(world).motor(in<JointId>(joint)));
    return found;
}

IsletError islet_joint_set_motor(IsletWorld* world, IsletJointId joint, const IsletJointMotor* motor) {
    if (begin(world) && is_there(world, motor)) of(world).set_motor(in<JointId>(joint), *cast<const JointMotor>(motor));
    return end(world);
}

float islet_joint_friction(const IsletWorld* world, IsletJointId joint) {
    float found = {};
    if (world != nullptr) found = of(world).joint_friction(in<JointId>(joint));
    return found;
}

IsletError islet_joint_set_friction(IsletWorld* world, IsletJointId joint, float friction) {
    if (begin(world)) of(world).set_joint_friction(in<JointId>(joint), friction);
    return end(world);
}

float islet_joint_motor_force(const IsletWorld* world, IsletJointId joint) {
    float found = {};
    if (world != nullptr) found = of(world).motor_force(in<JointId>(joint));
    return found;
}

IsletJointRatchet islet_joint_ratchet(const IsletWorld* world, IsletJointId joint) {
    IsletJointRatchet found = {};
    if (world != nullptr) new (&found) JointRatchet(of(world).ratchet(in<JointId>(joint)));
    return found;
}

IsletError islet_joint_set_ratchet(IsletWorld* world, IsletJointId joint, const IsletJointRatchet* ratchet) {
    if (begin(world) && is_there(world, ratchet)) of(world).set_ratchet(in<JointId>(joint), *cast<const JointRatchet>(ratchet));
    return end(world);
}

float islet_joint_length(const IsletWorld* world, IsletJointId joint) {
    float found = {};
    if (world != nullptr) found = of(world).joint_length(in<JointId>(joint));
    return found;
}

IsletError islet_joint_set_length(IsletWorld* world, IsletJointId joint, float length) {
    if (begin(world)) of(world).set_joint_length(in<JointId>(joint), length);
    return end(world);
}

IsletJointSoftness islet_joint_softness(const IsletWorld* world, IsletJointId joint) {
    JointSoftness found = {};
    if (world != nullptr) found = of(world).softness(in<JointId>(joint));
    return out(found);
}

IsletError islet_joint_set_softness(IsletWorld* world, IsletJointId joint, const IsletJointSoftness* softness) {
    if (begin(world) && is_there(world, softness)) of(world).set_softness(in<JointId>(joint), *cast<const JointSoftness>(softness));
    return end(world);
}

IsletVec2 islet_joint_linear_velocity(const IsletWorld* world, IsletJointId joint) {
    Vec2 found = {};
    if (world != nullptr) found = of(world).joint_linear_velocity(in<JointId>(joint));
    return out(found);
}

float islet_joint_angular_velocity(const IsletWorld* world, IsletJointId joint) {
    float found = {};
    if (world != nullptr) found = of(world).joint_angular_velocity(in<JointId>(joint));
    return found;
}

IsletError islet_joint_set_velocity(IsletWorld* world, IsletJointId joint, IsletVec2 linear, float angular) {
    if (begin(world)) of(world).set_joint_velocity(in<JointId>(joint), in<Vec2>(linear), angular);
    return end(world);
}

float islet_joint_max_force(const IsletWorld* world, IsletJointId joint) {
    float found = {};
    if (world != nullptr) found = of(world).joint_max_force(in<JointId>(joint));
    return found;
}

float islet_joint_max_torque(const IsletWorld* world, IsletJointId joint) {
    float found = {};
    if (world != nullptr) found = of(world).joint_max_torque(in<JointId>(joint));
    return found;
}

IsletError islet_joint_set_strength(IsletWorld* world, IsletJointId joint, float max_force, float max_torque) {
    if (begin(world)) of(world).set_joint_strength(in<JointId>(joint), max_force, max_torque);
    return end(world);
}

IsletVec2 islet_joint_target(const IsletWorld* world, IsletJointId joint) {
    Vec2 found = {};
    if (world != nullptr) found = of(world).target(in<JointId>(joint));
    return out(found);
}

IsletError islet_joint_set_target(IsletWorld* world, IsletJointId joint, IsletVec2 target) {
    if (begin(world)) of(world).set_target(in<JointId>(joint), in<Vec2>(target));
    return end(world);
}

IsletVec2 islet_joint_ground_a(const IsletWorld* world, IsletJointId joint) {
    Vec2 found = {};
    if (world != nullptr) found = of(world).ground_a(in<JointId>(joint));
    return out(found);
}

IsletVec2 islet_joint_ground_b(const IsletWorld* world, IsletJointId joint) {
    Vec2 found = {};
    if (world != nullptr) found = of(world).ground_b(in<JointId>(joint));
    return out(found);
}

IsletError islet_joint_set_grounds(IsletWorld* world, IsletJointId joint, IsletVec2 ground_a, IsletVec2 ground_b) {
    if (begin(world)) of(world).set_grounds(in<JointId>(joint), in<Vec2>(ground_a), in<Vec2>(ground_b));
    return end(world);
}

float islet_joint_ratio(const IsletWorld* world, IsletJointId joint) {
    float found = {};
    if (world != nullptr) found = of(world).joint_ratio(in<JointId>(joint));
    return found;
}

IsletError islet_joint_set_ratio(IsletWorld* world, IsletJointId joint, float ratio) {
    if (begin(world)) of(world).set_joint_ratio(in<JointId>(joint), ratio);
    return end(world);
}

IsletJointId islet_gear_joint1(const IsletWorld* world, IsletJointId gear) {
    IsletJointId found = {};
    if (world != nullptr) new (&found) JointId(of(world).joint1(in<JointId>(gear)));
    return found;
}

IsletJointId islet_gear_joint2(const IsletWorld* world, IsletJointId gear) {
    IsletJointId found = {};
    if (world != nullptr) new (&found) JointId(of(world).joint2(in<JointId>(gear)));
    return found;
}

IsletVec2 islet_joint_force(const IsletWorld* world, IsletJointId joint) {
    Vec2 found = {};
    if (world != nullptr) found = of(world).joint_force(in<JointId>(joint));
    return out(found);
}

float islet_joint_torque(const IsletWorld* world, IsletJointId joint) {
    float found = {};
    if (world != nullptr) found = of(world).joint_torque(in<JointId>(joint));
    return found;
}

IsletJointError islet_joint_error(const IsletWorld* world, IsletJointId joint) {
    IsletJointError found = {};
    if (world != nullptr) new (&found) JointError(of(world).joint_error(in<JointId>(joint)));
    return found;
}

}  // extern "C"
