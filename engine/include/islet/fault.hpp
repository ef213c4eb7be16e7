// Which field of a definition breaks its rules, by name: for what tells a user why a call was refused. A program that does not call this does not link it.
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

/// A field that breaks its rules.
struct FieldFault {
    Error error = Error::none;    ///< not_finite, out_of_range or feature_cut; none if all fields keep their rules
    const char* field = nullptr;  ///< its name, with the structs it stands in: "limit.lower", "solver.substeps"; null if there is none
};

/// The first field, in the order of the struct, for whose sake World::create, World::create_body, World::create_joint and so on refuse the definition. This
/// asks no world: ids, geometries, points that lie too close together, and room that is used up are not looked at. Of several faults the call may tell another.
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

}  // namespace islet
ISLET_API_END
