// Wind on a shape: drag and lift of the part of its outline that faces the stream.
//
// Let u be the air's velocity past the shape, u^ the unit vector along it, and q = rho |u|^2 / 2 the stagnation pressure. An edge of length L with the outward
// normal n faces the stream if n . u < 0. It has the width A = L |n . u| / |u| across the stream, and the force on its middle is
// q A (drag u^ + lift (n x u^) x u^). This is the lift of a flat plate, which grows with the sine of twice its angle. Round ends have no lift and the width 2
// r.
#include "../exact.hpp"

#include "../bodies/bounds.hpp"
#include "../bodies/impulses.hpp"
#include "../bodies/sleep.hpp"
#include "../calls/checks.hpp"
#include "../calls/recorder.hpp"
#include "../math/float_mode.hpp"
#include "../shapes/shape_types.hpp"

namespace islet {

using namespace detail;

namespace {

struct Stream {
    Vec2 along;          // unit
    float pressure = 0;  // N/m
    float drag = 0, lift = 0;
};

// Adds the force on a part of the outline with `width` across the stream, at `arm` from the centre of mass, with the outward normal n (zero if it is round).
void push(Core& core, std::uint32_t body, const Stream& s, float width, Vec2 arm, Vec2 n) {
    const Vec2 force = (s.pressure * width) * (s.drag * s.along + s.lift * cross(cross(n, s.along), s.along));
    pull(core, body, force, cross(arm, force));
}

}  // namespace

void World::apply_wind(ShapeId id, const WindDef& wind) {
    const DefaultFloatMode mode;
    Core& c = core();
    const std::uint32_t i = begin_call<Call::apply_wind>(c, id, wind).slot;
    if (i == null_index || !check(c, all_finite(wind.velocity.x, wind.velocity.y, wind.drag, wind.lift, wind.density), Error::not_finite)) return;
    if (!check(c, wind.density >= 0 && wind.drag >= 0 && length_squared(wind.velocity) <= max_speed_limit * max_speed_limit, Error::out_of_range)) return;
    const std::uint32_t body = c.shapes[i].body;
    const Geometry& g = c.geometries[c.shapes[i].geometry];
    if (!is_pushable(c, body) || kind_of(g) != ShapeKind::solid) return;
    if (!wake_if(c, body, wind.wake)) return;

    const Corners shape = corners_of(g);
    const Pose& pose = c.poses[body];
    const Motion& motion = c.motions[body];
    const auto arm_of = [&](Vec2 local) { return rotate(pose.q, local - c.bodies[body].local_center); };
    const Vec2 middle = arm_of(middle_of(g));
    const Vec2 past = wind.velocity - motion.v - cross(motion.w, middle);
    const Stream stream{normalize(past), 0.5f * wind.density * length_squared(past), wind.drag, wind.lift};
    if (stream.along == Vec2{}) return;

    if (shape.radius > 0) push(c, body, stream, 2.0f * shape.radius, middle, {});
    // A capsule's core is a segment with two sides. Of a polygon, the edges that face the stream count.
    for (std::uint32_t k = 0; shape.count > 1 && k < shape.count; ++k) {
        const Vec2 p1 = shape.points[k], p2 = shape.points[k + 1 < shape.count ? k + 1 : 0];
        const Vec2 edge = rotate(pose.q, p2 - p1);
        const float width = cross(edge, stream.along);
        if (width <= 0) continue;
        const Vec2 n = normalize(right_perp(edge));
        push(c, body, stream, width, arm_of(lerp(p1, p2, 0.5f)) + shape.radius * n, n);
    }
}

}  // namespace islet
