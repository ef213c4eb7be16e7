// What the parts of World::draw share: a pen that skips what the user has no function for.
#pragma once

#include "../data/core.hpp"
#include "islet/debug_draw.hpp"

namespace islet::detail {

/// Draws with one style.
struct Pen {
    const DebugDraw& draw;
    DrawStyle style;

    Pen with(DrawColor color) const { return {draw, {color, style.part, style.solid, style.slot}}; }

    void segment(Vec2 a, Vec2 b) const {
        if (draw.segment != nullptr) draw.segment(a, b, style, draw.context);
    }
    void point(Vec2 p) const {
        if (draw.point != nullptr) draw.point(p, style, draw.context);
    }
    void circle(Vec2 center, float radius, Vec2 axis) const {
        if (draw.circle != nullptr) draw.circle(center, radius, axis, style, draw.context);
    }
    void capsule(Vec2 a, Vec2 b, float radius) const {
        if (draw.capsule != nullptr) draw.capsule(a, b, radius, style, draw.context);
    }
    void polygon(std::span<const Vec2> corners, float radius) const {
        if (draw.polygon != nullptr) draw.polygon(corners, radius, style, draw.context);
    }
    void text(Vec2 p, const char* words) const {
        if (draw.text != nullptr) draw.text(p, words, style, draw.context);
    }
    void box(const Aabb& b) const {
        const Vec2 corners[] = {b.lower, {b.upper.x, b.lower.y}, b.upper, {b.lower.x, b.upper.y}};
        polygon(corners, 0);
    }
};

/// Calls visit(slot) for each live slot of a pool, in ascending order.
template <class T, class Visit>
void for_each_live(const PoolState& pool, const T* slots, Visit&& visit) {
    for (std::uint32_t i = 0; i < pool.high_water; ++i)
        if ((slots[i].generation & 1u) != 0) visit(i);
}

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
