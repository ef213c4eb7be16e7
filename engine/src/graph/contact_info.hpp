#pragma once

#include "../data/core.hpp"

namespace islet::detail {

/// A contact that touches, as the user sees it now.
void read_contact(const Core& core, std::uint32_t contact, ContactInfo& out);

}  // namespace islet::detail
