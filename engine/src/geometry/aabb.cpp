// Tight boxes around moved shapes: the extremes of the corners, grown by the radius.
#include "../exact.hpp"

#include "../geometry/convex.hpp"

namespace islet {

Aabb compute_aabb(const Circle& c, const Transform& t) {
    const Vec2 center = transform_point(t, c.center);
    return expand({center, center}, c.radius);
}

Aabb compute_aabb(const Capsule& c, const Transform& t) { return expand(compute_aabb(Segment{c.point1, c.point2}, t), c.radius); }

Aabb compute_aabb(const Segment& s, const Transform& t) {
    const Vec2 a = transform_point(t, s.point1);
    const Vec2 b = transform_point(t, s.point2);
    return {min(a, b), max(a, b)};
}

Aabb compute_aabb(const Polygon& p, const Transform& t) {
    const Vec2 first = transform_point(t, p.vertices[0]);
    Aabb box{first, first};
    const std::uint32_t count = p.count < max_polygon_vertices ? p.count : max_polygon_vertices;
    for (std::uint32_t i = 1; i < count; ++i) {
        const Vec2 v = transform_point(t, p.vertices[i]);
        box = {min(box.lower, v), max(box.upper, v)};
    }
    return expand(box, p.radius);
}

}  // namespace islet
