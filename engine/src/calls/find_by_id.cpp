// Finds the slot of an id.
#include "../exact.hpp"

#include "../calls/checks.hpp"

namespace islet::detail {

namespace {

template <class Id, class Record>
std::uint32_t find_by_id(const Core& core, const PoolState& pool, const Record* records, Id id) {
    if (!check(core, id.index1 != 0, Error::null_id)) return null_index;
    const std::uint32_t i = id.index1 - 1;
    return check(core, pool_live(pool, records, i) && records[i].generation == id.generation, Error::stale_id) ? i : null_index;
}

}  // namespace

std::uint32_t find_body(const Core& core, BodyId id) { return find_by_id(core, core.state->body_pool, core.bodies, id); }
std::uint32_t find_shape(const Core& core, ShapeId id) { return find_by_id(core, core.state->shape_pool, core.shapes, id); }
std::uint32_t find_joint(const Core& core, JointId id) { return find_by_id(core, core.state->joint_pool, core.joints, id); }

}  // namespace islet::detail
