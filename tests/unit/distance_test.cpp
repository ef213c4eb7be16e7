// GJK distance against an exact search over all corners and edges in double precision.
#include "collide/distance.hpp"

#include <gtest/gtest.h>

#include "islet/query.hpp"

#include "exact_geometry.hpp"
#include "support/effort.hpp"

namespace {

using exact::Core;
using exact::Point;
using islet::ShapeProxy;
using islet::Transform;
using islet::Vec2;
using islet::detail::DistanceResult;
using islet::test::cases;

// Largest error allowed, relative to the largest coordinate in the problem: seven roundings of single precision. Measured: 1.4e-7.
constexpr double relative_error = 4e-7;

/// Of rounded shapes, the second at a pose: core_distance, less the radii.
DistanceResult distance_of(const ShapeProxy& a, const ShapeProxy& b, const Transform& b_in_a) {
    Vec2 moved[islet::max_polygon_vertices];
    for (std::uint32_t i = 0; i < b.count; ++i) moved[i] = transform_point(b_in_a, b.points[i]);
    DistanceResult result = islet::detail::core_distance(a.points, a.count, moved, b.count);
    result.point_a += a.radius * result.normal;
    result.point_b -= b.radius * result.normal;
    result.distance -= a.radius + b.radius;
    return result;
}

ShapeProxy random_proxy(exact::Random& r, double size) {
    ShapeProxy p;
    p.count = 1 + r.below(islet::max_polygon_vertices);
    const double squash = r.below(4) == 0 ? 0.01 : 1.0;
    for (std::uint32_t i = 0; i < p.count; ++i) p.points[i] = {r.in(-size, size), r.in(-size * squash, size * squash)};
    if (r.below(3) == 0) {  // the corners of a box: parallel edges are the hard case
        p.count = 4;
        const Vec2 h = {r.in(0.01, size), r.in(0.01, size)};
        p.points[0] = -h, p.points[1] = {h.x, -h.y}, p.points[2] = h, p.points[3] = {-h.x, h.y};
    }
    return p;
}

Point moved_corner(const ShapeProxy& p, const Transform& t, std::uint32_t i) { return exact::moved(t, exact::of(p.points[i])); }

struct Case {
    ShapeProxy a, b;
    Transform pose;
    double scale = 0;
    Core exact_a, exact_b;
};

Case random_case(exact::Random& r) {
    Case c;
    const double size = std::pow(10.0, r.in(-1, 1));
    c.a = random_proxy(r, size);
    c.b = random_proxy(r, size);
    c.pose = r.pose(2 * size);
    if (r.below(3) == 0) c.pose.q = islet::make_rot(static_cast<float>(r.below(4)) * 1.57079633f);
    c.exact_a = exact::hull_of(exact::core_of(c.a.points, c.a.count));
    c.exact_b = exact::hull_of(exact::core_of(c.b.points, c.b.count, c.pose));
    c.scale = 5 * size;
    return c;
}

TEST(Distance, AgreesWithTheExactSearchFor200000RandomPairs) {
    exact::Random r;
    double worst = 0;
    int apart = 0;
    for (int i = 0; i < cases(200000); ++i) {
        const Case c = random_case(r);
        const DistanceResult got = distance_of(c.a, c.b, c.pose);
        const double want = exact::distance(c.exact_a, c.exact_b);
        const double error = std::fabs(static_cast<double>(got.distance) - want) / c.scale;
        worst = std::max(worst, error);
        apart += want > 0 ? 1 : 0;
        ASSERT_LT(error, relative_error) << "case " << i << ": got " << got.distance << ", exact " << want;
    }
    EXPECT_GT(apart, cases(50000));
    EXPECT_LT(apart, cases(190000));
    RecordProperty("worst_relative_error_e9", static_cast<int>(worst * 1e9));
}

TEST(Distance, ClosestPointsLieOnTheShapesAndAreThatFarApart) {
    exact::Random r;
    for (int i = 0; i < cases(100000); ++i) {
        const Case c = random_case(r);
        const DistanceResult got = distance_of(c.a, c.b, c.pose);
        const double tolerance = relative_error * c.scale;
        const double want = exact::distance(c.exact_a, c.exact_b);
        const Point a = exact::of(got.point_a), b = exact::of(got.point_b), n = exact::of(got.normal);
        ASSERT_LT(exact::to_core(c.exact_a, a), tolerance) << "case " << i;
        ASSERT_LT(exact::to_core(c.exact_b, b), tolerance) << "case " << i;
        ASSERT_NEAR(exact::length(b - a), static_cast<double>(got.distance), tolerance) << "case " << i;
        if (got.distance > 0) {
            ASSERT_NEAR(exact::length(n), 1.0, 1e-6) << "case " << i;
            // The normal separates the shapes by the whole distance: no other direction does. Rounding can turn it by what the corners
            // move over the length it was taken from: the distance itself or the edge that is closest.
            double base = want;
            if (got.count == 2) {
                const auto corner = [&](int k) { return moved_corner(c.b, c.pose, got.index_b[k]) - exact::of(c.a.points[got.index_a[k]]); };
                base = std::max(base, exact::length(corner(1) - corner(0)));
            }
            ASSERT_NEAR(exact::gap_along(c.exact_a, c.exact_b, n), want, tolerance * (1 + c.scale / base)) << "case " << i;
        } else {
            ASSERT_EQ(got.normal, Vec2{}) << "case " << i;
        }
    }
}

TEST(Distance, NamesTheCornersThatCarryTheClosestPoints) {
    ShapeProxy box;
    box.count = 4;
    box.points[0] = {-1, -1}, box.points[1] = {1, -1}, box.points[2] = {1, 1}, box.points[3] = {-1, 1};
    ShapeProxy point;
    point.count = 1;
    // Beyond a corner: that corner.
    DistanceResult r = distance_of(box, point, {{4, 5}, {}});
    EXPECT_FLOAT_EQ(r.distance, 5.0f);
    EXPECT_EQ(r.count, 1u);
    EXPECT_EQ(r.index_a[0], 2);
    EXPECT_EQ(r.index_b[0], 0);
    // Above a face: both ends of that face.
    r = distance_of(box, point, {{0.25f, 3}, {}});
    EXPECT_FLOAT_EQ(r.distance, 2.0f);
    EXPECT_EQ(r.normal, (Vec2{0, 1}));
    ASSERT_EQ(r.count, 2u);
    EXPECT_EQ(r.index_a[0] + r.index_a[1], 2 + 3);
    EXPECT_EQ(r.point_a, (Vec2{0.25f, 1}));
    // Inside: no direction, three corners.
    r = distance_of(box, point, {{0.25f, 0.5f}, {}});
    EXPECT_EQ(r.distance, 0.0f);
    EXPECT_EQ(r.count, 3u);
    EXPECT_EQ(r.normal, Vec2{});
}

TEST(Distance, RadiiMoveTheSurfacesTowardsEachOther) {
    ShapeProxy a, b;
    a.count = 1, a.radius = 1;
    b.count = 1, b.radius = 0.5f;
    DistanceResult r = distance_of(a, b, {{4, 0}, {}});
    EXPECT_FLOAT_EQ(r.distance, 2.5f);
    EXPECT_EQ(r.point_a, (Vec2{1, 0}));
    EXPECT_EQ(r.point_b, (Vec2{3.5f, 0}));
    // Only the rounding overlaps: the distance goes on below zero and the normal stays.
    r = distance_of(a, b, {{1, 0}, {}});
    EXPECT_FLOAT_EQ(r.distance, -0.5f);
    EXPECT_EQ(r.normal, (Vec2{1, 0}));
    // Coincident cores.
    r = distance_of(a, b, {});
    EXPECT_FLOAT_EQ(r.distance, -1.5f);
    EXPECT_EQ(r.normal, Vec2{});
}

TEST(Distance, DegenerateCoresGiveFiniteAnswers) {
    // All points alike, all in a line, the same line, end to end in a line.
    ShapeProxy dot_proxy, line, same;
    dot_proxy.count = 8;
    line.count = 8;
    for (std::uint32_t i = 0; i < 8; ++i) line.points[i] = {static_cast<float>(i), 0};
    same = line;
    const Transform poses[] = {{}, {{7, 0}, {}}, {{8, 0}, {}}, {{-8, 0}, {}}, {{0, 1}, {}}, {{3, 0}, {0, 1}}, {{3.5f, -3.5f}, {0, 1}}, {{0, 1e-20f}, {}}};
    const float want[] = {0, 0, 1, 1, 1, 0, 0, 0};
    for (int i = 0; i < 8; ++i) {
        const DistanceResult r = distance_of(line, same, poses[i]);
        EXPECT_FLOAT_EQ(r.distance, want[i]) << i;
        EXPECT_TRUE(islet::is_finite(r.point_a) && islet::is_finite(r.point_b) && islet::is_finite(r.normal)) << i;
    }
    for (const Transform& t : poses) {
        const DistanceResult r = distance_of(dot_proxy, dot_proxy, t);
        EXPECT_TRUE(islet::is_finite(r.point_a) && islet::is_finite(r.normal) && islet::is_finite(r.distance));
        EXPECT_NEAR(static_cast<double>(r.distance), exact::length(exact::of(t.p)), 1e-6);
    }
}

}  // namespace
