// Random numbers for tests: the same from the same seed on every machine and with every standard library.
#pragma once

#include <cstdint>

namespace islet::test {

/// SplitMix64 (Steele, Lea and Flood 2014).
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t bits() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15ull;
        z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9ull;
        z = (z ^ z >> 27) * 0x94d049bb133111ebull;
        return z ^ z >> 31;
    }
    /// 0 <= result < n
    std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>((bits() >> 32) * n >> 32); }
    bool one_in(std::uint32_t n) { return below(n) == 0; }
    float between(float lo, float hi) { return lo + (hi - lo) * static_cast<float>(bits() >> 40) * 0x1p-24f; }

private:
    std::uint64_t state_;
};

}  // namespace islet::test
