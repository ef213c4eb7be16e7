// Bodies over a substep in vectors: the velocity of a body, x, y and the turn, is one of four lanes, and its way another. The fourth lane of each is some other
// number of the record, and stays as it is.
//
// Each function works through slots first <= i < end, and returns early at a slot whose velocity may exceed a limit. The caller does that one as for one lane
// (solver_bodies.hpp). Below the limits the arithmetic is the same, and so are the bits.
#pragma once

#include "../constraint/solver_body.hpp"
#include "../math/lanes.hpp"

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

/// The same two at a time (kernel_avx2.cpp), for processors with AVX2 alone.
std::uint32_t integrate_velocities_8(const VelocityVectors& all, std::uint32_t slot, std::uint32_t end_slot);
std::uint32_t integrate_positions_8(const WayVectors& all, std::uint32_t slot, std::uint32_t end_slot);

#endif

}  // namespace islet::detail
