#include "collide/difference.hpp"

#include "geometry/convex.hpp"
#include "math/scalar.hpp"

namespace islet::detail {
namespace {

// Edges shorter than this (m) are left out: their squares would soon underflow.
constexpr float least_edge = 1e-15f;
// Translations shorter than this (m) lead nowhere.
constexpr float least_way = 1e-10f;

bool is_lower(Vec2 p, Vec2 q) { return p.y < q.y || (p.y == q.y && p.x < q.x); }

// A walk around the edges of a polygon from its lowest corner (sign 1), or around those of its mirror image at the origin (sign -1): either way
// counter-clockwise, so the directions of the edges only turn left: first those that lead up, then those that lead down.
struct EdgeWalk {
    const Vec2* points;
    std::uint32_t count;
    float sign;
    std::uint32_t at = 0;
    std::uint32_t left = 0;  // edges not walked yet
    Vec2 edge;               // the next one

    EdgeWalk(const ShapeProxy& p, float s) : points(p.points), count(p.count), sign(s), left(p.count > 1 ? p.count : 0) {
        for (std::uint32_t i = 1; i < count; ++i) {
            if (is_lower(sign * points[i], sign * points[at])) at = i;
        }
        look();
    }
    void look() { edge = sign * (points[next(at, count)] - points[at]); }
    void advance() {
        at = next(at, count);
        --left;
        look();
    }
    bool leads_up() const { return is_lower({}, edge); }
};

// Above 0 if b's edge comes first, below 0 if a's does, 0 if they are parallel. Directions are compared within half a turn only, where the sign of the cross
// product is an order.
float order(const EdgeWalk& a, const EdgeWalk& b) {
    if (a.left == 0) return 1;
    if (b.left == 0) return -1;
    if (a.leads_up() != b.leads_up()) return b.leads_up() ? 1.0f : -1.0f;
    return cross(b.edge, a.edge);
}

Vec2 end_of(const Difference& w, std::uint32_t k) { return w.points[next(k, w.count)]; }

Impact start_inside(const Nearest& n) { return {true, 0, n.normal, min(n.distance, 0.0f), n.place}; }

// Where a line along d enters the outline: at `numerator` / |d|^2 of d.
struct Entry {
    bool found = false;
    float numerator = 0;
    Vec2 normal;
    Place place;
};

// On edge k, moved outward by the radius, at `along` of it.
Entry entry_on_edge(const Difference& w, std::uint32_t k, float along, Vec2 d) {
    const Vec2 n = normalize(right_perp(w.edges[k]));
    const Vec2 point = lerp(w.points[k], end_of(w, k), along) + w.radius * n;
    return {true, dot(point, d), n, {k, along}};
}

// On the arc around corner k, which the line passes at `sine` of the radius, to its right.
Entry entry_on_arc(const Difference& w, std::uint32_t k, float sine, Vec2 d, float way) {
    const float cosine = sqrt((1 - sine) * (1 + sine));
    const Vec2 u = (1 / way) * d;
    return {true, dot(w.points[k], d) - w.radius * way * cosine, -(sine * left_perp(u) + cosine * u), {k, 0}};
}

// At m from something with normal n, but behind it: deep in the shape, unless m is hardly longer than rounding.
bool is_behind(Vec2 n, Vec2 m) { return dot(n, m) < -0.5f * length(m); }

// The origin is nearest to a corner, by edge k, which ends there or begins. Rounding may have cut that edge short, or hidden that the other edge at the corner
// leads still nearer: seen from the corner itself, to which little is lost, both are made good.
Nearest nearest_to_corner(const Difference& w, std::uint32_t k, bool at_end) {
    std::uint32_t corner = at_end ? next(k, w.count) : k;
    Vec2 n = normalize(right_perp(w.edges[k]));
    Vec2 m = -w.points[corner];
    const float back = dot(m, w.edges[k]);
    if (at_end ? back < 0 : back > 0) return {dot(n, m) - w.radius, n, {corner, 0}};
    for (std::uint32_t i = 0; i < w.count; ++i) {
        const std::uint32_t other = at_end ? corner : (corner > 0 ? corner : w.count) - 1;
        const Vec2 e = at_end ? w.edges[other] : -w.edges[other];
        const float over = dot(m, e);
        if (!(over > 0)) break;
        const Vec2 across = normalize(right_perp(w.edges[other]));
        const float square = length_squared(e);
        if (over < square) {
            if (!(dot(across, m) > dot(n, m)) && !is_behind(n, m)) break;
            return {dot(across, m) - w.radius, across, {other, at_end ? over / square : 1 - over / square}};
        }
        corner = at_end ? next(corner, w.count) : other;
        n = across;
        m = -w.points[corner];
    }
    // Behind both edges: rounding made a dent of a corner that is hardly one.
    if (is_behind(n, m)) return {dot(n, m) - w.radius, n, {corner, 0}};
    const Vec2 direction = normalize(m);
    return {length(m) - w.radius, direction != Vec2{} ? direction : n != Vec2{} ? n : Vec2{0, 1}, {corner, 0}};
}

}  // namespace

Difference difference_of(const ShapeProxy& a, const ShapeProxy& b) {
    Difference w;
    w.radius = a.radius + b.radius;
    const auto push = [&](std::uint32_t index_a, std::uint32_t index_b, Vec2 edge) {
        w.points[w.count] = b.points[index_b] - a.points[index_a];
        w.edges[w.count] = edge;
        w.index_a[w.count] = static_cast<std::uint8_t>(index_a);
        w.index_b[w.count] = static_cast<std::uint8_t>(index_b);
        ++w.count;
    };
    // Edges of both, merged by direction: at each corner the one that turns less comes next, parallel ones together.
    EdgeWalk on_b(b, 1);
    EdgeWalk on_a(a, -1);
    while (on_a.left + on_b.left > 0) {  // at most 16 times
        const std::uint32_t index_a = on_a.at, index_b = on_b.at;
        const float turn = order(on_a, on_b);
        Vec2 edge;
        if (turn >= 0) {
            edge += on_b.edge;
            on_b.advance();
        }
        if (turn <= 0) {
            edge += on_a.edge;
            on_a.advance();
        }
        if (length_squared(edge) > least_edge * least_edge) push(index_a, index_b, edge);
    }
    if (w.count == 0) push(on_a.at, on_b.at, {});
    return w;
}

// The nearest of all edges, where those that do not face the origin count as twice as far: see the header.
Nearest nearest(const Difference& w) {
    float least = 3.0e38f;  // squared distance, four times as much of edges that do not face the origin
    Place place;
    for (std::uint32_t k = 0; k < w.count && w.count > 1; ++k) {
        const Vec2 p = w.points[k];
        const Vec2 e = w.edges[k];
        const float per_square = 1 / length_squared(e);
        const float along = clamp(-dot(p, e) * per_square, 0, 1);
        const float area = cross(p, e);
        const float squared = along > 0 && along < 1 ? area * per_square * area : length_squared(along > 0 ? end_of(w, k) : p);
        const float weighed = area < 0 ? squared : 4 * squared;
        if (!(weighed < least)) continue;
        least = weighed;
        place = {k, along};
    }
    if (!(place.along > 0 && place.along < 1)) return nearest_to_corner(w, place.corner, place.along > 0);
    const Vec2 n = normalize(right_perp(w.edges[place.corner]));
    return {-dot(n, w.points[place.corner]) - w.radius, n, place};
}

// Which side of the ray's line a place of the outline is on (left above 0) is worked out from the corners and the directions of the edges alone, so neighbours
// agree about what they share. Edges that face the ray, moved outward by the radius, and the arcs between them lead from the leftmost place to the rightmost
// one: where they pass over, the line enters, and there is no gap to slip through.
Impact impact(const Difference& w, Vec2 d) {
    const float way = length(d);
    if (!(way >= least_way)) {
        const Nearest n = nearest(w);
        return n.distance < 0 ? start_inside(n) : Impact{};
    }
    const float reach = w.radius * way;
    float leftmost = -3.0e38f, rightmost = 3.0e38f;
    float arc_from[Difference::max_count], arc_to[Difference::max_count];  // sides of the ends of the arc around each corner
    Entry entry;
    float side = cross(d, w.points[0]);
    for (std::uint32_t k = 0; k < w.count; ++k) {
        leftmost = max(leftmost, side);
        rightmost = min(rightmost, side);
        const Vec2 e = w.edges[k];
        const float next_side = cross(d, end_of(w, k));
        const bool faces = cross(d, e) < 0;
        // An edge that does not face the ray ends an arc at its outermost.
        float lift = reach;
        if (faces) lift = w.radius > 0 ? w.radius * (dot(d, e) / length(e)) : 0;
        const float from = side - lift;
        const float to = faces ? next_side - lift : next_side + reach;
        if (faces && from >= 0 && to <= 0 && !entry.found) entry = entry_on_edge(w, k, from > to ? from / (from - to) : 0, d);
        arc_to[k] = from;
        arc_from[next(k, w.count)] = to;
        side = next_side;
    }
    const bool on_edge = entry.found;
    // A ray that meets just the end of a line meets it: so none slips between two segments that share a corner.
    const bool line = w.count == 2 && w.radius == 0;
    if (!(leftmost + reach > 0 && rightmost - reach < 0) && !(line && on_edge)) return {};
    for (std::uint32_t k = 0; k < w.count && reach > 0 && !on_edge; ++k) {
        if (!(arc_from[k] >= 0 && arc_to[k] <= 0)) continue;
        const Entry arc = entry_on_arc(w, k, clamp(cross(d, w.points[k]) / reach, -1, 1), d, way);
        if (!entry.found || arc.numerator < entry.numerator) entry = arc;
    }
    const float fraction = entry.numerator / (way * way);
    if (!entry.found || !(fraction <= 1)) return {};
    if (fraction >= 0) return {true, fraction, entry.normal, 0, entry.place};
    if (line) return {};
    const Nearest n = nearest(w);
    return n.distance < 0 || dot(n.normal, d) < 0 ? start_inside(n) : Impact{};
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
