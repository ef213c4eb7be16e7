// The contact update in lanes: it does what most contacts need, and leaves the others to be looked at one by one.
#pragma once

#include "../data/core.hpp"
#include "../data/parallel.hpp"
#include "../graph/contact_lanes.hpp"
#include "../graph/contact_parts.hpp"

namespace islet::detail {

/// Contacts that lanes may update, and those of which they do all that there is to do.
struct LaneShare {
    std::uint32_t all = 0, done = 0;

    void add(LaneShare other) {
        all += other.all;
        done += other.done;
    }
    /// True if lanes do enough of them to be worth it.
    bool pays() const { return 3 * done > all; }
};

/// By whether contacts have points or none. A build for one lane, which may be small, counts nothing.
template <bool is_there = (max_lanes > 1)>
struct LaneShares {
    LaneShare touching, apart;

    void add(const LaneShares& other) {
        touching.add(other.touching);
        apart.add(other.apart);
    }
};
template <>
struct LaneShares<false> {
    static inline LaneShare touching, apart;

    void add(const LaneShares&) {}
};

/// What an update counts.
struct UpdateCount : LaneShares<> {
    std::uint32_t kept = 0;  // contacts that kept their manifolds
};

/// What lanes ask of the world's contacts in this step. `fall`: see fall_in (broadphase/pairs.hpp).
ContactsInLanes contacts_in_lanes(const Core& core, LoadRate rate, float dt, float fall);

/// Sets of contacts that an update makes.
struct UpdateSets {
    BitSet changed;  // whose change concerns others
    BitSet parted;   // whose boxes meet no more

    void part(const ContactManifold* manifolds, std::uint32_t contact) {
        parted.set(contact);
        if (!has_threads || is_known(manifolds[contact])) changed.set(contact);
    }
};

/// Updates those awake contacts in the words first <= w < end of which lanes know all that there is to do, counts them, and sets these words of `open` to the
/// others. What lanes do not pay for (Core::kept) is among these. It touches nothing else but these words of the sets, so ranges may be updated in parallel.
void update_in_lanes(Core& core, const ContactsInLanes& in, std::uint32_t first, std::uint32_t end, BitSet open, UpdateSets sets, UpdateCount& count);

}  // namespace islet::detail
