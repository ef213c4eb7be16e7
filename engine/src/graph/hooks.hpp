// The user's hooks, and asking them.
#pragma once

#include "../data/core.hpp"

namespace islet::detail {

/// What the filter hook says, which is not null.
bool is_allowed_by_hook(const Core& core, std::uint32_t shape_1, std::uint32_t shape_2);

/// By the mixing hook, which is not null; its answer is brought into the range.
float friction_by_hook(const Core& core, const Shape& a, const Shape& b);
float restitution_by_hook(const Core& core, const Shape& a, const Shape& b);

/// Asks the pre_solve hook about a contact that has points; takes over what it changed. If the hook switches it off, the contact has no points until the
/// next step.
void ask_pre_solve(Core& core, std::uint32_t contact);

/// True if the filter hook, which is not null, lets `other` stop a fast `shape`. Static shapes are looked at by many workers at once, who must not ask
/// it; but it was asked about them when a contact was made.
bool stops_by_hook(const Core& core, std::uint32_t shape, std::uint32_t other);

/// True if this build has what the hooks need.
inline bool are_there(const Hooks& h) {
    if (has_hooks) return true;
    return h.filter == nullptr && h.pre_solve == nullptr && h.mix_friction == nullptr && h.mix_restitution == nullptr;
}

}  // namespace islet::detail
