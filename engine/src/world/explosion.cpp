// Explosions: impulses away from a point, in proportion to the width of a shape as seen from there.
#include "../exact.hpp"

#include "../bodies/bounds.hpp"
#include "../bodies/impulses.hpp"
#include "../bodies/sleep.hpp"
#include "../calls/checks.hpp"
#include "../calls/recorder.hpp"
#include "../collide/distance.hpp"
#include "../math/boxes.hpp"
#include "../math/float_mode.hpp"
#include "../shapes/shape_types.hpp"

namespace islet {

using namespace detail;

namespace {

bool check_explosion(const Core& core, const ExplosionDef& d) {
    return check_position(core, d.position) && check_range(core, d.radius, 0, max_position) && check_range(core, d.falloff, 0, max_position) &&
           check_finite(core, d.impulse_per_length);
}

// The width of a shape along a unit vector: the hull of its corners, and its radius.
float width_along(const Corners& shape, Vec2 direction) {
    float lower = dot(shape.points[0], direction), upper = lower;
    for (std::uint32_t i = 1; i < shape.count; ++i) {
        const float at = dot(shape.points[i], direction);
        lower = min(lower, at);
        upper = max(upper, at);
    }
    return upper - lower + 2.0f * shape.radius;
}

// Computes in the body's frame, so that nothing is lost far from the origin.
void push_shape(Core& core, const ExplosionDef& d, std::uint32_t shape) {
    const std::uint32_t body = core.shapes[shape].body;
    const Geometry& g = core.geometries[core.shapes[shape].geometry];
    const Corners corners = corners_of(g);
    const Pose& pose = core.poses[body];
    const Vec2 local_center = core.bodies[body].local_center;
    const Vec2 from = inv_rotate(pose.q, d.position - pose.center) + local_center;
    const DistanceResult r = core_distance(&from, 1, corners.points, corners.count);
    const float gap = max(r.distance - corners.radius, 0.0f);
    if (gap > d.radius + d.falloff) return;

    const bool inside = gap == 0;
    const Vec2 target = inside ? middle_of(g) : r.point_b;
    Vec2 direction = normalize(target - from);
    if (direction == Vec2{}) direction = {1, 0};  // at the very middle, any direction will do
    const Vec2 point = inside ? target : target - corners.radius * direction;
    const float strength = gap > d.radius ? (d.radius + d.falloff - gap) / d.falloff : 1.0f;
    const Vec2 impulse = rotate(pose.q, (d.impulse_per_length * strength * width_along(corners, left_perp(direction))) * direction);
    wake_island(core, body, core.arena());
    kick(core, body, impulse, cross(rotate(pose.q, point - local_center), impulse));
}

}  // namespace

void World::explode(const ExplosionDef& d) {
    Core& c = core();
    note_call<Call::explode>(c, d);
    const DefaultFloatMode mode;
    if (!check_open(c) || !check_explosion(c, d)) return;
    const float reach = d.radius + d.falloff;
    const Aabb box = expand({d.position, d.position}, reach);
    for (std::uint32_t i = 0; i < c.state->shape_pool.high_water; ++i) {
        if (!pool_live(c.state->shape_pool, c.shapes, i)) continue;
        const Shape& s = c.shapes[i];
        if (!is_pushable(c, s.body) || (s.flags & shape_sensor) != 0 || (s.filter.category & d.mask) == 0 || !meet(c.boxes[i], box)) continue;
        if (kind_of(c.geometries[s.geometry]) == ShapeKind::solid) push_shape(c, d, i);
    }
}

}  // namespace islet
