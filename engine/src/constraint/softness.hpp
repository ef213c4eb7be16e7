// Soft constraints: a spring and damper integrated implicitly, as scales on a row's effective mass and accumulated impulse.
//
//     delta = -m (mass_scale (Cdot + rate C)) - impulse_scale lambda
//
// With omega = 2 pi hertz, z the damping ratio and h the substep: a1 = 2 z + h omega, a2 = h omega a1,
//     rate = omega / a1,  mass_scale = a2 / (1 + a2),  impulse_scale = 1 / (1 + a2).
// Stable for any stiffness; in the limit rate = 1 / h, mass_scale = 1, impulse_scale = 0: rigid. (Catto, "Soft Constraints", GDC 2011.)
#pragma once

#include "islet/math.hpp"

namespace islet::detail {

struct Softness {
    float rate = 0;           // 1/s
    float mass_scale = 1;
    float impulse_scale = 0;
};

inline Softness make_soft(float hertz, float damping_ratio, float h) {
    const float omega = 2.0f * pi * hertz;
    const float a1 = 2.0f * damping_ratio + h * omega;
    const float a2 = h * omega * a1;
    const float a3 = 1.0f / (1.0f + a2);
    if (!(a1 > 0)) return {0, 0, 0};  // no spring at all
    return {omega / a1, a2 * a3, a3};
}

}  // namespace islet::detail
