// Segments. They collide as capsules without a radius (manifolds.hpp).
#include "../exact.hpp"

#include "../geometry/convex.hpp"
#include "../shapes/pen.hpp"
#include "../shapes/shape_types.hpp"

namespace islet {

using namespace detail;

bool is_valid(const Segment& s) { return are_apart(s.point1, s.point2); }

Aabb compute_aabb(const Segment& s, const Transform& t) { return aabb_of(corners_of(s), t); }
ShapeProxy make_proxy(const Segment& s) { return is_valid(s) ? proxy_of(corners_of(s)) : ShapeProxy{}; }

void draw_shape(const DebugDraw& draw, const Segment& s, const Transform& pose, const DrawStyle& style) {
    Pen{draw, style}.segment(transform_point(pose, s.point1), transform_point(pose, s.point2));
}

}  // namespace islet
