// Making polygons and moving them. A polygon that leaves here is valid or has count 0, and its unused places are zero.
#include "../exact.hpp"

#include "../geometry/convex.hpp"

namespace islet {
namespace {

/// Centroid by a fan of triangles around vertex 0: measured from there, a polygon far from the origin loses no digits.
Vec2 centroid_of(const Polygon& p) {
    const Vec2 origin = p.vertices[0];
    Vec2 moment;
    float twice_area = 0;
    for (std::uint32_t i = 1; i + 1 < p.count; ++i) {
        const Vec2 e1 = p.vertices[i] - origin;
        const Vec2 e2 = p.vertices[i + 1] - origin;
        const float weight = cross(e1, e2);
        moment += weight * (e1 + e2);
        twice_area += weight;
    }
    return twice_area > 0 ? origin + moment * (1.0f / (3.0f * twice_area)) : origin;
}

Polygon checked(const Polygon& p) { return is_valid(p) ? p : Polygon{}; }

}  // namespace

Polygon make_polygon(const Hull& hull, float radius) {
    if (hull.count < 3 || hull.count > max_polygon_vertices) return {};
    Polygon p;
    p.count = hull.count;
    p.radius = radius;
    for (std::uint32_t i = 0; i < hull.count; ++i) {
        p.vertices[i] = hull.points[i];
        const Vec2 edge = hull.points[detail::next(i, hull.count)] - hull.points[i];
        p.normals[i] = normalize(right_perp(edge)) + Vec2{};  // adding zero turns -0 into +0
    }
    p.centroid = centroid_of(p);
    return checked(p);
}

Polygon make_box(float hx, float hy) { return make_rounded_box(hx, hy, 0); }

Polygon make_rounded_box(float hx, float hy, float radius) {
    Polygon p;
    p.count = 4;
    p.radius = radius;
    p.vertices[0] = {-hx, -hy};
    p.vertices[1] = {hx, -hy};
    p.vertices[2] = {hx, hy};
    p.vertices[3] = {-hx, hy};
    p.normals[0] = {0, -1};
    p.normals[1] = {1, 0};
    p.normals[2] = {0, 1};
    p.normals[3] = {-1, 0};
    return checked(p);
}

Polygon make_offset_box(float hx, float hy, const Transform& pose, float radius) { return transform_polygon(pose, make_rounded_box(hx, hy, radius)); }

Polygon transform_polygon(const Transform& t, const Polygon& p) {
    if (p.count > max_polygon_vertices) return {};
    Polygon moved;
    moved.count = p.count;
    moved.radius = p.radius;
    moved.centroid = transform_point(t, p.centroid);
    for (std::uint32_t i = 0; i < p.count; ++i) {
        moved.vertices[i] = transform_point(t, p.vertices[i]);
        moved.normals[i] = rotate(t.q, p.normals[i]);
    }
    return checked(moved);
}

}  // namespace islet
