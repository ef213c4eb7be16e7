// Half-spaces: what is solid on one side of a line, without end.
//
// Nothing is cut off where shapes meet it: a contact point is a corner of the other shape, seen along the normal. Where points are asked for (queries, fast
// bodies, sensors) there is a patch: a square whose face lies on the surface, so large that what is asked about comes nowhere near its other sides.
#include "../exact.hpp"

#include "../geometry/convex.hpp"
#include "../math/scalar.hpp"
#include "../shapes/manifolds.hpp"
#include "../shapes/pen.hpp"
#include "../shapes/shape_types.hpp"

namespace islet {

using namespace detail;

namespace {

constexpr float normal_length_tolerance = 1e-3f;  // how far the squared length of a normal may be from 1
constexpr std::uint32_t hatch_count = 32;
constexpr float longest_drawing = 1000;  // m, half of the line

/// The surface's line in the frame that t leads to.
HalfSpace moved(const HalfSpace& h, const Transform& t) {
    const Vec2 n = rotate(t.q, h.normal);
    return {n, h.offset + dot(n, t.p)};
}

/// The largest coordinate that a point of the half-space has along an axis, where `along` is the normal's part along the axis and `across` the other.
float largest(float along, float across, float offset) {
    return along > 0 ? min(endless_reach, (offset + abs(across) * endless_reach) / along) : endless_reach;
}

}  // namespace

bool is_valid(const HalfSpace& h) { return abs(length_squared(h.normal) - 1) <= normal_length_tolerance && in_range(h.offset); }

void draw_shape(const DebugDraw& draw, const HalfSpace& h, const Transform& pose, const DrawStyle& style) {
    const Pen pen{draw, style};
    const HalfSpace line = moved(h, pose);
    const Vec2 center = 0.5f * (draw.view.lower + draw.view.upper), along = left_perp(line.normal);
    const Vec2 middle = center - (dot(line.normal, center) - line.offset) * line.normal;
    const float half = min(0.5f * perimeter(draw.view), longest_drawing);
    pen.segment(middle - half * along, middle + half * along);
    const float step = 2 * half / hatch_count;
    for (std::uint32_t i = 0; i < hatch_count; ++i) {
        const Vec2 from = middle + (static_cast<float>(i) * step - half) * along;
        pen.segment(from, from + 0.5f * step * (along - line.normal));
    }
}

namespace detail {

Geometry geometry_of(const HalfSpace& h) {
    Geometry g = blank_geometry(ShapeType::half_space);
    g.half_space = {normalize(h.normal) + Vec2{}, h.offset + 0.0f};
    return g;
}

Aabb aabb_of(const HalfSpace& h, const Transform& t) {
    const HalfSpace line = moved(h, t);
    const Vec2 n = line.normal;
    return {{-largest(-n.x, n.y, line.offset), -largest(-n.y, n.x, line.offset)}, {largest(n.x, n.y, line.offset), largest(n.y, n.x, line.offset)}};
}

bool reaches(const HalfSpace& h, const Transform& t, const Aabb& box) {
    const Vec2 n = rotate(t.q, h.normal), half = 0.5f * (box.upper - box.lower);
    const Vec2 middle = box.lower + half - t.p;
    return dot(n, middle) - (abs(n.x) * half.x + abs(n.y) * half.y) <= h.offset + 0.5f * speculative_distance;
}

Corners corners_near(const HalfSpace& h, const Around& around, Vec2* room) {
    const float height = dot(h.normal, around.place) - h.offset;
    const float size = 1 + 2 * (around.reach + abs(height));
    const Vec2 foot = around.place - height * h.normal, side = size * left_perp(h.normal), down = size * h.normal;
    room[0] = foot - side;
    room[1] = foot + side;
    room[2] = room[1] - down;
    room[3] = room[0] - down;
    return {room, 4, 0};
}

// The corner that is lowest, and that of its two neighbours to which the flatter edge leads. All heights share the rounding of where the other body is, so it
// does not rock.
Manifold collide(const HalfSpace& a, const Corners& b, const Transform& b_in_a, float margin) {
    const Vec2 axis = inv_rotate(b_in_a.q, a.normal);
    const float height = dot(a.normal, b_in_a.p) - a.offset - b.radius;
    const auto gap = [&](std::uint32_t i) { return dot(axis, b.points[i]) + height; };
    std::uint32_t lowest = 0;
    for (std::uint32_t i = 1; i < b.count; ++i) lowest = gap(i) < gap(lowest) ? i : lowest;
    const std::uint32_t after = next(lowest, b.count), before = (lowest == 0 ? b.count : lowest) - 1;
    const auto slope = [&](std::uint32_t i) {  // squared, of the edge from the lowest corner
        const float rise = gap(i) - gap(lowest);
        return rise * rise / distance_squared(b.points[i], b.points[lowest]);
    };
    const bool forward = b.count < 3 ? lowest == 0 : slope(after) <= slope(before);  // of two corners the first comes first
    const std::uint32_t ends[2] = {forward ? lowest : before, forward ? after : lowest};
    Manifold m;
    m.normal = a.normal;
    for (const std::uint32_t i : ends) {
        const float separation = gap(i);
        if (separation > margin || m.count == b.count) continue;
        const Vec2 point = transform_point(b_in_a, b.points[i]) - (b.radius + 0.5f * separation) * a.normal;
        m.points[m.count++] = {point, separation, static_cast<std::uint16_t>(i)};
    }
    return m;
}

}  // namespace detail
}  // namespace islet
