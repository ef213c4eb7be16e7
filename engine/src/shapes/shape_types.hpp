// What is asked of a shape of any type. The list of types is ISLET_SHAPE_TYPES (islet/config.hpp); what is particular to a type stands in one file of this
// room: which shapes are valid, their mass and box, the points they have with the types before it in the list, how they are drawn.
#pragma once

#include <cstddef>

#include "../data/records.hpp"
#include "../math/inlining.hpp"
#include "islet/debug_draw.hpp"
#include "islet/query.hpp"

namespace islet {

// What each type has besides the functions of the public headers.
inline void draw_shape(const DebugDraw& draw, const ChainSegment& s, const Transform& pose, const DrawStyle& style) {
    draw_shape(draw, s.segment, pose, style);
}

void draw_shape(const DebugDraw& draw, const HalfSpace& h, const Transform& pose, const DrawStyle& style);

namespace detail {

/// What a type's shapes are to others.
enum class ShapeKind : std::uint8_t {
    solid,    // has an area, and so a mass; collides with all
    line,     // has none; two lines do not collide with each other
    front,    // a line that is met from its front alone: the right of its two points
    endless,  // has no mass, is no dynamic body's, does not collide with lines, and has no corners: it is asked for those of a patch (corners_near)
};

// The place of a type in the list. A contact calls the shape of the higher rank A.
enum ShapeRank : std::uint32_t {
#define ISLET_RANK(name, ...) rank_##name,
    ISLET_SHAPE_TYPES(ISLET_RANK)
#undef ISLET_RANK
        shape_type_count
};

/// The row of a type.
template <class Shape>
struct ShapeRow;
#define ISLET_ROW(name, Type, feature, kind_, linked)               \
    template <>                                                     \
    struct ShapeRow<Type> {                                         \
        static constexpr ShapeType type = ShapeType::name;          \
        static constexpr ShapeKind kind = ShapeKind::kind_;         \
        static constexpr std::uint32_t rank = rank_##name;          \
        static constexpr bool is_there = has_##feature;             \
        static Type& of(Geometry& g) { return g.name; }             \
        static const Type& of(const Geometry& g) { return g.name; } \
    };
ISLET_SHAPE_TYPES(ISLET_ROW)
#undef ISLET_ROW
/// The row of what has the type Shape or const Shape&.
template <class Shape>
using RowOf = ShapeRow<std::remove_const_t<std::remove_reference_t<Shape>>>;

/// Calls visit(shape) with the geometry as what it is.
template <class Visit>
ISLET_ALWAYS_INLINE inline auto with_shape(const Geometry& g, Visit&& visit) {
    switch (g.shape_type()) {
#define ISLET_VISIT(name, ...) \
    case ShapeType::name: return visit(g.name);
        ISLET_SHAPE_TYPES(ISLET_VISIT)
#undef ISLET_VISIT
    }
    ISLET_UNREACHABLE();
}

ISLET_SHARED std::uint32_t rank_of(const Geometry& g) {
    return with_shape(g, [](const auto& shape) { return RowOf<decltype(shape)>::rank; });
}
inline ShapeKind kind_of(const Geometry& g) {
    return with_shape(g, [](const auto& shape) { return RowOf<decltype(shape)>::kind; });
}

/// The types without end have, besides, aabb_of, reaches and corners_near of their own (below).
#define ISLET_OR_ENDLESS(name, Type, ...) || (ShapeRow<Type>::is_there && ShapeRow<Type>::kind == ShapeKind::endless)
inline constexpr bool has_endless = false ISLET_SHAPE_TYPES(ISLET_OR_ENDLESS);
#undef ISLET_OR_ENDLESS
// (Type by type: of kind_of the compiler would make a table.)
#define ISLET_OR_IS_ENDLESS(name, Type, ...) || (ShapeRow<Type>::kind == ShapeKind::endless && g.shape_type() == ShapeType::name)
inline bool is_endless(const Geometry& g) { return has_endless && (false ISLET_SHAPE_TYPES(ISLET_OR_IS_ENDLESS)); }
#undef ISLET_OR_IS_ENDLESS

/// m: boxes and extents of what is endless end here. No point of another shape's box is as far from the origin along an axis.
inline constexpr float endless_reach = 8.0f * max_position;

// -- points and a radius ------------------------------------------------------------------------------------------------------------------
//
// Every shape is the hull of some points, grown by a radius. Three structs say so: Corners point into a geometry; a ShapeProxy (islet/query.hpp) is a copy,
// which can be moved; an Outline (collide/outline.hpp) has the faces' normals too, for contact points.

struct Corners {
    const Vec2* points;  // in the body's frame
    std::uint32_t count;
    float radius;
};

static_assert(sizeof(Segment) == 2 * sizeof(Vec2) && offsetof(Capsule, point2) == sizeof(Vec2));  // the points are an array

inline Corners corners_of(const Circle& c) { return {&c.center, 1, c.radius}; }
inline Corners corners_of(const Capsule& c) { return {reinterpret_cast<const Vec2*>(&c), 2, c.radius}; }
inline Corners corners_of(const Polygon& p) { return {p.vertices, p.count, p.radius}; }
inline Corners corners_of(const Segment& s) { return {reinterpret_cast<const Vec2*>(&s), 2, 0}; }
inline Corners corners_of(const ChainSegment& s) { return corners_of(s.segment); }

inline Corners corners_of(const HalfSpace& h) { return {&h.normal, 1, 0}; }  // for the radius alone: see corners_near

ISLET_SHARED Corners corners_of(const Geometry& g) {
    if (g.shape_type() == ShapeType::polygon) return corners_of(g.polygon);  // as most are
    return with_shape(g, [](const auto& shape) { return corners_of(shape); });
}

/// The polygon that a shape with faces is, or null.
inline const Polygon* faces_of(const Geometry& g) { return g.shape_type() == ShapeType::polygon ? &g.polygon : nullptr; }

/// A point well inside a shape, in the body's frame.
Vec2 middle_of(const Geometry& g);

/// Where another shape is, in the body's frame: no point of it is farther than `reach` (m) from the place.
struct Around {
    Vec2 place;
    float reach;
};

// Of each type without end:
Aabb aabb_of(const HalfSpace& h, const Transform& t);
bool reaches(const HalfSpace& h, const Transform& t, const Aabb& box);
Corners corners_near(const HalfSpace& h, const Around& around, Vec2* room);

/// The tight box. (Rounding keeps the order of numbers, so the place of the body may be added last.)
ISLET_SHARED Aabb aabb_of(const Corners& corners, const Transform& t) {
    const Vec2 first = rotate(t.q, corners.points[0]);
    Aabb box{first, first};
    for (std::uint32_t i = 1; i < corners.count; ++i) {
        const Vec2 v = rotate(t.q, corners.points[i]);
        box = {min(box.lower, v), max(box.upper, v)};
    }
    return expand({box.lower + t.p, box.upper + t.p}, corners.radius);
}
ISLET_SHARED Aabb aabb_of(const Geometry& g, const Transform& t) {
    if (!is_endless(g)) return aabb_of(corners_of(g), t);
    return with_shape(g, [&](const auto& shape) {
        if constexpr (RowOf<decltype(shape)>::kind == ShapeKind::endless) return aabb_of(shape, t);
        return Aabb{};
    });
}

Around around(const Corners& other, const Transform& t);

/// The corners of a shape; of one without end those of a patch, which go to `room` (4 points): what is around meets the patch as it meets the whole.
ISLET_SHARED Corners corners_near(const Geometry& g, [[maybe_unused]] const Around& around, [[maybe_unused]] Vec2* room) {
    if (!is_endless(g)) return corners_of(g);
    return with_shape(g, [&](const auto& shape) {
        if constexpr (RowOf<decltype(shape)>::kind == ShapeKind::endless) return corners_near(shape, around, room);
        return Corners{};
    });
}

/// False only if what is in the box does not come near a shape without end; its own box says little.
inline bool reaches_endless(const Geometry& g, const Transform& t, const Aabb& box) {
    return with_shape(g, [&](const auto& shape) {
        if constexpr (RowOf<decltype(shape)>::kind == ShapeKind::endless) return reaches(shape, t, box);
        return true;
    });
}

/// The shape as a proxy of its own.
ShapeProxy proxy_of(const Corners& corners);

// -- the geometry of a shape --------------------------------------------------------------------------------------------------------------

/// A geometry whose every byte is decided by its type and what is then filled in: equal ones are shared.
ISLET_SHARED Geometry blank_geometry(ShapeType type) {
    Geometry g;
    g.type = static_cast<std::uint32_t>(type);
    return g;
}
template <class Shape>
Geometry geometry_of(const Shape& shape) {
    Geometry g = blank_geometry(ShapeRow<Shape>::type);
    ShapeRow<Shape>::of(g) = shape;
    return g;
}
/// Only what counts: equal polygons are equal bit by bit. Of one that is not valid: blank.
Geometry geometry_of(const Polygon& polygon);
Geometry geometry_of(const HalfSpace& h);  // its normal made unit

}  // namespace detail
}  // namespace islet
