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

/// Each takes a part over; what is not sound is found by check_numbers (world/joint_make.cpp).
void set_spring_of(Joint& j, const JointSpring& spring);
void set_limit_of(Joint& j, const JointLimit& limit);
void set_motor_of(Joint& j, const JointMotor& motor);

inline void fill_coordinate(Joint& j, const JointSpring& spring, const JointLimit& limit, const JointMotor& motor) {
    set_spring_of(j, spring);
    set_limit_of(j, limit);
    set_motor_of(j, motor);
}

template <class Def>
void fill_softness(Joint& j, const Def& def) {
    j.linear_hertz = def.linear_hertz;
    j.linear_damping_ratio = def.linear_damping_ratio;
    j.angular_hertz = def.angular_hertz;
    j.angular_damping_ratio = def.angular_damping_ratio;
}

}  // namespace islet::detail
