// A pen that skips what the user has no function for.
#pragma once

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
    void polygon(span<const Vec2> corners, float radius) const {
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

}  // namespace islet::detail
