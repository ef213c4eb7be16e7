// Floors made of pieces: a contact with an edge between two pieces is no contact.
#pragma once

#include "../collide/manifold.hpp"
#include "../data/core.hpp"

namespace islet::detail {

inline constexpr float floor_mass = 4;  // a dynamic body is a floor for what has a quarter of its mass or less: in piles none is

/// True if the pieces of a moving body may be a floor for another moving body, by the poses of both.
inline bool may_bear(const Body& body, const Pose& own, const Pose& other) {
    return body.shape_count > 1 && is_positive(other.inv_mass) && other.inv_mass >= floor_mass * own.inv_mass;
}

/// Makes the manifold of two shapes anew if its nearest points are on a side or a corner that neighbours cover. One of the shapes must be a piece of floor: a
/// polygon, a segment or a capsule. Neighbours are pieces and chain segments flush beside it that the other shape's body is near. The new manifold is along
/// the best face that is not covered, or has no points. `b_in_a` and `margin` (m) are those with which the manifold was made.
void mend_inner_edges(const Core& core, const Contact& contact, const Transform& b_in_a, float margin, Manifold& manifold);

}  // namespace islet::detail
