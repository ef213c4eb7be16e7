// Calls of the user's hooks. Referenced weakly: only programs that call World::set_hooks or World::hooks link these functions.
#pragma once

#include "../data/core.hpp"

namespace islet::detail {

/// Calls the filter hook, which must not be null.
ISLET_OPTIONAL bool is_allowed_by_hook(const Core& core, std::uint32_t shape_1, std::uint32_t shape_2);

/// Call a mixing hook, which must not be null, and limit its result to the range.
ISLET_OPTIONAL float friction_by_hook(const Core& core, const Shape& a, const Shape& b);
ISLET_OPTIONAL float restitution_by_hook(const Core& core, const Shape& a, const Shape& b);

/// Calls the pre_solve hook for a contact that has points, and applies its changes. If the hook disables the contact, it has no points until the next step.
ISLET_OPTIONAL void ask_pre_solve(Core& core, std::uint32_t contact);

/// True if the filter hook, which must not be null, lets `other` stop a fast `shape`. Many workers at once follow bodies past static shapes and must not call
/// the hook; but it has decided about these pairs when their contacts were made.
ISLET_OPTIONAL bool stops_by_hook(const Core& core, std::uint32_t shape, std::uint32_t other);

/// Does nothing. A program that refers to it links the functions above.
void link_hooks();

/// True if this build and this program have all that the hooks need.
inline bool are_there(const Hooks& h) {
    if (has_hooks && ISLET_IS_LINKED(ask_pre_solve)) return true;
    return h.filter == nullptr && h.pre_solve == nullptr && h.mix_friction == nullptr && h.mix_restitution == nullptr;
}

}  // namespace islet::detail
