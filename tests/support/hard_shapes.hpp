// Pairs of shapes that rounding is hard on, as worlds are full of them: equal, touching, parallel, collinear or nearly so, one far larger than the other,
// a thousand times longer than wide, turned by quarters through pi, far from the origin.
#pragma once

#include <cstdio>
#include <string>

#include "islet/query.hpp"
#include "unit/exact_geometry.hpp"

namespace islet::test {

/// Either 1 or -1.
inline double random_sign(exact::Random& r) { return r.below(2) == 0 ? 1 : -1; }

/// Off by nothing in a third of all cases, by 1e-14 to 1e-3 of either sign in half of them, else by anything up to `most`.
inline double nudge(exact::Random& r, double most) {
    const std::uint32_t kind = r.below(6);
    if (kind < 2) return 0;
    if (kind == 5) return double(r.in(-most, most));
    return random_sign(r) * std::pow(10.0, double(r.in(-14, -3)));
}

/// None, multiples of a quarter through pi (up to twice around), or any; sometimes off by very little.
inline float hard_angle(exact::Random& r) {
    switch (r.below(4)) {
    case 0: return 0;
    case 1: return static_cast<float>(static_cast<int>(r.below(17)) - 8) * (pi / 2);
    case 2: return static_cast<float>(double(static_cast<int>(r.below(9)) - 4) * (double(pi) / 2) + nudge(r, 1e-3));
    default: return r.in(-3.2, 3.2);
    }
}

/// A pose within `reach` of the origin (m) at such an angle.
inline Transform hard_pose(exact::Random& r, double reach) { return {{r.in(-reach, reach), r.in(-reach, reach)}, make_rot(hard_angle(r))}; }

/// Corners around the frame's origin: regular, boxes, needles, random ones, some with a corner that hardly stands out.
inline Polygon hard_polygon(exact::Random& r, double size, float radius = 0) {
    for (;;) {
        Polygon p;
        switch (r.below(5)) {
        case 0: {
            const double thin = r.below(2) == 0 ? 1 : std::pow(10.0, double(r.in(-3, 0)));
            p = r.below(2) == 0 ? make_box(float(size), float(size * thin)) : make_box(float(size * thin), float(size));
            p.radius = radius;
            break;
        }
        case 1: {
            const std::uint32_t n = 3 + r.below(6);
            Vec2 corners[max_polygon_vertices];
            for (std::uint32_t i = 0; i < n; ++i) corners[i] = float(size) * Vec2{make_rot(2 * pi * float(i) / float(n)).c, make_rot(2 * pi * float(i) / float(n)).s};
            p = make_polygon(compute_hull({corners, n}), radius);
            break;
        }
        case 2: {  // a roof so flat that its corner is barely one
            const float x = float(size), y = r.in(0.1 * size, size), lift = float(std::pow(10.0, double(r.in(-3.2, -2))) * std::max(1.0, size));
            const Vec2 corners[] = {{-x, -y}, {x, -y}, {x, y}, {r.in(-0.9 * size, 0.9 * size), y + lift}, {-x, y}};
            p = make_polygon(compute_hull(corners), radius);
            break;
        }
        default: p = exact::random_polygon(r, size, radius);
        }
        if (p.count >= 3) return p;
    }
}

/// A shape of any type, about `size` large. Its corners are off by nudges now and then, all by themselves.
inline ShapeProxy hard_shape(exact::Random& r, double size, bool with_one_sided) {
    for (;;) {
        const float s = float(size), radius = float(size * std::pow(10.0, double(r.in(-2, 0))));
        const Vec2 end = r.below(2) == 0 ? Vec2{0, s} : r.below(2) == 0 ? Vec2{s, 0} : Vec2{r.in(-size, size), r.in(-size, size)};
        const Vec2 start = r.below(2) == 0 ? Vec2{} : r.below(2) == 0 ? -end : Vec2{r.in(-size, size), r.in(-size, size)};
        ShapeProxy p;
        switch (r.below(with_one_sided ? 6 : 5)) {
        case 0: p = make_proxy(Circle{start, radius}); break;
        case 1: p = make_proxy(Capsule{start, end, radius}); break;
        case 2: p = make_proxy(Segment{start, end}); break;
        case 3: p = make_proxy(hard_polygon(r, size)); break;
        case 4: p = make_proxy(hard_polygon(r, size, radius)); break;
        default: p = make_proxy(ChainSegment{start, {start, end}, end});
        }
        if (p.count == 0) continue;
        if (r.below(3) == 0) {
            for (std::uint32_t i = 0; i < p.count; ++i) p.points[i] += Vec2{float(size * nudge(r, 1e-3)), float(size * nudge(r, 1e-3))};
        }
        if (is_valid(p)) return p;
    }
}

struct HardPair {
    ShapeProxy a, b;   // in their own frames
    Transform pose_a, pose_b;
    Vec2 along;        // of the edge of a that b was laid along
    Vec2 out;          // across it, away from a
    double size = 1;   // of the larger
};

/// Mostly b lies along an edge of a, or nearly so, with its corner at one of a's, or on a's surface, or nearly so. `reach`: how far apart or deep they may be,
/// of the smaller one's size; `far`: how far from the origin, m.
inline HardPair hard_pair(exact::Random& r, bool with_one_sided, double reach = 1, double far = 1e6) {
    for (;;) {
        HardPair c;
        c.size = std::pow(10.0, double(r.in(-1, 2.5)));
        const double smaller = r.below(3) == 0 ? 1 : std::pow(10.0, double(r.in(-3, 0)));
        const bool b_smaller = r.below(2) == 0;
        c.a = hard_shape(r, b_smaller ? c.size : c.size * smaller, with_one_sided);
        c.b = r.below(6) == 0 ? c.a : hard_shape(r, b_smaller ? c.size * smaller : c.size, with_one_sided);
        const float turn = hard_angle(r);
        const Vec2 place = r.below(2) == 0 ? Vec2{} : Vec2{float(random_sign(r) * std::pow(10.0, r.in(-1, std::log10(far)))), r.in(-far, far)};
        c.pose_a = {r.below(3) == 0 ? place : Vec2{}, make_rot(turn)};

        // b's edge along a's, either way.
        const std::uint32_t i = r.below(c.a.count), j = r.below(c.b.count);
        const Vec2 edge_a = c.a.points[(i + 1) % c.a.count] - c.a.points[i], edge_b = c.b.points[(j + 1) % c.b.count] - c.b.points[j];
        const double angle_a = std::atan2(double(edge_a.y), double(edge_a.x)), angle_b = std::atan2(double(edge_b.y), double(edge_b.x));
        const double half = r.below(4) == 0 ? 0 : 3.14159265358979323846;
        float other = float(double(turn) + angle_a - angle_b + half + nudge(r, 3.2));
        if (r.below(3) == 0) other = r.below(2) == 0 ? turn : turn + float(r.below(4)) * (pi / 2);
        c.pose_b.q = make_rot(other);
        c.along = rotate(c.pose_a.q, edge_a);
        const double length = std::sqrt(double(c.along.x) * double(c.along.x) + double(c.along.y) * double(c.along.y));
        c.along = length > 0 ? Vec2{float(double(c.along.x) / length), float(double(c.along.y) / length)} : Vec2{1, 0};
        c.out = right_perp(c.along);

        // Its corner at a's corner, or along its edge, or beyond its end; and touching but for a nudge.
        const double ends[] = {0, 1, double(r.in(0, 1)), double(r.in(-0.5, 1.5)), nudge(r, 1)};
        const double at = ends[r.below(5)];
        const double gap = double(c.a.radius) + double(c.b.radius) + c.size * smaller * nudge(r, reach);
        const Vec2 corner = c.a.points[i] + float(at) * edge_a;
        c.pose_b.p = c.pose_a.p + rotate(c.pose_a.q, corner) + float(gap) * c.out - rotate(c.pose_b.q, c.b.points[j]);
        if (r.below(16) == 0) c.pose_b = c.pose_a;
        if (transform_proxy(c.pose_a, c.a).count > 0 && transform_proxy(c.pose_b, c.b).count > 0) return c;
    }
}

/// For messages: a point, or the corners and the radius of a shape, as they can be pasted into a program.
inline std::string text_of(Vec2 v) {
    char number[64];
    std::snprintf(number, sizeof number, "{%.9gf, %.9gf}", double(v.x), double(v.y));
    return number;
}
inline std::string text_of(const ShapeProxy& p) {
    char radius[32];
    std::snprintf(radius, sizeof radius, "{r %.9g:", double(p.radius));
    std::string text = radius;
    for (std::uint32_t i = 0; i < p.count; ++i) text += " " + text_of(p.points[i]);
    return text + "}";
}

}  // namespace islet::test
