// Finds the slot of an id.
#include "../exact.hpp"

#include "../calls/checks.hpp"

namespace islet::detail {

namespace {

template <class T, class Id>
std::uint32_t find_live(const Core& core, const PoolState& pool, const T* slots, Id id) {
    return check(core, id.index1 != 0, Error::null_id) && check(core, pool_holds(pool, slots, id), Error::stale_id) ? id.index1 - 1 : null_index;
}

}  // namespace

std::uint32_t find_slot(const Core& core, BodyId id) { return find_live(core, core.state->body_pool, core.bodies, id); }
std::uint32_t find_slot(const Core& core, ShapeId id) { return find_live(core, core.state->shape_pool, core.shapes, id); }
std::uint32_t find_slot(const Core& core, JointId id) { return find_live(core, core.state->joint_pool, core.joints, id); }

}  // namespace islet::detail
