// Preparing the rows of contacts from their manifolds and from where the bodies are now.
//
// With m and i the inverse masses and inertias of the bodies, and rn = r x n and rt = t x r (contact_rows.hpp), the rows of a contact point have
//     k_normal  = ma + mb + ia rna^2 + ib rnb^2
//     k_tangent = ma + mb + ia rta^2 + ib rtb^2
#pragma once

#include <cstring>

#include "../collide/manifold.hpp"
#include "../constraint/contact_bounce.hpp"
#include "../constraint/kernels.hpp"
#include "../constraint/lane_vectors.hpp"
#include "../math/inlining.hpp"
#include "../math/lanes.hpp"
#include "../math/scalar.hpp"

namespace islet::detail {

inline constexpr std::uint32_t manifold_words = sizeof(ContactManifold) / 4;
inline constexpr std::uint32_t manifold_head_words = offsetof(ContactManifold, normal) / 4;

/// Columns stand on level faces: contacts with two points whose normal is nearly along gravity. Undone fast, their overlaps would pump up the sway of a column.
/// Corners and tilted faces sink in easily, and rarely bear a column.
inline constexpr float level_tilt = 0.02f;       // sine of the angle between the normal and gravity; a level face has less
inline constexpr float deep_level_from = 0.02f;  // m; what overlaps by more, in the mean of its two points, is deep
inline constexpr float deep_from = 0.004f;       // m, of all other contacts

/// Of the speed of a point that meets later than another one. (With all of it, rooms of frictionless bodies with restitution 1 gain energy: nine octagons had
/// 46 times theirs after two minutes, with 0.97 of it twice theirs. With this share none had more than 1.11.)
inline constexpr float late_share = 0.9f;

inline constexpr float deep_masses = 4;    // ratio of masses above which deep overlaps are undone more slowly
inline constexpr float most_give = 0.05f;  // m; boxes under hundreds of their own mass stand only because they give way

/// The next block's manifolds may be anywhere in memory.
template <std::uint32_t W>
ISLET_PART void prefetch_manifolds(const PrepareInput& in, const ContactRows<W>& next) {
    for (std::uint32_t i = 0; i < W; ++i) {
        if (contact_of(next, i, in.manifolds) == null_index) continue;
        const ContactManifold& soon = manifold_of(next, i, in.manifolds);
        ISLET_PREFETCH(&soon);
        ISLET_PREFETCH(&soon.rolling_impulse);
    }
}

/// Says which lanes land: those whose shapes come together fast. Bodies that shock propagation takes for lighter land on floors alone.
template <std::uint32_t W>
ISLET_PART void name_landings(const PrepareInput& in, ContactRows<W>& r) {
    for (std::uint32_t i = 0; i < W; ++i) {
        if (W > 1 && contact_of(r, i, in.manifolds) == null_index) continue;
        const ContactManifold& m = manifold_of(r, i, in.manifolds);
        if ((m.flags & contact_ahead) == 0) continue;
        if (!in.numbers.lightens || min(in.poses[m.body_a].inv_mass, in.poses[m.body_b].inv_mass) <= 0) r.extra_passes[i] = landing_passes;
    }
}

/// Fills in the block's bodies, and the flags that say what any of its lanes has.
template <std::uint32_t W>
ISLET_PART void name_bodies(const PrepareInput& in, ContactRows<W>& r, ContactLanes<W>& lanes) {
    std::uint32_t any = 0;  // flags of the block's contacts
    for (std::uint32_t i = 0; i < W; ++i) {
        const bool is_live = W == 1 || contact_of(r, i, in.manifolds) != null_index;  // single rows need no padding
        const std::uint32_t lane = is_live ? i : 0;
        lanes.contact[i] = W == 1 ? 0 : contact_of(r, lane, in.manifolds);
        const ContactManifold& m = manifold_of(r, lane, in.manifolds);
        lanes.body_a[i] = m.body_a;
        lanes.body_b[i] = m.body_b;
        r.body_a[i] = slot_scale<W> * (is_live ? in.slot_of[m.body_a] : PlanIndex{0});
        r.body_b[i] = slot_scale<W> * (is_live ? in.slot_of[m.body_b] : PlanIndex{0});
        const std::uint32_t flags = is_live ? m.flags : 0;
        lanes.has_point[0][i] = is_live ? 1.0f : 0.0f;
        lanes.has_point[1][i] = (flags & two_point_flag) != 0 ? 1.0f : 0.0f;
        any |= flags;
    }
    if constexpr (W > 1) {
        r.shared = (any >> contact_sharers_shift & 3u) != 0;
        for (std::uint32_t i = 0; r.shared && i < W; ++i) r.sharers[i] = static_cast<std::uint8_t>(in.manifolds[lanes.contact[i]].sharers());
    }
    r.two_points = (any & two_point_flag) != 0 ? 1 : 0;
    if constexpr (has_surfaces) r.special = (any & contact_special) != 0;
    r.bouncy = (any & bouncy_flags) != 0;
    if constexpr (W > 1) r.rebounds = r.bouncy;
    if constexpr (W == 1)
        r.extra_passes[0] = 0;
    else
        std::memset(r.extra_passes, 0, W);
    if ((any & contact_ahead) != 0) name_landings(in, r);
}

/// 1 in the lanes that have point i, which some lane of the block has, and 0 in the others.
template <class L>
ISLET_PART typename L::F has_point(const ContactLanes<L::width>& lanes, std::uint32_t i) {
    if constexpr (L::width == 1)
        return 1;
    else
        return L::load(lanes.has_point[i]);
}

/// The manifolds of a block.
template <class L>
struct LaneManifolds {
    using F = typename L::F;
    typename L::template Columns<8> frame;    // normal, offset, rotations of A and B when the manifold was made
    typename L::template Columns<8> points;   // anchors, normal impulses, tangent impulses
    typename L::template Columns<4> surface;  // rolling impulse or load, separations, friction

