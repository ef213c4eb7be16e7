// Questions on boxes that stand in many places.
#pragma once

#include "islet/math.hpp"
#include "math/copies.hpp"

namespace islet::detail {

/// overlaps(), of which a build for size keeps one copy.
ISLET_SHARED bool meet(const Aabb& a, const Aabb& b) { return overlaps(a, b); }

}  // namespace islet::detail
