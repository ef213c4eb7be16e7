// One maker per scene. Each scene lives in the file that names its family; the catalogue lists them all.
#pragma once

#include "harness/scene.hpp"

namespace islet::samples {

// basics
Scene make_hello();
Scene make_projectile();
Scene make_bounce();
Scene make_friction_ramp();
Scene make_endless_slope();
Scene make_rolling();
Scene make_newtons_cradle();
Scene make_pendulum();
Scene make_double_pendulum();
Scene make_far_from_origin();

// stacks
Scene make_pyramid();
Scene make_vertical_stack();
Scene make_dominoes();
Scene make_card_house();
/// So many storeys, its cards leaning so far from upright (rad).
Scene make_card_house_of(int storeys, float lean);
Scene make_arch();
Scene make_mass_ratio();
Scene make_confined();
Scene make_cairn();

// joints
Scene make_rope();
Scene make_chain_ball();
Scene make_bridge();
Scene make_breakable_bridge();
Scene make_door();
Scene make_seesaw();
Scene make_elevator();
Scene make_pulley();
Scene make_gears();
Scene make_scissor_lift();
Scene make_car();
Scene make_ragdoll();
Scene make_ragdoll_pile();
Scene make_mouse_drag();
// soft
Scene make_cloth_scene();
Scene make_flag();
Scene make_blob();
Scene make_soft_stack();
Scene make_cable_bridge();

// robots
Scene make_gripper_scene();
Scene make_walker();
Scene make_arm();
Scene make_ratchet();
Scene make_quadruped();

// granular
Scene make_hourglass();
Scene make_silo();
Scene make_avalanche();
Scene make_mixer();

// play
Scene make_sensors();
Scene make_explosion();
Scene make_wind();
Scene make_conveyor();
Scene make_platformer();
Scene make_bullets();
Scene make_pinball();
Scene make_merge();

// benchmark
Scene make_large_pyramid();
Scene make_many_pyramids();
Scene make_washer();
Scene make_smash();
Scene make_compounds();
Scene make_junkyard();
Scene make_joint_grid();
Scene make_tumbler();
Scene make_spinner();
Scene make_rain();

}  // namespace islet::samples
