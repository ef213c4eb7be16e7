// The contact update in lanes: what most contacts need. Those that are as before keep their manifolds; of those without points many are found to be far apart.
// step/contact_update.cpp does the same for one contact, by the same arithmetic, operation by operation, so that lanes keep no manifold that it would not keep.
#pragma once

#include <cstddef>
#include <cstring>

#include "../collide/manifold.hpp"
#include "../data/records.hpp"
#include "../math/lane_vec.hpp"

namespace islet::detail {

inline constexpr float recycle_distance = 2.0f * linear_slop;  // m that the surfaces may slip before a manifold is made anew
inline constexpr float most_load = 1.0e28f;                    // N; a contact whose load would be more forgets it
inline constexpr float recycle_turn = 0.1f;                    // rad that a body may turn before a manifold is made anew
inline constexpr float least_lag = 0.001f;                     // rad that a manifold may lag behind two bodies that turn
inline constexpr float turn_rate = 0.015f;                     // rad/s of bodies with which a manifold turns: at a body that is not dynamic
inline constexpr float level_turn_rate = 0.05f;                // of two bodies that meet with one level face; card houses fall if it is less

inline constexpr float wedged_turn_rate = 0.15f;  // rad/s of bodies with which a manifold turns that do not meet with one level face
inline constexpr float held_turn = 0.09f;         // of what is between others, as a share of sqrt(g / size); arches fold if it is less
inline constexpr float bearing_share = 0.1f;      // of the impulse at the other point: if a point bears less, that face is none
inline constexpr float turn_alike = 0.1f;         // share of their rates by which two bodies on a level face may differ
inline constexpr float level_face = 0.3f;         // tangent of the angle between gravity and the normal of a level face, at most

inline constexpr float sticking_share = 0.9f;             // of the friction that there may be: what sticks needs less
inline constexpr float most_creep = 15.0f * linear_slop;  // m that faces of what is between others may slip before a manifold is made anew
inline constexpr float creep_share = 0.15f;               // the same as a share of the smaller body's size, but recycle_distance at least

inline constexpr float sunk_from = -2.0f * linear_slop;  // m, separation below which a contact with a floor is looked at by itself

/// How the load of a contact follows the force that it bore: m.load = keep * m.load + gain * (sum of its normal impulses).
struct LoadRate {
    float keep = 1;  // share of the old load
    float gain = 0;  // 1/s, of the impulses of the last substep
};

/// The flags of a contact that may be settled: of one that touches, and of one without points. What else is among `asked_flags` keeps it from that. So does
/// `pose_learns` of either body, and where there are no points `pose_fast`.
inline constexpr std::uint32_t settled_flags = contact_touching | contact_posed;
inline constexpr std::uint32_t apart_flags = contact_posed;
/// The flags of one that touches, and was made ahead of a blow, but perhaps contact_untold.
inline constexpr std::uint32_t struck_flags = settled_flags | contact_ahead;
inline constexpr std::uint32_t asked_flags = settled_flags | contact_sensor | contact_asks | contact_one_way | contact_ahead | contact_untold | contact_rolls;

/// True if lanes may keep the manifold of a contact that touches; if they may look how far apart a contact without points is.
ISLET_LANE bool lanes_keep(std::uint32_t flags) {
    return (flags & (asked_flags | contact_special)) == settled_flags && (flags & 3u << contact_count_shift) != 0;
}
ISLET_LANE bool lanes_tell_apart(std::uint32_t flags) {
    return (flags & ((asked_flags & ~std::uint32_t{contact_posed}) | contact_special | 3u << contact_count_shift)) == 0;
}

/// True if other bodies are at both bodies of a contact, too, as at the parts of an arch or of a house of cards, but not at what lies on a board.
ISLET_LANE bool is_between_others(const Body* bodies, const ContactManifold& m) {
    const std::uint32_t own = m.sharers();
    return bodies[m.body_a].contact_count > own && bodies[m.body_b].contact_count > own;
}

/// Where the contacts of a world and their bodies are, and what the step's update asks of all.
struct ContactsInLanes {
    ContactManifold* manifolds;
    const Contact* contacts;
    const Geometry* geometries;
    float* clearances;  // m, by contact
    const Pose* poses;
    const Motion* motions;
    const Body* bodies;
    const Aabb* boxes;  // by shape
    float widest_box;   // m; a shape with a wider one may be endless
    LoadRate rate;
    Vec2 gravity;       // m/s^2
    float pull;         // m/s^2, the length of gravity
    float dt;           // s
    float fall;         // m, the way that gravity adds to one body's within dt
    float comes_fast;   // m; if two bodies come together by more, their contact looks ahead
    bool follows_deep;  // what has sunk deep into a floor is looked at by itself
    bool looks_ahead;   // bodies that both move look ahead for each other
};

/// A bit for each lane whose surfaces have slipped by less than the root of `most` at a point, but for what they are pressed into each other where they may be.
template <class L, class F = typename L::F>
ISLET_LANE std::uint32_t slips_little(LaneVec<F> anchor, LaneVec<F> normal, LaneVec<F> shift, LaneVec<F> apart, F size, F most, std::uint32_t pressed) {
    const LaneVec<F> slip = shift + turned_in_lanes(apart, anchor);
    const F way = dot(slip, slip), sunk = clamp_lanes<L>(dot(slip, normal), L::splat(-0.5f) * size, L::splat(0));
    return L::bits(way <= most) | (pressed & L::bits(way - sunk * sunk <= most));
}

/// The fat boxes of the two shapes of contacts.
template <class L>
struct LaneBoxes {
    using F = typename L::F;
    typename L::template Columns<4> a, b;  // m: lower, upper

