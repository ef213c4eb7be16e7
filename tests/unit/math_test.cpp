// Trigonometry, unit vectors and rotations against the C library in long double.
#include <gtest/gtest.h>

#include <bit>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "islet/math.hpp"
#include "support/effort.hpp"

namespace {

using islet::Rot;
using islet::Vec2;
using islet::test::cases;

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr long double exact_pi = 3.14159265358979323846264338327950288L;

// Larger of the two errors of make_rot at one angle.
long double rot_error(float a) {
    const Rot q = islet::make_rot(a);
    return std::fmax(std::fabs(static_cast<long double>(q.s) - std::sin(static_cast<long double>(a))),
                     std::fabs(static_cast<long double>(q.c) - std::cos(static_cast<long double>(a))));
}

long double unit_error(Rot q) {
    const long double c = q.c, s = q.s;
    return std::fabs(c * c + s * s - 1);
}

// Difference of two angles, whole turns removed.
long double angle_between(long double a, long double b) { return std::fabs(std::remainder(a - b, 2 * exact_pi)); }

// Calls f for every stride-th float from `from` up to `to` (both >= 0), with either sign. Floats are walked in the order of their bits, so
// denormals, small and huge numbers all get their share.
template <class F>
void sweep(float from, float to, std::uint32_t stride, F f) {
    const auto last = std::bit_cast<std::uint32_t>(to);
    for (std::uint32_t bits = std::bit_cast<std::uint32_t>(from); bits <= last; bits += stride) {
        f(std::bit_cast<float>(bits));
        f(-std::bit_cast<float>(bits));
    }
}

TEST(Trig, SineAndCosineAreWithin9e8UpTo100000Radians) {
    long double worst = 0, worst_unit = 0;
    sweep(0.0f, 1e5f, 1009, [&](float a) {
        worst = std::fmax(worst, rot_error(a));
        worst_unit = std::fmax(worst_unit, unit_error(islet::make_rot(a)));
    });
    // The same over equal steps: most floats below 1e5 are tiny.
    for (int i = -500000; i <= 500000; ++i) worst = std::fmax(worst, rot_error(static_cast<float>(i) * 0.2f));
    for (int i = -500000; i <= 500000; ++i) worst = std::fmax(worst, rot_error(static_cast<float>(i) * 1e-5f));
    EXPECT_LT(worst, 9e-8L);
    EXPECT_LT(worst_unit, 1.5e-7L);
}

TEST(Trig, SineAndCosineAreWithin11e8ForEveryLargerAngle) {
    // sin(10^22), to as many digits. Windows' C library does not reduce large angles, so there is nothing to compare with.
    volatile long double large = 1e22L;  // so that the library is asked, not the compiler
    if (std::fabs(std::sin(large) + 0.85220084976718880L) > 1e-15L) GTEST_SKIP() << "this C library knows no sine of large angles";
    long double worst = 0, worst_unit = 0;
    sweep(1e5f, FLT_MAX, 1009, [&](float a) {
        worst = std::fmax(worst, rot_error(a));
        worst_unit = std::fmax(worst_unit, unit_error(islet::make_rot(a)));
    });
    EXPECT_LT(worst, 1.1e-7L);
    EXPECT_LT(worst_unit, 1.5e-7L);
}

TEST(Trig, SineAndCosineAreExactlyReducedAroundEveryQuadrantEdge) {
    long double worst = 0;
    for (int eighth = -127000; eighth <= 127000; ++eighth) {  // odd eighths are where the quadrant is rounded up or down
        float a = static_cast<float>(eighth * (exact_pi / 4));
        a = std::nextafter(std::nextafter(a, -inf), -inf);
        for (int i = 0; i < 5; ++i, a = std::nextafter(a, inf)) worst = std::fmax(worst, rot_error(a));
    }
    EXPECT_LT(worst, 9e-8L);
}

TEST(Trig, SmallAnglesKeepTheirRelativeAccuracy) {
    sweep(0.0f, 0.7f, 4099, [](float a) {
        const long double exact = std::sin(static_cast<long double>(a));
        ASSERT_LE(std::fabs(islet::make_rot(a).s - exact), 1.3e-7L * std::fabs(exact)) << a;
    });
}

TEST(Trig, KnownAnglesComeOutExact) {
    EXPECT_EQ(islet::make_rot(0.0f), (Rot{1, 0}));
    EXPECT_EQ(islet::make_rot(-0.0f), (Rot{1, 0}));
    EXPECT_EQ(islet::make_rot(FLT_TRUE_MIN), (Rot{1, FLT_TRUE_MIN}));
    EXPECT_EQ(islet::make_rot(islet::pi / 2).s, 1.0f);
    EXPECT_NEAR(islet::make_rot(islet::pi / 2).c, 0, 1e-7);
    EXPECT_EQ(islet::make_rot(islet::pi).c, -1.0f);
    EXPECT_NEAR(islet::make_rot(islet::pi).s, 0, 1e-7);
    EXPECT_EQ(islet::make_rot(-islet::pi / 2).s, -1.0f);
}

TEST(Trig, SineIsOddAndCosineEven) {
    sweep(0.0f, FLT_MAX, 100003, [](float a) {
        const Rot q = islet::make_rot(a), r = islet::make_rot(-a);
        ASSERT_EQ(q.c, r.c) << a;
        ASSERT_EQ(q.s, -r.s) << a;
    });
}

TEST(Trig, AnAngleThatIsNotFiniteTurnsNothing) {
    EXPECT_EQ(islet::make_rot(nan), Rot{});
    EXPECT_EQ(islet::make_rot(inf), Rot{});
    EXPECT_EQ(islet::make_rot(-inf), Rot{});
}

TEST(Trig, BitsAreTheseOnEveryMachine) {
    // FNV-1a over the results' bits. A change here is a change of every recorded world hash.
    std::uint32_t hash = 2166136261u;
    const auto mix = [&](float f) { hash = (hash ^ std::bit_cast<std::uint32_t>(f)) * 16777619u; };
    sweep(0.0f, FLT_MAX, 65537, [&](float a) {
        const Rot q = islet::make_rot(a);
        mix(q.c);
        mix(q.s);
        mix(islet::atan2(q.s, 3 * q.c));
        const Rot turned = islet::integrate(q, q.s * 0.25f);
        mix(turned.c);
        mix(turned.s);
    });
    EXPECT_EQ(hash, 1128814353u);
}

TEST(Atan2, IsWithin13e8InTheRightHalfPlaneAnd19e8InTheLeft) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> angle(-3.1415, 3.1415), exponent(-30, 30);
    long double worst_right = 0, worst_left = 0;
    for (int i = 0; i < cases(1000000); ++i) {
        const double a = angle(random), r = std::exp2(exponent(random));
        const float x = static_cast<float>(r * std::cos(a)), y = static_cast<float>(r * std::sin(a));
        const long double error = std::fabs(islet::atan2(y, x) - std::atan2(static_cast<long double>(y), static_cast<long double>(x)));
        (x >= 0 ? worst_right : worst_left) = std::fmax(x >= 0 ? worst_right : worst_left, error);
    }
    EXPECT_LT(worst_right, 1.3e-7L);
    EXPECT_LT(worst_left, 1.9e-7L);
}

