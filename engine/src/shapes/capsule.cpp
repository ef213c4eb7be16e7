// Capsules, and segments where they are capsules without a radius.
#include "../exact.hpp"

#include "../collide/outline_pair.hpp"
#include "../geometry/convex.hpp"
#include "../math/boxes.hpp"
#include "../shapes/manifolds.hpp"
#include "../shapes/pen.hpp"
#include "../shapes/shape_types.hpp"

namespace islet {

using namespace detail;

bool is_valid(const Capsule& c) { return are_apart(c.point1, c.point2) && c.radius > 0 && c.radius <= max_coordinate; }

/// A rectangle and two half discs. A half disc's centre of area is 4 r / (3 pi) from its straight side, so about the capsule's centre, h
/// away, the two have m (r^2 / 2 + h^2 + 2 h 4 r / (3 pi)).
MassData compute_mass(const Capsule& c, float density) {
    if (!is_valid(c) || !is_density(density)) return {};
    const float r = c.radius;
    const float len = distance(c.point1, c.point2);
    const float h = 0.5f * len;
    const float rectangle = density * 2.0f * r * len;
    const float discs = density * pi * r * r;
    const float of_rectangle = rectangle * (len * len + 4.0f * r * r) * (1.0f / 12.0f);
    const float of_discs = discs * (0.5f * r * r + h * h + 8.0f / (3.0f * pi) * h * r);
    return checked({rectangle + discs, lerp(c.point1, c.point2, 0.5f), of_rectangle + of_discs});
}

Aabb compute_aabb(const Capsule& c, const Transform& t) { return aabb_of(corners_of(c), t); }
ShapeProxy make_proxy(const Capsule& c) { return is_valid(c) ? proxy_of(corners_of(c)) : ShapeProxy{}; }

void draw_shape(const DebugDraw& draw, const Capsule& c, const Transform& pose, const DrawStyle& style) {
    Pen{draw, style}.capsule(transform_point(pose, c.point1), transform_point(pose, c.point2), c.radius);
}

namespace detail {

Manifold collide(const Capsule& a, const Circle& b, const Transform& b_in_a, float margin) {
    const Vec2 center = transform_point(b_in_a, b.center);
    const Vec2 axis = a.point2 - a.point1;
    const float t = clamp(dot(center - a.point1, axis) / max(length_squared(axis), 1e-14f), 0.0f, 1.0f);
    const Vec2 fallback = right_perp(direction_of(axis, {1, 0}).unit);
    // A centre that is on the axis but for rounding gives no direction: the remainder may point along the axis.
    const Vec2 foot = a.point1 + t * axis;
    const bool on_axis = distance_squared(center, foot) < 1e-12f * length_squared(axis);
    return collide_point(foot, a.radius, on_axis ? foot : center, b.radius, fallback, margin, 0);
}

Manifold collide(const Capsule& a, const Polygon& b, const Transform& b_in_a, float margin) {
    const Vec2 origin = a.point1;
    return collide_cores(outline_of({}, a.point2 - origin, a.radius), outline_of(b, b_in_a, origin), origin, margin);
}

Manifold collide(const Capsule& a, const Capsule& b, const Transform& b_in_a, float margin) {
    const Vec2 origin = a.point1;
    const Transform t = {b_in_a.p - origin, b_in_a.q};
    const Vec2 end = a.point2 - origin;
    const Vec2 b1 = transform_point(t, b.point1);
    const Vec2 b2 = transform_point(t, b.point2);
    // Most capsules that the broad phase pairs are further apart than this; it saves the square roots.
    const float limit = margin + a.radius + b.radius;
    const Aabb box_a = box_around({}, end), box_b = box_around(b1, b2);
    if (!meet(expand(box_a, limit), box_b)) { return none_within(gap_between(box_a, box_b) - (a.radius + b.radius)); }
    return collide_cores(outline_of({}, end, a.radius), outline_of(b1, b2, b.radius), origin, margin);
}

}  // namespace detail

}  // namespace islet
