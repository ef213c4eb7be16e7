// The doll of Box2D's benchmark scene "rain", for scenes that are compared with it: eleven capsules, hinged with limits, a little friction and weak springs.
// It is no person: 1.28 m from its soles to its crown, and 0.39 kg. For games there is prefabs/ragdoll.hpp.
#pragma once

#include "prefab_scene.hpp"

namespace islet::samples {

/// The order of its bodies. Joint i - 1 hangs body i on its parent: the hip has none.
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

struct BenchmarkDollDef {
    Vec2 position = {};             ///< m, 0.27 m below its soles
    float scale = 1;
    float friction_torque = 0.05f;  ///< N m, in the stiffest joint
    float hertz = 5;                ///< Hz, of the springs; 0: none
    float damping_ratio = 0.5f;
    int group = 1;  ///< > 0: bones of ragdolls of the same group do not collide with each other
};

/// It collides with shapes of categories 1 and 2 and is of category 2; its feet meet category 1 only.
Prefab make_benchmark_doll(const BenchmarkDollDef& def);

}  // namespace islet::samples
