// Convex polygons, plain or rounded.
#include "../exact.hpp"

#include "../collide/outline_pair.hpp"
#include "../geometry/convex.hpp"
#include "../shapes/manifolds.hpp"
#include "../shapes/pen.hpp"
#include "../shapes/shape_types.hpp"

namespace islet {

using namespace detail;

namespace {

constexpr float unit_tolerance = 1e-3f;    // how far a hand-made normal's squared length may be from 1
constexpr float normal_tolerance = 1e-3f;  // rad: how far a hand-made normal may lean
constexpr float rounding = 4e-7f;          // of a coordinate: a polygon moved far away has its corners rounded, but not its normals

/// True if n is the outward unit normal of the edge from a to b.
bool is_normal(Vec2 n, Vec2 a, Vec2 b) {
    const Vec2 edge = b - a;
    const float farthest = max(max(abs(a.x), abs(a.y)), max(abs(b.x), abs(b.y)));
    const float lean = normal_tolerance * length(edge) + rounding * farthest;  // m, over the whole edge
    return abs(length_squared(n) - 1.0f) <= unit_tolerance && abs(dot(n, edge)) <= lean && cross(edge, n) < 0;
}

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
        const std::uint32_t j = next(i, p.count);
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

bool is_valid(const Polygon& p) {
    if (p.count < 3 || p.count > max_polygon_vertices || !is_radius(p.radius)) return false;
    for (std::uint32_t i = 0; i < p.count; ++i) {
        if (!in_range(p.vertices[i])) return false;
    }
    if (!is_strictly_convex({p.vertices, p.count})) return false;
    for (std::uint32_t i = 0; i < p.count; ++i) {
        const Vec2 a = p.vertices[i];
        const Vec2 b = p.vertices[next(i, p.count)];
        if (!is_normal(p.normals[i], a, b) || !(cross(b - a, p.centroid - a) > 0)) return false;
    }
    return true;
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

Aabb compute_aabb(const Polygon& p, const Transform& t) {
    return aabb_of({p.vertices, p.count < max_polygon_vertices ? p.count : max_polygon_vertices, p.radius}, t);
}
ShapeProxy make_proxy(const Polygon& p) { return is_valid(p) ? proxy_of(corners_of(p)) : ShapeProxy{}; }

void draw_shape(const DebugDraw& draw, const Polygon& p, const Transform& pose, const DrawStyle& style) {
    if (p.count > max_polygon_vertices) return;
    Vec2 corners[max_polygon_vertices];
    for (std::uint32_t i = 0; i < p.count; ++i) corners[i] = transform_point(pose, p.vertices[i]);
    Pen{draw, style}.polygon({corners, p.count}, p.radius);
}

namespace detail {

Geometry geometry_of(const Polygon& polygon) {
    Geometry g = blank_geometry(ShapeType::polygon);
    if (polygon.count > max_polygon_vertices) return g;
    g.polygon.count = polygon.count;
    g.polygon.radius = polygon.radius;
    g.polygon.centroid = polygon.centroid;
    for (std::uint32_t i = 0; i < polygon.count; ++i) {
        g.polygon.vertices[i] = polygon.vertices[i];
        g.polygon.normals[i] = polygon.normals[i];
    }
    return g;
}

Manifold collide(const Polygon& a, const Circle& b, const Transform& b_in_a, float margin) {
    const Vec2 center = transform_point(b_in_a, b.center);
    const float limit = margin + a.radius + b.radius;
    std::uint32_t face = 0;
    float separation = -3e38f;
    for (std::uint32_t i = 0; i < a.count; ++i) {
        const float s = dot(a.normals[i], center - a.vertices[i]);
        face = s > separation ? i : face;
        separation = max(s, separation);
    }
    if (separation > limit) { return none_within(separation - (a.radius + b.radius)); }

    // The corner closest to a centre outside always belongs to the face it is furthest in front of.
    const std::uint32_t next = face + 1 < a.count ? face + 1 : 0;
    const Vec2 v1 = a.vertices[face];
    const Vec2 v2 = a.vertices[next];
    const Vec2 n = a.normals[face];
    if (separation > 1e-6f) {
        if (dot(center - v1, v2 - v1) < 0.0f) { return collide_point(v1, a.radius, center, b.radius, n, margin, feature_id(face, 0)); }
        if (dot(center - v2, v1 - v2) < 0.0f) { return collide_point(v2, a.radius, center, b.radius, n, margin, feature_id(next, 0)); }
    }
    return point_manifold(center - separation * n, a.radius, center, b.radius, n, separation, feature_id(face, 0));
}

Manifold collide(const Polygon& a, const Polygon& b, const Transform& b_in_a, float margin) {
    if (!has_hulls || (is_box(a) && is_box(b))) return collide_boxes(a, b, b_in_a, margin);
    const Vec2 origin = a.vertices[0];
    return collide_cores(outline_of(a, origin), outline_of(b, b_in_a, origin), origin, margin);
}

Manifold collide(const Polygon& a, const Capsule& b, const Transform& b_in_a, float margin) {
    const Vec2 origin = a.vertices[0];
    const Transform t = {b_in_a.p - origin, b_in_a.q};
    return collide_cores(outline_of(a, origin), outline_of(transform_point(t, b.point1), transform_point(t, b.point2), b.radius), origin, margin);
}

}  // namespace detail

}  // namespace islet
