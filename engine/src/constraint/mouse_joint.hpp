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

template <>
struct JointKind<JointType::mouse> : DriveJoint {
    static constexpr bool has_frames = false, has_base = false;

    static const char* fault(const Joint& j) { return j.linear_hertz > 0 ? nullptr : "a mouse joint has no spring"; }

    template <class Rows>
    static void add_rows(Rows& rows) {
        add_point_rows(rows);
    }
    /// A crosshair at the target, and dashes to the point it pulls.
    template <class Pen>
    static void draw(const Pen& pen, const Joint&) {
        pen.bar(pen.at.a, {pen.size, 0});
        pen.bar(pen.at.a, {0, pen.size});
        pen.circle(pen.at.a, 0.5f * pen.size, {1, 0});
        pen.dashes(pen.at.a, pen.at.b);
    }
};

}  // namespace islet::detail
