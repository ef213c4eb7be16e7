#include "../exact.hpp"

#include "../step/lane_update.hpp"

#include "../broadphase/pairs.hpp"
#include "../math/scalar.hpp"
#include "../step/clearance.hpp"

namespace islet::detail {

#if ISLET_MAX_LANES > 1

namespace {

// The kernels' functions by their width.
template <std::uint32_t W>
std::uint32_t keep_by(const ContactsInLanes& in, const std::uint32_t* contact) {
    if constexpr (W == 8) return keep_touching_8(in, contact);
    return keep_touching_4(in, contact);
}
template <std::uint32_t W>
void tell_by(const ContactsInLanes& in, const std::uint32_t* contact, ToldApart& out) {
    if constexpr (W == 8) return tell_apart_8(in, contact, out);
    tell_apart_4(in, contact, out);
}

// Contacts of one kind, until there are as many as lanes.
template <std::uint32_t W>
struct Gathered {
    std::uint32_t contact[W];
    std::uint32_t count = 0;

    // Returns whether there are as many now.
    ISLET_INLINE bool add(std::uint32_t index) {
        contact[count++] = index;
        return count == W;
    }
    // Fills the lanes that are left with the first contact. Returns a bit for each lane that counts.
    std::uint32_t fill() {
        for (std::uint32_t i = count; i < W; ++i) contact[i] = contact[0];
        return (1u << count) - 1;
    }
};

template <std::uint32_t W>
void open_those(const Gathered<W>& all, std::uint32_t which, BitSet open) {
    for (; which != 0; which &= which - 1) open.set(all.contact[trailing_zeros(which)]);
}

template <std::uint32_t W>
void keep_those(const ContactsInLanes& in, Gathered<W>& touching, BitSet open, UpdateCount& count) {
    const std::uint32_t counting = touching.fill();
    const std::uint32_t keeps = counting & keep_by<W>(in, touching.contact);
    const std::uint32_t kept = BitSet::bits_of(keeps);
    count.kept += kept;
    count.touching.add({touching.count, kept});
    open_those(touching, counting & ~keeps, open);
    touching.count = 0;
}

template <std::uint32_t W>
void tell_those(Core& core, const ContactsInLanes& in, Gathered<W>& parted, BitSet open, UpdateCount& count) {
    const std::uint32_t counting = parted.fill();
    ToldApart told;
    tell_by<W>(in, parted.contact, told);
    const std::uint32_t keeps = counting & told.kept;
    std::uint32_t apart = counting & told.apart;
    // What comes fast to a link is looked at again where it may touch.
    for (std::uint32_t fast = apart & told.fast; fast != 0; fast &= fast - 1) {
        const std::uint32_t i = trailing_zeros(fast);
        if (is_link(core, core.contacts[parted.contact[i]])) apart &= ~(1u << i);
    }
    for (std::uint32_t left = apart; left != 0; left &= left - 1) {
        const std::uint32_t i = trailing_zeros(left), contact = parted.contact[i];
        ContactManifold& m = core.manifolds[contact];
        core.clearances[contact] = told.clearance[i];
        note_apart(m, core.poses[m.body_a], core.poses[m.body_b]);
    }
    count.kept += BitSet::bits_of(keeps);
    count.apart.add({parted.count, BitSet::bits_of(keeps | apart)});
    open_those(parted, counting & ~(keeps | apart), open);
    parted.count = 0;
}

template <std::uint32_t W>
void update_by(Core& core, const ContactsInLanes& in, std::uint32_t first, std::uint32_t end, BitSet open, UpdateCount& count) {
    const bool keeps = core.kept.keeps_in_lanes, parts = core.kept.parts_in_lanes;
    Gathered<W> touching, parted;
    for (std::uint32_t w = first; w < end; ++w) open.words[w] = 0;
    core.awake_contacts.for_each_in(first, end, [&](std::uint32_t i) ISLET_INLINED_LAMBDA {
        if (core.manifolds[i].count() != 0) {
            if (!keeps) return open.set(i);
            if (touching.add(i)) keep_those(in, touching, open, count);
        } else {
            if (!parts) return open.set(i);
            if (parted.add(i)) tell_those(core, in, parted, open, count);
        }
    });
    if (touching.count != 0) keep_those(in, touching, open, count);
    if (parted.count != 0) tell_those(core, in, parted, open, count);
}

}  // namespace

ContactsInLanes contacts_in_lanes(const Core& core, LoadRate rate, float dt, float fall) {
    const Vec2 gravity = core.state->gravity;
    return {core.manifolds, core.contacts, core.clearances, core.poses, core.motions, core.bodies,     core.boxes,          widest_box,
            rate,           gravity,       length(gravity), dt,         fall,         2.0f * fast_way, is_continuous(core), !has_shock(core.state->solver)};
}

void update_in_lanes(Core& core, const ContactsInLanes& in, std::uint32_t first, std::uint32_t end, BitSet open, UpdateCount& count) {
    core.lanes >= 8 ? update_by<max_block_lanes>(core, in, first, end, open, count) : update_by<4>(core, in, first, end, open, count);
}

#endif

}  // namespace islet::detail
