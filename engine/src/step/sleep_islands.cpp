#include "../exact.hpp"

#include "../step/sleep_islands.hpp"

#include "../bodies/joint_changes.hpp"
#include "../bodies/sleep.hpp"
#include "../data/parallel.hpp"
#include "../graph/contacts.hpp"
#include "../graph/joint_graph.hpp"
#include "../graph/mixing.hpp"

namespace islet::detail {

namespace {

inline constexpr std::uint32_t rest_grain = 16;  // words of 64 slots that are worth a task

// Whether a motor moves the joint, however slowly: at half of the speed asked for at least. One that is blocked does not.
bool is_driven(const Core& core, const Joint& j) {
    const JointType type = j.joint_type();
    const bool drives = type == JointType::motor;
    if (j.body_a == null_index || !(drives || (j.flags & joint_motor) != 0)) return false;
    const bool turns = drives || type == JointType::revolute || type == JointType::angle || type == JointType::wheel;
    const float speed = abs(j.motor_speed), shift = drives ? length_inline(j.velocity) : speed;
    const float turning = abs(core.motions[j.body_b].w - core.motions[j.body_a].w);
    return (turns && speed > 0 && turning >= 0.5f * speed) ||
           ((drives || !turns) && shift > 0 && speed_of(core, j.body_a) + speed_of(core, j.body_b) >= 0.5f * shift);
}

// Whether a motor or a belt keeps the body going, which may be slower than what sleeps; or a joint of it is about to break.
bool stays_awake(const Core& core, std::uint32_t body) {
    bool stays = false;
    for_each_joint(core, body, [&](std::uint32_t joint, std::uint32_t) {
        stays = stays || is_driven(core, core.joints[joint]) || (core.awake_joints.test(joint) && breaks(core, core.joints[joint]));
    });
    if (has_surfaces)
        for_each_contact(core, body, [&](std::uint32_t contact, std::uint32_t) {
            if ((core.manifolds[contact].flags & contact_touching) == 0) return;
            const float belt = abs(tangent_speed_of(core, contact));
            stays = stays || (belt > 0 && speed_of(core, body) >= 0.5f * belt);
        });
    return stays;
}

// How long an island has been at rest is at most `to`. Workers may call it at once.
void shorten(const Core& core, float& rest, float to) {
#if ISLET_SHARES_WORDS
    if (has_workers(core)) {
        float now;
        __atomic_load(&rest, &now, __ATOMIC_RELAXED);
        while (to < now && !__atomic_compare_exchange(&rest, &now, &to, false, __ATOMIC_RELAXED, __ATOMIC_RELAXED)) {}
        return;
    }
#else
    static_cast<void>(core);
#endif
    rest = min(rest, to);
}

// A touch of an awake kinematic body, or a joint to one, keeps an island awake.
void keep_awake(const Core& core, const Plan& plan, std::uint32_t kinematic, float* rest) {
    for_each_contact(core, kinematic, [&](std::uint32_t contact, std::uint32_t side) {
        const std::uint32_t other = plan.slot_of[other_body(core, contact, side)];
        if (other != 0 && (core.manifolds[contact].flags & contact_touching) != 0) shorten(core, rest[plan.island_of[other]], 0);
    });
    for_each_joint(core, kinematic, [&](std::uint32_t joint, std::uint32_t side) {
        const std::uint32_t joined = other_joined(core, joint, side);
        const std::uint32_t other = joined != null_index ? plan.slot_of[joined] : 0;
        if (other != 0 && plan.island_of[other] != no_plan_index) shorten(core, rest[plan.island_of[other]], 0);
    });
}

// Calls work(first slot, end) for ranges of slots that workers may take at once.
template <class Work>
void over_slots(const Core& core, const Plan& plan, Work&& work) {
    const auto words = static_cast<std::uint32_t>(words_for(plan.slot_count));
    for_ranges(core, words, ISLET_SHARES_WORDS ? fine_grain(core, rest_grain) : words,
               [&](std::uint32_t first, std::uint32_t end) { work(first == 0 ? 1 : 64 * first, 64 * end < plan.slot_count ? 64 * end : plan.slot_count); });
}

}  // namespace

bool sleep_islands(Core& core, const Plan& plan, const float* rested, Arena arena, float dt) {
    float* const rest = arena.take<float>(plan.island_count);  // by island, s: as long as the body with the shortest rest
    for (std::uint32_t i = 0; i < plan.island_count; ++i) rest[i] = 3.0e38f;
    over_slots(core, plan, [&](std::uint32_t first, std::uint32_t end) {
        for (std::uint32_t slot = first; slot < end; ++slot) {
            const std::uint32_t island = index_of(plan.island_of[slot]);
            if (island != null_index) {
                shorten(core, rest[island], rested[slot]);
            } else {
                keep_awake(core, plan, plan.body_of[slot], rest);
            }
        }
    });

    const auto time_of = [&](std::uint32_t slot) {
        const std::uint32_t island = index_of(plan.island_of[slot]);
        return island != null_index ? rest[island] : rested[slot];
    };
    std::uint32_t tired = 0;  // not 0: a body has been at rest for long enough
    over_slots(core, plan, [&](std::uint32_t first, std::uint32_t end) {
        std::uint32_t tired_here = 0;
        for (std::uint32_t slot = first; slot < end; ++slot) {
            const float time = time_of(slot);
            if (time >= time_to_learn && time < time_to_learn + dt) core.poses[plan.body_of[slot]].flags |= pose_learns;
            if (time >= time_to_sleep) tired_here = 1;
        }
        if (tired_here == 0) return;
#if ISLET_SHARES_WORDS
        __atomic_store_n(&tired, 1u, __ATOMIC_RELAXED);
#else
        tired = 1;
#endif
    });
    if (tired == 0) return false;
    for (std::uint32_t slot = 1; slot < plan.slot_count; ++slot) {
        const std::uint32_t island = index_of(plan.island_of[slot]), body = plan.body_of[slot];
        if (island == null_index || rest[island] < time_to_sleep || !stays_awake(core, body)) continue;
        core.motions[body].sleep_time = 0;
        rest[island] = 0;
    }
    bool any = false;
    for (std::uint32_t slot = 1; slot < plan.slot_count; ++slot) {
        if (time_of(slot) < time_to_sleep) continue;
        put_to_sleep(core, plan.body_of[slot]);
        any = true;
    }
    return any;
}

}  // namespace islet::detail
