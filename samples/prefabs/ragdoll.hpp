// A ragdoll of eleven bones: capsules, hinged with limits, a little friction and weak springs that hold its posture.
#pragma once

#include "prefab.hpp"

namespace islet::samples {

/// The order of a ragdoll's bodies. Joint i - 1 hangs body i on its parent: the hip has none.
enum class Bone : std::size_t {
    hip,
    torso,
    head,
    upper_left_leg,
    lower_left_leg,
    upper_right_leg,
    lower_right_leg,
    upper_left_arm,
    lower_left_arm,
    upper_right_arm,
    lower_right_arm,
};
inline constexpr std::size_t bone_count = 11;

struct RagdollDef {
    Vec2 position = {};             ///< m, of the ground between its feet, when it stands
    float scale = 1;                ///< 1: it stands about 1.6 m tall
    float friction_torque = 0.05f;  ///< N m, in the stiffest joint
    float hertz = 5;                ///< Hz, of the springs; 0: none
    float damping_ratio = 0.5f;
    int group = 1;  ///< > 0: bones of ragdolls of the same group do not collide with each other
};

/// It collides with shapes of categories 1 and 2 and is of category 2; its feet meet category 1 only.
Prefab make_ragdoll(const RagdollDef& def);

}  // namespace islet::samples
