// Disabling and enabling a body, with its shapes and joints. A disabled body is neither awake nor in the tree of resting shapes, so no stage of a step and no
// query meets it.
#include "../exact.hpp"

#include "../bodies/bounds.hpp"
#include "../bodies/impulses.hpp"
#include "../bodies/sleep.hpp"
#include "../calls/recorder.hpp"
#include "../graph/joint_graph.hpp"

namespace islet {

using namespace detail;

namespace {

void disable(Core& core, std::uint32_t i) {
    wake_island(core, i, core.arena());
    end_contacts(core, i);
    unrest_shapes(core, i);
    core.awake_bodies.clear(i);
    core.bodies[i].flags |= body_disabled;
    core.motions[i].force = {0, 0};
    core.motions[i].torque = 0;
    core.poses[i].flags = 0;
}

void enable(Core& core, std::uint32_t i) {
    core.bodies[i].flags &= ~static_cast<std::uint32_t>(body_disabled);
    core.motions[i].sleep_time = 0;
    update_boxes(core, i, true);
    if (core.bodies[i].type() == BodyType::static_body) {
        rest_shapes(core, i);
    } else {
        core.awake_bodies.set(i);
    }
    wake_neighbors(core, i, core.arena());
}

}  // namespace

bool World::is_enabled(BodyId id) const { ISLET_READ(detail::is_enabled(c, i)); }

void World::set_enabled(BodyId id, bool enabled) {
    const auto [c, i] = begin_call<Call::set_enabled>(core(), id, enabled);
    if (i == null_index || detail::is_enabled(c, i) == enabled || !check_there(c, has_disabling)) return;
    if (enabled) {
        enable(c, i);
    } else {
        disable(c, i);
    }
    if (c.state->joint_pool.count != 0) refresh_awake_joints(c);
}

}  // namespace islet
