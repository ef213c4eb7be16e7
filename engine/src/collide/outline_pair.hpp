// Pairs with straight faces: separating axes first, then the faces that look at each other are clipped, then corners if faces do not do.
//
// For two convex outlines every face normal gives a lower bound of the distance; the greatest of them picks the reference face. If the
// face it looks at, clipped to it, comes as close as that bound, face contact is the answer. Otherwise two corners are closest, and GJK
// says which. (The order of these steps, and that rounded and speculative contacts need the last one, is learnt from Box2D 3.)
#pragma once

#include "../collide/distance.hpp"
#include "../collide/outline.hpp"
#include "../math/lanes.hpp"

namespace islet::detail {

struct Axis {
    float separation = 0;  // m, between the cores
    std::uint32_t face = 0;
};

// The face of p that q is furthest in front of.
template <class P, class Q>
ISLET_COPIED Axis best_axis(const P& p, const Q& q) {
    Axis best = {-3e38f, 0};
    for (std::uint32_t i = 0; i < p.count; ++i) {
        const Vec2 n = p.normals[i];
        float nearest = dot(n, q.vertices[0]);
        for (std::uint32_t j = 1; j < q.count; ++j) { nearest = min(nearest, dot(n, q.vertices[j])); }
        const float separation = nearest - dot(n, p.vertices[i]);
        best.face = separation > best.separation ? i : best.face;
        best.separation = max(separation, best.separation);
    }
    return best;
}

#if ISLET_MAX_LANES > 1
/// Four vectors as columns.
struct FourPoints {
    f4 x, y;

    ISLET_LANE explicit FourPoints(const Vec2* points) {
        const f4 first = load4(&points[0].x), last = load4(&points[2].x);
        x = __builtin_shufflevector(first, last, 0, 2, 4, 6);
        y = __builtin_shufflevector(first, last, 1, 3, 5, 7);
    }
};

// best_axis for four faces at once. (Those behind the last one count for nothing.)
template <class Q>
ISLET_LANE Axis best_axis(const Outline& p, const Q& q) {
    static_assert(max_polygon_vertices % 4 == 0);
    float separations[max_polygon_vertices];
    for (std::uint32_t i = 0; i < p.count; i += 4) {
        const FourPoints n(p.normals + i), v(p.vertices + i);
        const auto along = [&](Vec2 point) ISLET_INLINED_LAMBDA { return n.x * Lane4::splat(point.x) + n.y * Lane4::splat(point.y); };
        f4 nearest = along(q.vertices[0]);
        for (std::uint32_t j = 1; j < q.count; ++j) nearest = min(nearest, along(q.vertices[j]));
        store4(separations + i, nearest - (n.x * v.x + n.y * v.y));
    }
    Axis best = {-3e38f, 0};
    for (std::uint32_t i = 0; i < p.count; ++i) {
        best.face = separations[i] > best.separation ? i : best.face;
        best.separation = max(separations[i], best.separation);
    }
    return best;
}
#endif

// Overlapping outlines whose faces miss each other: the deepest corner alone.
template <class Reference, class Other>
inline Manifold deepest_corner(const Reference& reference, const Axis& axis, const Other& other, bool reference_is_b, Vec2 origin) {
    const Face face = face_of(reference, axis.face);
    const std::uint32_t deepest = corner_against(other, face.normal);
    const Vec2 corner = other.vertices[deepest] + origin;
    const Vec2 foot = corner - axis.separation * face.normal;
    if (reference_is_b) {
        return point_manifold(corner, other.radius, foot, reference.radius, -face.normal, axis.separation, feature_id(deepest, face.index1));
    }
    return point_manifold(foot, reference.radius, corner, other.radius, face.normal, axis.separation, feature_id(face.index1, deepest));
}

template <class A, class B>
ISLET_COPIED Manifold collide_cores(const A& a, const B& b, Vec2 origin, float margin) {
    const float radii = a.radius + b.radius;
    const float limit = margin + radii;
    const Axis axis_a = best_axis(a, b);
    if (axis_a.separation > limit) { return none_within(axis_a.separation - radii); }
    const Axis axis_b = best_axis(b, a);
    if (axis_b.separation > limit) { return none_within(axis_b.separation - radii); }

    // A is the reference unless B is clearly better.
    const bool reference_is_b = axis_b.separation > axis_a.separation + separation_tie;
    const Face face = reference_is_b ? face_of(b, axis_b.face) : face_of(a, axis_a.face);
    const Face other = reference_is_b ? face_of(a, face_against(a, face.normal)) : face_of(b, face_against(b, face.normal));
    const Manifold clipped = clip_faces(face, other, reference_is_b, origin, margin);

    // No clipped point can be closer than the best axis says, and none needs to be.
    const float bound = max(axis_a.separation, axis_b.separation);
    if (clipped.count > 0 && (bound <= separation_tie || least_separation(clipped) <= bound - radii + separation_tie)) { return clipped; }

    const DistanceResult near = core_distance(a.vertices, a.count, b.vertices, b.count);
    if (near.distance <= 1e-5f) {  // m; overlapping, or too close for a direction between corners
        if (clipped.count > 0) { return clipped; }
        return axis_b.separation > axis_a.separation ? deepest_corner(b, axis_b, a, true, origin) : deepest_corner(a, axis_a, b, false, origin);
    }
    if (clipped.count > 0 && least_separation(clipped) <= near.distance - radii + separation_tie) { return clipped; }
    if (near.distance > limit) { return none_within(near.distance - radii); }
    return point_manifold(near.point_a + origin, a.radius, near.point_b + origin, b.radius, near.normal, near.distance,
                          feature_id(near.index_a[0], near.index_b[0]));
}

}  // namespace islet::detail
