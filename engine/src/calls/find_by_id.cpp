// Finds the slot of an id.
#include "../exact.hpp"

#include "../calls/checks.hpp"

namespace islet::detail {

namespace {

template <class T, class Id>
ISLET_ALWAYS_INLINE inline std::uint32_t find_live(const Core& core, PoolState State::*pool, T* Core::*slots, Id id) {
    if (!check(core, id.index1 != 0, Error::null_id)) return null_index;
    const std::uint32_t i = id.index1 - 1;
    const bool live = pool_live(core.state->*pool, core.*slots, i) && (core.*slots)[i].generation == id.generation;
    return check(core, live, Error::stale_id) ? i : null_index;
}

}  // namespace

std::uint32_t find_slot(const Core& core, BodyId id) { return find_live(core, &State::body_pool, &Core::bodies, id); }
std::uint32_t find_slot(const Core& core, ShapeId id) { return find_live(core, &State::shape_pool, &Core::shapes, id); }
std::uint32_t find_slot(const Core& core, JointId id) { return find_live(core, &State::joint_pool, &Core::joints, id); }

}  // namespace islet::detail
