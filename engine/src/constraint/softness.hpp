// Soft constraints: a spring and damper integrated implicitly, as scales on a row's effective mass and accumulated impulse.
//
//     delta = -m (mass_scale (Cdot + rate C)) - impulse_scale lambda
//
// With omega = 2 pi hertz, z the damping ratio and h the substep: a1 = 2 z + h omega, a2 = h omega a1,
//     rate = omega / a1,  mass_scale = a2 / (1 + a2),  impulse_scale = 1 / (1 + a2).
// Stable for any stiffness; in the limit rate = 1 / h, mass_scale = 1, impulse_scale = 0: rigid. (Catto, "Soft Constraints", GDC 2011.)
#pragma once

#include <cstdint>

#include "../data/records.hpp"
#include "../math/inlining.hpp"
#include "../math/scalar.hpp"
#include "islet/math.hpp"

namespace islet::detail {

struct Softness {
    float rate = 0;  // 1/s
    float mass_scale = 1;
    float impulse_scale = 0;
};

inline constexpr Softness no_spring = {0, 0, 1};  // gives way at once

// Beyond these a spring is rigid, or a damper stands still, or nothing can be felt: the products would leave the range of float.
inline constexpr float stiffest = 1.0e9f;  // Hz
inline constexpr float most_damped = 1.0e9f;
inline constexpr float least_soft = 1.0e-30f;  // a2

inline Softness make_soft(float hertz, float damping_ratio, float h) {
    const float omega = 2.0f * pi * min(hertz, stiffest);
    const float a1 = 2.0f * min(damping_ratio, most_damped) + h * omega;
    const float a2 = h * omega * a1;
    if (!(a2 > least_soft)) return no_spring;
    const float a3 = 1.0f / (1.0f + a2);
    return {omega / a1, a2 * a3, a3};
}

/// A spring of a joint. With K = J M^-1 J^T, k a number that stands for it, C the error and v = dC/dt, a sweep ends where
///     with bias    scale (K delta + v) +      kick C + (1 - scale) k (lambda + delta) = 0                         `held` = lambda + delta
///     relaxing     scale (K delta + v) + late kick C + (1 - scale) k (lambda + delta - (1 - late) held) = 0
struct SplitSpring {
    float kick, scale, late;  // kick: 1/s
};

/// Half of the damper acts before the bodies move, half of it after, and the stiffness in between (Strang splitting):
///     v1 = e (v + h force k - h omega^2 C),   C' = C + h v1,   v' = e v1,   e = sqrt(1 + a^2) - a = exp(-a) + O(a^3),   a = z h omega
/// This swings with cos(turn) = cosh(a) - (h omega)^2 / 2, an error of second order; a whole damper before the move makes one of first order. Up to 10 Hz
/// and 240 substeps a second frequencies are right within 0.5 %, damping ratios of up to 1 within 0.013. A spring at rest gives way by exactly
/// force / stiffness, and under a steady force f the bodies go as fast as the damper lets them, however strong it is: v1 = h f k / (2 a), since e / (1 - e^2)
/// is 1 / (2 a). (exp(-a) itself would hold them where a is large.)
///
/// Stiffness that is taken at the start of a substep makes energy where a swing is faster than about 2 / h. From h omega = 0.5 on (19 Hz at 240 substeps) it is
/// therefore implicit in both sweeps, late = 1, which damps; below, late falls with the sixth power of h omega. `reach` is by how much omega^2 of the fastest
/// swing exceeds that of this spring alone.
inline SplitSpring split_spring(float hertz, float damping_ratio, float reach, float h, bool relaxes) {
    const float omega = 2.0f * pi * min(hertz, stiffest);
    const float turn = h * omega;
    const float a = min(min(damping_ratio, most_damped) * turn, 1.0e6f);  // beyond, nothing is left of a velocity
    const float damper = relaxes ? a + (sqrt(1 + a * a) - 1) : 2.0f * a;  // 1 / e - 1; where no sweep relaxes, all of it acts before the move
    const float near = min(turn * turn * max(4.0f, reach), 1.0f);         // 1 if it is not a number
    const float late = near * near * near;
    const float both = damper + turn * turn * late;
    const float e = 1.0f / (1.0f + both);
    return {turn * omega * e, both * e, late};
}

/// The spring of sweeps with bias.
inline Softness softness_of(const SplitSpring& s) { return s.scale > least_soft ? Softness{s.kick / s.scale, s.scale, 1.0f - s.scale} : no_spring; }

/// SplitSpring in lanes. A lane without a spring has a kick below 0.
template <std::uint32_t W>
struct SpringRows {
    float kick[W], scale[W], late[W];
};

/// Joints of the body of j that has most of them, and can be pushed. As many springs, each of the same frequency alone, swing a light body at most so many
/// times faster, squared.
ISLET_SHARED float crowd_of(const Joint& j, const Pose* poses, const Body* bodies) {
    std::uint32_t most = 1;
    for (const std::uint32_t body : {j.body_a, j.body_b}) {
        if (body == null_index || !is_positive(poses[body].inv_mass)) continue;
        const std::uint32_t count = bodies[body].joint_count;
        if (count > most) most = count;
    }
    return static_cast<float>(most);
}

template <std::uint32_t W>
ISLET_SHARED void set_spring(SpringRows<W>& r, std::uint32_t lane, const SplitSpring& spring) {
    r.kick[lane] = spring.kick;
    r.scale[lane] = spring.scale;
    r.late[lane] = spring.late;
}

}  // namespace islet::detail
