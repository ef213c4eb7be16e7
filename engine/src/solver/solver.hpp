// The solve: batches side by side, the substeps of each one after another.
#pragma once

#include "../constraint/contact_rows.hpp"
#include "../island/batches.hpp"

namespace islet::detail {

/// Solves the contacts and joints of all awake bodies over dt, and moves the bodies. Writes back impulses, velocities, centres and rotations, and clears
/// forces. Returns the bodies by slot, which are taken from the end of `arena`: dp and dq are how far each has moved and turned.
SolverBody* solve(Core& core, const Plan& plan, Arena& arena, float dt);

}  // namespace islet::detail
