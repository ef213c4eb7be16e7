// The rows of contacts, in blocks of lanes.
#pragma once

#include <cstdint>
#include <cstring>
#include <type_traits>

#include "../constraint/solver_body.hpp"
#include "../data/records.hpp"

namespace islet::detail {

/// By how much body_a and body_b of a row go up from slot to slot. An address on x86 can contain eight times a number, but not the 32 that a slot has bytes; so
/// lanes count each slot as four, which saves a shift for every body that a block loads or writes.
template <std::uint32_t W>
inline constexpr std::uint32_t slot_scale = W == 1 ? 1 : 4;
template <std::uint32_t W>
inline constexpr std::uint32_t words_counted = slot_words / slot_scale<W>;

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
    std::uint32_t body_a[W], body_b[W];  // solver slots times slot_scale<W>; 0 in the padding
    std::uint32_t contact[W];            // null_index in the padding
    float nx[W], ny[W];
    float friction[W];
    float rt_ab[W], rn_ab[W];  // m: rtb - rta, rnb - rna
    Point points[2];
    float rolling_mass[W], rolling_impulse[W], rolling_resistance[W], tangent_speed[W];  // if special
    float restitution[W], approach[2][W], peak[2][W];  // if bouncy or reporting hits: m/s, normal velocity as the surfaces meet; N s, largest impulse
    std::uint8_t two_points;                           // 0: no contact of the block has two; 1: some have; 2: the same, and the second is solved first
    bool special, bouncy, shared;                      // of any lane; is_special(), is_bouncy() and sharing() read them
    bool rebounds;                                     // some lane may bounce: set until a look at the impulses shows that none does
    std::uint8_t extra_passes[W];                      // landing_passes if the shapes come together fast, else 0
    std::uint8_t sharers[W * 3 - 5];                   // of W lanes, if shared: contacts that the two bodies have, 1 to 4

    ISLET_INLINE bool is_special() const { return has_surfaces && special; }
    ISLET_INLINE bool is_bouncy() const { return (has_restitution || has_hits) && bouncy; }
    ISLET_INLINE std::uint32_t sharing() const { return shared ? 1 : 0; }
};

/// What only special contacts need. A build without them has no memory for it.
template <bool is_there = has_surfaces>
struct SurfaceOfRow {
    float rolling_mass[1], rolling_resistance[1], tangent_speed[1];
};
template <>
struct SurfaceOfRow<false> {
    static inline float rolling_mass[1], rolling_resistance[1], tangent_speed[1];  // never read
};

/// What contacts bounce by. A build that reports no hits keeps no more of it than the speed that each point is given.
template <bool reports = has_hits>
struct BounceOfRow {
    float restitution[1], approach[2][1], peak[2][1];
};
template <>
struct BounceOfRow<false> {
    float rebound[2];  // m/s, restitution times approach; the second is the restitution until its point is prepared
};

/// The row of one contact: what its manifold holds already, the frame, the friction and the impulses, is read and written there. (Lanes gather these once
/// instead.)
template <>
struct ContactRows<1> : SurfaceOfRow<>, BounceOfRow<> {
    struct Point {
        float rta[1], rna[1], separation[1], normal_mass[1], tangent_mass[1];
    };
    ContactManifold* manifold;
    PlanIndex body_a[1], body_b[1];
    float rt_ab[1], rn_ab[1];
    Point points[2];
    std::uint8_t two_points;
    bool special;
    std::uint8_t bouncy;  // 0: it is not. Without peaks: bit 1 + i, point i comes fast enough; bit 3 + i, it needed an impulse
    std::uint8_t extra_passes[1];

    ISLET_INLINE bool is_special() const { return has_surfaces && special; }
    ISLET_INLINE bool is_bouncy() const { return (has_restitution || has_hits) && bouncy != 0; }
    ISLET_INLINE std::uint32_t sharing() const { return manifold->sharers() - 1; }
};

static_assert(sizeof(ContactRows<4>) == 4 * row_bytes || max_lanes == 1);
static_assert(sizeof(ContactRows<8>) == 8 * row_bytes || max_lanes == 1);
static_assert(sizeof(ContactRows<16>) == 2 * sizeof(ContactRows<8>));
static_assert(sizeof(ContactRows<1>) <= row_bytes);

