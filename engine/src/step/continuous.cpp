// A shape's core, half as thick as the shape, decides: a body is stopped only if a core would meet another shape, and then where the surfaces meet. So bodies
// that lie or slide on something, sunk in a little, or that graze a corner, are left to their contacts in the next step. A shape that does pass a surface
// passes it by less than half its thickness, and is pushed back the way it came.
//
// The body keeps its velocity and loses the rest of the step. (Box2D 3 also stops bodies where they hit, and lets them go on in the next step without a solve
// of their own.) But a body that touches static faces and gets nowhere goes along them instead: else what is pressed in so deep that its middle has come to a
// face would be nailed there, and torn off its joints. If it still gets nowhere, or is wedged between faces, it is stopped for good: else it would gather speed
// for as long as it is wedged.
#include "../exact.hpp"

#include "../step/continuous.hpp"

#include "../bodies/bounds.hpp"
#include "../broadphase/pairs.hpp"
#include "../broadphase/tree.hpp"
#include "../collide/time_of_impact.hpp"
#include "../data/features.hpp"
#include "../graph/contacts.hpp"
#include "../graph/hooks.hpp"
#include "../math/boxes.hpp"
#include "../math/scalar.hpp"
#include "../solver/free_motion.hpp"
#include "../step/clear_way.hpp"

