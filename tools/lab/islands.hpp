// The islands of a running world as problems in double precision.
#pragma once

#include <vector>

#include <islet/island.hpp>
#include <islet/world.hpp>

#include "problem.hpp"

namespace islet::lab {

/// The problem that the rows and bodies of an export pose, computed anew in double: M and q as rounded to float would have a solution of their own, or, where
/// contacts say the same twice, none. A block for each contact and joint.
Problem problem_of(const IslandProblem& exported);

/// Every island of the world, asleep or awake, for a substep of h seconds, the one with the most rows first; those without rows are left out. Scene and step are
/// the caller's to fill in.
std::vector<Island> islands_of(const World& world, float h);

}  // namespace islet::lab
