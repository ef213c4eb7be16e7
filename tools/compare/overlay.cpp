// The picture of a comparison: where the same bodies are in both engines.
#include <cmath>

#include <fmt/format.h>

#include "compare_report.hpp"

namespace islet::compare {

using samples::Engine;
using samples::Scene;
using samples::SceneGeometry;

namespace {

/// A geometry as SVG elements in the world's axes (y up; the picture flips once).
struct Drawer {
    Transform pose;
    const char* style;

    std::string path(std::span<const Vec2> points, bool closed) const {
        std::string d;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Vec2 p = transform_point(pose, points[i]);
            d += fmt::format("{}{:.4f} {:.4f}", i == 0 ? "M" : "L", p.x, p.y);
        }
        return fmt::format("<path class=\"{}\" d=\"{}{}\"/>\n", style, d, closed ? "Z" : "");
    }

    std::string operator()(const Circle& c) const {
        const Vec2 p = transform_point(pose, c.center);
        const Vec2 spoke[] = {c.center, c.center + Vec2{c.radius, 0}};  // shows how far it has rolled
        return fmt::format("<circle class=\"{}\" cx=\"{:.4f}\" cy=\"{:.4f}\" r=\"{:.4f}\"/>\n", style, p.x, p.y, c.radius) +
               path(spoke, false);
    }
    std::string operator()(const Capsule& c) const {
        const Vec2 ends[] = {c.point1, c.point2};
        return path(ends, false) + (*this)(Circle{c.point1, c.radius}) + (*this)(Circle{c.point2, c.radius});
    }
    std::string operator()(const Segment& s) const {
        const Vec2 ends[] = {s.point1, s.point2};
        return path(ends, false);
    }
    std::string operator()(const HalfSpace& h) const { return (*this)(samples::long_segment(h)); }
    std::string operator()(const Polygon& p) const { return path({p.vertices, p.count}, true); }
    std::string operator()(const samples::Chain& c) const { return path(c.points, c.loop); }
};

std::string draw(const Scene& scene, const Engine& engine, const char* style) {
    std::string out;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        if (!engine.exists(i)) continue;
        const samples::BodyState body = engine.body(i);
        const Drawer drawer{{body.position, make_rot(body.angle)}, style};
        for (const samples::SceneShape& shape : scene.bodies[i].shapes) out += std::visit(drawer, shape.geometry);
    }
    return out;
}

}  // namespace

std::string to_svg(const Scene& scene, const Engine& islet, const Engine& reference, int step) {
    constexpr float pixels = 1000;
    const Vec2 low = scene.view.lower, high = scene.view.upper;
    const float width = high.x - low.x, height = high.y - low.y, caption = 0.035f * width;
    // Lengths are metres: a line is 1.2 pixels wide.
    std::string out = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{:.0f}\" height=\"{:.0f}\" viewBox=\"{:.4f} {:.4f} {:.4f} {:.4f}\">\n"
        "<style>path,circle{{stroke-width:{:.5f}px;fill:none}} .a{{fill:#4a90d9;fill-opacity:0.35;stroke:#1f5f9f}} .b{{stroke:#d9482b}} "
        "text{{font-family:sans-serif;font-size:{:.4f}px}}</style>\n",
        pixels, pixels * (height + caption) / width, low.x, -high.y, width, height + caption, 1.2f * width / pixels, 0.6f * caption);
    const std::string white = "<rect x=\"{:.4f}\" y=\"{:.4f}\" width=\"{:.4f}\" height=\"{:.4f}\" fill=\"#fff\"/>\n";
    out += fmt::format(fmt::runtime(white), low.x, -high.y, width, height);
    out += "<g transform=\"scale(1 -1)\">\n" + draw(scene, islet, "a") + draw(scene, reference, "b") + "</g>\n";
    out += fmt::format(fmt::runtime(white), low.x, -low.y, width, caption);
    out += fmt::format(
        "<text x=\"{:.4f}\" y=\"{:.4f}\">{}, step {}: <tspan fill=\"#1f5f9f\">Islet</tspan> and "
        "<tspan fill=\"#d9482b\">{}</tspan></text>\n</svg>\n",
        low.x + 0.5f * caption, -low.y + 0.7f * caption, scene.name, step, reference.name());
    return out;
}

}  // namespace islet::compare
