// Convex shapes in double precision, worked out the slow and obvious way: what the engine's answers are measured against.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "islet/geometry.hpp"

namespace exact {

struct Point {
    double x = 0;
    double y = 0;
};

inline Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
inline Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
inline Point operator*(double s, Point a) { return {s * a.x, s * a.y}; }
inline double dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
inline double cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }
inline double length(Point a) { return std::sqrt(dot(a, a)); }
inline Point of(islet::Vec2 v) { return {static_cast<double>(v.x), static_cast<double>(v.y)}; }

inline Point moved(const islet::Transform& t, Point v) {
    const double c = static_cast<double>(t.q.c), s = static_cast<double>(t.q.s);
    return {c * v.x - s * v.y + static_cast<double>(t.p.x), s * v.x + c * v.y + static_cast<double>(t.p.y)};
}

/// Corners of a convex hull, counter-clockwise: one point, two points or a polygon.
using Core = std::vector<Point>;

inline Core core_of(const islet::Vec2* points, std::uint32_t count, const islet::Transform& t = {}) {
    Core out;
    for (std::uint32_t i = 0; i < count; ++i) out.push_back(moved(t, of(points[i])));
    return out;
}
inline Core core_of(const islet::Polygon& p, const islet::Transform& t = {}) { return core_of(p.vertices, p.count, t); }

/// The hull of any points (monotone chain), without collinear ones.
inline Core hull_of(Core points) {
    std::sort(points.begin(), points.end(), [](Point a, Point b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    Core hull;
    for (int side = 0; side < 2; ++side) {
        const std::size_t start = hull.size();
        for (Point p : points) {
            while (hull.size() >= start + 2 && cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0) hull.pop_back();
            hull.push_back(p);
        }
        if (hull.size() > 1) hull.pop_back();
        std::reverse(points.begin(), points.end());
    }
    return hull;
}

inline double point_segment(Point p, Point a, Point b) {
    const Point e = b - a;
    const double ee = dot(e, e);
    const double t = ee > 0 ? std::clamp(dot(p - a, e) / ee, 0.0, 1.0) : 0.0;
    return length(p - (a + t * e));
}

inline bool holds(const Core& c, Point p) {
    if (c.size() < 3) return false;
    for (std::size_t i = 0; i < c.size(); ++i) {
        if (cross(c[(i + 1) % c.size()] - c[i], p - c[i]) < 0) return false;
    }
    return true;
}

/// From p to the outline of c, whether inside or outside.
inline double to_outline(const Core& c, Point p) {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < c.size(); ++i) best = std::min(best, point_segment(p, c[i], c[(i + 1) % c.size()]));
    return best;
}
/// From p to the nearest point of c, 0 inside.
inline double to_core(const Core& c, Point p) { return holds(c, p) ? 0.0 : to_outline(c, p); }

inline bool segments_cross(Point a, Point b, Point c, Point d) {
    const double s1 = cross(b - a, c - a), s2 = cross(b - a, d - a), s3 = cross(d - c, a - c), s4 = cross(d - c, b - c);
    return ((s1 > 0) != (s2 > 0)) && ((s3 > 0) != (s4 > 0));
}

/// Between two convex cores; 0 when they overlap.
inline double distance(const Core& a, const Core& b) {
    double best = std::numeric_limits<double>::infinity();
    for (Point p : a) best = std::min(best, to_core(b, p));
    for (Point p : b) best = std::min(best, to_core(a, p));
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t j = 0; j < b.size(); ++j) {
            if (segments_cross(a[i], a[(i + 1) % a.size()], b[j], b[(j + 1) % b.size()])) return 0;
        }
    }
    return best;
}

/// How far b is in front of a along unit direction n; negative by the overlap.
inline double gap_along(const Core& a, const Core& b, Point n) {
    double front = -std::numeric_limits<double>::infinity(), back = std::numeric_limits<double>::infinity();
    for (Point p : a) front = std::max(front, dot(n, p));
    for (Point p : b) back = std::min(back, dot(n, p));
    return back - front;
}

/// Greatest gap along any outward face normal of a; a core of two points has both sides of its segment.
inline double best_face_gap(const Core& a, const Core& b) {
    double best = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Point e = a[(i + 1) % a.size()] - a[i];
        const Point n = (1 / length(e)) * Point{e.y, -e.x};
        best = std::max(best, gap_along(a, b, n));
    }
    return best;
}

/// Numbers that are the same with every standard library.
struct Random {
    std::mt19937 bits{20250101};
    double unit() { return static_cast<double>(bits()) / 4294967296.0; }
    float in(double low, double high) { return static_cast<float>(low + (high - low) * unit()); }
    std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(bits() % n); }
    islet::Transform pose(double reach) { return {{in(-reach, reach), in(-reach, reach)}, islet::make_rot(in(-3.2, 3.2))}; }
};

/// A random convex polygon of 3 to 8 corners within about `size` of the origin: boxes, needles, fans.
inline islet::Polygon random_polygon(Random& r, double size, float radius = 0) {
    for (;;) {
        if (r.below(3) == 0) {
            islet::Polygon box = islet::make_box(r.in(0.05 * size, size), r.in(0.05 * size, size));
            box.radius = radius;
            return box;
        }
        islet::Vec2 points[islet::max_polygon_vertices];
        const std::uint32_t n = 3 + r.below(6);
        const double squash = r.below(4) == 0 ? 0.1 : 1.0;
        for (std::uint32_t i = 0; i < n; ++i) points[i] = {r.in(-size, size), r.in(-size * squash, size * squash)};
        const islet::Polygon p = islet::make_polygon(islet::compute_hull({points, n}), radius);
        if (p.count >= 3) return p;
    }
}

}  // namespace exact
