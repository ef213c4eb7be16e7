// Sine, cosine and arctangent in plain single precision. Unlike the C library's, they are the same on every system.
//
// Largest absolute error against the exact value for the float that was passed, measured by tests/unit/math_test.cpp:
//
//     make_rot   9e-8 up to 1e5 rad, 1.1e-7 up to the largest float; c^2 + s^2 is within 1.5e-7 of 1
//     atan2      1.3e-7 for results within +-pi/2, 1.9e-7 beyond (floats near pi are 2.4e-7 apart); 2e-7 of the result if it is small
//
// The angle passed is itself rounded, by up to 0.004 rad at 1e5 rad and by up to a turn at 2e8 rad: a result that is exact for the float may be far from what
// the caller meant. No step converts a number to an integer type that cannot hold it.
#include "../exact.hpp"

#include <cstdint>

#include "../math/scalar.hpp"
#include "islet/math.hpp"

namespace islet {
namespace {

/// An angle as quadrant * pi/2 + rest, with |rest| <= pi/4 plus a rounding. Only the lowest two bits of the quadrant matter.
struct Reduced {
    std::uint32_t quadrant;
    float rest;
};

constexpr float largest_easy_angle = 1e5f;  // rad; keeps the number of quarter turns below 2^16

/// Cody and Waite's reduction. pi/2 is split into a sum whose first two terms have 8 bits each: times a whole number below 2^16 they are
/// exact, and so are the first two subtractions, because the leading digits cancel. Only the last one rounds.
Reduced reduce_easy(float a) {
    constexpr float two_over_pi = 0.636619747f;
    constexpr float half_pi_1 = 201.0f / 128;           // 1.5703125
    constexpr float half_pi_2 = 253.0f / (128 * 4096);  // 4.8e-4
    constexpr float half_pi_3 = 1.267590847e-6f;        // pi/2 is less than 6e-14 away from the sum of the three
    const auto k = static_cast<std::int32_t>(a * two_over_pi + (a < 0 ? -0.5f : 0.5f));
    const auto n = static_cast<float>(k);
    return {static_cast<std::uint32_t>(k), ((a - n * half_pi_1) - n * half_pi_2) - n * half_pi_3};
}

/// Payne and Hanek's reduction for |a| > 1e5, in integers. With |a| = m * 2^e and m < 2^24, quarter turns modulo 4 need only those bits
/// of 2/pi whose weight times 2^e is 2 or less: 64 of them leave an error below 2^-30 quarter turns (1.5e-9 rad).
Reduced reduce_hard(float a) {
    constexpr std::uint32_t two_over_pi[7] = {0, 0xa2f9836e, 0x4e441529, 0xfc2757d1, 0xf534ddc0, 0xdb629599, 0x3c439041};
    constexpr float half_pi_over_2_30 = 1.462918120e-9f;
    const auto bits = detail::bits_of(a);
    const std::uint32_t m = (bits & 0x7fffff) | 0x800000;
    const std::uint32_t first = ((bits >> 23) & 0xff) - 120;  // e + 30: the place in the table of the bit worth 2; 23 to 134 here
    const std::uint32_t* word = two_over_pi + first / 32;
    const std::uint32_t shift = first % 32;
    const std::uint32_t high = (word[0] << shift) | ((word[1] >> 1) >> (31 - shift));
    const std::uint32_t low = (word[1] << shift) | ((word[2] >> 1) >> (31 - shift));

    // The top 32 bits of the 64-bit product: two bits of quadrant, thirty of fraction. Rounded to the nearest quadrant.
    const std::uint32_t turns = m * high + static_cast<std::uint32_t>((std::uint64_t{m} * low) >> 32);
    const std::uint32_t quadrant = (turns + 0x20000000) >> 30;
    const float rest = static_cast<float>(static_cast<std::int32_t>(turns - (quadrant << 30))) * half_pi_over_2_30;
    return a < 0 ? Reduced{0 - quadrant, -rest} : Reduced{quadrant, rest};
}

/// atan(t) for |t| <= tan(pi/8); near-minimax coefficients, error 5e-9.
float small_atan(float t) {
    const float z = t * t;
    return t + t * z * (-3.333275616e-1f + z * (1.997185200e-1f + z * (-1.382412314e-1f + z * 7.901478559e-2f)));
}

}  // namespace

Rot make_rot(float radians) {
    if (!is_finite(radians)) return {};
    const Reduced a = abs(radians) <= largest_easy_angle ? reduce_easy(radians) : reduce_hard(radians);

    // Near-minimax polynomials on +-0.79, errors 2e-9 and 1e-10; the leading terms are kept apart so that they round only once.
    const float r = a.rest;
    const float z = r * r;
    const float sine = r + r * z * (-1.666665077e-1f + z * (8.331974968e-3f + z * -1.949444268e-4f));
    const float cosine = 1.0f - (0.5f * z - z * z * (4.166664556e-2f + z * (-1.388730365e-3f + z * 2.443120320e-5f)));
    switch (a.quadrant & 3) {
        case 0: return {cosine, sine};
        case 1: return {-sine, cosine};
        case 2: return {-cosine, -sine};
        default: return {sine, -cosine};
    }
}

float atan2(float y, float x) {
    if (!is_finite(y) || !is_finite(x)) return 0;
    float big = max(abs(x), abs(y));
    float small = min(abs(x), abs(y));
    if (big == 0) return 0;
    if (big > 1e38f) {  // their sum must not overflow
        big *= 0.25f;
        small *= 0.25f;
    }

    // The angle is eighths * pi/4 + rest, |rest| <= pi/8, from the nearest axis or diagonal: tan(a - pi/4) = (t - 1) / (t + 1).
    constexpr float tan_eighth_pi = 0.41421356f;
    const bool near_diagonal = small > tan_eighth_pi * big;
    float rest = near_diagonal ? small_atan((small - big) / (small + big)) : small_atan(small / big);
    int eighths = near_diagonal ? 1 : 0;
    if (abs(y) > abs(x)) {  // mirrored at the diagonal
        eighths = 2 - eighths;
        rest = -rest;
    }
    if (x < 0) {  // mirrored at the y axis
        eighths = 4 - eighths;
        rest = -rest;
    }

    // Multiples of pi/4 in two parts, so that only the last addition rounds.
    constexpr float high[5] = {0, 0.785398163f, 1.57079633f, 2.35619449f, 3.14159265f};
    constexpr float low[5] = {0, -2.18556941e-8f, -4.37113883e-8f, -5.96244023e-09f, -8.74227766e-8f};
    constexpr float below_pi = 3.14159250f;  // the largest float that is less than the true pi
    const float angle = high[eighths] + (low[eighths] + rest);
    return y < 0 ? -min(angle, below_pi) : angle;
}

float angle_of(Rot q) { return atan2(q.s, q.c); }

}  // namespace islet
