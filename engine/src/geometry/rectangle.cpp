// Rectangles among the polygons.
#include "../exact.hpp"

#include "../geometry/convex.hpp"
#include "../math/scalar.hpp"

namespace islet::detail {

// Normals alone do not tell: those of a thin box that was moved far from the origin stay as they are, but its corners are rounded.
bool is_box(const Polygon& p) {
    const Vec2 n0 = p.normals[0], n1 = p.normals[1], n2 = p.normals[2], n3 = p.normals[3];
    // One sum instead of six comparisons: it is zero only if every term is.
    const float skew = magnitude_of(n1.x + n0.y) + magnitude_of(n1.y - n0.x) + magnitude_of(n2.x + n0.x) + magnitude_of(n2.y + n0.y) +
                       magnitude_of(n3.x + n1.x) + magnitude_of(n3.y + n1.y);
    const Vec2 side0 = p.vertices[1] - p.vertices[0], side1 = p.vertices[2] - p.vertices[1], rest = p.vertices[3] - p.vertices[0] - side1;
    const float off = magnitude_of(dot(side0, n0)) + magnitude_of(dot(side1, n1)) + magnitude_of(rest.x) + magnitude_of(rest.y);
    return p.count == 4 && skew == 0.0f && off <= 0.1f * min_length;
}

}  // namespace islet::detail
