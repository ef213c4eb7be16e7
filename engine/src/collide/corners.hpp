// Any geometry as the points whose hull, grown by a radius, it is.
#pragma once

#include "../data/records.hpp"
#include "../math/inlining.hpp"

namespace islet::detail {

struct Corners {
    const Vec2* points;  // in the body's frame
    std::uint32_t count;
    float radius;
};

static_assert(sizeof(Segment) == 2 * sizeof(Vec2) && offsetof(Capsule, point2) == sizeof(Vec2));  // the points are an array

ISLET_SHARED Corners corners_of(const Geometry& g) {
    const ShapeType type = g.shape_type();
    if (type == ShapeType::polygon) return {g.polygon.vertices, g.polygon.count, g.polygon.radius};
    switch (type) {
        case ShapeType::circle: return {&g.circle.center, 1, g.circle.radius};
        case ShapeType::capsule: return {reinterpret_cast<const Vec2*>(&g.capsule), 2, g.capsule.radius};
        case ShapeType::segment: return {reinterpret_cast<const Vec2*>(&g.segment), 2, 0};
        default: return {reinterpret_cast<const Vec2*>(&g.chain.segment), 2, 0};
    }
}

}  // namespace islet::detail
