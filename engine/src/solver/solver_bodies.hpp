// The bodies of a solve: read from the world, moved over a substep, written back. Each function is for the slots from first_slot to before end_slot.
#pragma once

#include "../math/inlining.hpp"
#include "../math/scalar.hpp"
#include "../solver/body_vectors.hpp"
#include "../solver/free_motion.hpp"
#include "../solver/solve_context.hpp"

namespace islet::detail {

/// Calls one(slot) for each slot, except where `many` (body_vectors.hpp) has done it.
template <class Many, class One>
ISLET_PART void over_slots(std::uint32_t slot, std::uint32_t end_slot, [[maybe_unused]] Many&& many, One&& one) {
    for (; slot < end_slot; ++slot) {
#if ISLET_BODY_VECTORS
        slot = many(slot);
        if (slot == end_slot) return;
#endif
        one(slot);
    }
}

/// Reads the velocity and the masses of a body, and what a substep adds to the velocity.
ISLET_PART void read_body(Solve& s, std::uint32_t slot) {
    Core& core = s.core;
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
    gather_motion(s.motions[slot], core, i, s.numbers.step.h);
    core.bodies[i].stretch = 0;  // the joints' forces of this step give the next step's
}

#if ISLET_BODY_VECTORS
/// Whether a block of lanes has work to do.
inline bool fills_lanes(const Solve& s, std::uint32_t slot, std::uint32_t end_slot) { return end_slot - slot >= (s.core.lanes < 8 ? 4u : 8u); }
#endif

ISLET_PART void gather_bodies(Solve& s, std::uint32_t first_slot, std::uint32_t end_slot) {
    const auto many = [&](std::uint32_t slot) ISLET_INLINED_LAMBDA {
#if ISLET_BODY_VECTORS
        if (!fills_lanes(s, slot, end_slot) || s.plan.lightness != nullptr) return slot;
        Core& core = s.core;
        const BodyInput in{s.bodies, s.motions, s.plan.body_of, core.poses, core.motions, core.bodies, core.state->gravity, s.numbers.step.h};
        return ISLET_MAX_LANES >= 8 && core.lanes >= 8 ? read_bodies_8(in, slot, end_slot) : read_bodies<Lane4>(in, slot, end_slot);
#else
        return slot;
#endif
    };
    over_slots(first_slot, end_slot, many, [&](std::uint32_t slot) ISLET_INLINED_LAMBDA { read_body(s, slot); });
}

/// v <- factor (v + a) + warm start. `first`: in the first substep.
///
/// Within a step anchors and normals do not change. So the warm start of a later substep, M^-1 J^T lambda summed over a body's rows, is what the sweeps of the
/// substep before added to the body's velocity, v - v_free: one addition a body instead of a pass over all rows.
ISLET_PART void integrate_velocity(SolverBody& b, SolverMotion& m, float max_speed, float max_turn, bool first) {
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
ISLET_PART void integrate_position(SolverBody& b, float h, float max_speed, float max_turn) {
    if (!(dot(b.v, b.v) <= max_speed * max_speed)) b.v = limit_speed(b.v, max_speed);
    b.w = within(b.w, max_turn);
    b.dp += h * b.v;
    b.dq += h * b.w;
}

ISLET_PART void integrate_velocities(Solve& s, std::uint32_t first_slot, std::uint32_t end_slot, bool first) {
    const float max_speed = s.numbers.step.max_speed, max_turn = s.numbers.step.max_turn;
    const auto many = [&](std::uint32_t slot) ISLET_INLINED_LAMBDA {
        [[maybe_unused]] const VelocityVectors all{s.bodies, s.motions, 0.7f * max_speed, max_turn, first};
#if ISLET_BODY_VECTORS
        return ISLET_MAX_LANES >= 8 && s.core.lanes >= 8 ? integrate_velocities_8(all, slot, end_slot) : integrate_vectors<OneBody>(all, slot, end_slot);
#else
        return slot;
#endif
    };
    over_slots(first_slot, end_slot, many,
               [&](std::uint32_t slot) ISLET_INLINED_LAMBDA { integrate_velocity(s.bodies[slot], s.motions[slot], max_speed, max_turn, first); });
}

ISLET_PART void integrate_positions(Solve& s, std::uint32_t first_slot, std::uint32_t end_slot) {
    const float h = s.numbers.step.h, max_speed = s.numbers.step.max_speed, max_turn = s.numbers.step.max_turn;
    const auto many = [&](std::uint32_t slot) ISLET_INLINED_LAMBDA {
        [[maybe_unused]] const WayVectors all{s.bodies, 0.7f * max_speed, max_turn, h};
#if ISLET_BODY_VECTORS
        return ISLET_MAX_LANES >= 8 && s.core.lanes >= 8 ? integrate_positions_8(all, slot, end_slot) : integrate_vectors<OneBody>(all, slot, end_slot);
#else
        return slot;
#endif
    };
    over_slots(first_slot, end_slot, many, [&](std::uint32_t slot) ISLET_INLINED_LAMBDA { integrate_position(s.bodies[slot], h, max_speed, max_turn); });
}

/// A lock is a row like any other, v . axis = 0, solved last in each sweep. (Later warm starts hold its impulses of the substeps before.)
ISLET_PART void hold_locked(Solve& s, std::uint32_t first_slot, std::uint32_t end_slot) {
    for (std::uint32_t slot = first_slot; slot < end_slot; ++slot) {
        const Body& body = s.core.bodies[s.plan.body_of[slot]];
        if (body.type() != BodyType::dynamic) continue;
        if ((body.flags & body_lock_x) != 0) s.bodies[slot].v.x = 0;
        if ((body.flags & body_lock_y) != 0) s.bodies[slot].v.y = 0;
    }
}

/// Writes the velocity and the pose of a body to the world, and clears its forces.
ISLET_PART void write_body(Solve& s, std::uint32_t slot) {
    const std::uint32_t i = s.plan.body_of[slot];
    SolverBody& b = s.bodies[slot];
    b.dq = within_bounds(b.dq, 0.5f * pi);
    Pose& pose = s.core.poses[i];
    Motion& motion = s.core.motions[i];
    motion.v = limit_speed(b.v, s.numbers.step.max_speed);
    motion.w = within(b.w, s.numbers.step.max_turn);
    motion.force = {0, 0};
    motion.torque = 0;
    pose.center = max(min(pose.center + b.dp, Vec2{max_position, max_position}), Vec2{-max_position, -max_position});
    if (b.dq != 0) pose.q = integrate(pose.q, b.dq);
}

ISLET_PART void scatter_bodies(Solve& s, std::uint32_t first_slot, std::uint32_t end_slot) {
    const auto many = [&](std::uint32_t slot) ISLET_INLINED_LAMBDA {
        const float max_speed = s.numbers.step.max_speed;
        [[maybe_unused]] const BodyOutput out{
            s.bodies, s.plan.body_of, s.core.poses, s.core.motions, slow_share * max_speed * max_speed, s.numbers.step.max_turn};
#if ISLET_BODY_VECTORS
        if (!fills_lanes(s, slot, end_slot)) return slot;
        return ISLET_MAX_LANES >= 8 && s.core.lanes >= 8 ? write_bodies_8(out, slot, end_slot) : write_bodies<Lane4>(out, slot, end_slot);
#else
        return slot;
#endif
    };
    over_slots(first_slot, end_slot, many, [&](std::uint32_t slot) ISLET_INLINED_LAMBDA { write_body(s, slot); });
}

}  // namespace islet::detail
