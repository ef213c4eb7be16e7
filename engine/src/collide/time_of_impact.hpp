// When two convex shapes in motion meet within a step.
#pragma once

#include "../collide/distance.hpp"
#include "islet/query.hpp"

namespace islet::detail {

/// How a body makes its way in a step: its centre of mass on a line, turning evenly.
struct BodyPath {
    Vec2 center;     // m, at the start
    Rot q;           // at the start
    Vec2 way;        // m, over the step
    float turn = 0;  // rad, over the step; pi/2 at most
};

/// The body's rotation, and its centre, at a fraction of the step.
Rot rotation_at(const BodyPath& path, float fraction);
Vec2 center_at(const BodyPath& path, float fraction);

/// A convex shape of a body that follows a path. The core's points are relative to the body's centre of mass.
struct MovingCore {
    ShapeProxy core;
    BodyPath path;
    float reach = 0;  // m, of the core's points from the centre of mass
};

inline constexpr float no_impact = 2.0f;
inline constexpr float overlaps_from_the_start = -1.0f;

/// The first fraction of the step, below `end`, at which a and b are no farther apart than `gap` (m, > 0), give or take as much; no_impact if they
/// never are. If they start so near: no_impact if they part, 0 if they do not, overlaps_from_the_start if their cores overlap.
/// Where rotation makes the search long it gives up early rather than late: at a fraction before which they do not meet.
float time_of_impact(const MovingCore& a, const MovingCore& b, float gap, float end);

}  // namespace islet::detail
