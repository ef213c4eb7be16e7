// The bodies of a solve: read from the world, moved over a substep, written back. Each function is for the slots from first_slot to before end_slot.
#pragma once

#include "../math/inlining.hpp"
#include "../math/lanes.hpp"
#include "../math/scalar.hpp"
#include "../solver/free_motion.hpp"
#include "../solver/solve_context.hpp"

namespace islet::detail {

/// Reads velocities and masses, and what a substep adds to the velocities.
ISLET_PART void gather_bodies(Solve& s, std::uint32_t first_slot, std::uint32_t end_slot) {
    Core& core = s.core;
    const float h = s.numbers.step.h;
    for (std::uint32_t slot = first_slot; slot < end_slot; ++slot) {
        const std::uint32_t i = s.plan.body_of[slot];
        const Pose& pose = core.poses[i];
        const Motion& motion = core.motions[i];
        SolverBody& b = s.bodies[slot];
        // Adding +0 turns -0 into +0. After that no sum in the solve is ever -0, so a lane that adds nothing changes no bit.
        b.v = {motion.v.x + 0.0f, motion.v.y + 0.0f};
        b.w = motion.w + 0.0f;
        b.inv_mass = pose.inv_mass;
        b.warm_v = {0, 0};
        b.warm_w = 0;
        const float lightness = has_tuning && s.plan.lightness != nullptr ? s.plan.lightness[i] : 1.0f;
        b.inv_mass *= lightness;
        b.inv_inertia = stiffened(lightness * pose.inv_inertia, core.bodies[i].stretch);
        gather_motion(s.motions[slot], core, i, h);
        core.bodies[i].stretch = 0;  // the joints' forces of this step give the next step's
    }
}

/// v <- factor (v + a) + warm start. `first`: in the first substep.
///
/// Within a step anchors and normals do not change. So the warm start of a later substep, M^-1 J^T lambda summed over a body's rows, is what the sweeps of the
/// substep before added to the body's velocity, v - v_free: one addition a body instead of a pass over all rows.
ISLET_SHARED void integrate_velocity(SolverBody& b, SolverMotion& m, float max_speed, float max_turn, bool first) {
    Vec2 dv = b.v - m.v_free;
    float dw = b.w - m.w_free;
    if (first) {
        dv = b.warm_v;
        dw = b.warm_w;
        b.dp = {0, 0};
        b.dq = 0;
    }
    const Vec2 v = free_velocity(m, b.v, max_speed);
    const float w = free_turn(m, b.w, max_turn);
    m.v_free = v;
    m.w_free = w;
    b.v = v + dv;
    b.w = w + dw;
}

/// Adds up how far the velocities move a body in a substep.
ISLET_SHARED void integrate_position(SolverBody& b, float h, float max_speed, float max_turn) {
    if (!(dot(b.v, b.v) <= max_speed * max_speed)) b.v = limit_speed(b.v, max_speed);
    b.w = within(b.w, max_turn);
    b.dp += h * b.v;
    b.dq += h * b.w;
}

#if ISLET_MAX_LANES >= 4 && !ISLET_FOR_MSVC

/// A velocity as one vector: x, y and the turn; the fourth lane is another number of the same record.
struct SpeedLimits {
    f4 most;
    SpeedLimits(float max_speed, float max_turn) : most{0.7f * max_speed, 0.7f * max_speed, max_turn, 0} {}

