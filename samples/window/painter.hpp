// Draws a world into an SDL window: what DebugDraw asks for becomes triangles and lines, seen through a camera that can be moved and zoomed.
#pragma once

#include <SDL.h>

#include <vector>

#include <islet/debug_draw.hpp>

/// What part of the world the window shows.
struct Camera {
    islet::Vec2 center;         ///< m, in the middle of the window
    float scale = 40;           ///< pixels per metre
    int width = 0, height = 0;  ///< pixels

    SDL_FPoint to_window(islet::Vec2 p) const { return {float(width) / 2 + scale * (p.x - center.x), float(height) / 2 - scale * (p.y - center.y)}; }
    islet::Vec2 to_world(float x, float y) const { return {center.x + (x - float(width) / 2) / scale, center.y - (y - float(height) / 2) / scale}; }
    islet::Aabb view() const { return {to_world(0, float(height)), to_world(float(width), 0)}; }
    /// Shows all of the box, with the window's shape.
    void show(const islet::Aabb& box);
    /// Zooms by `factor`; the point under the pixel stays there.
    void zoom(float factor, float x, float y);
};

/// Draws with an SDL renderer. Shapes are filled and have a darker outline.
class Painter {
public:
    explicit Painter(SDL_Renderer* renderer) : renderer_(renderer) {}
    /// The functions that DebugDraw calls; set what you want to see of the world and hand it to World::draw.
    islet::DebugDraw debug_draw(const Camera& camera);

private:
    void fill(std::span<const SDL_FPoint> outline, const islet::DrawStyle& style);
    void line(std::span<const SDL_FPoint> points, islet::DrawColor color);
    void round_hull(std::span<const islet::Vec2> corners, float radius, const islet::DrawStyle& style);

    SDL_Renderer* renderer_;
    Camera camera_;
    std::vector<SDL_FPoint> outline_;
    std::vector<SDL_Vertex> vertices_;
    std::vector<int> triangles_;
};
