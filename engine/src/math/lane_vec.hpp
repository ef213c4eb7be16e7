// Vectors of lanes.
#pragma once

#include "../math/lanes.hpp"

namespace islet::detail {

template <class F>
struct LaneVec {
    F x, y;
};

template <class F>
ISLET_LANE LaneVec<F> operator+(LaneVec<F> a, LaneVec<F> b) {
    return {a.x + b.x, a.y + b.y};
}
template <class F>
ISLET_LANE LaneVec<F> operator-(LaneVec<F> a, LaneVec<F> b) {
    return {a.x - b.x, a.y - b.y};
}
template <class F>
ISLET_LANE LaneVec<F> operator*(F s, LaneVec<F> a) {
    return {s * a.x, s * a.y};
}
template <class F>
ISLET_LANE F dot(LaneVec<F> a, LaneVec<F> b) {
    return a.x * b.x + a.y * b.y;
}
template <class F>
ISLET_LANE F cross(LaneVec<F> a, LaneVec<F> b) {
    return a.x * b.y - a.y * b.x;
}
/// w x r
template <class F>
ISLET_LANE LaneVec<F> cross(F w, LaneVec<F> r) {
    return {-w * r.y, w * r.x};
}
template <class F>
ISLET_LANE LaneVec<F> left_perp(LaneVec<F> a) {
    return {-a.y, a.x};
}
template <class F, class I>
ISLET_LANE LaneVec<F> select(I mask, LaneVec<F> a, LaneVec<F> b) {
    return {select(mask, a.x, b.x), select(mask, a.y, b.y)};
}

/// v turned by q (cosine, sine), as rotate() turns it; by the inverse of q; and the turn that leads from one to the other.
template <class F>
ISLET_LANE LaneVec<F> turned_in_lanes(LaneVec<F> q, LaneVec<F> v) {
    return {q.x * v.x - q.y * v.y, q.y * v.x + q.x * v.y};
}
template <class F>
ISLET_LANE LaneVec<F> turned_back_in_lanes(LaneVec<F> q, LaneVec<F> v) {
    return {q.x * v.x + q.y * v.y, -q.y * v.x + q.x * v.y};
}
template <class F>
ISLET_LANE LaneVec<F> turn_between(LaneVec<F> from, LaneVec<F> to) {
    return {from.x * to.x + from.y * to.y, from.x * to.y - from.y * to.x};
}

template <class L>
ISLET_LANE typename L::F clamp_lanes(typename L::F a, typename L::F lo, typename L::F hi) {
    return min(max(a, lo), hi);
}

}  // namespace islet::detail
