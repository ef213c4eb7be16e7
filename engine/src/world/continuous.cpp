// What decides is a shape's core, half as thick as the shape: only if that would meet another shape is the body stopped, and then where the surfaces
// meet. So a body that lies or slides on something, sunk in by a little, or that grazes a corner, is left to its contacts, which see it in the next
// step; and what does pass a surface passes it by less than half its thickness, and is pushed back the way it came.
//
// The body keeps its velocity, and loses what is left of the step. (That a body may be stopped where it hits and go on in the next step, without a
// solve of its own, is Box2D 3's way too.)
#include "world/continuous.hpp"

#include "broadphase/contacts.hpp"
#include "broadphase/tree.hpp"
#include "collide/time_of_impact.hpp"
#include "math/scalar.hpp"
#include "world/bounds.hpp"
#include "world/hooks.hpp"

namespace islet::detail {

namespace {

inline constexpr float least_gap = 0.05f * linear_slop;  // m that the middle of a shape keeps from what it must not pass
inline constexpr std::uint32_t bullet_rounds = 4;  // each may stop a bullet in the way of another

/// The way a body has just made.
Sweep sweep_of(const Core& core, std::uint32_t body, const SolverBody& way) {
    const Pose& pose = core.poses[body];
    return {pose.center - way.dp, pose.q * inverse(integrate({1, 0}, way.dq)), way.dp, way.dq};
}

Sweep at_rest(const Core& core, std::uint32_t body) { return {core.poses[body].center, core.poses[body].q, {0, 0}, 0}; }

// Smallest distance of the polygon's faces from its middle.
float inner_radius(const Polygon& p) {
    float radius = dot(p.normals[0], p.vertices[0] - p.centroid);
    for (std::uint32_t i = 1; i < p.count; ++i) radius = min(radius, dot(p.normals[i], p.vertices[i] - p.centroid));
    return radius;
}

// Corner i with both its faces moved in by `inset`; where another face is short, and so in the way, half-way to the middle.
Vec2 inset_corner(const Polygon& p, std::uint32_t i, float inset) {
    const Vec2 n1 = p.normals[(i == 0 ? p.count : i) - 1], n2 = p.normals[i];
    const Vec2 corner = p.vertices[i] - inset / (1.0f + dot(n1, n2)) * (n1 + n2);
    for (std::uint32_t k = 0; k < p.count; ++k)
        if (!(dot(p.normals[k], p.vertices[k] - corner) >= 0.5f * inset)) return lerp(p.vertices[i], p.centroid, 0.5f);
    return corner;
}

float half_thickness(const Geometry& g) {
    return corners_of(g).radius + (g.shape_type() == ShapeType::polygon ? inner_radius(g.polygon) : 0);
}

enum class Part { whole, core, middle };

/// What of a shape is swept: all of it, its core, or its middle, a point or a line.
SweptCore swept(const Core& core, std::uint32_t shape, const Sweep& sweep, Part part) {
    const Geometry& g = core.geometries[core.shapes[shape].geometry];
    const Vec2 center = core.bodies[core.shapes[shape].body].local_center;
    const Corners corners = corners_of(g);
    const bool inset = part != Part::whole && g.shape_type() == ShapeType::polygon;
    const float by = inset ? 0.5f * inner_radius(g.polygon) : 0;
    SweptCore s;
    s.sweep = sweep;
    s.core.count = inset && part == Part::middle ? 1 : corners.count;
    s.core.radius = part == Part::whole ? corners.radius : part == Part::core ? 0.5f * corners.radius : 0;
    for (std::uint32_t i = 0; i < s.core.count; ++i) {
        const Vec2 point = !inset ? corners.points[i] : part == Part::core ? inset_corner(g.polygon, i, by) : g.polygon.centroid;
        s.core.points[i] = point - center;
        s.reach = max(s.reach, length(s.core.points[i]));
    }
    return s;
}

// A chain is met from its front alone.
bool comes_from_behind(const Core& core, std::uint32_t shape, const Sweep& sweep, std::uint32_t other) {
    const Geometry& g = core.geometries[core.shapes[other].geometry];
    if (g.shape_type() != ShapeType::chain_segment) return false;
    const std::uint32_t body = core.shapes[other].body;
    const Vec2 middle = middle_of(core.geometries[core.shapes[shape].geometry]) - core.bodies[core.shapes[shape].body].local_center;
    const Vec2 from = inv_transform_point(body_transform(core, body), sweep.center + rotate(sweep.q, middle));
    const Segment& s = g.chain.segment;
    return dot(right_perp(s.point2 - s.point1), from - s.point1) < 0;
}

bool is_solid(const Core& core, std::uint32_t shape, std::uint32_t other) {
    constexpr std::uint32_t undecided = shape_sensor | shape_pre_solve;  // passes through, or may
    if (((core.shapes[shape].flags | core.shapes[other].flags) & undecided) != 0) return false;
    return may_collide(core, shape, other) && (!has_hooks || core.hooks.filter == nullptr || stops_by_hook(core, shape, other));
}

/// The fraction of the way at which `shape` must stop for `other`, or no_impact.
float stop_time(const Core& core, std::uint32_t shape, const Sweep& way, std::uint32_t other, const Sweep& other_way, float end) {
    if (!is_solid(core, shape, other) || comes_from_behind(core, shape, way, other)) return no_impact;
    const float tolerance = clamp(0.25f * half_thickness(core.geometries[core.shapes[shape].geometry]), 0.1f * linear_slop, 0.25f * linear_slop);
    const SweptCore obstacle = swept(core, other, other_way, Part::whole);
    float passing = time_of_impact(swept(core, shape, way, Part::core), obstacle, 0.5f * tolerance, 0.5f * tolerance, end);
    // Where it has been squeezed in so deep already, its middle must at least stay on this side.
    if (passing <= 0) passing = time_of_impact(swept(core, shape, way, Part::middle), obstacle, least_gap, least_gap, end);
    if (passing < 0 || passing == no_impact) return no_impact;
    const float touching = time_of_impact(swept(core, shape, way, Part::whole), obstacle, tolerance, tolerance, passing);
    return touching > 0 && touching < passing ? touching : passing;
}

Aabb box_of_way(const Sweep& way, float reach) {
    const Vec2 end = way.center + way.way;
    return expand({min(way.center, end), max(way.center, end)}, reach);
}

/// Puts the body where its way now ends.
void place_at_end(Core& core, std::uint32_t body, const Sweep& way, SolverBody& out) {
    core.poses[body].center = way.center + way.way;
    core.poses[body].q = integrate(way.q, way.turn);
    out.dp = way.way;
    out.dq = way.turn;
}

float moved_by(const SolverBody& way, float reach) { return length(way.dp) + abs(way.dq) * reach; }

/// The first impact of a body with others on their ways.
struct Impact {
    float fraction = no_impact;
    Sweep other;
};

void meet(const Core& core, std::uint32_t body, const Sweep& way, std::uint32_t other_shape, const Sweep& other, Impact& first) {
    for (std::uint32_t s = core.bodies[body].shape_head; s != null_index; s = core.shapes[s].next) {
        const float fraction = stop_time(core, s, way, other_shape, other, min(first.fraction, 1.0f));
        if (fraction < first.fraction) first = {fraction, other};
    }
}

Impact first_impact(const Core& core, std::uint32_t body, const Sweep& way, const std::uint32_t* body_of, std::uint32_t slot_count,
                    const SolverBody* bodies, std::uint32_t slot) {
    Impact first;
    const Pose& pose = core.poses[body];
    const float far_enough = swept_fraction * core.bodies[body].min_extent;
    const Aabb box = box_of_way(way, pose.max_extent);
    const float turned = abs(way.turn) * pose.max_extent;
    for (std::uint32_t i = 1; i < slot_count; ++i) {
        const std::uint32_t other = body_of[i];
        const SolverBody& other_way = bodies[i];
        const Pose& other_pose = core.poses[other];
        const Vec2 start = other_pose.center - other_way.dp;
        const Aabb other_box = expand({min(start, other_pose.center), max(start, other_pose.center)}, other_pose.max_extent);
        if (i == slot || !overlaps(box, other_box)) continue;
        if (length(way.way - other_way.dp) + turned + abs(other_way.dq) * other_pose.max_extent <= far_enough) continue;
        const Sweep sweep = sweep_of(core, other, other_way);
        for (std::uint32_t s = core.bodies[other].shape_head; s != null_index; s = core.shapes[s].next) meet(core, body, way, s, sweep, first);
    }
    if (length(way.way) + turned <= far_enough) return first;
    tree_query(Tree{&core.state->tree, core.tree}, box, [&](std::uint32_t shape) {
        const std::uint32_t other = core.shapes[shape].body;
        if (core.bodies[other].type() != BodyType::static_body) meet(core, body, way, shape, at_rest(core, other), first);
    });
    return first;
}

// From the impact on the bullet keeps its place on the other body, so that this does not pass through it either.
Sweep carried(const Sweep& way, const Impact& impact) {
    const float f = impact.fraction;
    const Sweep& other = impact.other;
    const Vec2 place = inv_rotate(rotation_at(other, f), center_at(way, f) - center_at(other, f));
    const Vec2 end = center_at(other, 1) + rotate(rotation_at(other, 1), place);
    return {way.center, way.q, end - way.center, f * way.turn + (1 - f) * other.turn};
}

}  // namespace

Sweep sweep_ahead(const Core& core, std::uint32_t body, float dt) {
    const Motion& motion = core.motions[body];
    return {core.poses[body].center, core.poses[body].q, dt * motion.v, clamp(dt * motion.w, -0.5f * pi, 0.5f * pi)};
}

float time_to_touch(const Core& core, std::uint32_t shape_a, const Sweep& a, std::uint32_t shape_b, const Sweep& b) {
    constexpr float gap = 0.25f * linear_slop;
    return time_of_impact(swept(core, shape_a, a, Part::whole), swept(core, shape_b, b, Part::whole), gap, gap, 1);
}

void stop_at_static(Core& core, std::uint32_t body, SolverBody& way) {
    if (!core.is_dynamic(body)) return;
    Sweep sweep = sweep_of(core, body, way);
    float end = 1;
    tree_query(Tree{&core.state->tree, core.tree}, box_of_way(sweep, core.poses[body].max_extent), [&](std::uint32_t other) {
        const std::uint32_t wall = core.shapes[other].body;
        if (core.bodies[wall].type() != BodyType::static_body) return;
        for (std::uint32_t s = core.bodies[body].shape_head; s != null_index; s = core.shapes[s].next)
            end = min(end, stop_time(core, s, sweep, other, at_rest(core, wall), end));
    });
    if (end >= 1) return;
    sweep.way = end * sweep.way;
    sweep.turn = end * sweep.turn;
    place_at_end(core, body, sweep, way);
}

void stop_bullets(Core& core, const std::uint32_t* body_of, std::uint32_t slot_count, SolverBody* bodies) {
    bool again = true;
    for (std::uint32_t round = 0; again && round < bullet_rounds; ++round) {
        again = false;
        for (std::uint32_t slot = 1; slot < slot_count; ++slot) {
            const std::uint32_t body = body_of[slot];
            if ((core.bodies[body].flags & body_bullet) == 0 || !core.is_dynamic(body)) continue;
            const Sweep way = sweep_of(core, body, bodies[slot]);
            const Impact impact = first_impact(core, body, way, body_of, slot_count, bodies, slot);
            if (impact.fraction >= 1) continue;
            place_at_end(core, body, carried(way, impact), bodies[slot]);
            if (moved_by(bodies[slot], core.poses[body].max_extent) > swept_fraction * core.bodies[body].min_extent)
                stop_at_static(core, body, bodies[slot]);
            core.bodies[body].origin = core.poses[body].center - rotate(core.poses[body].q, core.bodies[body].local_center);
            update_boxes(core, body, false);
            again = true;
        }
    }
}

}  // namespace islet::detail
