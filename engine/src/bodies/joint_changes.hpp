// Taking joints out of the world, breaking them, and what follows for joints when a body changes.
#pragma once

#include "../data/core.hpp"

namespace islet::detail {

/// Destroys the joint and the gears that use it, and wakes the bodies. Their shapes may meet again from the next step on.
void remove_joint(Core& core, std::uint32_t joint);

/// The body of a joint that a gear on it hangs on: a dynamic one if there is one, else a kinematic one; of equals B.
std::uint32_t moving_body(const Core& core, const Joint& j);

// What a step and a body's own functions need of joints is referenced weakly: a program that makes no joints does not link it (see
// solver/joint_solve.hpp). None of these may be called in a world, or for a body, without joints.

/// Does nothing, but whoever refers to it links the functions below.
void link_joint_changes();

/// Destroys all joints of a body.
ISLET_OPTIONAL void remove_joints(Core& core, std::uint32_t body);

/// Where gears hang depends on the bodies' types: hangs those on a body's joints anew after a change of type, and wakes what they then join.
ISLET_OPTIONAL void hang_gears(Core& core, std::uint32_t body);

/// Colours depend on the bodies' types: these take those of a body's joints away, and give new ones, around a change of type.
ISLET_OPTIONAL void release_joint_colors(Core& core, std::uint32_t body);
ISLET_OPTIONAL void assign_joint_colors(Core& core, std::uint32_t body);

/// Destroys the joints whose force or torque exceeded what they bear, and reports them.
ISLET_OPTIONAL void break_joints(Core& core);

}  // namespace islet::detail
