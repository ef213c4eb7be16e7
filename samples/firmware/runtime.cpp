// All that the engine asks of a C library: five functions. Small rather than fast; a firmware that has a C library uses that one's.
#include <cstddef>
#include <cstdint>

typedef std::uint32_t Word __attribute__((may_alias));

extern "C" {

void* memcpy(void* to, const void* from, std::size_t n) {
    auto* t = static_cast<unsigned char*>(to);
    const auto* f = static_cast<const unsigned char*>(from);
    // Whole words where both begin on one, which the engine's records do.
    if (((reinterpret_cast<std::uintptr_t>(t) | reinterpret_cast<std::uintptr_t>(f)) & 3u) == 0) {
        for (; n >= 4; n -= 4, t += 4, f += 4) *reinterpret_cast<Word*>(t) = *reinterpret_cast<const Word*>(f);
    }
    for (; n != 0; --n) *t++ = *f++;
    return to;
}

void* memmove(void* to, const void* from, std::size_t n) {
    auto* t = static_cast<unsigned char*>(to);
    const auto* f = static_cast<const unsigned char*>(from);
    if (reinterpret_cast<std::uintptr_t>(t) <= reinterpret_cast<std::uintptr_t>(f)) return memcpy(to, from, n);
    for (; n != 0; --n) t[n - 1] = f[n - 1];
    return to;
}

void* memset(void* to, int value, std::size_t n) {
    auto* t = static_cast<unsigned char*>(to);
    const auto byte = static_cast<unsigned char>(value);
    if ((reinterpret_cast<std::uintptr_t>(t) & 3u) == 0) {
        for (; n >= 4; n -= 4, t += 4) *reinterpret_cast<Word*>(t) = byte * 0x01010101u;
    }
    for (; n != 0; --n) *t++ = byte;
    return to;
}

int memcmp(const void* a, const void* b, std::size_t n) {
    const auto* x = static_cast<const unsigned char*>(a);
    const auto* y = static_cast<const unsigned char*>(b);
    for (; n != 0; --n, ++x, ++y)
        if (*x != *y) return *x < *y ? -1 : 1;
    return 0;
}

#if (defined(__arm__) && !defined(__ARM_FP)) || (defined(__riscv) && !defined(__riscv_flen))
// Without a floating-point unit: the root of the mantissa bit by bit, rounded to nearest. (The root of a float is never half way between two floats.)
float sqrtf(float a) {
    std::uint32_t bits = 0;
    __builtin_memcpy(&bits, &a, 4);
    if (bits << 1 == 0 || bits == 0x7f800000u) return a;       // +-0, infinity
    if (bits > 0x7f800000u) return (a - a) / (a - a);          // below zero, or not a number
    std::int32_t exponent = static_cast<std::int32_t>(bits >> 23);
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
#endif
}
