// Distance between convex cores after Gilbert, Johnson and Keerthi (1988), on at most 8 points each.
//
// The vectors w = b - a from points of A to points of B fill a convex polygon, and the distance is that of the origin from it. We walk
// towards the origin: hold the vertex or edge of that polygon found closest so far, look up the corner furthest in the direction of the
// origin, and keep whichever edge to the new corner comes closer. The walk ends when nothing comes closer, or when a triangle holds the
// origin: the cores overlap.
//
//        w1 ---- new          d: from the edge w0 w1 towards the origin o
//        |      /
//        | d-> o              here o is inside w0 w1 new: overlap
//        w0
#include "../exact.hpp"

#include "../collide/distance.hpp"

#include "../math/inlining.hpp"
#include "../math/scalar.hpp"

namespace islet::detail {
namespace {

// Each pass strictly shortens the distance, so no corner of the at most 16-sided polygon comes twice; the bound is for safety only.
constexpr std::uint32_t max_iterations = 24;

struct Corner {
    Vec2 w;  // b - a
    std::uint8_t index_a = 0;
    std::uint8_t index_b = 0;
};

// The vertex (count 1) or edge (count 2) closest to the origin.
struct Feature {
    Corner corner[2];
    std::uint32_t count = 0;
    float distance_squared = 0;
};

ISLET_SHARED std::uint8_t support(const Vec2* points, std::uint32_t count, Vec2 direction) {
    std::uint32_t best = 0;
    float best_value = dot(points[0], direction);
    for (std::uint32_t i = 1; i < count; ++i) {
        const float value = dot(points[i], direction);
        if (value > best_value) {
            best_value = value;
            best = i;
        }
    }
    return static_cast<std::uint8_t>(best);
}

ISLET_SHARED Feature vertex_feature(const Corner& p) { return {{p, p}, 1, length_squared(p.w)}; }

// What of the segment p-q is closest to the origin.
Feature edge_feature(const Corner& p, const Corner& q) {
    const Vec2 edge = q.w - p.w;
    const float along = -dot(p.w, edge);
    const float whole = dot(edge, edge);
    if (along <= 0.0f) { return vertex_feature(p); }
    if (along >= whole) { return vertex_feature(q); }
    const float area = cross(p.w, q.w);
    return {{p, q}, 2, area * area / whole};
}

bool triangle_holds_origin(Vec2 p, Vec2 q, Vec2 r) {
    const float a = cross(p, q);
    const float b = cross(q, r);
    const float c = cross(r, p);
    return (a > 0.0f && b > 0.0f && c > 0.0f) || (a < 0.0f && b < 0.0f && c < 0.0f);
}

// From the feature towards the origin, not unit.
Vec2 towards_origin(const Feature& f) {
    if (f.count == 1) { return -f.corner[0].w; }
    const Vec2 edge = f.corner[1].w - f.corner[0].w;
    return cross(f.corner[0].w, f.corner[1].w) > 0.0f ? left_perp(edge) : right_perp(edge);
}

bool is_among(const Corner& c, const Feature& f) {
    return (c.index_a == f.corner[0].index_a && c.index_b == f.corner[0].index_b) || (c.index_a == f.corner[1].index_a && c.index_b == f.corner[1].index_b);
}

// Where on the edge the point closest to the origin is; 0 for a vertex.
float fraction_along(const Feature& f) {
    if (f.count == 1) { return 0.0f; }
    const Vec2 edge = f.corner[1].w - f.corner[0].w;
    return clamp(-dot(f.corner[0].w, edge) / dot(edge, edge), 0.0f, 1.0f);
}

// The two cores that are searched, in one frame.
struct Cores {
    const Vec2* a;
    std::uint32_t count_a;
    const Vec2* b;
    std::uint32_t count_b;

    ISLET_SHARED Corner corner(std::uint8_t index_a, std::uint8_t index_b) const { return {b[index_b] - a[index_a], index_a, index_b}; }
    Corner furthest(Vec2 d) const { return corner(support(a, count_a, -d), support(b, count_b, d)); }