    ISLET_LANE LaneBoxes(const ContactsInLanes& in, const std::uint32_t* contact) {
        std::uint32_t shape_a[L::width], shape_b[L::width];
        for (std::uint32_t i = 0; i < L::width; ++i) {
            shape_a[i] = in.contacts[contact[i]].shape_a;
            shape_b[i] = in.contacts[contact[i]].shape_b;
        }
        L::template gather4<sizeof(Aabb) / 4>(reinterpret_cast<const float*>(in.boxes), shape_a, a);
        L::template gather4<sizeof(Aabb) / 4>(reinterpret_cast<const float*>(in.boxes), shape_b, b);
    }
    /// A bit for each pair that meets; for each that does within a step in which B goes so far from A (may_meet); for each that has ends.
    ISLET_LANE std::uint32_t meet() const { return L::bits(a[0] <= b[2]) & L::bits(b[0] <= a[2]) & L::bits(a[1] <= b[3]) & L::bits(b[1] <= a[3]); }
    ISLET_LANE std::uint32_t may_meet(LaneVec<F> way, F turn) const {
        const F lower[2] = {min(b[0], b[0] + way.x) - turn, min(b[1], b[1] + way.y) - turn};
        const F upper[2] = {max(b[2], b[2] + way.x) + turn, max(b[3], b[3] + way.y) + turn};
        return L::bits(a[0] <= upper[0]) & L::bits(lower[0] <= a[2]) & L::bits(a[1] <= upper[1]) & L::bits(lower[1] <= a[3]);
    }
    ISLET_LANE std::uint32_t have_ends(float widest) const { return L::bits(a[2] - a[0] <= L::splat(widest)); }
};

/// What the update reads of contacts, and the poses of their bodies.
template <class L>
struct LaneContacts {
    static constexpr std::uint32_t stride = sizeof(ContactManifold) / 4;
    using F = typename L::F;
    using I = decltype(F{} < F{});

    typename L::template Columns<4> head;         // bodies, flags, ids
    typename L::template Columns<8> frame, a, b;  // normal, offset, rotations; poses
    std::uint32_t body_a[L::width], body_b[L::width];

    ISLET_LANE LaneContacts(const ContactsInLanes& in, const std::uint32_t* contact) {
        const float* const words = reinterpret_cast<const float*>(in.manifolds);
        L::template gather4<stride>(words, contact, head);
        std::memcpy(body_a, &head[0], sizeof body_a);
        std::memcpy(body_b, &head[1], sizeof body_b);
        L::template gather8<sizeof(Pose) / 4>(reinterpret_cast<const float*>(in.poses), body_a, a);
        L::template gather8<sizeof(Pose) / 4>(reinterpret_cast<const float*>(in.poses), body_b, b);
        L::template gather8<stride>(words + 4, contact, frame);
    }
    /// ContactFlags; PoseFlags of A and B.
    ISLET_LANE I flags() const { return reinterpret_cast<I>(head[2]); }
    ISLET_LANE I states_a() const { return reinterpret_cast<I>(a[7]); }
    ISLET_LANE I states_b() const { return reinterpret_cast<I>(b[7]); }
};

/// How the bodies of contacts move.
template <class L>
struct LaneMotions {
    using F = typename L::F;
    LaneVec<F> va, vb;
    F wa, wb;

