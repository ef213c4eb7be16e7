#include "../exact.hpp"

#include "../step/one_way.hpp"

#include "../bodies/bounds.hpp"
#include "../math/scalar.hpp"
#include "../shapes/shape_types.hpp"

namespace islet::detail {

namespace {

inline constexpr float out_of_reach = 1.0e12f;      // m
inline constexpr float clear_height = linear_slop;  // m above the one-way shape, from which a dropped shape is held again
inline constexpr float least_rise = 0.1f;  // cosine between a normal and `up` from which the normal leads up: a shape that slides past an end is not held there

/// The lowest point of a shape along a direction.
struct Lowest {
    float height;  // m
    std::uint32_t corner;
};

Lowest lowest_of(const Corners& c, Vec2 direction) {
    Lowest low = {dot(direction, c.points[0]), 0};
    for (std::uint32_t i = 1; i < c.count; ++i) {
        const float height = dot(direction, c.points[i]);
        if (height < low.height) low = {height, i};
    }
    low.height -= c.radius;
    return low;
}

const Geometry& its_geometry(const Core& core, std::uint32_t shape) { return core.geometries[core.shapes[shape].geometry]; }

// How far a shape rises along a direction; of one without end: what is near the other.
float top_of(const Geometry& g, Vec2 up, const Corners& other, const Transform& to_shape) {
    Vec2 room[4];
    return lowest_of(corners_near(g, has_endless ? around(other, to_shape) : Around{}, room), -up).height;
}

/// A one-way shape and the other shape, in the one-way shape's body frame. Only the other's corners are in its own body's frame.
struct Pair {
    Vec2 up;
    Corners other;
    Transform to_shape;
    const Geometry& geometry;

    Pair(const Core& core, std::uint32_t shape, const Transform& shape_pose, const Corners& its, const Transform& pose)
        : up(direction_of_flags(core.shapes[shape].flags)), other(its), to_shape(inv_mul(shape_pose, pose)), geometry(its_geometry(core, shape)) {}
    Pair(const Core& core, std::uint32_t shape, std::uint32_t other_shape)
        : Pair(core, shape, body_transform(core, core.shapes[shape].body), corners_of(its_geometry(core, other_shape)),
               body_transform(core, core.shapes[other_shape].body)) {}

    Lowest lowest() const { return lowest_of(other, inv_rotate(to_shape.q, up)); }
    float height() const { return lowest().height + dot(up, to_shape.p) + top_of(geometry, up, other, to_shape); }
};

// The body's pose a step ago, if its velocity was the same.
Transform pose_before(const Core& core, std::uint32_t body, float dt) {
    const Rot q = integrate(core.poses[body].q, -dt * core.motions[body].w);
    return {core.poses[body].center - dt * core.motions[body].v - rotate(q, core.bodies[body].local_center), q};
}

float height_before(const Core& core, std::uint32_t shape, std::uint32_t other, float dt) {
    if ((core.shapes[shape].flags & shape_one_way_bits) == 0) return out_of_reach;
    if (is_endless(its_geometry(core, other))) return -out_of_reach;
    const Transform shape_pose = pose_before(core, core.shapes[shape].body, dt);
    return Pair(core, shape, shape_pose, corners_of(its_geometry(core, other)), pose_before(core, core.shapes[other].body, dt)).height();
}

}  // namespace

float height_above(const Core& core, std::uint32_t shape, std::uint32_t other) {
    if ((core.shapes[shape].flags & shape_one_way_bits) == 0) return out_of_reach;
    if (is_endless(its_geometry(core, other))) return -out_of_reach;  // what has no end is above nothing
    return Pair(core, shape, other).height();
}

float height_above(const Core& core, std::uint32_t shape, const Corners& other, const Transform& pose) {
    return (core.shapes[shape].flags & shape_one_way_bits) == 0 ? out_of_reach
                                                                : Pair(core, shape, body_transform(core, core.shapes[shape].body), other, pose).height();
}

float height_before(const Core& core, std::uint32_t shape, const Corners& other, const Transform& pose, float dt) {
    return (core.shapes[shape].flags & shape_one_way_bits) == 0 ? out_of_reach
                                                                : Pair(core, shape, pose_before(core, core.shapes[shape].body, dt), other, pose).height();
}

bool decide_one_way(const Core& core, std::uint32_t contact, std::uint32_t& flags, float dt) {
    const Contact& c = core.contacts[contact];
    const float height = min(height_above(core, c.shape_a, c.shape_b), height_above(core, c.shape_b, c.shape_a));
    const bool dropped = (flags & contact_dropped) != 0 && height < clear_height;
    bool passes = (flags & contact_passes) != 0 && height < least_above;
    if ((flags & (contact_passes | contact_posed)) == 0) {
        // In a new contact the other shape may already have gone a step's way into this one before their boxes met. So the contact also holds if the other
        // shape was above a step ago.
        const float before = min(height_before(core, c.shape_a, c.shape_b, dt), height_before(core, c.shape_b, c.shape_a, dt));
        passes = max(height, before) < least_above;
    }
    flags &= ~static_cast<std::uint32_t>(contact_passes | contact_dropped);
    flags |= (dropped ? std::uint32_t{contact_dropped} : 0u) | (dropped || passes ? std::uint32_t{contact_passes} : 0u);
    return !(dropped || passes);
}

void mend_one_way(Core& core, std::uint32_t contact) {
    const Contact& c = core.contacts[contact];
    ContactManifold& m = core.manifolds[contact];
    for (const bool is_a : {true, false}) {
        const std::uint32_t shape = is_a ? c.shape_a : c.shape_b, other = is_a ? c.shape_b : c.shape_a;
        if ((core.shapes[shape].flags & shape_one_way_bits) == 0 || m.count() == 0) continue;
        const Pair pair(core, shape, other);
        const Vec2 up = rotate(core.poses[is_a ? m.body_a : m.body_b].q, pair.up);
        const float rise = is_a ? dot(up, m.normal) : -dot(up, m.normal);
        if (rise >= least_rise) continue;
        m.forget_points();
        if (rise > -least_rise) continue;
        const Lowest low = pair.lowest();
        const Transform pose = body_transform(core, core.shapes[other].body);
        const Vec2 corner = transform_point(pose, pair.other.points[low.corner]) - pair.other.radius * up;
        m.normal = is_a ? up : -up;
        m.separation[0] = pair.height();
        m.anchors[0] = corner - 0.5f * m.separation[0] * up - core.poses[m.body_a].center;
        m.ids = low.corner;
        m.offset = core.poses[m.body_b].center - core.poses[m.body_a].center;  // a manifold made ahead has the offset at the impact
        m.rotation_a = core.poses[m.body_a].q;
        m.rotation_b = core.poses[m.body_b].q;
        m.flags |= 1u << contact_count_shift;
    }
    // The other shape is not above, and has no contact point: it has left past an end.
    if (m.count() == 0 && min(height_above(core, c.shape_a, c.shape_b), height_above(core, c.shape_b, c.shape_a)) < least_above) m.flags |= contact_passes;
}

}  // namespace islet::detail
