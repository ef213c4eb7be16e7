// The pre_solve hook. Weakly referenced: only setting hooks links it.
#pragma once

#include "memory/core.hpp"

namespace islet::detail {

/// Asks the hook about a contact that has points; takes over what it changed. If the hook switches it off, the contact has no points until the next step.
ISLET_OPTIONAL void ask_pre_solve(Core& core, std::uint32_t contact);

/// Does nothing, but whoever refers to it links the function above.
void link_hooks();

/// True if this build and this program have what the hooks need.
inline bool are_there(const Hooks& h) {
    const bool none = h.filter == nullptr && h.pre_solve == nullptr && h.mix_friction == nullptr && h.mix_restitution == nullptr;
#if defined(__ELF__)
    return none || (has_hooks && (h.pre_solve == nullptr || ask_pre_solve != nullptr));
#else
    return none || has_hooks;
#endif
}

}  // namespace islet::detail