    /// True only if nothing limits the velocity.
    ISLET_LANE bool allow(f4 v) const { return (mask_bits(Lane4::abs(v) <= most) & 7u) == 7u; }
};
inline constexpr i4 velocity_lanes = {-1, -1, -1, 0};

ISLET_PART void integrate_velocities(Solve& s, std::uint32_t first_slot, std::uint32_t end_slot, bool first) {
    const float max_speed = s.numbers.step.max_speed, max_turn = s.numbers.step.max_turn;
    const SpeedLimits limits(max_speed, max_turn);
    for (std::uint32_t slot = first_slot; slot < end_slot; ++slot) {
        auto* const body = reinterpret_cast<float*>(s.bodies + slot);
        auto* const motion = reinterpret_cast<float*>(s.motions + slot);
        const f4 v = load4(body), way = load4(body + 4), v_free = load4(motion), a = load4(motion + 4);
        const f4 free = __builtin_shufflevector(a, v_free, 3, 3, 7, 7) * (v + a);
        if (!limits.allow(free)) {
            integrate_velocity(s.bodies[slot], s.motions[slot], max_speed, max_turn, first);
            continue;
        }
        const f4 now = free + f4{};
        store4(motion, select(velocity_lanes, now, v_free));
        store4(body, select(velocity_lanes, now + (first ? way : v - v_free), v));
        if (first) store4(body + 4, select(velocity_lanes, f4{}, way));
    }
}

ISLET_PART void integrate_positions(Solve& s, std::uint32_t first_slot, std::uint32_t end_slot) {
    const float h = s.numbers.step.h, max_speed = s.numbers.step.max_speed, max_turn = s.numbers.step.max_turn;
    const SpeedLimits limits(max_speed, max_turn);
    for (std::uint32_t slot = first_slot; slot < end_slot; ++slot) {
        auto* const body = reinterpret_cast<float*>(s.bodies + slot);
        const f4 v = load4(body), way = load4(body + 4);
        if (!limits.allow(v)) {
            integrate_position(s.bodies[slot], h, max_speed, max_turn);
            continue;
        }
        store4(body + 4, select(velocity_lanes, way + Lane4::splat(h) * v, way));
    }
}

#else

ISLET_PART void integrate_velocities(Solve& s, std::uint32_t first_slot, std::uint32_t end_slot, bool first) {
    const float max_speed = s.numbers.step.max_speed, max_turn = s.numbers.step.max_turn;
    for (std::uint32_t slot = first_slot; slot < end_slot; ++slot) integrate_velocity(s.bodies[slot], s.motions[slot], max_speed, max_turn, first);
}

ISLET_PART void integrate_positions(Solve& s, std::uint32_t first_slot, std::uint32_t end_slot) {
    const float h = s.numbers.step.h, max_speed = s.numbers.step.max_speed, max_turn = s.numbers.step.max_turn;
    for (std::uint32_t slot = first_slot; slot < end_slot; ++slot) integrate_position(s.bodies[slot], h, max_speed, max_turn);
}

#endif

/// A lock is a row like any other, v . axis = 0, solved last in each sweep. (Later warm starts hold its impulses of the substeps before.)
ISLET_PART void hold_locked(Solve& s, std::uint32_t first_slot, std::uint32_t end_slot) {
    for (std::uint32_t slot = first_slot; slot < end_slot; ++slot) {
        const Body& body = s.core.bodies[s.plan.body_of[slot]];
        if (body.type() != BodyType::dynamic) continue;
        if ((body.flags & body_lock_x) != 0) s.bodies[slot].v.x = 0;
        if ((body.flags & body_lock_y) != 0) s.bodies[slot].v.y = 0;
    }
}

/// Writes velocities and poses to the world, and clears the forces.
ISLET_PART void scatter_bodies(Solve& s, std::uint32_t first_slot, std::uint32_t end_slot) {
    const float max_turn = 0.5f * pi;
    for (std::uint32_t slot = first_slot; slot < end_slot; ++slot) {
        const std::uint32_t i = s.plan.body_of[slot];
        SolverBody& b = s.bodies[slot];
        b.dq = within_bounds(b.dq, max_turn);
        Pose& pose = s.core.poses[i];
        Motion& motion = s.core.motions[i];
        motion.v = limit_speed(b.v, s.numbers.step.max_speed);
        motion.w = within(b.w, s.numbers.step.max_turn);
        motion.force = {0, 0};
        motion.torque = 0;
        pose.center = max(min(pose.center + b.dp, Vec2{max_position, max_position}), Vec2{-max_position, -max_position});
        if (b.dq != 0) pose.q = integrate(pose.q, b.dq);
    }
}

}  // namespace islet::detail
