#include "../exact.hpp"

#include "../shapes/shape_types.hpp"

namespace islet::detail {

Vec2 middle_of(const Geometry& g) {
    if (const Polygon* polygon = faces_of(g)) return polygon->centroid;
    const Corners corners = corners_of(g);
    return lerp(corners.points[0], corners.points[corners.count - 1], 0.5f);
}

Around around(const Corners& other, const Transform& t) {
    float reach = 0;
    for (std::uint32_t i = 1; i < other.count; ++i) reach = max(reach, distance(other.points[0], other.points[i]));
    return {transform_point(t, other.points[0]), reach + other.radius};
}

ShapeProxy proxy_of(const Corners& corners) {
    ShapeProxy p;
    for (std::uint32_t i = 0; i < corners.count; ++i) p.points[i] = corners.points[i];
    p.count = corners.count;
    p.radius = corners.radius;
    return p;
}

}  // namespace islet::detail
