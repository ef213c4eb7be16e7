// Jams: bodies that are pressed where they cannot go, as a limb that a hand drags into the floor.
#pragma once

#include "../data/core.hpp"

namespace islet::detail {

/// m/s^2. A contact or a joint that gives its lighter body more is jammed. (Ragdolls in a heap bear 500. A light body under a hundred times its mass bears it,
/// too, so jams are looked for only where a kinematic body lets go: what else could press so hard?)
inline constexpr float jam_load = 1000;

/// Call it before a kinematic body becomes dynamic or goes: forgets the impulses of all that is jammed at it, and on from there, from one jammed contact or
/// joint to the next. Started from these impulses, the next step would shoot the bodies away: nothing bears them any longer. No effect on other bodies.
void forget_jam(Core& core, std::uint32_t body);

/// The same before a joint goes that holds a body to a kinematic one.
void forget_jam_of_joint(Core& core, std::uint32_t joint);

}  // namespace islet::detail
