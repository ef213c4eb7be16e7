// Pairs with a circle: the closest point of the other core to the circle's centre decides everything, so there is one point at most.
#include "collide/outline.hpp"

namespace islet::detail {
namespace {

// Where two coincident centres are pushed apart.
constexpr Vec2 up = {0, 1};

// Core point `a` of A against the circle around `center`, both in frame A.
Manifold collide_point(Vec2 a, float radius_a, Vec2 center, float radius_b, Vec2 fallback, float margin, std::uint16_t id) {
    const Vec2 between = center - a;
    const float limit = margin + radius_a + radius_b;
    if (length_squared(between) > limit * limit) { return {}; }
    const Direction d = direction_of(between, fallback);
    return point_manifold(a, radius_a, center, radius_b, d.unit, d.length, id);
}

}  // namespace

Manifold collide(const Circle& a, const Circle& b, const Transform& b_in_a, float margin) {
    return collide_point(a.center, a.radius, transform_point(b_in_a, b.center), b.radius, up, margin, 0);
}

Manifold collide(const Capsule& a, const Circle& b, const Transform& b_in_a, float margin) {
    const Vec2 center = transform_point(b_in_a, b.center);
    const Vec2 axis = a.point2 - a.point1;
    const float t = clamp(dot(center - a.point1, axis) / max(length_squared(axis), 1e-14f), 0.0f, 1.0f);
    const Vec2 fallback = right_perp(direction_of(axis, {1, 0}).unit);
    // A centre on the axis but for rounding has no direction of its own: what is left may lead along the axis.
    const Vec2 foot = a.point1 + t * axis;
    const bool on_axis = distance_squared(center, foot) < 1e-12f * length_squared(axis);
    return collide_point(foot, a.radius, on_axis ? foot : center, b.radius, fallback, margin, 0);
}

Manifold collide(const Polygon& a, const Circle& b, const Transform& b_in_a, float margin) {
    const Vec2 center = transform_point(b_in_a, b.center);
    const float limit = margin + a.radius + b.radius;
    std::uint32_t face = 0;
    float separation = -3e38f;
    for (std::uint32_t i = 0; i < a.count; ++i) {
        const float s = dot(a.normals[i], center - a.vertices[i]);
        face = s > separation ? i : face;
        separation = max(s, separation);
    }
    if (separation > limit) { return {}; }

    // The corner closest to a centre outside always belongs to the face it is furthest in front of.
    const std::uint32_t next = face + 1 < a.count ? face + 1 : 0;
    const Vec2 v1 = a.vertices[face];
    const Vec2 v2 = a.vertices[next];
    const Vec2 n = a.normals[face];
    if (separation > 1e-6f) {
        if (dot(center - v1, v2 - v1) < 0.0f) { return collide_point(v1, a.radius, center, b.radius, n, margin, feature_id(face, 0)); }
        if (dot(center - v2, v1 - v2) < 0.0f) { return collide_point(v2, a.radius, center, b.radius, n, margin, feature_id(next, 0)); }
    }
    return point_manifold(center - separation * n, a.radius, center, b.radius, n, separation, feature_id(face, 0));
}

}  // namespace islet::detail
