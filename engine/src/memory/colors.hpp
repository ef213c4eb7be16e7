// Constraint colours: no two constraints of one colour share a dynamic body, so all of a colour can be solved at once.
//
// A body keeps a bit mask of the colours its constraints use, so giving a colour is O(1): the lowest bit that is free in both masks. A
// constraint against a static or kinematic body takes colours from the other end; they are solved last, so the ground has the last word. What
// finds no colour overflows and is solved on its own. (Graph colouring for Gauss-Seidel; the split between the two ends follows Box2D 3.)
#pragma once

#include "memory/core.hpp"

namespace islet::detail {

inline constexpr std::uint32_t dynamic_color_limit = 24;  // colours that two dynamic bodies may share

inline void assign_color(Core& core, std::uint32_t contact) {
    ContactManifold& m = core.manifolds[contact];
    const bool dynamic_a = core.is_dynamic(m.body_a);
    const bool dynamic_b = core.is_dynamic(m.body_b);
    const std::uint32_t used = (dynamic_a ? core.bodies[m.body_a].colors : 0u) | (dynamic_b ? core.bodies[m.body_b].colors : 0u);
    std::uint32_t color = no_color;
    if (dynamic_a && dynamic_b) {
        const std::uint32_t free = ~used & ((1u << dynamic_color_limit) - 1u);
        if (free != 0) color = static_cast<std::uint32_t>(__builtin_ctz(free));
    } else if (~used != 0) {
        color = 31u - static_cast<std::uint32_t>(__builtin_clz(~used));
    }
    m.set_color(color);
    if (color == no_color) return;
    if (dynamic_a) core.bodies[m.body_a].colors |= 1u << color;
    if (dynamic_b) core.bodies[m.body_b].colors |= 1u << color;
}

inline void release_color(Core& core, std::uint32_t contact) {
    ContactManifold& m = core.manifolds[contact];
    const std::uint32_t color = m.color();
    if (color == no_color) return;
    if (core.is_dynamic(m.body_a)) core.bodies[m.body_a].colors &= ~(1u << color);
    if (core.is_dynamic(m.body_b)) core.bodies[m.body_b].colors &= ~(1u << color);
    m.set_color(no_color);
}

}  // namespace islet::detail
