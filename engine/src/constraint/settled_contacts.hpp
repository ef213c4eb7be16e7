// Contacts that touch as before: when an update only keeps their manifolds. (step/recycling.hpp asks that of one contact, keep_settled of several in lanes.)
#pragma once

#include "../data/records.hpp"

namespace islet::detail {

inline constexpr float recycle_distance = 2.0f * linear_slop;  // m that the surfaces may slip before a manifold is made anew
inline constexpr float most_load = 1.0e28f;                    // N
inline constexpr float recycle_turn = 0.1f;                    // rad that a body may turn before a manifold is made anew
inline constexpr float least_lag = 0.001f;                     // rad that a manifold may lag behind two bodies that turn

/// How the load of a contact follows the force that it bore: m.load = keep * m.load + gain * (sum of its normal impulses).
struct LoadRate {
    float keep = 1;  // share of the old load
    float gain = 0;  // 1/s, of the impulses of the last substep
};

/// The flags of a contact that may be settled; what else is among `asked_flags` keeps it from that. So do all of `pose_unsettled`, of either body.
inline constexpr std::uint32_t settled_flags = contact_touching | contact_posed;
inline constexpr std::uint32_t asked_flags = settled_flags | contact_sensor | contact_asks | contact_one_way | contact_ahead | contact_untold;
inline constexpr std::uint32_t pose_unsettled = pose_moved | pose_fast | pose_learns;

/// Keeps those of W contacts that are settled: their loads follow. Returns a bit for each that is kept. None is that has rolling resistance or a tangent speed,
/// or, if `follows_deep`, that has sunk deep into a floor. (settled_kernel.hpp; compiled beside the contacts' kernels of the same width.)
template <std::uint32_t W>
std::uint32_t keep_settled(ContactManifold* manifolds, const Pose* poses, const std::uint32_t* contact, LoadRate rate, bool follows_deep);
extern template std::uint32_t keep_settled<4>(ContactManifold*, const Pose*, const std::uint32_t*, LoadRate, bool);
extern template std::uint32_t keep_settled<8>(ContactManifold*, const Pose*, const std::uint32_t*, LoadRate, bool);

}  // namespace islet::detail
