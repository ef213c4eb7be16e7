// The narrow phase in lanes: the manifolds of as many pairs of shapes as there are lanes, all of one kind.
//
// Each kind is that of one function `collide` (shapes/manifolds.hpp), or of collide_boxes (collide/box.cpp), by the same arithmetic, operation by operation.
// What few pairs need is left to these: a pair is undecided where boxes' corners may be nearer than their faces, or where other outlines overlap, though no
// face of theirs says how.
#pragma once

#include "../collide/lane_distance.hpp"
#include "../collide/lane_outlines.hpp"

namespace islet::detail {

/// A point of a manifold: where (m, frame A), how far apart (m), and its feature id.
template <class L>
struct LanePoint {
    LaneVec<typename L::F> point;
    typename L::F separation;
    LaneInts<L> id;
};
template <class L>
ISLET_LANE LanePoint<L> select(LaneInts<L> mask, const LanePoint<L>& a, const LanePoint<L>& b) {
    return {select(mask, a.point, b.point), select(mask, a.separation, b.separation), pick(mask, a.id, b.id)};
}

/// The manifolds of pairs.
template <class L>
struct PairManifolds {
    LaneVec<typename L::F> normal;  // unit, frame A, from A to B
    LanePoint<L> points[2];
    typename L::F clearance;      // m, of those without points: see Manifold
    std::uint32_t some, two;      // a bit for each pair that has a point; that has two
    std::uint32_t undecided = 0;  // for each whose manifold this is not
};

// -------------------------------------------------------------------------------- one point

/// point_manifold, of pairs whose bits are in `some`.
template <class L, class F = typename L::F>
ISLET_LANE PairManifolds<L> point_manifolds(LaneVec<F> a, F radius_a, LaneVec<F> b, F radius_b, LaneVec<F> normal, F gap, LaneInts<L> id, std::uint32_t some) {
    const LaneVec<F> on_a = a + radius_a * normal, on_b = b - radius_b * normal;
    const LanePoint<L> point = {L::splat(0.5f) * (on_a + on_b), gap - radius_a - radius_b, id};
    return {normal, {point, point}, F{}, some, 0};
}

/// collide_point
template <class L, class F = typename L::F>
ISLET_LANE PairManifolds<L> collide_points(LaneVec<F> a, F radius_a, LaneVec<F> center, F radius_b, LaneVec<F> fallback, F margin, LaneInts<L> id) {
    const LaneVec<F> between = center - a;
    const F limit = margin + radius_a + radius_b;
    const std::uint32_t far = L::bits(dot(between, between) > limit * limit);
    const LaneDirections<L> d(between, fallback);
    return point_manifolds<L>(a, radius_a, center, radius_b, d.unit, d.length, id, ((1u << L::width) - 1) & ~far);
}

template <class L>
ISLET_LANE PairManifolds<L> collide_circles(const LaneStands<L>& s) {
    const LaneWords<L> a(s.geometries, s.a, circle_words), b(s.geometries, s.b, circle_words);
    return collide_points<L>(a.first(), a.columns[2], s.place(b.first()), b.columns[2], {L::splat(0), L::splat(1)}, s.margin, LaneInts<L>{});
}

template <class L>
ISLET_LANE PairManifolds<L> collide_capsule_circle(const LaneStands<L>& s) {
    using F = typename L::F;
    const LaneWords<L> a(s.geometries, s.a, capsule_words), radius_a(s.geometries, s.a, capsule_words + 4), b(s.geometries, s.b, circle_words);
    const LaneVec<F> center = s.place(b.first()), axis = a.second() - a.first();
    const F squared = dot(axis, axis), zero = L::splat(0), one = L::splat(1);
    const F along = dot(center - a.first(), axis) / max(squared, L::splat(1e-14f)), t = select(along < zero, zero, select(along > one, one, along));
    const LaneVec<F> unit = LaneDirections<L>(axis, {one, zero}).unit, foot = a.first() + t * axis, off = foot - center;
    const LaneInts<L> on_axis = dot(off, off) < L::splat(1e-12f) * squared;
    return collide_points<L>(foot, radius_a.columns[0], select(on_axis, foot, center), b.columns[2], {unit.y, -unit.x}, s.margin, LaneInts<L>{});
}

// -------------------------------------------------------------------------------- outlines

/// A face of each outline: Face without its radius.
template <class L>
struct LaneFaces {
    LaneVec<typename L::F> v1, v2, normal;
    LaneInts<L> index1;

