// What all pairs with straight faces share: a convex outline seen in frame A, and one face clipped against another.
//
//            2 ___i1____ 1        incident face, clipped to the ends of the reference face; each of the two points that remain
//         ---+-.------ .-+---     is named after the corner of either face next to it: (ref 1, inc 2) and (ref 2, inc 1).
//            1           2        The names stay when the other shape becomes the reference.
//              reference
#pragma once

#include "../collide/manifold.hpp"
#include "../math/inlining.hpp"
#include "../math/scalar.hpp"

namespace islet::detail {

// A convex core, counter-clockwise, with outward normals, grown by a radius. Capsules and segments are outlines with two corners and two
// opposite faces; `most` corners have room. Positions are relative to an origin near the contact, to keep digits.
template <std::uint32_t most>
struct OutlineOf {
    Vec2 vertices[most];
    Vec2 normals[most];
    std::uint32_t count = 0;
    float radius = 0;
};

using Outline = OutlineOf<max_polygon_vertices>;
#if defined(__OPTIMIZE_SIZE__)
using LineOutline = Outline;  // so that there is one copy of what works on outlines
#else
using LineOutline = OutlineOf<2>;
#endif

struct Face {
    Vec2 v1;
    Vec2 v2;
    Vec2 normal;
    float radius = 0;
    std::uint32_t index1 = 0;
    std::uint32_t index2 = 0;
};

inline std::uint16_t feature_id(std::uint32_t index_a, std::uint32_t index_b) { return static_cast<std::uint16_t>(index_a << 8 | index_b); }

// v / |v| and |v|; a vector too short to have a direction gets `fallback`, which must be unit.
struct Direction {
    Vec2 unit;
    float length = 0;
};

inline Direction direction_of(Vec2 v, Vec2 fallback) {
    const float squared = length_squared(v);
    const float length = sqrt(squared);
    if (squared < 1e-14f) {  // (1e-7 m)^2
        return {fallback, length};
    }
    return {(1.0f / length) * v, length};
}

template <class Shape>
ISLET_SHARED Face face_of(const Shape& o, std::uint32_t i) {
    const std::uint32_t next = i + 1 < o.count ? i + 1 : 0;
    return {o.vertices[i], o.vertices[next], o.normals[i], o.radius, i, next};
}

// The face that looks most directly against direction n.
template <class Shape>
inline std::uint32_t face_against(const Shape& o, Vec2 n) {
    std::uint32_t best = 0;
    float best_value = dot(n, o.normals[0]);
    for (std::uint32_t i = 1; i < o.count; ++i) {
        const float value = dot(n, o.normals[i]);
        best = value < best_value ? i : best;
        best_value = min(value, best_value);
    }
    return best;
}

// The corner furthest against direction n.
template <class Shape>
inline std::uint32_t corner_against(const Shape& o, Vec2 n) {
    std::uint32_t best = 0;
    float best_value = dot(n, o.vertices[0]);
    for (std::uint32_t i = 1; i < o.count; ++i) {
        const float value = dot(n, o.vertices[i]);
        best = value < best_value ? i : best;
        best_value = min(value, best_value);
    }
    return best;
}

// p relative to origin, in frame A already.
ISLET_COPIED Outline outline_of(const Polygon& p, Vec2 origin) {
    Outline o;
    o.count = p.count;
    o.radius = p.radius;
    for (std::uint32_t i = 0; i < p.count; ++i) {
        o.vertices[i] = p.vertices[i] - origin;
        o.normals[i] = p.normals[i];
    }
    return o;
}
// p moved by t, relative to origin.
Outline outline_of(const Polygon& p, const Transform& t, Vec2 origin);
// Two-cornered outline around p1-p2, already relative to the origin.
template <class Shape = LineOutline>
ISLET_COPIED Shape outline_of(Vec2 p1, Vec2 p2, float radius) {
    Shape o;
    o.count = 2;
    o.radius = radius;
    o.vertices[0] = p1;
    o.vertices[1] = p2;
    o.normals[0] = right_perp(direction_of(p2 - p1, {1, 0}).unit);
    o.normals[1] = -o.normals[0];
    return o;
}

// One point between a corner or surface point `a` of core A and `b` of core B, which are `gap` apart along the unit normal.
Manifold point_manifold(Vec2 a, float radius_a, Vec2 b, float radius_b, Vec2 normal, float gap, std::uint16_t id);

// At most one point: core point `a` of A against the circle around `center`, both in frame A.
ISLET_SHARED Manifold collide_point(Vec2 a, float radius_a, Vec2 center, float radius_b, Vec2 fallback, float margin, std::uint16_t id) {
    const Vec2 between = center - a;
    const float limit = margin + radius_a + radius_b;
    if (length_squared(between) > limit * limit) { return {}; }
    const Direction d = direction_of(between, fallback);
    return point_manifold(a, radius_a, center, radius_b, d.unit, d.length, id);
}

// Up to two points where the incident face lies over the reference face; none where they do not lie over each other.
Manifold clip_faces(const Face& reference, const Face& incident, bool reference_is_b, Vec2 origin, float margin);

// Of two boxes (is_box). It is that of other polygons (collide_cores) but for rounding, and for points between corners within linear_slop, which may be
// 0.3 mm elsewhere.
Manifold collide_boxes(const Polygon& a, const Polygon& b, const Transform& b_in_a, float margin);

}  // namespace islet::detail
