// The manifold of each pair of shapes: one function for two types, where A has the higher rank (shape_types.hpp).
#pragma once

#include "../collide/manifold.hpp"
#include "../data/features.hpp"
#include "../shapes/shape_types.hpp"

namespace islet::detail {

Manifold collide(const HalfSpace& a, const Corners& b, const Transform& b_in_a, float margin);
// Each returns the manifold of shapes a and b, where b_in_a is the pose of B's body frame in A's body frame. Points with separation above
// `margin` (m, >= speculative_distance) are left out. A segment is a capsule of radius 0.
Manifold collide(const Circle& a, const Circle& b, const Transform& b_in_a, float margin);
Manifold collide(const Capsule& a, const Circle& b, const Transform& b_in_a, float margin);
Manifold collide(const Capsule& a, const Capsule& b, const Transform& b_in_a, float margin);
Manifold collide(const Capsule& a, const Polygon& b, const Transform& b_in_a, float margin);
Manifold collide(const Polygon& a, const Circle& b, const Transform& b_in_a, float margin);
Manifold collide(const Polygon& a, const Capsule& b, const Transform& b_in_a, float margin);
Manifold collide(const Polygon& a, const Polygon& b, const Transform& b_in_a, float margin);
template <class B>
inline Manifold collide(const HalfSpace& a, const B& b, const Transform& b_in_a, float margin) {
    return collide(a, corners_of(b), b_in_a, margin);
}
template <class B>
inline Manifold collide(const Segment& a, const B& b, const Transform& b_in_a, float margin) {
    return collide(Capsule{a.point1, a.point2, 0}, b, b_in_a, margin);
}
// Chains are linked only by programs that make or load them, which ask is_valid of the same file.
ISLET_OPTIONAL Manifold collide(const ChainSegment& a, const Circle& b, const Transform& b_in_a, float margin);
ISLET_OPTIONAL Manifold collide(const ChainSegment& a, const Capsule& b, const Transform& b_in_a, float margin);
ISLET_OPTIONAL Manifold collide(const ChainSegment& a, const Polygon& b, const Transform& b_in_a, float margin);

}  // namespace islet::detail
