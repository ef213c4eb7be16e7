// Questions about shapes that are nearly equal, touching, parallel, collinear, or much longer than wide (support/hard_shapes.hpp), judged in long double
// (support/long_geometry.hpp) by the bound that islet/query.hpp states: 1e-6 of the largest difference of corners.
#include <gtest/gtest.h>

#include <string>

#include "support/effort.hpp"
#include "support/hard_shapes.hpp"
#include "support/long_geometry.hpp"

namespace {

using namespace islet;
using long_exact::Point;
using long_exact::Real;
using long_exact::Rounded;
using long_exact::Solid;
using test::cases;
using test::HardPair;
using test::text_of;

constexpr Real relative_error = 1e-6L;
constexpr Real rounding_of_a_number = 1.8e-7L;  // three of single precision

struct Posed {
    ShapeProxy a, b;
    Vec2 along, out;
    double size = 1;
};

Posed posed(const HardPair& p) { return {transform_proxy(p.pose_a, p.a), transform_proxy(p.pose_b, p.b), p.along, p.out, p.size}; }

TEST(HardShapes, SeparationIsWithinItsBoundOfLongDoubleIn200000Cases) {
    exact::Random r;
    Real worst = 0;
    int overlapping = 0;
    for (int i = 0; i < cases(200000); ++i) {
        const Posed c = posed(test::hard_pair(r, true));
        const Solid a = long_exact::solid_of(c.a), b = long_exact::solid_of(c.b);
        const Rounded w = long_exact::difference(a, b);
        const Real scale = long_exact::scale_of(a, b), tolerance = relative_error * scale;
        const Real want = long_exact::signed_distance(w, {});
        const Separation got = separation(c.a, c.b);
        const std::string what = std::to_string(i) + ": " + text_of(c.a) + " and " + text_of(c.b);
        const Real error = std::fabs(Real(got.distance) - want);
        worst = std::max(worst, error / scale);
        ASSERT_LE(error, tolerance) << what << ": " << got.distance << ", not " << double(want);
        // The points are on the surfaces, as exactly as numbers of their size can be; and moved by the distance along the normal the shapes touch.
        const Point n = long_exact::of(got.normal);
        ASSERT_NEAR(double(long_exact::length(n)), 1, 1e-6) << what;
        ASSERT_LE(std::fabs(long_exact::signed_distance(long_exact::rounded_of(a), long_exact::of(got.point_a))),
                  tolerance + rounding_of_a_number * long_exact::reach_of(a)) << what << " at " << text_of(got.point_a);
        ASSERT_LE(std::fabs(long_exact::signed_distance(long_exact::rounded_of(b), long_exact::of(got.point_b))),
                  tolerance + rounding_of_a_number * long_exact::reach_of(b)) << what << " at " << text_of(got.point_b);
        const Point parted = Real(got.distance) * n;
        ASSERT_LE(std::fabs(long_exact::signed_distance(w, parted)), 3 * tolerance) << what << " normal " << text_of(got.normal);
        const Point between = long_exact::of(got.point_b) - long_exact::of(got.point_a) - Real(got.distance) * n;
        ASSERT_LE(long_exact::length(between), 3 * tolerance + 2 * rounding_of_a_number * std::max(long_exact::reach_of(a), long_exact::reach_of(b))) << what;
        ASSERT_EQ(overlaps(c.a, c.b), got.distance <= 0);
        overlapping += want < 0 ? 1 : 0;
    }
    EXPECT_GT(overlapping, cases(20000));
    EXPECT_LT(overlapping, cases(180000));
    std::printf("separation of hard pairs: %d overlap, worst error %.2Lg of the size\n", overlapping, worst);
}

// A line, which has no inside: it must be met where the way crosses it clearly.
bool crosses_clearly(const Rounded& w, Point d, Real tolerance) {
    const Point u = w.core[0], v = w.core[1], e = v - u;
    const Real way = long_exact::length(d), length = long_exact::length(e);
    const Real s0 = long_exact::cross(d, u) / way, s1 = long_exact::cross(d, v) / way;
    const Real h0 = long_exact::cross(e, Point{} - u) / length, h1 = long_exact::cross(e, d - u) / length;
    const bool clear = std::min({std::fabs(s0), std::fabs(s1), std::fabs(h0), std::fabs(h1)}) > tolerance;
    return clear && (s0 > 0) != (s1 > 0) && (h0 > 0) != (h1 > 0);
}

struct CastTally {
    int hits = 0, misses = 0, inside = 0;
    Real worst = 0;
};

// A hit ends on the surface, having been in it nowhere before; a miss is nowhere in it. Both but for the bound.
void judge_cast(const Solid& moving, Point d, const Solid& target, bool one_sided, const CastHit& got, const std::string& what, CastTally& tally) {
    const Rounded w = long_exact::difference(moving, target);
    const Real scale = long_exact::scale_of(moving, target, d), tolerance = relative_error * scale;
    const Real at_start = long_exact::signed_distance(w, {});
    if (!got.hit) {
        ++tally.misses;
        if (one_sided) return;
        if (w.core.size() == 2 && w.radius == 0) {
            ASSERT_FALSE(crosses_clearly(w, d, 3 * tolerance)) << what << " missed";
        } else {
            ASSERT_GE(long_exact::least_on_way(w, {}, d), -tolerance) << what << " missed";
        }
        return;
    }
    ASSERT_TRUE(got.fraction >= 0 && got.fraction <= 1 && got.separation <= 0) << what;
    const Point n = long_exact::of(got.normal), at = Real(got.fraction) * d;
    ASSERT_NEAR(double(long_exact::length(n)), 1, 1e-5) << what;
    ASSERT_LE(std::fabs(long_exact::signed_distance(long_exact::rounded_of(target), long_exact::of(got.point))),
              tolerance + rounding_of_a_number * long_exact::reach_of(target)) << what << " at point " << text_of(got.point);
    if (got.separation < 0) {
        ++tally.inside;
        ASSERT_EQ(got.fraction, 0) << what;
        ASSERT_LE(std::fabs(Real(got.separation) - at_start), tolerance) << what;
        ASSERT_LE(std::fabs(long_exact::signed_distance(w, -Real(got.separation) * n)), 3 * tolerance) << what << " normal " << text_of(got.normal);
        return;
    }
    ++tally.hits;
    const Real depth = long_exact::signed_distance(w, at);
    tally.worst = std::max(tally.worst, std::fabs(depth) / scale);
    ASSERT_LE(std::fabs(depth), tolerance) << what << " hit at " << double(got.fraction);
    ASSERT_GE(long_exact::least_on_way(w, {}, at), -tolerance) << what << " went through before " << double(got.fraction);
    ASSERT_LE(long_exact::dot(n, d), 1e-6L * long_exact::length(d)) << what;
    // The normal is the outline's there.
    const Real step = 1e-3L * scale;
    ASSERT_NEAR(double(long_exact::signed_distance(w, at + step * n)), double(step), double(0.002L * step + 3 * tolerance)) << what << " normal " << text_of(got.normal);
}

// Towards the other shape, or along or across the edge that they share, or anywhere; exactly or off by very little.
Vec2 hard_way(exact::Random& r, const Posed& c) {
    const double length = c.size * std::pow(10.0, double(r.in(-2, 1)));
    const Vec2 sides[] = {-c.out, c.out, c.along, -c.along, {1, 0}, {0, 1}};
    Vec2 d = r.below(3) == 0 ? Vec2{r.in(-1, 1), r.in(-1, 1)} : sides[r.below(6)];
    d += Vec2{float(test::nudge(r, 0.3)), float(test::nudge(r, 0.3))};
    return float(length) * d;
}

TEST(HardShapes, CastsEndWhereTheSweepFirstTouchesIn100000Cases) {
    exact::Random r;
    CastTally tally;
    for (int i = 0; i < cases(100000); ++i) {
        const Posed c = posed(test::hard_pair(r, true));
        const Vec2 d = hard_way(r, c);
        // The pair stands as it does somewhere on the way.
        const ShapeProxy moving = transform_proxy({r.in(0, 1.2) * -d, {}}, c.a);
        if (moving.count == 0) continue;
        const std::string what = std::to_string(i) + ": " + text_of(moving) + " along " + text_of(d) + " at " + text_of(c.b);
        judge_cast(long_exact::solid_of(moving), long_exact::of(d), long_exact::solid_of(c.b), c.b.one_sided, cast_shape(moving, d, c.b), what, tally);
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(tally.hits, cases(20000));
    EXPECT_GT(tally.misses, cases(10000));
    EXPECT_GT(tally.inside, cases(5000));
    std::printf("casts of hard pairs: %d hits, %d misses, %d begin inside, worst error %.2Lg of the size\n", tally.hits, tally.misses, tally.inside, tally.worst);
}

TEST(HardShapes, RaysEndWhereTheyFirstTouchIn100000Cases) {
    exact::Random r;
    CastTally tally;
    for (int i = 0; i < cases(100000); ++i) {
        const Posed c = posed(test::hard_pair(r, true));
        const Vec2 d = hard_way(r, c), from = c.a.points[r.below(c.a.count)] - r.in(0, 1.2) * d;
        const std::string what = std::to_string(i) + ": ray from " + text_of(from) + " along " + text_of(d) + " at " + text_of(c.b);
        judge_cast({{long_exact::of(from)}, 0}, long_exact::of(d), long_exact::solid_of(c.b), c.b.one_sided, cast_ray(c.b, from, d), what, tally);
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(tally.hits, cases(10000));
    EXPECT_GT(tally.misses, cases(10000));
    std::printf("rays at hard shapes: %d hits, %d misses, %d begin inside, worst error %.2Lg of the size\n", tally.hits, tally.misses, tally.inside, tally.worst);
}

}  // namespace