// What single rows have in their manifolds, and blocks of lanes in themselves.
#define ISLET_IN_ROW(function, of_lanes, of_one)                                 \
    template <class Rows>                                                        \
    ISLET_INLINE auto* function(Rows& r, [[maybe_unused]] std::uint32_t i = 0) { \
        if constexpr (is_single<Rows>)                                           \
            return &r.manifold->of_one;                                          \
        else                                                                     \
            return r.of_lanes;                                                   \
    }
template <class Rows>
inline constexpr bool is_single = std::is_same_v<std::remove_const_t<Rows>, ContactRows<1>>;
ISLET_IN_ROW(normal_x, nx, normal.x)
ISLET_IN_ROW(normal_y, ny, normal.y)
ISLET_IN_ROW(friction_of, friction, friction)
ISLET_IN_ROW(normal_impulse_of, points[i].normal_impulse, normal_impulse[i])
ISLET_IN_ROW(tangent_impulse_of, points[i].tangent_impulse, tangent_impulse[i])
ISLET_IN_ROW(rolling_impulse_of, rolling_impulse, rolling_impulse)
#undef ISLET_IN_ROW

/// In how many contacts with nearly the same normal the two bodies of each lane touch: 1 to 4.
template <class L>
ISLET_PART typename L::F sharers_of(const ContactRows<L::width>& r) {
    if constexpr (L::width == 1) {
        return static_cast<float>(r.manifold->sharers());
    } else {
        float sharers[L::width];
        for (std::uint32_t i = 0; i < L::width; ++i) sharers[i] = r.sharers[i];
        return L::load(sharers);
    }
}

/// N s: the sum of a block's normal impulses so far.
template <class L>
ISLET_PART typename L::F normal_impulses_of(const ContactRows<L::width>& r) {
    const auto first = L::load(normal_impulse_of(r, 0));
    return r.two_points ? first + L::load(normal_impulse_of(r, 1)) : first;
}

/// A truth value that is known when a template is compiled.
template <bool is>
struct KnownBool {
    constexpr operator bool() const { return is; }
};

/// Calls row(index, is_first) for one point or two, the one with the index `first` first. Sums may begin with what is_first says is the first; they are zero
/// before. On a page there is one copy of the row, for which no point is.
template <class Row>
ISLET_PART void for_points(bool two, std::uint32_t first, Row&& row) {
#if defined(__wasm__)
    std::uint32_t i = first;
    for (std::uint32_t left = two ? 2 : 1; left > 0; --left, i = 1 - i) row(i, KnownBool<false>{});
#else
    row(first, KnownBool<true>{});
    if (two) row(1 - first, KnownBool<false>{});
#endif
}

/// The contact of a lane, or null_index in the padding.
template <std::uint32_t W>
ISLET_INLINE std::uint32_t contact_of(const ContactRows<W>& r, std::uint32_t i, [[maybe_unused]] const ContactManifold* manifolds) {
    if constexpr (W == 1)
        return static_cast<std::uint32_t>(r.manifold - manifolds);
    else
        return r.contact[i];
}
template <std::uint32_t W>
ISLET_INLINE void set_contact(ContactRows<W>& r, std::uint32_t i, std::uint32_t contact, [[maybe_unused]] ContactManifold* manifolds) {
    if constexpr (W == 1)
        r.manifold = manifolds + contact;
    else
        r.contact[i] = contact;
}
/// The manifold of a lane, which must not be padding.
template <std::uint32_t W>
ISLET_INLINE auto& manifold_of(const ContactRows<W>& r, std::uint32_t i, [[maybe_unused]] const ContactManifold* manifolds) {
    if constexpr (W == 1)
        return static_cast<const ContactManifold&>(*r.manifold);
    else
        return manifolds[r.contact[i]];
}

/// Whether any contact of a block lands.
template <std::uint32_t W>
ISLET_PART bool any_lands(const ContactRows<W>& r) {
    if constexpr (W == 1) {
        return r.extra_passes[0] != 0;
    } else {
        std::uint64_t landing[2] = {};
        std::memcpy(landing, r.extra_passes, W);
        return (landing[0] | landing[1]) != 0;
    }
}

/// How one sweep treats penetration: the velocity bias is max(bias_rate (s + slop), -push_speed), where s < 0 is the separation. For soft contacts,
/// bias_rate includes mass_scale.
struct SweepNumbers {
    float inv_h = 0;
    float bias_rate = 0;  // 1/s; 0 in a relax sweep
    float mass_scale = 1;
    float impulse_scale = 0;
    float push_speed = 0;
    float slop = 0;
    bool shares = false;  // some contacts share their load (SweepLanes::share)
};

}  // namespace islet::detail
