// Finds the slot of an id.
#include "../exact.hpp"

#include "../calls/checks.hpp"

namespace islet::detail {

namespace {

template <class T, class Id>
std::uint32_t find_live(const Core& core, const PoolState& pool, const T* slots, Id id) {
    if (!check(core, id.index1 != 0, Error::null_id)) return null_index;
    const std::uint32_t i = id.index1 - 1;
    return check(core, pool_live(pool, slots, i) && slots[i].generation == id.generation, Error::stale_id) ? i : null_index;
}

}  // namespace

std::uint32_t find_slot(const Core& core, BodyId id) { return find_live(core, core.state->body_pool, core.bodies, id); }
std::uint32_t find_slot(const Core& core, ShapeId id) { return find_live(core, core.state->shape_pool, core.shapes, id); }
std::uint32_t find_slot(const Core& core, JointId id) { return find_live(core, core.state->joint_pool, core.joints, id); }

}  // namespace islet::detail
