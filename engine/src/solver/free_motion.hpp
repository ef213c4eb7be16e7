// What a body does over a substep when nothing touches it: gravity, forces, damping and the limits of speed.
#pragma once

#include "../constraint/solver_body.hpp"
#include "../data/core.hpp"
#include "../math/inlining.hpp"
#include "../math/scalar.hpp"

namespace islet::detail {

/// The inverse inertia of a body that its joints stretch.
///
/// A body pulled at both ends swings back about its centre like a string, with the geometric stiffness S = sum of r . f over its joints. Where the substep is
/// too long for that swing, h^2 S > I, the body gets the inertia that keeps it stable (from the implicit treatment in Tournier and others, "Stable Constrained
/// Dynamics", 2015). Elsewhere nothing changes. `stretch` is h^2 S of the last step, within bounds (most_stretch
/// in joint_runs.hpp).
inline float stiffened(float inv_inertia, float stretch) { return stretch * inv_inertia > 1.0f ? 1.0f / stretch : inv_inertia; }

/// Fills in what a substep of length h adds to the body's velocity, and the damping.
inline void gather_motion(SolverMotion& m, const Core& core, std::uint32_t body, float h) {
    const Pose& pose = core.poses[body];
    const Motion& motion = core.motions[body];
    const Body& b = core.bodies[body];
    m = SolverMotion{};
    if (is_positive(pose.inv_mass)) {
        m.a = h * (b.gravity_scale * core.state->gravity + pose.inv_mass * motion.force);
        m.alpha = h * (pose.inv_inertia * motion.torque);
        m.linear_factor = 1.0f / (1.0f + h * b.linear_damping);
        m.angular_factor = 1.0f / (1.0f + h * b.angular_damping);
    }
}

/// a, but at most `bound` on either side, and 0 if it is not a number.
ISLET_SHARED float within(float a, float bound) { return a == a ? within_bounds(a, bound) : 0; }

inline constexpr float slow_share = 0.9f;  // of a squared speed limit: what is below it needs no root to be known as slower

/// v, but no longer than max_speed. Velocities may have overflowed: infinity counts as a very large number, and NaN as zero.
inline Vec2 limit_speed(Vec2 v, float max_speed) {
    constexpr float huge = 1.0e18f;  // its square is still a number
    v = {within(v.x, huge), within(v.y, huge)};
#if !defined(__OPTIMIZE_SIZE__)
    if (dot(v, v) < slow_share * max_speed * max_speed) return {v.x + 0.0f, v.y + 0.0f};  // slow enough, without a root
#endif
    const float speed = length(v);
    if (speed > max_speed) v = (max_speed / speed) * v;
    return {v.x + 0.0f, v.y + 0.0f};  // a product that underflows may be -0, which the 0 that an idle lane adds would turn into +0
}

/// The velocities after the substep, before warm start and sweeps.
inline Vec2 free_velocity(const SolverMotion& m, Vec2 v, float max_speed) {
    v = m.linear_factor * (v + m.a);
    if (!(dot(v, v) <= max_speed * max_speed)) v = limit_speed(v, max_speed);
    return {v.x + 0.0f, v.y + 0.0f};
}
inline float free_turn(const SolverMotion& m, float w, float max_turn) { return within(m.angular_factor * (w + m.alpha), max_turn) + 0.0f; }

/// The fastest a body may turn in a step of dt seconds, rad/s: separations follow the turning to first order.
inline float max_turn_of(float dt) { return 0.5f * pi / dt; }

}  // namespace islet::detail
