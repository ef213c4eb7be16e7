// Arguments of every kind out of a fuzzer's bytes: good ones mostly, and all that a user may get wrong.
#include "caller.hpp"

namespace islet::fuzz {

// Of ids mostly ones that live, if any does: the next from a slot that the byte names.
BodyId Caller::body() {
    const std::uint32_t which = in.byte();
    if (which >= 248) return which % 2 == 0 ? dead_body : BodyId{which - 247, in.byte()};
    for (std::uint32_t i = 0; i < w.capacity().bodies; ++i) {
        const BodyId id = w.body_at((which + i) % w.capacity().bodies);
        if (id) return id;
    }
    return {};
}

ShapeId Caller::shape() {
    const std::uint32_t owner = in.byte(), which = in.byte();
    if (which >= 248) return which % 2 == 0 ? dead_shape : ShapeId{which - 247, in.byte()};
    for (std::uint32_t i = 0; i < w.capacity().bodies; ++i) {
        const BodyId id = w.body_at((owner + i) % w.capacity().bodies);
        ShapeId shapes[max_shapes];
        const std::uint32_t n = id ? w.shapes(id, shapes) : 0;
        if (n > 0) return shapes[which % (n < max_shapes ? n : max_shapes)];
    }
    return {};
}

JointId Caller::joint() {
    const std::uint32_t which = in.byte();
    if (which >= 248) return which % 2 == 0 ? dead_joint : JointId{which - 247, in.byte()};
    for (std::uint32_t i = 0; i < w.capacity().joints; ++i) {
        const JointId id = w.joint_at((which + i) % w.capacity().joints);
        if (id) return id;
    }
    return {};
}

WorldDef Caller::world_def() {
    WorldDef d;
    const std::uint32_t more = in.byte();
    if ((more & 1) != 0) d.gravity = in.point();
    d.enable_sleep = (more & 2) == 0;
    if ((more & 4) != 0) d.restitution_threshold = in.size();
    if ((more & 8) != 0) d.max_speed = 100 * in.size();
    if ((more & 16) != 0) d.hit_threshold = in.size();
    d.continuous = (more & 32) == 0;
    if ((more & 64) != 0) d.solver = solver_def(d.solver);
    if ((more & 128) != 0) d.lanes = in.below(10);
    return d;
}

/// One thing changed. Few sweeps: an input should not take seconds.
SolverDef Caller::solver_def(SolverDef d) {
    switch (in.below(18)) {
    case 0: d.schedule = static_cast<Schedule>(in.below(3)); break;
    case 1: d.substeps = in.below(7); break;
    case 2: d.iterations = in.below(6); break;
    case 3: d.relax_iterations = in.below(6); break;
    case 4: d.contact_hertz = in.size() * 20; break;
    case 5: d.joint_hertz = in.size() * 20; break;
    case 6: d.omega = in.size(); break;
    case 7: d.warm_start = in.flag(); break;
    case 8: d.joint_trees = static_cast<JointTrees>(in.below(4)); break;
    case 9: d.sweep_order = static_cast<SweepOrder>(in.below(5)); break;
    case 10: d.block_contacts = in.flag(); d.measure_residual = in.flag(); break;
    case 11: d.contact_damping_ratio = in.size(); break;
    case 12: d.contact_push_speed = in.size(); break;
    case 13: d.joint_damping_ratio = in.size(); break;
    case 14: d.baumgarte = 0.5f * in.size(); break;
    case 15: d.joint_tree_load = in.size(); break;
    default: d.shock = 0.25f * in.size(); d.tolerance = in.size();
    }
    return d;
}

BodyDef Caller::body_def() {
    BodyDef d;
    d.type = static_cast<BodyType>(in.below(8) < 5 ? 2 : in.below(3));
    d.position = in.place();
    d.angle = in.number();
    const std::uint32_t more = in.byte();
    if ((more & 1) != 0) d.linear_velocity = in.point();
    if ((more & 2) != 0) d.angular_velocity = in.number();
    if ((more & 4) != 0) d.linear_damping = in.size();
    if ((more & 8) != 0) d.gravity_scale = in.number();
    d.awake = (more & 16) == 0;
    d.fixed_rotation = (more & 32) != 0;
    d.bullet = (more & 64) != 0;
    if (d.awake && d.fixed_rotation) {
        const std::uint32_t rare = in.byte();
        d.lock_x = (rare & 1) != 0;
        d.lock_y = (rare & 2) != 0;
        d.enabled = (rare & 12) != 0;
    }
    if ((more & 128) != 0) d.sleep_threshold = in.size();
    return d;
}

ShapeDef Caller::shape_def() {
    ShapeDef d;
    const std::uint32_t more = in.byte();
    if ((more & 1) != 0) d.friction = in.size();
    if ((more & 2) != 0) d.restitution = 0.25f * in.size();
    if ((more & 4) != 0) d.rolling_resistance = in.size();
    if ((more & 8) != 0) d.tangent_speed = in.number();
    if ((more & 16) != 0) d.density = in.size();
    if ((more & 32) != 0) d.filter = filter();
    if ((more & 64) != 0) {
        const std::uint32_t what = in.byte();
        d.sensor = (what & 1) != 0;
        d.sensor_events = (what & 2) != 0;
        d.hit_events = (what & 4) != 0;
        d.pre_solve = (what & 8) != 0;
        if ((what & 7) == 7) d.one_way = {0, 1};
        d.material = what;
    }
    return d;
}

Filter Caller::filter() {
    const std::uint32_t category = in.byte(), mask = in.byte();
    return {category, mask, static_cast<std::int32_t>(in.below(4)) - 2};
}

Circle Caller::circle() {
    const Vec2 center = in.point();
    return {center, in.size()};
}

Capsule Caller::capsule() {
    const Vec2 from = in.point(), to = in.point();
    return {from, to, in.size()};
}

Segment Caller::segment() {
    const Vec2 from = in.point();
    return {from, in.point()};
}

ChainSegment Caller::chain_segment() {
    const Vec2 before = in.point();
    const Segment s = segment();
    return {before, s, in.point()};
}

HalfSpace Caller::half_space() {
    const float offset = in.number();
    return {in.flag() ? rotate(make_rot(in.number()), {0, 1}) : in.point(), offset};
}

Polygon Caller::polygon() {
    switch (in.below(6)) {
    case 0: {
        const float hx = in.size();
        return make_box(hx, in.size());
    }
    case 1: {
        const float hx = in.size(), hy = in.size();
        return make_rounded_box(hx, hy, in.size());
    }
    case 2: {
        Vec2 points[max_polygon_vertices];
        for (Vec2& p : points) p = in.point();
        const Hull hull = compute_hull({points, in.below(max_polygon_vertices + 1)});
        return make_polygon(hull, in.flag() ? in.size() : 0);
    }
    case 3: {
        const float hx = in.size(), hy = in.size();
        const Vec2 at = in.point();
        const Transform pose = {at, make_rot(in.number())};
        return make_offset_box(hx, hy, pose, in.flag() ? in.size() : 0);
    }
    case 4: {
        const Vec2 at = in.point();
        const Transform pose = {at, make_rot(in.number())};
        return transform_polygon(pose, make_box(in.size(), 0.5f));
    }
    default: {  // made by hand, and badly
        const float hx = in.size();
        Polygon p = make_box(hx, in.size());
        const std::uint32_t which = in.below(max_polygon_vertices);
        p.vertices[which] = in.point();
        p.count = in.below(12);
        return p;
    }
    }
}

ShapeProxy Caller::proxy() {
    switch (in.below(8)) {
    case 0: return make_proxy(circle());
    case 1: return make_proxy(capsule());
    case 2: return make_proxy(segment());
    case 3: return make_proxy(polygon());
    case 4: return make_proxy(chain_segment());
    case 5: {
        const Vec2 lower = in.point();
        return make_proxy(Aabb{lower, in.point()});
    }
    case 6: {
        Vec2 points[max_polygon_vertices];
        for (Vec2& p : points) p = in.point();
        const std::uint32_t count = in.below(max_polygon_vertices + 1);
        return make_proxy(std::span<const Vec2>(points, count), in.size());
    }
    default: {
        const Vec2 at = in.point();
        const Transform pose = {at, make_rot(in.number())};
        return transform_proxy(pose, make_proxy(polygon()));
    }
    }
}

JointSpring Caller::spring() {
    const bool on = in.flag();
    const float hertz = in.size(), ratio = in.size();
    return {on, hertz, ratio, in.number()};
}

JointLimit Caller::limit() {
    const bool on = in.flag();
    const float a = in.number(), b = in.number();
    return in.below(8) == 0 || a <= b ? JointLimit{on, a, b} : JointLimit{on, b, a};
}

JointRatchet Caller::ratchet() {
    const float step = in.number();
    return {(in.byte() & 1) != 0 ? step : 0, in.number()};
}

JointMotor Caller::motor() {
    const bool on = in.flag();
    const float speed = in.number();
    return {on, speed, in.size()};
}

JointFrame Caller::frame() {
    const Vec2 at = in.point();
    return {at, in.number()};
}

}  // namespace islet::fuzz
