// The solve: batches side by side, the substeps of each one after another.
#pragma once

#include "../constraint/contact_rows.hpp"
#include "../island/batches.hpp"

namespace islet::detail {

/// Room for the motions of the solve: where the arrays lie that a step writes at its end, and on into scratch. Call it before anything else is taken.
SolverMotion* take_motions(Core& core, Arena& arena);

/// Solves the contacts and joints of all awake bodies over dt, and moves the bodies. Writes back impulses, velocities, centres and rotations, and clears
/// forces. Returns the bodies by slot, in scratch: dp and dq are how far each has moved and turned.
SolverBody* solve(Core& core, const Plan& plan, SolverMotion* motions, Arena& arena, float dt);

}  // namespace islet::detail
