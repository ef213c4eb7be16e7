// Lanes: 1, 4, 8 or 16 floats that one operation computes at once. The solver's kernels are written once, over these types.
//
// A lane never sees another lane's value, and every operation is a single IEEE operation, so each width gives the same bits.
#pragma once

#include <cstdint>
#include <cstring>

#include "../math/inlining.hpp"
#include "../math/scalar.hpp"
#include "islet/config.hpp"
#include "islet/math.hpp"

#if defined(__SSE2__)
#include <immintrin.h>
#elif defined(__wasm_simd128__)
#include <wasm_simd128.h>
#endif

#if ISLET_MAX_LANES == 1
#define ISLET_LANE inline
#define ISLET_LANE_SHARED ISLET_SHARED
#else
#define ISLET_LANE ISLET_ALWAYS_INLINE inline
#define ISLET_LANE_SHARED ISLET_LANE
#endif

namespace islet::detail {

// One lane: the processor's own float.
using islet::max;
using islet::min;
ISLET_LANE float select(bool mask, float a, float b) { return mask ? a : b; }

struct Lane1 {
    using F = float;
    static constexpr std::uint32_t width = 1;
    ISLET_LANE static F splat(float a) { return a; }
    ISLET_LANE static F load(const float* p) { return *p; }
    ISLET_LANE static void store(float* p, F a) { *p = a; }
    ISLET_LANE static F sqrt(F a) { return detail::sqrt(a); }
    ISLET_LANE static F abs(F a) { return magnitude_of(a); }

