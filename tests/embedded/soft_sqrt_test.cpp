// The firmware's square root, which processors without a floating-point unit use: it must be the one of IEEE 754, to the bit.
#include "../../samples/firmware/soft_sqrt.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace {

// The reference is the double's root rounded to float, which is the correctly rounded one: a double has more than twice a float's digits and two.
float reference(float a) { return static_cast<float>(std::sqrt(static_cast<double>(a))); }

void expect_correct(std::uint32_t bits) {
    const float a = std::bit_cast<float>(bits);
    EXPECT_EQ(std::bit_cast<std::uint32_t>(firmware::soft_sqrt(a)), std::bit_cast<std::uint32_t>(reference(a))) << std::hexfloat << a;
}

TEST(SoftSqrt, EveryExponentRoundsAsIeee) {
    for (std::uint32_t exponent = 0; exponent < 255; ++exponent) {
        for (std::uint32_t mantissa = 0; mantissa < 1u << 23; mantissa += 12347) expect_correct(exponent << 23 | mantissa);
        expect_correct(exponent << 23 | 1);
        expect_correct(exponent << 23 | 0x7fffff);
    }
}

TEST(SoftSqrt, SquaresHaveTheirRoots) {
    for (std::uint32_t n = 1; n < 4096; ++n) EXPECT_EQ(firmware::soft_sqrt(static_cast<float>(n * n)), static_cast<float>(n));
}

TEST(SoftSqrt, DenormalNumbersHaveRoots) {
    for (std::uint32_t bits = 1; bits < 1u << 23; bits = bits * 3 / 2 + 1) expect_correct(bits);
}

TEST(SoftSqrt, ZerosAndInfinityAreTheirOwnRootsAndNegativeNumbersHaveNone) {
    expect_correct(0);
    expect_correct(0x80000000u);
    expect_correct(0x7f800000u);
    EXPECT_TRUE(std::isnan(firmware::soft_sqrt(-1.0f)));
    EXPECT_TRUE(std::isnan(firmware::soft_sqrt(-std::numeric_limits<float>::infinity())));
    EXPECT_TRUE(std::isnan(firmware::soft_sqrt(std::numeric_limits<float>::quiet_NaN())));
}

}  // namespace
