// What the masses of all shapes share.
#pragma once

#include "../math/inlining.hpp"
#include "islet/geometry.hpp"

namespace islet::detail {

ISLET_SHARED bool is_density(float density) { return density >= 0 && is_finite(density); }

/// A density may be finite and still too much for the shape: no mass rather than an infinite one.
ISLET_SHARED MassData checked(const MassData& m) { return is_finite(m.mass) && is_finite(m.inertia) ? m : MassData{}; }

}  // namespace islet::detail
