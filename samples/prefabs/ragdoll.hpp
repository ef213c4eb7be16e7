// A person as a ragdoll, seen from the side and facing +x: eleven bodies of capsules, hinged with a person's limits. These two files and the engine are
// all it takes:
//
//   Ragdoll hero = create_ragdoll(world, {.position = {0, 0}});
//   world.apply_linear_impulse_to_center(hero[BodyPart::torso], {60, 0});
//
// It takes 11 bodies, 13 shapes and 10 joints of a world's capacity.
//
// Lengths and masses are shares of a person's: Winter, Biomechanics and Motor Control of Human Movement (4th ed. 2009), tables 4.1 (Dempster's masses) and
// figure 4.1 (the lengths of Drillis and Contini). Limits are the ranges of motion of the American Academy of Orthopaedic Surgeons.
#pragma once

#include <cstddef>

#include <islet/islet.hpp>

namespace islet::samples {

/// A ragdoll's bodies. A hand is part of its forearm, a foot of its shank.
enum class BodyPart : std::size_t {
    pelvis,
    torso,
    head,
    left_thigh,
    left_shank,
    right_thigh,
    right_shank,
    left_upper_arm,
    left_forearm,
    right_upper_arm,
    right_forearm,
};
inline constexpr std::size_t body_part_count = 11;

struct RagdollDef {
    Vec2 position = {};         ///< m, of the ground at its ankles when it stands upright
    float height = 1.6f;        ///< m, from the soles to the crown
    float mass = 60;            ///< kg, of all of it
    float friction = 0.6f;      ///< of the skin
    float joint_torque = 0.1f;  ///< N m for each kilogram of the person, in the stiffest joint: what muscles at rest hold back. 0: none
    float hertz = 0;            ///< Hz, of springs that hold it upright; 0: it is limp
    float damping_ratio = 1;    ///< of the springs
    /// Of all its shapes. A negative group keeps its parts from colliding with each other: give each ragdoll its own.
    Filter filter = {.group = -1};
};

struct Ragdoll {
    BodyId bodies[body_part_count] = {};       ///< by BodyPart
    JointId joints[body_part_count - 1] = {};  ///< joints[i - 1] hangs body i on the one nearer to the pelvis

    BodyId operator[](BodyPart part) const { return bodies[static_cast<std::size_t>(part)]; }
    explicit operator bool() const { return static_cast<bool>(bodies[0]); }
};

/// Makes one that stands upright. If not all of it finds room, or a number is bad, nothing is made, the ids are null, and world.last_error() says why.
Ragdoll create_ragdoll(World& world, const RagdollDef& def);
/// Destroys what is left of it.
void destroy(World& world, const Ragdoll& ragdoll);

}  // namespace islet::samples
