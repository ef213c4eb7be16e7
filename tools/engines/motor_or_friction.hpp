// Engines without friction in joints: a motor that holds still stands for it.
#pragma once

#include <islet/joints.hpp>

namespace islet::engines {

/// The motor if there is one, else a motor that holds still with the force of the friction.
inline JointMotor motor_or_friction(const JointMotor& motor, float friction) {
    if (motor.enable) return motor;
    return {friction > 0, 0, friction};
}

}  // namespace islet::engines