    ISLET_LANE LaneManifolds(const ContactManifold* manifolds, const std::uint32_t* contact) {
        const float* words = reinterpret_cast<const float*>(manifolds) + manifold_head_words;
        L::template gather8<manifold_words>(words, contact, frame);
        L::template gather8<manifold_words>(words + 8, contact, points);
        L::template gather4<manifold_words>(words + 16, contact, surface);
    }
    ISLET_LANE LaneVec<F> normal() const { return {frame[0], frame[1]}; }
    ISLET_LANE LaneVec<F> offset() const { return {frame[2], frame[3]}; }
    ISLET_LANE LaneVec<F> rotation_a() const { return {frame[4], frame[5]}; }  // cosine, sine
    ISLET_LANE LaneVec<F> rotation_b() const { return {frame[6], frame[7]}; }
    ISLET_LANE LaneVec<F> anchor(std::uint32_t i) const { return {points[2 * i], points[2 * i + 1]}; }
    ISLET_LANE F normal_impulse(std::uint32_t i) const { return points[4 + i]; }
    ISLET_LANE F tangent_impulse(std::uint32_t i) const { return points[6 + i]; }
    ISLET_LANE F rolling_impulse() const { return surface[0]; }  // of special contacts
    ISLET_LANE F load() const { return surface[0]; }             // of the others
    ISLET_LANE F separation(std::uint32_t i) const { return surface[1 + i]; }
    ISLET_LANE F friction() const { return surface[3]; }
};

/// How the bodies of a block moved since its manifolds were made.
template <class L>
struct MotionSince {
    using F = typename L::F;
    F along;   // m, the centres apart along the normal
    F ca, sa;  // cosine - 1 and sine of what A has turned
    F cb, sb;  // and B

