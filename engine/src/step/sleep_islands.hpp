// Islands that have been at rest for long enough fall asleep.
#pragma once

#include "../data/core.hpp"
#include "../island/batches.hpp"
#include "../math/scalar.hpp"

namespace islet::detail {

/// An upper bound of the speed of a point on the body, m/s.
inline float speed_of(const Core& core, std::uint32_t body) {
    return length_inline(core.motions[body].v) + abs(core.motions[body].w) * core.poses[body].max_extent;
}

/// Says which islands have just come to rest, and puts those to sleep that have been at rest for longer. `rested`: by slot, how long each body has been at
/// rest, s. Returns whether any body fell asleep.
bool sleep_islands(Core& core, const Plan& plan, const float* rested, Arena arena, float dt);

}  // namespace islet::detail
