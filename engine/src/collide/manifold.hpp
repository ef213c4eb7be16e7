// Contact manifolds: up to two points that say where two shapes meet.
//
// Everything is in the local frame of shape A's body ("frame A"): the narrow phase never sees large world coordinates, so a scene 10 km from
// the origin collides exactly like one at the origin.
#pragma once

#include <cstdint>

#include "../geometry/convex.hpp"
#include "islet/geometry.hpp"
#include "islet/layout.hpp"

namespace islet::detail {

inline constexpr float linear_slop = min_length;                   // m: a length that is numerically large and visually small
inline constexpr float speculative_distance = 4.0f * linear_slop;  // m: contacts are made this long before surfaces meet
inline constexpr float touch_gap = 0.25f * linear_slop;            // m: shapes that are no farther apart touch

// Below this difference (m) two directions or two shapes' faces count as equally good, so that a choice does not flicker with rounding.
inline constexpr float separation_tie = 0.1f * linear_slop;

struct ManifoldPoint {
    Vec2 point;            // m, frame A, midway between the two surfaces
    float separation = 0;  // m, along the normal; negative when overlapping
    std::uint16_t id = 0;  // feature id: which vertex or edge of A and of B; stable from step to step while the features are the same
};

/// How far two shapes are apart. Builds for one lane, which may be small, do not note it.
template <bool is_noted = (max_lanes > 1)>
struct Clearance {
    float clearance = 0;  // m that the shapes are apart at least, if there are no points and that is known; else 0

    void note(float apart) { clearance = apart; }
};
template <>
struct Clearance<false> {
    static constexpr float clearance = 0;

    void note(float) {}
};

struct Manifold : Clearance<> {
    Vec2 normal;  // unit, frame A, from A to B
    ManifoldPoint points[2];
    std::uint32_t count = 0;  // 0: no contact closer than the margin
};

/// The manifold of shapes that are so far apart (m) at least.
inline Manifold none_within(float clearance) {
    Manifold none;
    none.note(clearance);
    return none;
}

/// The separation of the nearest point, m. There must be one.
inline float least_separation(const Manifold& m) { return m.count == 2 ? min(m.points[0].separation, m.points[1].separation) : m.points[0].separation; }

}  // namespace islet::detail
