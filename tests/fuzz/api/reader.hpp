// Numbers out of a fuzzer's bytes.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <iterator>

#include "islet/math.hpp"

namespace islet::fuzz {

/// What kind of numbers arguments are.
struct Family {
    const char* name = "ordinary";
    Vec2 origin = {};          ///< m, where things are
    float gravity = 10;        ///< m/s^2, so strong at the most
    std::uint32_t wild = 0;    ///< of 256 sizes so many lie anywhere between 1e-6 and 1e6
    bool relaxed = false;      ///< solvers with omega 1.5
    bool fine = true;          ///< numbers between the eighths
};
inline constexpr Family families[] = {
    {},
    {.name = "extreme", .wild = 80},
    {.name = "far", .origin = {3.0e6f, -9.0e5f}},
    {.name = "edge", .origin = {-9.99998e6f, 9.99998e6f}},
    {.name = "heavy", .gravity = 10000},
    {.name = "relaxed", .wild = 16, .relaxed = true},
    {.name = "eighths", .fine = false},
};

/// Makes arguments of the fuzzer's bytes; zeros when they are used up.
class Reader {
public:
    Reader(const std::uint8_t* data, std::size_t size, const Family& kind = families[6]) : family(&kind), at_(data), end_(data + size) {}
    const Family* family;
    bool done() const { return at_ == end_; }
    std::uint32_t byte() { return at_ < end_ ? *at_++ : 0; }
    bool flag() { return (byte() & 1) != 0; }
    std::uint32_t below(std::uint32_t n) { return byte() % n; }

    /// Mostly -16 to 16 in steps of an eighth.
    float number() {
        constexpr float special[] = {__builtin_nanf(""), __builtin_inff(), -__builtin_inff(), 3.4e38f, -3.4e38f, 1e-38f, 1.4e-45f, -0.0f,
                                     1e7f, -1e7f, 1e30f, 1e-12f, 1e6f, 0.005f, 1e-4f, 400};
        const std::uint32_t first = byte();
        if (first < 240) {
            const float eighths = 0.125f * static_cast<float>(static_cast<int>(first) - 120);
            return family->fine && first % 2 == 1 ? eighths + static_cast<float>(byte()) / 2048 : eighths;
        }
        if (first < 252) return special[below(std::size(special))];
        return std::bit_cast<float>(byte() | byte() << 8 | byte() << 16 | byte() << 24);
    }
    /// Mostly 0 to 4; often 0, at which things are left out.
    float size() {
        const std::uint32_t first = byte();
        if (first % 16 == 0) return 0;
        if (family->wild > 0 && byte() < family->wild) {
            constexpr float powers[] = {1e-6f, 1e-5f, 1e-4f, 1e-3f, 1e-2f, 1e-1f, 1, 10, 100, 1000, 1e4f, 1e5f, 1e6f};
            return static_cast<float>(first) / 60.0f * powers[below(std::size(powers))];
        }
        return first < 240 ? static_cast<float>(first) / 60.0f : number();
    }
    /// Somewhere in the world.
    Vec2 place() {
        const Vec2 near = point();
        return near + family->origin;
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
