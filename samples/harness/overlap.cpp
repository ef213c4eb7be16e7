#include "overlap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace islet::samples {
namespace {

/// How far `b` would have to move to leave the half-planes of a's faces; negative where they are apart along one of them.
double depth_along_faces(const Outline& a, const Outline& b) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Corner &p = a[i], &q = a[(i + 1) % a.size()];
        const double nx = q[1] - p[1], ny = p[0] - q[0], length = std::hypot(nx, ny);
        double deepest = -std::numeric_limits<double>::infinity();
        for (const Corner& c : b) deepest = std::max(deepest, -(nx * (c[0] - p[0]) + ny * (c[1] - p[1])) / length);
        least = std::min(least, deepest);
    }
    return least;
}

/// A polygon where it is now.
struct PolygonInWorld {
    std::size_t body = 0;
    bool is_dynamic = false;
    Outline outline;
    double left = 0, right = 0, bottom = 0, top = 0;
};

PolygonInWorld polygon_in_world(const ScenePolygon& polygon, const Engine& engine) {
    const BodyState state = engine.body(polygon.body);
    PolygonInWorld placed{polygon.body, state.mass > 0, outline_of(polygon.shape, {state.position, make_rot(state.angle)})};
    const auto [low_x, high_x] = std::minmax_element(placed.outline.begin(), placed.outline.end());
    placed.left = (*low_x)[0], placed.right = (*high_x)[0];
    placed.bottom = placed.top = placed.outline.front()[1];
    for (const Corner& c : placed.outline) placed.bottom = std::min(placed.bottom, c[1]), placed.top = std::max(placed.top, c[1]);
    return placed;
}

}  // namespace

Outline outline_of(const Polygon& polygon, const Transform& pose) {
    Outline outline;
    outline.reserve(polygon.count);
    const double c = double(pose.q.c), s = double(pose.q.s);
    for (std::uint32_t i = 0; i < polygon.count; ++i) {
        const double x = double(polygon.vertices[i].x), y = double(polygon.vertices[i].y);
        outline.push_back({double(pose.p.x) + c * x - s * y, double(pose.p.y) + s * x + c * y});
    }
    return outline;
}

double overlap_of(const Outline& a, const Outline& b) { return std::min(depth_along_faces(a, b), depth_along_faces(b, a)); }

std::vector<ScenePolygon> polygons_in(const Scene& scene) {
    std::vector<ScenePolygon> polygons;
    for (std::size_t body = 0; body < scene.bodies.size(); ++body) {
        for (const SceneShape& shape : scene.bodies[body].shapes) {
            const auto* polygon = std::get_if<Polygon>(&shape.geometry);
            if (polygon != nullptr && !shape.def.sensor) polygons.push_back({body, *polygon});
        }
    }
    return polygons;
}

std::vector<Overlap> overlaps_of(const std::vector<ScenePolygon>& polygons, const Engine& engine, double least) {
    std::vector<PolygonInWorld> placed;
    placed.reserve(polygons.size());
    for (const ScenePolygon& polygon : polygons)
        if (engine.exists(polygon.body)) placed.push_back(polygon_in_world(polygon, engine));
    std::sort(placed.begin(), placed.end(), [](const PolygonInWorld& a, const PolygonInWorld& b) { return a.left < b.left; });

    std::vector<Overlap> overlaps;
    for (std::size_t i = 0; i < placed.size(); ++i) {
        const PolygonInWorld& a = placed[i];
        for (std::size_t k = i + 1; k < placed.size() && placed[k].left < a.right; ++k) {
            const PolygonInWorld& b = placed[k];
            if (a.body == b.body || !(a.is_dynamic || b.is_dynamic) || b.bottom > a.top || b.top < a.bottom) continue;
            if (const double depth = overlap_of(a.outline, b.outline); depth > least) overlaps.push_back({a.body, b.body, depth});
        }
    }
    return overlaps;
}

double deepest_overlap(const std::vector<ScenePolygon>& polygons, const Engine& engine) {
    double deepest = 0;
    for (const Overlap& overlap : overlaps_of(polygons, engine, 0)) deepest = std::max(deepest, overlap.depth);
    return deepest;
}

}  // namespace islet::samples
