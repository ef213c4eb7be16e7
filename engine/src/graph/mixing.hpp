// What two materials make together: Coulomb's coefficients by the geometric mean, bouncing by the larger, unless the user mixes them otherwise.
#pragma once

#include "../data/core.hpp"
#include "../math/inlining.hpp"
#include "../math/scalar.hpp"

namespace islet::detail {

/// By the user's hook, which is not null; what it says is brought into the range. Weakly referenced, as step/hooks.hpp.
ISLET_OPTIONAL float friction_by_hook(const Core& core, const Shape& a, const Shape& b);
ISLET_OPTIONAL float restitution_by_hook(const Core& core, const Shape& a, const Shape& b);

inline float mixed_friction(const Core& core, const Shape& a, const Shape& b) {
    return !has_hooks || core.hooks.mix_friction == nullptr ? sqrt(a.friction * b.friction) : friction_by_hook(core, a, b);
}

inline float mixed_restitution(const Core& core, const Shape& a, const Shape& b) {
    return !has_hooks || core.hooks.mix_restitution == nullptr ? max(a.restitution, b.restitution) : restitution_by_hook(core, a, b);
}

}  // namespace islet::detail
