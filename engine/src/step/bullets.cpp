// Bullets: bodies whose way in a step is compared with the ways of all moving bodies, and with sleeping ones.
//
// Each body goes evenly from where it was to where it is. A bullet that meets another body on the way stops there, and the other body then carries it along, so
// that the other body does not pass through the bullet either. Whatever ways the bodies take, where they end decides which has passed which. So bullets that
// were stopped are compared again, a few times at most, with static shapes as well.
//
// Of two bullets, the one that goes farther gives way. It does not carry the other bullet along: how far it will come is not known yet, and more rounds would
// be needed to correct what it carries the other over.
#include "../exact.hpp"

#include "../bodies/bounds.hpp"
#include "../broadphase/tree.hpp"
#include "../calls/recorder.hpp"
#include "../math/boxes.hpp"
#include "../math/scalar.hpp"
#include "../step/continuous.hpp"

namespace islet {

using namespace detail;

namespace detail {

namespace {

// Each round may stop a bullet in the way of another one. In the last round bullets ignore each other: passing through a bullet is better than passing through
// a moving wall.
inline constexpr std::uint32_t bullet_rounds = 4;

/// The first impact of a body with other moving or sleeping bodies.
struct WayImpact {
    float fraction = no_impact;
    BodyPath other;
};

void find_impact(const Core& core, std::uint32_t body, const BodyPath& way, std::uint32_t other_shape, const BodyPath& other, WayImpact& first) {
    for (std::uint32_t s = core.bodies[body].shape_head; s != null_index; s = core.shapes[s].next) {
        const float fraction = stop_time(core, s, way, other_shape, other, min(first.fraction, 1.0f));
        if (fraction < first.fraction) first = {fraction, other};
    }
}

bool is_stopped(const Core& core, std::uint32_t body) { return (core.bodies[body].flags & body_bullet) != 0 && core.is_dynamic(body); }

WayImpact first_impact(const Core& core, std::uint32_t body, const BodyPath& way, const PlanIndex* body_of, std::uint32_t slot_count, const SolverBody* bodies,
                       std::uint32_t slot, bool last_round) {
    WayImpact first;
    const Pose& pose = core.poses[body];
    const float far_enough = look_fraction * core.bodies[body].min_extent;
    const Aabb box = box_of_way(way.center, way.way, pose.max_extent);
    const float turned = abs(way.turn) * pose.max_extent;
    const float moved = length(way.way) + turned;
    for (std::uint32_t i = 1; i < slot_count; ++i) {
        const std::uint32_t other = body_of[i];
        const SolverBody& other_way = bodies[i];
        const Pose& other_pose = core.poses[other];
        const Vec2 start = other_pose.center - other_way.dp;
        const Aabb other_box = expand({min(start, other_pose.center), max(start, other_pose.center)}, other_pose.max_extent);
        if (i == slot || !meet(box, other_box)) continue;
        const float other_turned = abs(other_way.dq) * other_pose.max_extent;
        if (length(way.way - other_way.dp) + turned + other_turned <= far_enough) continue;
        if (is_stopped(core, other) && (last_round || length(other_way.dp) + other_turned > moved)) continue;
        const BodyPath path = path_of(core, other, other_way);
        for (std::uint32_t s = core.bodies[other].shape_head; s != null_index; s = core.shapes[s].next) find_impact(core, body, way, s, path, first);
    }
    if (moved <= far_enough) return first;
    tree_query(Tree{&core.state->tree, core.tree}, box, [&](std::uint32_t shape) {
        const std::uint32_t other = core.shapes[shape].body;
        if (core.bodies[other].type() != BodyType::static_body) find_impact(core, body, way, shape, at_rest(core, other), first);
    });
    return first;
}

// From the impact on, the bullet keeps its place on the other body, so that the other body does not pass through it.
BodyPath carried(const BodyPath& way, const WayImpact& impact) {
    const float f = impact.fraction;
    const BodyPath& other = impact.other;
    const Vec2 place = inv_rotate(rotation_at(other, f), center_at(way, f) - center_at(other, f));
    const Vec2 end = center_at(other, 1) + rotate(rotation_at(other, 1), place);
    return {way.center, way.q, end - way.center, f * way.turn + (1 - f) * other.turn};
}

}  // namespace

void stop_bullets(Core& core, const PlanIndex* body_of, std::uint32_t slot_count, SolverBody* bodies) {
    bool again = true;
    for (std::uint32_t round = 0; again && round < bullet_rounds; ++round) {
        again = false;
        for (std::uint32_t slot = 1; slot < slot_count; ++slot) {
            const std::uint32_t body = body_of[slot];
            if (!is_stopped(core, body)) continue;
            const BodyPath way = path_of(core, body, bodies[slot]);
            const WayImpact impact = first_impact(core, body, way, body_of, slot_count, bodies, slot, round + 1 == bullet_rounds);
            if (impact.fraction >= 1) continue;
            place_at_end(core, body, carried(way, impact), bodies[slot]);
            stop_at_static(core, body, bodies[slot]);  // however short its way: what carries it may press it deeper in step by step
            core.bodies[body].origin = core.poses[body].center - rotate(core.poses[body].q, core.bodies[body].local_center);
            update_boxes(core, body, false);
            again = true;
        }
    }
}

}  // namespace detail

bool World::is_bullet(BodyId id) const { ISLET_READ((c.bodies[i].flags & body_bullet) != 0); }

void World::set_bullet(BodyId id, bool bullet) {
    const auto [c, i] = begin_call<Call::set_bullet>(core(), id, bullet);
    if (i == null_index || !check_there(c, has_bullets || !bullet)) return;
    Body& b = c.bodies[i];
    if (((b.flags & body_bullet) != 0) == bullet) return;
    b.flags ^= body_bullet;
    c.state->bullet_count += bullet ? 1u : ~0u;
}

}  // namespace islet
