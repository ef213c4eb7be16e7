// The contact update in lanes, where contacts need new manifolds: `remake` (step/contact_update.cpp) of as many as there are lanes, by the same arithmetic,
// operation by operation. What is rare is left to that: what the narrow phase in lanes does not decide, and shapes that meet later in the step.
#pragma once

#include "../collide/lane_manifolds.hpp"
#include "../graph/contact_lanes.hpp"

namespace islet::detail {

/// What became of pairs: a bit for each.
struct Remade {
    std::uint32_t done = 0;     // it has its new manifold
    std::uint32_t changed = 0;  // of these: it touches now and did not, or the other way round, or its touch is not told yet
};

/// The bodies of pairs.
template <class L>
struct LanePoses {
    using F = typename L::F;
    using Vec = LaneVec<F>;
    Vec offset;                      // m, from A's centre to B's
    Vec stands_a, stands_b;          // rotations
    Vec center_a, center_b;          // m, local centres
    F reach_a, reach_b;              // m, of all their points from their centres
    LaneInts<L> states_a, states_b;  // PoseFlags

    ISLET_LANE LanePoses(const ContactsInLanes& in, const std::uint32_t* body_a, const std::uint32_t* body_b) {
        typename L::template Columns<8> a, b;
        typename L::template Columns<4> local_a, local_b;
        L::template gather8<sizeof(Pose) / 4>(reinterpret_cast<const float*>(in.poses), body_a, a);
        L::template gather8<sizeof(Pose) / 4>(reinterpret_cast<const float*>(in.poses), body_b, b);
        const float* const local_centers = reinterpret_cast<const float*>(in.bodies) + offsetof(Body, local_center) / 4;
        L::template gather4<sizeof(Body) / 4>(local_centers, body_a, local_a);
        L::template gather4<sizeof(Body) / 4>(local_centers, body_b, local_b);
        offset = Vec{b[0], b[1]} - Vec{a[0], a[1]};
        stands_a = {a[2], a[3]};
        stands_b = {b[2], b[3]};
        center_a = {local_a[0], local_a[1]};
        center_b = {local_b[0], local_b[1]};
        reach_a = a[6];
        reach_b = b[6];
        states_a = reinterpret_cast<LaneInts<L>>(a[7]);
        states_b = reinterpret_cast<LaneInts<L>>(b[7]);
    }
};

/// How pairs come together in this step (approach_to): only those that look ahead for each other, of `hurries`, and that do not fall together.
template <class L>
ISLET_LANE LaneApproach<L> approach_to(const ContactsInLanes& in, const std::uint32_t* body_a, const std::uint32_t* body_b, const LanePoses<L>& p,
                                       std::uint32_t hurries, typename L::F fall) {
    using F = typename L::F;
    typename L::template Columns<4> size_a, size_b;
    const float* const sizes = reinterpret_cast<const float*>(in.bodies) + offsetof(Body, mass) / 4;
    static_assert(offsetof(Body, min_extent) == offsetof(Body, mass) + 8);
    L::template gather4<sizeof(Body) / 4>(sizes, body_a, size_a);
    L::template gather4<sizeof(Body) / 4>(sizes, body_b, size_b);
    const LaneMotions<L> m(in, body_a, body_b);
    LaneApproach<L> approach(m, p.offset, p.reach_a, p.reach_b, in.dt, fall);
    const F way = approach.most(), slower = min(dot(m.va, m.va), dot(m.vb, m.vb)), zero = L::splat(0);
    const std::uint32_t together = L::bits((p.states_a & p.states_b & static_cast<std::int32_t>(pose_fast)) != 0) &
                                   L::bits(way * way < L::splat(16 * in.dt * in.dt) * slower) & L::bits(way <= min(size_a[2], size_b[2]));
    const LaneInts<L> looks = L::mask(hurries & ~together);
    approach.way = select(looks, approach.way, LaneVec<F>{zero, zero});
    approach.turn = select(looks, approach.turn, zero);
    return approach;
}

/// Makes the manifolds of pairs of a kind anew. Both bodies must move, none may roll or have inner edges, nor have flags that keep lanes away (keep_touching,
/// tell_apart).
template <class L>
ISLET_LANE Remade remake(const ContactsInLanes& in, PairKind kind, const LanePairs& pairs) {
    constexpr std::uint32_t W = L::width, stride = sizeof(ContactManifold) / 4;
    using F = typename L::F;
    using I = LaneInts<L>;
    using Vec = LaneVec<F>;
    const std::uint32_t* const contact = pairs.contact;
    float* const words = reinterpret_cast<float*>(in.manifolds);
    typename L::template Columns<4> head, impulses, surface;
    std::uint32_t body_a[W], body_b[W];
    L::template gather4<stride>(words, contact, head);
    L::template gather4<stride>(words + 16, contact, impulses);
    L::template gather4<stride>(words + 20, contact, surface);
    std::memcpy(body_a, &head[0], sizeof body_a);
    std::memcpy(body_b, &head[1], sizeof body_b);
    const I flags = reinterpret_cast<I>(head[2]), ids = reinterpret_cast<I>(head[3]);
    const I had = flags >> static_cast<std::int32_t>(contact_count_shift) & 3;
    const auto has = [&](std::uint32_t flag) ISLET_INLINED_LAMBDA { return (flags & static_cast<std::int32_t>(flag)) != 0; };
    const F zero = L::splat(0), near = L::splat(speculative_distance);
    const LanePoses<L> p(in, body_a, body_b);

    LaneApproach<L> approach;
    F margin = near;
    std::uint32_t ahead = 0;
    std::uint32_t hurries = L::bits(((p.states_a | p.states_b) & static_cast<std::int32_t>(pose_fast)) != 0) & ~L::bits(has(contact_bouncy));
    if (!in.looks_ahead) hurries = 0;
    if (hurries != 0) {
        approach = approach_to(in, body_a, body_b, p, hurries, select(had == 0, L::splat(in.fall), zero));
        const I fast = approach.most() > L::splat(in.comes_fast);
        if (in.follows_deep) {
            ahead = L::bits(fast);
            margin = select(fast, near + L::splat(2.0f) * min(approach.most(), L::splat(max_speed_limit)), near);
        }
    }

    // B in frame A (pose_between).
    const Vec turn = turn_between(p.stands_a, p.stands_b);
    const Vec to = turned_back_in_lanes(p.stands_a, p.offset) + p.center_a - turned_in_lanes(turn, p.center_b);
    const PairManifolds<L> m = collide_in_lanes<L>(kind, {reinterpret_cast<const float*>(in.geometries), pairs.geometry_a, pairs.geometry_b, turn, to, margin});

    // Of those that come fast, and are not near yet, some only pass by (manifold_ahead).
    const Vec out_of_a = turned_in_lanes(p.stands_a, m.normal);
    const F least = least_separation(m), nears = dot(out_of_a, approach.way);
    const std::uint32_t later = ahead & m.some & ~L::bits(least <= near);
    const std::uint32_t pass = later & L::bits(least + nears > approach.turn + L::splat(1.1f * touch_gap));
    const std::uint32_t some = m.some & ~pass, both = m.two & ~pass;
    Remade out;
    out.done = ((1u << W) - 1) & ~m.undecided & ~(later & ~pass);
    out.changed = out.done & ((some ^ L::bits(has(contact_touching))) | L::bits(has(contact_untold)));

    const I has_one = L::mask(some), has_two = L::mask(both);
    const Vec normal = select(has_one, out_of_a, turned_in_lanes(p.stands_a, Vec{zero, zero}));
    const auto anchor = [&](const LanePoint<L>& of, I is) ISLET_INLINED_LAMBDA {
        return select(is, turned_in_lanes(p.stands_a, of.point - p.center_a), Vec{zero, zero});
    };
    const Vec anchor0 = anchor(m.points[0], has_one), anchor1 = anchor(m.points[1], has_two);
    // Points whose features the old manifold had keep their impulses, but not those of a blow.
    const I known = ~has(contact_ahead), id0 = m.points[0].id, id1 = m.points[1].id, old0 = ids & 0xffff, old1 = ids >> 16 & 0xffff;
    const auto kept = [&](I is, I id, F first, F second) ISLET_INLINED_LAMBDA {
        return select(is & known & (had == 2) & (id == old1), second, select(is & known & (had != 0) & (id == old0), first, zero));
    };
    const F load = L::splat(in.rate.keep) * surface[0] + L::splat(in.rate.gain) * (impulses[0] + impulses[1]);
    const F followed = select(had != 0, select((load >= zero) & (load < L::splat(most_load)), load, zero), surface[0]);
    const std::uint32_t lands = some & L::bits(approach.turn - nears > L::splat(2.0f * speculative_distance));
    const I counts = (has_one & static_cast<std::int32_t>(1u << contact_count_shift)) + (has_two & static_cast<std::int32_t>(1u << contact_count_shift));
    const I now = (flags & ~static_cast<std::int32_t>(3u << contact_count_shift | contact_ahead | contact_rolls)) | counts |
                  static_cast<std::int32_t>(contact_posed) | (L::mask(lands) & static_cast<std::int32_t>(contact_ahead));
    const F heads[4] = {head[0], head[1], reinterpret_cast<F>(now), reinterpret_cast<F>((has_one & id0) | (has_two & (id1 << 16)))};
    const F frame[4] = {normal.x, normal.y, p.offset.x, p.offset.y};
    const F stood[4] = {p.stands_a.x, p.stands_a.y, p.stands_b.x, p.stands_b.y};
    const F anchors[4] = {anchor0.x, anchor0.y, anchor1.x, anchor1.y};
    const F forces[4] = {kept(has_one, id0, impulses[0], impulses[1]), kept(has_two, id1, impulses[0], impulses[1]),
                         kept(has_one, id0, impulses[2], impulses[3]), kept(has_two, id1, impulses[2], impulses[3])};
    const F surfaces[4] = {select(has_one, followed, zero), select(has_one, m.points[0].separation, zero), select(has_two, m.points[1].separation, zero),
                           surface[3]};
    L::template scatter4_where<stride>(out.done, words, contact, heads);
    L::template scatter4_where<stride>(out.done, words + 4, contact, frame);
    L::template scatter4_where<stride>(out.done, words + 8, contact, stood);
    L::template scatter4_where<stride>(out.done, words + 12, contact, anchors);
    L::template scatter4_where<stride>(out.done, words + 16, contact, forces);
    L::template scatter4_where<stride>(out.done, words + 20, contact, surfaces);
    float clearances[W];
    L::store(clearances, select(L::mask(pass), zero, m.clearance));
    for (std::uint32_t left = out.done & ~some; left != 0; left &= left - 1) in.clearances[contact[trailing_zeros(left)]] = clearances[trailing_zeros(left)];
    return out;
}

}  // namespace islet::detail
