// Numbers out of a fuzzer's bytes.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <iterator>

#include "islet/math.hpp"

namespace islet::fuzz {

/// Makes arguments of the fuzzer's bytes; zeros when they are used up.
class Reader {
public:
    Reader(const std::uint8_t* data, std::size_t size) : at_(data), end_(data + size) {}
    bool done() const { return at_ == end_; }
    std::uint32_t byte() { return at_ < end_ ? *at_++ : 0; }
    bool flag() { return (byte() & 1) != 0; }
    std::uint32_t below(std::uint32_t n) { return byte() % n; }

    /// Mostly -16 to 16 in steps of an eighth.
    float number() {
        constexpr float special[] = {__builtin_nanf(""), __builtin_inff(), -__builtin_inff(), 3.4e38f, -3.4e38f, 1e-38f, 1.4e-45f, -0.0f,
                                     1e7f, -1e7f, 1e30f, 1e-12f, 1e6f, 0.005f, 1e-4f, 400};
        const std::uint32_t first = byte();
        if (first < 240) return 0.125f * static_cast<float>(static_cast<int>(first) - 120);
        if (first < 252) return special[below(std::size(special))];
        return std::bit_cast<float>(byte() | byte() << 8 | byte() << 16 | byte() << 24);
    }
    /// Mostly 0 to 4.
    float size() {
        const std::uint32_t first = byte();
        return first < 240 ? static_cast<float>(first) / 60.0f : number();
    }
    Vec2 point() {
        const float x = number();
        return {x, number()};
    }

private:
    const std::uint8_t* at_;
    const std::uint8_t* end_;
};

}  // namespace islet::fuzz
