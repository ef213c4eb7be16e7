// Circles.
#include "../exact.hpp"

#include "../collide/outline.hpp"
#include "../geometry/convex.hpp"
#include "../shapes/manifolds.hpp"
#include "../shapes/pen.hpp"
#include "../shapes/shape_types.hpp"

namespace islet {

using namespace detail;

bool is_valid(const Circle& c) { return in_range(c.center) && c.radius > 0 && c.radius <= max_coordinate; }

MassData compute_mass(const Circle& c, float density) {
    if (!is_valid(c) || !is_density(density)) return {};
    const float square = c.radius * c.radius;
    const float mass = density * pi * square;
    return checked({mass, c.center, mass * 0.5f * square});
}

Aabb compute_aabb(const Circle& c, const Transform& t) { return aabb_of(corners_of(c), t); }
ShapeProxy make_proxy(const Circle& c) { return is_valid(c) ? proxy_of(corners_of(c)) : ShapeProxy{}; }

void draw_shape(const DebugDraw& draw, const Circle& c, const Transform& pose, const DrawStyle& style) {
    Pen{draw, style}.circle(transform_point(pose, c.center), c.radius, {pose.q.c, pose.q.s});
}

namespace detail {

// Coincident centres are pushed apart along y.
Manifold collide(const Circle& a, const Circle& b, const Transform& b_in_a, float margin) {
    return collide_point(a.center, a.radius, transform_point(b_in_a, b.center), b.radius, {0, 1}, margin, 0);
}

}  // namespace detail

}  // namespace islet
