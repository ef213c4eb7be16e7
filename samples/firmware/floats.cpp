#include "floats.hpp"

#if defined(__arm__) || defined(__riscv)
extern "C" float sqrtf(float a);
#else
#include <cmath>
#endif

namespace firmware {
namespace {

float float_of(std::uint32_t bits) {
    float a = 0;
    __builtin_memcpy(&a, &bits, 4);
    return a;
}

std::uint32_t bits_of(float a) {
    if (a != a) return 0x7fc00000u;
    std::uint32_t bits = 0;
    __builtin_memcpy(&bits, &a, 4);
    return bits;
}

}  // namespace

std::uint64_t hash_floats(std::uint32_t count) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    const auto add = [&](std::uint32_t word) { hash = (hash ^ word) * 0x100000001b3u; };  // FNV-1a, by words
    std::uint32_t seed = 1;
    const auto next = [&] { return seed = seed * 1664525u + 1013904223u; };
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t x = next() ^ next() >> 16;
        std::uint32_t y = next() ^ next() >> 16;
        // Numbers of like size are where rounding matters; among all floats they are rare. So are the smallest, and those that are infinite.
        if (i % 4 == 1) y = (x & 0xff000000u) ^ (y & 0x81ffffffu);
        if (i % 4 == 2) y &= 0x80ffffffu;
        if (i % 64 == 3) y = 0x7f800000u | (y & 0x80000000u);
        const float a = float_of(x), b = float_of(y);
        add(bits_of(a + b));
        add(bits_of(a - b));
        add(bits_of(a * b));
        add(bits_of(a / b));
        add(bits_of(b * 0.5f));
        add(bits_of(sqrtf(a < 0 ? -a : a)));
        add(bits_of(static_cast<float>(static_cast<std::int32_t>(x))));
        add(bits_of(static_cast<float>(y)));
        add(a < b ? 1u : a == b ? 2u : 3u);
        if (a > -2.0e9f && a < 2.0e9f) add(static_cast<std::uint32_t>(static_cast<std::int32_t>(a)));
    }
    return hash;
}

}  // namespace firmware
