#include "painter.hpp"

#include <algorithm>
#include <cmath>

using namespace islet;

namespace {

constexpr float point_size = 5;  // pixels

DrawColor darker(DrawColor color) { return (color >> 1) & 0x7f7f7f; }

SDL_Color sdl_color(DrawColor color) { return {Uint8(color >> 16), Uint8(color >> 8), Uint8(color), 255}; }

}  // namespace

void Camera::show(const Aabb& box) {
    center = 0.5f * (box.lower + box.upper);
    scale = std::min(float(width) / (box.upper.x - box.lower.x), float(height) / (box.upper.y - box.lower.y));
}

void Camera::zoom(float factor, float x, float y) {
    const Vec2 held = to_world(x, y);
    scale = std::clamp(scale * factor, 0.5f, 5000.0f);
    center = center + (held - to_world(x, y));
}

DebugDraw Painter::debug_draw(const Camera& camera) {
    camera_ = camera;
    DebugDraw draw;
    draw.context = this;
    draw.view = camera.view();
    draw.size = 12 / camera.scale;
    draw.polygon = [](std::span<const Vec2> corners, float radius, const DrawStyle& style, void* painter) {
        static_cast<Painter*>(painter)->round_hull(corners, radius, style);
    };
    draw.circle = [](Vec2 center, float radius, Vec2 axis, const DrawStyle& style, void* context) {
        Painter& painter = *static_cast<Painter*>(context);
        painter.round_hull({&center, 1}, radius, style);
        const SDL_FPoint spoke[] = {painter.camera_.to_window(center), painter.camera_.to_window(center + radius * axis)};
        painter.line(spoke, darker(style.color));
    };
    draw.capsule = [](Vec2 point1, Vec2 point2, float radius, const DrawStyle& style, void* painter) {
        const Vec2 ends[] = {point1, point2};
        static_cast<Painter*>(painter)->round_hull(ends, radius, style);
    };
    draw.segment = [](Vec2 point1, Vec2 point2, const DrawStyle& style, void* context) {
        Painter& painter = *static_cast<Painter*>(context);
        const SDL_FPoint ends[] = {painter.camera_.to_window(point1), painter.camera_.to_window(point2)};
        painter.line(ends, style.part == DrawPart::shape ? darker(style.color) : style.color);
    };
    draw.point = [](Vec2 point, const DrawStyle& style, void* context) {
        const Painter& painter = *static_cast<Painter*>(context);
        const SDL_FPoint middle = painter.camera_.to_window(point);
        const SDL_FRect dot{middle.x - point_size / 2, middle.y - point_size / 2, point_size, point_size};
        const SDL_Color color = sdl_color(style.color);
        SDL_SetRenderDrawColor(painter.renderer_, color.r, color.g, color.b, color.a);
        SDL_RenderFillRectF(painter.renderer_, &dot);
    };
    return draw;
}

/// Convex, in order.
void Painter::fill(std::span<const SDL_FPoint> outline, const DrawStyle& style) {
    vertices_.clear();
    triangles_.clear();
    for (const SDL_FPoint& point : outline) vertices_.push_back({point, sdl_color(style.color), {}});
    for (int i = 2; i < int(outline.size()); ++i) triangles_.insert(triangles_.end(), {0, i - 1, i});
    SDL_RenderGeometry(renderer_, nullptr, vertices_.data(), int(vertices_.size()), triangles_.data(), int(triangles_.size()));
}

void Painter::line(std::span<const SDL_FPoint> points, DrawColor color) {
    const SDL_Color c = sdl_color(color);
    SDL_SetRenderDrawColor(renderer_, c.r, c.g, c.b, c.a);
    SDL_RenderDrawLinesF(renderer_, points.data(), int(points.size()));
}

/// The hull of one to eight corners, grown by the radius: at each corner an arc from the normal of the edge before it to that of the edge after it.
void Painter::round_hull(std::span<const Vec2> corners, float radius, const DrawStyle& style) {
    const std::size_t count = corners.size();
    // Enough that the chord of each step is within a quarter of a pixel of the arc.
    const int arc_steps = radius > 0 ? std::clamp(int(2.3f * std::sqrt(radius * camera_.scale)), 3, 48) : 0;
    outline_.clear();
    for (std::size_t i = 0; i < count; ++i) {
        const Vec2 here = corners[i];
        if (arc_steps == 0) {
            outline_.push_back(camera_.to_window(here));
            continue;
        }
        // Edges go counter-clockwise around the hull, so outside is to their right. A circle has no edges: its arc is a whole turn.
        const Vec2 in = here - corners[(i + count - 1) % count], out = corners[(i + 1) % count] - here;
        const float from = count > 1 ? std::atan2(-in.x, in.y) : 0;
        float turn = count > 1 ? std::atan2(-out.x, out.y) - from : 2 * pi;
        if (turn < 0) turn += 2 * pi;
        const int steps = count > 1 ? arc_steps : 2 * arc_steps;
        for (int k = 0; k <= steps; ++k) {
            const float angle = from + turn * float(k) / float(steps);
            outline_.push_back(camera_.to_window(here + radius * Vec2{std::cos(angle), std::sin(angle)}));
        }
    }
    if (style.solid) fill(outline_, style);
    outline_.push_back(outline_.front());
    line(outline_, style.solid ? darker(style.color) : style.color);
}
