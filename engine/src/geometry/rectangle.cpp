// Rectangles among the polygons.
#include "../exact.hpp"

#include "../geometry/convex.hpp"
#include "../math/scalar.hpp"

namespace islet::detail {

bool is_box(const Polygon& p) {
    const Vec2 n0 = p.normals[0];
    const Vec2 n1 = p.normals[1];
    const Vec2 n2 = p.normals[2];
    const Vec2 n3 = p.normals[3];
    // One sum instead of six comparisons: it is zero only if every term is.
    const float skew = magnitude_of(n1.x + n0.y) + magnitude_of(n1.y - n0.x) + magnitude_of(n2.x + n0.x) + magnitude_of(n2.y + n0.y) +
                       magnitude_of(n3.x + n1.x) + magnitude_of(n3.y + n1.y);
    return p.count == 4 && skew == 0.0f;
}

// The core, strips along the sides, and quarters of a disc at the corners.
MassData compute_box_mass(const Polygon& p, float density) {
    const Vec2 half = 0.5f * (p.vertices[2] - p.vertices[0]);
    const float h0 = -dot(half, p.normals[0]), h1 = dot(half, p.normals[1]), r = p.radius;
    const float core = 4.0f * h0 * h1, diagonal = h0 * h0 + h1 * h1, discs = pi * r * r;
    float area = core, second = core * diagonal * (1.0f / 3.0f);
    if (r > 0) {
        const float strip0 = 4.0f * h1 * r, strip1 = 4.0f * h0 * r;  // two of them, outside the faces across axis 0, and across axis 1
        const float far0 = h0 + 0.5f * r, far1 = h1 + 0.5f * r;
        area += strip0 + strip1 + discs;
        second += strip0 * (far0 * far0 + (4.0f * h1 * h1 + r * r) * (1.0f / 12.0f)) + strip1 * (far1 * far1 + (4.0f * h0 * h0 + r * r) * (1.0f / 12.0f));
        second += discs * (diagonal + 0.5f * r * r) + (8.0f / 3.0f) * (h0 + h1) * r * r * r;
    }
    return checked({density * area, 0.5f * (p.vertices[0] + p.vertices[2]), density * second});
}

}  // namespace islet::detail
