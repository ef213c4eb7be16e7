// The firmware's multiplication, which boards without a floating-point unit use: it must be the processor's, to the bit.
#include "../../samples/firmware/soft_multiply.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>

namespace {

using firmware::detail::Product;

/// Random words.
class Random {
public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}
    std::uint32_t operator()() { return static_cast<std::uint32_t>(engine_()); }

private:
    std::mt19937 engine_;
};

void expect_correct(std::uint32_t a, std::uint32_t b) {
    const float wanted = std::bit_cast<float>(a) * std::bit_cast<float>(b);
    const std::uint32_t bits = firmware::soft_multiply(a, b);
    if (std::isnan(wanted) && std::isnan(std::bit_cast<float>(bits))) return;
    EXPECT_EQ(bits, std::bit_cast<std::uint32_t>(wanted)) << std::hexfloat << std::bit_cast<float>(a) << " times " << std::bit_cast<float>(b);
}

TEST(SoftMultiply, OfAnyBitsIsTheProcessors) {
    Random random(1);
    for (int i = 0; i < 2'000'000 && !testing::Test::HasFailure(); ++i) expect_correct(random(), random());
}

TEST(SoftMultiply, RoundsAsIeeeWhereTheProductIsNearTheSmallestAndTheLargestNumbers) {
    Random random(2);
    const auto times = [&](int exponent_of_product) {  // that of a product of two numbers between 1 and 2 is 127
        const std::uint32_t a = random(), b = random();
        const int ea = static_cast<int>(a >> 23 & 0xffu), eb = exponent_of_product + 127 - ea;
        if (eb >= 0 && eb <= 254) expect_correct(a, (b & 0x807fffffu) | static_cast<std::uint32_t>(eb) << 23);
    };
    for (int i = 0; i < 1'000'000 && !testing::Test::HasFailure(); ++i) {
        times(static_cast<int>(random() % 40) - 30);
        times(static_cast<int>(random() % 8) + 250);
    }
}

TEST(SoftMultiply, TiesGoToTheEvenNumber) {
    // (1 + 2^-12) (1 + k 2^-12) = 1 + (k + 1) 2^-12 + k 2^-24: half a unit in the last place, for odd k.
    for (std::uint32_t k = 1; k < 4096; ++k) expect_correct(0x3f800800u, 0x3f800000u + (k << 11));
}

TEST(SoftMultiply, OfZerosInfinitiesSubnormalNumbersAndWhatIsNoNumber) {
    constexpr std::uint32_t magnitudes[] = {0,           1,           2,           0x7fffffu,   0x800000u,   0x800001u,   0x3f800000u, 0x3f800001u, 0x3f7fffffu,
                                            0x7f7fffffu, 0x7f800000u, 0x7fc00000u, 0x00400000u, 0x3f000000u, 0x34000000u, 0x33ffffffu, 0x4b800000u};
    constexpr std::uint32_t signs[] = {0, 0x80000000u};
    for (const std::uint32_t a : magnitudes)
        for (const std::uint32_t b : magnitudes)
            for (const std::uint32_t sign_a : signs)
                for (const std::uint32_t sign_b : signs) expect_correct(a | sign_a, b | sign_b);
}

TEST(SoftMultiply, ByHalvesTheMantissasProductIsTheSame) {
    Random random(3);
    for (int i = 0; i < 1'000'000; ++i) {
        const std::uint32_t a = random() & 0xffffffu, b = random() & 0xffffffu;
        const Product wide = firmware::detail::multiply_wide(a, b);
        const Product halves = firmware::detail::multiply_halves(a, b);
        ASSERT_TRUE(wide.high == halves.high && wide.low == halves.low) << a << " times " << b;
    }
}

}  // namespace
