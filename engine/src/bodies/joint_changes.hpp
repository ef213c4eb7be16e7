// Destroying and breaking joints, and updating them when a body changes.
#pragma once

#include "../data/core.hpp"

namespace islet::detail {

/// Destroys the joint and the gears that use it, and wakes the bodies. Their shapes may meet again from the next step on.
void remove_joint(Core& core, std::uint32_t joint);

/// The body of a joint on which a gear that uses the joint hangs: a dynamic one, if there is one, else a kinematic one. Of two of one type it is B.
std::uint32_t moving_body(const Core& core, const Joint& j);

/// Destroys the contacts that the joint forbids.
void end_forbidden_contacts(Core& core, const Joint& j);

// The functions below are referenced weakly: a program that makes no joints does not link them (solver/joint_solve.hpp). They may be called only for worlds, or
// bodies, with joints.

/// Does nothing. A program that refers to it links the functions below.
void link_joint_changes();

/// Destroys all joints of a body.
ISLET_OPTIONAL void remove_joints(Core& core, std::uint32_t body);

/// Updates, after a change of a body's type, on which bodies the gears that use its joints hang, and wakes those bodies.
ISLET_OPTIONAL void hang_gears(Core& core, std::uint32_t body);

/// Take away the colours of a body's joints before a change of its type, and assign new ones after it: colours depend on the types.
ISLET_OPTIONAL void release_joint_colors(Core& core, std::uint32_t body);
ISLET_OPTIONAL void assign_joint_colors(Core& core, std::uint32_t body);

/// True if the joint bore more in the step than it can.
ISLET_OPTIONAL bool breaks(const Core& core, const Joint& j);

/// After a step: notes which hinges bear a heavy load, and destroys the joints whose force or torque exceeded their strength, and reports them. `arena` has
/// room for a bit a joint.
ISLET_OPTIONAL void finish_joints(Core& core, Arena arena);

}  // namespace islet::detail
