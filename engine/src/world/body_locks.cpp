// Leading bodies: targets of kinematic ones, motion locks, sleep thresholds.
#include "../exact.hpp"

#include "../bodies/bounds.hpp"
#include "../bodies/impulses.hpp"
#include "../bodies/sleep.hpp"
#include "../calls/checks.hpp"
#include "../calls/recorder.hpp"
#include "../math/float_mode.hpp"
#include "../solver/free_motion.hpp"

namespace islet {

using namespace detail;

namespace {

// The turn by which integrate() leads from the identity to q. Its series are a little off, so what it makes of the angle is looked at, twice.
float turn_to(Rot q, float most) {
    const float angle = clamp(angle_of(q), -most, most);
    const Rot goal = make_rot(angle);
    float turn = angle;
    for (int i = 0; i < 2; ++i) turn = clamp(turn + angle_of(inv_mul(integrate(Rot{}, turn), goal)), -most, most);
    return turn;
}

void set_lock(Core& core, BodyId id, std::uint32_t flag, bool lock) {
    const std::uint32_t i = find_body(core, id);
    if (i == null_index) return;
    Body& b = core.bodies[i];
    if (((b.flags & flag) != 0) == lock) return;
    const bool before = b.has_locks();
    b.flags ^= flag;
    core.state->locked_count += static_cast<std::uint32_t>(b.has_locks()) - static_cast<std::uint32_t>(before);
    if (core.is_dynamic(i)) core.motions[i].v = unlocked(b, core.motions[i].v);
    core.state->trees_stale = 1;
    wake_island(core, i, core.arena());
}

bool flag_of(const Core& core, BodyId id, std::uint32_t flag) {
    const std::uint32_t i = find_body(core, id);
    return i != null_index && (core.bodies[i].flags & flag) != 0;
}

}  // namespace

void World::set_target(BodyId id, const Transform& target, float dt) {
    Core& c = core();
    note_call<Call::set_body_target>(c, id, target, dt);
    const DefaultFloatMode mode;
    const std::uint32_t i = find_body(c, id);
    if (i == null_index || !check_position(c, target.p) || !check(c, all_finite(target.q.c, target.q.s), Error::not_finite)) return;
    if (!check(c, abs(target.q.c * target.q.c + target.q.s * target.q.s - 1.0f) <= 1.0e-3f, Error::out_of_range)) return;
    if (!check(c, is_time_step(dt), Error::bad_time_step) || c.bodies[i].type() != BodyType::kinematic) return;
    const Pose& pose = c.poses[i];
    const Vec2 way = transform_point(target, c.bodies[i].local_center) - pose.center;
    const float turn = turn_to(inv_mul(pose.q, normalize(target.q)), max_turn_of(dt) * dt);
    const float inv_dt = 1.0f / dt;
    set_linear_velocity(id, limit_speed(inv_dt * way, c.state->max_speed));
    set_angular_velocity(id, inv_dt * turn);
}

bool World::is_x_locked(BodyId id) const { return flag_of(core(), id, body_lock_x); }
bool World::is_y_locked(BodyId id) const { return flag_of(core(), id, body_lock_y); }
bool World::is_rotation_fixed(BodyId id) const { return flag_of(core(), id, body_fixed_rotation); }
void World::lock_x(BodyId id, bool lock) {
    note_call<Call::lock_x>(core(), id, lock);
    set_lock(core(), id, body_lock_x, lock);
}
void World::lock_y(BodyId id, bool lock) {
    note_call<Call::lock_y>(core(), id, lock);
    set_lock(core(), id, body_lock_y, lock);
}

float World::sleep_threshold(BodyId id) const {
    const std::uint32_t i = find_body(core(), id);
    return i != null_index ? core().bodies[i].sleep_threshold : 0;
}

void World::set_sleep_threshold(BodyId id, float threshold) {
    Core& c = core();
    note_call<Call::set_sleep_threshold>(c, id, threshold);
    const std::uint32_t i = find_body(c, id);
    if (i != null_index && check_range(c, threshold, 0, no_limit)) c.bodies[i].sleep_threshold = threshold;
}

}  // namespace islet