    ISLET_LANE LaneMotions(const ContactsInLanes& in, const std::uint32_t* body_a, const std::uint32_t* body_b) {
        typename L::template Columns<4> a, b;  // v, w, slack
        L::template gather4<sizeof(Motion) / 4>(reinterpret_cast<const float*>(in.motions), body_a, a);
        L::template gather4<sizeof(Motion) / 4>(reinterpret_cast<const float*>(in.motions), body_b, b);
        va = {a[0], a[1]};
        vb = {b[0], b[1]};
        wa = a[2];
        wb = b[2];
    }
};

/// How bodies come together within a step: Approach (broadphase/pairs.hpp).
template <class L>
struct LaneApproach {
    using F = typename L::F;
    LaneVec<F> way = {F{}, F{}};
    F turn = F{};

    LaneApproach() = default;
    /// Of bodies that stand `offset` (m) from each other and reach so far (m) from their centres: approach_of.
    ISLET_LANE LaneApproach(const LaneMotions<L>& m, LaneVec<F> offset, F reach_a, F reach_b, float time, F fall) {
        const F dt = L::splat(time);
        way = dt * (m.vb - m.va - cross(select(reach_a < reach_b, m.wb, m.wa), offset));
        turn = min(dt * L::abs(m.wb - m.wa), L::splat(2.0f)) * min(reach_a, reach_b) + fall;
    }
    ISLET_LANE F most() const { return L::abs(way.x) + L::abs(way.y) + turn; }
};

/// A manifold's frame in lanes, with all that it holds of how the bodies stood.
template <class F>
struct LaneFrame {
    LaneVec<F> normal, offset, rotation_a, rotation_b, anchors[2];
};

template <class L, class F = typename L::F>
ISLET_LANE LaneVec<F> unit_rotation(LaneVec<F> q) {  // normalize(Rot), of what is nearly a unit vector
    const F inv_length = L::splat(1.0f) / L::sqrt(q.x * q.x + q.y * q.y);
    return {q.x * inv_length, q.y * inv_length};
}

/// turn_along's turn: of all lanes.
template <class L, class F = typename L::F>
ISLET_LANE LaneFrame<F> turned_frame(const LaneFrame<F>& m, LaneVec<F> turn, LaneVec<F> to) {
    LaneFrame<F> t = {turned_in_lanes(turn, m.normal), turned_in_lanes(turn, m.offset), to, {}, {}};
    t.normal = (L::splat(1.5f) - L::splat(0.5f) * dot(t.normal, t.normal)) * t.normal;
    t.rotation_b = unit_rotation<L>(turned_in_lanes(turn, m.rotation_b));
    for (std::uint32_t i = 0; i < 2; ++i) t.anchors[i] = turned_in_lanes(turn, m.anchors[i]);
    return t;
}

/// A bit for each contact whose manifold turns with its bodies, if it lags (turn_along). `size` is the smaller body's (m), p and q are the normal impulses.
template <class L, class F = typename L::F>
ISLET_LANE std::uint32_t turns_along(const ContactsInLanes& in, const std::uint32_t* contact, const std::uint32_t* body_a, const std::uint32_t* body_b,
                                     LaneVec<F> normal, F size, F p, F q, std::uint32_t one_sharer_and_two, std::uint32_t moving) {
    float of_a[L::width], of_b[L::width];
    for (std::uint32_t i = 0; i < L::width; ++i) {
        of_a[i] = in.motions[body_a[i]].w;
        of_b[i] = in.motions[body_b[i]].w;
    }
    const F wa = L::load(of_a), wb = L::load(of_b), slower = min(L::abs(wa), L::abs(wb));
    std::uint32_t turns = L::positive(wa * wb) & (L::bits(slower > L::splat(level_turn_rate)) | (L::bits(slower > L::splat(turn_rate)) & ~moving));
    if ((turns & moving) == 0) return turns;
    const LaneVec<F> gravity = {L::splat(in.gravity.x), L::splat(in.gravity.y)};
    const std::uint32_t level = one_sharer_and_two & L::bits(L::abs(cross(normal, gravity)) <= L::splat(level_face) * L::abs(dot(normal, gravity))) &
                                L::bits(L::abs(wa - wb) < L::splat(turn_alike) * slower);
    turns &= ~moving | level | L::bits(slower > L::splat(wedged_turn_rate));
    const std::uint32_t on_face = level & L::bits(min(p, q) > L::splat(bearing_share) * max(p, q));
    const F pace = L::sqrt(L::splat(in.pull) / size);
    std::uint32_t held = turns & moving & ~on_face & ~L::bits(slower > L::splat(held_turn) * pace);
    for (; held != 0; held &= held - 1) {
        const std::uint32_t i = trailing_zeros(held);
        if (is_between_others(in.bodies, in.manifolds[contact[i]])) turns &= ~(1u << i);
    }
    return turns;
}

/// What lanes know of contacts that touch: a bit for each contact.
struct KeptTouching {
    std::uint32_t kept = 0;  // it keeps its manifold
    std::uint32_t anew = 0;  // it needs a new one, between moving bodies
};

/// Keeps the manifolds of those contacts that touch and have slipped little (can_recycle), as many as there are lanes: the loads follow, and manifolds turn
/// along. None is kept, or said to need a new one, whose boxes changed and meet no more, or, if `follows_deep`, that has sunk deep into a floor. All must have
/// points.
template <class L>
ISLET_LANE KeptTouching keep_touching(const ContactsInLanes& in, const std::uint32_t* contact) {
    constexpr std::uint32_t W = L::width;
    using F = typename L::F;
    using I = decltype(F{} < F{});
    using Vec = LaneVec<F>;
    constexpr std::uint32_t stride = LaneContacts<L>::stride;
    const LaneContacts<L> all(in, contact);
    const auto &a = all.a, &b = all.b, &frame = all.frame;
    typename L::template Columns<8> points;   // anchors, impulses
    typename L::template Columns<4> surface;  // load, separations, friction
    float* const words = reinterpret_cast<float*>(in.manifolds);
    L::template gather8<stride>(words + 12, contact, points);
    L::template gather4<stride>(words + 20, contact, surface);
    const I flags = all.flags(), states = all.states_a() | all.states_b();
    const std::uint32_t two = L::bits((flags & static_cast<std::int32_t>(2u << contact_count_shift)) != 0);
    const std::uint32_t moving = L::positive(min(a[4], b[4]));
    const I asked = flags & static_cast<std::int32_t>(asked_flags | contact_special);
    const std::uint32_t settled = L::bits(asked == static_cast<std::int32_t>(settled_flags));
    const std::uint32_t struck = moving & L::bits((asked & ~static_cast<std::int32_t>(contact_untold)) == static_cast<std::int32_t>(struck_flags));
    std::uint32_t open = (settled | struck) & L::bits((states & static_cast<std::int32_t>(pose_learns)) == 0);
    const std::uint32_t moved = open & L::bits((states & static_cast<std::int32_t>(pose_moved)) != 0);
    if (moved != 0) {
        const LaneBoxes<L> boxes(in, contact);
        open &= (boxes.meet() & boxes.have_ends(in.widest_box)) | ~moved;
    }
    std::uint32_t kept = open & settled;

    LaneFrame<F> m = {{frame[0], frame[1]}, {frame[2], frame[3]}, {frame[4], frame[5]}, {frame[6], frame[7]}, {{points[0], points[1]}, {points[2], points[3]}}};
    const F size = min(a[6], b[6]);
    const Vec stands_a = {a[2], a[3]}, stands_b = {b[2], b[3]};
    Vec turn_a = turn_between(m.rotation_a, stands_a);
    std::uint32_t turns = kept & L::bits(L::abs(turn_a.y) > L::splat(least_lag));
    if (turns != 0) {
        const std::uint32_t alone = two & L::bits((flags & static_cast<std::int32_t>(3u << contact_sharers_shift)) == 0);
        turns &= turns_along<L>(in, contact, all.body_a, all.body_b, m.normal, size, points[4], points[5], alone, moving);
    }
    if (turns != 0) {
        const LaneFrame<F> turned = turned_frame<L>(m, turn_a, stands_a);
        const I which = L::mask(turns);
        const auto take = [&](Vec& of, const Vec& from) ISLET_INLINED_LAMBDA { of = {select(which, from.x, of.x), select(which, from.y, of.y)}; };
        take(m.normal, turned.normal);
        take(m.offset, turned.offset);
        take(m.rotation_a, turned.rotation_a);
        take(m.rotation_b, turned.rotation_b);
        take(m.anchors[0], turned.anchors[0]);
        take(m.anchors[1], turned.anchors[1]);
        turn_a = turn_between(m.rotation_a, stands_a);
    }

    const Vec turn_b = turn_between(m.rotation_b, stands_b);
    kept &= L::bits(min(turn_a.x, turn_b.x) >= L::splat(0)) & L::bits(max(L::abs(turn_a.y), L::abs(turn_b.y)) <= L::splat(recycle_turn));
    const F turn = L::abs(turn_b.y * turn_a.x - turn_b.x * turn_a.y);
    const Vec shift = Vec{b[0], b[1]} - Vec{a[0], a[1]} - turned_in_lanes(turn_b, m.offset);
    const Vec apart = turn_b - turn_a;
    const std::uint32_t faces = two & moving;
    const auto slip_less_than = [&](F most) ISLET_INLINED_LAMBDA {
        const F reach = most - L::splat(2.0f) * size * turn, square = reach * reach;
        return L::positive(reach) & slips_little<L>(m.anchors[0], m.normal, shift, apart, size, square, faces) &
               (slips_little<L>(m.anchors[1], m.normal, shift, apart, size, square, faces) | ~two);
    };
    std::uint32_t creep = kept & faces;
    kept &= slip_less_than(L::splat(recycle_distance));
    creep &= ~kept;
    // Faces of what is between others may creep, where friction holds them.
    if (creep != 0) creep &= L::bits(L::abs(points[6] + points[7]) < L::splat(sticking_share) * surface[3] * (points[4] + points[5]));
    for (std::uint32_t left = creep; left != 0; left &= left - 1) {
        const std::uint32_t i = trailing_zeros(left);
        if (!is_between_others(in.bodies, in.manifolds[contact[i]])) creep &= ~(1u << i);
    }
    if (creep != 0) kept |= creep & slip_less_than(max(L::splat(recycle_distance), min(L::splat(most_creep), L::splat(creep_share) * size)));
    if (in.follows_deep) kept &= moving | L::bits(min(surface[1], surface[2]) >= L::splat(sunk_from));

    const F load = L::splat(in.rate.keep) * surface[0] + L::splat(in.rate.gain) * (points[4] + points[5]);
    const F followed = select((load >= L::splat(0)) & (load < L::splat(most_load)), load, L::splat(0));
    float loads[W];
    L::store(loads, followed);
    for (std::uint32_t left = kept; left != 0; left &= left - 1) in.manifolds[contact[trailing_zeros(left)]].load = loads[trailing_zeros(left)];
    turns &= kept;
    if (turns != 0) {
        const F stood[4] = {m.normal.x, m.normal.y, m.offset.x, m.offset.y};
        const F turned[4] = {m.rotation_a.x, m.rotation_a.y, m.rotation_b.x, m.rotation_b.y};
        const F anchors[4] = {m.anchors[0].x, m.anchors[0].y, m.anchors[1].x, m.anchors[1].y};
        L::template scatter4_where<stride>(turns, words + 4, contact, stood);
        L::template scatter4_where<stride>(turns, words + 8, contact, turned);
        L::template scatter4_where<stride>(turns, words + 12, contact, anchors);
    }
    return {kept, open & moving & ~kept};
}

/// What lanes know of contacts without points: a bit for each contact.
struct ToldApart {
    std::uint32_t kept = 0;            // it stays as it is, since its bodies have hardly moved
    std::uint32_t apart = 0;           // its shapes are too far apart for points
    std::uint32_t fast = 0;            // the same, and its bodies come together fast
    std::uint32_t anew = 0;            // between moving bodies, its shapes must be looked at
    std::uint32_t parts = 0;           // its boxes meet no more
    float clearance[max_block_lanes];  // m, of those apart: see step/clearance.hpp
};

/// Looks at contacts without points, as many as there are lanes. It may take bodies that fall together for such as come together.
template <class L>
ISLET_LANE void tell_apart(const ContactsInLanes& in, const std::uint32_t* contact, ToldApart& out) {
    constexpr std::uint32_t W = L::width;
    using F = typename L::F;
    using I = decltype(F{} < F{});
    using Vec = LaneVec<F>;
    const LaneContacts<L> all(in, contact);
    const auto &a = all.a, &b = all.b, &frame = all.frame;
    typename L::template Columns<4> center_a, center_b;  // local centres, damping
    const I flags = all.flags(), states_a = all.states_a(), states_b = all.states_b();
    const std::uint32_t moving = L::positive(min(a[4], b[4]));
    const Vec way = Vec{b[0], b[1]} - Vec{a[0], a[1]};

    // How fast they come (approach_of). Two bodies that fall together do not look ahead (approach_to): if that matters, one lane decides.
    const std::uint32_t hurries = L::bits(((states_a | states_b) & static_cast<std::int32_t>(pose_fast)) != 0);
    const std::uint32_t both = moving & L::bits((states_a & states_b & static_cast<std::int32_t>(pose_fast)) != 0);
    const std::uint32_t looks = hurries & (~moving | (in.looks_ahead ? L::bits((flags & static_cast<std::int32_t>(contact_bouncy)) == 0) : 0u));
    LaneApproach<L> approach;
    F come = L::splat(0);
    if (hurries != 0) {
        approach = LaneApproach<L>(LaneMotions<L>(in, all.body_a, all.body_b), way, a[6], b[6], in.dt, L::splat(in.fall));
        come = select(L::mask(looks), approach.most(), come);
    }
    std::uint32_t open = L::bits((flags & static_cast<std::int32_t>((asked_flags & ~std::uint32_t{contact_posed}) | contact_special)) == 0);
    const std::uint32_t moved = L::bits(((states_a | states_b) & static_cast<std::int32_t>(pose_moved)) != 0);
    out.parts = 0;
    if (moved != 0) {
        const std::uint32_t leaves = L::bits(((states_a | states_b) & static_cast<std::int32_t>(pose_leaves)) != 0);
        const LaneBoxes<L> boxes(in, contact);
        const std::uint32_t near = boxes.meet() | (leaves & boxes.may_meet(approach.way, approach.turn));
        out.parts = open & moved & ~near;
        open &= (near & boxes.have_ends(in.widest_box)) | ~moved;
    }
    const std::uint32_t fast = L::bits(come > L::splat(in.comes_fast));

    const Vec offset = {frame[2], frame[3]}, stands_a = {a[2], a[3]}, stands_b = {b[2], b[3]};
    const Vec turn_a = turn_between(Vec{frame[4], frame[5]}, stands_a), turn_b = turn_between(Vec{frame[6], frame[7]}, stands_b);
    const F turned_a = L::abs(turn_a.y), turned_b = L::abs(turn_b.y);
    const std::uint32_t posed = L::bits((flags & static_cast<std::int32_t>(contact_posed)) != 0);
    const Vec shift = way - offset;
    const F moved_by = dot(shift, shift);
    const F room = L::splat(0.5f * speculative_distance) - a[6] * turned_a - b[6] * turned_b;
    const std::uint32_t stays = posed & L::bits(min(turn_a.x, turn_b.x) >= L::splat(0)) & L::bits(max(turned_a, turned_b) <= L::splat(recycle_turn)) &
                                L::positive(room) & L::bits(moved_by < room * room);
    out.kept = open & stays & ~fast;
    open &= ~stays | (fast & ~both);
    out.apart = out.fast = out.anew = 0;
    if (open == 0) return;

    const float* const local_centers = reinterpret_cast<const float*>(in.bodies) + offsetof(Body, local_center) / 4;
    L::template gather4<sizeof(Body) / 4>(local_centers, all.body_a, center_a);
    L::template gather4<sizeof(Body) / 4>(local_centers, all.body_b, center_b);
    const F reach = a[6] + b[6];
    const F inexact = L::splat(linear_slop) + L::splat(1e-5f) * (reach + L::abs(center_a[0]) + L::abs(center_a[1]) + L::abs(center_b[0]) + L::abs(center_b[1]));
    const F margin = L::splat(speculative_distance) + L::splat(2.0f) * min(come, L::splat(max_speed_limit)) + inexact;
    const F most = margin + reach;
    const std::uint32_t circles = L::bits(dot(way, way) > most * most);
    float known[W];
    for (std::uint32_t i = 0; i < W; ++i) known[i] = in.clearances[contact[i]];
    const F one = L::splat(1.0f);
    const F turned = a[6] * (turned_a + L::abs(one - turn_a.x)) + b[6] * (turned_b + L::abs(one - turn_b.x));
    const F clearance = L::load(known) - L::sqrt(moved_by) - turned;
    out.apart = open & (circles | (posed & L::bits(clearance > margin)));
    out.fast = out.apart & fast;
    out.anew = open & moving & ~out.apart;
    L::store(out.clearance, select(L::mask(circles), L::splat(0), clearance));
}

}  // namespace islet::detail