TEST(Atan2, HoldsForEveryMagnitudeFromDenormalsToTheLargestFloat) {
    std::mt19937 random(2);
    for (int i = 0; i < cases(1000000); ++i) {
        const float y = std::bit_cast<float>(static_cast<std::uint32_t>(random())), x = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
        if (!std::isfinite(x) || !std::isfinite(y)) continue;
        const long double exact = std::atan2(static_cast<long double>(y), static_cast<long double>(x));
        const long double error = std::fabs(islet::atan2(y, x) - exact);
        ASSERT_LE(error, 1.9e-7L) << y << ' ' << x;
        if (x > 0 && std::fabs(y) < x && std::fabs(exact) > 1e-37L) { ASSERT_LE(error, 2e-7L * std::fabs(exact)) << y << ' ' << x; }
    }
}

TEST(Atan2, AxesAndSigns) {
    EXPECT_EQ(islet::atan2(0, 0), 0.0f);
    EXPECT_EQ(islet::atan2(0, 1), 0.0f);
    EXPECT_EQ(islet::atan2(1, 0), islet::pi / 2);
    EXPECT_EQ(islet::atan2(-1, 0), -islet::pi / 2);
    EXPECT_EQ(islet::atan2(0, -1), islet::pi);
    EXPECT_EQ(islet::atan2(-0.0f, -1), islet::pi);  // the range is (-pi, pi], whatever the sign of zero
    EXPECT_GT(islet::atan2(-FLT_TRUE_MIN, -1), -exact_pi);
    EXPECT_LT(islet::atan2(-FLT_TRUE_MIN, -1), -3.14159f);
    EXPECT_EQ(islet::atan2(1, 1), islet::pi / 4);
    EXPECT_EQ(islet::atan2(FLT_MAX, FLT_MAX), islet::pi / 4);
    EXPECT_EQ(islet::atan2(-FLT_TRUE_MIN, FLT_TRUE_MIN), -islet::pi / 4);
    for (const float bad : {nan, inf, -inf}) {
        EXPECT_EQ(islet::atan2(bad, 1), 0.0f);
        EXPECT_EQ(islet::atan2(1, bad), 0.0f);
    }
}

