#include "../exact.hpp"

#include "../step/move_and_sleep.hpp"

#include "../bodies/bounds.hpp"
#include "../bodies/sleep.hpp"
#include "../broadphase/pairs.hpp"
#include "../data/parallel.hpp"
#include "../graph/contacts.hpp"
#include "../graph/joint_graph.hpp"
#include "../math/scalar.hpp"
#include "../step/continuous.hpp"
#include "../step/sleep_islands.hpp"

namespace islet::detail {

namespace {

inline constexpr std::uint32_t finish_grain = 4;  // words of 64 bodies that are worth a task
inline constexpr float unmoved = 1.25e-7f;        // of a position, and of 1 m: what a kinematic body that stands still may move by in a step

// Updates the body's pose and fat boxes after its way. Most bodies cannot have left a fat box, because their slack says how far they may go before they could.
// Threads that call it at once each pass a counter, which goes up by the shapes that were marked as moved.
void move_body(Core& core, std::uint32_t i, SolverBody& way, float dt, std::uint32_t* marked) {
    Pose& pose = core.poses[i];
    Motion& motion = core.motions[i];
    Body& body = core.bodies[i];
    const auto farthest = [&] { return length_inline(way.dp) + abs(way.dq) * pose.max_extent; };  // m, of any of its points
    float moved = farthest();
    if (is_continuous(core) && (moved > look_fraction * body.min_extent || (pose.flags & pose_deep) != 0)) {
        const bool alone = has_shortcuts && (pose.flags & pose_alone) != 0 && moved <= surroundings(pose);
        if (!alone) {
            stop_at_static(core, i, way);
            moved = max(moved, farthest());  // it may have been let out of something
        }
    }
    pose.flags &= ~static_cast<std::uint32_t>(pose_alone | pose_leaves | pose_far | pose_deep | pose_learns);
    body.origin = pose.center - rotate(pose.q, body.local_center);

    motion.slack -= moved;
    if (motion.slack < 0) fit_boxes(core, i, false, marked);

    // The way counts for sleep too, so bodies that are being pushed apart stay awake. A kinematic body rests while it does not move at all.
    const float speed = max(speed_of(core, i), 0.5f * moved / dt);
    const bool still = core.is_dynamic(i) || moved <= unmoved * (1 + abs(pose.center.x) + abs(pose.center.y));
    const bool resting = speed <= body.sleep_threshold && still && (body.flags & body_may_sleep) != 0;
    motion.sleep_time = resting ? motion.sleep_time + dt : 0;
}

// Moves all bodies; by one thread if workers cannot mark shapes at once. `rested` gets, by slot, how long each body has been at rest, s.
void move_bodies(Core& core, const Plan& plan, SolverBody* bodies, float* rested, float dt) {
    const auto words = static_cast<std::uint32_t>(words_for(plan.slot_count));
    const bool shares = ISLET_SHARES_WORDS != 0 && has_workers(core);
    for_ranges(core, words, shares ? fine_grain(core, finish_grain) : words, [&](std::uint32_t first, std::uint32_t end) {
        std::uint32_t marked = 0;
        const std::uint32_t end_slot = 64 * end < plan.slot_count ? 64 * end : plan.slot_count;
        for (std::uint32_t slot = first == 0 ? 1 : 64 * first; slot < end_slot; ++slot) {
            const std::uint32_t body = plan.body_of[slot];
            move_body(core, body, bodies[slot], dt, shares ? &marked : nullptr);
            rested[slot] = core.motions[body].sleep_time;
        }
        add_marked(core, marked);
    });
}

// Reports the bodies that moved, in the order of their slots in the pool.
void report_moved(Core& core, Arena arena) {
    const BitSet awake = core.awake_bodies;
    core.moved_count = 0;
    if (!has_workers(core)) {
        awake.for_each([&](std::uint32_t body) { core.moved_events[core.moved_count++] = core.body_id(body); });
        return;
    }
    const std::uint32_t ranges = range_count(awake.word_count, finish_grain);
    std::uint32_t* place = arena.take<std::uint32_t>(ranges);  // of a range's first event
    for (std::uint32_t i = 0; i < ranges; ++i) {
        place[i] = core.moved_count;
        const std::uint32_t end = (i + 1) * finish_grain < awake.word_count ? (i + 1) * finish_grain : awake.word_count;
        core.moved_count += awake.count_in(i * finish_grain, end);
    }
    for_ranges(core, awake.word_count, finish_grain, [&](std::uint32_t first, std::uint32_t end) {
        std::uint32_t at = place[first / finish_grain];
        awake.for_each_in(first, end, [&](std::uint32_t body) { core.moved_events[at++] = core.body_id(body); });
    });
}

}  // namespace

void finish_bodies(Core& core, const Plan& plan, SolverBody* bodies, Arena& arena, float dt) {
    float* rested = arena.take<float>(plan.slot_count);
    move_bodies(core, plan, bodies, rested, dt);
    if (has_bullets && is_continuous(core) && core.state->bullet_count != 0) stop_bullets(core, plan.body_of, plan.slot_count, bodies);
    report_moved(core, arena);
    if (!has_sleep || core.state->enable_sleep == 0 || !sleep_islands(core, plan, rested, arena, dt)) return;
    // Bodies that fell asleep are reported in the order of their slots, too.
    for (std::uint32_t i = 0; i < core.moved_count; ++i) {
        const BodyId id = core.moved_events[i];
        if (!core.is_awake(id.index1 - 1)) core.slept_events[core.slept_count++] = id;
    }
}

}  // namespace islet::detail
