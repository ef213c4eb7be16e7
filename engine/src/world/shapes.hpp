#pragma once

#include "memory/core.hpp"

namespace islet::detail {

/// Takes a shape off its body and frees it, contacts first. The body's mass is left to the caller.
void remove_shape(Core& core, std::uint32_t shape);

}  // namespace islet::detail
