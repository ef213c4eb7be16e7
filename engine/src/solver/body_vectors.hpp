// Bodies in vectors. Over a substep the velocity of a body, x, y and the turn, is one vector of four lanes, and its way another; the fourth lane of each is
// some other number of the record, and stays as it is. As a solve begins and ends each body is a lane.
//
// Each function works through slots first <= i < end, and returns early at a slot whose velocity may exceed a limit. The caller does that one as for one lane
// (solver_bodies.hpp). Below the limits the arithmetic is the same, and so are the bits.
#pragma once

#include <cstddef>

#include "../constraint/lane_vectors.hpp"
#include "../constraint/solver_body.hpp"
#include "../math/lanes.hpp"
#include "../math/scalar.hpp"

// Whether this build integrates bodies in vectors.
#if ISLET_MAX_LANES >= 4 && !ISLET_FOR_MSVC
#define ISLET_BODY_VECTORS 1
#else
#define ISLET_BODY_VECTORS 0
#endif

namespace islet::detail {

/// The velocities of all bodies, to be integrated.
struct VelocityVectors {
    SolverBody* bodies;
    SolverMotion* motions;
    float most, most_turn;  // m/s, rad/s: a body whose x, y and turn are within is not limited
    bool first;             // in the first substep
};

/// The ways of all bodies.
struct WayVectors {
    SolverBody* bodies;
    float most, most_turn;
    float h;  // s, substep
};

/// Where the bodies of a solve come from.
struct BodyInput {
    SolverBody* solved;
    SolverMotion* motions_solved;
    const PlanIndex* body_of;  // by slot
    const Pose* poses;
    const Motion* motions;
    Body* bodies;
    Vec2 gravity;  // m/s^2
    float h;       // s, substep
};

/// Where the bodies of a solve go.
struct BodyOutput {
    const SolverBody* bodies;
    const PlanIndex* body_of;  // by slot
    Pose* poses;
    Motion* motions;
    float square;    // m^2/s^2: a body whose squared speed is less is not limited
    float max_turn;  // rad/s
};

#if ISLET_BODY_VECTORS

/// One body at a time.
struct OneBody {
    using F = f4;
    static constexpr std::uint32_t count = 1, bits = 0x7;
    static constexpr i4 velocity = {-1, -1, -1, 0};
    ISLET_LANE static F load(const float* p, std::uint32_t) { return load4(p); }
    ISLET_LANE static void store(float* p, std::uint32_t, F a) { store4(p, a); }
    ISLET_LANE static F repeat(float x, float turn) { return F{x, x, turn, x}; }
    /// The damping factors of x, y and the turn, from the two halves of a SolverMotion.
    ISLET_LANE static F factors(F v_free, F a) { return __builtin_shufflevector(a, v_free, 3, 3, 7, 7); }
    ISLET_LANE static bool is_within(F a, F most) { return (mask_bits(Lane4::abs(a) <= most) & bits) == bits; }
};

#if defined(ISLET_AVX2)
/// Two bodies at a time, in files compiled for AVX2. `stride` is in floats.
struct TwoBodies {
    using F = f8;
    static constexpr std::uint32_t count = 2, bits = 0x77;
    static constexpr i8 velocity = {-1, -1, -1, 0, -1, -1, -1, 0};
    ISLET_LANE static F load(const float* p, std::uint32_t stride) {
        return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(p)), _mm_loadu_ps(p + stride), 1);
    }
    ISLET_LANE static void store(float* p, std::uint32_t stride, F a) {
        _mm_storeu_ps(p, _mm256_castps256_ps128(a));
        _mm_storeu_ps(p + stride, _mm256_extractf128_ps(a, 1));
    }
    ISLET_LANE static F repeat(float x, float turn) { return F{x, x, turn, x, x, x, turn, x}; }
    ISLET_LANE static F factors(F v_free, F a) { return _mm256_shuffle_ps(a, v_free, 0xff); }
    ISLET_LANE static bool is_within(F a, F most) { return (Lane8::bits(Lane8::abs(a) <= most) & bits) == bits; }
};
#endif

