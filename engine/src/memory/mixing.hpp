// What two materials make together: Coulomb's coefficients by the geometric mean, bouncing by the larger, unless the user mixes them otherwise.
#pragma once

#include "math/copies.hpp"
#include "math/scalar.hpp"
#include "memory/core.hpp"

namespace islet::detail {

inline float mixed_friction(const Core& core, const Shape& a, const Shape& b) {
    const Hooks& hooks = core.hooks;
    if (!has_hooks || hooks.mix_friction == nullptr) return sqrt(a.friction * b.friction);
    const float mixed = hooks.mix_friction(a.friction, a.material, b.friction, b.material, hooks.context);
    return mixed >= 0 ? min(mixed, max_coefficient) : 0.0f;  // 0 for NaN too
}

ISLET_SHARED float mixed_restitution(const Core& core, const Shape& a, const Shape& b) {
    const Hooks& hooks = core.hooks;
    if (!has_hooks || hooks.mix_restitution == nullptr) return max(a.restitution, b.restitution);
    const float mixed = hooks.mix_restitution(a.restitution, a.material, b.restitution, b.material, hooks.context);
    return has_restitution && mixed >= 0 ? min(mixed, 1.0f) : 0.0f;
}

}  // namespace islet::detail