    /// n columns of words, one record a lane. The columns of one record are the record itself.
    template <std::uint32_t n>
    using Columns = const float*;
    /// Column i of the output is word i of the records at base + stride * index[lane].
    template <std::uint32_t stride, class Index>
    ISLET_LANE static void gather8(const float* base, const Index* index, Columns<8>& out) {
        out = base + std::size_t{stride} * index[0];
    }
    template <std::uint32_t stride, class Index>
    ISLET_LANE static void gather4(const float* base, const Index* index, Columns<4>& out) {
        out = base + std::size_t{stride} * index[0];
    }
    /// Bit i is set if the comparison is true of lane i.
    ISLET_LANE static std::uint32_t bits(bool mask) { return mask ? 1u : 0u; }
    /// Bit i is set if lane i is above zero.
    ISLET_LANE static std::uint32_t positive(F a) { return bits(a > 0); }
};

// Four lanes by the compiler's vector extension: SSE2, NEON, wasm-simd128, or plain code where there is none.
#if !ISLET_FOR_MSVC
typedef float f4 __attribute__((vector_size(16)));
typedef int i4 __attribute__((vector_size(16)));

ISLET_LANE f4 select(i4 mask, f4 a, f4 b) { return reinterpret_cast<f4>((mask & reinterpret_cast<i4>(a)) | (~mask & reinterpret_cast<i4>(b))); }
#if defined(__SSE2__)
ISLET_LANE f4 min(f4 a, f4 b) { return _mm_min_ps(a, b); }  // a < b ? a : b, as for one lane
ISLET_LANE f4 max(f4 a, f4 b) { return _mm_max_ps(a, b); }
#elif defined(__wasm_simd128__)
// pmin(x, y) is y < x ? y : x, and pmax(x, y) is x < y ? y : x. (f32x4.min and f32x4.max order zeros and keep NaN, as one lane does not.)
ISLET_LANE f4 min(f4 a, f4 b) { return reinterpret_cast<f4>(wasm_f32x4_pmin(reinterpret_cast<v128_t>(b), reinterpret_cast<v128_t>(a))); }
ISLET_LANE f4 max(f4 a, f4 b) { return reinterpret_cast<f4>(wasm_f32x4_pmax(reinterpret_cast<v128_t>(b), reinterpret_cast<v128_t>(a))); }
#else
ISLET_LANE f4 min(f4 a, f4 b) { return select(a < b, a, b); }
ISLET_LANE f4 max(f4 a, f4 b) { return select(a > b, a, b); }
#endif

ISLET_LANE f4 load4(const float* p) {
    f4 a;
    std::memcpy(&a, p, 16);
    return a;
}
ISLET_LANE void store4(float* p, f4 a) { std::memcpy(p, &a, 16); }

/// Bit i is set if lane i of the comparison is true.
ISLET_LANE std::uint32_t mask_bits(i4 mask) {
#if defined(__SSE2__)
    return static_cast<std::uint32_t>(_mm_movemask_ps(reinterpret_cast<f4>(mask)));
#elif defined(__wasm_simd128__)
    return static_cast<std::uint32_t>(wasm_i32x4_bitmask(reinterpret_cast<v128_t>(mask)));
#else
    std::uint32_t bits = 0;
    for (std::uint32_t i = 0; i < 4; ++i) bits |= mask[i] != 0 ? 1u << i : 0u;
    return bits;
#endif
}

/// Two vectors, each as rotate() turns it.
ISLET_LANE f4 rotate_two(Rot q, f4 two) { return f4{q.c, q.c, q.c, q.c} * two + f4{-q.s, q.s, -q.s, q.s} * __builtin_shufflevector(two, two, 1, 0, 3, 2); }

ISLET_LANE void transpose4(f4 r0, f4 r1, f4 r2, f4 r3, f4* out) {
    const f4 a = __builtin_shufflevector(r0, r1, 0, 4, 1, 5);
    const f4 b = __builtin_shufflevector(r2, r3, 0, 4, 1, 5);
    const f4 c = __builtin_shufflevector(r0, r1, 2, 6, 3, 7);
    const f4 d = __builtin_shufflevector(r2, r3, 2, 6, 3, 7);
    out[0] = __builtin_shufflevector(a, b, 0, 1, 4, 5);
    out[1] = __builtin_shufflevector(a, b, 2, 3, 6, 7);
    out[2] = __builtin_shufflevector(c, d, 0, 1, 4, 5);
    out[3] = __builtin_shufflevector(c, d, 2, 3, 6, 7);
}

struct Lane4 {
    using F = f4;
    static constexpr std::uint32_t width = 4;
    ISLET_LANE static F splat(float a) { return F{a, a, a, a}; }
    ISLET_LANE static F load(const float* p) { return load4(p); }
    ISLET_LANE static void store(float* p, F a) { store4(p, a); }
    ISLET_LANE static F sqrt(F a) {
#if defined(__SSE2__)
        return _mm_sqrt_ps(a);
#elif defined(__wasm_simd128__)
        return reinterpret_cast<F>(wasm_f32x4_sqrt(reinterpret_cast<v128_t>(a)));
#else
        return F{detail::sqrt(a[0]), detail::sqrt(a[1]), detail::sqrt(a[2]), detail::sqrt(a[3])};
#endif
    }
    ISLET_LANE static F abs(F a) { return reinterpret_cast<F>(reinterpret_cast<i4>(a) & 0x7fffffff); }
    ISLET_LANE static F with_sign_of(F a, F sign) {
        return reinterpret_cast<F>((reinterpret_cast<i4>(a) & 0x7fffffff) | (reinterpret_cast<i4>(sign) & ~0x7fffffff));
    }

