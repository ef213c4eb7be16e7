#include "../exact.hpp"

#include "../bodies/bounds.hpp"

#include "../bodies/impulses.hpp"
#include "../broadphase/pairs.hpp"
#include "../graph/contacts.hpp"
#include "../math/boxes.hpp"
#include "../math/inlining.hpp"

namespace islet::detail {

namespace {

inline constexpr float box_margin_fraction = 0.125f;  // of the shape's size: small shapes get small margins

ISLET_COPIED Extent extent_of(const Geometry& g, Vec2 center) {
    if (is_endless(g)) return {endless_reach, endless_reach};
    if (const Polygon* polygon = faces_of(g)) {
        const Polygon& p = *polygon;
        Extent e{0, 3.0e38f};
        for (std::uint32_t i = 0; i < p.count; ++i) {
            e.max = max(e.max, distance(p.vertices[i], center));
            e.min = min(e.min, dot(p.normals[i], p.vertices[i] - p.centroid));
        }
        return {e.max + p.radius, e.min + p.radius};
    }
    const Corners corners = corners_of(g);
    const float farthest = max(distance(corners.points[0], center), distance(corners.points[corners.count - 1], center));
    return {farthest + corners.radius, corners.radius};
}

MassData mass_of(const Core& core, const Shape& shape) {
    return with_shape(core.geometries[shape.geometry], [&](const auto& solid) {
        using Row = RowOf<decltype(solid)>;
        if constexpr (Row::kind == ShapeKind::solid && Row::is_there) return compute_mass(solid, shape.density);
        return MassData{};
    });
}

}  // namespace

Transform body_transform(const Core& core, std::uint32_t body) { return {core.bodies[body].origin, core.poses[body].q}; }

Aabb shape_aabb(const Core& core, std::uint32_t shape) {
    const Shape& s = core.shapes[shape];
    return aabb_of(core.geometries[s.geometry], body_transform(core, s.body));
}

namespace {

inline constexpr float tight_margin = 0.5f * speculative_distance;

#if ISLET_MAX_LANES > 1
// The box of corners as aabb_of makes it, but two corners at once, and wider by tight_margin. (That is why it does not matter which of two zeros is less.)
ISLET_LANE f4 tight_box_at_once(const Corners& corners, const Transform& t) {
    const float* const points = &corners.points[0].x;
    const float* const last = points + 2 * (corners.count - 1);
    f4 lower = rotate_two(t.q, f4{last[0], last[1], points[0], points[1]}), upper = lower;
    for (std::uint32_t i = 1; i + 1 < corners.count; i += 2) {
        const f4 two = rotate_two(t.q, load4(points + 2 * i));
        lower = min(lower, two);
        upper = max(upper, two);
    }
    lower = min(lower, __builtin_shufflevector(lower, lower, 2, 3, 0, 1));
    upper = max(upper, __builtin_shufflevector(upper, upper, 2, 3, 0, 1));
    const f4 box = __builtin_shufflevector(lower, upper, 0, 1, 6, 7) + f4{t.p.x, t.p.y, t.p.x, t.p.y};
    return expand_held(expand_held(box, corners.radius), tight_margin);
}
#endif

ISLET_LANE HeldBox held_tight_box(const Geometry& g, const Transform& t) {
#if ISLET_MAX_LANES > 1
    if (!is_endless(g)) return tight_box_at_once(corners_of(g), t);
#endif
    return expand_held(hold(aabb_of(g, t)), tight_margin);
}

}  // namespace

float room_in_box(const Aabb& box, const Geometry& g, const Transform& t) { return room_in(hold(box), held_tight_box(g, t)); }

void fit_boxes(Core& core, std::uint32_t body, bool force, std::uint32_t* marked, std::uint32_t newest) {
    const bool is_static = core.bodies[body].type() == BodyType::static_body;
    const Transform t = body_transform(core, body);
    float slack = newest == every_shape ? 3.0e38f : core.motions[body].slack;
    for (std::uint32_t s = core.bodies[body].shape_head; s != null_index && newest != 0; s = core.shapes[s].next, --newest) {
        Shape& shape = core.shapes[s];
        const Geometry& g = core.geometries[shape.geometry];
        const HeldBox tight = held_tight_box(g, t);
        Aabb& fat = core.boxes[s];
        if (force || is_endless(g) || !is_inside(hold(fat), tight)) {
            const bool is_new = force || fat.lower.x > fat.upper.x;  // otherwise the shape keeps its margin
            if (is_new) shape.margin = is_static ? 0 : min(max_box_margin, box_margin_fraction * extent_of(g, middle_of(g)).max);
            fat = as_box(expand_held(tight, shape.margin));
            mark_moved(core, s, marked);
        }
        slack = min(slack, room_in(hold(fat), tight));
    }
    core.motions[body].slack = is_beyond(core.poses[body].center) ? -1.0f : slack;
}

void update_boxes(Core& core, std::uint32_t body, bool force, std::uint32_t newest) { fit_boxes(core, body, force, nullptr, newest); }

namespace {

// Of a shape that is no solid, the thickness does not count.
Extent shape_extent(const Core& core, std::uint32_t shape) {
    const Shape& s = core.shapes[shape];
    const Extent e = extent_of(core.geometries[s.geometry], core.bodies[s.body].local_center);
    return {e.max, has_sensors && (s.flags & shape_sensor) != 0 ? 3.0e38f : e.min};
}

}  // namespace

Extent body_extent(const Core& core, std::uint32_t body, std::uint32_t newest) {
    const Body& b = core.bodies[body];
    Extent all = newest == every_shape ? Extent{0, 3.0e38f} : Extent{core.poses[body].max_extent, b.min_extent};
    for (std::uint32_t s = b.shape_head; s != null_index && newest != 0; s = core.shapes[s].next, --newest) {
        const Extent e = shape_extent(core, s);
        all = {max(all.max, e.max), min(all.min, e.min)};
    }
    return all;
}

bool is_within_others(const Core& core, std::uint32_t shape) {
    const std::uint32_t body = core.shapes[shape].body;
    const Extent all{core.poses[body].max_extent, core.bodies[body].min_extent};
    const Extent own = shape_extent(core, shape);
    // Of the other shapes, as far as it is known: a bound that is not this shape's is one of theirs.
    Extent rest{own.max < all.max ? all.max : 0, own.min > all.min ? all.min : 3.0e38f};
    for (std::uint32_t s = core.bodies[body].shape_head; s != null_index && (rest.max < all.max || rest.min > all.min); s = core.shapes[s].next) {
        if (s == shape) continue;
        const Extent e = shape_extent(core, s);
        rest = {max(rest.max, e.max), min(rest.min, e.min)};
    }
    return rest.max >= all.max && rest.min <= all.min && core.bodies[body].shape_count > 1;
}

void update_extent(Core& core, std::uint32_t body, std::uint32_t newest) {
    const Extent extent = body_extent(core, body, newest);
    core.poses[body].max_extent = extent.max;
    core.bodies[body].min_extent = extent.min;
}

namespace {

// The inverse of a mass or an inertia.
ISLET_SHARED float inverse_of(float a, float least) { return 1.0f / clamp(a, least, max_mass); }

}  // namespace

void apply_mass(Core& core, std::uint32_t body, const MassData& mass, std::uint32_t newest) {
    Body& b = core.bodies[body];
    Pose& pose = core.poses[body];
    Motion& motion = core.motions[body];
    const bool dynamic = b.type() == BodyType::dynamic;
    const bool turns = dynamic && (b.flags & body_fixed_rotation) == 0 && mass.inertia > 0;
    b.mass = dynamic ? mass.mass : 0;
    b.inertia = dynamic ? mass.inertia : 0;
    if (b.joint_count != 0) core.state->trees_stale = 1;
    pose.inv_mass = dynamic ? inverse_of(mass.mass, min_mass) : 0;
    pose.inv_inertia = turns ? inverse_of(mass.inertia, min_inertia) : 0;

    if (b.local_center != mass.center) {
        // Manifolds keep arms from the centre of mass, so they must be made anew.
        for_each_contact(core, body,
                         [&](std::uint32_t contact, std::uint32_t) { core.manifolds[contact].flags &= ~static_cast<std::uint32_t>(contact_posed); });
    }
    const Vec2 old_center = pose.center;
    b.local_center = mass.center;
    pose.center = transform_point(body_transform(core, body), mass.center);
    motion.v = capped(motion.v + cross(motion.w, pose.center - old_center));
    update_extent(core, body, newest);
}

void update_mass(Core& core, std::uint32_t body, std::uint32_t newest) {
    Body& b = core.bodies[body];
    if (b.type() != BodyType::dynamic) {
        apply_mass(core, body, {}, newest);
        return;
    }
    MassData total;
    float inertia = 0;  // about the body's origin
    for (std::uint32_t s = b.shape_head; s != null_index; s = core.shapes[s].next) {
        const MassData m = mass_of(core, core.shapes[s]);
        total.mass += m.mass;
        total.center += m.mass * m.center;
    }
    total.center *= 1.0f / total.mass;
    const float known = total.mass + 0.0f * (total.center.x + total.center.y);  // the mass; NaN if the centre is not finite
    if (!(known >= min_mass && known <= no_limit)) {
        // A dynamic body without mass would not move, so it gets a kilogram; so does a body whose shapes' masses overflow. A body lighter than min_mass becomes
        // a point of that mass.
        apply_mass(core, body, {total.mass > 0 && total.mass < min_mass ? min_mass : 1.0f, {0, 0}, 0});
        return;
    }
    for (std::uint32_t s = b.shape_head; s != null_index; s = core.shapes[s].next) {
        const MassData m = mass_of(core, core.shapes[s]);
        inertia += m.inertia + m.mass * distance_squared(m.center, total.center);
    }
    total.inertia = min(inertia, no_limit);
    apply_mass(core, body, total);
}

}  // namespace islet::detail
