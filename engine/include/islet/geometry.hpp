// Shapes as plain data, in the local frame of the body they will be attached to, and what can be computed from them.
// No coordinate or radius of a valid shape is larger than 1e7 m.
#pragma once

#include <cstdint>

#include "islet/math.hpp"
#include "islet/span.hpp"

ISLET_API_BEGIN
namespace islet {

/// Most corners a convex polygon can have.
inline constexpr std::uint32_t max_polygon_vertices = 8;

enum class ShapeType : std::uint8_t { circle, capsule, segment, polygon, chain_segment, half_space };

/// A solid disc. radius > 0, metres.
struct Circle {
    Vec2 center = {};
    float radius = 0.5f;
};

/// All points within `radius` of the segment point1-point2. radius > 0; the points must be more than 0.005 m apart.
struct Capsule {
    Vec2 point1 = {};
    Vec2 point2 = {};
    float radius = 0.5f;
};

/// A line segment that collides on both sides and has no mass. The points must be more than 0.005 m apart.
struct Segment {
    Vec2 point1 = {};
    Vec2 point2 = {};
};

/// One segment of a chain. It collides only on the right of point1 -> point2: its outward normal is right_perp(point2 - point1). So a floor runs from right to
/// left. The ghost points are the far ends of the neighbouring segments. They tell the engine which corners are inner corners, so that bodies do not catch on
/// them. A ghost point may lie beyond max_position, up to 4e7 m from the origin, so that the last segment of a chain can continue straight on.
struct ChainSegment {
    Vec2 ghost1 = {};
    Segment segment = {};
    Vec2 ghost2 = {};
};

/// Everything on the inner side of an infinite line: the ground of a small world. Only static and kinematic bodies can have one, and it has no mass. It
/// collides with circles, capsules and polygons. Its bounding box ends at 8e7 m.
struct HalfSpace {
    Vec2 normal = {0, 1};  ///< unit, outward
    float offset = 0;      ///< m, from the body's origin to the surface along the normal; 1e7 m at most
};

/// The corners of a convex polygon, m, counter-clockwise. count = 0 means that no hull could be made.
struct Hull {
    Vec2 points[max_polygon_vertices];
    std::uint32_t count = 0;
};

/// A solid convex polygon, counter-clockwise, with outward unit normals (normal i belongs to the edge from vertex i to i + 1), rounded by
/// `radius` (metres, >= 0) around its corners. Make one with make_polygon or make_box. If you fill one in by hand, it is checked when you use it.
struct Polygon {
    Vec2 vertices[max_polygon_vertices];
    Vec2 normals[max_polygon_vertices];
    Vec2 centroid = {};
    float radius = 0;
    std::uint32_t count = 0;
};

/// Mass (kg), centre of mass (m, local) and rotational inertia about that centre (kg m^2).
struct MassData {
    float mass = 0;
    Vec2 center = {};
    float inertia = 0;
};

/// The convex hull of up to max_polygon_vertices points in any order. It begins with the leftmost point (if there are several, the lowest). Duplicates (closer
/// than 0.005 m) and collinear points (standing out by less than 0.0005 m) are dropped. The result depends on the set of points, not on their order. Returns
/// count 0 if fewer than 3 points remain, if there are more than 8 points given, or if a coordinate is not finite or above 1e7 m.
Hull compute_hull(span<const Vec2> points);
/// Polygon from a hull; count 0 if the hull has fewer than 3 points or is not convex, or if radius (m) is negative or not finite.
Polygon make_polygon(const Hull& hull, float radius = 0);
/// Axis-aligned box of half-width hx and half-height hy (metres, > 0; count 0 otherwise), centred on the body's origin.
Polygon make_box(float hx, float hy);
/// Box with rounded corners: the total half extents are hx + radius and hy + radius, m.
Polygon make_rounded_box(float hx, float hy, float radius);
/// Box with its centre at pose.p, turned by pose.q; half extents and radius in m.
Polygon make_offset_box(float hx, float hy, const Transform& pose, float radius = 0);
/// p moved by t; count 0 if the result is not valid (t not finite, or so far away that rounding destroys the shape).
Polygon transform_polygon(const Transform& t, const Polygon& p);

/// True if the geometry obeys its own rules above (finite, sizes positive, convex, counter-clockwise, unit normals).
bool is_valid(const Circle& c);
bool is_valid(const Capsule& c);
bool is_valid(const Segment& s);
bool is_valid(const ChainSegment& s);
bool is_valid(const HalfSpace& h);
bool is_valid(const Polygon& p);

/// Mass properties at a density in kg/m^2 (>= 0); all zero if the shape or the density is not valid. Segments have
/// none. A rounded polygon is, exactly, the Minkowski sum of the polygon and a disc.
MassData compute_mass(const Circle& c, float density);
MassData compute_mass(const Capsule& c, float density);
MassData compute_mass(const Polygon& p, float density);

/// The tight bounding box of a shape that is moved by t.
Aabb compute_aabb(const Circle& c, const Transform& t);
Aabb compute_aabb(const Capsule& c, const Transform& t);
Aabb compute_aabb(const Segment& s, const Transform& t);
Aabb compute_aabb(const Polygon& p, const Transform& t);

}  // namespace islet
ISLET_API_END