    template <std::uint32_t n>
    using Columns = F[n];
    template <std::uint32_t stride>
    ISLET_LANE static void gather8(const float* base, const std::uint32_t* index, F out[8]) {
        const float* p[4];
        for (int i = 0; i < 4; ++i) p[i] = base + std::size_t{stride} * index[i];
        transpose4(load4(p[0]), load4(p[1]), load4(p[2]), load4(p[3]), out);
        transpose4(load4(p[0] + 4), load4(p[1] + 4), load4(p[2] + 4), load4(p[3] + 4), out + 4);
    }
    template <std::uint32_t stride>
    ISLET_LANE static void gather4(const float* base, const std::uint32_t* index, F out[4]) {
        const float* p[4];
        for (int i = 0; i < 4; ++i) p[i] = base + std::size_t{stride} * index[i];
        transpose4(load4(p[0]), load4(p[1]), load4(p[2]), load4(p[3]), out);
    }
    /// Writes four columns back to the first four words of each record.
    template <std::uint32_t stride>
    ISLET_LANE static void scatter4(float* base, const std::uint32_t* index, const F in[4]) {
        f4 r[4];
        transpose4(in[0], in[1], in[2], in[3], r);
        for (int i = 0; i < 4; ++i) store4(base + std::size_t{stride} * index[i], r[i]);
    }
    /// The same, only for records whose bit is set.
    template <std::uint32_t stride>
    ISLET_LANE static void scatter4_where(std::uint32_t bits, float* base, const std::uint32_t* index, const F in[4]) {
        f4 r[4];
        transpose4(in[0], in[1], in[2], in[3], r);
        for (std::uint32_t i = 0; i < 4; ++i)
            if ((bits >> i & 1u) != 0) store4(base + std::size_t{stride} * index[i], r[i]);
    }
    ISLET_LANE static std::uint32_t bits(i4 mask) { return mask_bits(mask); }
    /// The lanes whose bits are set.
    ISLET_LANE static i4 mask(std::uint32_t bits) { return (static_cast<std::int32_t>(bits) & i4{1, 2, 4, 8}) != 0; }
    /// Writes the numbers of the set bits, counted from `first`, in order. Returns how many there are.
    ISLET_LANE static std::uint32_t list(std::uint32_t bits, std::uint32_t first, std::uint32_t* out) {
        std::uint32_t count = 0;
        for (; bits != 0; bits &= bits - 1) out[count++] = first + trailing_zeros(bits);
        return count;
    }
    ISLET_LANE static std::uint32_t positive(F a) { return bits(a > F{}); }
};

#if defined(ISLET_AVX2)
// Eight lanes, for files compiled with AVX2 alone (math/avx2.hpp).
typedef float f8 __attribute__((vector_size(32)));
typedef int i8 __attribute__((vector_size(32)));

ISLET_LANE f8 select(i8 mask, f8 a, f8 b) { return _mm256_blendv_ps(b, a, reinterpret_cast<f8>(mask)); }
ISLET_LANE f8 min(f8 a, f8 b) { return _mm256_min_ps(a, b); }
ISLET_LANE f8 max(f8 a, f8 b) { return _mm256_max_ps(a, b); }

/// Of each byte: the places of the bits that are set in it, in order.
struct SetBits {
    std::uint8_t places[256][8] = {};

    constexpr SetBits() {
        for (std::uint32_t byte = 0; byte < 256; ++byte)
            for (std::uint32_t place = 0, count = 0; place < 8; ++place)
                if ((byte >> place & 1u) != 0) places[byte][count++] = static_cast<std::uint8_t>(place);
    }
};
inline constexpr SetBits set_bits;

struct Lane8 {
    using F = f8;
    static constexpr std::uint32_t width = 8;
    ISLET_LANE static F splat(float a) { return _mm256_set1_ps(a); }
    ISLET_LANE static F load(const float* p) { return _mm256_loadu_ps(p); }
    ISLET_LANE static void store(float* p, F a) { _mm256_storeu_ps(p, a); }
    ISLET_LANE static F sqrt(F a) { return _mm256_sqrt_ps(a); }
    ISLET_LANE static F abs(F a) { return reinterpret_cast<F>(reinterpret_cast<i8>(a) & 0x7fffffff); }
    ISLET_LANE static F with_sign_of(F a, F sign) {
        return reinterpret_cast<F>((reinterpret_cast<i8>(a) & 0x7fffffff) | (reinterpret_cast<i8>(sign) & ~0x7fffffff));
    }

