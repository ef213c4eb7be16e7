// The end of a step: poses, fat boxes, sleep and events.
#pragma once

#include "../constraint/contact_rows.hpp"
#include "../island/batches.hpp"

namespace islet::detail {

/// `bodies` are the solver's, by slot. Their dp and dq say how far each body has moved and turned, and become the way to where it was stopped.
void finish_bodies(Core& core, const Plan& plan, SolverBody* bodies, Arena& arena, float dt);

}  // namespace islet::detail
