// The parts of joints' definitions: what each must keep, and taking it over into the record.
#pragma once

#include "../data/core.hpp"

namespace islet::detail {

/// Each is true if the part is sound; else the error is recorded.
bool check_not_negative(const Core& core, float a);
bool check_frame(const Core& core, const JointFrame& frame);
bool check_spring(const Core& core, const JointSpring& spring);
bool check_limit(const Core& core, const JointLimit& limit);
bool check_motor(const Core& core, const JointMotor& motor);

/// Each takes a sound part over.
void set_spring_of(Joint& j, const JointSpring& spring);
void set_limit_of(Joint& j, const JointLimit& limit);
void set_motor_of(Joint& j, const JointMotor& motor);

/// Destroys the contacts that the joint forbids.
void end_forbidden_contacts(Core& core, const Joint& j);

/// The coordinate of a joint that has one, now.
float joint_coordinate(const Core& core, const Joint& j);

}  // namespace islet::detail
