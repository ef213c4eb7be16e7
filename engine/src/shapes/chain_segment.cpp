// One segment of a chain against circles and convex outlines: solid on one side, and smooth across the corners to its neighbours.
//
// A body sliding over segments that meet flush must not feel the corners between them. So a contact may only use a normal that the surface
// really has there: between its own normal and that of the neighbour at an outer (convex) corner, its own alone at a flat or inner one.
// Other normals are left to the neighbour, or replaced by the segment's own. (The idea of sorting normals by the Gauss map of the corner,
// and of comparing with the neighbours' axes in overlap, is from Erin Catto, "Ghost collisions", box2d.org, 2020.)
//
//          n0  \   | n1
//     leave to  \  |          convex corner p1, outward up: normals between n0 and n1 are the corner's own;
//     neighbour  \ | segment  left of n0 they belong to the neighbour.
//     ---------.__\|_________
//     ghost1     p1     ->  p2   (drawn mirrored: the outward side is on the right of p1 -> p2)
#include "../exact.hpp"

#include "../collide/distance.hpp"
#include "../collide/outline.hpp"
#include "../geometry/convex.hpp"
#include "../math/inlining.hpp"
#include "../shapes/manifolds.hpp"
#include "islet/query.hpp"

namespace islet {

using namespace detail;

namespace {

// A chain that goes on straight beyond its end has a ghost that mirrors one end of the last segment at the other, so it may lie beyond max_position.
ISLET_SHARED bool is_ghost(Vec2 a) { return detail::in_range(0.25f * a); }

// Corners and normals closer to straight than this (sine of the angle) count as straight.
constexpr float straight = 0.01f;

// A segment relative to p1, so p1 = 0 and p2 = `end`.
struct LocalSegment {
    Vec2 end;
    Vec2 edge;     // unit, p1 to p2
    Vec2 normal;   // its own
    Vec2 normal0;  // of the neighbour at p1 if that corner is convex, else its own again
    Vec2 normal2;  // the same at p2
    bool convex1 = false;
    bool convex2 = false;
};

LocalSegment local_segment(const ChainSegment& s) {
    const Vec2 p1 = s.segment.point1;
    const Vec2 p2 = s.segment.point2;
    LocalSegment k;
    k.end = p2 - p1;
    k.edge = direction_of(k.end, {1, 0}).unit;
    k.normal = right_perp(k.edge);
    const Vec2 edge0 = direction_of(p1 - s.ghost1, k.edge).unit;
    const Vec2 edge2 = direction_of(s.ghost2 - p2, k.edge).unit;
    k.convex1 = cross(edge0, k.edge) >= straight;
    k.convex2 = cross(k.edge, edge2) >= straight;
    k.normal0 = k.convex1 ? right_perp(edge0) : k.normal;
    k.normal2 = k.convex2 ? right_perp(edge2) : k.normal;
    return k;
}

enum class Verdict { own, neighbours, replace };

// Whose is a contact whose normal (from the segment outwards) is n?
Verdict judge(const LocalSegment& k, Vec2 n) {
    if (dot(n, k.edge) <= 0.0f) {
        if (!k.convex1) { return Verdict::replace; }
        return cross(n, k.normal0) > straight ? Verdict::neighbours : Verdict::own;
    }
    if (!k.convex2) { return Verdict::replace; }
    return cross(k.normal2, n) > straight ? Verdict::neighbours : Verdict::own;
}

ISLET_SHARED float least_along(const Outline& o, Vec2 n) { return dot(n, o.vertices[corner_against(o, n)]); }

Manifold contact_on_segment(const LocalSegment& k, const Outline& b, Vec2 origin, float margin) {
    const Face face = {{}, k.end, k.normal, 0, 0, 1};
    return clip_faces(face, face_of(b, face_against(b, k.normal)), false, origin, margin);
}

// A face of B against a corner of the segment, unless the neighbour lies closer to that face.
Manifold contact_on_face(const LocalSegment& k, const Outline& b, std::uint32_t index, Vec2 origin, float margin) {
    const Face face = face_of(b, index);
    const Vec2 beside = dot(face.normal, k.end) > 0.0f ? k.normal0 : k.normal2;
    if (dot(beside, face.normal) < dot(k.normal, face.normal)) { return {}; }
    return clip_faces(face, {{}, k.end, k.normal, 0, 0, 1}, true, origin, margin);
}

// B is clear of the segment: closest features.
Manifold collide_apart(const LocalSegment& k, const Outline& b, const DistanceResult& near, Vec2 origin, float margin) {
    const bool on_edge = near.count == 2 && near.index_a[0] != near.index_a[1];
    if (on_edge) { return contact_on_segment(k, b, origin, margin); }
    const bool b_edge = near.count == 2;
    std::uint32_t face = 0;
    Vec2 n = near.normal;
    if (b_edge) {
        face = face_against(b, n);
        n = -b.normals[face];
    }
    switch (judge(k, n)) {
        case Verdict::neighbours: return {};
        case Verdict::replace: return contact_on_segment(k, b, origin, margin);
        case Verdict::own: break;
    }
    if (b_edge) { return contact_on_face(k, b, face, origin, margin); }
    if (near.distance - b.radius > margin) { return {}; }
    return point_manifold(near.point_a + origin, 0, near.point_b + origin, b.radius, n, near.distance, feature_id(near.index_a[0], near.index_b[0]));
}

// B's core touches or crosses the segment: least overlap among the segment's normal, its convex neighbours' and those of B it may use.
Manifold collide_overlapping(const LocalSegment& k, const Outline& b, float segment_gap, Vec2 origin, float margin) {
    const float gap0 = k.convex1 ? least_along(b, k.normal0) : segment_gap;
    const float gap2 = k.convex2 ? least_along(b, k.normal2) - dot(k.normal2, k.end) : segment_gap;
    const float surface_gap = max(segment_gap, max(gap0, gap2));

    float face_gap = -3e38f;
    std::uint32_t face = 0;
    for (std::uint32_t i = 0; i < b.count; ++i) {
        const Vec2 n = b.normals[i];
        if (judge(k, -n) == Verdict::own) {
            const float gap = min(0.0f, dot(n, k.end)) - dot(n, b.vertices[i]);
            face = gap > face_gap ? i : face;
            face_gap = max(gap, face_gap);
        }
    }
    if (face_gap > surface_gap + separation_tie) { return contact_on_face(k, b, face, origin, margin); }
    if (surface_gap > segment_gap) {
        return {};  // the neighbour's
    }
    return contact_on_segment(k, b, origin, margin);
}

Manifold collide_segment(const LocalSegment& k, const Outline& b, Vec2 centroid, Vec2 origin, float margin) {
    // One-sided: behind the segment and, at convex corners, behind the neighbours too.
    const bool behind = dot(k.normal, centroid) < 0.0f;
    const bool behind0 = !k.convex1 || dot(k.normal0, centroid) < 0.0f;
    const bool behind2 = !k.convex2 || dot(k.normal2, centroid - k.end) < 0.0f;
    if (behind && behind0 && behind2) { return {}; }
    const Vec2 lowest = b.vertices[corner_against(b, k.normal)];
    const float segment_gap = dot(lowest, k.normal);
    const float limit = margin + b.radius;
    if (segment_gap > limit) { return {}; }
    // Between flat and inner corners every normal but the segment's own is replaced by it.
    if (!k.convex1 && !k.convex2) { return contact_on_segment(k, b, origin, margin); }
    // A lowest corner over the segment itself, at its height, is closest to it or just through it: no need to search.
    const float along = dot(lowest, k.edge);
    if (!behind && along > 0.0f && along < dot(k.end, k.edge) && segment_gap > -speculative_distance) {
        return segment_gap > separation_tie ? contact_on_segment(k, b, origin, margin) : collide_overlapping(k, b, segment_gap, origin, margin);
    }
    const Vec2 core[2] = {{}, k.end};
    const DistanceResult near = core_distance(core, 2, b.vertices, b.count);
    if (near.distance > limit) { return {}; }
    if (!behind && near.distance > separation_tie) { return collide_apart(k, b, near, origin, margin); }
    return collide_overlapping(k, b, segment_gap, origin, margin);
}

}  // namespace

bool is_valid(const ChainSegment& s) { return is_valid(s.segment) && is_ghost(s.ghost1) && is_ghost(s.ghost2); }

ShapeProxy make_proxy(const ChainSegment& s) {
    ShapeProxy proxy = make_proxy(s.segment);
    proxy.one_sided = true;
    return proxy;
}

namespace detail {

Manifold collide(const ChainSegment& a, const Circle& b, const Transform& b_in_a, float margin) {
    const Vec2 center = transform_point(b_in_a, b.center);
    const Vec2 p1 = a.segment.point1;
    const Vec2 p2 = a.segment.point2;
    const Vec2 edge = p2 - p1;
    if (dot(right_perp(edge), center - p1) < 0.0f) {
        return {};  // behind
    }

    // The segment owns what lies above it, and beyond its ends what does not lie above the neighbour.
    Vec2 on_segment;
    std::uint32_t feature = 0;
    const float along = dot(center - p1, edge);
    const float whole = length_squared(edge);
    if (along <= 0.0f) {
        if (dot(center - p1, p1 - a.ghost1) <= 0.0f) { return {}; }
        on_segment = p1;
    } else if (along >= whole) {
        if (dot(center - p2, a.ghost2 - p2) > 0.0f) { return {}; }
        on_segment = p2;
        feature = 1;
    } else {
        on_segment = p1 + (along / whole) * edge;
    }
    const Vec2 between = center - on_segment;
    const float limit = margin + b.radius;
    if (length_squared(between) > limit * limit) { return {}; }
    const Direction d = direction_of(between, right_perp(direction_of(edge, {1, 0}).unit));
    return point_manifold(on_segment, 0, center, b.radius, d.unit, d.length, feature_id(feature, 0));
}

Manifold collide(const ChainSegment& a, const Capsule& b, const Transform& b_in_a, float margin) {
    const Vec2 origin = a.segment.point1;
    const Transform t = {b_in_a.p - origin, b_in_a.q};
    const Vec2 p1 = transform_point(t, b.point1);
    const Vec2 p2 = transform_point(t, b.point2);
    return collide_segment(local_segment(a), outline_of<Outline>(p1, p2, b.radius), 0.5f * (p1 + p2), origin, margin);
}

Manifold collide(const ChainSegment& a, const Polygon& b, const Transform& b_in_a, float margin) {
    const Vec2 origin = a.segment.point1;
    const Transform t = {b_in_a.p - origin, b_in_a.q};
    return collide_segment(local_segment(a), outline_of(b, b_in_a, origin), transform_point(t, b.centroid), origin, margin);
}

}  // namespace detail

}  // namespace islet
