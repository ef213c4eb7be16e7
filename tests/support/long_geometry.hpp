// What queries should find, in long double: the hull of all differences of corners, and the signed distance of points from it, which is all that is needed to
// judge a distance, a cast or a miss. Shares no code and no formula with the engine.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "islet/query.hpp"

namespace long_exact {

using Real = long double;

struct Point {
    Real x = 0;
    Real y = 0;
};

inline Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
inline Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
inline Point operator*(Real s, Point a) { return {s * a.x, s * a.y}; }
inline Real dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
inline Real cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }
inline Real length(Point a) { return std::sqrt(dot(a, a)); }
inline Point of(islet::Vec2 v) { return {static_cast<Real>(v.x), static_cast<Real>(v.y)}; }

/// A convex outline, counter-clockwise and without collinear corners, grown by a radius.
struct Rounded {
    std::vector<Point> core;
    Real radius = 0;
};

inline std::vector<Point> hull_of(std::vector<Point> points) {
    std::sort(points.begin(), points.end(), [](Point a, Point b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    std::vector<Point> hull;
    for (int side = 0; side < 2; ++side) {
        const std::size_t start = hull.size();
        for (Point p : points) {
            while (hull.size() >= start + 2 && cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0) hull.pop_back();
            if (hull.size() == start || hull.back().x != p.x || hull.back().y != p.y) hull.push_back(p);
        }
        if (hull.size() > start + 1) hull.pop_back();
        std::reverse(points.begin(), points.end());
    }
    if (hull.size() == 2 && hull[0].x == hull[1].x && hull[0].y == hull[1].y) hull.pop_back();
    return hull;
}

/// Both shapes' corners in one frame.
struct Solid {
    std::vector<Point> corners;
    Real radius = 0;
};

inline Solid solid_of(const islet::ShapeProxy& p, const islet::Transform& t = {}) {
    Solid s;
    const Real c = static_cast<Real>(t.q.c), sine = static_cast<Real>(t.q.s);
    for (std::uint32_t i = 0; i < p.count; ++i) {
        const Point v = of(p.points[i]);
        s.corners.push_back(Point{c * v.x - sine * v.y, sine * v.x + c * v.y} + of(t.p));
    }
    s.radius = static_cast<Real>(p.radius);
    return s;
}

inline Rounded rounded_of(const Solid& s) { return {hull_of(s.corners), s.radius}; }

/// b - a: a moved by x meets b just when x is in it.
inline Rounded difference(const Solid& a, const Solid& b) {
    std::vector<Point> all;
    for (Point p : a.corners) {
        for (Point q : b.corners) all.push_back(q - p);
    }
    return {hull_of(all), a.radius + b.radius};
}

inline Real to_segment(Point p, Point a, Point b) {
    const Point e = b - a;
    const Real ee = dot(e, e);
    const Real t = ee > 0 ? std::clamp(dot(p - a, e) / ee, Real{0}, Real{1}) : Real{0};
    return length(p - (a + t * e));
}

/// Of a point from the outline, negative inside.
inline Real signed_distance(const Rounded& s, Point p) {
    const std::size_t n = s.core.size();
    Real least = length(p - s.core[0]);
    bool inside = n > 2;
    for (std::size_t i = 0; i < n && n > 1; ++i) {
        const Point a = s.core[i], b = s.core[(i + 1) % n];
        least = std::min(least, to_segment(p, a, b));
        inside = inside && cross(b - a, p - a) > 0;
    }
    return (inside ? -least : least) - s.radius;
}

/// The least signed distance on the way from p to p + d, by the golden section: along a line the distance from a convex set is convex.
inline Real least_on_way(const Rounded& s, Point p, Point d) {
    constexpr Real golden = 0.61803398874989484820L;
    Real low = 0, high = 1;
    Real first = high - golden * (high - low), second = low + golden * (high - low);
    Real at_first = signed_distance(s, p + first * d), at_second = signed_distance(s, p + second * d);
    Real least = std::min({signed_distance(s, p), signed_distance(s, p + d), at_first, at_second});
    for (int i = 0; i < 48; ++i) {
        if (at_first < at_second) {
            high = second;
            second = first;
            at_second = at_first;
            first = high - golden * (high - low);
            at_first = signed_distance(s, p + first * d);
        } else {
            low = first;
            first = second;
            at_first = at_second;
            second = low + golden * (high - low);
            at_second = signed_distance(s, p + second * d);
        }
        least = std::min({least, at_first, at_second});
    }
    return least;
}

/// Largest difference of two corners along an axis, the way and the radii counted in: what errors are measured by.
inline Real scale_of(const Solid& a, const Solid& b, Point way = {}) {
    Real largest = 1e-30L;
    for (Point p : a.corners) {
        for (Point q : b.corners) {
            const Point d = q - p;
            largest = std::max({largest, std::fabs(d.x), std::fabs(d.y), std::fabs(d.x - way.x), std::fabs(d.y - way.y)});
        }
    }
    return std::max({largest, std::fabs(way.x), std::fabs(way.y), a.radius + b.radius});
}

/// The largest coordinate: a point cannot be told more exactly than that is rounded.
inline Real reach_of(const Solid& s) {
    Real largest = 0;
    for (Point p : s.corners) largest = std::max({largest, std::fabs(p.x) + s.radius, std::fabs(p.y) + s.radius});
    return largest;
}

}  // namespace long_exact
