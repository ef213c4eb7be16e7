// A picture in SVG, put together line by line: worlds through DebugDraw, and what a page wants to say about them.
#pragma once

#include <cstdio>
#include <span>
#include <string>

#include <islet/islet.hpp>

namespace islet::pictures {

/// Where a part of the world is on the picture.
struct Camera {
    Vec2 lower = {};        ///< m, the world's point at the lower left corner
    float scale = 40;       ///< px per metre
    float left = 0;         ///< px, of that corner on the picture
    float bottom = 0;

    Vec2 operator()(Vec2 p) const { return {left + scale * (p.x - lower.x), bottom - scale * (p.y - lower.y)}; }
};

/// How a line or an outline looks. An empty fill is none.
struct Pen {
    const char* stroke = "#2c3440";
    const char* fill = "none";
    float width = 1.5f;       // px
    const char* dashes = "";  // as in stroke-dasharray
};

class Sketch {
public:
    Sketch(int width, int height) : width_(width), height_(height) {}

    void line(Vec2 a, Vec2 b, const Pen& pen);
    /// A line that ends in a head at `b`.
    void arrow(Vec2 a, Vec2 b, const Pen& pen);
    void circle(Vec2 center, float radius, const Pen& pen);
    void polyline(std::span<const Vec2> points, const Pen& pen);
    /// An upright box, rounded at its corners.
    void box(Vec2 corner, float width, float height, const Pen& pen);
    /// `anchor` is start, middle or end.
    void text(Vec2 at, const std::string& words, const char* color = "#2c3440", float size = 14, const char* anchor = "start");
    /// The shapes of a world, in the colours of DebugDraw.
    void world(const World& world, const Camera& camera);

    std::string svg() const;

private:
    void shape(std::span<const Vec2> corners, float radius, const DrawStyle& style);

    int width_, height_;
    std::string body_;
    Camera camera_;  // of the world that is being drawn
};

}  // namespace islet::pictures
