// core_distance (collide/distance.hpp) in lanes: how far convex outlines are apart, and where, by the same arithmetic, operation by operation.
#pragma once

#include "../collide/lane_outlines.hpp"

namespace islet::detail {

/// What core_distance finds, of cores that neither touch nor overlap.
template <class L>
struct LaneDistances {
    LaneVec<typename L::F> point_a, point_b;  // m, the points that are nearest
    LaneVec<typename L::F> normal;            // unit, from A to B
    typename L::F distance;                   // m
    LaneInts<L> id;                           // feature_id of the first corners
    std::uint32_t others = 0;                 // a bit for each pair whose cores touch or overlap
};

/// A corner of the difference of two cores, B - A.
template <class L>
struct LaneCorner {
    LaneVec<typename L::F> a, b, w;
    LaneInts<L> index_a, index_b;
};
template <class L>
ISLET_LANE LaneCorner<L> select(LaneInts<L> mask, const LaneCorner<L>& p, const LaneCorner<L>& q) {
    return {select(mask, p.a, q.a), select(mask, p.b, q.b), select(mask, p.w, q.w), pick(mask, p.index_a, q.index_a), pick(mask, p.index_b, q.index_b)};
}

/// The corner (p twice) or edge that is closest to the origin.
template <class L>
struct LaneFeature {
    LaneCorner<L> p, q;
    LaneInts<L> is_edge;
    typename L::F squared;  // m^2, of the distance
};
template <class L>
ISLET_LANE LaneFeature<L> select(LaneInts<L> mask, const LaneFeature<L>& f, const LaneFeature<L>& g) {
    return {select<L>(mask, f.p, g.p), select<L>(mask, f.q, g.q), pick(mask, f.is_edge, g.is_edge), select(mask, f.squared, g.squared)};
}

/// edge_feature
template <class L>
ISLET_LANE LaneFeature<L> edge_feature(const LaneCorner<L>& p, const LaneCorner<L>& q) {
    using F = typename L::F;
    const LaneVec<F> edge = q.w - p.w;
    const F along = -dot(p.w, edge), whole = dot(edge, edge), area = cross(p.w, q.w);
    const LaneInts<L> at_p = along <= L::splat(0), at_q = ~at_p & (along >= whole);
    const F squared = select(at_p, dot(p.w, p.w), select(at_q, dot(q.w, q.w), area * area / whole));
    return {select<L>(at_q, q, p), select<L>(at_p, p, q), ~(at_p | at_q), squared};
}

/// towards_origin
template <class L>
ISLET_LANE LaneVec<typename L::F> towards_origin(const LaneFeature<L>& f) {
    using Vec = LaneVec<typename L::F>;
    const Vec edge = f.q.w - f.p.w, left = left_perp(edge), right = {edge.y, -edge.x};
    return select(f.is_edge, select(cross(f.p.w, f.q.w) > L::splat(0), left, right), Vec{-f.p.w.x, -f.p.w.y});
}

/// support: the corner of an outline that is furthest along a direction.
template <class L>
ISLET_LANE void furthest(const LaneOutline<L>& o, LaneVec<typename L::F> direction, LaneVec<typename L::F>& corner, LaneInts<L>& index) {
    corner = o.vertices[0];
    index = LaneInts<L>{};
    typename L::F best = dot(corner, direction);
    for (std::uint32_t i = 1; i < o.most; ++i) {
        const typename L::F value = dot(o.vertices[i], direction);
        const LaneInts<L> better = value > best;
        best = select(better, value, best);
        corner = select(better, o.vertices[i], corner);
        index = pick(better, LaneInts<L>{} + static_cast<std::int32_t>(i), index);
    }
}

/// core_distance, of those pairs whose bits are in `open`.
template <class L>
ISLET_LANE LaneDistances<L> core_distances(const LaneOutline<L>& a, const LaneOutline<L>& b, std::uint32_t open) {
    using F = typename L::F;
    using I = LaneInts<L>;
    using Vec = LaneVec<F>;
    constexpr std::uint32_t most_passes = 24;
    const F zero = L::splat(0);
    const LaneCorner<L> start = {a.vertices[0], b.vertices[0], b.vertices[0] - a.vertices[0], I{}, I{}};
    LaneFeature<L> nearest = {start, start, I{}, dot(start.w, start.w)};
    LaneDistances<L> out;
    for (std::uint32_t pass = 0; pass < most_passes; ++pass) {
        const std::uint32_t touching = open & L::bits(nearest.squared <= L::splat(1e-16f));
        out.others |= touching;
        open &= ~touching;
        const Vec towards = towards_origin(nearest);
        LaneCorner<L> next;
        furthest(a, Vec{-towards.x, -towards.y}, next.a, next.index_a);
        furthest(b, towards, next.b, next.index_b);
        next.w = next.b - next.a;
        open &= ~L::bits(((next.index_a == nearest.p.index_a) & (next.index_b == nearest.p.index_b)) |
                         ((next.index_a == nearest.q.index_a) & (next.index_b == nearest.q.index_b)));
        if (open == 0) break;
        const F ab = cross(nearest.p.w, nearest.q.w), bc = cross(nearest.q.w, next.w), ca = cross(next.w, nearest.p.w);
        const std::uint32_t overlap = open & L::bits(nearest.is_edge & (((ab > zero) & (bc > zero) & (ca > zero)) | ((ab < zero) & (bc < zero) & (ca < zero))));
        out.others |= overlap;
        open &= ~overlap;
        LaneFeature<L> closer = edge_feature(nearest.p, next);
        const LaneFeature<L> other = edge_feature(nearest.q, next);
        closer = select<L>(nearest.is_edge & (other.squared < closer.squared), other, closer);
        const I stands_out = dot(next.w - nearest.p.w, towards) > L::splat(1e-6f) * (dot(towards, towards) + dot(next.w, next.w));
        open &= L::bits((~nearest.is_edge & closer.is_edge) | stands_out | (closer.squared < nearest.squared));
        if (open == 0) break;
        nearest = select<L>(L::mask(open), closer, nearest);
    }
    const Vec edge = nearest.q.w - nearest.p.w;
    const F length = dot(edge, edge), share = -dot(nearest.p.w, edge) / length, one = L::splat(1);
    const F t = select(nearest.is_edge, select(share < zero, zero, select(share > one, one, share)), zero);
    out.point_a = nearest.p.a + t * (nearest.q.a - nearest.p.a);
    out.point_b = nearest.p.b + t * (nearest.q.b - nearest.p.b);
    const Vec across = out.point_b - out.point_a, back = towards_origin(nearest);
    const Vec n = select(nearest.is_edge & (length > dot(across, across)), Vec{-back.x, -back.y}, across);
    out.normal = (one / L::sqrt(dot(n, n))) * n;
    out.distance = max(zero, dot(across, out.normal));
    out.id = ids_of(nearest.p.index_a, nearest.p.index_b);
    return out;
}

}  // namespace islet::detail
