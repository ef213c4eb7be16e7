// Floors made of pieces: contacts with edges that lie between two pieces are no contacts.
#pragma once

#include "collide/manifold.hpp"
#include "memory/core.hpp"

namespace islet::detail {

/// Makes the manifold of two shapes anew if one of them is a polygon that lies flush beside others which the other shape's body is near, and all its points
/// are on an edge or a corner that those cover: along the best face that is not covered, or without points. `b_in_a` and `margin` (m) are as the manifold was made.
void mend_inner_edges(const Core& core, const Contact& contact, const Transform& b_in_a, float margin, Manifold& manifold);

}  // namespace islet::detail
