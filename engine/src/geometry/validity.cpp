// Which shapes the engine accepts. Every comparison is written so that NaN fails it.
#include "../exact.hpp"

#include "../geometry/convex.hpp"
#include "../math/inlining.hpp"

namespace islet {
namespace {

constexpr float unit_tolerance = 1e-3f;    // how far a hand-made normal's squared length may be from 1
constexpr float normal_tolerance = 1e-3f;  // rad: how far a hand-made normal may lean
constexpr float rounding = 4e-7f;          // of a coordinate: a polygon moved far away has its corners rounded, but not its normals

ISLET_SHARED bool are_apart(Vec2 a, Vec2 b) {
    return detail::in_range(a) && detail::in_range(b) && distance_squared(a, b) > detail::min_length * detail::min_length;
}

// A chain that goes on straight beyond its end has a ghost that mirrors one end of the last segment at the other, so it may lie beyond max_position.
ISLET_SHARED bool is_ghost(Vec2 a) { return detail::in_range(0.25f * a); }

/// True if n is the outward unit normal of the edge from a to b.
bool is_normal(Vec2 n, Vec2 a, Vec2 b) {
    const Vec2 edge = b - a;
    const float farthest = max(max(abs(a.x), abs(a.y)), max(abs(b.x), abs(b.y)));
    const float lean = normal_tolerance * length(edge) + rounding * farthest;  // m, over the whole edge
    return abs(length_squared(n) - 1.0f) <= unit_tolerance && abs(dot(n, edge)) <= lean && cross(edge, n) < 0;
}

}  // namespace

namespace detail {

bool is_strictly_convex(std::span<const Vec2> points) {
    const auto count = static_cast<std::uint32_t>(points.size());
    if (count < 3) return false;
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t j = next(i, count);
        const Vec2 edge = points[j] - points[i];
        for (std::uint32_t k = 0; k < count; ++k) {
            if (k != i && k != j && !(cross(edge, points[k] - points[i]) > 0)) return false;
        }
    }
    return true;
}

}  // namespace detail

bool is_valid(const Circle& c) { return detail::in_range(c.center) && c.radius > 0 && c.radius <= detail::max_coordinate; }

bool is_valid(const Capsule& c) { return are_apart(c.point1, c.point2) && c.radius > 0 && c.radius <= detail::max_coordinate; }

bool is_valid(const Segment& s) { return are_apart(s.point1, s.point2); }

bool is_valid(const ChainSegment& s) { return is_valid(s.segment) && is_ghost(s.ghost1) && is_ghost(s.ghost2); }

bool is_valid(const Polygon& p) {
    if (p.count < 3 || p.count > max_polygon_vertices || !detail::is_radius(p.radius)) return false;
    for (std::uint32_t i = 0; i < p.count; ++i) {
        if (!detail::in_range(p.vertices[i])) return false;
    }
    if (!detail::is_strictly_convex({p.vertices, p.count})) return false;
    for (std::uint32_t i = 0; i < p.count; ++i) {
        const Vec2 a = p.vertices[i];
        const Vec2 b = p.vertices[detail::next(i, p.count)];
        if (!is_normal(p.normals[i], a, b) || !(cross(b - a, p.centroid - a) > 0)) return false;
    }
    return true;
}

}  // namespace islet
