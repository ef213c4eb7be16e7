// What a row keeps for bouncing: how fast its points come, and whether they needed an impulse. Blocks of lanes, and builds that report hits, keep the numbers
// themselves.
#pragma once

#include "../constraint/contact_rows.hpp"
#include "../math/inlining.hpp"
#include "../math/lanes.hpp"

namespace islet::detail {

/// Whether rows keep how fast their points come and the largest impulses of these.
template <class Rows>
inline constexpr bool has_peaks = has_hits || !is_single<Rows>;

/// Where a row keeps its restitution until its last point is prepared.
template <class Rows>
ISLET_INLINE auto* restitution_of(Rows& r) {
    if constexpr (has_peaks<Rows>)
        return r.restitution;
    else
        return r.rebound + 1;  // the point that is prepared last
}

/// Notes how fast (m/s) the surfaces will meet at a point, of which no impulse is noted yet. The first point comes before the second.
template <class L>
ISLET_PART void note_approach([[maybe_unused]] const StepNumbers& n, ContactRows<L::width>& r, std::uint32_t i, typename L::F approach) {
    if constexpr (has_peaks<ContactRows<L::width>>) {
        L::store(r.approach[i], approach);
        L::store(r.peak[i], L::splat(0.0f));
    } else {
        const float e = *restitution_of(r);
        r.rebound[i] = e * approach;
        if (approach < -n.restitution_threshold && is_positive(e)) r.bouncy |= static_cast<std::uint8_t>(2u << i);
    }
}

/// Notes a normal impulse of a row that bounces.
template <class L>
ISLET_PART void note_impulse(ContactRows<L::width>& r, std::uint32_t i, typename L::F lambda) {
    if constexpr (has_peaks<ContactRows<L::width>>) {
        L::store(r.peak[i], max(L::load(r.peak[i]), lambda));
    } else {
        if (lambda > 0) r.bouncy |= static_cast<std::uint8_t>(8u << i);
    }
}

/// Whether a point bounces: it came faster than the threshold, and needed an impulse.
template <class L>
ISLET_PART auto will_bounce(const ContactRows<L::width>& r, std::uint32_t i, [[maybe_unused]] typename L::F threshold) {
    if constexpr (has_peaks<ContactRows<L::width>>) {
        const auto zero = L::splat(0.0f), approach = L::load(r.approach[i]), peak = L::load(r.peak[i]), e = L::load(r.restitution);
        return (approach < threshold) & (peak > zero) & (e > zero);
    } else {
        return (r.bouncy >> i & 10u) == 10u;
    }
}

/// m/s: how fast the surfaces came together at a point that needed an impulse; else 0.
template <class Rows>
ISLET_PART float hit_speed([[maybe_unused]] const Rows& r, [[maybe_unused]] std::uint32_t i, [[maybe_unused]] std::uint32_t lane) {
    if constexpr (has_peaks<Rows>)
        return r.peak[i][lane] > 0 ? max(-r.approach[i][lane], 0.0f) : 0.0f;
    else
        return 0;
}

/// m/s: the restitution times the approach.
template <class L>
ISLET_PART typename L::F rebound_of(const ContactRows<L::width>& r, std::uint32_t i) {
    if constexpr (has_peaks<ContactRows<L::width>>)
        return L::load(r.restitution) * L::load(r.approach[i]);
    else
        return r.rebound[i];
}

}  // namespace islet::detail
