// Constraint colours: no two constraints of one colour share a dynamic body, so all of a colour can be solved at once.
//
// A body keeps a bit mask of the colours of its constraints, so finding a colour takes O(1): the lowest bit that is free in both masks. For half of the pairs
// of bodies, each two neighbouring colours change places first. Constraints with a static or kinematic body take colours from the other end. These colours are
// solved last, so the ground has the last word. A constraint that finds no colour is solved on its own. (Graph colouring for Gauss-Seidel; the split between
// the two ends follows Box2D 3.)
//
// Why they change places: if every brick of a wall has its left contact solved before its right one, sweeps pass a shear wave on along the wall, and it grows
// as fast as friction takes from it. (Walls in bond of 15 to 26 rows shook at 0.1 m/s for ever, and do not.)
#pragma once

#include "../data/core.hpp"
#include "../math/inlining.hpp"

namespace islet::detail {

inline constexpr std::uint32_t dynamic_color_limit = 24;  // constraints between two dynamic bodies have colours below this

/// Whether neighbouring colours change places for this pair of bodies: a bit of a hash.
inline bool swaps_colors(std::uint32_t body_a, std::uint32_t body_b) { return ((body_a * 2654435761u ^ body_b * 2246822519u) >> 16 & 1u) != 0; }

/// Takes a colour that neither body has yet, or no_color. null_index stands for a body that cannot move.
inline std::uint32_t take_color(Core& core, std::uint32_t body_a, std::uint32_t body_b) {
    const bool dynamic_a = body_a != null_index && core.is_dynamic(body_a);
    const bool dynamic_b = body_b != null_index && core.is_dynamic(body_b);
    const std::uint32_t used = (dynamic_a ? core.bodies[body_a].colors : 0u) | (dynamic_b ? core.bodies[body_b].colors : 0u);
    std::uint32_t color = no_color;
    if (dynamic_a && dynamic_b) {
        const std::uint32_t free = ~used & ((1u << dynamic_color_limit) - 1u);
        const bool swaps = swaps_colors(body_a, body_b);
        const std::uint32_t in_turn = swaps ? (free & 0x55555555u) << 1 | (free >> 1 & 0x55555555u) : free;
        if (in_turn != 0) color = trailing_zeros(in_turn) ^ (swaps ? 1u : 0u);
    } else if (~used != 0) {
        color = 31u - leading_zeros(~used);
    }
    if (color == no_color) return color;
    if (dynamic_a) core.bodies[body_a].colors |= 1u << color;
    if (dynamic_b) core.bodies[body_b].colors |= 1u << color;
    return color;
}

ISLET_SHARED void give_color(Core& core, std::uint32_t color, std::uint32_t body_a, std::uint32_t body_b) {
    if (color == no_color) return;
    if (body_a != null_index && core.is_dynamic(body_a)) core.bodies[body_a].colors &= ~(1u << color);
    if (body_b != null_index && core.is_dynamic(body_b)) core.bodies[body_b].colors &= ~(1u << color);
}

inline void assign_color(Core& core, std::uint32_t contact) {
    ContactManifold& m = core.manifolds[contact];
    m.set_color(take_color(core, m.body_a, m.body_b));
}

inline void release_color(Core& core, std::uint32_t contact) {
    ContactManifold& m = core.manifolds[contact];
    give_color(core, m.color(), m.body_a, m.body_b);
    m.set_color(no_color);
}

}  // namespace islet::detail
