// Functions of islet.h: faults.
//
// Made by bindings/c/generate.py; do not edit.
#include "glue.hpp"

using namespace islet;
using namespace islet::c;

extern "C" {

IsletFieldFault islet_find_solver_def_fault(const IsletSolverDef* def) {
    Room<SolverDef> def_room;
    const SolverDef* def_taken = nullptr;
    IsletFieldFault found = {why(def), nullptr};
    if ((def_taken = take<SolverDef>(nullptr, def, def_room)) != nullptr) new (&found) FieldFault(islet::find_fault(*def_taken));
    return found;
}

IsletFieldFault islet_find_body_def_fault(const IsletBodyDef* def) {
    Room<BodyDef> def_room;
    const BodyDef* def_taken = nullptr;
    IsletFieldFault found = {why(def), nullptr};
    if ((def_taken = take<BodyDef>(nullptr, def, def_room)) != nullptr) new (&found) FieldFault(islet::find_fault(*def_taken));
    return found;
}

IsletFieldFault islet_find_shape_def_fault(const IsletShapeDef* def) {
    Room<ShapeDef> def_room;
    const ShapeDef* def_taken = nullptr;
    IsletFieldFault found = {why(def), nullptr};
    if ((def_taken = take<ShapeDef>(nullptr, def, def_room)) != nullptr) new (&found) FieldFault(islet::find_fault(*def_taken));
    return found;
}

IsletFieldFault islet_find_explosion_def_fault(const IsletExplosionDef* def) {
    Room<ExplosionDef> def_room;
    const ExplosionDef* def_taken = nullptr;
    IsletFieldFault found = {why(def), nullptr};
    if ((def_taken = take<ExplosionDef>(nullptr, def, def_room)) != nullptr) new (&found) FieldFault(islet::find_fault(*def_taken));
    return found;
}

IsletFieldFault islet_find_wind_def_fault(const IsletWindDef* def) {
    Room<WindDef> def_room;
    const WindDef* def_taken = nullptr;
    IsletFieldFault found = {why(def), nullptr};
    if ((def_taken = take<WindDef>(nullptr, def, def_room)) != nullptr) new (&found) FieldFault(islet::find_fault(*def_taken));
    return found;
}

IsletFieldFault islet_find_revolute_joint_def_fault(const IsletRevoluteJointDef* def) {
    Room<RevoluteJointDef> def_room;
    const RevoluteJointDef* def_taken = nullptr;
    IsletFieldFault found = {why(def), nullptr};
    if ((def_taken = take<RevoluteJointDef>(nullptr, def, def_room)) != nullptr) new (&found) FieldFault(islet::find_fault(*def_taken));
    return found;
}

IsletFieldFault islet_find_prismatic_joint_def_fault(const IsletPrismaticJointDef* def) {
    Room<PrismaticJointDef> def_room;
    const PrismaticJointDef* def_taken = nullptr;
    IsletFieldFault found = {why(def), nullptr};
    if ((def_taken = take<PrismaticJointDef>(nullptr, def, def_room)) != nullptr) new (&found) FieldFault(islet::find_fault(*def_taken));
    return found;
}

IsletFieldFault islet_find_distance_joint_def_fault(const IsletDistanceJointDef* def) {
    Room<DistanceJointDef> def_room;
    const DistanceJointDef* def_taken = nullptr;
    IsletFieldFault found = {why(def), nullptr};
    if ((def_taken = take<DistanceJointDef>(nullptr, def, def_room)) != nullptr) new (&found) FieldFault(islet::find_fault(*def_taken));
    return found;
}

IsletFieldFault islet_find_weld_joint_def_fault(const IsletWeldJointDef* def) {
    Room<WeldJointDef> def_room;
    const WeldJointDef* def_taken = nullptr;
    IsletFieldFault found = {why(def), nullptr};
    if ((def_taken = take<WeldJointDef>(nullptr, def, def_room)) != nullptr) new (&found) FieldFault(islet::find_fault(*def_taken));
    return found;
}

IsletFieldFault islet_find_wheel_joint_def_fault(const IsletWheelJointDef* def) {
    Room<WheelJointDef> def_room;
    const WheelJointDef* def_taken = nullptr;
    IsletFieldFault found = {why(def), nullptr};
    if ((def_taken = take<WheelJointDef>(nullptr, def, def_room)) != nullptr) new (&found) FieldFault(islet::find_fault(*def_taken));
    return found;
}

IsletFieldFault islet_find_motor_joint_def_fault(const IsletMotorJointDef* def) {
    Room<MotorJointDef> def_room;
    const MotorJointDef* def_taken = nullptr;
    IsletFieldFault found = {why(def), nullptr};
    if ((def_taken = take<MotorJointDef>(nullptr, def, def_room)) != nullptr) new (&found) FieldFault(islet::find_fault(*def_taken));
    return found;
}

IsletFieldFault islet_find_mouse_joint_def_fault(const IsletMouseJointDef* def) {
    Room<MouseJointDef> def_room;
    const MouseJointDef* def_taken = nullptr;
    IsletFieldFault found = {why(def), nullptr};
    if ((def_taken = take<MouseJointDef>(nullptr, def, def_room)) != nullptr) new (&found) FieldFault(islet::find_fault(*def_taken));
    return found;
}

IsletFieldFault islet_find_pulley_joint_def_fault(const IsletPulleyJointDef* def) {
    Room<PulleyJointDef> def_room;
    const PulleyJointDef* def_taken = nullptr;
    IsletFieldFault found = {why(def), nullptr};
    if ((def_taken = take<PulleyJointDef>(nullptr, def, def_room)) != nullptr) new (&found) FieldFault(islet::find_fault(*def_taken));
    return found;
}

IsletFieldFault islet_find_gear_joint_def_fault(const IsletGearJointDef* def) {
    Room<GearJointDef> def_room;
    const GearJointDef* def_taken = nullptr;
    IsletFieldFault found = {why(def), nullptr};
    if ((def_taken = take<GearJointDef>(nullptr, def, def_room)) != nullptr) new (&found) FieldFault(islet::find_fault(*def_taken));
    return found;
}

IsletFieldFault islet_find_angle_joint_def_fault(const IsletAngleJointDef* def) {
    Room<AngleJointDef> def_room;
    const AngleJointDef* def_taken = nullptr;
    IsletFieldFault found = {why(def), nullptr};
    if ((def_taken = take<AngleJointDef>(nullptr, def, def_room)) != nullptr) new (&found) FieldFault(islet::find_fault(*def_taken));
    return found;
}

IsletFieldFault islet_find_capacity_fault(const IsletCapacity* capacity) {
    Room<Capacity> capacity_room;
    const Capacity* capacity_taken = nullptr;
    IsletFieldFault found = {why(capacity), nullptr};
    if ((capacity_taken = take<Capacity>(nullptr, capacity, capacity_room)) != nullptr)
        new (&found) FieldFault(islet::find_fault(*capacity_taken));
    return found;
}

IsletFieldFault islet_find_mass_data_fault(const IsletMassData* mass) {
    IsletFieldFault found = {why(mass), nullptr};
    if (is_there(nullptr, mass)) new (&found) FieldFault(islet::find_fault(*cast<const MassData>(mass)));
    return found;
}

IsletFieldFault islet_find_surface_material_fault(const IsletSurfaceMaterial* material) {
    IsletFieldFault found = {why(material), nullptr};
    if (is_there(nullptr, material)) new (&found) FieldFault(islet::find_fault(*cast<const SurfaceMaterial>(material)));
    return found;
}

IsletFieldFault islet_find_joint_frame_fault(const IsletJointFrame* frame) {
    IsletFieldFault found = {why(frame), nullptr};
    if (is_there(nullptr, frame)) new (&found) FieldFault(islet::find_fault(*cast<const JointFrame>(frame)));
    return found;
}

IsletFieldFault islet_find_joint_spring_fault(const IsletJointSpring* spring) {
    IsletFieldFault found = {why(spring), nullptr};
    if (is_there(nullptr, spring)) new (&found) FieldFault(islet::find_fault(*cast<const JointSpring>(spring)));
    return found;
}

IsletFieldFault islet_find_joint_softness_fault(const IsletJointSoftness* softness) {
    IsletFieldFault found = {why(softness), nullptr};
    if (is_there(nullptr, softness)) new (&found) FieldFault(islet::find_fault(*cast<const JointSoftness>(softness)));
    return found;
}

IsletFieldFault islet_find_joint_limit_fault(const IsletJointLimit* limit) {
    IsletFieldFault found = {why(limit), nullptr};
    if (is_there(nullptr, limit)) new (&found) FieldFault(islet::find_fault(*cast<const JointLimit>(limit)));
    return found;
}

IsletFieldFault islet_find_joint_motor_fault(const IsletJointMotor* motor) {
    IsletFieldFault found = {why(motor), nullptr};
    if (is_there(nullptr, motor)) new (&found) FieldFault(islet::find_fault(*cast<const JointMotor>(motor)));
    return found;
}

IsletFieldFault islet_find_joint_ratchet_fault(const IsletJointRatchet* ratchet) {
    IsletFieldFault found = {why(ratchet), nullptr};
    if (is_there(nullptr, ratchet)) new (&found) FieldFault(islet::find_fault(*cast<const JointRatchet>(ratchet)));
    return found;
}

IsletFieldFault islet_find_mover_def_fault(const IsletMoverDef* def) {
    Room<MoverDef> def_room;
    const MoverDef* def_taken = nullptr;
    IsletFieldFault found = {why(def), nullptr};
    if ((def_taken = take<MoverDef>(nullptr, def, def_room)) != nullptr) new (&found) FieldFault(islet::find_fault(*def_taken));
    return found;
}

}  // extern "C"
