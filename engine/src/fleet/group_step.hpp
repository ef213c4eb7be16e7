// One step of several worlds of a fleet, whose contacts are solved side by side.
#pragma once

#include "../data/core.hpp"
#include "../solver/group_solve.hpp"

namespace islet::detail {

/// Most rows of contacts that a group has, padding included: they and their bodies fit the core's own cache.
inline constexpr std::uint32_t group_rows = 1024;

/// Steps worlds of a fleet, in ascending order, at most group_worlds of them. `arena` has the scratch of as many worlds, and each world is left with a part of
/// it. The thread has a DefaultFloatMode.
void step_group(World* const* worlds, std::uint32_t count, Arena arena, float dt);

}  // namespace islet::detail
