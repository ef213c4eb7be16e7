// The narrow phase over all awake contacts: manifolds, begin and end touch.
#pragma once

#include "../data/core.hpp"

namespace islet::detail {

void update_contacts(Core& core, float dt);

}  // namespace islet::detail
