// What differs between compilers: every attribute and built-in function that GCC and Clang have and others write differently. Microsoft's are from its
// documentation (C++ built-in attributes, compiler intrinsics). Its compiler has never read them: continuous integration reads them with Clang.
#pragma once

#include <cstdint>
#include <cstring>

#include "islet/standard.hpp"

#if defined(_MSC_VER) && !defined(__clang__)
#define ISLET_FOR_MSVC 1
#include <intrin.h>
#else
#define ISLET_FOR_MSVC 0
#endif

#if ISLET_FOR_MSVC
/// Before a function: copied into every caller.
#define ISLET_ALWAYS_INLINE [[msvc::forceinline]]
/// Before a function: one copy, which its callers call.
#define ISLET_NEVER_INLINE [[msvc::noinline]]
/// Before a function: hardly ever called.
#define ISLET_COLD
/// Behind the parameters of a lambda expression: copied into every caller.
#define ISLET_INLINED_LAMBDA
/// Behind the name of a type that is defined by typedef: its objects may lie where others do.
#define ISLET_MAY_ALIAS
/// A hint: never reached.
#define ISLET_UNREACHABLE() __assume(0)
/// Ends the program at once.
#define ISLET_TRAP() __fastfail(7)
/// A hint: the cache line at this address is needed soon.
#define ISLET_PREFETCH(address) ((void)(address))
/// memcpy, never a call for a few bytes.
#define ISLET_MEMCPY(to, from, bytes) std::memcpy(to, from, bytes)
#else
#define ISLET_ALWAYS_INLINE [[gnu::always_inline]]
#define ISLET_NEVER_INLINE [[gnu::noinline]]
#define ISLET_COLD [[gnu::cold]]
#define ISLET_INLINED_LAMBDA __attribute__((always_inline))
#define ISLET_MAY_ALIAS __attribute__((may_alias))
#define ISLET_UNREACHABLE() __builtin_unreachable()
#define ISLET_TRAP() __builtin_trap()
#define ISLET_PREFETCH(address) __builtin_prefetch(address)
#define ISLET_MEMCPY(to, from, bytes) __builtin_memcpy(to, from, bytes)
#endif

namespace islet::detail {

#if ISLET_FOR_MSVC
inline constexpr bool is_big_endian = false;

constexpr float magnitude_of(float a) { return __builtin_bit_cast(float, __builtin_bit_cast(std::uint32_t, a) & 0x7fffffffu); }
constexpr float with_sign_of(float a, float sign) {
    return __builtin_bit_cast(float, (__builtin_bit_cast(std::uint32_t, a) & 0x7fffffffu) | (__builtin_bit_cast(std::uint32_t, sign) & 0x80000000u));
}
#if defined(_M_X64) || defined(_M_IX86)
inline float root_of(float a) { return _mm_cvtss_f32(_mm_sqrt_ss(_mm_set_ss(a))); }
#else
inline float root_of(float a) { return vget_lane_f32(vsqrt_f32(vdup_n_f32(a)), 0); }
#endif
inline std::uint32_t swapped_bytes(std::uint32_t a) { return _byteswap_ulong(a); }
inline std::uint32_t trailing_zeros(std::uint32_t a) {
    unsigned long place = 0;
    _BitScanForward(&place, a);
    return place;
}
inline std::uint32_t leading_zeros(std::uint32_t a) {
    unsigned long place = 0;
    _BitScanReverse(&place, a);
    return 31u - place;
}
inline std::uint32_t trailing_zeros_of_long(std::uint64_t a) {
    const std::uint32_t low = static_cast<std::uint32_t>(a);
    return low != 0 ? trailing_zeros(low) : 32u + trailing_zeros(static_cast<std::uint32_t>(a >> 32));
}
#else
inline constexpr bool is_big_endian = __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__;

/// |a|
ISLET_ALWAYS_INLINE constexpr float magnitude_of(float a) { return __builtin_fabsf(a); }
/// |a|, or its negative if `sign` has the sign bit.
ISLET_ALWAYS_INLINE constexpr float with_sign_of(float a, float sign) { return __builtin_copysignf(a, sign); }
/// The square root, rounded as IEEE 754 says.
ISLET_ALWAYS_INLINE inline float root_of(float a) { return __builtin_sqrtf(a); }
/// The four bytes in the other order.
ISLET_ALWAYS_INLINE inline std::uint32_t swapped_bytes(std::uint32_t a) { return __builtin_bswap32(a); }
/// How many zeros are below the lowest one; a is not 0.
ISLET_ALWAYS_INLINE inline std::uint32_t trailing_zeros(std::uint32_t a) { return static_cast<std::uint32_t>(__builtin_ctz(a)); }
/// How many zeros are above the highest one; a is not 0.
ISLET_ALWAYS_INLINE inline std::uint32_t leading_zeros(std::uint32_t a) { return static_cast<std::uint32_t>(__builtin_clz(a)); }
/// trailing_zeros of 64 bits.
ISLET_ALWAYS_INLINE inline std::uint32_t trailing_zeros_of_long(std::uint64_t a) { return static_cast<std::uint32_t>(__builtin_ctzll(a)); }
#endif

}  // namespace islet::detail
