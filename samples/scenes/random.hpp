// The scenes' own random numbers: a PCG32 generator (O'Neill 2014, XSH-RR), the same on every machine for the same seed.
#pragma once

#include <cstdint>

namespace islet::samples {

class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed + increment) { next(); }

    std::uint32_t next() {
        const std::uint64_t old = state_;
        state_ = old * 6364136223846793005u + increment;
        const auto mixed = static_cast<std::uint32_t>(((old >> 18) ^ old) >> 27);
        const auto turn = static_cast<std::uint32_t>(old >> 59);
        return (mixed >> turn) | (mixed << ((32 - turn) & 31));
    }

    /// Evenly spread over low <= x < high: 24 random bits, which a float holds exactly.
    float uniform(float low, float high) { return low + (high - low) * (static_cast<float>(next() >> 8) * (1.0f / 16777216.0f)); }

private:
    static constexpr std::uint64_t increment = 1442695040888963407u;
    std::uint64_t state_;
};

}  // namespace islet::samples
