// What the parts of World::draw share.
#pragma once

#include "../data/core.hpp"
#include "../shapes/pen.hpp"
#include "islet/debug_draw.hpp"

namespace islet::detail {

/// Which colour a constraint's is, if constraints are told apart by it.
inline DrawColor constraint_color(const DebugDraw& draw, std::uint32_t color, DrawColor otherwise) {
    if (!draw.constraint_colors) return otherwise;
    return color == no_color ? draw_color::overflow : distinct_color(color);
}

/// By body slot: the lowest slot of a body in its island, or null_index for what is in none. Uses scratch memory.
const std::uint32_t* find_all_islands(const Core& core);

/// The marks of a joint that is in view.
void draw_joint(const Core& core, const DebugDraw& draw, std::uint32_t joint);
void draw_joint_name(const Core& core, const DebugDraw& draw, std::uint32_t joint);

}  // namespace islet::detail
