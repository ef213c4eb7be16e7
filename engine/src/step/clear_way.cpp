// Nearly all that moves fast along a wall, or is thrown back by it, is in front of the wall's line at the start and at the end of the step. In between a
// corner is farther from its straight way only by the bulge of its arc.
//
// What is found here must be what time_of_impact would find, to the bit, as not every build asks here first. So besides an allowance for rounding the two
// must be so far apart that each advance of the search is a fortieth of the way or more: it cannot run out of advances, and ends with nothing found.
#include "../exact.hpp"

#include "../step/clear_way.hpp"

#include "../math/scalar.hpp"
#include "../shapes/shape_types.hpp"

namespace islet::detail {

namespace {

inline constexpr float least_advance = 0.025f;  // of the way; time_of_impact makes up to 48
inline constexpr float rounding = 2e-6f;        // of all lengths together

float sum(Vec2 a) { return abs(a.x) + abs(a.y); }

// A line, in the frame of the wall's body.
struct Line {
    Vec2 from;
    Vec2 normal;  // unit
};

// Of the face of a polygon that looks most at the point, or of a segment.
Line line_towards(Vec2 point, const Geometry& g, const Corners& corners) {
    if (const Polygon* faces = faces_of(g)) {
        const Polygon& p = *faces;
        std::uint32_t best = 0;
        float most = dot(p.normals[0], point - p.vertices[0]);
        for (std::uint32_t i = 1; i < p.count; ++i) {
            const float in_front = dot(p.normals[i], point - p.vertices[i]);
            best = in_front > most ? i : best;
            most = max(in_front, most);
        }
        return {p.vertices[best], p.normals[best]};
    }
    const Vec2 edge = corners.points[1] - corners.points[0];
    const Vec2 normal = 1.0f / length_inline(edge) * right_perp(edge);
    return {corners.points[0], dot(normal, point - corners.points[0]) < 0 ? -normal : normal};
}

// How far the nearest corner is along a unit axis of the body's frame.
float nearest_along(Vec2 axis, const Corners& corners, Vec2 center) {
    float least = dot(axis, corners.points[0] - center);
    for (std::uint32_t i = 1; i < corners.count; ++i) least = min(least, dot(axis, corners.points[i] - center));
    return least;
}

}  // namespace

ClearWay clear_way_of(const BodyPath& path, float reach, float min_extent, float gap) {
    const float turning = abs(path.turn) * reach;
    const float room = max(gap, least_advance * (length_inline(path.way) + 1.1f * turning));
    const float bulge = 0.13f * abs(path.turn) * turning;  // an eighth, and a little for a turn that is not quite even
    const float inexact = rounding * (sum(path.center) + sum(path.way) + reach);
    return {path.center, path.way, path.q, integrate(path.q, path.turn), gap + room + bulge + inexact, min_extent};
}

bool keeps_clear(const ClearWay& way, const Geometry& shape, Vec2 center, const Geometry& wall, const Transform& wall_pose) {
    const Corners moving = corners_of(shape), fixed = corners_of(wall);
    if (fixed.count < 2) return false;
    const Vec2 start = inv_transform_point(wall_pose, way.start);
    const Line line = line_towards(start, wall, fixed);
    const Vec2 normal = rotate(wall_pose.q, line.normal);
    const float at_start = dot(line.normal, start - line.from);
    const float at_end = at_start + dot(normal, way.way);
    const float apart =
        min(at_start + nearest_along(inv_rotate(way.q_start, normal), moving, center), at_end + nearest_along(inv_rotate(way.q_end, normal), moving, center));
    // The core's radius is half of the shape's, and its corners are moved in from all faces by a quarter at least of what is within them (mostly by half).
    const float core_radius = moving.radius - 0.25f * (way.min_extent + moving.radius);
    return apart > way.needed + core_radius + fixed.radius + rounding * (sum(wall_pose.p) + sum(start) + sum(line.from));
}

}  // namespace islet::detail