    // The feature's corners, and its points closest to the origin. Normal and distance are for cores that neither touch nor overlap.
    DistanceResult at(const Feature& f) const {
        DistanceResult result;
        result.count = f.count;
        for (std::uint32_t i = 0; i < f.count; ++i) {
            result.index_a[i] = f.corner[i].index_a;
            result.index_b[i] = f.corner[i].index_b;
        }
        const Corner& p = f.corner[0];
        const Corner& q = f.corner[1];
        const float t = fraction_along(f);
        result.point_a = lerp(a[p.index_a], a[q.index_a], t);
        result.point_b = lerp(b[p.index_b], b[q.index_b], t);
        return result;
    }

    DistanceResult separated(const Feature& f) const {
        DistanceResult result = at(f);
        // The normal comes from the longer of two vectors that lie along and across it, the one that rounding turns less.
        const Vec2 across = result.point_b - result.point_a;
        const bool edge_is_longer = f.count == 2 && length_squared(f.corner[1].w - f.corner[0].w) > length_squared(across);
        const Vec2 n = edge_is_longer ? -towards_origin(f) : across;
        result.normal = (1.0f / sqrt(length_squared(n))) * n;
        result.distance = max(0.0f, dot(across, result.normal));
        return result;
    }

    // One shared point and no direction.
    DistanceResult touching(const Feature& f) const {
        DistanceResult result = at(f);
        result.point_b = result.point_a;
        return result;
    }

    // The triangle's barycentric weights of the origin give a point that both cores contain.
    DistanceResult overlapping(const Feature& f, const Corner& third) const {
        DistanceResult result = at(f);
        result.count = 3;
        result.index_a[2] = third.index_a;
        result.index_b[2] = third.index_b;
        const float w0 = cross(f.corner[1].w, third.w);
        const float w1 = cross(third.w, f.corner[0].w);
        const float w2 = cross(f.corner[0].w, f.corner[1].w);
        const float scale = 1.0f / (w0 + w1 + w2);
        result.point_a = scale * (w0 * a[f.corner[0].index_a] + w1 * a[f.corner[1].index_a] + w2 * a[third.index_a]);
        result.point_b = result.point_a;
        return result;
    }
};

}  // namespace

DistanceResult core_distance(const Vec2* a, std::uint32_t count_a, const Vec2* b, std::uint32_t count_b) {
    // Shorter than this the direction of a vector can no longer be trusted (and its square would soon underflow).
    constexpr float touching_squared = 1e-16f;  // (1e-8 m)^2

    const Cores cores = {a, count_a, b, count_b};
    Feature nearest = vertex_feature(cores.corner(0, 0));
    for (std::uint32_t pass = 0; pass < max_iterations; ++pass) {
        if (nearest.distance_squared <= touching_squared) { return cores.touching(nearest); }
        const Vec2 towards = towards_origin(nearest);
        const Corner next = cores.furthest(towards);
        if (is_among(next, nearest)) { break; }
        Feature closer = edge_feature(nearest.corner[0], next);
        if (nearest.count == 2) {
            if (triangle_holds_origin(nearest.corner[0].w, nearest.corner[1].w, next.w)) { return cores.overlapping(nearest, next); }
            const Feature other = edge_feature(nearest.corner[1], next);
            if (other.distance_squared < closer.distance_squared) { closer = other; }
        }
        // A step from a corner to an edge that ends there always comes closer, though rounding may hide it. So does a step to a new corner that stands out of
        // the edge by more than rounding: there the edge was closest at its very end, and only the next pass comes closer.
        const bool gained_edge = nearest.count == 1 && closer.count == 2;
        const bool stands_out = dot(next.w - nearest.corner[0].w, towards) > 1e-6f * (length_squared(towards) + length_squared(next.w));
        if (!gained_edge && !stands_out && !(closer.distance_squared < nearest.distance_squared)) { break; }
        nearest = closer;
    }
    return cores.separated(nearest);
}

}  // namespace islet::detail
