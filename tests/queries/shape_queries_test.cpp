// Questions about two shapes by themselves, each against formulas in double precision on random pairs of all types (oracle.hpp), many of them turned by
// quarters; those that rounding is hardest on are in hard_shapes_test.cpp. The tolerance is the one
// that islet/query.hpp states: 1e-6 of the largest difference of corners.
#include <gtest/gtest.h>

#include "oracle.hpp"
#include "shapes.hpp"
#include "support/effort.hpp"
#include "support/hard_shapes.hpp"

namespace {

using namespace islet;
using exact::Point;
using oracle::Solid;
using test::cases;

constexpr double relative_error = 1e-6;

std::string text(const ShapeProxy& p) {
    std::string s = "r " + std::to_string(p.radius);
    for (std::uint32_t i = 0; i < p.count; ++i) s += " (" + std::to_string(p.points[i].x) + ", " + std::to_string(p.points[i].y) + ")";
    return s;
}

struct Pair {
    ShapeProxy a, b;
    Solid exact_a, exact_b;
    double size = 1;
};

Pair random_pair(exact::Random& r, bool with_one_sided) {
    Pair c;
    c.size = std::pow(10.0, r.in(-1, 2));
    c.a = test::random_shape(r, c.size * std::pow(10.0, r.in(-1, 0)), with_one_sided);
    do c.b = transform_proxy(test::hard_pose(r, 1.2 * c.size), test::random_shape(r, c.size, with_one_sided));
    while (c.b.count == 0);
    c.exact_a = oracle::solid_of(c.a);
    c.exact_b = oracle::solid_of(c.b);
    return c;
}

TEST(ShapeQueries, SeparationIsThatOfTheExactFormulasFor200000RandomPairs) {
    exact::Random r;
    double worst = 0;
    int overlapping = 0;
    for (int i = 0; i < cases(200000); ++i) {
        const Pair c = random_pair(r, true);
        const double scale = oracle::scale_of(c.exact_a, c.exact_b), tolerance = relative_error * scale;
        const double want = oracle::signed_distance(c.exact_a, c.exact_b);
        const Separation got = separation(c.a, c.b);
        worst = std::max(worst, std::fabs(double(got.distance) - want) / scale);
        ASSERT_NEAR(double(got.distance), want, tolerance) << i << ": " << text(c.a) << " and " << text(c.b);
        // The points are on the surfaces, that far apart along the normal; and no shorter way parts overlapping shapes: moved by the depth they touch.
        const Point a = exact::of(got.point_a), b = exact::of(got.point_b), n = exact::of(got.normal);
        ASSERT_NEAR(exact::length(n), 1, 1e-6);
        ASSERT_NEAR(oracle::depth_at(c.exact_a, a), 0, tolerance) << i;
        ASSERT_NEAR(oracle::depth_at(c.exact_b, b), 0, tolerance) << i;
        ASSERT_LT(exact::length(b - a - double(got.distance) * n), 3 * tolerance) << i;
        const Solid parted = oracle::moved(c.exact_b, -double(got.distance) * n);
        ASSERT_NEAR(oracle::signed_distance(c.exact_a, parted), 0, 3 * tolerance) << i;
        ASSERT_EQ(overlaps(c.a, c.b), got.distance <= 0);
        overlapping += want < 0 ? 1 : 0;
    }
    EXPECT_GT(overlapping, cases(20000));
    EXPECT_LT(overlapping, 180000);
    std::printf("separation: worst error %.2g of the size\n", worst);
}

// Shared by rays and moving shapes: is the hit the first entry, on the surface, with its normal?
void check_cast(int i, const Solid& moving, Point d, const Solid& target, const CastHit& got, const std::string& what, int& hits, double& worst) {
    const Solid w = oracle::difference(moving, target);
    const double scale = oracle::scale_of(moving, target, d), tolerance = relative_error * scale;
    const double way = exact::length(d);
    double want = oracle::first_entry(w, {}, d);
    if (oracle::passes(moving, d, target)) want = oracle::never;
    const bool overlapping = oracle::depth_at(w, {}) < 0;
    if (!got.hit) {
        // A miss may be a graze that single precision cannot tell from one.
        if (want != oracle::never && !overlapping) {
            ASSERT_GT(oracle::least_on_way(w, {}, d), -tolerance) << i << " missed at " << want << ": " << what;
        }
        if (want != oracle::never && overlapping) {
            ASSERT_GT(oracle::depth_at(w, {}), -tolerance) << i << " missed at the start: " << what;
        }
        return;
    }
    ++hits;
    ASSERT_GE(got.fraction, 0) << what;
    ASSERT_LE(got.fraction, 1) << what;
    const Point n = exact::of(got.normal), at = double(got.fraction) * d;
    ASSERT_NEAR(exact::length(n), 1, 1e-5) << i << ": " << what;
    // The surface point is on the target, and the moved shape touches it there.
    const Solid there = oracle::moved(moving, at);
    ASSERT_NEAR(oracle::depth_at(target, exact::of(got.point)), 0, tolerance) << i << ": " << what;
    if (got.separation < 0) {
        ASSERT_EQ(got.fraction, 0) << i;
        ASSERT_NEAR(double(got.separation), oracle::depth_at(w, {}), tolerance) << i << ": " << what;
        ASSERT_NEAR(oracle::depth_at(w, -double(got.separation) * n), 0, 3 * tolerance) << i << ": " << what;
        return;
    }
    const double depth = oracle::signed_distance(there, target);
    worst = std::max(worst, std::fabs(depth) / scale);
    ASSERT_NEAR(depth, 0, tolerance) << i << ": " << what;
    const double cosine = -exact::dot(n, d) / way;
    ASSERT_GT(cosine, -1e-4) << i << ": " << what;
    if (want == oracle::never) {
        // It may also have hit where the exact way just ends before, or just grazes.
        const bool ends = double(got.fraction) * way > way - 4 * tolerance / std::max(cosine, 1e-3);
        ASSERT_TRUE(ends || oracle::least_on_way(w, {}, d) < tolerance) << i << " hit nothing: " << what;
        ASSERT_FALSE(oracle::passes(moving, d, target)) << i << " hit the back: " << what;
    } else if (cosine > 0.05) {
        ASSERT_NEAR(double(got.fraction) * way, want * way, 2 * tolerance / cosine) << i << ": " << what;
    }
    // The normal is the outline's there: a little before along it the shapes are apart by as much.
    const double step = 1e-3 * scale;
    const Solid back = oracle::moved(there, step * n);
    ASSERT_NEAR(oracle::signed_distance(back, target), step, 0.002 * step + 3 * tolerance) << i << ": " << what;
}

TEST(ShapeQueries, RaysMeetWhatTheExactFormulasMeetIn200000RandomCases) {
    exact::Random r;
    int hits = 0;
    double worst = 0;
    for (int i = 0; i < cases(200000); ++i) {
        const Pair c = random_pair(r, true);
        const Vec2 o{r.in(-4 * c.size, 4 * c.size), r.in(-4 * c.size, 4 * c.size)};
        const Vec2 aim = c.b.points[0] + Vec2{r.in(-0.7 * c.size, 0.7 * c.size), r.in(-0.7 * c.size, 0.7 * c.size)};
        const Vec2 d = r.in(0.3, 3) * (aim - o);
        const CastHit got = cast_ray(c.b, o, d);
        check_cast(i, {{exact::of(o)}, 0, false}, exact::of(d), c.exact_b, got, text(c.b), hits, worst);
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(hits, cases(20000));
    std::printf("rays: %d hits, worst error %.2g of the size\n", hits, worst);
}

TEST(ShapeQueries, MovingShapesMeetWhatTheExactSweepMeetsIn200000RandomCases) {
    exact::Random r;
    int hits = 0;
    double worst = 0;
    for (int i = 0; i < cases(200000); ++i) {
        Pair c = random_pair(r, true);
        const Vec2 from{r.in(-3 * c.size, 3 * c.size), r.in(-3 * c.size, 3 * c.size)};
        const ShapeProxy a = transform_proxy({from, {}}, c.a);
        if (a.count == 0) continue;
        const Vec2 d = i % 16 == 0 ? Vec2{} : r.in(0.3, 3) * (c.b.points[0] - from + Vec2{r.in(-c.size, c.size), r.in(-c.size, c.size)});
        const CastHit got = cast_shape(a, d, c.b);
        check_cast(i, oracle::solid_of(a), exact::of(d), c.exact_b, got, text(a) + " against " + text(c.b), hits, worst);
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(hits, cases(40000));
    std::printf("moving shapes: %d hits, worst error %.2g of the size\n", hits, worst);
}

TEST(ShapeQueries, ARayThatStartsInsideHitsAtOnceAndKnowsTheWayOut) {
    const ShapeProxy box = make_proxy(make_box(2, 1));
    for (const Vec2 d : {Vec2{0, 0}, Vec2{9, 0}, Vec2{0, 9}, Vec2{-3, -3}}) {
        const CastHit hit = cast_ray(box, {0.5f, 0.75f}, d);
        ASSERT_TRUE(hit);
        EXPECT_EQ(hit.fraction, 0);
        EXPECT_EQ(hit.normal, (Vec2{0, 1})) << "the top, 0.25 m away, is the nearest face";
        EXPECT_FLOAT_EQ(hit.separation, -0.25f);
        EXPECT_EQ(hit.point, (Vec2{0.5f, 1}));
    }
}

TEST(ShapeQueries, ARayFromTheSurfaceMeetsItOnlyOnTheWayIn) {
    for (const ShapeProxy& shape : {make_proxy(make_box(1, 1)), make_proxy(make_rounded_box(0.5f, 0.5f, 0.5f)), make_proxy(Circle{{0, 0}, 1}),
                                    make_proxy(Capsule{{-1, 0}, {1, 0}, 1})}) {
        EXPECT_TRUE(cast_ray(shape, {0, 1}, {0, -1})) << "downwards from the top";
        EXPECT_EQ(cast_ray(shape, {0, 1}, {0, -1}).fraction, 0);
        EXPECT_FALSE(cast_ray(shape, {0, 1}, {0, 1})) << "upwards from the top";
        EXPECT_FALSE(cast_ray(shape, {0, 1}, {1, 0})) << "along the top";
    }
}

TEST(ShapeQueries, NoRaySlipsThroughTheCornerThatTwoSegmentsShare) {
    exact::Random r;
    for (int i = 0; i < cases(100000); ++i) {
        const Vec2 left{r.in(-20, -5), r.in(-2, 2)}, middle{r.in(-1, 1), r.in(-1, 1)}, right{r.in(5, 20), r.in(-2, 2)};
        const ShapeProxy one = make_proxy(Segment{left, middle}), two = make_proxy(Segment{middle, right});
        // Aimed at the very corner, from above and from below.
        const Vec2 from{r.in(-3, 3), i % 2 == 0 ? 9.0f : -9.0f};
        const Vec2 way = 2.0f * (middle - from);
        ASSERT_TRUE(cast_ray(one, from, way) || cast_ray(two, from, way)) << i;
    }
}

TEST(ShapeQueries, OneSidedSegmentsLetPassFromBehind) {
    // A floor runs from right to left: solid ground below.
    const ShapeProxy floor = make_proxy(ChainSegment{{9, 0}, {{5, 0}, {-5, 0}}, {-9, 0}});
    EXPECT_TRUE(cast_ray(floor, {0, 2}, {0, -4}));
    EXPECT_EQ(cast_ray(floor, {0, 2}, {0, -4}).normal, (Vec2{0, 1}));
    EXPECT_FALSE(cast_ray(floor, {0, -2}, {0, 4}));
    const auto ball = [](Vec2 at) { return make_proxy(Circle{at, 0.5f}); };
    EXPECT_FLOAT_EQ(cast_shape(ball({0, 2}), {0, -3}, floor).fraction, 0.5f);
    EXPECT_FALSE(cast_shape(ball({0, -2}), {0, 3}, floor));
    EXPECT_FALSE(cast_shape(ball({0, -0.25f}), {0, -3}, floor)) << "reaches through, but its centre is behind";
    EXPECT_TRUE(cast_shape(ball({0, 0.25f}), {0, -3}, floor));
    EXPECT_FALSE(cast_shape(ball({0, 0.25f}), {0, 3}, floor)) << "on its way out";
}

TEST(ShapeQueries, ABoxThatSlidesOnAFloorDoesNotMeetIt) {
    const ShapeProxy floor = make_proxy(make_offset_box(50, 1, {{0, -1}, {}}));
    EXPECT_FALSE(cast_shape(make_proxy(make_offset_box(0.5f, 0.5f, {{0, 0.5f}, {}})), {9, 0}, floor));
    EXPECT_FALSE(cast_shape(make_proxy(Circle{{0, 0.5f}, 0.5f}), {9, 0}, floor));
    const CastHit down = cast_shape(make_proxy(Circle{{0, 0.5f}, 0.5f}), {9, -0.01f}, floor);
    EXPECT_TRUE(down);
    EXPECT_EQ(down.normal, (Vec2{0, 1}));
}

TEST(ShapeQueries, PointsAreContainedBySolidsAndTheirSurfacesOnly) {
    EXPECT_TRUE(contains(make_proxy(Circle{{1, 1}, 2}), {3, 1}));
    EXPECT_FALSE(contains(make_proxy(Circle{{1, 1}, 2}), {3.001f, 1}));
    EXPECT_TRUE(contains(make_proxy(make_box(1, 1)), {1, 1}));
    EXPECT_TRUE(contains(make_proxy(Capsule{{0, 0}, {2, 0}, 0.5f}), {2.5f, 0}));
    EXPECT_FALSE(contains(make_proxy(make_rounded_box(1, 1, 0.5f)), {1.4f, 1.4f})) << "0.57 m from the corner";
    EXPECT_TRUE(contains(make_proxy(make_rounded_box(1, 1, 0.5f)), {1.3f, 1.3f})) << "0.42 m from it";
    EXPECT_FALSE(contains(make_proxy(Segment{{0, 0}, {2, 0}}), {1, 0}));
}

bool finite(const CastHit& h) { return is_finite(h.fraction) && is_finite(h.point) && is_finite(h.normal) && is_finite(h.separation); }

TEST(ShapeQueries, NoFiniteInputGivesANaN) {
    exact::Random r;
    const float sizes[] = {1e-30f, 1e-9f, 1e-3f, 1, 1e3f, 1e7f};
    const auto number = [&] { return sizes[r.below(6)] * static_cast<float>(static_cast<int>(r.below(5)) - 2); };
    int hits = 0;
    for (int i = 0; i < cases(200000); ++i) {
        // Corners in any order: mostly invalid ones, which must be refused; of one and two points, all alike as well.
        ShapeProxy p[2];
        for (ShapeProxy& s : p) {
            s.count = r.below(10);
            s.radius = r.below(2) == 0 ? 0 : sizes[r.below(6)];
            for (Vec2& v : s.points) v = {number(), number()};
            if (r.below(3) == 0) s = make_proxy(make_box(sizes[r.below(6)], sizes[r.below(6)]));
        }
        const Vec2 d{number(), number()};
        const CastHit ray = cast_ray(p[0], {number(), number()}, d), cast = cast_shape(p[0], d, p[1]);
        const Separation apart = separation(p[0], p[1]);
        ASSERT_TRUE(finite(ray) && finite(cast)) << i << ": " << text(p[0]) << " and " << text(p[1]);
        ASSERT_TRUE(is_finite(apart.distance) && is_finite(apart.point_a) && is_finite(apart.point_b) && is_finite(apart.normal)) << i;
        hits += ray.hit || cast.hit ? 1 : 0;
    }
    EXPECT_GT(hits, cases(10000));
}

TEST(ShapeQueries, WhatIsNotValidIsMetByNothing) {
    const float nan = __builtin_nanf("");
    EXPECT_EQ(make_proxy(Circle{{0, 0}, -1}).count, 0u);
    EXPECT_EQ(make_proxy(Capsule{{0, 0}, {0, 0}, 1}).count, 0u);
    EXPECT_EQ(make_proxy(Polygon{}).count, 0u);
    EXPECT_EQ(make_proxy(Aabb{{0, 0}, {0, 1}}).count, 0u);
    EXPECT_EQ(make_proxy(std::span<const Vec2>{}).count, 0u);
    EXPECT_EQ(transform_proxy({{nan, 0}, {}}, make_proxy(Circle{})).count, 0u);
    const ShapeProxy good = make_proxy(make_box(1, 1));
    ShapeProxy turned = good;
    std::swap(turned.points[0], turned.points[1]);
    for (const ShapeProxy& bad : {ShapeProxy{}, turned}) {
        EXPECT_FALSE(cast_ray(bad, {0, 9}, {0, -20}));
        EXPECT_FALSE(cast_shape(bad, {0, -20}, good));
        EXPECT_FALSE(overlaps(bad, good));
        EXPECT_EQ(separation(good, bad).normal, Vec2{});
    }
    EXPECT_FALSE(cast_ray(good, {0, nan}, {0, -20}));
    EXPECT_FALSE(cast_ray(good, {0, 9}, {0, nan}));
    EXPECT_FALSE(cast_ray(good, {0, 9}, {0, -3e7f}));
    EXPECT_FALSE(contains(good, {nan, 0}));
}

}  // namespace
