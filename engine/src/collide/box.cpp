// Box against box, the pair that stacks and piles are made of.
//
// A rectangle is a centre, two half extents and two perpendicular axes. Seen from the reference face (its normal n, its tangent t, the
// reference box's centre as origin) the whole test needs only the offset of the other box and the cosine and sine between the two:
//
//        t ^
//     +----|----+ /\               faces 0, 1, 2, 3 have the normals axis0, axis1, -axis0, -axis1, where axis1 is axis0 turned by +90
//     |    +--->|/  \    -> n      degrees; face i runs from corner i to corner i + 1
//     +---------+\  / incident box
//                 \/
#include "../exact.hpp"

#include "../collide/outline.hpp"
#include "../math/inlining.hpp"

namespace islet::detail {
namespace {

// One instruction each, unlike a comparison that must keep the sign of -0.
float magnitude(float a) { return magnitude_of(a); }
float sign_of(float a) { return with_sign_of(1.0f, a); }

struct Box {
    Vec2 center;
    Vec2 axis0;
    float h0 = 0;  // m, half extents along axis0 and axis1
    float h1 = 0;
    float radius = 0;
};

ISLET_SHARED Box oriented_box(const Polygon& p) {
    const Vec2 half = 0.5f * (p.vertices[2] - p.vertices[0]);
    return {0.5f * (p.vertices[0] + p.vertices[2]), p.normals[0], -dot(half, p.normals[0]), dot(half, p.normals[1]), p.radius};
}

// What is known about two boxes once they are in one frame.
struct View {
    float x = 0;  // m, from the centre of the reference box to that of the other, along its axis0 and axis1
    float y = 0;
    float c = 1;  // cosine and sine of the angle from the reference's axis0 to the other's
    float s = 0;
};

// Clips the other box's face to the reference's face across axis0 or axis1. `bound` is the gap along the best axis. False if two corners may be nearer.
ISLET_COPIED bool clip_boxes(const Box ref, const Box inc, View v, bool second_axis, bool reference_is_b, float bound, float margin, Manifold& m) {
    // Turn the view so that the reference face's normal is the x axis: by a quarter for axis1, by a half if the other box is behind.
    Vec2 n = ref.axis0;
    float h_n = ref.h0;
    float h_t = ref.h1;
    std::uint32_t ref1 = 0;
    if (second_axis) {
        n = left_perp(n);
        v = {v.y, -v.x, v.s, -v.c};
        h_n = ref.h1;
        h_t = ref.h0;
        ref1 = 1;
    }
    const float turn = sign_of(v.x);
    v = {turn * v.x, turn * v.y, turn * v.c, turn * v.s};
    n *= turn;
    ref1 += turn < 0.0f ? 2u : 0u;

    // The other box's face that looks back most directly, and its normal (i_n, i_t) in this view.
    float i_n = -magnitude(v.c);
    float i_t = -sign_of(v.c) * v.s;
    float half_n = inc.h0;
    float half_t = inc.h1;
    std::uint32_t inc1 = v.c < 0.0f ? 0 : 2;
    if (magnitude(v.c) < magnitude(v.s)) {
        i_n = -magnitude(v.s);
        i_t = sign_of(v.s) * v.c;
        half_n = inc.h1;
        half_t = inc.h0;
        inc1 = v.s > 0.0f ? 1 : 3;
    }

    // That face runs against t; cut it at the ends of the reference face.
    const float middle = v.y + half_n * i_t;
    const float middle_gap = v.x + half_n * i_n - h_n;
    const float reach = -half_t * i_n;
    const float high = min(middle + reach, h_t);
    const float low = max(middle - reach, -h_t);
    const float slope = -i_t / i_n;  // |i_n| >= cos 45 degrees
    const float gap_high = middle_gap + slope * (high - middle);
    const float gap_low = middle_gap + slope * (low - middle);
    if (low > high) return false;

    const Vec2 t = left_perp(n);
    const float radii = ref.radius + inc.radius;
    const Vec2 base = ref.center + (h_n + 0.5f * (ref.radius - inc.radius)) * n;
    const std::uint32_t ref2 = (ref1 + 1u) & 3u;
    const std::uint32_t inc2 = (inc1 + 1u) & 3u;
    const ManifoldPoint at_low = {base + low * t + (0.5f * gap_low) * n, gap_low - radii, reference_is_b ? feature_id(inc2, ref1) : feature_id(ref1, inc2)};
    const ManifoldPoint at_high = {base + high * t + (0.5f * gap_high) * n, gap_high - radii, reference_is_b ? feature_id(inc1, ref2) : feature_id(ref2, inc1)};
    m.normal = reference_is_b ? -n : n;
    m.points[0] = reference_is_b ? at_high : at_low;
    m.count = m.points[0].separation <= margin ? 1 : 0;
    m.points[m.count] = reference_is_b ? at_low : at_high;
    m.count += m.points[m.count].separation <= margin ? 1 : 0;
    // No clipped point can be closer than the best axis says, and none needs to be.
    return m.count > 0 && (bound <= separation_tie || min(gap_high, gap_low) <= bound + separation_tie);
}

// Half of the box's diagonal to a corner, in which the signs along axis0 and axis1 are these. Corner i of a box is where its face i begins.
Vec2 to_corner(const Box& box, bool plus0, bool plus1) { return (plus0 ? box.h0 : -box.h0) * box.axis0 + (plus1 ? box.h1 : -box.h1) * left_perp(box.axis0); }

/// The corner of a box that is nearest to another box, and the point of that which is nearest to the corner.
struct NearCorner {
    float squared = 3.0e38f;                  // m^2, of the distance
    Vec2 corner, foot, between;               // frame A; from the foot to the corner
    std::uint32_t index = 0, foot_index = 0;  // of the corners; that of the foot is in the same quarter of its box
};

ISLET_SHARED NearCorner nearest_corner(const Box& box, const Box& other) {
    NearCorner best;
    const Vec2 axis1 = left_perp(box.axis0);
    for (std::uint32_t i = 0; i < 4; ++i) {
        const Vec2 half = to_corner(other, i < 2, i - 1 < 2), from_center = other.center - box.center + half;
        const Vec2 at = {dot(box.axis0, from_center), dot(axis1, from_center)};
        const Vec2 on = {clamp(at.x, -box.h0, box.h0), clamp(at.y, -box.h1, box.h1)};
        const Vec2 out = at - on;
        if (!(length_squared(out) < best.squared)) continue;
        const std::uint32_t quarter = at.x > 0 ? (at.y > 0 ? 1 : 0) : (at.y > 0 ? 2 : 3);
        best = {length_squared(out), other.center + half, box.center + on.x * box.axis0 + on.y * axis1, out.x * box.axis0 + out.y * axis1, i, quarter};
    }
    return best;
}

/// How far two boxes are apart along their axes, m.
struct Gaps {
    float a0, a1, b0, b1;
    float of_a() const { return max(a0, a1); }
    float of_b() const { return max(b0, b1); }
};

// The manifold of two boxes whose corners may be nearer to each other than the faces that look at each other. `clipped` is that of these faces.
ISLET_NEVER_INLINE Manifold collide_corners(const Box& a, const Box& b, const Gaps& gaps, float margin, const Manifold& clipped) {
    const float bound = max(gaps.of_a(), gaps.of_b()), radii = a.radius + b.radius;
    const Vec2 d = b.center - a.center;
    // The nearest points of two boxes that are apart: at least one is a corner.
    const NearCorner of_b = nearest_corner(a, b), of_a = nearest_corner(b, a);
    const float gap = sqrt(min(of_a.squared, of_b.squared));
    const bool overlap = gap <= 1e-5f;  // m; or too close for a direction between corners
    if (clipped.count > 0 && (overlap || least_separation(clipped) <= gap - radii + separation_tie)) return clipped;
    if (gap > margin + radii) return none_within(gap - radii);

    // If a face is as far away as the nearest points, but for rounding, its normal is right: where corners are near corners, rounding may have chosen the wrong
    // ones, and has made a direction of its own between them. So it is if the boxes overlap, though their faces miss each other.
    const bool at_face = overlap || (gap < linear_slop && gap <= bound + 1e-6f * (1.0f + magnitude(d.x) + magnitude(d.y)));
    const bool reference_is_b = at_face ? gaps.of_b() > gaps.of_a() : of_a.squared < of_b.squared;
    const Box &ref = reference_is_b ? b : a, &other = reference_is_b ? a : b;
    NearCorner near = reference_is_b ? of_a : of_b;
    Vec2 n = (1.0f / gap) * near.between;
    if (at_face) {
        const bool second_axis = reference_is_b ? gaps.b1 > gaps.b0 : gaps.a1 > gaps.a0;
        n = second_axis ? left_perp(ref.axis0) : ref.axis0;
        if (dot(other.center - ref.center, n) < 0) n = -n;
        near.foot = near.corner - bound * n;
    }
    const float apart = at_face ? bound : gap;
    if (!reference_is_b) return point_manifold(near.foot, a.radius, near.corner, b.radius, n, apart, feature_id(near.foot_index, near.index));
    return point_manifold(near.corner, a.radius, near.foot, b.radius, -n, apart, feature_id(near.index, near.foot_index));
}

}  // namespace

Manifold collide_boxes(const Polygon& pa, const Polygon& pb, const Transform& b_in_a, float margin) {
    const Box a = oriented_box(pa);
    Box b = oriented_box(pb);
    b.center = transform_point(b_in_a, b.center);
    b.axis0 = rotate(b_in_a.q, b.axis0);

    const Vec2 d = b.center - a.center;
    const View from_a = {dot(d, a.axis0), cross(a.axis0, d), dot(a.axis0, b.axis0), cross(a.axis0, b.axis0)};
    const View from_b = {-dot(d, b.axis0), -cross(b.axis0, d), from_a.c, -from_a.s};
    const float c = magnitude(from_a.c);
    const float s = magnitude(from_a.s);
    const Gaps gaps = {magnitude(from_a.x) - a.h0 - (c * b.h0 + s * b.h1), magnitude(from_a.y) - a.h1 - (s * b.h0 + c * b.h1),
                       magnitude(from_b.x) - b.h0 - (c * a.h0 + s * a.h1), magnitude(from_b.y) - b.h1 - (s * a.h0 + c * a.h1)};
    const float gap_a = gaps.of_a(), gap_b = gaps.of_b(), bound = max(gap_a, gap_b);
    Manifold m;
    if (bound > margin + (a.radius + b.radius)) {
        m.note(bound - (a.radius + b.radius));
        return m;
    }

    // The reference face is A's unless B's is clearly better.
    const bool decided = gap_b > gap_a + separation_tie ? clip_boxes(b, a, from_b, gaps.b1 > gaps.b0, true, bound, margin, m)
                                                        : clip_boxes(a, b, from_a, gaps.a1 > gaps.a0, false, bound, margin, m);
    if (!decided) m = collide_corners(a, b, gaps, margin, m);
    return m;
}

}  // namespace islet::detail
