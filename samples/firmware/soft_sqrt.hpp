// The square root for processors without a floating-point unit.
#pragma once

#include <cstdint>

namespace firmware {

/// Correctly rounded, as IEEE 754 asks: the mantissa's root bit by bit, then rounded to nearest. (The root of a float never lies half way between two.)
inline float soft_sqrt(float a) {
    std::uint32_t bits = 0;
    __builtin_memcpy(&bits, &a, 4);
    if (bits << 1 == 0 || bits == 0x7f800000u) return a;  // +-0, infinity
    if (bits > 0x7f800000u) return __builtin_nanf("");    // below zero, or not a number
    auto exponent = static_cast<std::int32_t>(bits >> 23);
    std::uint32_t mantissa = bits & 0x007fffffu;
    if (exponent == 0) {
        const int shift = __builtin_clz(mantissa) - 8;  // a denormal number
        mantissa <<= shift;
        exponent = 1 - shift;
    } else {
        mantissa |= 0x00800000u;
    }
    exponent -= 127;
    if ((exponent & 1) != 0) {
        mantissa <<= 1;
        --exponent;
    }
    // 25 bits of the root of mantissa * 2^25: one more than are kept.
    std::uint32_t root = 0, rest = 0;
    for (int i = 0; i < 25; ++i) {
        rest = rest << 2 | (mantissa >> 23 & 3u);
        mantissa <<= 2;
        root <<= 1;
        if (rest > 2 * root) {
            rest -= 2 * root + 1;
            ++root;
        }
    }
    root = (root >> 1) + (root & 1u);
    bits = (static_cast<std::uint32_t>(exponent / 2 + 126) << 23) + root;  // the root's leading bit adds the last one to the exponent
    __builtin_memcpy(&a, &bits, 4);
    return a;
}

}  // namespace firmware
