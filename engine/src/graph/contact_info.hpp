#pragma once

#include "../data/core.hpp"

namespace islet::detail {

/// Fills in a touching contact as the user reads it, at the bodies' present poses.
void read_contact(const Core& core, std::uint32_t contact, ContactInfo& out);

}  // namespace islet::detail
