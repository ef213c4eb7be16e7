// Jams: bodies that are pressed where they cannot go, as a limb that a hand drags into the floor.
#pragma once

#include "../data/core.hpp"

namespace islet::detail {

/// m/s^2. A contact or a joint that gives its lighter body more is jammed. (Ragdolls in a heap bear 500; ropes under hundreds of times their links' mass come
/// to it, but do without a warm start for a step.)
inline constexpr float jam_load = 1000;

/// Forgets the impulses of all that is jammed at a body which is about to be let go, or to hold no more, and on from there, from one jammed contact or joint
/// to the next. Started from these impulses, the next step would shoot the bodies away: nothing bears them any longer.
void forget_jam(Core& core, std::uint32_t body, Arena arena);

}  // namespace islet::detail