TEST(Rotation, AngleOfUndoesMakeRot) {
    for (int i = -100000; i <= 100000; ++i) {
        const float a = static_cast<float>(i) * 1e-4f;
        ASSERT_LT(angle_between(islet::angle_of(islet::make_rot(a)), a), 3e-7L) << a;
    }
}

TEST(Rotation, ProductsAddAnglesAndInversesSubtractThem) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> angle(-10, 10);
    for (int i = 0; i < 100000; ++i) {
        const float a = angle(random), b = angle(random);
        const Rot q = islet::make_rot(a), r = islet::make_rot(b);
        ASSERT_LT(angle_between(islet::angle_of(q * r), static_cast<long double>(a) + b), 6e-7L);
        ASSERT_LT(angle_between(islet::angle_of(islet::inv_mul(q, r)), static_cast<long double>(b) - a), 6e-7L);
        const Vec2 v{a, b};
        const Vec2 back = islet::inv_rotate(q, islet::rotate(q, v));
        ASSERT_NEAR(back.x, v.x, 5e-6f);
        ASSERT_NEAR(back.y, v.y, 5e-6f);
    }
}

TEST(Rotation, TransformsComposeAndInvert) {
    const islet::Transform a{{1, 2}, islet::make_rot(0.7f)}, b{{-3, 0.5f}, islet::make_rot(-2.1f)};
    const Vec2 v{0.3f, -0.8f};
    const Vec2 direct = islet::inv_transform_point(a, islet::transform_point(b, v));
    const Vec2 composed = islet::transform_point(islet::inv_mul(a, b), v);
    EXPECT_NEAR(direct.x, composed.x, 1e-6f);
    EXPECT_NEAR(direct.y, composed.y, 1e-6f);
}

TEST(Rotation, NormalizeRestoresUnitLengthAndKeepsTheAngle) {
    for (const float scale : {1e-10f, 0.5f, 0.999f, 1.001f, 3.0f, 1e10f}) {
        for (int i = -300; i <= 300; ++i) {
            const Rot q = islet::make_rot(static_cast<float>(i) * 0.01f);
            const Rot n = islet::normalize(Rot{q.c * scale, q.s * scale});
            ASSERT_LT(unit_error(n), 4e-7L);
            ASSERT_LT(angle_between(islet::angle_of(n), islet::angle_of(q)), 5e-7L);
        }
    }
    EXPECT_EQ(islet::normalize(Rot{0, 0}), Rot{});
    EXPECT_EQ(islet::normalize(Rot{nan, 0}), Rot{});
    EXPECT_EQ(islet::normalize(Rot{inf, 1}), Rot{});
}

TEST(Integrate, KeepsUnitLengthOverAMillionSteps) {
    for (const float step : {1e-6f, 0.001f, -0.05f, 0.3f}) {
        Rot q;
        long double worst = 0;
        for (int i = 0; i < cases(1000000); ++i) {
            q = islet::integrate(q, step);
            worst = std::fmax(worst, unit_error(q));
        }
        EXPECT_LT(worst, 4e-7L) << step;
    }
}

TEST(Integrate, TurnsByTheAngleUpToItsEighthPower) {
    // The first terms left out are d^8 / 8! of the cosine and d^9 / 9! of the sine.
    for (int i = -780; i <= 780; ++i) {
        const float d = static_cast<float>(i) * 0.002f;  // up to pi / 2 in one step
        const Rot q = islet::make_rot(1.1f);
        const Rot turn = islet::inv_mul(q, islet::integrate(q, d));
        const long double d8 = std::pow(std::fabs(static_cast<long double>(d)), 8.0L);
        ASSERT_LE(angle_between(islet::angle_of(turn), d), 4e-7L + d8 / 40320) << d;
    }
}

TEST(Integrate, LargeStepsAreCutToAQuarterTurnAndNoNumberTurnsNothing) {
    for (const float d : {2.0f, 3.0f, 10.0f, 1000.0f, inf}) {
        EXPECT_NEAR(islet::angle_of(islet::integrate({}, d)), islet::pi / 2, 1.1e-3f) << d;
        EXPECT_NEAR(islet::angle_of(islet::integrate({}, -d)), -islet::pi / 2, 1.1e-3f) << d;
    }
    const Rot q = islet::make_rot(0.5f);
    for (const float bad : {nan}) EXPECT_LT(angle_between(islet::angle_of(islet::integrate(q, bad)), 0.5L), 3e-7L);
}