    template <std::uint32_t n>
    using Columns = F[n];
    template <std::uint32_t stride>
    ISLET_LANE static void gather8(const float* base, const std::uint32_t* index, F out[8]) {
        gather4<stride>(base, index, out);
        gather4<stride>(base + 4, index, out + 4);
    }
    template <std::uint32_t stride>
    ISLET_LANE static void gather4(const float* base, const std::uint32_t* index, F out[4]) {
        // Rows i and i + 4 share a register, so two 4 x 4 transpositions side by side remain.
        f8 r[4];
        for (int i = 0; i < 4; ++i) {
            const float* p = base + std::size_t{stride} * index[i];
            const float* q = base + std::size_t{stride} * index[i + 4];
            r[i] = _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(p)), _mm_loadu_ps(q), 1);
        }
        transpose(r, out);
    }
    template <std::uint32_t stride>
    ISLET_LANE static void scatter4(float* base, const std::uint32_t* index, const F in[4]) {
        f8 r[4];
        transpose(in, r);
        for (int i = 0; i < 4; ++i) {
            _mm_storeu_ps(base + std::size_t{stride} * index[i], _mm256_castps256_ps128(r[i]));
            _mm_storeu_ps(base + std::size_t{stride} * index[i + 4], _mm256_extractf128_ps(r[i], 1));
        }
    }
    template <std::uint32_t stride>
    ISLET_LANE static void scatter4_where(std::uint32_t bits, float* base, const std::uint32_t* index, const F in[4]) {
        f8 r[4];
        transpose(in, r);
        for (std::uint32_t i = 0; i < 4; ++i) {
            if ((bits >> i & 1u) != 0) _mm_storeu_ps(base + std::size_t{stride} * index[i], _mm256_castps256_ps128(r[i]));
            if ((bits >> i & 16u) != 0) _mm_storeu_ps(base + std::size_t{stride} * index[i + 4], _mm256_extractf128_ps(r[i], 1));
        }
    }
    /// Without a branch for each bit. `out` has room for eight numbers, whatever the bits.
    ISLET_LANE static std::uint32_t list(std::uint32_t bits, std::uint32_t first, std::uint32_t* out) {
        const __m128i places = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(set_bits.places[bits]));
        const __m256i numbers = _mm256_add_epi32(_mm256_cvtepu8_epi32(places), _mm256_set1_epi32(static_cast<int>(first)));
        _mm256_storeu_si256(reinterpret_cast<__m256i*>(out), numbers);
        return static_cast<std::uint32_t>(__builtin_popcount(bits));
    }
    ISLET_LANE static i8 mask(std::uint32_t bits) { return (static_cast<std::int32_t>(bits) & i8{1, 2, 4, 8, 16, 32, 64, 128}) != 0; }
    ISLET_LANE static std::uint32_t bits(i8 mask) { return static_cast<std::uint32_t>(_mm256_movemask_ps(reinterpret_cast<f8>(mask))); }
    ISLET_LANE static std::uint32_t positive(F a) { return bits(a > F{}); }

private:
    ISLET_LANE static void transpose(const f8 r[4], f8 out[4]) {
        const f8 a = _mm256_unpacklo_ps(r[0], r[1]);
        const f8 b = _mm256_unpacklo_ps(r[2], r[3]);
        const f8 c = _mm256_unpackhi_ps(r[0], r[1]);
        const f8 d = _mm256_unpackhi_ps(r[2], r[3]);
        out[0] = _mm256_shuffle_ps(a, b, 0x44);
        out[1] = _mm256_shuffle_ps(a, b, 0xee);
        out[2] = _mm256_shuffle_ps(c, d, 0x44);
        out[3] = _mm256_shuffle_ps(c, d, 0xee);
    }
};
#endif

#if defined(ISLET_AVX512)
// Sixteen lanes, for files compiled with AVX-512 alone (math/avx512.hpp).
typedef float f16 __attribute__((vector_size(64)));
typedef int i16 __attribute__((vector_size(64)));

// (The plain functions of these names begin from an undefined register, at which GCC 12 warns.)
ISLET_LANE f16 select(i16 mask, f16 a, f16 b) { return mask ? a : b; }
ISLET_LANE f16 min(f16 a, f16 b) { return _mm512_maskz_min_ps(0xffff, a, b); }
ISLET_LANE f16 max(f16 a, f16 b) { return _mm512_maskz_max_ps(0xffff, a, b); }

struct Lane16 {
    using F = f16;
    static constexpr std::uint32_t width = 16;
    ISLET_LANE static F splat(float a) { return _mm512_set1_ps(a); }
    ISLET_LANE static F load(const float* p) { return _mm512_loadu_ps(p); }
    ISLET_LANE static void store(float* p, F a) { _mm512_storeu_ps(p, a); }
    ISLET_LANE static F sqrt(F a) { return _mm512_maskz_sqrt_ps(0xffff, a); }
    ISLET_LANE static F abs(F a) { return reinterpret_cast<F>(reinterpret_cast<i16>(a) & 0x7fffffff); }

