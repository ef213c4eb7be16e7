// What acts on the angle of a hinge in a joint tree: dry friction, a motor and limits, all at once.
//
// Friction, a motor and limits make an impulse that never grows with the angle's speed w:
//
//     impulse |
//             +  lower limit
//             |
//             +------+  motor or friction: a step at its speed
//                    |
//                    +---------+
//                              |  upper limit
//     ---------------------------------- w
//
// Where the graph is upright, the speed is known and the impulse lies within a range: the angle is *held*. Where it is level, the impulse is known. A tree
// that is solved with the right angles held has found the graph of each (an active set). Friction and motors are Coulomb's; limits are speculative, as in
// coordinate.hpp, but lose none of their impulse.
#pragma once

#include "../constraint/coordinate.hpp"
#include "../math/inlining.hpp"

namespace islet::detail {

struct AngleLaw {
    float lowest, highest;            // rad/s, between the limits
    float speed;                      // rad/s, of the motor
    float most_motor, most_friction;  // N m s

    static float sign(float x, float at_zero) { return x > 0 ? 1.0f : x < 0 ? -1.0f : at_zero; }

    /// The impulses at the speed w; `side`: 1, -1 the largest, the least where there is a step.
    float motor(float w, float side) const { return most_motor * sign(speed - w, side); }
    float friction(float w, float side) const { return most_friction * sign(-w, side); }
    float drive(float w, float side) const { return motor(w, side) + friction(w, side); }
};

inline constexpr float no_impulse_bound = 1.0e18f;  // N m s

// rad/s, at most, at which a limit brings back an angle beyond it. Exact limits let none beyond: it has been set there, or sweeps have left it there, and where
// many hinges in a row mend at once, what hangs on them would be thrown (a row of 12 planks that jut out, 30 times as heavy at its end: by 60 times m g L).
inline constexpr float fastest_return = 0.25f;

inline AngleLaw angle_law(const Joint& j, float angle, const JointSweep& n) {
    AngleLaw law = {-no_bound, no_bound, 0, 0, min(n.h * j.friction, no_impulse_bound)};
    if ((j.flags & joint_limit) != 0) {
        const auto bound = [&](float ahead) { return ahead > 0 ? ahead * n.inv_h : max(ahead * n.soft.rate, -fastest_return); };
        law.lowest = -bound(angle - within_bound(j.lower));
        law.highest = max(bound(within_bound(j.upper) - angle), law.lowest);
    }
    if ((j.flags & joint_motor) != 0) {
        law.speed = within_bound(j.motor_speed);
        law.most_motor = min(n.h * j.motor_max, no_impulse_bound);
    }
    return law;
}

/// An upright part of the graph.
struct HeldAngle {
    float speed = 0;            // rad/s
    float least = 0, most = 0;  // N m s
};

/// Finds the upright part where the angle is, by its impulse so far. If that is an end of a part, then the speed w decides whether it leads into the part, or,
/// where w is not known, it does not. Returns false on a level part.
inline bool find_held(HeldAngle& held, const AngleLaw& law, bool limited, float impulse, float w, bool known) {
    const auto look_at = [&](float speed, float least, float most) {
        const bool down = impulse > least || (known && w < speed), up = impulse < most || (known && w > speed);
        if (!(least < most && impulse >= least && impulse <= most && down && up)) return false;
        held = {speed, least, most};
        return true;
    };
    for (const float speed : {law.speed, 0.0f})
        if (speed > law.lowest && speed < law.highest && look_at(speed, law.drive(speed, -1), law.drive(speed, 1))) return true;
    return limited && (look_at(law.lowest, law.drive(law.lowest, -1), no_impulse_bound) || look_at(law.highest, -no_impulse_bound, law.drive(law.highest, 1)));
}

/// Writes the angle's impulse back, each part to what makes it, at the speed w.
inline void store_angle(Joint& j, const AngleLaw& law, float w, const JointOutput& out) {
    float rest = j.torque_impulse;
    j.motor_impulse = clamp(rest, law.motor(w, -1), law.motor(w, 1)) + 0.0f;
    rest -= j.motor_impulse;
    j.friction_impulse = clamp(rest, law.friction(w, -1), law.friction(w, 1)) + 0.0f;
    rest -= j.friction_impulse;
    if ((j.flags & joint_limit) == 0) return;
    j.lower_impulse = max(rest, 0.0f);
    j.upper_impulse = max(-rest, 0.0f);
    keep_load(rest, j, out);
}

}  // namespace islet::detail
