// Mixing of two materials: the geometric mean of the friction coefficients and the larger restitution, unless the user's hooks mix them.
#pragma once

#include "../graph/hooks.hpp"
#include "../math/scalar.hpp"

namespace islet::detail {

inline float mixed_friction(const Core& core, const Shape& a, const Shape& b) {
    return !has_hooks || core.hooks.mix_friction == nullptr ? sqrt(a.friction * b.friction) : friction_by_hook(core, a, b);
}

inline float mixed_restitution(const Core& core, const Shape& a, const Shape& b) {
    return !has_hooks || core.hooks.mix_restitution == nullptr ? max(a.restitution, b.restitution) : restitution_by_hook(core, a, b);
}

}  // namespace islet::detail
