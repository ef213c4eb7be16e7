#include "drawing.hpp"

#include <algorithm>
#include <map>

namespace islet::tools {
namespace {

Drawing& of(void* self) { return *static_cast<Drawing*>(self); }

}  // namespace

void Drawing::put(Stroke::Figure figure, std::span<const Vec2> points, float radius, const DrawStyle& style) {
    strokes_.push_back({figure, style, radius, static_cast<std::uint32_t>(points_.size()), static_cast<std::uint32_t>(points.size())});
    points_.insert(points_.end(), points.begin(), points.end());
}

void Drawing::take_all(DebugDraw& options) {
    using Figure = Stroke::Figure;
    options.context = this;
    options.polygon = [](std::span<const Vec2> corners, float radius, const DrawStyle& style, void* self) {
        of(self).put(Figure::polygon, corners, radius, style);
    };
    options.circle = [](Vec2 center, float radius, Vec2 axis, const DrawStyle& style, void* self) {
        of(self).put(Figure::circle, {{center, center + radius * axis}}, radius, style);
    };
    options.capsule = [](Vec2 a, Vec2 b, float radius, const DrawStyle& style, void* self) { of(self).put(Figure::capsule, {{a, b}}, radius, style); };
    options.segment = [](Vec2 a, Vec2 b, const DrawStyle& style, void* self) { of(self).put(Figure::segment, {{a, b}}, 0, style); };
    options.point = [](Vec2 p, const DrawStyle& style, void* self) { of(self).put(Figure::point, {{p}}, 0, style); };
    options.text = [](Vec2 p, const char* text, const DrawStyle& style, void* self) { of(self).words_.push_back({p, text, style.color}); };
}

void Drawing::add(const World& world, DebugDraw options) {
    take_all(options);
    world.draw(options);
}

void Drawing::add_shape(const World& world, ShapeId shape) {
    DebugDraw options;
    take_all(options);
    world.draw_shape(options, shape, {}, {});
}

void Drawing::clear() {
    strokes_.clear();
    points_.clear();
    words_.clear();
}

double size_of(const Drawing& drawing, const Stroke& shape) {
    if (shape.figure == Stroke::Figure::circle) return 2 * double(shape.radius);
    const std::span<const Vec2> points = drawing.points(shape);
    const Vec2 along = normalize(points[1] - points[0]), across = left_perp(along);
    Aabb box = {{3e30f, 3e30f}, {-3e30f, -3e30f}};
    for (const Vec2 p : points) {
        const Vec2 turned = {dot(p, along), dot(p, across)};
        box = merge(box, {turned, turned});
    }
    return 0.25 * double(perimeter(expand(box, shape.radius)));
}

double typical_size(const Drawing& drawing) {
    std::map<std::uint32_t, double> largest;  // by body
    for (const Stroke& shape : drawing.strokes()) {
        if (shape.style.part != DrawPart::shape || shape.style.color == draw_color::static_body) continue;
        double& size = largest[shape.style.slot];
        size = std::max(size, size_of(drawing, shape));
    }
    if (largest.empty()) return 0;
    std::vector<double> sizes;
    for (const auto& [body, size] : largest) sizes.push_back(size);
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::nth_element(sizes.begin(), middle, sizes.end());
    return *middle;
}

float joint_mark_size(double typical_size, double pixels_per_metre) {
    return static_cast<float>(std::clamp(0.4 * typical_size * pixels_per_metre, 3.0, 18.0) / pixels_per_metre);
}

}  // namespace islet::tools
