// A gripper on a gantry: a trolley runs along a rail, a palm hangs from it on a lift, and two fingers close on what is between them.
//
//   GripperDef def = {.rail = {0, 5}};
//   BodyId parts[5];
//   JointId axes[5];
//   Spawned gripper = spawn(world, def, parts, axes);
//   command(world, gripper, def, {.lift = -0.5f});               // down, m/s
//   command(world, gripper, def, {.lift = 0.5f, .close = true}); // hold on, and up
//
// The fingers press with `grip` newtons each, whatever is between them: they hold by friction what weighs less than 2 * friction * grip, if the
// lift is gentle.
#pragma once

#include <array>

#include "prefab.hpp"

namespace islet::samples {

/// The order of a gripper's bodies.
enum class GripperPart : std::size_t { rail, trolley, palm, left_finger, right_finger };
/// The order of its joints: sliders, positive to the right, upwards, and as the finger closes. A gear between the fingers comes
/// last.
enum class GripperAxis : std::size_t { travel, lift, left_finger, right_finger };

struct GripperDef {
    Vec2 rail = {};              ///< m, of the rail's middle, where the trolley starts
    float rail_length = 6;       ///< m
    float reach = 3;             ///< m, how far the lift goes down from where it starts, close under the trolley
    float opening = 1;           ///< m, between the open fingers
    float finger_length = 0.7f;  ///< m
    float grip = 100;            ///< N, of each finger
    float friction = 1;          ///< of the fingers
    float drive_force = 2000;    ///< N, the most that travel and lift give
};

struct GripperCommand {
    float travel = 0;    ///< m/s, to the right
    float lift = 0;      ///< m/s, upwards
    bool close = false;  ///< false: the fingers open
};

void assemble(const GripperDef& def, Assembler& into);
/// What the four motors are set to, by GripperAxis.
std::array<JointMotor, 4> gripper_motors(const GripperDef& def, const GripperCommand& command);
/// Holds until the next command.
void command(World& world, const Spawned& gripper, const GripperDef& def, const GripperCommand& command);

}  // namespace islet::samples
