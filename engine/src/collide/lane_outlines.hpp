// Pairs of shapes in lanes: their geometries as columns, and the outlines of polygons and capsules.
#pragma once

#include <cstddef>

#include "../collide/manifold.hpp"
#include "../data/records.hpp"
#include "../math/lane_vec.hpp"

namespace islet::detail {

/// The types of shapes A and B.
enum class PairKind : std::uint8_t { boxes, polygons, polygon_capsule, capsules, polygon_circle, capsule_circle, circles };
inline constexpr std::uint32_t pair_kinds = 7;

/// Pairs of one kind, as many as there are lanes at most.
struct LanePairs {
    std::uint32_t contact[max_block_lanes];
    std::uint32_t geometry_a[max_block_lanes], geometry_b[max_block_lanes];
};

/// Whole numbers, or masks, in lanes.
template <class L>
using LaneInts = decltype(typename L::F{} < typename L::F{});

template <class I>
ISLET_LANE I pick(I mask, I a, I b) {
    return (mask & a) | (~mask & b);
}
template <class I>
ISLET_LANE I ids_of(I index_a, I index_b) {  // feature_id
    return (index_a << 8) | index_b;
}

/// What all kinds are asked: the shapes' geometries, where B's body is in A's (turn: cosine and sine; m), and how far apart points may be (m).
template <class L>
struct LaneStands {
    const float* geometries;
    const std::uint32_t *a, *b;
    LaneVec<typename L::F> turn, to;
    typename L::F margin;

    ISLET_LANE LaneVec<typename L::F> place(LaneVec<typename L::F> in_b) const { return turned_in_lanes(turn, in_b) + to; }  // transform_point
};

/// Four words of each geometry.
template <class L>
struct LaneWords {
    typename L::template Columns<4> columns;

    ISLET_LANE LaneWords(const float* geometries, const std::uint32_t* which, std::size_t first) {
        L::template gather4<sizeof(Geometry) / 4>(geometries + first, which, columns);
    }
    ISLET_LANE LaneVec<typename L::F> first() const { return {columns[0], columns[1]}; }
    ISLET_LANE LaneVec<typename L::F> second() const { return {columns[2], columns[3]}; }
};
inline constexpr std::size_t circle_words = offsetof(Geometry, circle) / 4;  // centre, radius
inline constexpr std::size_t capsule_words = offsetof(Geometry, capsule) / 4;
inline constexpr std::size_t polygon_words = offsetof(Geometry, polygon) / 4;
inline constexpr std::size_t normal_words = polygon_words + offsetof(Polygon, normals) / 4;
inline constexpr std::size_t rest_words = polygon_words + offsetof(Polygon, centroid) / 4;  // centroid, radius, count
static_assert(offsetof(Capsule, radius) == 2 * sizeof(Vec2) && offsetof(Circle, radius) == sizeof(Vec2));
static_assert(offsetof(Polygon, vertices) == 0 && offsetof(Polygon, count) == offsetof(Polygon, centroid) + 12);

/// direction_of
template <class L>
struct LaneDirections {
    LaneVec<typename L::F> unit;
    typename L::F length;

    ISLET_LANE LaneDirections(LaneVec<typename L::F> v, LaneVec<typename L::F> fallback) {
        const typename L::F squared = dot(v, v);
        length = L::sqrt(squared);
        unit = select(squared < L::splat(1e-14f), fallback, (L::splat(1.0f) / length) * v);
    }
};

/// OutlineOf: behind the last corner stands the first one again, up to `most` corners.
template <class L>
struct LaneOutline {
    LaneVec<typename L::F> vertices[max_polygon_vertices], normals[max_polygon_vertices];
    LaneInts<L> count;
    typename L::F radius;
    std::uint32_t most = 0;

    ISLET_LANE void pad(std::uint32_t from, std::uint32_t to) {
        for (std::uint32_t i = from; i < to; ++i) vertices[i] = vertices[0], normals[i] = normals[0];
    }
};

/// The corners and normals of polygons as they stand in their bodies.
template <class L>
ISLET_LANE void load_polygons(const float* geometries, const std::uint32_t* which, LaneOutline<L>& o) {
    const LaneWords<L> rest(geometries, which, rest_words);
    o.radius = rest.columns[2];
    o.count = reinterpret_cast<LaneInts<L>>(rest.columns[3]);
    o.most = 3;
    while (o.most < max_polygon_vertices && L::bits(o.count > static_cast<std::int32_t>(o.most)) != 0) ++o.most;
    for (std::uint32_t i = 0; i < o.most; i += 2) {
        const LaneWords<L> vertices(geometries, which, polygon_words + 2 * i), normals(geometries, which, normal_words + 2 * i);
        o.vertices[i] = vertices.first();
        o.vertices[i + 1] = vertices.second();
        o.normals[i] = normals.first();
        o.normals[i + 1] = normals.second();
    }
    for (std::uint32_t i = 3; i < o.most; ++i) {
        const LaneInts<L> is = o.count > static_cast<std::int32_t>(i);
        o.vertices[i] = select(is, o.vertices[i], o.vertices[0]);
        o.normals[i] = select(is, o.normals[i], o.normals[0]);
    }
}

/// outline_of(p, t, origin): polygons of B's body in frame A.
template <class L>
ISLET_LANE void place_polygons(const LaneStands<L>& s, LaneVec<typename L::F> origin, LaneOutline<L>& o) {
    using Vec = LaneVec<typename L::F>;
    const Vec base = o.vertices[0], moved = turned_in_lanes(s.turn, base) + (s.to - origin);
    for (std::uint32_t i = 0; i < o.most; ++i) {
        o.vertices[i] = moved + turned_in_lanes(s.turn, o.vertices[i] - base);
        o.normals[i] = turned_in_lanes(s.turn, o.normals[i]);
    }
}

/// outline_of(p1, p2, radius)
template <class L>
ISLET_LANE void outline_lines(LaneVec<typename L::F> p1, LaneVec<typename L::F> p2, typename L::F radius, LaneOutline<L>& o) {
    o.count = LaneInts<L>{} + 2;
    o.most = 2;
    o.radius = radius;
    o.vertices[0] = p1;
    o.vertices[1] = p2;
    const LaneVec<typename L::F> unit = LaneDirections<L>(p2 - p1, {L::splat(1), L::splat(0)}).unit;
    o.normals[0] = {unit.y, -unit.x};
    o.normals[1] = {-o.normals[0].x, -o.normals[0].y};
}

}  // namespace islet::detail
