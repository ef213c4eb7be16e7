#include "collide/difference.hpp"

#include "geometry/convex.hpp"
#include "math/scalar.hpp"

namespace islet::detail {
namespace {

// Corners closer than this (m) are one: an edge between them would have no direction.
constexpr float same_point = 1e-9f;
// Translations shorter than this (m) lead nowhere.
constexpr float least_way = 1e-10f;

bool is_lower(Vec2 p, Vec2 q) { return p.y < q.y || (p.y == q.y && p.x < q.x); }

// A walk around the edges of a polygon from its lowest corner (sign 1), or around those of its mirror image at the origin (sign -1): either way
// counter-clockwise, so the directions of the edges only turn left.
struct EdgeWalk {
    const Vec2* points;
    std::uint32_t count;
    float sign;
    std::uint32_t at = 0;
    std::uint32_t left = 0;  // edges not walked yet

    EdgeWalk(const ShapeProxy& p, float s) : points(p.points), count(p.count), sign(s), left(p.count > 1 ? p.count : 0) {
        for (std::uint32_t i = 1; i < count; ++i) {
            if (is_lower(sign * points[i], sign * points[at])) at = i;
        }
    }
    Vec2 edge() const { return sign * (points[next(at, count)] - points[at]); }
    void advance() {
        at = next(at, count);
        --left;
    }
};

void push(Difference& w, Vec2 point, std::uint32_t a, std::uint32_t b) {
    if (w.count > 0 && distance_squared(w.points[w.count - 1], point) <= same_point * same_point) return;
    w.points[w.count] = point;
    w.index_a[w.count] = static_cast<std::uint8_t>(a);
    w.index_b[w.count] = static_cast<std::uint8_t>(b);
    ++w.count;
}

Vec2 edge_of(const Difference& w, std::uint32_t k) { return w.points[next(k, w.count)] - w.points[k]; }

Impact start_inside(const Nearest& n) { return {true, 0, n.normal, n.distance, n.place}; }

// The ray's point q, at `from` of the way, is outside the disc around a corner; where does it enter from there on?
Impact against_corner(const Difference& w, std::uint32_t corner, Vec2 q, float from, Vec2 d) {
    const Vec2 m = q - w.points[corner];
    const float dd = length_squared(d);
    const float b = dot(m, d);
    if (!(b < 0)) return {};
    // h is the way's point closest to the corner, seen from there: it and the chord have no difference of large squares.
    const float s = -b / dd;
    const Vec2 h = m + s * d;
    const float rest = w.radius * w.radius - length_squared(h);
    if (!(rest > 1e-30f)) return {};
    const float back = sqrt(rest / dd);
    const float t = max(from + (s - back), 0.0f);
    if (!(t <= 1)) return {};
    return {true, t, normalize(h - back * d), 0, {corner, 0}};
}

// Two corners and no radius: a line, met where the ray has one corner on each side. The sides are worked out from the corners alone, so a ray cannot slip
// between two segments that share a corner.
Impact against_line(const Difference& w, Vec2 d) {
    const float s0 = cross(d, w.points[0]);
    const float s1 = cross(d, w.points[1]);
    const bool one_side = (s0 > 0 && s1 > 0) || (s0 < 0 && s1 < 0);
    if (one_side || s0 == s1) return {};
    const float along = clamp(s0 / (s0 - s1), 0, 1);
    const Vec2 edge = edge_of(w, 0);
    const float t = dot(w.points[0] + along * edge, d) / length_squared(d);
    if (!(t >= 0 && t <= 1)) return {};
    const Vec2 n = normalize(right_perp(edge));
    return {true, t, dot(n, d) < 0 ? n : -n, 0, {0, along}};
}

}  // namespace

Difference difference_of(const ShapeProxy& a, const ShapeProxy& b) {
    Difference w;
    w.radius = a.radius + b.radius;
    // Edges of both, merged by direction: at each corner the one that turns less comes next, parallel ones together.
    EdgeWalk on_b(b, 1);
    EdgeWalk on_a(a, -1);
    push(w, b.points[on_b.at] - a.points[on_a.at], on_a.at, on_b.at);
    while (on_a.left + on_b.left > 0) {  // at most 16 times
        const float turn = on_a.left == 0 ? 1.0f : (on_b.left == 0 ? -1.0f : cross(on_b.edge(), on_a.edge()));
        if (turn >= 0) on_b.advance();
        if (turn <= 0) on_a.advance();
        if (on_a.left + on_b.left > 0) push(w, b.points[on_b.at] - a.points[on_a.at], on_a.at, on_b.at);
    }
    while (w.count > 1 && distance_squared(w.points[w.count - 1], w.points[0]) <= same_point * same_point) --w.count;
    return w;
}

Nearest nearest(const Difference& w) {
    if (w.count == 1) {
        const Vec2 n = normalize(-w.points[0]);
        return {length(w.points[0]) - w.radius, n != Vec2{} ? n : Vec2{0, 1}, {0, 0}};
    }
    Nearest inside{-3.0e38f, {}, {}};
    Nearest outside{0, {}, {}};
    float least = 3.0e38f;  // squared distance of `outside`
    const bool line = w.count == 2;
    const std::uint32_t edges = line ? 1 : w.count;
    for (std::uint32_t k = 0; k < edges; ++k) {
        const Vec2 p = w.points[k];
        const Vec2 e = edge_of(w, k);
        Vec2 n = normalize(right_perp(e));
        float gap = -dot(n, p);  // of the origin above the edge
        if (line && gap < 0) {
            n = -n;
            gap = -gap;
        }
        const float along = clamp(-dot(p, e) / length_squared(e), 0, 1);
        if (gap > inside.distance) inside = {gap, n, {k, along}};
        if (!line && !(gap > 0)) continue;
        const float squared = length_squared(p + along * e);
        if (!(squared < least)) continue;
        least = squared;
        if (along > 0 && along < 1) {
            outside = {gap, n, {k, along}};
            continue;
        }
        const std::uint32_t corner = along > 0 ? next(k, w.count) : k;
        const Vec2 away = normalize(-w.points[corner]);
        outside = {length(w.points[corner]), away != Vec2{} ? away : n, {corner, 0}};
    }
    Nearest& result = least < 3.0e38f ? outside : inside;
    result.distance -= w.radius;
    return result;
}

// The outline lies within the planes of its edges, moved outward by the radius (Cyrus and Beck 1978): the ray is inside from the last plane that it enters to
// the first that it leaves. Planes meet beyond the round corners, so a ray that enters there is tried against the disc around the corner; if it misses that, it
// leaves by the corner's other plane and misses the whole.
Impact impact(const Difference& w, Vec2 d) {
    if (!(length_squared(d) >= least_way * least_way)) {
        const Nearest n = nearest(w);
        return n.distance < 0 ? start_inside(n) : Impact{};
    }
    if (w.count == 1) {
        const Nearest n = nearest(w);
        return n.distance < 0 ? start_inside(n) : against_corner(w, 0, {}, 0, d);
    }
    if (w.count == 2 && w.radius == 0) return against_line(w, d);

    float enter = -1;
    float leave = 3.0e38f;
    std::uint32_t face = 0;
    for (std::uint32_t k = 0; k < w.count; ++k) {
        const Vec2 e = edge_of(w, k);
        const Vec2 n = right_perp(e);  // not unit: only ratios matter
        const float room = dot(n, w.points[k]) + (w.radius > 0 ? w.radius * length(e) : 0);
        const float speed = dot(n, d);
        if (speed < 0) {
            const float t = room / speed;
            face = t > enter ? k : face;
            enter = max(t, enter);
        } else if (speed > 0) {
            leave = min(leave, room / speed);
        } else if (!(room > 0)) {
            return {};
        }
    }
    if (!(enter <= leave) || !(leave > 0) || enter > 1) return {};
    if (enter < 0) {
        const Nearest n = nearest(w);
        if (n.distance < 0 || (n.place.along > 0 && dot(n.normal, d) < 0)) return start_inside(n);
        return against_corner(w, n.place.corner, {}, 0, d);
    }
    const Vec2 q = enter * d;
    const Vec2 e = edge_of(w, face);
    const float along = dot(q - w.points[face], e) / length_squared(e);
    if (w.radius > 0 && !(along >= 0 && along <= 1)) return against_corner(w, along < 0 ? face : next(face, w.count), q, enter, d);
    return {true, max(enter, 0.0f), normalize(right_perp(e)), 0, {face, clamp(along, 0, 1)}};
}

Vec2 point_of(const Difference& w, const std::uint8_t* index, const Vec2* points, Place place) {
    const Vec2 p = points[index[place.corner]];
    const Vec2 q = points[index[next(place.corner, w.count)]];
    return lerp(p, q, place.along);
}

CastHit cast_proxy(const ShapeProxy& moving, Vec2 translation, const ShapeProxy& target) {
    if (target.one_sided && target.count == 2) {
        const Vec2 n = right_perp(target.points[1] - target.points[0]);
        Vec2 sum;  // of the corners, seen from the segment
        for (std::uint32_t i = 0; i < moving.count; ++i) sum += moving.points[i] - target.points[0];
        if (!(dot(n, translation) < 0) || dot(n, sum) < 0) return {};
    }
    const Difference w = difference_of(moving, target);
    const Impact i = impact(w, translation);
    if (!i.hit) return {};
    return {true, i.fraction, point_of(w, w.index_b, target.points, i.place) + target.radius * i.normal, i.normal, i.separation};
}

}  // namespace islet::detail
