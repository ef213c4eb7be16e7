// Finds the slot of an id.
#include "../exact.hpp"

#include "../calls/checks.hpp"

namespace islet::detail {

std::uint32_t find_body(const Core& core, BodyId id) {
    if (!check(core, id.index1 != 0, Error::null_id)) return null_index;
    const std::uint32_t i = id.index1 - 1;
    const bool live = pool_live(core.state->body_pool, core.bodies, i) && core.bodies[i].generation == id.generation;
    return check(core, live, Error::stale_id) ? i : null_index;
}

std::uint32_t find_shape(const Core& core, ShapeId id) {
    if (!check(core, id.index1 != 0, Error::null_id)) return null_index;
    const std::uint32_t i = id.index1 - 1;
    const bool live = pool_live(core.state->shape_pool, core.shapes, i) && core.shapes[i].generation == id.generation;
    return check(core, live, Error::stale_id) ? i : null_index;
}

std::uint32_t find_joint(const Core& core, JointId id) {
    if (!check(core, id.index1 != 0, Error::null_id)) return null_index;
    const std::uint32_t i = id.index1 - 1;
    const bool live = pool_live(core.state->joint_pool, core.joints, i) && core.joints[i].generation == id.generation;
    return check(core, live, Error::stale_id) ? i : null_index;
}

}  // namespace islet::detail