    ISLET_PART MotionSince(const LaneManifolds<L>& m, const Pose* poses, const std::uint32_t* body_a, const std::uint32_t* body_b) {
        typename L::template Columns<4> a, b;  // centre, cosine, sine
        L::template gather4<pose_words>(reinterpret_cast<const float*>(poses), body_a, a);
        L::template gather4<pose_words>(reinterpret_cast<const float*>(poses), body_b, b);
        const F one = L::splat(1.0f);
        const LaneVec<F> qa = {a[2], a[3]}, qb = {b[2], b[3]};
        along = dot(m.normal(), LaneVec<F>{b[0], b[1]} - LaneVec<F>{a[0], a[1]} - m.offset());
        ca = dot(m.rotation_a(), qa) - one;
        sa = cross(m.rotation_a(), qa);
        cb = dot(m.rotation_b(), qb) - one;
        sb = cross(m.rotation_b(), qb);
    }
    /// m, by which turning moved the two surfaces apart at a contact point.
    ISLET_LANE F by_turning(F rna, F rta, F rnb, F rtb) const { return (cb * rtb + sb * rnb) - (ca * rta + sa * rna); }
};

/// The arms of a contact point from both bodies (contact_rows.hpp).
template <class F>
struct PointArms {
    F rta, rna, rtb, rnb;
};

/// Fills a point's arms and effective masses. `usable` is the relaxation factor, and 0 in lanes without this point.
template <class L>
ISLET_PART void prepare_point(typename ContactRows<L::width>::Point& p, const BodyPair<L>& s, const PointArms<typename L::F>& r, typename L::F usable) {
    using F = typename L::F;
    const F zero = L::splat(0.0f);
    const F mass = s.ma + s.mb;
    const F k_normal = mass + s.ia * r.rna * r.rna + s.ib * r.rnb * r.rnb;
    const F k_tangent = mass + s.ia * r.rta * r.rta + s.ib * r.rtb * r.rtb;
    L::store(p.rta, r.rta);
    L::store(p.rna, r.rna);
    L::store(p.normal_mass, select(k_normal > zero, usable / k_normal, zero));
    L::store(p.tangent_mass, select(k_tangent > zero, usable / k_tangent, zero));
}

/// m/s: the normal velocity that a point will have when the surfaces meet, gravity and forces included. `speed` (m/s) is its normal velocity now, `gain`
/// (m/s^2) its rate of change, and `behind` (m) by how much the point's separation exceeds that of the contact's nearer point. A point that meets later in the
/// step bounces nearly by the speed that it has before the first one meets: of a body that lands a little tilted, both bounces together give back what a bounce
/// gives that is solved event by event.
///
/// To what comes out of free flight fast enough to bounce, a substep's gain is added, `free_gain` (m/s^2). In flight velocities change before positions do,
/// which conserves v^2 / 2 + g y - g h v / 2 instead of the energy (semi-implicit Euler; Hairer, Lubich and Wanner, Geometric Numerical Integration). So where
/// what falls is too slow by g h / 2, what rises is too fast by as much, and g h lies between them. (Without it, a ball with restitution 1 lost that speed in
/// every bounce, and 12 % of its half metre in five. What bore in the last step did not fly: an octagon on a floor would rock itself into hops.)
template <class L>
ISLET_PART typename L::F approach_of(const StepNumbers& n, typename L::F speed, typename L::F separation, typename L::F gain, typename L::F behind,
                                     typename L::F free_gain) {
    using F = typename L::F;
    const F zero = L::splat(0.0f);
    const F fastest = L::splat(-2.0f * n.max_speed);  // two bodies cannot meet faster, whatever pulls at them
    const F gap = max(separation, zero);
    const F time = select(speed < zero, min(gap / max(zero - speed, L::splat(1.0e-9f)), L::splat(n.dt)), zero);
    const F share = select(behind > L::splat(2.0f * linear_slop), L::splat(late_share), L::splat(1.0f));
    const F meeting = (speed + time * gain) * share;
    const F bounced = meeting + select(meeting < L::splat(-n.restitution_threshold), L::splat(n.h) * free_gain * share, zero);
    return select(bounced < fastest, fastest, bounced);
}

/// Fills the rolling row and returns the impulse that it starts from. A contact without rolling resistance starts from none, even if another contact of its
/// block has resistance, or this one had some in the last step.
template <class L>
ISLET_PART typename L::F prepare_rolling(ContactRows<L::width>& r, const BodyPair<L>& s, const StepNumbers& n, typename L::F old) {
    using F = typename L::F;
    const F zero = L::splat(0.0f);
    const F k_rolling = s.ia + s.ib;
    const auto rolls = L::load(r.rolling_resistance) > zero;
    const F impulse = select(rolls, L::splat(n.swept_warm) * old, zero);
    L::store(r.rolling_mass, select(k_rolling > zero, L::splat(n.omega) / k_rolling, zero));
    L::store(rolling_impulse_of(r), impulse);
    return impulse;
}

/// m/s^2: what gravity and forces add to the normal velocity of a block's bodies.
template <class L>
ISLET_PART typename L::F normal_gain(const PrepareInput& in, const ContactRows<L::width>& r, LaneVec<typename L::F> n) {
    using F = typename L::F;
    typename L::template Columns<8> a, b;
    L::template gather8<words_counted<L::width>>(reinterpret_cast<const float*>(in.motions), r.body_a, a);
    L::template gather8<words_counted<L::width>>(reinterpret_cast<const float*>(in.motions), r.body_b, b);
    return dot(n, LaneVec<F>{b[4], b[5]} - LaneVec<F>{a[4], a[5]}) * L::splat(in.numbers.inv_h);
}

/// What a block's impulses of the last step come to: on B along n and t, and on the spin of each body.
template <class F>
struct WarmStartSum {
    F along_n, along_t, turning_a, turning_b;
};

/// Fills the frame and the points of a block. Returns the impulses that the points start from.
template <class L>
ISLET_PART WarmStartSum<typename L::F> prepare_points(const PrepareInput& in, ContactRows<L::width>& r, const ContactLanes<L::width>& lanes,
                                                      const LaneManifolds<L>& m, const MotionSince<L>& since, const BodyPair<L>& s) {
    using F = typename L::F;
    const F zero = L::splat(0.0f);
    const F omega = L::splat(in.numbers.omega);
    const F warm = L::splat(in.numbers.swept_warm);
    const LaneVec<F> n = m.normal();
    const F rt_ab = zero - dot(n, m.offset()), rn_ab = zero - cross(m.offset(), n);
    if constexpr (L::width > 1) {
        L::store(r.nx, n.x);
        L::store(r.ny, n.y);
        L::store(r.friction, m.friction());
    }
    L::store(r.rt_ab, rt_ab);
    L::store(r.rn_ab, rn_ab);

    WarmStartSum<F> sum{zero, zero, zero, zero};
    for_points(r.two_points != 0, 0, [&](std::uint32_t i, auto is_first) ISLET_INLINED_LAMBDA {
        typename ContactRows<L::width>::Point& p = r.points[i];
        const F used = has_point<L>(lanes, i);
        const F rta = dot(n, m.anchor(i)), rna = cross(m.anchor(i), n);
        const F rtb = rta + rt_ab, rnb = rna + rn_ab;
        prepare_point<L>(p, s, {rta, rna, rtb, rnb}, used * omega);

        const F separation = m.separation(i) + since.along + since.by_turning(rna, rta, rnb, rtb);
        L::store(p.separation, separation);
        const F normal_impulse = used * warm * m.normal_impulse(i), tangent_impulse = used * warm * m.tangent_impulse(i);
        L::store(normal_impulse_of(r, i), normal_impulse);
        L::store(tangent_impulse_of(r, i), tangent_impulse);
        const F turning_a = rna * normal_impulse - rta * tangent_impulse, turning_b = rnb * normal_impulse - rtb * tangent_impulse;
        sum.along_n = is_first ? normal_impulse : sum.along_n + normal_impulse;
        sum.along_t = is_first ? tangent_impulse : sum.along_t + tangent_impulse;
        sum.turning_a = is_first ? turning_a : sum.turning_a + turning_a;
        sum.turning_b = is_first ? turning_b : sum.turning_b + turning_b;
    });
    return sum;
}

/// Notes how fast the surfaces will meet at each point of a block that has bouncing contacts.
template <class L>
ISLET_PART void prepare_bounce(const PrepareInput& in, ContactRows<L::width>& r, const ContactLanes<L::width>& lanes, const LaneManifolds<L>& m,
                               const BodyPair<L>& s) {
    using F = typename L::F;
    const LaneVec<F> n = m.normal();
    const F rn_ab = L::load(r.rn_ab);
    const F vn = dot(n, s.vb - s.va), gain = normal_gain<L>(in, r, n);
    F first = m.separation(0);
    if (r.two_points) first = select(has_point<L>(lanes, 1) > L::splat(0.0f), min(first, m.separation(1)), first);
    F bears = L::load(normal_impulse_of(r, 0));  // what the row starts from: without warm start nobody knows what bore
    if (r.two_points) bears = bears + L::load(normal_impulse_of(r, 1));
    const F zero = L::splat(0.0f), free_gain = is_positive(in.numbers.swept_warm) ? select(bears > zero, zero, gain) : zero;
    const std::uint32_t points = r.two_points ? 2 : 1;
    for (std::uint32_t i = 0; i < points; ++i) {
        const F rna = L::load(r.points[i].rna), rnb = rna + rn_ab;
        const F speed = vn + s.wb * rnb - s.wa * rna;
        note_approach<L>(in.numbers, r, i, approach_of<L>(in.numbers, speed, L::load(r.points[i].separation), gain, m.separation(i) - first, free_gain));
    }
}

/// Lets the shapes of two moving bodies count as overlapping by more than they do. A soft contact gives way by its load, so loaded shapes would overlap for
/// good. Most of what the load of the last seconds accounts for is undone; since that load is slow, the contact answers to motion as before. Where the shapes
/// overlap deeply, as in a crowd, more is undone in each step than by the spring alone. Both points get the same, by the mean of their depths: a contact that
/// is stiffer against leaning lets columns swing, and if the deeper point says how far both are pushed, what leans to and fro is pumped up. Floors are stiff
/// enough, and a contact with rolling resistance does not know its load. Without gravity all faces are level.
///
/// What deep overlaps get is the same in all substeps of a step, so it comes late: by itself it feeds the slow motions of arches, of clamped rows and of piles
/// under a piston, which the few sweeps of a step do not damp enough. It therefore answers to the depth that the shapes will have after the step if they go on
/// as they do. What comes together counts for at most twice its depth, so shapes that do not overlap yet are not pushed. Level faces get little enough to do
/// without. A light body under a heavy one would shake, so the share falls with the ratio of their masses.
///
/// A deep overlap gets no more than what the contact's impulses of the last substep account for: it is there to hold against what presses. Shapes that were
/// made to overlap, or that a long step let fall into each other, are pressed by little, and part as their springs say. (Without that bound a hundred balls in
/// a bin that grew by 5 % were thrown 3 m high. With half of it, crowds of compounds and of scrap stay deep, and pressed rows shake; compounds that are wedged
/// into each other would drive themselves less, since what is undone presses, too.)
template <class L>
ISLET_PART void undo_overlap(const StepNumbers& n, ContactRows<L::width>& r, const ContactLanes<L::width>& lanes, typename L::F load, const BodyPair<L>& s) {
    using F = typename L::F;
    const F zero = L::splat(0.0f), half = L::splat(0.5f);
    if constexpr (L::width == 1)
        if (!(is_positive(s.ma) && is_positive(s.mb))) return;
    F depth = zero - L::load(r.points[0].separation), rna = L::load(r.points[0].rna);
    F mass = L::load(r.points[0].normal_mass);
    if (r.two_points) mass = mass + select(has_point<L>(lanes, 1) > zero, L::load(r.points[1].normal_mass), zero);
    F give = L::splat(n.give_back) * load / mass;  // by which both points would sink under the load
    F from = L::splat(deep_from), share = L::splat(n.deep), ahead = L::splat(n.dt);
    if (r.sharing() != 0) [[unlikely]]
        give = sharers_of<L>(r) * give;
    if (r.is_special()) give = select(L::load(r.rolling_resistance) > zero, zero, give);
    if (r.two_points) {
        const auto two = has_point<L>(lanes, 1) > zero;
        const F tilt = L::load(normal_x(r)) * L::splat(n.up.y) - L::load(normal_y(r)) * L::splat(n.up.x);
        const auto level = two & (L::abs(tilt) < L::splat(level_tilt));
        depth = select(two, half * (depth - L::load(r.points[1].separation)), depth);
        rna = select(two, half * (rna + L::load(r.points[1].rna)), rna);
        from = select(level, L::splat(deep_level_from), from);
        share = select(level, L::splat(n.deep_level), share);
        ahead = select(level, zero, ahead);
    }
    F more = min(give, min(L::splat(8.0f) * max(depth, zero), L::splat(most_give)));  // a load that is gone pushes no shapes apart
    const F most = depth + max(depth, zero);
    if (L::positive(most - from) != 0) {  // else nothing is deep, however fast it comes
        const F parting = dot(LaneVec<F>{L::load(normal_x(r)), L::load(normal_y(r))}, s.vb - s.va) + (s.wb * (rna + L::load(r.rn_ab)) - s.wa * rna);
        const F soon = min(depth - ahead * parting, most);
        const F light = min(s.ma, s.mb), heavy = max(s.ma, s.mb);  // inverse masses
        share = share * min(L::splat(deep_masses) * light / max(heavy, L::splat(1.0e-37f)), L::splat(1.0f));
        F borne = L::splat(n.give_back * n.inv_h) * normal_impulses_of<L>(r) / mass;
        if (r.sharing() != 0) borne = sharers_of<L>(r) * borne;
        more = more + max(min(share * min(soon - from, L::splat(1.0f)), borne), zero);  // an image may hold impulses below 0
    }
    if constexpr (L::width > 1) more = select(min(s.ma, s.mb) > zero, more, zero);
    L::store(r.points[0].separation, L::load(r.points[0].separation) - more);
    if (r.two_points) L::store(r.points[1].separation, L::load(r.points[1].separation) - more);
}

/// Fills the rows of one block whose bodies and flags are known, and adds its warm start. `manifolds` and `poses` are what `lanes` counts from.
template <std::uint32_t W>
ISLET_PART void prepare_block(const PrepareInput& in, const ContactManifold* manifolds, const ContactLanes<W>& lanes, ContactRows<W>& r) {
    using L = LaneOf<W>;
    using F = typename L::F;
    const LaneManifolds<L> m(manifolds, lanes.contact);
    const MotionSince<L> since(m, in.poses, lanes.body_a, lanes.body_b);
    BodyPair<L> s;
    s.template gather<words_counted<W>>(in.bodies, r.body_a, r.body_b);
    WarmStartSum<F> start = prepare_points<L>(in, r, lanes, m, since, s);
    if (r.is_bouncy()) prepare_bounce<L>(in, r, lanes, m, s);
    undo_overlap<L>(in.numbers, r, lanes, m.load(), s);
    if (r.is_special()) {
        const F rolling = prepare_rolling<L>(r, s, in.numbers, m.rolling_impulse());
        start.turning_a = start.turning_a + rolling;
        start.turning_b = start.turning_b + rolling;
    }
    if constexpr (W == 1) s.template gather<words_counted<W>>(in.bodies, r.body_a, r.body_b);  // anew, rather than kept all the while
    s.template add_warm_start<words_counted<W>>(in.bodies, r.body_a, r.body_b, in_world(m.normal(), start.along_n, start.along_t), start.turning_a,
                                                start.turning_b);
}

/// ContactKernel::prepare, to be compiled with the caller's instructions.
template <std::uint32_t W>
ISLET_PART ContactKinds prepare_blocks(const PrepareInput& in, ContactRows<W>* rows, std::uint32_t count) {
    ContactKinds found;
    for (std::uint32_t block = 0; block < count; ++block) {
        ContactRows<W>& r = rows[block];
        ContactLanes<W> lanes;
        if (W > 1 && block + 1 < count) prefetch_manifolds(in, rows[block + 1]);
        name_bodies(in, r, lanes);
        prepare_block<W>(in, &manifold_of(r, 0, in.manifolds) - lanes.contact[0], lanes, r);
        found.note(r);
    }
    return found;
}

template <std::uint32_t W>
ContactKinds ContactKernel<W>::prepare(const PrepareInput& in, Rows* rows, std::uint32_t count) {
    return prepare_blocks<W>(in, rows, count);
}

template <std::uint32_t W>
void ContactKernel<W>::prepare_named(const PrepareInput& in, const ContactLanes<W>& lanes, Rows& r) {
    if constexpr (W > 1) prepare_block<W>(in, in.manifolds, lanes, r);
}

}  // namespace islet::detail
