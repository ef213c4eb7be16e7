// Every invariant of a world. For tests: slow and thorough.
#include "broadphase/contacts.hpp"
#include "world/bounds.hpp"
#include "world/faults.hpp"

namespace islet {

using namespace detail;

namespace {

// What an image does not hold, because it follows from the rest.
const char* fault_in_pair_set(const Core& c) {
    const PoolState& pool = c.state->contact_pool;
    std::uint32_t keys = 0;
    for (std::uint32_t i = 0; i <= c.pairs.mask; ++i) keys += c.pairs.keys[i] != 0 ? 1 : 0;
    if (keys != pool.count) return "the pair set does not hold one key per contact";
    for (std::uint32_t i = 0; i < pool.high_water; ++i) {
        const Contact& contact = c.contacts[i];
        if (pool_live(pool, c.contacts, i) && !c.pairs.contains(PairSet::key(contact.shape_a, contact.shape_b)))
            return "a contact is missing from the pair set";
    }
    return nullptr;
}

const char* fault_in_boxes(const Core& c) {
    for (std::uint32_t s = 0; s < c.state->shape_pool.high_water; ++s) {
        if (!pool_live(c.state->shape_pool, c.shapes, s)) continue;
        const Vec2 center = c.poses[c.shapes[s].body].center;
        const float rounding = 1.0e-3f * (1.0f + abs(center.x) + abs(center.y)) * 0.01f + 1.0e-4f;
        if (!contains(expand(c.boxes[s], rounding), shape_aabb(c, s))) return "a shape has left its fat box";
    }
    return nullptr;
}

}  // namespace

const char* World::validate() const {
    const Core& c = core();
    const char* bad = find_fault(c, c.arena());
    if (bad == nullptr) bad = fault_in_pair_set(c);
    return bad != nullptr ? bad : fault_in_boxes(c);
}

}  // namespace islet
