// All that the engine asks of a C library: five functions. Small rather than fast; a firmware that has a C library uses that one's.
#include <cstddef>
#include <cstdint>

#include "soft_sqrt.hpp"

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

// One instruction where there is a floating-point unit; then nobody calls this.
float sqrtf(float a) { return firmware::soft_sqrt(a); }
}
