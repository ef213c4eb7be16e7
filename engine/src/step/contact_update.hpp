// The narrow phase over all awake contacts: manifolds, begin and end touch.
#pragma once

#include "../data/core.hpp"

namespace islet::detail {

void update_contacts(Core& core, float dt);

/// After the solve: reports the touches and overlaps that have begun, of contacts made ahead those whose shapes have met.
void tell_touches(Core& core);

}  // namespace islet::detail
