// The user's hooks, and asking them. Weakly referenced: only programs that call World::set_hooks or World::hooks link the functions.
#pragma once

#include "../data/core.hpp"

namespace islet::detail {

/// What the filter hook says, which is not null.
ISLET_OPTIONAL bool is_allowed_by_hook(const Core& core, std::uint32_t shape_1, std::uint32_t shape_2);

/// By the mixing hook, which is not null; its answer is brought into the range.
ISLET_OPTIONAL float friction_by_hook(const Core& core, const Shape& a, const Shape& b);
ISLET_OPTIONAL float restitution_by_hook(const Core& core, const Shape& a, const Shape& b);

/// Asks the pre_solve hook about a contact that has points; takes over what it changed. If the hook switches it off, the contact has no points until the
/// next step.
ISLET_OPTIONAL void ask_pre_solve(Core& core, std::uint32_t contact);

/// True if the filter hook, which is not null, lets `other` stop a fast `shape`. Static shapes are looked at by many workers at once, who must not ask
/// it; but it was asked about them when a contact was made.
ISLET_OPTIONAL bool stops_by_hook(const Core& core, std::uint32_t shape, std::uint32_t other);

/// Does nothing, but whoever refers to it links the functions above.
void link_hooks();

/// True if this build and this program have what the hooks need.
inline bool are_there(const Hooks& h) {
    if (has_hooks && ISLET_IS_LINKED(ask_pre_solve)) return true;
    return h.filter == nullptr && h.pre_solve == nullptr && h.mix_friction == nullptr && h.mix_restitution == nullptr;
}

}  // namespace islet::detail