    ISLET_LANE void take(LaneInts<L> where, const LaneOutline<L>& o, std::uint32_t i) {
        v1 = select(where, o.vertices[i], v1);
        v2 = select(where, o.vertices[i + 1 < o.most ? i + 1 : 0], v2);
        normal = select(where, o.normals[i], normal);
        index1 = pick(where, LaneInts<L>{} + static_cast<std::int32_t>(i), index1);
    }
};
template <class L>
ISLET_LANE LaneFaces<L> first_faces(const LaneOutline<L>& o) {
    return {o.vertices[0], o.vertices[1], o.normals[0], LaneInts<L>{}};
}
template <class L>
ISLET_LANE LaneFaces<L> select(LaneInts<L> mask, const LaneFaces<L>& a, const LaneFaces<L>& b) {
    return {select(mask, a.v1, b.v1), select(mask, a.v2, b.v2), select(mask, a.normal, b.normal), pick(mask, a.index1, b.index1)};
}
template <class L>
ISLET_LANE LaneInts<L> next_index(LaneInts<L> index, LaneInts<L> count) {
    return (index + 1) & (index + 1 < count);
}

/// best_axis
template <class L>
struct LaneAxes {
    LaneFaces<L> face;
    typename L::F separation;

    ISLET_LANE LaneAxes(const LaneOutline<L>& p, const LaneOutline<L>& q) : face(first_faces(p)), separation(L::splat(-3e38f)) {
        for (std::uint32_t i = 0; i < p.most; ++i) {
            const LaneVec<typename L::F> n = p.normals[i];
            typename L::F nearest = dot(n, q.vertices[0]);
            for (std::uint32_t j = 1; j < q.most; ++j) nearest = min(nearest, dot(n, q.vertices[j]));
            const typename L::F apart = nearest - dot(n, p.vertices[i]);
            face.take(apart > separation, p, i);
            separation = max(apart, separation);
        }
    }
};

/// Two points across a reference face, which is B's where `is_b` says so, in the order of A's corners: those no farther apart than `margin`. The normal is the
/// reference's. Fills in what follows from that.
template <class L, class F = typename L::F>
ISLET_LANE PairManifolds<L> two_points(const LanePoint<L>& lower, const LanePoint<L>& upper, LaneVec<F> normal, LaneInts<L> is_b, F margin) {
    PairManifolds<L> m;
    m.normal = select(is_b, LaneVec<F>{-normal.x, -normal.y}, normal);
    m.points[0] = select<L>(is_b, upper, lower);
    m.points[1] = select<L>(is_b, lower, upper);
    const LaneInts<L> near0 = m.points[0].separation <= margin, near1 = m.points[1].separation <= margin;
    m.points[0] = select<L>(near0, m.points[0], m.points[1]);
    m.some = L::bits(near0 | near1);
    m.two = L::bits(near0 & near1);
    return m;
}

/// least_separation, of those with a point.
template <class L>
ISLET_LANE typename L::F least_separation(const PairManifolds<L>& m) {
    return select(L::mask(m.two), min(m.points[0].separation, m.points[1].separation), m.points[0].separation);
}

/// clip_faces
template <class L, class F = typename L::F>
ISLET_LANE PairManifolds<L> clip_faces(const LaneFaces<L>& reference, const LaneFaces<L>& incident, LaneInts<L> ref2, LaneInts<L> inc2, F ref_radius,
                                       F inc_radius, LaneInts<L> is_b, LaneVec<F> origin, F margin) {
    using Vec = LaneVec<F>;
    const Vec n = reference.normal, tangent = left_perp(n);
    const F length = dot(reference.v2 - reference.v1, tangent), zero = L::splat(0);
    const Vec from1 = incident.v1 - reference.v1, from2 = incident.v2 - reference.v1;
    const F high = dot(from1, tangent), low = dot(from2, tangent);
    const LaneInts<L> cuts = high - low > L::splat(1e-7f);
    const F scale = L::splat(1.0f) / (high - low);
    const Vec lower = select(cuts & (low < zero), from2 + (-low * scale) * (from1 - from2), from2);
    const Vec upper = select(cuts & (high > length), from2 + ((length - low) * scale) * (from1 - from2), from1);
    const F radii = ref_radius + inc_radius, lift = L::splat(0.5f) * (ref_radius - inc_radius), half = L::splat(0.5f);
    const Vec base = origin + reference.v1;
    const F gap_lower = dot(lower, n), gap_upper = dot(upper, n);
    const LaneInts<L> ref1 = reference.index1, inc1 = incident.index1;
    PairManifolds<L> m =
        two_points<L>({base + lower + (lift - half * gap_lower) * n, gap_lower - radii, pick(is_b, ids_of(inc2, ref1), ids_of(ref1, inc2))},
                      {base + upper + (lift - half * gap_upper) * n, gap_upper - radii, pick(is_b, ids_of(inc1, ref2), ids_of(ref2, inc1))}, n, is_b, margin);
    const std::uint32_t misses = L::bits((high < zero) | (low > length));
    m.some &= ~misses;
    m.two &= ~misses;
    return m;
}

/// collide_cores. Undecided are those that touch or overlap where their faces do not say how.
template <class L>
ISLET_LANE PairManifolds<L> collide_cores(LaneOutline<L>& a, LaneOutline<L>& b, LaneVec<typename L::F> origin, typename L::F margin) {
    using F = typename L::F;
    using I = LaneInts<L>;
    const F radii = a.radius + b.radius, limit = margin + radii;
    const LaneAxes<L> axis_a(a, b), axis_b(b, a);
    const I far_a = axis_a.separation > limit, far = far_a | (axis_b.separation > limit);
    const I is_b = axis_b.separation > axis_a.separation + L::splat(separation_tie);
    const LaneFaces<L> face = select<L>(is_b, axis_b.face, axis_a.face);
    // The face of the other that looks most directly against that (face_against).
    const std::uint32_t most = a.most > b.most ? a.most : b.most;
    a.pad(a.most, most);
    b.pad(b.most, most);
    a.most = b.most = most;
    LaneFaces<L> other = select<L>(is_b, first_faces(a), first_faces(b));
    F best = dot(face.normal, other.normal);
    for (std::uint32_t i = 1; i < most; ++i) {
        const F value = select(is_b, dot(face.normal, a.normals[i]), dot(face.normal, b.normals[i]));
        const I better = value < best;
        other.take(better & is_b, a, i);
        other.take(better & ~is_b, b, i);
        best = min(value, best);
    }
    const I ref_count = pick(is_b, b.count, a.count), inc_count = pick(is_b, a.count, b.count);
    const F ref_radius = select(is_b, b.radius, a.radius), inc_radius = select(is_b, a.radius, b.radius);
    PairManifolds<L> m =
        clip_faces<L>(face, other, next_index<L>(face.index1, ref_count), next_index<L>(other.index1, inc_count), ref_radius, inc_radius, is_b, origin, margin);
    const F bound = max(axis_a.separation, axis_b.separation), tie = L::splat(separation_tie);
    const std::uint32_t fits = m.some & L::bits((bound <= tie) | (least_separation(m) <= bound - radii + tie)), apart = L::bits(far);
    m.undecided = ((1u << L::width) - 1) & ~apart & ~fits;
    m.some &= ~apart;
    m.two &= ~apart;
    m.clearance = select(far_a, axis_a.separation, axis_b.separation) - radii;
    if ((m.undecided & (m.undecided - 1)) == 0) return m;  // none, or one alone: that takes less time by itself

    // Corners may be nearer than faces.
    const LaneDistances<L> near = core_distances(a, b, m.undecided);
    const std::uint32_t open = m.undecided & ~near.others & ~L::bits(near.distance <= L::splat(1e-5f));
    const std::uint32_t clipped = open & m.some & L::bits(least_separation(m) <= near.distance - radii + tie);
    const std::uint32_t corners = open & ~clipped, none = corners & L::bits(near.distance > limit), points = corners & ~none;
    const PairManifolds<L> c =
        point_manifolds<L>(near.point_a + origin, a.radius, near.point_b + origin, b.radius, near.normal, near.distance, near.id, points);
    const I is_point = L::mask(points);
    m.normal = select(is_point, c.normal, m.normal);
    m.points[0] = select<L>(is_point, c.points[0], m.points[0]);
    m.some = (m.some & ~corners) | points;
    m.two &= ~corners;
    m.clearance = select(L::mask(none), near.distance - radii, m.clearance);
    m.undecided &= ~open;
    return m;
}

template <class L>
ISLET_LANE PairManifolds<L> collide_polygons(const LaneStands<L>& s) {
    LaneOutline<L> a, b;
    load_polygons(s.geometries, s.a, a);
    load_polygons(s.geometries, s.b, b);
    const LaneVec<typename L::F> origin = a.vertices[0];
    for (std::uint32_t i = 0; i < a.most; ++i) a.vertices[i] = a.vertices[i] - origin;
    place_polygons(s, origin, b);
    return collide_cores(a, b, origin, s.margin);
}

template <class L>
ISLET_LANE PairManifolds<L> collide_polygon_capsule(const LaneStands<L>& s) {
    LaneOutline<L> a, b;
    load_polygons(s.geometries, s.a, a);
    const LaneWords<L> points(s.geometries, s.b, capsule_words), radius(s.geometries, s.b, capsule_words + 4);
    const LaneVec<typename L::F> origin = a.vertices[0], to = s.to - origin;
    for (std::uint32_t i = 0; i < a.most; ++i) a.vertices[i] = a.vertices[i] - origin;
    outline_lines(turned_in_lanes(s.turn, points.first()) + to, turned_in_lanes(s.turn, points.second()) + to, radius.columns[0], b);
    return collide_cores(a, b, origin, s.margin);
}

template <class L>
ISLET_LANE PairManifolds<L> collide_capsules(const LaneStands<L>& s) {
    using F = typename L::F;
    using Vec = LaneVec<F>;
    const LaneWords<L> at_a(s.geometries, s.a, capsule_words), radius_a(s.geometries, s.a, capsule_words + 4);
    const LaneWords<L> at_b(s.geometries, s.b, capsule_words), radius_b(s.geometries, s.b, capsule_words + 4);
    const Vec origin = at_a.first(), to = s.to - origin, end = at_a.second() - origin;
    const Vec b1 = turned_in_lanes(s.turn, at_b.first()) + to, b2 = turned_in_lanes(s.turn, at_b.second()) + to;
    const F radii = radius_a.columns[0] + radius_b.columns[0], limit = s.margin + radius_a.columns[0] + radius_b.columns[0], zero = L::splat(0);
    // The boxes around both lines: those farther apart than the limit have no points.
    const Vec lower_a = {min(zero, end.x), min(zero, end.y)}, upper_a = {max(zero, end.x), max(zero, end.y)};
    const Vec lower_b = {min(b1.x, b2.x), min(b1.y, b2.y)}, upper_b = {max(b1.x, b2.x), max(b1.y, b2.y)};
    const LaneInts<L> meet =
        (lower_a.x - limit <= upper_b.x) & (lower_b.x <= upper_a.x + limit) & (lower_a.y - limit <= upper_b.y) & (lower_b.y <= upper_a.y + limit);
    const F gap = max(max(lower_b.x - upper_a.x, lower_a.x - upper_b.x), max(lower_b.y - upper_a.y, lower_a.y - upper_b.y));
    LaneOutline<L> a, b;
    outline_lines(Vec{zero, zero}, end, radius_a.columns[0], a);
    outline_lines(b1, b2, radius_b.columns[0], b);
    PairManifolds<L> m = collide_cores(a, b, origin, s.margin);
    const std::uint32_t apart = ~L::bits(meet);
    m.some &= ~apart;
    m.two &= ~apart;
    m.undecided &= ~apart;
    m.clearance = select(meet, m.clearance, gap - radii);
    return m;
}

template <class L>
ISLET_LANE PairManifolds<L> collide_polygon_circle(const LaneStands<L>& s) {
    using F = typename L::F;
    using I = LaneInts<L>;
    using Vec = LaneVec<F>;
    LaneOutline<L> a;
    load_polygons(s.geometries, s.a, a);
    const LaneWords<L> b(s.geometries, s.b, circle_words);
    const Vec center = s.place(b.first());
    const F radius_b = b.columns[2], limit = s.margin + a.radius + radius_b;
    LaneFaces<L> face = first_faces(a);
    F separation = L::splat(-3e38f);
    for (std::uint32_t i = 0; i < a.most; ++i) {
        const F apart = dot(a.normals[i], center - a.vertices[i]);
        face.take(apart > separation, a, i);
        separation = max(apart, separation);
    }
    const std::uint32_t far = L::bits(separation > limit);
    const F zero = L::splat(0);
    const I outside = separation > L::splat(1e-6f), at1 = outside & (dot(center - face.v1, face.v2 - face.v1) < zero);
    const I at2 = outside & ~at1 & (dot(center - face.v2, face.v1 - face.v2) < zero), at_corner = at1 | at2;
    const Vec corner = select(at1, face.v1, face.v2), between = center - corner;
    const LaneDirections<L> d(between, face.normal);
    const std::uint32_t too_far = far | L::bits(at_corner & (dot(between, between) > limit * limit));
    const I index = pick(at2, next_index<L>(face.index1, a.count), face.index1);
    PairManifolds<L> m =
        point_manifolds<L>(select(at_corner, corner, center - separation * face.normal), a.radius, center, radius_b, select(at_corner, d.unit, face.normal),
                           select(at_corner, d.length, separation), index << 8, ((1u << L::width) - 1) & ~too_far);
    m.clearance = select(L::mask(far), separation - (a.radius + radius_b), zero);
    return m;
}

// -------------------------------------------------------------------------------- boxes

/// A box as a centre (m), a unit axis, and half extents (m) along it and across: collide/box.cpp.
template <class L>
struct LaneBox {
    LaneVec<typename L::F> center, axis0;
    typename L::F h0, h1, radius;

