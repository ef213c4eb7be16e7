// One world's state and settings given to another.
#pragma once

#include "../data/core.hpp"

namespace islet::detail {

/// What the host gave the world; the rest is part of its state.
WorldDef host_settings(const Core& core);

/// `to` takes over the state of `from`, which has the same capacity. A recording of `to` ends.
void copy_state(const Core& from, Core& to);

}  // namespace islet::detail
