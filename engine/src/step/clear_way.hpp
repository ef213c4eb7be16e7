// Proof, without a search, that what moves stays in front of a wall.
#pragma once

#include "../collide/time_of_impact.hpp"
#include "../data/records.hpp"

namespace islet::detail {

/// What is asked of a body's way again and again.
struct ClearWay {
    Vec2 start, way;  // m, of the centre of mass
    Rot q_start, q_end;
    float needed = 0;      // m, that a core must stay away from a wall's line to be clear of it
    float min_extent = 0;  // m, smallest half-thickness of the body's shapes
};

/// Of a body of whose points none is farther than `reach` (m) from its centre of mass, and whose shapes have a half-thickness of `min_extent` (m) at least;
/// `gap` (m) is the largest that time_of_impact is asked for.
ClearWay clear_way_of(const BodyPath& path, float reach, float min_extent, float gap);

/// True only if time_of_impact, for the gap given, of the shape's core, which is half as thick as the shape (step/continuous.cpp), and the wall, which is at
/// rest, would find no impact. False says nothing. `center` is the centre of mass, in the frame of the shape.
bool keeps_clear(const ClearWay& way, const Geometry& shape, Vec2 center, const Geometry& wall, const Transform& wall_pose);

}  // namespace islet::detail
