#include "world/finish.hpp"

#include "broadphase/contacts.hpp"
#include "memory/joint_graph.hpp"
#include "world/bounds.hpp"
#include "world/sleep.hpp"

namespace islet::detail {

namespace {

// Pose and boxes after the way made. The slack says how far the body may go on before a box could be left, so most bodies need no look at their shapes.
void move_body(Core& core, std::uint32_t i, const SolverBody& way, float dt) {
    Pose& pose = core.poses[i];
    Motion& motion = core.motions[i];
    Body& body = core.bodies[i];
    body.origin = pose.center - rotate(pose.q, body.local_center);

    const float moved = length(way.dp) + abs(way.dq) * pose.max_extent;
    motion.slack -= moved;
    if (motion.slack < 0) update_boxes(core, i, false);

    // Sleep watches the way made too, so that bodies that are being pushed apart stay awake.
    const float speed = max(length(motion.v) + abs(motion.w) * pose.max_extent, 0.5f * moved / dt);
    const bool resting = speed <= body.sleep_threshold && (body.flags & body_may_sleep) != 0;
    motion.sleep_time = resting ? motion.sleep_time + dt : 0;
}

void sleep_islands(Core& core, const Plan& plan, Arena& arena) {
    // The shortest rest of any of its bodies decides for an island; touching an awake kinematic body, or being joined to one, keeps it awake.
    float* rest = arena.take<float>(plan.island_count);
    for (std::uint32_t i = 0; i < plan.island_count; ++i) rest[i] = 3.0e38f;
    for (std::uint32_t slot = 1; slot < plan.slot_count; ++slot) {
        const std::uint32_t body = plan.body_of[slot];
        const std::uint32_t island = plan.island_of[slot];
        if (island != null_index) {
            rest[island] = min(rest[island], core.motions[body].sleep_time);
            continue;
        }
        for_each_contact(core, body, [&](std::uint32_t contact, std::uint32_t side) {
            const std::uint32_t other = plan.slot_of[other_body(core, contact, side)];
            if (other != 0 && (core.manifolds[contact].flags & contact_touching) != 0) rest[plan.island_of[other]] = 0;
        });
        for_each_joint(core, body, [&](std::uint32_t joint, std::uint32_t side) {
            const std::uint32_t joined = other_joined(core, joint, side);
            const std::uint32_t other = joined != null_index ? plan.slot_of[joined] : 0;
            if (other != 0 && plan.island_of[other] != null_index) rest[plan.island_of[other]] = 0;
        });
    }
    for (std::uint32_t slot = 1; slot < plan.slot_count; ++slot) {
        const std::uint32_t body = plan.body_of[slot];
        const std::uint32_t island = plan.island_of[slot];
        const float time = island != null_index ? rest[island] : core.motions[body].sleep_time;
        if (time >= time_to_sleep) put_to_sleep(core, body);
    }
}

}  // namespace

void finish_bodies(Core& core, const Plan& plan, const SolverBody* bodies, Arena& arena, float dt) {
    for (std::uint32_t slot = 1; slot < plan.slot_count; ++slot) move_body(core, plan.body_of[slot], bodies[slot], dt);

    // Who moved is reported in slot order of the pool; so is who falls asleep.
    core.awake_bodies.for_each([&](std::uint32_t body) { core.moved_events[core.moved_count++] = core.body_id(body); });
    if (!has_sleep || core.state->enable_sleep == 0) return;
    sleep_islands(core, plan, arena);
    for (std::uint32_t i = 0; i < core.moved_count; ++i) {
        const BodyId id = core.moved_events[i];
        if (!core.is_awake(id.index1 - 1)) core.slept_events[core.slept_count++] = id;
    }
}

}  // namespace islet::detail
