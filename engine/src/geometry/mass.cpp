// Mass, centre of mass and inertia of solid shapes. Areas below are multiplied by the density at the very end.
#include "../exact.hpp"

#include "../geometry/convex.hpp"
#include "../math/inlining.hpp"

namespace islet {
namespace {

ISLET_SHARED bool is_density(float density) { return density >= 0 && is_finite(density); }

/// A density may be finite and still too much for the shape: no mass rather than an infinite one.
MassData checked(const MassData& m) { return is_finite(m.mass) && is_finite(m.inertia) ? m : MassData{}; }

/// Area, its first moment about the origin, and its second polar moment about the origin. Moments of parts add up.
struct Moments {
    float area = 0;
    Vec2 first;
    float second = 0;
};

void add(Moments& sum, float area, Vec2 first, float second) {
    sum.area += area;
    sum.first += first;
    sum.second += second;
}

/// A part whose centre of area is c and whose polar moment about c is `own` (parallel axis theorem).
void add_centered(Moments& sum, float area, Vec2 c, float own) { add(sum, area, area * c, own + area * length_squared(c)); }

/// Triangle (0, a, b), counter-clockwise if positive.
void add_triangle(Moments& sum, Vec2 a, Vec2 b) {
    const float area = 0.5f * cross(a, b);
    add(sum, area, area * (a + b) * (1.0f / 3.0f), area * (dot(a, a) + dot(a, b) + dot(b, b)) * (1.0f / 6.0f));
}

/// Circular sector around v from normal n1 to n2. With u(t) the unit vector at angle t, the sector is v + rho u(t), and the integral of
/// u over the sector's angle is right_perp(n2 - n1): no trigonometry but the angle itself.
void add_sector(Moments& sum, Vec2 v, float radius, Vec2 n1, Vec2 n2) {
    const float angle = atan2(cross(n1, n2), dot(n1, n2));
    const float square = radius * radius;
    const float area = 0.5f * angle * square;
    const Vec2 about_v = square * radius * (1.0f / 3.0f) * right_perp(n2 - n1);  // first moment, measured from v
    add(sum, area, area * v + about_v, 0.25f * angle * square * square + 2.0f * dot(v, about_v) + area * length_squared(v));
}

/// Minkowski sum of the polygon and a disc, about `origin`: the polygon, a rectangle on every edge, a sector at every corner.
Moments polygon_moments(const Polygon& p, Vec2 origin) {
    Moments sum;
    for (std::uint32_t i = 0; i < p.count; ++i) {
        const std::uint32_t j = detail::next(i, p.count);
        const Vec2 a = p.vertices[i] - origin;
        const Vec2 b = p.vertices[j] - origin;
        add_triangle(sum, a, b);
        if (p.radius > 0) {
            const float len = distance(a, b);
            const float area = len * p.radius;
            add_centered(sum, area, 0.5f * (a + b + p.radius * p.normals[i]), area * (len * len + p.radius * p.radius) * (1.0f / 12.0f));
            add_sector(sum, b, p.radius, p.normals[i], p.normals[j]);
        }
    }
    return sum;
}

}  // namespace

MassData compute_mass(const Circle& c, float density) {
    if (!is_valid(c) || !is_density(density)) return {};
    const float square = c.radius * c.radius;
    const float mass = density * pi * square;
    return checked({mass, c.center, mass * 0.5f * square});
}

/// A rectangle and two half discs. A half disc's centre of area is 4 r / (3 pi) from its straight side, so about the capsule's centre, h
/// away, the two have m (r^2 / 2 + h^2 + 2 h 4 r / (3 pi)).
MassData compute_mass(const Capsule& c, float density) {
    if (!is_valid(c) || !is_density(density)) return {};
    const float r = c.radius;
    const float len = distance(c.point1, c.point2);
    const float h = 0.5f * len;
    const float rectangle = density * 2.0f * r * len;
    const float discs = density * pi * r * r;
    const float of_rectangle = rectangle * (len * len + 4.0f * r * r) * (1.0f / 12.0f);
    const float of_discs = discs * (0.5f * r * r + h * h + 8.0f / (3.0f * pi) * h * r);
    return checked({rectangle + discs, lerp(c.point1, c.point2, 0.5f), of_rectangle + of_discs});
}

/// Moments about vertex 0 give the centre of mass; a second pass about that centre gives the inertia without subtracting large numbers.
MassData compute_mass(const Polygon& p, float density) {
    if (!is_valid(p) || !is_density(density)) return {};
    const Vec2 origin = p.vertices[0];
    const Moments rough = polygon_moments(p, origin);
    if (!(rough.area > 0)) return {};
    const Vec2 center = origin + rough.first * (1.0f / rough.area);
    return checked({density * rough.area, center, density * polygon_moments(p, center).second});
}

}  // namespace islet
