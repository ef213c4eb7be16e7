#include "../exact.hpp"

#include "../step/lane_update.hpp"

#include "../broadphase/pairs.hpp"
#include "../geometry/convex.hpp"
#include "../math/scalar.hpp"
#include "../solver/update_kernels.hpp"
#include "../step/clearance.hpp"
#include "../step/inner_edges.hpp"

namespace islet::detail {

#if ISLET_MAX_LANES > 1

namespace {

// The kernels' functions by their width.
template <std::uint32_t W>
KeptTouching keep_by(const ContactsInLanes& in, const std::uint32_t* contact) {
    if constexpr (W == 8) return keep_touching_8(in, contact);
    return keep_touching_4(in, contact);
}
template <std::uint32_t W>
void tell_by(const ContactsInLanes& in, const std::uint32_t* contact, ToldApart& out) {
    if constexpr (W == 8) return tell_apart_8(in, contact, out);
    tell_apart_4(in, contact, out);
}

template <std::uint32_t W>
void remake_by(const ContactsInLanes& in, PairKind kind, const LanePairs& pairs, Remade& out) {
    if constexpr (W == 8) return remake_8(in, kind, pairs, out);
    remake_4(in, kind, pairs, out);
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

// What lanes take a shape for.
enum class LaneShape : std::uint8_t { circle, capsule, polygon, box, other };

LaneShape lane_shape_of(const Geometry& g) {
    switch (g.shape_type()) {
        case ShapeType::circle: return LaneShape::circle;
        case ShapeType::capsule: return LaneShape::capsule;
        case ShapeType::polygon: return !has_hulls || is_box(g.polygon) ? LaneShape::box : LaneShape::polygon;
        default: return LaneShape::other;
    }
}

// What geometries are, of those that were asked last.
class ShapeMemo {
public:
    LaneShape of(const Geometry* geometries, std::uint32_t which) {
        if (is_empty_) clear();
        const std::uint32_t at = which % room;
        if (asked_[at] != which) {
            asked_[at] = which;
            is_[at] = lane_shape_of(geometries[which]);
        }
        return is_[at];
    }

private:
    ISLET_NEVER_INLINE void clear() {
        for (std::uint32_t& asked : asked_) asked = null_index;
        is_empty_ = false;
    }

    static constexpr std::uint32_t room = 32;
    std::uint32_t asked_[room];
    LaneShape is_[room];
    bool is_empty_ = true;
};

// The kind of a pair. False if lanes do not know it. A has the higher rank.
bool kind_of_pair(LaneShape a, LaneShape b, PairKind& kind) {
    if (a == LaneShape::other || b == LaneShape::other) return false;
    constexpr PairKind kinds[4][4] = {{PairKind::circles, PairKind::circles, PairKind::circles, PairKind::circles},
                                      {PairKind::capsule_circle, PairKind::capsules, PairKind::capsules, PairKind::capsules},
                                      {PairKind::polygon_circle, PairKind::polygon_capsule, PairKind::polygons, PairKind::polygons},
                                      {PairKind::polygon_circle, PairKind::polygon_capsule, PairKind::polygons, PairKind::boxes}};
    kind = kinds[static_cast<std::uint32_t>(a)][static_cast<std::uint32_t>(b)];
    return true;
}

// What updates a range of contacts in lanes.
template <std::uint32_t W>
class LaneUpdate {
public:
    LaneUpdate(Core& core, const ContactsInLanes& in, BitSet open, UpdateSets sets, UpdateCount& count)
        : core_(core), in_(in), open_(open), sets_(sets), count_(count) {}

    // `all`: how many of the contacts count.
    void keep(const std::uint32_t* contact, std::uint32_t all) {
        const std::uint32_t counting = (1u << all) - 1;
        const KeptTouching told = keep_by<W>(in_, contact);
        const std::uint32_t keeps = counting & told.kept, kept = BitSet::bits_of(keeps);
        count_.kept += kept;
        count_.touching.add({all, kept});
        if (keeps == counting) return;
        remake(contact, counting & told.anew, count_.touching);
        open_those(contact, counting & ~keeps & ~told.anew, open_);
    }

    void tell(const std::uint32_t* contact, std::uint32_t all) {
        ToldApart told;
        tell_by<W>(in_, contact, told);
        const std::uint32_t counting = (1u << all) - 1, keeps = counting & told.kept;
        std::uint32_t apart = counting & told.apart;
        // What comes fast to a link is looked at again where it may touch.
        for (std::uint32_t fast = apart & told.fast; fast != 0; fast &= fast - 1) {
            const std::uint32_t i = trailing_zeros(fast);
            if (is_link(core_, core_.contacts[contact[i]])) apart &= ~(1u << i);
        }
        for (std::uint32_t left = apart; left != 0; left &= left - 1) {
            const std::uint32_t i = trailing_zeros(left);
            ContactManifold& m = core_.manifolds[contact[i]];
            core_.clearances[contact[i]] = told.clearance[i];
            note_apart(m, core_.poses[m.body_a], core_.poses[m.body_b]);
        }
        const std::uint32_t parts = counting & told.parts, anew = counting & told.anew;
        for (std::uint32_t left = parts; left != 0; left &= left - 1) sets_.part(core_.manifolds, contact[trailing_zeros(left)]);
        count_.kept += BitSet::bits_of(keeps);
        count_.apart.add({all, BitSet::bits_of(keeps | apart | parts)});
        remake(contact, anew, count_.apart);
        open_those(contact, counting & ~(keeps | apart | parts | anew), open_);
    }

    // Pairs that are left: but few of a kind take less time one by one.
    void finish() {
        for (; kinds_ != 0; kinds_ &= kinds_ - 1) {
            const std::uint32_t kind = trailing_zeros(kinds_);
            Listed& pairs = listed_[kind];
            if (4 * pairs.count <= W) {
                open_those(pairs.of.contact, (1u << pairs.count) - 1, open_);
                continue;
            }
            for (std::uint32_t i = pairs.count; i < W; ++i) {
                pairs.of.contact[i] = pairs.of.contact[0];
                pairs.of.geometry_a[i] = pairs.of.geometry_a[0];
                pairs.of.geometry_b[i] = pairs.of.geometry_b[0];
            }
            remake_listed(static_cast<PairKind>(kind));
        }
    }

private:
    struct Listed {
        LanePairs of;
        std::uint32_t count;
    };

    // Lists contacts that need new manifolds, and counts them; those that are none of lanes' pairs are left open.
    void remake(const std::uint32_t* contact, std::uint32_t which, LaneShare& share) {
        for (; which != 0; which &= which - 1) {
            const std::uint32_t c = contact[trailing_zeros(which)];
            if (list(c)) {
                ++share.done;
            } else {
                open_.set(c);
            }
        }
    }
    bool list(std::uint32_t c) {
        const ContactManifold& m = core_.manifolds[c];
        const Contact& of = core_.contacts[c];
        const Pose &pose_a = core_.poses[m.body_a], &pose_b = core_.poses[m.body_b];
        if (may_bear(core_.bodies[m.body_a], pose_a, pose_b) || may_bear(core_.bodies[m.body_b], pose_b, pose_a)) return false;
        const std::uint32_t a = core_.shapes[of.shape_a].geometry, b = core_.shapes[of.shape_b].geometry;
        const LaneShape shape_a = shapes_.of(core_.geometries, a), shape_b = shapes_.of(core_.geometries, b);
        PairKind kind;
        if (!kind_of_pair(shape_a, shape_b, kind)) return false;
        // A round shape may roll, where no others are at both bodies.
        if ((shape_a <= LaneShape::capsule || shape_b <= LaneShape::capsule) && m.count() == 1 && !is_between_others(core_.bodies, m)) return false;
        const std::uint32_t bit = 1u << static_cast<std::uint32_t>(kind);
        Listed& pairs = listed_[static_cast<std::uint32_t>(kind)];
        if ((kinds_ & bit) == 0) pairs.count = 0;
        kinds_ |= bit;
        pairs.of.contact[pairs.count] = c;
        pairs.of.geometry_a[pairs.count] = a;
        pairs.of.geometry_b[pairs.count] = b;
        if (++pairs.count == W) remake_listed(kind);
        return true;
    }
    void remake_listed(PairKind kind) {
        Listed& pairs = listed_[static_cast<std::uint32_t>(kind)];
        Remade out;
        remake_by<W>(in_, kind, pairs.of, out);
        const std::uint32_t counting = (1u << pairs.count) - 1;
        open_those(pairs.of.contact, counting & ~out.done, open_);
        open_those(pairs.of.contact, counting & out.changed, sets_.changed);
        pairs.count = 0;
    }

    Core& core_;
    const ContactsInLanes& in_;
    BitSet open_;
    UpdateSets sets_;
    UpdateCount& count_;
    ShapeMemo shapes_;
    std::uint32_t kinds_ = 0;  // a bit for each that has been listed
    Listed listed_[pair_kinds];
};

template <std::uint32_t W>
void update_by(Core& core, const ContactsInLanes& in, std::uint32_t first, std::uint32_t end, BitSet open, UpdateSets sets, UpdateCount& count) {
    const bool keeps = core.kept.keeps_in_lanes, parts = core.kept.parts_in_lanes;
    Gathered<W> touching, parted;
    LaneUpdate<W> update(core, in, open, sets, count);
    const auto keep = [&](const std::uint32_t* contact, std::uint32_t all) { update.keep(contact, all); };
    const auto tell = [&](const std::uint32_t* contact, std::uint32_t all) { update.tell(contact, all); };
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
    update.finish();
}

}  // namespace

ContactsInLanes contacts_in_lanes(const Core& core, LoadRate rate, float dt, float fall) {
    const Vec2 gravity = core.state->gravity;
    return {core.manifolds,
            core.contacts,
            core.geometries,
            core.clearances,
            core.poses,
            core.motions,
            core.bodies,
            core.boxes,
            widest_box,
            rate,
            gravity,
            length(gravity),
            dt,
            fall,
            2.0f * fast_way,
            is_continuous(core),
            !has_shock(core.state->solver)};
}

void update_in_lanes(Core& core, const ContactsInLanes& in, std::uint32_t first, std::uint32_t end, BitSet open, UpdateSets sets, UpdateCount& count) {
    core.lanes >= 8 ? update_by<max_block_lanes>(core, in, first, end, open, sets, count) : update_by<4>(core, in, first, end, open, sets, count);
}

#endif

}  // namespace islet::detail
