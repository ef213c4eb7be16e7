// Contacts that are as before: when an update only keeps their manifolds. step/recycling.hpp asks that of one contact, keep_settled of several in lanes: by
// the same arithmetic, operation by operation, so that no manifold is kept that one lane would not keep.
#pragma once

#include <cstring>

#include "../collide/manifold.hpp"
#include "../constraint/lane_vectors.hpp"
#include "../data/records.hpp"
#include "../math/lanes.hpp"

namespace islet::detail {

inline constexpr float recycle_distance = 2.0f * linear_slop;  // m that the surfaces may slip before a manifold is made anew
inline constexpr float most_load = 1.0e28f;                    // N; a contact whose load would be more forgets it
inline constexpr float recycle_turn = 0.1f;                    // rad that a body may turn before a manifold is made anew
inline constexpr float least_lag = 0.001f;                     // rad that a manifold may lag behind two bodies that turn
inline constexpr float turn_rate = 0.015f;                     // rad/s of bodies with which a manifold turns: at a body that is not dynamic
inline constexpr float level_turn_rate = 0.05f;                // of two bodies that meet with one level face; card houses fall if it is less

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
inline constexpr std::uint32_t asked_flags = settled_flags | contact_sensor | contact_asks | contact_one_way | contact_ahead | contact_untold | contact_rolls;

/// Where the contacts of a world and their bodies are, and how they are kept.
struct ContactsToKeep {
    ContactManifold* manifolds;
    const Contact* contacts;
    const Pose* poses;
    const Motion* motions;
    const Aabb* boxes;  // by shape
    float widest_box;   // m; a shape with a wider one may be endless
    LoadRate rate;
    bool follows_deep;
};

template <class F>
ISLET_LANE LaneVec<F> turned_in_lanes(LaneVec<F> q, LaneVec<F> v) {  // q: cosine, sine
    return {q.x * v.x - q.y * v.y, q.y * v.x + q.x * v.y};
}
template <class F>
ISLET_LANE LaneVec<F> turn_between(LaneVec<F> from, LaneVec<F> to) {
    return {from.x * to.x + from.y * to.y, from.x * to.y - from.y * to.x};
}

/// A bit for each lane whose surfaces have slipped by less than the root of `most` at a point, but for what they are pressed into each other where they may be.
template <class L, class F = typename L::F>
ISLET_LANE std::uint32_t slips_little(LaneVec<F> anchor, LaneVec<F> normal, LaneVec<F> shift, LaneVec<F> apart, F size, F most, std::uint32_t pressed) {
    const LaneVec<F> slip = shift + turned_in_lanes(apart, anchor);
    const F way = dot(slip, slip), sunk = clamp_lanes<L>(dot(slip, normal), L::splat(-0.5f) * size, L::splat(0));
    return L::bits(way <= most) | (pressed & L::bits(way - sunk * sunk <= most));
}

/// A bit for each contact whose boxes meet, and are none of an endless shape.
template <class L>
ISLET_LANE std::uint32_t boxes_meet(const ContactsToKeep& in, const std::uint32_t* contact) {
    std::uint32_t shape_a[L::width], shape_b[L::width];
    for (std::uint32_t i = 0; i < L::width; ++i) {
        shape_a[i] = in.contacts[contact[i]].shape_a;
        shape_b[i] = in.contacts[contact[i]].shape_b;
    }
    typename L::template Columns<4> a, b;  // lower, upper
    L::template gather4<sizeof(Aabb) / 4>(reinterpret_cast<const float*>(in.boxes), shape_a, a);
    L::template gather4<sizeof(Aabb) / 4>(reinterpret_cast<const float*>(in.boxes), shape_b, b);
    return L::bits(a[0] <= b[2]) & L::bits(b[0] <= a[2]) & L::bits(a[1] <= b[3]) & L::bits(b[1] <= a[3]) & L::bits(a[2] - a[0] <= L::splat(in.widest_box));
}

/// A bit for each contact whose manifold may turn with its two bodies (turn_along), if it lags. `moving`: a bit for each whose bodies can both move.
template <class L>
ISLET_LANE std::uint32_t turn_together(const Motion* motions, const std::uint32_t* body_a, const std::uint32_t* body_b, std::uint32_t moving) {
    float of_a[L::width], of_b[L::width];
    for (std::uint32_t i = 0; i < L::width; ++i) {
        of_a[i] = motions[body_a[i]].w;
        of_b[i] = motions[body_b[i]].w;
    }
    const auto wa = L::load(of_a), wb = L::load(of_b), slower = min(L::abs(wa), L::abs(wb));
    return L::positive(wa * wb) & (L::bits(slower > L::splat(level_turn_rate)) | (L::bits(slower > L::splat(turn_rate)) & ~moving));
}

/// Keeps those contacts that are settled, as many as there are lanes: the loads of those that touch follow. Returns a bit for each that is kept. None is that
/// has rolling resistance or a tangent speed, whose boxes changed and meet no more, or, if `follows_deep`, that has sunk deep into a floor.
template <class L>
ISLET_LANE std::uint32_t keep_settled(const ContactsToKeep& in, const std::uint32_t* contact) {
    constexpr std::uint32_t W = L::width;
    ContactManifold* const manifolds = in.manifolds;
    const Pose* const poses = in.poses;
    using F = typename L::F;
    using I = decltype(F{} < F{});
    using Vec = LaneVec<F>;
    constexpr std::uint32_t manifold_stride = sizeof(ContactManifold) / 4, pose_stride = sizeof(Pose) / 4;
    typename L::template Columns<4> head, surface;        // bodies, flags, ids; load, separations, friction
    typename L::template Columns<8> frame, points, a, b;  // normal, offset, rotations; anchors, impulses; poses
    const float* const words = reinterpret_cast<const float*>(manifolds);
    L::template gather4<manifold_stride>(words, contact, head);
    const I flags = reinterpret_cast<I>(head[2]);
    const I asked = flags & static_cast<std::int32_t>(asked_flags | contact_special);
    const std::uint32_t two = L::bits((flags & static_cast<std::int32_t>(2u << contact_count_shift)) != 0);
    const std::uint32_t none = L::bits((flags & static_cast<std::int32_t>(3u << contact_count_shift)) == 0);
    std::uint32_t touching = L::bits(asked == static_cast<std::int32_t>(settled_flags)) & ~none;
    std::uint32_t apart = L::bits(asked == static_cast<std::int32_t>(apart_flags)) & none;
    if ((touching | apart) == 0) return 0;
    std::uint32_t body_a[W], body_b[W];
    std::memcpy(body_a, &head[0], sizeof body_a);
    std::memcpy(body_b, &head[1], sizeof body_b);
    L::template gather8<pose_stride>(reinterpret_cast<const float*>(poses), body_a, a);
    L::template gather8<pose_stride>(reinterpret_cast<const float*>(poses), body_b, b);
    L::template gather8<manifold_stride>(words + 4, contact, frame);
    L::template gather8<manifold_stride>(words + 12, contact, points);
    L::template gather4<manifold_stride>(words + 20, contact, surface);
    const I states = reinterpret_cast<I>(a[7]) | reinterpret_cast<I>(b[7]);
    apart &= L::bits((states & static_cast<std::int32_t>(pose_fast)) == 0);
    std::uint32_t kept = (touching | apart) & L::bits((states & static_cast<std::int32_t>(pose_learns)) == 0);
    const std::uint32_t moved = kept & L::bits((states & static_cast<std::int32_t>(pose_moved)) != 0);
    if (moved != 0) kept &= boxes_meet<L>(in, contact) | ~moved;

    const Vec turn_a = turn_between(Vec{frame[4], frame[5]}, Vec{a[2], a[3]}), turn_b = turn_between(Vec{frame[6], frame[7]}, Vec{b[2], b[3]});
    const F turned_a = L::abs(turn_a.y), turned_b = L::abs(turn_b.y);
    kept &= L::bits(min(turn_a.x, turn_b.x) >= L::splat(0)) & L::bits(max(turned_a, turned_b) <= L::splat(recycle_turn));
    const Vec way = Vec{b[0], b[1]} - Vec{a[0], a[1]}, offset = {frame[2], frame[3]};

    const std::uint32_t moving = L::positive(min(a[4], b[4]));
    const std::uint32_t lag = touching & kept & L::bits(turned_a > L::splat(least_lag));
    if (lag != 0) touching &= ~(lag & turn_together<L>(in.motions, body_a, body_b, moving));
    const F turn = L::abs(turn_b.y * turn_a.x - turn_b.x * turn_a.y);
    const F size = min(a[6], b[6]);
    const F reach = L::splat(recycle_distance) - L::splat(2.0f) * size * turn;
    const F most = reach * reach;
    touching &= L::positive(reach);
    const Vec shift = way - turned_in_lanes(turn_b, offset);
    const Vec turned = turn_b - turn_a, normal = {frame[0], frame[1]};
    const std::uint32_t pressed = two & moving;  // faces of moving bodies
    touching &= slips_little<L>(Vec{points[0], points[1]}, normal, shift, turned, size, most, pressed) &
                (slips_little<L>(Vec{points[2], points[3]}, normal, shift, turned, size, most, pressed) | ~two);

    if (apart != 0) {
        const Vec moved_apart = way - offset;
        const F room = L::splat(0.5f * speculative_distance) - a[6] * turned_a - b[6] * turned_b;
        apart &= L::positive(room) & L::bits(dot(moved_apart, moved_apart) < room * room);
    }
    kept &= touching | apart;
    if (in.follows_deep) kept &= moving | L::bits(min(surface[1], surface[2]) >= L::splat(sunk_from));

    const F load = L::splat(in.rate.keep) * surface[0] + L::splat(in.rate.gain) * (points[4] + points[5]);
    const F followed = select((load >= L::splat(0)) & (load < L::splat(most_load)), load, L::splat(0));
    float loads[W];
    L::store(loads, followed);
    for (std::uint32_t i = 0; i < W; ++i)
        if ((kept & touching) >> i & 1u) manifolds[contact[i]].load = loads[i];
    return kept;
}

/// The same of four contacts (kernel_scalar.cpp), and of eight (kernel_avx2.cpp), for processors with AVX2 alone.
std::uint32_t keep_settled_4(const ContactsToKeep& in, const std::uint32_t* contact);
std::uint32_t keep_settled_8(const ContactsToKeep& in, const std::uint32_t* contact);

}  // namespace islet::detail
