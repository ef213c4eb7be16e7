// Calls of the user's hooks.
#pragma once

#include "../data/core.hpp"

namespace islet::detail {

/// Calls the filter hook, which must not be null.
bool is_allowed_by_hook(const Core& core, std::uint32_t shape_1, std::uint32_t shape_2);

/// Call a mixing hook, which must not be null, and limit its result to the range.
float friction_by_hook(const Core& core, const Shape& a, const Shape& b);
float restitution_by_hook(const Core& core, const Shape& a, const Shape& b);

/// Calls the pre_solve hook for a contact that has points, and applies its changes. If the hook disables the contact, it has no points until the next step.
void ask_pre_solve(Core& core, std::uint32_t contact);

/// True if the filter hook, which must not be null, lets `other` stop a fast `shape`. Many workers at once follow bodies past static shapes and must not call
/// the hook; but it has decided about these pairs when their contacts were made.
bool stops_by_hook(const Core& core, std::uint32_t shape, std::uint32_t other);

/// True if this build and this program have all that the hooks need.
inline bool are_there(const Hooks& h) {
    if (has_hooks) return true;
    return h.filter == nullptr && h.pre_solve == nullptr && h.mix_friction == nullptr && h.mix_restitution == nullptr;
}

}  // namespace islet::detail
