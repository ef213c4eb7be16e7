// Floors made of pieces: a contact with an edge between two pieces is no contact.
#pragma once

#include "../collide/manifold.hpp"
#include "../data/core.hpp"

namespace islet::detail {

/// Makes the manifold of two shapes anew if its nearest points are on a side or a corner that neighbours cover. One of the shapes must be a piece of floor: a
/// polygon, a segment or a capsule. Neighbours are pieces and chain segments flush beside it that the other shape's body is near. The new manifold is along
/// the best face that is not covered, or has no points. `b_in_a` and `margin` (m) are those with which the manifold was made.
void mend_inner_edges(const Core& core, const Contact& contact, const Transform& b_in_a, float margin, Manifold& manifold);

}  // namespace islet::detail
