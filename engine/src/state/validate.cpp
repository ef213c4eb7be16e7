// World::validate: checks every invariant of a world. Slow; for tests.
#include "../exact.hpp"

#include "../calls/checks.hpp"
#include "../state/faults.hpp"

namespace islet {

using namespace detail;

namespace {

// Checks the arrays that images do not hold, because they follow from the others.
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

}  // namespace

const char* World::validate() const {
    const Core& c = core();
    if (!check_open(c)) return "the world is in the middle of a call";
    const char* bad = find_fault(c, c.arena());
    return bad != nullptr ? bad : fault_in_pair_set(c);
}

}  // namespace islet
