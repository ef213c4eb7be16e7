// One maker per scene. Each scene lives in the file that names its family; the catalogue lists them all.
#pragma once

#include "../scene.hpp"

namespace islet::samples {

// basics
Scene make_hello();
Scene make_projectile();
Scene make_bounce();
Scene make_friction_ramp();
Scene make_rolling();
Scene make_newtons_cradle();
Scene make_far_from_origin();

// stacks
Scene make_pyramid();
Scene make_vertical_stack();
Scene make_dominoes();
Scene make_card_house();
Scene make_arch();
Scene make_mass_ratio();
Scene make_confined();
Scene make_cairn();

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