template <class V>
ISLET_LANE std::uint32_t integrate_vectors(const VelocityVectors& all, std::uint32_t slot, std::uint32_t end_slot) {
    using F = typename V::F;
    constexpr std::uint32_t stride = sizeof(SolverBody) / 4;  // and that of a SolverMotion
    static_assert(sizeof(SolverMotion) == sizeof(SolverBody));
    const F most = V::repeat(all.most, all.most_turn);
    for (; slot + V::count <= end_slot; slot += V::count) {
        auto* const body = reinterpret_cast<float*>(all.bodies + slot);
        auto* const motion = reinterpret_cast<float*>(all.motions + slot);
        const F v = V::load(body, stride), v_free = V::load(motion, stride), a = V::load(motion + 4, stride);
        const F free = V::factors(v_free, a) * (v + a);
        if (!V::is_within(free, most)) return slot;
        const F now = free + F{};
        V::store(motion, stride, select(V::velocity, now, v_free));
        if (all.first) {
            const F way = V::load(body + 4, stride);
            V::store(body, stride, select(V::velocity, now + way, v));
            V::store(body + 4, stride, select(V::velocity, F{}, way));
        } else {
            V::store(body, stride, select(V::velocity, now + (v - v_free), v));
        }
    }
    return slot;
}

template <class V>
ISLET_LANE std::uint32_t integrate_vectors(const WayVectors& all, std::uint32_t slot, std::uint32_t end_slot) {
    using F = typename V::F;
    constexpr std::uint32_t stride = sizeof(SolverBody) / 4;
    const F most = V::repeat(all.most, all.most_turn), h = V::repeat(all.h, all.h);
    for (; slot + V::count <= end_slot; slot += V::count) {
        auto* const body = reinterpret_cast<float*>(all.bodies + slot);
        const F v = V::load(body, stride), way = V::load(body + 4, stride);
        if (!V::is_within(v, most)) return slot;
        V::store(body + 4, stride, select(V::velocity, way + h * v, way));
    }
    return slot;
}

/// The bodies of a block of slots.
template <class L>
struct SlotLanes {
    std::uint32_t in_order[L::width];  // of the bodies in the solve
    std::uint32_t body[L::width];      // in the world

    ISLET_LANE SlotLanes() {
        for (std::uint32_t i = 0; i < L::width; ++i) in_order[i] = i;
    }
    ISLET_LANE void find(const PlanIndex* body_of) {
        for (std::uint32_t i = 0; i < L::width; ++i) body[i] = body_of[i];
    }
};

/// Reads velocities and masses, and what a substep adds to the velocities: all that read_body in solver_bodies.hpp does where nothing is lightened.
template <class L>
ISLET_LANE std::uint32_t read_bodies(const BodyInput& in, std::uint32_t slot, std::uint32_t end_slot) {
    using F = typename L::F;
    constexpr std::uint32_t body_words = sizeof(Body) / 4;
    static_assert(sizeof(Body) % 4 == 0 && offsetof(Body, angular_damping) == offsetof(Body, linear_damping) + 4 &&
                  offsetof(Body, gravity_scale) == offsetof(Body, linear_damping) + 8);
    const F zero = L::splat(0.0f), one = L::splat(1.0f), h = L::splat(in.h);
    SlotLanes<L> at;
    for (; slot + L::width <= end_slot; slot += L::width) {
        at.find(in.body_of + slot);
        typename L::template Columns<8> motion;
        typename L::template Columns<4> mass, body;  // masses, extent and flags; dampings, scale of gravity, threshold of sleep
        L::template gather8<motion_words>(reinterpret_cast<const float*>(in.motions), at.body, motion);
        L::template gather4<pose_words>(&in.poses->inv_mass, at.body, mass);
        L::template gather4<body_words>(&in.bodies->linear_damping, at.body, body);
        float stretches[L::width];
        for (std::uint32_t i = 0; i < L::width; ++i) {
            stretches[i] = in.bodies[at.body[i]].stretch;
            in.bodies[at.body[i]].stretch = 0;
        }
        const F inv_mass = mass[0], stretch = L::load(stretches);
        const F inv_inertia = select(stretch * mass[1] > one, one / stretch, mass[1]);
        const auto moves = inv_mass > zero;
        const auto gained = [&](float gravity, F force)
                                ISLET_INLINED_LAMBDA { return select(moves, h * (body[2] * L::splat(gravity) + inv_mass * force), zero); };
        const auto kept = [&](F damping) ISLET_INLINED_LAMBDA { return select(moves, one / (one + h * damping), one); };
        const F velocity[4] = {motion[0] + zero, motion[1] + zero, motion[2] + zero, inv_mass}, way[4] = {zero, zero, zero, inv_inertia};
        const F free[4] = {zero, zero, zero, kept(body[1])};
        const F gain[4] = {gained(in.gravity.x, motion[4]), gained(in.gravity.y, motion[5]), select(moves, h * (mass[1] * motion[6]), zero), kept(body[0])};
        auto* const out = reinterpret_cast<float*>(in.solved + slot);
        auto* const motion_out = reinterpret_cast<float*>(in.motions_solved + slot);
        L::template scatter4<slot_words>(out, at.in_order, velocity);
        L::template scatter4<slot_words>(out + 4, at.in_order, way);
        L::template scatter4<slot_words>(motion_out, at.in_order, free);
        L::template scatter4<slot_words>(motion_out + 4, at.in_order, gain);
    }
    return slot;
}

