// The rows of contacts, in blocks of lanes.
#pragma once

#include <cstdint>

#include "../constraint/solver_body.hpp"
#include "../data/records.hpp"

namespace islet::detail {

/// The rows of W contacts of one colour. Each of up to two points has a row along the normal n and a row along the tangent t = right_perp(n).
///
/// Let r be the arm from a body's centre to the contact point, rn = r x n and rt = t x r. A body's spin w then moves its point with the speed w rn along n and
/// -w rt along t. Both bodies share the point, so B's rn and rt are A's plus rn_ab and rt_ab, those of the vector from B's centre to A's.
template <std::uint32_t W>
struct alignas(W * 4) ContactRows {
    struct Point {
        float rta[W], rna[W];      // m
        float separation[W];       // m, at the start of the step
        float normal_mass[W];      // kg, times the relaxation factor
        float tangent_mass[W];     // kg, times the relaxation factor
        float normal_impulse[W];   // N s
        float tangent_impulse[W];  // N s
    };
    std::uint32_t body_a[W], body_b[W];  // solver slots; 0 in the padding
    std::uint32_t contact[W];            // null_index in the padding
    float nx[W], ny[W];
    float friction[W];
    float rt_ab[W], rn_ab[W];  // m: rtb - rta, rnb - rna
    Point points[2];
    float rolling_mass[W], rolling_impulse[W], rolling_resistance[W], tangent_speed[W];  // if special
    float restitution[W], approach[2][W], peak[2][W];  // if bouncy or reporting hits: m/s, normal velocity as the surfaces meet; N s, largest impulse
    std::uint8_t two_points;                           // 0: no contact of the block has two; 1: some have; 2: the same, and the second is solved first
    bool special, bouncy;                              // of any lane; is_special() and is_bouncy() read them
    std::uint8_t extra_passes[W * 4 - 3];              // of W lanes: landing_passes if the shapes come together fast, else 0

    ISLET_INLINE bool is_special() const { return has_surfaces && special; }
    ISLET_INLINE bool is_bouncy() const { return (has_restitution || has_hits) && bouncy; }
};

static_assert(sizeof(ContactRows<1>) == row_bytes && sizeof(ContactRows<4>) == 4 * row_bytes && sizeof(ContactRows<8>) == 8 * row_bytes);

/// How one sweep treats penetration: the velocity bias is max(bias_rate (s + slop), -push_speed), where s < 0 is the separation. For soft contacts,
/// bias_rate includes mass_scale.
struct SweepNumbers {
    float inv_h = 0;
    float bias_rate = 0;  // 1/s; 0 in a relax sweep
    float mass_scale = 1;
    float impulse_scale = 0;
    float push_speed = 0;
    float slop = 0;
};

}  // namespace islet::detail
