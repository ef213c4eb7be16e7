// Finding pairs: every two shapes whose fat boxes began to overlap get a contact.
#pragma once

#include "memory/core.hpp"

namespace islet::detail {

/// Creates contacts for the shapes whose fat boxes changed since the last call. The cost follows what moved; nothing moved costs nothing.
/// Pairs that find no room are counted in report.dropped_contacts and tried again in every later call.
void find_pairs(Core& core);

/// Marks a shape's fat box as changed.
void mark_moved(Core& core, std::uint32_t shape);

}  // namespace islet::detail
