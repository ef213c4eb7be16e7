// A mover's step: its ground carries it, then it walks or falls, and then it pushes the bodies around it.
#include "../exact.hpp"

#include "islet/mover.hpp"

#include "../calls/checks.hpp"
#include "../math/float_mode.hpp"
#include "../math/inlining.hpp"
#include "../mover/mover_slide.hpp"

namespace islet {

using namespace detail;

namespace {

constexpr std::uint32_t walk_passes = 8;
constexpr float no_length = 1e-5f;  // m: shorter ways are not walked
// The weight on a body is at most this many times the body's own, and accelerates the place below the feet, if nothing else holds the body, by at most this
// many times gravity.
constexpr float most_load = 10, most_press = 25;

float approach(float from, float to, float most) { return from + clamp(to - from, -most, most); }

Vec2 limited(Vec2 a, float limit) { return max(min(a, Vec2{limit, limit}), Vec2{-limit, -limit}); }

Vec2 ground_velocity(const Mover& m) { return m.world.velocity_at(m.state.ground, m.support()); }

// The mover takes the ground's speed along, of a light body only what the place below its feet has: the top of a small ball that rolls is slower than the
// support above it.
void leave_ground(Mover& m) {
    const bool light = m.world.type(m.state.ground) == BodyType::dynamic && m.world.mass(m.state.ground) < m.def.mass;
    const Vec2 below = m.support() - m.def.capsule.radius * m.up;
    m.state.velocity += light ? m.world.velocity_at(m.state.ground, below) : ground_velocity(m);
    m.state.ground = {};
    m.state.ground_normal = {};
    m.state.ground_point = {};
}

void stand_on(Mover& m, const Surface& s, Vec2 face) {
    m.state.ground = m.world.body(s.shape);
    m.state.ground_normal = face;
    m.state.ground_point = inv_transform_point(m.world.transform(m.state.ground), m.support());
}

/// How the support, if it were a point of the ground body, answers to impulses: its velocity changes by the product of this symmetric matrix and the impulse.
struct Answer {
    float xx = 0, xy = 0, yy = 0;  // 1/kg
    Vec2 operator*(Vec2 impulse) const { return {xx * impulse.x + xy * impulse.y, xy * impulse.x + yy * impulse.y}; }
};

ISLET_APART Answer answer_of_ground(const Mover& m) {
    const Pose& pose = Core::of(m.world).poses[m.state.ground.index1 - 1];
    const Vec2 arm = m.support() - pose.center;
    const float turn = pose.inv_inertia;
    return {pose.inv_mass + turn * arm.y * arm.y, -turn * arm.x * arm.y, pose.inv_mass + turn * arm.x * arm.x};
}

/// The weight that the mover puts on the ground body, N. It is a force over a whole step, so a body that weighs next to nothing does not get all of it.
ISLET_APART float weight_on_ground(const Mover& m) {
    if (m.world.type(m.state.ground) != BodyType::dynamic) return 0;
    const float yields = dot(m.up, answer_of_ground(m) * m.up);
    const float most = min(m.def.mass, most_load * m.world.mass(m.state.ground));
    return -dot(m.world.gravity(), m.up) * (most * yields > most_press ? most_press / yields : most);
}

/// A body that carries the mover carries its inertia too: what the last step of the world gave to the body, the two now share. A body that rests does not
/// notice this; a light one that gives way under the weight gets no faster than the mover falls. `carried` is how far the step moved the support.
ISLET_APART void share_speed(Mover& m, Vec2 carried) {
    const float weight = weight_on_ground(m), substep = Core::of(m.world).state->last_substep;
    if (!(weight > 0) || !(substep < 0.75f * m.dt)) return;
    // In n substeps of an even acceleration a speed rises from v - gain to v, and its mean is v - gain (n - 1) / 2n.
    const Vec2 gain = 2 * m.dt / (m.dt - substep) * (ground_velocity(m) - (1.0f / m.dt) * carried);
    const Answer a = answer_of_ground(m);
    const float mass = m.def.mass, xx = 1 + mass * a.xx, yy = 1 + mass * a.yy, xy = mass * a.xy;
    Vec2 impulse = -(mass / (xx * yy - xy * xy)) * Vec2{yy * gain.x - xy * gain.y, xx * gain.y - xy * gain.x};
    // Hinges and other bodies may help the body to bear the weight: it then acts as if it were heavier, by as much as the weight made it less fast.
    const float most = weight * m.dt, given = -mass * dot(gain, m.up), falls = -dot(ground_velocity(m), m.up);
    if (given > 0 && falls > 0) {
        const float back = min(most * (given / (given + most)), falls / dot(m.up, a * m.up));
        impulse += max(back - dot(impulse, m.up), 0.0f) * m.up;
    }
    const float size = length(impulse);
    if (size > most) impulse *= most / size;
    if (is_finite(impulse)) m.world.apply_linear_impulse(m.state.ground, impulse, m.support());
}

// The ground has moved since the last step, and the feet go with it. Other surfaces that moved may have come too close.
void ride(Mover& m) {
    Vec2 carried;
    bool follows = m.world.is_valid(m.state.ground);
    if (follows) carried = transform_point(m.world.transform(m.state.ground), m.state.ground_point) - m.support();
    follows = follows && length(carried) <= max_speed_limit * m.dt;  // the mover does not follow ground that was teleported far away
    if (!follows) {
        m.state.ground = {};
        return;
    }
    share_speed(m, carried);
    // A conveyor's surface moves besides.
    const Touched t = touched_by(m);
    for (std::uint32_t i = 0; i < t.count; ++i) {
        const Surface& s = t.surfaces[i];
        const float speed = m.world.tangent_speed(s.shape);
        if (speed == 0 || m.world.body(s.shape) != m.state.ground || dot(s.normal, m.up) < m.least_up) continue;
        carried += m.dt * speed * right_perp(s.normal);
        break;
    }
    slide(m, carried);
}

/// Lowers the feet, by no more than `most`, to the gap above the surface below. Returns that surface, or a null one if there is none. An edge that a mover with
/// this `speed` to the right climbs, or stands on, holds it: else it would sink back from the edge by as much as it rises in a step.
ISLET_APART Met lower(Mover& m, float most, float speed) {
    Met below = way_ahead(m, -(most + mover_gap) * m.up);
    if (!below.hit) return below;
    const float slope = max(dot(below.surface.normal, m.up), 0.5f);
    float drop = below.fraction * (most + mover_gap) - (mover_gap - mover_cast_gap) / slope;
    if (drop > most) return {};
    const Met edge = drop > mover_touch ? way_ahead(m, -drop * m.up, mover_gap) : Met{};
    Vec2 face;
    const Vec2 normal = edge.surface.normal;
    const bool steeper = dot(normal, m.up) < max(m.least_up, dot(below.surface.normal, m.up) - 1e-3f);
    if (edge.hit && steeper && !(speed * dot(normal, m.right) > 0) && can_stand_on(m, edge.surface, face)) {
        drop *= edge.fraction;
        below = edge;
    }
    // Feet that stand at the gap stay where they are, to the bit. If they rise, the ceiling stops them.
    if (drop > mover_touch) m.state.position -= drop * m.up;
    if (drop < -mover_touch) m.state.position -= way_ahead(m, -drop * m.up).fraction * drop * m.up;
    return below;
}

/// Steps up, forward and down onto ground that is too high to walk onto. Returns false, without a move, if that leads nowhere.
bool step_up(Mover& m, Vec2 forward, float distance) {
    const Vec2 before = m.state.position;
    const float feet = dot(m.support(), m.up) - m.def.capsule.radius;
    const float rise = way_ahead(m, m.def.step_height * m.up).fraction * m.def.step_height;
    m.state.position += rise * m.up;
    const float reach = max(distance, 2.0f * mover_gap);
    const float gone = way_ahead(m, reach * forward).fraction * reach;
    m.state.position += gone * forward;
    Vec2 face;
    const Met below = lower(m, rise, dot(forward, m.right));
    const bool higher = dot(m.state.position - before, m.up) > mover_touch;
    const bool reached = below.hit && dot(below.surface.point, m.up) - feet <= m.def.step_height;
    if (gone > mover_gap && higher && reached && can_stand_on(m, below.surface, face)) return true;
    m.state.position = before;
    return false;
}

/// Walks a length along the ground, and up slopes that are not too steep. Returns how far the mover came.
float walk_along(Mover& m, float side, float whole) {
    Vec2 normal = m.state.ground_normal;
    float left = whole;
    for (std::uint32_t pass = 0; pass < walk_passes && left > no_length; ++pass) {
        const Touched t = touched_by(m);
        Bound bounds[mover_planes];
        set_bounds(m, t, bounds);
        for (std::uint32_t i = 0; i < t.count; ++i) {
            const Surface& s = t.surfaces[i];
            Vec2 face;
            if (can_stand_on(m, s, face)) {
                if (dot(s.normal, side * right_perp(normal)) < 0) normal = s.normal;  // the ground rises
            } else if (dot(s.normal, m.up) > 0) {
                const Vec2 wall = normalize(s.normal - dot(s.normal, m.up) * m.up);  // a slope too steep to walk up acts as a wall
                if (wall != Vec2{}) bounds[i].normal = wall;
            }
        }
        const Vec2 way = side * right_perp(normal);
        const Vec2 piece = next_piece(m, left * way, bounds, t.count);
        const Met met = way_ahead(m, piece);
        go(m, met.fraction, piece, left * way);
        const float gone = dot(met.fraction * piece, way);
        left -= max(gone, 0.0f);
        if (gone > 0.01f * left || met.hit) continue;
        if (left > no_length && m.def.step_height > 0 && step_up(m, side * m.right, left)) left = 0;
        break;
    }
    return whole - max(left, 0.0f);
}

/// True if there is ground to stand on under the middle, within reach of the feet.
bool has_ground_below(const Mover& m) {
    Vec2 normal;
    return finds_ground(m, m.support(), m.def.capsule.radius + mover_gap + m.def.snap_distance, normal);
}

/// True if surfaces that are all too steep leave no way down: they hold the mover as ground does.
bool hold_in_wedge(Mover& m) {
    const Touched t = touched_by(m);
    Bound bounds[mover_planes];
    for (std::uint32_t i = 0; i < t.count; ++i) bounds[i] = {t.surfaces[i].normal, 0};
    bool room = true;
    if (t.count < 2 || length_squared(within_bounds(-m.up, bounds, t.count, room)) > 1e-4f) return false;
    stand_on(m, t.surfaces[0], m.up);
    return true;
}

void walk(Mover& m, float wanted) {
    const Vec2 tangent = right_perp(m.state.ground_normal);
    const float speed = approach(dot(m.state.velocity, tangent), wanted, m.def.ground_acceleration * m.dt);
    const float side = speed < 0 ? -1.0f : 1.0f;
    const float gone = walk_along(m, side, abs(speed) * m.dt);
    const float kept = side * min(gone / m.dt, abs(speed));

    const Vec2 there = m.state.position;
    const Met below = lower(m, m.def.snap_distance, speed);
    Vec2 face;
    if (below.hit && can_stand_on(m, below.surface, face)) {
        // An edge behind a mover that walks off it does not hold the mover, unless it is that of a step down, and does not turn it downwards.
        const bool too_steep = dot(below.surface.normal, m.up) < m.least_up;
        const bool behind = kept * dot(below.surface.normal, m.right) > 0;
        if (!too_steep || !behind || has_ground_below(m)) {
            const bool level = behind && is_edge(m, below.surface, face);
            stand_on(m, below.surface, level ? face : below.surface.normal);
            m.state.velocity = kept * right_perp(m.state.ground_normal);
            return;
        }
    }
    m.state.position = there;
    m.state.velocity = kept * tangent;
    if (!hold_in_wedge(m)) leave_ground(m);
}

/// Removes the part of the velocity that leads into touched surfaces, and finds ground among these.
void land(Mover& m) {
    const Touched t = touched_by(m);
    Bound bounds[mover_planes];
    const Vec2 v = m.state.velocity;
    for (std::uint32_t i = 0; i < t.count; ++i) {
        const Surface& s = t.surfaces[i];
        const BodyId body = m.world.body(s.shape);
        const Vec2 surface_velocity = m.world.velocity_at(body, s.point);
        const float away = dot(surface_velocity, s.normal);
        bounds[i] = {s.normal, m.world.type(body) == BodyType::dynamic ? min(away, 0.0f) : away};
        Vec2 face;
        if (m.state.ground || dot(v - surface_velocity, s.normal) > 0.01f || !can_stand_on(m, s, face)) continue;
        stand_on(m, s, face);
    }
    bool room = true;
    const Vec2 kept = within_bounds(v, bounds, t.count, room);
    m.state.velocity = kept;
    if (m.state.ground) {
        const Vec2 tangent = right_perp(m.state.ground_normal);
        m.state.velocity = dot(v - ground_velocity(m), tangent) * tangent;
        return;
    }
    if (dot(v, m.up) <= 0 && hold_in_wedge(m)) m.state.velocity = {};
}

void fall(Mover& m, float wanted) {
    float pull = m.def.air_acceleration * m.dt;
    const Touched t = touched_by(m);
    const float sideways = dot(m.state.velocity, m.right);
    for (std::uint32_t i = 0; i < t.count; ++i) {  // a mover in the air does not climb a slope by leaning against it
        if ((wanted - sideways) * dot(t.surfaces[i].normal, m.right) < 0) pull = 0;
    }
    m.state.velocity += (approach(sideways, wanted, pull) - sideways) * m.right + m.def.gravity_scale * m.dt * m.world.gravity();
    m.state.velocity = limited(m.state.velocity, max_speed_limit);
    slide(m, m.dt * m.state.velocity);
    land(m);
}

/// Pushes dynamic bodies out of the mover's way, and puts its weight on the one it stands on.
void press(Mover& m, float wanted) {
    const float strength = m.def.max_push_force * m.dt;
    const Touched t = touched_by(m);
    for (std::uint32_t i = 0; i < t.count; ++i) {
        const Surface& s = t.surfaces[i];
        const BodyId body = m.world.body(s.shape);
        if (m.world.type(body) != BodyType::dynamic || body == m.state.ground || dot(s.normal, m.up) >= m.least_up) continue;
        const float closing = dot(m.world.linear_velocity(body) - wanted * m.right, s.normal);
        const float body_mass = m.world.mass(body);
        const float together = body_mass * (m.def.mass / (body_mass + m.def.mass));  // reduced mass
        if (!(closing > 0) || !(dot(wanted * m.right, s.normal) < 0) || !(together > 0)) continue;
        m.world.apply_linear_impulse_to_center(body, -min(together * closing, strength) * s.normal);
    }
    if (!m.state.ground) return;
    const float weight = weight_on_ground(m);
    if (weight > 0) m.world.apply_force(m.state.ground, -weight * m.up, m.support() - m.def.capsule.radius * m.up);
}

bool check_mover(const Core& core, const MoverDef& d, const MoverState& s, const MoverInput& in, float dt) {
    const Vec2 v = s.velocity;
    return check_open(core) && check(core, is_time_step(dt), Error::bad_time_step) && check(core, islet::is_valid(d.capsule), Error::bad_geometry) &&
           check_finite(core, d.up) && check(core, abs(length(d.up) - 1) <= 1e-3f, Error::out_of_range) &&
           check_range(core, d.gravity_scale, -max_coefficient, max_coefficient) && check_range(core, d.max_slope, 0, 1.5f) &&
           check_range(core, d.step_height, 0, max_position) && check_range(core, d.snap_distance, 0, max_position) &&
           check_range(core, d.ground_acceleration, 0, no_limit) && check_range(core, d.air_acceleration, 0, no_limit) &&
           check_range(core, d.mass, 0, no_limit) && check_range(core, d.max_push_force, 0, no_limit) && check_position(core, s.position) &&
           check_position(core, s.position + d.capsule.point1) && check_position(core, s.position + d.capsule.point2) &&
           check_range(core, v.x, -max_speed_limit, max_speed_limit) && check_range(core, v.y, -max_speed_limit, max_speed_limit) &&
           check_range(core, in.walk, -max_speed_limit, max_speed_limit) && check_range(core, in.jump, 0, max_speed_limit) &&
           check_finite(core, s.ground_normal) && check_position(core, s.ground_point);
}

}  // namespace

bool step_mover(World& world, const MoverDef& def, MoverState& state, const MoverInput& input, float dt) {
    if constexpr (!has_mover) {
        Core::of(world).fail(Error::feature_cut);
        return false;
    }
    if (!check_mover(Core::of(world), def, state, input, dt)) return false;
    const DefaultFloatMode mode;
    const Vec2 up = normalize(def.up);
    Mover m{world, def, state, up, right_perp(up), make_rot(def.max_slope).c, dt, state.position};
    m.state.squeezed = 0;
    if (m.state.ground && !(abs(length_squared(m.state.ground_normal) - 1) < 1e-3f)) m.state.ground_normal = up;
    if (m.state.ground) ride(m);
    if (m.state.ground && input.jump > 0) {
        leave_ground(m);
        m.state.velocity += input.jump * m.up;
    }
    if (m.state.ground) {
        walk(m, input.walk);
    } else {
        fall(m, input.walk);
    }
    press(m, input.walk);
    m.state.velocity = limited(m.state.velocity, max_speed_limit);
    m.state.position = limited(m.state.position, max_position);
    state = m.state;
    return true;
}

}  // namespace islet