TEST(Length, IsTheRootOfTheSquares) {
    EXPECT_EQ(islet::length({3, -4}), 5.0f);
    EXPECT_EQ(islet::length({}), 0.0f);
    EXPECT_EQ(islet::distance({1, 1}, {-2, 5}), 5.0f);
    std::mt19937 random(4);
    std::uniform_real_distribution<float> number(-1000, 1000);
    for (int i = 0; i < 100000; ++i) {
        const Vec2 v{number(random), number(random)};
        const long double exact = std::hypot(static_cast<long double>(v.x), static_cast<long double>(v.y));
        ASSERT_LE(std::fabs(islet::length(v) - exact), 1.3e-7L * exact);
    }
}

TEST(Normalize, GivesUnitLengthInTheSameDirection) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> angle(-3.1f, 3.1f), exponent(-55, 60);
    for (int i = 0; i < 100000; ++i) {
        const float scale = std::exp2(exponent(random));
        const Rot q = islet::make_rot(angle(random));
        const Vec2 n = islet::normalize(Vec2{q.c * scale, q.s * scale});
        ASSERT_LT(unit_error({n.x, n.y}), 4e-7L);
        ASSERT_LT(std::fabs(islet::cross(n, {q.c, q.s})), 3e-7f);
        ASSERT_GT(islet::dot(n, {q.c, q.s}), 0);
    }
}

TEST(Normalize, AxesStayExactAndDegenerateVectorsBecomeZero) {
    std::mt19937 random(6);
    std::uniform_real_distribution<float> number(1e-3f, 1e6f);
    for (int i = 0; i < 100000; ++i) ASSERT_EQ(islet::normalize(Vec2{0, -number(random)}), (Vec2{0, -1}));
    EXPECT_EQ(islet::normalize(Vec2{}), Vec2{});
    EXPECT_EQ(islet::normalize(Vec2{5e-19f, 5e-19f}), Vec2{});
    EXPECT_EQ(islet::normalize(Vec2{1.1e-18f, 0}), (Vec2{1, 0}));
    for (const float bad : {nan, inf, FLT_MAX}) EXPECT_EQ(islet::normalize(Vec2{bad, 1}), Vec2{});
}

TEST(Finite, TellsNumbersFromTheRest) {
    for (const float good : {0.0f, -0.0f, 1.0f, FLT_MAX, -FLT_MAX, FLT_TRUE_MIN}) EXPECT_TRUE(islet::is_finite(good));
    for (const float bad : {nan, inf, -inf}) EXPECT_FALSE(islet::is_finite(bad));
}

TEST(Lerp, OfRotationsGoesTheShortWayAndStaysOfUnitLength) {
    for (float from : {-3.0f, -1.0f, 0.0f, 2.5f})
        for (float turn : {-1.5f, -0.1f, 0.0f, 0.3f, 1.5f}) {
            const Rot a = islet::make_rot(from), b = islet::make_rot(from + turn);
            const auto turned = [&](float t) { return islet::angle_of(islet::inv_mul(a, islet::lerp(a, b, t))); };
            EXPECT_NEAR(turned(0), 0, 1e-6f);
            EXPECT_NEAR(turned(0.5f), turn / 2, 1e-6f);  // the middle is exact by symmetry
            EXPECT_NEAR(turned(1), turn, 1e-6f);
            for (float t : {0.1f, 0.25f, 0.75f}) {
                // On the chord: tan(angle - turn / 2) = (2 t - 1) tan(turn / 2).
                EXPECT_NEAR(turned(t), turn / 2 + std::atan((2 * t - 1) * std::tan(turn / 2)), 1e-6f);
                const Rot q = islet::lerp(a, b, t);
                EXPECT_NEAR(q.c * q.c + q.s * q.s, 1, 1e-6f);
            }
        }
}

TEST(Lerp, OfPosesIsThatOfPlaceAndRotation) {
    const islet::Transform a = {{1, 2}, islet::make_rot(0.2f)}, b = {{3, -2}, islet::make_rot(1.0f)};
    const islet::Transform m = islet::lerp(a, b, 0.5f);
    EXPECT_EQ(m.p, (Vec2{2, 0}));
    EXPECT_NEAR(islet::angle_of(m.q), 0.6f, 1e-6f);
}

}  // namespace
