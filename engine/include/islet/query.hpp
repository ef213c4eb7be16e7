// Questions about shapes: where a ray or a moving shape meets one, how far two are apart, whether they overlap. First about shapes by themselves, then
// what the queries of a World (World::cast_ray and so on) take and give.
//
// A ShapeProxy stands for a shape of any type, so that one function serves all: separation(make_proxy(circle), make_proxy(box)).
//
// Errors. Everything is computed in single precision from the differences of the corners, so shapes close to each other lose nothing by being far from the
// origin. Distances, depths and surface points are within 1e-6 times the largest such difference (of any two corners, one of each shape, and along the way of
// a cast; or times a radius that is larger), however nearly parallel, collinear or alike the shapes are. Points in the world are rounded to floats besides,
// so far from the origin they are less exact. Casts are exact for shapes displaced by that much; a hit that only grazes may therefore be a miss, and the other
// way round. There is no iteration and no tolerance. No finite input gives a NaN.
#pragma once

#include <cstdint>
#include <span>

#include "islet/geometry.hpp"
#include "islet/types.hpp"

ISLET_API_BEGIN
namespace islet {

/// A convex shape of any type: the hull of 1 to 8 points, counter-clockwise, grown by `radius` (m, 0 to 1e7). count 0: no shape.
struct ShapeProxy {
    Vec2 points[max_polygon_vertices];
    std::uint32_t count = 0;
    float radius = 0;
    bool one_sided = false;  ///< Of two points: met by rays and casts only from the right of points[0] -> points[1], as a ChainSegment.
};

/// What stands for a shape; count 0 if it is not valid.
ShapeProxy make_proxy(const Circle& circle);
ShapeProxy make_proxy(const Capsule& capsule);
ShapeProxy make_proxy(const Segment& segment);
ShapeProxy make_proxy(const Polygon& polygon);
ShapeProxy make_proxy(const ChainSegment& segment);
/// The hull of up to 8 points (one and two are taken as they are, more by compute_hull), grown by radius; count 0 if there is none.
ShapeProxy make_proxy(std::span<const Vec2> points, float radius = 0);
/// An upright box; count 0 unless lower < upper on both axes.
ShapeProxy make_proxy(const Aabb& box);
/// p moved by t; count 0 if the result is not valid.
ShapeProxy transform_proxy(const Transform& t, const ShapeProxy& p);
/// 1 to 8 points within 4e7 m, 3 and more of them strictly convex and counter-clockwise; a radius of 0 to 1e7 m.
bool is_valid(const ShapeProxy& p);

/// Farthest that a ray or a cast may go along either axis, m.
inline constexpr float max_translation = 2.0f * max_position;

/// Where a moving point or shape first meets another.
struct CastHit {
    bool hit = false;
    float fraction = 0;    ///< of the translation, 0 to 1
    Vec2 point = {};       ///< m, on the surface that is met
    Vec2 normal = {};      ///< unit, of the surface that is met, towards what moves
    float separation = 0;  ///< m, 0; if they overlapped at the start, minus the depth
    explicit constexpr operator bool() const { return hit; }
};

/// The first point of `target` on the way from `origin` to `origin + translation`.
/// Starting inside is a hit at fraction 0 whatever the direction: normal is then the shortest way out, point where it ends, and separation, below 0, minus
/// its length. Starting on the surface is a hit only if the way leads inwards. A ray along a segment or an edge passes it by; at a corner that two segments
/// share it meets at least one of them. A translation shorter than 1e-10 m finds only what it starts in.
/// No hit if an argument is not valid: target, origin within 4e7 m, translation within max_translation.
CastHit cast_ray(const ShapeProxy& target, Vec2 origin, Vec2 translation);
/// The same for a moving shape: `moving` starts where it stands. Shapes that overlap at the start hit at fraction 0 (if they only touch, then if
/// the way leads inwards). A one-sided target is met only on ways against its normal by shapes whose corners' mean is in front of it at the start.
CastHit cast_shape(const ShapeProxy& moving, Vec2 translation, const ShapeProxy& target);

/// How two shapes stand to each other.
struct Separation {
    float distance = 0;  ///< m; below 0 when they overlap: then minus the length of the shortest way that parts them
    Vec2 point_a = {};   ///< m, the closest points of the surfaces; of overlapping shapes the deepest
    Vec2 point_b = {};
    Vec2 normal = {};  ///< unit, from a to b. For coinciding points (0, -1), on a line across it.
};

/// Distance and closest points of two shapes in one frame. Of shapes that are not valid: distance 3.4e38, no normal.
Separation separation(const ShapeProxy& a, const ShapeProxy& b);
/// True if they share a point.
bool overlaps(const ShapeProxy& a, const ShapeProxy& b);
/// True if the point is in the shape or on its surface; segments contain no point.
bool contains(const ShapeProxy& shape, Vec2 point);

// -- queries of a World ------------------------------------------------------------------------------------------------------------

/// Which shapes a query finds: those whose filter's category is in `mask` and whose filter's mask holds `category`. The default finds every shape but
/// sensors and those whose mask is 0. Shapes of disabled bodies are never found.
struct QueryFilter {
    std::uint32_t category = 0xffffffffu;
    std::uint32_t mask = 0xffffffffu;
    bool sensors = false;  ///< Find sensors too.
};

/// A shape that a ray or a cast meets; as CastHit. Null if there is none.
struct QueryHit {
    ShapeId shape = {};
    Vec2 point = {};   ///< m, world
    Vec2 normal = {};  ///< unit, world
    float fraction = 0;
    float separation = 0;  ///< m, 0 or, if it overlapped at the start, minus the depth
    explicit constexpr operator bool() const { return bool(shape); }
};

/// The shape closest to a point. Null if there is none.
struct ClosestHit {
    ShapeId shape = {};
    Vec2 point = {};     ///< m, the shape's closest point; the point asked for if that is inside
    Vec2 normal = {};    ///< unit, towards the point asked for; the shortest way out if that is inside
    float distance = 0;  ///< m, 0 inside
    explicit constexpr operator bool() const { return bool(shape); }
};

/// A surface near a shape: the plane that bounds it there.
struct Surface {
    ShapeId shape = {};
    Vec2 point = {};       ///< m, its closest point; of an overlapping shape the deepest
    Vec2 normal = {};      ///< unit, towards the shape asked for; the shortest way out of an overlap
    float separation = 0;  ///< m, below 0 when they overlap: then minus the depth
};

/// Called for each hit, from the first on the way to the last, and in the order of their slots where fractions are equal. What it returns decides how to go
/// on: 0 stops; a fraction above 0 cuts the way there, so that only hits up to it are still reported (1 cuts nothing, hit.fraction leaves what is as near);
/// a negative number ignores the hit.
///
/// A visitor may call any function of the world, and change it too if no other thread asks it anything meanwhile. Up to seven hits after a change may have been
/// found before it: their ids may be stale (World::is_valid), their places old. Those after them are of the world as it is then.
using CastVisitor = float (*)(const QueryHit& hit, void* context);
/// Called for each shape found, in the order of their slots; false stops. It may change the world as a CastVisitor may.
using OverlapVisitor = bool (*)(ShapeId shape, void* context);

}  // namespace islet
ISLET_API_END
