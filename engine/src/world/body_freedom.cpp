// What a body takes part in: its locks (it does not move along x, along y, or does not turn), and disabling it with its shapes and joints. A disabled body is
// neither awake nor in the tree of resting shapes, so no stage of a step and no query meets it.
#include "../exact.hpp"

#include "../bodies/bounds.hpp"
#include "../bodies/impulses.hpp"
#include "../bodies/jam.hpp"
#include "../bodies/sleep.hpp"
#include "../calls/checks.hpp"
#include "../calls/recorder.hpp"
#include "../graph/joint_graph.hpp"

namespace islet {

using namespace detail;

namespace {

void set_lock(Core& core, BodyId id, std::uint32_t flag, bool lock) {
    const std::uint32_t i = find_slot(core, id);
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

void disable(Core& core, std::uint32_t i) {
    wake_island(core, i, core.arena());
    forget_jam(core, i);
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

bool World::is_x_locked(BodyId id) const { ISLET_READ((c.bodies[i].flags & body_lock_x) != 0); }
bool World::is_y_locked(BodyId id) const { ISLET_READ((c.bodies[i].flags & body_lock_y) != 0); }
bool World::is_rotation_fixed(BodyId id) const { ISLET_READ((c.bodies[i].flags & body_fixed_rotation) != 0); }
void World::lock_x(BodyId id, bool lock) {
    note_call<Call::lock_x>(core(), id, lock);
    set_lock(core(), id, body_lock_x, lock);
}
void World::lock_y(BodyId id, bool lock) {
    note_call<Call::lock_y>(core(), id, lock);
    set_lock(core(), id, body_lock_y, lock);
}

void World::set_fixed_rotation(BodyId id, bool fixed) {
    const auto [c, i] = begin_call<Call::set_fixed_rotation>(core(), id, fixed);
    if (i == null_index) return;
    Body& b = c.bodies[i];
    if (((b.flags & body_fixed_rotation) != 0) == fixed) return;
    b.flags = fixed ? b.flags | body_fixed_rotation : b.flags & ~static_cast<std::uint32_t>(body_fixed_rotation);
    if (fixed) c.motions[i].w = 0;
    apply_mass(c, i, {b.mass, b.local_center, b.inertia});
    wake_island(c, i, c.arena());
}

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
