// Proxies, and the questions about shapes by themselves: checks around what difference.hpp answers.
#include "../exact.hpp"

#include "islet/query.hpp"

#include "../collide/difference.hpp"
#include "../geometry/convex.hpp"

namespace islet {
namespace {

constexpr float max_proxy_coordinate = 4.0f * detail::max_coordinate;  // m: a shape at the edge of a body at the edge of the world, turned

bool in_range(Vec2 a, float limit) { return abs(a.x) <= limit && abs(a.y) <= limit; }

ShapeProxy proxy_of(Vec2 p, float radius) {
    ShapeProxy proxy;
    proxy.points[0] = p;
    proxy.count = 1;
    proxy.radius = radius;
    return proxy;
}

ShapeProxy proxy_of(Vec2 p, Vec2 q, float radius) {
    ShapeProxy proxy = proxy_of(p, radius);
    proxy.points[1] = q;
    proxy.count = 2;
    return proxy;
}

ShapeProxy checked(const ShapeProxy& p) { return is_valid(p) ? p : ShapeProxy{}; }

}  // namespace

ShapeProxy make_proxy(span<const Vec2> points, float radius) {
    if (points.size() == 1) return checked(proxy_of(points[0], radius));
    if (points.size() == 2) return checked(proxy_of(points[0], points[1], radius));
    const Hull hull = compute_hull(points);
    ShapeProxy proxy;
    for (std::uint32_t i = 0; i < hull.count; ++i) proxy.points[i] = hull.points[i];
    proxy.count = hull.count;
    proxy.radius = radius;
    return checked(proxy);
}

ShapeProxy make_proxy(const Aabb& box) {
    ShapeProxy proxy;
    if (!(box.lower.x < box.upper.x && box.lower.y < box.upper.y)) return proxy;
    proxy.points[0] = box.lower;
    proxy.points[1] = {box.upper.x, box.lower.y};
    proxy.points[2] = box.upper;
    proxy.points[3] = {box.lower.x, box.upper.y};
    proxy.count = 4;
    return checked(proxy);
}

ShapeProxy transform_proxy(const Transform& t, const ShapeProxy& p) {
    if (!is_valid(p)) return {};
    ShapeProxy moved = p;
    for (std::uint32_t i = 0; i < p.count; ++i) moved.points[i] = transform_point(t, p.points[i]);
    return checked(moved);
}

bool is_valid(const ShapeProxy& p) {
    if (p.count < 1 || p.count > max_polygon_vertices || !detail::is_radius(p.radius)) return false;
    for (std::uint32_t i = 0; i < p.count; ++i) {
        if (!in_range(p.points[i], max_proxy_coordinate)) return false;
    }
    return p.count < 3 || detail::is_strictly_convex({p.points, p.count});
}

CastHit cast_ray(const ShapeProxy& target, Vec2 origin, Vec2 translation) { return cast_shape(proxy_of(origin, 0), translation, target); }

CastHit cast_shape(const ShapeProxy& moving, Vec2 translation, const ShapeProxy& target) {
    if (!is_valid(moving) || !is_valid(target) || !in_range(translation, max_translation)) return {};
    return detail::cast_proxy(moving, translation, target);
}

Separation separation(const ShapeProxy& a, const ShapeProxy& b) {
    if (!is_valid(a) || !is_valid(b)) return {3.4e38f, {}, {}, {}};
    const detail::Difference w = detail::difference_of(a, b);
    const detail::Nearest n = detail::nearest(w);
    return {n.distance, detail::point_of(w, w.index_a, a.points, n.place) - a.radius * n.normal,
            detail::point_of(w, w.index_b, b.points, n.place) + b.radius * n.normal, -n.normal};
}

bool overlaps(const ShapeProxy& a, const ShapeProxy& b) { return separation(a, b).distance <= 0; }

bool contains(const ShapeProxy& shape, Vec2 point) {
    const bool solid = shape.count > 2 || shape.radius > 0;
    return solid && separation(proxy_of(point, 0), shape).distance <= 0;
}

}  // namespace islet
