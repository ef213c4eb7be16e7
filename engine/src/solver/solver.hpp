// The solve: batches side by side, the substeps of each one after another.
#pragma once

#include "../constraint/contact_rows.hpp"
#include "../island/batches.hpp"

namespace islet::detail {

/// Solves the contacts of all awake bodies over dt and moves the bodies. Writes impulses, velocities, centres and rotations back, and clears forces.
/// Returns the bodies by slot, in scratch: dp and dq are the way each made.
SolverBody* solve(Core& core, const Plan& plan, Arena& arena, float dt);

}  // namespace islet::detail
