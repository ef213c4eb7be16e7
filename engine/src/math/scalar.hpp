// The square root, the only floating-point function that the engine takes from the machine, and small functions on floats.
#pragma once

#include <cstdint>

#include "../math/inlining.hpp"
#include "islet/math.hpp"

namespace islet::detail {

/// IEEE square root, correctly rounded, so the same bits everywhere: one instruction on every target with a floating-point unit.
/// Never call it with a negative number: without -fno-math-errno the compiler leaves that case to the C library's sqrtf.
ISLET_ALWAYS_INLINE inline float sqrt(float a) { return root_of(a); }

/// length(a) for the loops over all bodies: without a call, unless the build is for size.
ISLET_ALWAYS_INLINE inline float length_inline(const Vec2& a) {
#if defined(__OPTIMIZE_SIZE__)
    return length(a);
#else
    return sqrt(dot(a, a));
#endif
}

/// a, but at most `bound` on either side.
#if defined(__OPTIMIZE_SIZE__)
ISLET_SHARED float within_bounds(float a, float bound) { return abs(a) > bound ? (a < 0 ? -bound : bound) : a; }  // one comparison, mostly
#else
inline float within_bounds(float a, float bound) { return clamp(a, -bound, bound); }  // without a branch
#endif

/// The squared lengths that a vector can be divided by: below, underflow has lost digits; above, the square has overflowed. NaN is outside, too.
inline constexpr float least_square = 1e-36f;
inline constexpr float largest_square = 3.402823466e+38f;

inline std::uint32_t bits_of(float a) { return __builtin_bit_cast(std::uint32_t, a); }

/// a > 0, of what is never NaN: a comparison of whole numbers costs least, above all without a floating-point unit.
inline bool is_positive(float a) { return __builtin_bit_cast(std::int32_t, a) > 0; }

/// An unsigned integer that sorts as the float does.
inline std::uint32_t sort_key(float a) {
    const std::uint32_t bits = bits_of(a);
    return (bits & 0x80000000u) != 0 ? ~bits : bits | 0x80000000u;
}

}  // namespace islet::detail