    template <std::uint32_t n>
    using Columns = F[n];
    template <std::uint32_t stride>
    ISLET_LANE static void gather8(const float* base, const std::uint32_t* index, F out[8]) {
        // The halves of rows i, i + 4, i + 8 and i + 12 share a register each, so four 4 x 4 transpositions side by side remain of each half.
        f16 low[4], high[4];
        for (int i = 0; i < 4; ++i) {
            const auto two_rows = [&](int a, int b) ISLET_INLINED_LAMBDA {
                return __builtin_shufflevector(_mm256_loadu_ps(base + std::size_t{stride} * index[a]), _mm256_loadu_ps(base + std::size_t{stride} * index[b]),
                                               0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
            };
            const f16 a = two_rows(i, i + 4), b = two_rows(i + 8, i + 12);
            low[i] = _mm512_maskz_shuffle_f32x4(0xffff, a, b, 0x88);
            high[i] = _mm512_maskz_shuffle_f32x4(0xffff, a, b, 0xdd);
        }
        transpose(low, out);
        transpose(high, out + 4);
    }
    template <std::uint32_t stride>
    ISLET_LANE static void gather4(const float* base, const std::uint32_t* index, F out[4]) {
        // Rows i, i + 4, i + 8 and i + 12 share a register, so four 4 x 4 transpositions side by side remain.
        f16 r[4];
        for (int i = 0; i < 4; ++i) {
            const auto row = [&](int at) ISLET_INLINED_LAMBDA { return load4(base + std::size_t{stride} * index[at]); };
            r[i] = __builtin_shufflevector(__builtin_shufflevector(row(i), row(i + 4), 0, 1, 2, 3, 4, 5, 6, 7),
                                           __builtin_shufflevector(row(i + 8), row(i + 12), 0, 1, 2, 3, 4, 5, 6, 7), 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12,
                                           13, 14, 15);
        }
        transpose(r, out);
    }
    template <std::uint32_t stride>
    ISLET_LANE static void scatter4(float* base, const std::uint32_t* index, const F in[4]) {
        scatter4_where<stride>(0xffff, base, index, in);
    }
    template <std::uint32_t stride>
    ISLET_LANE static void scatter4_where(std::uint32_t bits, float* base, const std::uint32_t* index, const F in[4]) {
        f16 r[4];
        transpose(in, r);
        for (std::uint32_t i = 0; i < 4; ++i) {
            const auto put = [&](std::uint32_t at, f4 row) ISLET_INLINED_LAMBDA {
                if ((bits >> at & 1u) != 0) store4(base + std::size_t{stride} * index[at], row);
            };
            put(i, __builtin_shufflevector(r[i], r[i], 0, 1, 2, 3));
            put(i + 4, __builtin_shufflevector(r[i], r[i], 4, 5, 6, 7));
            put(i + 8, __builtin_shufflevector(r[i], r[i], 8, 9, 10, 11));
            put(i + 12, __builtin_shufflevector(r[i], r[i], 12, 13, 14, 15));
        }
    }
    ISLET_LANE static std::uint32_t bits(i16 mask) { return _mm512_movepi32_mask(reinterpret_cast<__m512i>(mask)); }
    ISLET_LANE static std::uint32_t positive(F a) { return _mm512_cmp_ps_mask(a, F{}, _CMP_GT_OQ); }

private:
    ISLET_LANE static void transpose(const f16 r[4], f16 out[4]) {
        const f16 a = _mm512_maskz_unpacklo_ps(0xffff, r[0], r[1]);
        const f16 b = _mm512_maskz_unpacklo_ps(0xffff, r[2], r[3]);
        const f16 c = _mm512_maskz_unpackhi_ps(0xffff, r[0], r[1]);
        const f16 d = _mm512_maskz_unpackhi_ps(0xffff, r[2], r[3]);
        out[0] = _mm512_maskz_shuffle_ps(0xffff, a, b, 0x44);
        out[1] = _mm512_maskz_shuffle_ps(0xffff, a, b, 0xee);
        out[2] = _mm512_maskz_shuffle_ps(0xffff, c, d, 0x44);
        out[3] = _mm512_maskz_shuffle_ps(0xffff, c, d, 0xee);
    }
};
#endif
#endif  // !ISLET_FOR_MSVC

template <std::uint32_t width>
struct LanesByWidth;
template <>
struct LanesByWidth<1> {
    using Type = Lane1;
};
#if !ISLET_FOR_MSVC
template <>
struct LanesByWidth<4> {
    using Type = Lane4;
};
#endif
#if defined(ISLET_AVX2)
template <>
struct LanesByWidth<8> {
    using Type = Lane8;
};
#endif
#if defined(ISLET_AVX512)
template <>
struct LanesByWidth<16> {
    using Type = Lane16;
};
#endif

/// The lanes of a width.
template <std::uint32_t width>
using LaneOf = typename LanesByWidth<width>::Type;

}  // namespace islet::detail