/// Writes velocities and poses to the world, and clears the forces. Returns early before a block of which some body is not within all limits.
template <class L>
ISLET_LANE std::uint32_t write_bodies(const BodyOutput& out, std::uint32_t slot, std::uint32_t end_slot) {
    using F = typename L::F;
    using V = LaneVec<F>;
    auto* const poses = reinterpret_cast<float*>(out.poses);
    auto* const motions = reinterpret_cast<float*>(out.motions);
    const F zero = L::splat(0.0f);
    SlotLanes<L> at;
    for (; slot + L::width <= end_slot; slot += L::width) {
        at.find(out.body_of + slot);
        typename L::template Columns<8> solved, pose, motion;
        L::template gather8<slot_words>(reinterpret_cast<const float*>(out.bodies + slot), at.in_order, solved);
        L::template gather8<pose_words>(poses, at.body, pose);
        L::template gather8<motion_words>(motions, at.body, motion);
        const V v = {solved[0], solved[1]}, dp = {solved[4], solved[5]}, q = {pose[2], pose[3]};
        const F w = solved[2], dq = solved[6];
        const V turned = turn<L>(dq, q);
        const F length = dot(turned, turned);
        const auto ordinary = (dot(v, v) < L::splat(out.square)) & (L::abs(w) <= L::splat(out.max_turn)) & (L::abs(dq) <= L::splat(0.5f * pi)) &
                              (L::abs(dp.x) + L::abs(dp.y) < L::splat(max_position)) & (length >= L::splat(least_square)) &
                              (length <= L::splat(largest_square));
        if (L::bits(ordinary) != (1u << L::width) - 1) return slot;

        const auto turns = L::abs(dq) > zero;
        const F most = L::splat(max_position), least = L::splat(-max_position), inv_length = L::splat(1.0f) / L::sqrt(length);
        const F new_pose[4] = {max(min(pose[0] + dp.x, most), least), max(min(pose[1] + dp.y, most), least), select(turns, inv_length * turned.x, q.x),
                               select(turns, inv_length * turned.y, q.y)};
        L::template scatter4<pose_words>(poses, at.body, new_pose);
        const F velocity[4] = {v.x + zero, v.y + zero, w, motion[3]}, force[4] = {zero, zero, zero, motion[7]};
        L::template scatter4<motion_words>(motions, at.body, velocity);
        L::template scatter4<motion_words>(motions + 4, at.body, force);
    }
    return slot;
}

/// The same two at a time, or eight (kernel_avx2.cpp), for processors with AVX2 alone.
std::uint32_t integrate_velocities_8(const VelocityVectors& all, std::uint32_t slot, std::uint32_t end_slot);
std::uint32_t integrate_positions_8(const WayVectors& all, std::uint32_t slot, std::uint32_t end_slot);
std::uint32_t read_bodies_8(const BodyInput& in, std::uint32_t slot, std::uint32_t end_slot);
std::uint32_t write_bodies_8(const BodyOutput& out, std::uint32_t slot, std::uint32_t end_slot);

#endif

}  // namespace islet::detail
