// Targets of kinematic bodies: the velocities that take a body to a pose in one step.
#include "../exact.hpp"

#include "../calls/recorder.hpp"
#include "../math/float_mode.hpp"
#include "../solver/free_motion.hpp"

namespace islet {

using namespace detail;

namespace {

// The turn with which integrate() leads from the identity to q. Its series are not exact, so the result for the angle is corrected twice.
float turn_to(Rot q, float most) {
    const float angle = clamp(angle_of(q), -most, most);
    const Rot goal = make_rot(angle);
    float turn = angle;
    for (int i = 0; i < 2; ++i) turn = clamp(turn + angle_of(inv_mul(integrate(Rot{}, turn), goal)), -most, most);
    return turn;
}

}  // namespace

void World::set_target(BodyId id, const Transform& target, float dt) {
    const DefaultFloatMode mode;
    const auto [c, i] = begin_call<Call::set_body_target>(core(), id, target, dt);
    if (i == null_index || !check_pose(c, target)) return;
    if (!check(c, is_time_step(dt), Error::bad_time_step) || c.bodies[i].type() != BodyType::kinematic) return;
    const Pose& pose = c.poses[i];
    const Vec2 way = transform_point(target, c.bodies[i].local_center) - pose.center;
    const float turn = turn_to(inv_mul(pose.q, normalize(target.q)), max_turn_of(dt) * dt);
    const float inv_dt = 1.0f / dt;
    set_linear_velocity(id, limit_speed(inv_dt * way, c.state->max_speed));
    set_angular_velocity(id, inv_dt * turn);
}

}  // namespace islet
