// The name of the field that makes a definition invalid, so that an editor or a binding can show it to its user. A program that does not call find_fault does
// not link it.
//
//   BodyId body = world.create_body(def);
//   if (!body) {
//       FieldFault fault = find_fault(def);
//       if (fault.field != nullptr) printf("%s: %s\n", fault.field, describe(fault.error));  // "linear_damping: A number is outside its range: ..."
//   }
#pragma once

#include "islet/config.hpp"
#include "islet/joints.hpp"
#include "islet/types.hpp"

ISLET_API_BEGIN
namespace islet {

struct MoverDef;  // mover.hpp

/// A field that breaks its rules.
struct FieldFault {
    Error error = Error::none;    ///< not_finite, out_of_range, feature_cut, bad_capacity or bad_geometry; none if all fields keep their rules
    const char* field = nullptr;  ///< its name, after those of the structs that hold it: "limit.lower", "solver.substeps"; null if there is none
};

/// The first field, in the order of the struct, that makes World::create, World::create_body, World::create_joint and so on refuse the definition. No world is
/// needed, so ids, geometries, points that are too close together and a lack of room are not checked. If several fields are invalid, the call that refuses the
/// definition may report the error of another one.
FieldFault find_fault(const WorldDef& def);
FieldFault find_fault(const SolverDef& def);
FieldFault find_fault(const BodyDef& def);
FieldFault find_fault(const ShapeDef& def);
FieldFault find_fault(const ExplosionDef& def);
FieldFault find_fault(const WindDef& def);
FieldFault find_fault(const RevoluteJointDef& def);
FieldFault find_fault(const PrismaticJointDef& def);
FieldFault find_fault(const DistanceJointDef& def);
FieldFault find_fault(const WeldJointDef& def);
FieldFault find_fault(const WheelJointDef& def);
FieldFault find_fault(const MotorJointDef& def);
FieldFault find_fault(const MouseJointDef& def);
FieldFault find_fault(const PulleyJointDef& def);
FieldFault find_fault(const GearJointDef& def);
FieldFault find_fault(const AngleJointDef& def);

/// The same for what World::create, the setters of bodies, shapes and joints, and step_mover refuse. Rules that only some joints have are not checked: the
/// limit of a distance joint begins at 0 or above, and a mouse joint has a linear frequency above 0 and no angular one.
FieldFault find_fault(const Capacity& capacity);
FieldFault find_fault(const MassData& mass);
FieldFault find_fault(const SurfaceMaterial& material);
FieldFault find_fault(const JointFrame& frame);
FieldFault find_fault(const JointSpring& spring);
FieldFault find_fault(const JointSoftness& softness);
FieldFault find_fault(const JointLimit& limit);
FieldFault find_fault(const JointMotor& motor);
FieldFault find_fault(const JointRatchet& ratchet);
FieldFault find_fault(const MoverDef& def);

}  // namespace islet
ISLET_API_END
