// Mouse joint: pulls a point of B to a target in the world, within a force.
//
//     C    = (xb + rb) - target          m, two rows solved as a block
//     Cdot = vb + wb x rb                m/s,  |lambda| <= h max_force
//     K    = mb I + ib [by^2, -bx by; -bx by, bx^2]
// It is the motor joint (motor_joint.hpp) with a frequency, no torque, and for A the world: `body_a` is null and `local_a` the target.
#pragma once

#include "../constraint/motor_joint.hpp"

namespace islet::detail {

/// Makes j pull the point of B that is at `target` now.
inline void set_mouse(Joint& j, const Pose& b, Vec2 local_center, Vec2 target, float hertz, float damping_ratio, float max_force) {
    j.body_a = null_index;
    j.local_a = target;
    j.local_b = inv_rotate(b.q, target - b.center) + local_center;
    j.linear_hertz = hertz;
    j.linear_damping_ratio = damping_ratio;
    j.motor_max = max_force;
}

}  // namespace islet::detail