    ISLET_LANE LaneBox(const float* geometries, const std::uint32_t* which) {
        const LaneWords<L> v0(geometries, which, polygon_words), v2(geometries, which, polygon_words + 4), n(geometries, which, normal_words);
        const LaneVec<typename L::F> half = L::splat(0.5f) * (v2.first() - v0.first());
        center = L::splat(0.5f) * (v0.first() + v2.first());
        axis0 = n.first();
        h0 = -dot(half, n.first());
        h1 = dot(half, n.second());
        radius = LaneWords<L>(geometries, which, rest_words).columns[2];
    }
};

template <class L>
ISLET_LANE PairManifolds<L> collide_boxes(const LaneStands<L>& stands) {
    using F = typename L::F;
    using I = LaneInts<L>;
    using Vec = LaneVec<F>;
    const LaneBox<L> a(stands.geometries, stands.a);
    LaneBox<L> b(stands.geometries, stands.b);
    b.center = stands.place(b.center);
    b.axis0 = turned_in_lanes(stands.turn, b.axis0);
    const F margin = stands.margin, zero = L::splat(0), half = L::splat(0.5f);
    const auto sign_of = [&](F of) ISLET_INLINED_LAMBDA { return L::with_sign_of(L::splat(1.0f), of); };
    const auto whole = [&](std::int32_t of) ISLET_INLINED_LAMBDA { return I{} + of; };
    const Vec d = b.center - a.center;
    const F cosine = dot(a.axis0, b.axis0), sine = cross(a.axis0, b.axis0), c = L::abs(cosine), s = L::abs(sine);
    const Vec from_a = {dot(d, a.axis0), cross(a.axis0, d)}, from_b = {-dot(d, b.axis0), -cross(b.axis0, d)};
    const F a0 = L::abs(from_a.x) - a.h0 - (c * b.h0 + s * b.h1), a1 = L::abs(from_a.y) - a.h1 - (s * b.h0 + c * b.h1);
    const F b0 = L::abs(from_b.x) - b.h0 - (c * a.h0 + s * a.h1), b1 = L::abs(from_b.y) - b.h1 - (s * a.h0 + c * a.h1);
    const F gap_a = max(a0, a1), gap_b = max(b0, b1), bound = max(gap_a, gap_b), radii = a.radius + b.radius;
    const I far = bound > margin + radii;

    // The reference face is A's unless B's is clearly better. Its normal becomes the x axis: by a quarter turn, or a half if the other box is behind.
    const I is_b = gap_b > gap_a + L::splat(separation_tie), second = (is_b & (b1 > b0)) | (~is_b & (a1 > a0));
    const F ref0 = select(is_b, b.h0, a.h0), ref1 = select(is_b, b.h1, a.h1), inc0 = select(is_b, a.h0, b.h0), inc1 = select(is_b, a.h1, b.h1);
    const F ref_radius = select(is_b, b.radius, a.radius), inc_radius = select(is_b, a.radius, b.radius);
    Vec n = select(is_b, b.axis0, a.axis0), at = select(is_b, from_b, from_a), angle = {cosine, select(is_b, -sine, sine)};
    n = select(second, left_perp(n), n);
    at = select(second, Vec{at.y, -at.x}, at);
    angle = select(second, Vec{angle.y, -angle.x}, angle);
    const F h_n = select(second, ref1, ref0), h_t = select(second, ref0, ref1), turn = sign_of(at.x);
    at = turn * at;
    angle = turn * angle;
    n = turn * n;
    const I face1 = (second & whole(1)) + ((turn < zero) & whole(2));

    // The other box's face that looks back most directly, cut at the ends of the reference face.
    const I across = L::abs(angle.x) < L::abs(angle.y);
    const F i_n = -select(across, L::abs(angle.y), L::abs(angle.x));
    const F i_t = select(across, sign_of(angle.y) * angle.x, -sign_of(angle.x) * angle.y);
    const F half_n = select(across, inc1, inc0), half_t = select(across, inc0, inc1);
    const I other1 = pick(across, pick(angle.y > zero, whole(1), whole(3)), pick(angle.x < zero, whole(0), whole(2)));
    const F middle = at.y + half_n * i_t, middle_gap = at.x + half_n * i_n - h_n, reach = -half_t * i_n;
    const F high = min(middle + reach, h_t), low = max(middle - reach, -h_t), slope = -i_t / i_n;
    const F gap_high = middle_gap + slope * (high - middle), gap_low = middle_gap + slope * (low - middle);

    const Vec t = left_perp(n), base = select(is_b, b.center, a.center) + (h_n + half * (ref_radius - inc_radius)) * n;
    const I face2 = (face1 + 1) & 3, other2 = (other1 + 1) & 3;
    PairManifolds<L> m =
        two_points<L>({base + low * t + (half * gap_low) * n, gap_low - radii, pick(is_b, ids_of(other2, face1), ids_of(face1, other2))},
                      {base + high * t + (half * gap_high) * n, gap_high - radii, pick(is_b, ids_of(other1, face2), ids_of(face2, other1))}, n, is_b, margin);
    const F tie = L::splat(separation_tie);
    const std::uint32_t apart = L::bits(far), fits = m.some & L::bits((low <= high) & ((bound <= tie) | (min(gap_high, gap_low) <= bound + tie)));
    m.undecided = ~apart & ~fits;
    m.some &= ~apart;
    m.two &= ~apart;
    m.clearance = bound - radii;
    return m;
}

/// The manifolds of pairs of a kind.
template <class L>
ISLET_LANE PairManifolds<L> collide_in_lanes(PairKind kind, const LaneStands<L>& s) {
    switch (kind) {
        case PairKind::boxes: return collide_boxes(s);
        case PairKind::polygons: return collide_polygons(s);
        case PairKind::polygon_capsule: return collide_polygon_capsule(s);
        case PairKind::capsules: return collide_capsules(s);
        case PairKind::polygon_circle: return collide_polygon_circle(s);
        case PairKind::capsule_circle: return collide_capsule_circle(s);
        case PairKind::circles: return collide_circles(s);
    }
    ISLET_UNREACHABLE();
}

}  // namespace islet::detail