namespace islet::detail {

namespace {

inline constexpr float most_tolerance = 0.25f * linear_slop;  // m
inline constexpr float least_progress = 0.001f;               // share of its way; a body that goes less goes nowhere
inline constexpr float least_alike = 0.7f;                    // cosine of the angle between what lets a body slide; else it is wedged
inline constexpr float least_gap = 0.05f * linear_slop;       // m that the middle of a shape keeps from a surface that it must not pass

// The smallest distance of the polygon's faces from its middle.
float inner_radius(const Polygon& p) {
    float radius = dot(p.normals[0], p.vertices[0] - p.centroid);
    for (std::uint32_t i = 1; i < p.count; ++i) radius = min(radius, dot(p.normals[i], p.vertices[i] - p.centroid));
    return radius;
}

// Corner i with both its faces moved in by `inset`; half-way to the middle where another face is short and therefore in the way.
Vec2 inset_corner(const Polygon& p, std::uint32_t i, float inset) {
    const Vec2 n1 = p.normals[(i == 0 ? p.count : i) - 1], n2 = p.normals[i];
    const Vec2 corner = p.vertices[i] - inset / (1.0f + dot(n1, n2)) * (n1 + n2);
    for (std::uint32_t k = 0; k < p.count; ++k)
        if (!(dot(p.normals[k], p.vertices[k] - corner) >= 0.5f * inset)) return lerp(p.vertices[i], p.centroid, 0.5f);
    return corner;
}

float half_thickness(const Geometry& g) {
    const Polygon* faces = faces_of(g);
    return corners_of(g).radius + (faces != nullptr ? inner_radius(*faces) : 0);
}

enum class Part { whole, core, middle };

// Where another body is and goes, as a body sees it at the start.
Around around_way(const Core& core, const BodyPath& path, Vec2 local_center, std::uint32_t other, const BodyPath& other_path) {
    const Vec2 apart = other_path.center - path.center;
    const float way = length(other_path.way - path.way);
    return {local_center + inv_rotate(path.q, apart), core.poses[other].max_extent + way + abs(path.turn) * (length(apart) + way)};
}

/// The part of a shape that is followed: all of it, its core, or its middle (a point or a line). Of a shape without end: the part around the other one's way.
MovingCore moving_core(const Core& core, std::uint32_t shape, const BodyPath& path, Part part, std::uint32_t other, const BodyPath& other_path) {
    const Geometry& g = core.geometries[core.shapes[shape].geometry];
    const Vec2 center = core.bodies[core.shapes[shape].body].local_center;
    Vec2 room[4];
    const Corners corners = corners_near(g, is_endless(g) ? around_way(core, path, center, core.shapes[other].body, other_path) : Around{}, room);
    const Polygon* faces = part != Part::whole ? faces_of(g) : nullptr;
    const bool inset = faces != nullptr;
    const float by = inset ? 0.5f * inner_radius(*faces) : 0;
    MovingCore s;
    s.path = path;
    s.core.count = inset && part == Part::middle ? 1 : corners.count;
    s.core.radius = part == Part::whole ? corners.radius : part == Part::core ? 0.5f * corners.radius : 0;
    for (std::uint32_t i = 0; i < s.core.count; ++i) {
        const Vec2 point = !inset ? corners.points[i] : part == Part::core ? inset_corner(*faces, i, by) : faces->centroid;
        s.core.points[i] = point - center;
        s.reach = max(s.reach, length(s.core.points[i]));
    }
    return s;
}

// A chain is met only from its front.
bool comes_from_behind(const Core& core, std::uint32_t shape, const BodyPath& path, std::uint32_t other) {
    const Geometry& g = core.geometries[core.shapes[other].geometry];
    if (kind_of(g) != ShapeKind::front) return false;
    const std::uint32_t body = core.shapes[other].body;
    const Vec2 middle = middle_of(core.geometries[core.shapes[shape].geometry]) - core.bodies[core.shapes[shape].body].local_center;
    const Vec2 from = inv_transform_point(body_transform(core, body), path.center + rotate(path.q, middle));
    const Vec2* line = corners_of(g).points;
    return dot(right_perp(line[1] - line[0]), from - line[0]) < 0;
}

// Whether the contact of two shapes holds in this step, if one of them is one-way or asks the pre_solve hook. The contact of a fast body was made ahead, and
// the hook, which must not be called from here, has decided about it. Without a contact the shapes pass each other.
bool is_held(const Core& core, std::uint32_t shape, std::uint32_t other, bool asks) {
    bool held = false;
    for_each_contact(core, core.shapes[shape].body, [&](std::uint32_t contact, std::uint32_t) {
        const Contact& c = core.contacts[contact];
        if (c.shape_a + c.shape_b != shape + other || (c.shape_a != shape && c.shape_b != shape)) return;
        const ContactManifold& m = core.manifolds[contact];
        held = (m.flags & contact_passes) == 0 && (!asks || m.count() > 0);
    });
    return held;
}

// Whether a contact holds the body.
bool has_touch(const Core& core, std::uint32_t body) {
    bool found = false;
    for_each_contact(core, body, [&](std::uint32_t contact, std::uint32_t) { found = found || (core.manifolds[contact].flags & contact_touching) != 0; });
    return found;
}

// Which way out of the static bodies that it touches a body would go, unit; zero if it touches none, or is wedged between several.
Vec2 way_out(const Core& core, std::uint32_t body) {
    Vec2 out;
    bool wedged = false;
    for_each_contact(core, body, [&](std::uint32_t contact, std::uint32_t side) {
        const ContactManifold& m = core.manifolds[contact];
        if ((m.flags & contact_touching) == 0 || core.bodies[other_body(core, contact, side)].type() != BodyType::static_body) return;
        const Vec2 own = side == 0 ? -m.normal : m.normal;
        wedged = wedged || (out != Vec2{} && dot(out, own) < least_alike);
        out = own;
    });
    return wedged ? Vec2{} : out;
}

bool is_solid(const Core& core, std::uint32_t shape, std::uint32_t other) {
    const std::uint32_t flags = core.shapes[shape].flags | core.shapes[other].flags;
    if ((flags & shape_sensor) != 0) return false;
    if ((flags & (shape_pre_solve | shape_one_way_bits)) != 0 && !is_held(core, shape, other, (flags & shape_pre_solve) != 0)) return false;
    return may_collide(core, shape, other) && (!has_hooks || core.hooks.filter == nullptr || stops_by_hook(core, shape, other));
}

// The share of its way after which static bodies stop a body; 1 if none does.
float stop_on_way(const Core& core, std::uint32_t body, const BodyPath& path) {
    TreeWalk walk(Tree{&core.state->tree, core.tree}, box_of_way(path.center, path.way, core.poses[body].max_extent));
    std::uint32_t other = walk.next();
    if (other == null_index) return 1;  // as for most bodies that fall or fly
    ClearWay clear_way;
    if (has_shortcuts) clear_way = clear_way_of(path, core.poses[body].max_extent, core.bodies[body].min_extent, 0.5f * most_tolerance);
    float end = 1;
    do {
        const std::uint32_t wall = core.shapes[other].body;
        if (core.bodies[wall].type() != BodyType::static_body) continue;
        for (std::uint32_t s = core.bodies[body].shape_head; s != null_index; s = core.shapes[s].next) {
            if (has_shortcuts && keeps_clear(clear_way, core.geometries[core.shapes[s].geometry], core.bodies[body].local_center,
                                             core.geometries[core.shapes[other].geometry], body_transform(core, wall)))
                continue;
            end = min(end, stop_time(core, s, path, other, at_rest(core, wall), end));
        }
    } while ((other = walk.next()) != null_index);
    return end;
}

// Moves a body, whose middle static bodies hold, a little along `out`, with what its way has of the other direction taken away, and its turn if need be.
// Returns the share of that way after which it is stopped, and the way in `taken`; 0 if it is held there, too.
float let_go(Core& core, std::uint32_t body, const BodyPath& path, Vec2 out, BodyPath& taken) {
    const Vec2 step_out = 2 * least_gap * out;
    if (stop_on_way(core, body, {path.center, path.q, step_out, 0}) < 1) return 0;
    Motion& motion = core.motions[body];
    taken = path;
    taken.center += step_out;
    taken.way -= min(dot(taken.way, out), 0.0f) * out;
    float end = stop_on_way(core, body, taken);
    const bool turns = end > least_progress;
    if (!turns) {
        taken.turn = 0;
        end = stop_on_way(core, body, taken);
    }
    if (end <= least_progress) return 0;
    motion.v -= min(dot(motion.v, out), 0.0f) * out;
    if (!turns) motion.w = 0;
    return end;
}

}  // namespace

BodyPath path_ahead(const Core& core, std::uint32_t body, float dt, bool may_be_held) {
    const Motion& motion = core.motions[body];
    const Vec2 gain = dt * pull_on(core, body);
    const bool held = may_be_held && length_squared(motion.v) < length_squared(gain);
    Vec2 v = held ? motion.v : motion.v + gain;
    if (const float most = core.state->max_speed; !(dot(v, v) <= most * most)) v = limit_speed(v, most);
    return {core.poses[body].center, core.poses[body].q, dt * v, within_bounds(dt * motion.w, 0.5f * pi)};
}

float time_to_touch(const Core& core, std::uint32_t shape_a, const BodyPath& a, std::uint32_t shape_b, const BodyPath& b) {
    return time_of_impact(moving_core(core, shape_a, a, Part::whole, shape_b, b), moving_core(core, shape_b, b, Part::whole, shape_a, a), touch_gap, 1);
}

BodyPath path_of(const Core& core, std::uint32_t body, const SolverBody& way) {
    const Pose& pose = core.poses[body];
    return {pose.center - way.dp, pose.q * inverse(integrate({1, 0}, way.dq)), way.dp, way.dq};
}

BodyPath at_rest(const Core& core, std::uint32_t body) { return {core.poses[body].center, core.poses[body].q, {0, 0}, 0}; }

float stop_time(const Core& core, std::uint32_t shape, const BodyPath& way, std::uint32_t other, const BodyPath& other_way, float end) {
    if (!is_solid(core, shape, other) || comes_from_behind(core, shape, way, other)) return no_impact;
    const float tolerance = clamp(0.25f * half_thickness(core.geometries[core.shapes[shape].geometry]), 0.1f * linear_slop, most_tolerance);
    const MovingCore obstacle = moving_core(core, other, other_way, Part::whole, shape, way);
    const auto moving = [&](Part part) { return moving_core(core, shape, way, part, other, other_way); };
    float passing = time_of_impact(moving(Part::core), obstacle, 0.5f * tolerance, end);
    // If the shape has already been pressed in so deep, at least its middle must stay on this side.
    if (passing <= 0) passing = time_of_impact(moving(Part::middle), obstacle, least_gap, end);
    if (passing < 0 || passing == no_impact) return no_impact;
    const float touching = time_of_impact(moving(Part::whole), obstacle, tolerance, passing);
    return touching > 0 && touching < passing ? touching : passing;
}

Aabb box_of_way(Vec2 start, Vec2 way, float reach) { return expand(box_around(start, start + way), reach); }

void place_at_end(Core& core, std::uint32_t body, const BodyPath& way, SolverBody& out) {
    core.poses[body].center = way.center + way.way;
    core.poses[body].q = integrate(way.q, way.turn);
    out.dp = way.way;
    out.dq = way.turn;
}

void stop_at_static(Core& core, std::uint32_t body, SolverBody& way) {
    if (!core.is_dynamic(body)) return;
    const BodyPath path = path_of(core, body, way);
    float end = stop_on_way(core, body, path);
    if (end >= 1) return;
    BodyPath taken = path;
    if (end <= least_progress && has_touch(core, body)) {
        Motion& motion = core.motions[body];
        end = 0;
        const Vec2 out = way_out(core, body);
        if (out != Vec2{}) {
            // The contact's normal may lead along the face that the middle lies at, as at the top of a thin wall. Of four ways a quarter turn apart, one leads
            // away from any face.
            for (const Vec2 way_off : {out, Vec2{1, 0}, Vec2{-1, 0}, Vec2{0, 1}, Vec2{0, -1}})
                if (end <= 0) end = let_go(core, body, path, way_off, taken);
        }
        if (end <= 0) {
            taken = path;
            motion.v = {0, 0};
            motion.w = 0;
        }
    }
    place_at_end(core, body, {path.center, path.q, taken.center - path.center + end * taken.way, end * taken.turn}, way);
}

}  // namespace islet::detail
