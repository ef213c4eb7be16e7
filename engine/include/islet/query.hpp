// Queries: where a ray or a moving shape meets a shape, how far two shapes are apart, and whether they overlap. First come functions on shapes by themselves,
// then the types that the queries of a World take and return (World::cast_ray and so on).
//
// A ShapeProxy stands for a shape of any type, so one function serves all types: separation(make_proxy(circle), make_proxy(box)).
//
// Rounding. Everything is computed in single precision from the differences of corners, so shapes that are close to each other lose nothing far from the
// origin. Distances, depths and surface points are exact to 1e-6 times the largest such difference (between a corner of one shape and a corner of the other,
// along the way of a cast, or times a radius that is larger), however nearly parallel, collinear or alike the shapes are. Points in the world are then rounded
// to floats, so they are less exact far from the origin. Casts are exact for shapes displaced by that much, so a grazing hit may become a miss, or a miss
// a hit. There is no iteration and no tolerance. No finite input gives a NaN.
#pragma once

#include <cstdint>

#include "islet/geometry.hpp"
#include "islet/span.hpp"
#include "islet/types.hpp"

ISLET_API_BEGIN
namespace islet {

/// A convex shape of any type: the hull of 1 to 8 points, counter-clockwise, grown by `radius` (m, 0 to 1e7). count 0: no shape.
struct ShapeProxy {
    Vec2 points[max_polygon_vertices];
    std::uint32_t count = 0;
    float radius = 0;
    bool one_sided = false;  ///< Of two points: rays and casts meet the shape only from the right of points[0] -> points[1], as a ChainSegment.
};

/// The proxy of a shape; count 0 if the shape is not valid.
ShapeProxy make_proxy(const Circle& circle);
ShapeProxy make_proxy(const Capsule& capsule);
ShapeProxy make_proxy(const Segment& segment);
ShapeProxy make_proxy(const Polygon& polygon);
ShapeProxy make_proxy(const ChainSegment& segment);
/// The hull of up to 8 points (one and two are taken as they are, more by compute_hull), grown by radius (m); count 0 if there is none.
ShapeProxy make_proxy(span<const Vec2> points, float radius = 0);
/// An upright box; count 0 unless lower < upper on both axes.
ShapeProxy make_proxy(const Aabb& box);
/// p moved by t; count 0 if the result is not valid.
ShapeProxy transform_proxy(const Transform& t, const ShapeProxy& p);
/// 1 to 8 points within 4e7 m, 3 and more of them strictly convex and counter-clockwise; a radius of 0 to 1e7 m.
bool is_valid(const ShapeProxy& p);

/// The farthest that a ray or a cast may go along either axis, m.
inline constexpr float max_translation = 2.0f * max_position;

/// Where a moving point or shape first meets another.
struct CastHit {
    bool hit = false;
    float fraction = 0;    ///< of the translation, 0 to 1
    Vec2 point = {};       ///< m, on the surface that is met
    Vec2 normal = {};      ///< unit, of the surface that is met, towards the moving point or shape
    float separation = 0;  ///< m, 0; if they overlapped at the start, minus the depth
    explicit constexpr operator bool() const { return hit; }
};

/// The first point of `target` on the way from `origin` to `origin + translation`.
/// A ray that starts inside hits at fraction 0, in any direction. Its normal points along the shortest way out, `point` is the end of that way, and separation
/// is minus its length. A ray that starts on the surface hits only if it leads inwards. A ray that runs along a segment or an edge does not hit it. At a corner
/// that two segments share, a ray hits at least one of them. A translation shorter than 1e-10 m hits only the shape in which it starts.
/// No hit if an argument is not valid: target, origin within 4e7 m, translation within max_translation.
CastHit cast_ray(const ShapeProxy& target, Vec2 origin, Vec2 translation);
/// The same for a moving shape. Shapes that overlap at the start hit at fraction 0; shapes that only touch do if the way leads
/// inwards. A shape meets a one-sided target only if it moves against the target's normal and the mean of its corners starts in front of the target.
CastHit cast_shape(const ShapeProxy& moving, Vec2 translation, const ShapeProxy& target);

/// How two shapes stand to each other.
struct Separation {
    float distance = 0;  ///< m; for shapes that overlap, minus the length of the shortest way that parts them
    Vec2 point_a = {};   ///< m, the closest points of the surfaces; of overlapping shapes the deepest
    Vec2 point_b = {};   ///< m
    Vec2 normal = {};    ///< unit, from a to b. For coinciding points (0, -1), on a line across it.
};

/// Distance and closest points of two shapes in one frame. Of shapes that are not valid: distance 3.4e38, no normal.
Separation separation(const ShapeProxy& a, const ShapeProxy& b);
/// True if they share a point.
bool overlaps(const ShapeProxy& a, const ShapeProxy& b);
/// True if the point is in the shape or on its surface; segments contain no point.
bool contains(const ShapeProxy& shape, Vec2 point);

// -- queries of a World ------------------------------------------------------------------------------------------------------------

/// Which shapes a query finds: those whose filter has a category in `mask` and a mask that contains `category`. The default finds all shapes but sensors and
/// shapes whose mask is 0. Shapes of disabled bodies are never found.
struct QueryFilter {
    std::uint32_t category = 0xffffffffu;
    std::uint32_t mask = 0xffffffffu;
    bool sensors = false;  ///< Find sensors too.
};

/// A shape that a ray or a cast meets, with the fields of CastHit. Null if there is none.
struct QueryHit {
    ShapeId shape = {};
    Vec2 point = {};       ///< m, world
    Vec2 normal = {};      ///< unit, world
    float fraction = 0;    ///< 0 to 1, of the translation
    float separation = 0;  ///< m, 0; for shapes that overlapped at the start, minus the depth
    explicit constexpr operator bool() const { return bool(shape); }
};

/// The shape closest to a point. Null if there is none.
struct ClosestHit {
    ShapeId shape = {};
    Vec2 point = {};     ///< m, the shape's closest point; the given point if it is inside
    Vec2 normal = {};    ///< unit, towards the given point; if that is inside, along the shortest way out
    float distance = 0;  ///< m, 0 inside
    explicit constexpr operator bool() const { return bool(shape); }
};

/// A surface near a shape: the plane that bounds it there.
struct Surface {
    ShapeId shape = {};
    Vec2 point = {};       ///< m, the surface's closest point; of an overlapping shape the deepest
    Vec2 normal = {};      ///< unit, towards the given shape; along the shortest way out of an overlap
    float separation = 0;  ///< m; for shapes that overlap, minus the depth
};

/// Called for each hit, from the first on the way to the last; hits of equal fractions come in the order of their slots. The result decides how the cast goes
/// on. 0 stops it. A fraction above 0 ends the way there: only hits up to that fraction follow (1 ends nothing; hit.fraction leaves only hits as near as this
/// one). A negative number ignores the hit.
///
/// A visitor may call any function of the world. It may change the world, too, if no other thread uses the world meanwhile. Up to seven hits after a change may
/// have been found before it: their ids may be stale (World::is_valid) and their places old. The hits after them are of the changed world.
using CastVisitor = float (*)(const QueryHit& hit, void* context);
/// Called for each shape found, in the order of their slots; false stops the query. It may change the world as a CastVisitor may.
using OverlapVisitor = bool (*)(ShapeId shape, void* context);

}  // namespace islet
ISLET_API_END
