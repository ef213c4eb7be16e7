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

// Contacts of one kind: those of a word of the set, and what the words before it left, which were too few for lanes.
template <std::uint32_t W>
struct Gathered {
    std::uint32_t contact[64 + W];
    std::uint32_t count = 0;

    // Calls visit(contacts, count) for as many at once as there are lanes, and keeps the rest.
    template <class Visit>
    ISLET_INLINE void take_full(Visit&& visit) {
        if (count < W) return;
        std::uint32_t first = 0;
        for (; first + W <= count; first += W) visit(contact + first, W);
        for (std::uint32_t i = first; i < count; ++i) contact[i - first] = contact[i];
        count -= first;
    }
    // The same for the rest: lanes that are left have the first contact.
    template <class Visit>
    ISLET_INLINE void take_rest(Visit&& visit) {
        if (count == 0) return;
        for (std::uint32_t i = count; i < W; ++i) contact[i] = contact[0];
        visit(contact, count);
    }
};

void open_those(const std::uint32_t* contact, std::uint32_t which, BitSet open) {
    for (; which != 0; which &= which - 1) open.set(contact[trailing_zeros(which)]);
}

// `all`: how many of the contacts count.
template <std::uint32_t W>
void keep_those(const ContactsInLanes& in, const std::uint32_t* contact, std::uint32_t all, BitSet open, UpdateCount& count) {
    const std::uint32_t counting = (1u << all) - 1, keeps = counting & keep_by<W>(in, contact);
    std::uint32_t kept = all;
    if (keeps != counting) {
        kept = BitSet::bits_of(keeps);
        open_those(contact, counting & ~keeps, open);
    }
    count.kept += kept;
    count.touching.add({all, kept});
}

template <std::uint32_t W>
void tell_those(Core& core, const ContactsInLanes& in, const std::uint32_t* contact, std::uint32_t all, BitSet open, UpdateCount& count) {
    ToldApart told;
    tell_by<W>(in, contact, told);
    const std::uint32_t counting = (1u << all) - 1, keeps = counting & told.kept;
    std::uint32_t apart = counting & told.apart;
    // What comes fast to a link is looked at again where it may touch.
    for (std::uint32_t fast = apart & told.fast; fast != 0; fast &= fast - 1) {
        const std::uint32_t i = trailing_zeros(fast);
        if (is_link(core, core.contacts[contact[i]])) apart &= ~(1u << i);
    }
    for (std::uint32_t left = apart; left != 0; left &= left - 1) {
        const std::uint32_t i = trailing_zeros(left);
        ContactManifold& m = core.manifolds[contact[i]];
        core.clearances[contact[i]] = told.clearance[i];
        note_apart(m, core.poses[m.body_a], core.poses[m.body_b]);
    }
    count.kept += BitSet::bits_of(keeps);
    count.apart.add({all, BitSet::bits_of(keeps | apart)});
    open_those(contact, counting & ~(keeps | apart), open);
}

template <std::uint32_t W>
void update_by(Core& core, const ContactsInLanes& in, std::uint32_t first, std::uint32_t end, BitSet open, UpdateCount& count) {
    const bool keeps = core.kept.keeps_in_lanes, parts = core.kept.parts_in_lanes;
    Gathered<W> touching, parted;
    const auto keep = [&](const std::uint32_t* contact, std::uint32_t all) { keep_those<W>(in, contact, all, open, count); };
    const auto tell = [&](const std::uint32_t* contact, std::uint32_t all) { tell_those<W>(core, in, contact, all, open, count); };
    const auto leave = [&](const std::uint32_t* contact, std::uint32_t all) { open_those(contact, (1u << all) - 1, open); };
    for (std::uint32_t w = first; w < end; ++w) {
        open.words[w] = 0;
        // Without a branch, as which kind a contact is can't be foreseen: each is written to both lists, and counts in one.
        std::uint32_t touch = touching.count, part = parted.count;
        for (std::uint64_t bits = core.awake_contacts.words[w]; bits != 0; bits &= bits - 1) {
            const std::uint32_t i = 64 * w + trailing_zeros_of_long(bits), touches = core.manifolds[i].count() != 0 ? 1 : 0;
            touching.contact[touch] = parted.contact[part] = i;
            touch += touches;
            part += 1 - touches;
        }
        touching.count = touch;
        parted.count = part;
        keeps ? touching.take_full(keep) : touching.take_full(leave);
        parts ? parted.take_full(tell) : parted.take_full(leave);
    }
    keeps ? touching.take_rest(keep) : touching.take_rest(leave);
    parts ? parted.take_rest(tell) : parted.take_rest(leave);
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
