// What queries should find, in double precision and by the plainest formulas: hulls of all differences of corners, discs, strips and lines one by one.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "islet/query.hpp"
#include "unit/exact_geometry.hpp"

namespace oracle {

using exact::Core;
using exact::Point;

/// A convex core grown by a radius, in the world.
struct Solid {
    Core core;
    double radius = 0;
    bool one_sided = false;
};

inline Solid solid_of(const islet::ShapeProxy& p, const islet::Transform& t = {}) {
    return {exact::core_of(p.points, p.count, t), static_cast<double>(p.radius), p.one_sided};
}

/// Largest difference of two corners: what errors are measured by.
inline double scale_of(const Solid& a, const Solid& b, Point way = {}) {
    double largest = 1e-30;
    for (Point p : a.core) {
        for (Point q : b.core) {
            const Point d = q - p;
            largest = std::max({largest, std::fabs(d.x), std::fabs(d.y), std::fabs(d.x - way.x), std::fabs(d.y - way.y)});
        }
    }
    return std::max({largest + a.radius + b.radius, std::fabs(way.x), std::fabs(way.y)});
}

/// Negative inside: then the least gap of any face is how deep the cores overlap.
inline double signed_distance(const Solid& a, const Solid& b) {
    double d = exact::distance(a.core, b.core);
    const double faces = std::max(a.core.size() > 1 ? exact::best_face_gap(a.core, b.core) : -1e300,
                                  b.core.size() > 1 ? exact::best_face_gap(b.core, a.core) : -1e300);
    if (faces > -1e300 && d <= 0) d = std::min(0.0, faces);
    return d - a.radius - b.radius;
}

inline Solid moved(Solid s, Point by) {
    for (Point& p : s.core) p = p + by;
    return s;
}

/// The difference b - a: a moved by x meets b just when x is in it.
inline Solid difference(const Solid& a, const Solid& b) {
    Core all;
    for (Point p : a.core) {
        for (Point q : b.core) all.push_back(q - p);
    }
    return {exact::hull_of(all), a.radius + b.radius, false};
}

/// From the origin; negative inside.
inline double depth_at(const Solid& s, Point p) { return signed_distance({{p}, 0, false}, s); }

constexpr double never = std::numeric_limits<double>::infinity();

/// Where the ray from p along d enters the disc, if p is outside.
inline double into_disc(Point p, Point d, Point center, double radius) {
    const Point m = p - center;
    const double a = exact::dot(d, d), b = exact::dot(m, d), c = exact::dot(m, m) - radius * radius;
    if (b >= 0 || b * b < a * c) return never;
    return (-b - std::sqrt(b * b - a * c)) / a;
}

/// Where it crosses the segment u-v.
inline double onto_segment(Point p, Point d, Point u, Point v) {
    const Point e = v - u;
    const double den = exact::cross(d, e);
    if (den == 0) return never;
    const double t = exact::cross(u - p, e) / den, s = exact::cross(u - p, d) / den;
    return s >= 0 && s <= 1 ? t : never;
}

/// First fraction of the way at which the point p, moved along d, is in the solid: the first of all discs and all strips' sides.
inline double first_entry(const Solid& s, Point p, Point d) {
    if (depth_at(s, p) < 0) return 0;
    double first = never;
    const auto take = [&](double t) {
        if (t >= 0 && t <= 1) first = std::min(first, t);
    };
    const std::size_t n = s.core.size();
    for (std::size_t i = 0; i < n; ++i) {
        if (s.radius > 0) take(into_disc(p, d, s.core[i], s.radius));
        if (n == 1) continue;
        const Point u = s.core[i], v = s.core[(i + 1) % n], e = v - u;
        const Point out = (s.radius / exact::length(e)) * Point{e.y, -e.x};
        take(onto_segment(p, d, u + out, v + out));
    }
    return first;
}

/// The least signed distance of the point from the solid on its way, by thirds: the distance from a convex set is convex along a line.
inline double least_on_way(const Solid& s, Point p, Point d) {
    double low = 0, high = 1;
    for (int i = 0; i < 90; ++i) {
        const double a = low + (high - low) / 3, b = high - (high - low) / 3;
        if (depth_at(s, p + a * d) < depth_at(s, p + b * d)) {
            high = b;
        } else {
            low = a;
        }
    }
    return depth_at(s, p + 0.5 * (low + high) * d);
}

/// True if a displacement by `tolerance` may decide whether the point p meets the solid on its way d.
inline bool is_doubtful(const Solid& s, Point p, Point d, double tolerance) {
    if (s.core.size() != 2 || s.radius > 0) return std::fabs(least_on_way(s, p, d)) < tolerance;
    // A line: it is met near one of its ends, or near an end of the way.
    const Point u = s.core[0], e = s.core[1] - u;
    const double den = exact::cross(d, e), way = exact::length(d), length = exact::length(e);
    const double room = tolerance * way * length / std::max(std::fabs(den), 1e-300);
    const double along = exact::cross(u - p, d) / den * length, at = exact::cross(u - p, e) / den * way;
    return std::min(std::fabs(along), std::fabs(length - along)) < room || std::min(std::fabs(at), std::fabs(way - at)) < room;
}

/// True if a one-sided target lets the cast pass.
inline bool passes(const Solid& moving, Point d, const Solid& target) {
    if (!target.one_sided) return false;
    const Point e = target.core[1] - target.core[0], n{e.y, -e.x};
    Point middle;
    for (Point p : moving.core) middle = middle + (1.0 / static_cast<double>(moving.core.size())) * p;
    return exact::dot(n, d) >= 0 || exact::dot(n, middle - target.core[0]) < 0;
}

}  // namespace oracle
