// Locks of a body: it does not move along x, along y, or does not turn.
#include "../exact.hpp"

#include "../bodies/bounds.hpp"
#include "../bodies/impulses.hpp"
#include "../bodies/sleep.hpp"
#include "../calls/recorder.hpp"

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

bool flag_of(const Core& core, BodyId id, std::uint32_t flag) {
    const std::uint32_t i = find_slot(core, id);
    return i != null_index && (core.bodies[i].flags & flag) != 0;
}

}  // namespace

bool World::is_x_locked(BodyId id) const { return flag_of(core(), id, body_lock_x); }
bool World::is_y_locked(BodyId id) const { return flag_of(core(), id, body_lock_y); }
bool World::is_rotation_fixed(BodyId id) const { return flag_of(core(), id, body_fixed_rotation); }
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
    b.flags = fixed ? b.flags | body_fixed_rotation : b.flags & ~static_cast<std::uint32_t>(body_fixed_rotation);
    if (fixed) c.motions[i].w = 0;
    apply_mass(c, i, {b.mass, b.local_center, b.inertia});
}

}  // namespace islet
