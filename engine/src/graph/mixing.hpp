// Mixing of two materials: the geometric mean of the friction coefficients and the larger restitution, unless the user's hooks mix them.
#pragma once

#include "../data/core.hpp"
#include "../graph/hooks.hpp"
#include "../math/inlining.hpp"
#include "../math/scalar.hpp"
#include "../shapes/shape_types.hpp"

namespace islet::detail {

inline float mixed_friction(const Core& core, const Shape& a, const Shape& b) {
    return !has_hooks || core.hooks.mix_friction == nullptr ? sqrt(a.friction * b.friction) : friction_by_hook(core, a, b);
}

inline float mixed_restitution(const Core& core, const Shape& a, const Shape& b) {
    return !has_hooks || core.hooks.mix_restitution == nullptr ? max(a.restitution, b.restitution) : restitution_by_hook(core, a, b);
}

/// What of a contact's material is rare, and so is not in its manifold: it comes from the shapes.
struct MixedSurface {
    float restitution = 0;
    float rolling_resistance = 0;  // m, lever arm of the resisting torque
    float tangent_speed = 0;       // m/s
};

inline float tangent_speed_of(const Core& core, std::uint32_t contact) {
    const Contact& c = core.contacts[contact];
    return has_hooks && c.has_own_speed() ? c.own_speed() : core.shapes[c.shape_a].tangent_speed + core.shapes[c.shape_b].tangent_speed;
}

inline MixedSurface surface_of(const Core& core, std::uint32_t contact) {
    const Contact& c = core.contacts[contact];
    const Shape& a = core.shapes[c.shape_a];
    const Shape& b = core.shapes[c.shape_b];
    const auto radius = [&](const Shape& shape) { return corners_of(core.geometries[shape.geometry]).radius; };
    const auto rolling_arm = [&] {
        const float resistance = max(a.rolling_resistance, b.rolling_resistance);
        if (resistance == 0) return resistance;  // as most are: their geometries need not come from memory
        return resistance * max(radius(a), radius(b));
    };
    return {mixed_restitution(core, a, b), rolling_arm(), tangent_speed_of(core, contact)};
}

}  // namespace islet::detail
