// Hulls against the definition of a convex hull, mass against Green's theorem in long double, bounds against sampled outlines.
#include "islet/geometry.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "support/effort.hpp"

namespace {

using namespace islet;
using test::cases;

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr long double exact_pi = std::numbers::pi_v<long double>;

struct LongPoint {
    long double x = 0, y = 0;
};

LongPoint exact(Vec2 v) { return {v.x, v.y}; }
long double cross(LongPoint o, LongPoint a, LongPoint b) { return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x); }
long double dot(LongPoint o, LongPoint a, LongPoint b) { return (a.x - o.x) * (b.x - o.x) + (a.y - o.y) * (b.y - o.y); }

bool on_segment(LongPoint p, LongPoint a, LongPoint b) { return cross(a, b, p) == 0 && dot(p, a, b) <= 0; }

bool in_triangle(LongPoint p, LongPoint a, LongPoint b, LongPoint c) {
    if (cross(a, b, c) == 0) return on_segment(p, a, b) || on_segment(p, b, c) || on_segment(p, c, a);
    const long double u = cross(a, b, p), v = cross(b, c, p), w = cross(c, a, p);
    return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
}

// The corners of the hull by Caratheodory's theorem: a point is none if some triangle of other points (however thin) holds it.
std::vector<Vec2> brute_force_corners(std::vector<Vec2> points) {
    std::sort(points.begin(), points.end(), [](Vec2 a, Vec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    points.erase(std::unique(points.begin(), points.end()), points.end());
    std::vector<Vec2> corners;
    for (const Vec2 p : points) {
        std::vector<Vec2> others = points;
        others.erase(std::find(others.begin(), others.end(), p));
        bool inside = false;
        for (const Vec2 a : others)
            for (const Vec2 b : others)
                for (const Vec2 c : others) inside = inside || in_triangle(exact(p), exact(a), exact(b), exact(c));
        if (!inside) corners.push_back(p);
    }
    return corners;
}

std::vector<Vec2> corners_of(const Hull& hull) { return {hull.points, hull.points + hull.count}; }

// Signed distance of p to the left of the line from a to b.
long double left_of(LongPoint a, LongPoint b, LongPoint p) { return cross(a, b, p) / std::hypot(b.x - a.x, b.y - a.y); }

void expect_convex_counter_clockwise(const Hull& hull) {
    for (std::uint32_t i = 0; i < hull.count; ++i) {
        const std::uint32_t j = (i + 1) % hull.count, k = (i + 2) % hull.count;
        const LongPoint a = exact(hull.points[i]), b = exact(hull.points[j]), c = exact(hull.points[k]);
        ASSERT_GE(std::hypot(b.x - a.x, b.y - a.y), 0.00499L);
        ASSERT_GE(-left_of(a, c, b), 0.00049L) << "corner " << j << " does not stand out";
        for (std::uint32_t m = 0; m < hull.count; ++m) {
            if (m != i && m != j) { ASSERT_GT(left_of(a, b, exact(hull.points[m])), 0) << "corner " << m << ", edge " << i; }
        }
    }
}

TEST(Hull, HasExactlyTheCornersOfTheDefinition) {
    // Points on a coarse grid: all arithmetic is exact, and duplicates and collinear triples are plenty.
    std::mt19937 random(1);
    int with_hull = 0;
    for (int trial = 0; trial < cases(12000); ++trial) {
        const auto count = 3 + random() % 6;
        const auto size = 2 + random() % 6;
        std::vector<Vec2> points(count);
        for (Vec2& p : points)
            p = {0.25f * static_cast<float>(random() % size) - 0.5f, 0.25f * static_cast<float>(random() % size) - 0.75f};
        std::vector<Vec2> expected = brute_force_corners(points);
        if (expected.size() < 3) expected.clear();  // all points in one line

        const Hull hull = compute_hull(points);
        expect_convex_counter_clockwise(hull);
        std::vector<Vec2> found = corners_of(hull);
        std::sort(found.begin(), found.end(), [](Vec2 a, Vec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
        ASSERT_EQ(found, expected) << "trial " << trial;
        with_hull += hull.count > 0;
    }
    EXPECT_GT(with_hull, cases(8000));
}

TEST(Hull, HoldsEveryPointUpToTheDroppedCornersAtAnyScaleAndPlace) {
    std::mt19937 random(2);
    std::uniform_real_distribution<float> unit(-1, 1), exponent(-6, 6);
    for (int trial = 0; trial < cases(20000); ++trial) {
        const float size = std::exp2(exponent(random));
        const Vec2 place{unit(random) * 1000, unit(random) * 1000};
        std::vector<Vec2> points(3 + random() % 6);
        for (Vec2& p : points) p = place + size * Vec2{unit(random), unit(random)};
        if (trial % 3 == 0) points.back() = points.front() + 0.001f * Vec2{unit(random), unit(random)};  // nearly a duplicate
        if (trial % 4 == 0) points[1] = lerp(points[0], points[2], 0.5f + 0.5f * unit(random));          // nearly in a line
        const Hull hull = compute_hull(points);
        expect_convex_counter_clockwise(hull);
        for (std::uint32_t i = 0; i < hull.count; ++i) {
            ASSERT_NE(std::find(points.begin(), points.end(), hull.points[i]), points.end()) << "a corner that was not given";
            for (const Vec2 p : points)
                ASSERT_GT(left_of(exact(hull.points[i]), exact(hull.points[(i + 1) % hull.count]), exact(p)), -0.0075L);
        }
        if (hull.count == 0 && size > 1) {  // only a sliver has none
            long double widest = 0;
            for (const Vec2 a : points)
                for (const Vec2 b : points)
                    for (const Vec2 c : points) {
                        const long double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
                        if (longest > 0) widest = std::max(widest, cross(exact(a), exact(b), exact(c)) / longest);
                    }
            ASSERT_LT(widest, 0.0075L);
        }
    }
}

TEST(Hull, DoesNotDependOnTheOrderOfThePoints) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> number(-0.02f, 0.02f);  // small enough for many corners to be dropped
    for (int trial = 0; trial < 5000; ++trial) {
        std::vector<Vec2> points(8);
        for (Vec2& p : points) p = {number(random), number(random)};
        points[5].x = -0.0f;
        points[6] = {0.0f, points[5].y};
        const Hull hull = compute_hull(points);
        for (int i = 0; i < 5; ++i) {
            std::shuffle(points.begin(), points.end(), random);
            const Hull again = compute_hull(points);
            ASSERT_EQ(std::memcmp(&hull, &again, sizeof hull), 0);
        }
    }
}

TEST(Hull, OfTwoCornersTooCloseKeepsTheOneThatStandsOutMore) {
    const Vec2 points[] = {{0, 0}, {0.002f, -0.001f}, {1, 0}, {1, 1}, {0, 1}};
    EXPECT_EQ(corners_of(compute_hull(points)), (std::vector<Vec2>{{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
}

TEST(Hull, KeepsAllEightCornersOfAnOctagonFarFromTheOrigin) {
    std::vector<Vec2> points;
    for (int i = 0; i < 8; ++i) {
        const Rot q = make_rot(static_cast<float>(i) * pi / 4);
        points.push_back({5000 + q.c, -3000 + q.s});
    }
    EXPECT_EQ(compute_hull(points).count, 8u);
}

TEST(Hull, OfOneLineOrTooFewOrTooManyOrBadPointsIsEmpty) {
    const auto count = [](std::vector<Vec2> points) { return compute_hull(points).count; };
    EXPECT_EQ(count({}), 0u);
    EXPECT_EQ(count({{0, 0}, {1, 0}}), 0u);
    EXPECT_EQ(count({{0, 0}, {1, 1}, {2, 2}, {3, 3}, {0.5f, 0.5f}}), 0u);
    EXPECT_EQ(count({{0.1f, 0.3f}, {0.2f, 0.6f}, {0.7f, 2.1f}}), 0u);  // a line but for rounding
    EXPECT_EQ(count({{1, 1}, {1, 1}, {1, 1}}), 0u);
    EXPECT_EQ(count({{0, 0}, {1, 0}, {1, 0.004f}}), 0u);  // two corners closer than 5 mm
    EXPECT_EQ(count({{0, 0}, {1, 0}, {1, 0.006f}}), 3u);
    EXPECT_EQ(count({{0, 0}, {1, 0}, {0.5f, 0.0004f}}), 0u);  // stands out by less than 0.5 mm
    EXPECT_EQ(count({{0, 0}, {1, 0}, {1, 1}, {0.5f, 1.0004f}, {0, 1}}), 4u);
    for (const float bad : {nan, inf, -inf, 1e30f, -2e7f}) {
        EXPECT_EQ(count({{0, 0}, {1, 0}, {0, 1}, {bad, 0}}), 0u);
        EXPECT_EQ(count({{0, bad}, {1, 0}, {0, 1}}), 0u);
    }
    std::vector<Vec2> nine;
    for (int i = 0; i < 9; ++i) nine.push_back({make_rot(0.69f * static_cast<float>(i)).c, make_rot(0.69f * static_cast<float>(i)).s});
    EXPECT_EQ(count(nine), 0u);
}

TEST(Box, HasTheStatedCornersNormalsAndZeroesElsewhere) {
    const Polygon box = make_box(2, 0.5f);
    Polygon expected;
    expected.count = 4;
    const Vec2 vertices[] = {{-2, -0.5f}, {2, -0.5f}, {2, 0.5f}, {-2, 0.5f}}, normals[] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
    std::copy(vertices, vertices + 4, expected.vertices);
    std::copy(normals, normals + 4, expected.normals);
    EXPECT_EQ(std::memcmp(&box, &expected, sizeof box), 0);
    const Polygon from_hull = make_polygon(compute_hull(vertices));
    EXPECT_EQ(std::memcmp(&from_hull, &expected, sizeof box), 0);
    EXPECT_EQ(make_rounded_box(2, 0.5f, 0.25f).radius, 0.25f);
    EXPECT_EQ(make_rounded_box(2, 0.5f, 0.25f).vertices[2], (Vec2{2, 0.5f}));
}

TEST(Box, OfNoOrBadSizeIsEmpty) {
    for (const float bad : {0.0f, -1.0f, nan, inf}) {
        EXPECT_EQ(make_box(bad, 1).count, 0u);
        EXPECT_EQ(make_box(1, bad).count, 0u);
        EXPECT_EQ(make_offset_box(bad, 1, {}).count, 0u);
    }
    for (const float bad : {-0.1f, nan, inf}) {
        EXPECT_EQ(make_rounded_box(1, 1, bad).count, 0u);
        EXPECT_EQ(make_polygon(compute_hull(std::vector<Vec2>{{0, 0}, {1, 0}, {0, 1}}), bad).count, 0u);
    }
    EXPECT_EQ(make_offset_box(1, 1, {{nan, 0}, {}}).count, 0u);
    EXPECT_EQ(make_polygon({}).count, 0u);
}

TEST(Box, OffsetTurnsThenMoves) {
    const Polygon box = make_offset_box(2, 1, {{10, 20}, make_rot(pi / 2)}, 0.1f);
    EXPECT_NEAR(box.vertices[0].x, 11, 1e-5f);
    EXPECT_NEAR(box.vertices[0].y, 18, 1e-5f);
    EXPECT_NEAR(box.normals[0].x, 1, 1e-6f);
    EXPECT_EQ(box.centroid, (Vec2{10, 20}));
    EXPECT_EQ(box.radius, 0.1f);
    EXPECT_TRUE(is_valid(box));
    EXPECT_TRUE(is_valid(make_offset_box(0.5f, 0.5f, {{10000, -10000}, make_rot(0.3f)})));
}

// A random convex polygon: corners in order of angle on an ellipse.
Polygon random_polygon(std::mt19937& random, float radius, Vec2 place = {}) {
    std::uniform_real_distribution<float> unit(0, 1);
    const float a = 0.2f + 2 * unit(random), b = 0.2f + 2 * unit(random), turn = 6 * unit(random);
    std::vector<Vec2> points(3 + random() % 6);
    for (Vec2& p : points) {
        const Rot q = make_rot(6.28f * unit(random));
        p = place + rotate(make_rot(turn), {a * q.c, b * q.s});
    }
    return make_polygon(compute_hull(points), radius);
}

// The outline of a polygon rounded by its radius: every corner becomes an arc of many small chords.
std::vector<LongPoint> outline(const Polygon& p, int chords) {
    std::vector<LongPoint> points;
    for (std::uint32_t i = 0; i < p.count; ++i) {
        const LongPoint a = exact(p.vertices[(i + p.count - 1) % p.count]), b = exact(p.vertices[i]), c = exact(p.vertices[(i + 1) % p.count]);
        const long double from = std::atan2(a.x - b.x, b.y - a.y), to = std::atan2(b.x - c.x, c.y - b.y);
        const long double turn = to < from ? to + 2 * exact_pi - from : to - from;
        for (int k = 0; k <= chords; ++k) {
            const long double t = from + turn * k / chords;
            points.push_back({b.x + p.radius * std::cos(t), b.y + p.radius * std::sin(t)});
        }
    }
    return points;
}

struct ExactMass {
    long double area = 0, x = 0, y = 0, inertia = 0;  // about the centre (x, y)
};

// Green's theorem: area integrals as sums over the edges of the outline. Relative error of n chords per arc: below 10 / n^2.
ExactMass green(const std::vector<LongPoint>& points) {
    const LongPoint o = points[0];
    ExactMass m;
    long double second = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const LongPoint a{points[i].x - o.x, points[i].y - o.y}, next = points[(i + 1) % points.size()], b{next.x - o.x, next.y - o.y};
        const long double w = a.x * b.y - a.y * b.x;
        m.area += w / 2;
        m.x += w * (a.x + b.x) / 6;
        m.y += w * (a.y + b.y) / 6;
        second += w * (a.x * a.x + a.x * b.x + b.x * b.x + a.y * a.y + a.y * b.y + b.y * b.y) / 12;
    }
    m.x /= m.area;
    m.y /= m.area;
    m.inertia = second - m.area * (m.x * m.x + m.y * m.y);
    m.x += o.x;
    m.y += o.y;
    return m;
}

void expect_mass(const MassData& m, const ExactMass& e, float density, long double tolerance) {
    const auto size = std::sqrt(e.area);
    ASSERT_NEAR(static_cast<double>(m.mass / (e.area * density)), 1, static_cast<double>(tolerance));
    ASSERT_NEAR(static_cast<double>(m.inertia / (e.inertia * density)), 1, static_cast<double>(tolerance));
    const long double off = std::hypot(m.center.x - e.x, m.center.y - e.y), rounding = 6e-8L * (std::fabs(e.x) + std::fabs(e.y));
    ASSERT_LE(off, tolerance * size * 10 + rounding);
}

TEST(Mass, OfRandomPolygonsMatchesGreensTheorem) {
    std::mt19937 random(4);
    int solid = 0;
    for (int trial = 0; trial < 5000; ++trial) {
        const Polygon p = random_polygon(random, 0);
        if (p.count == 0) continue;
        const ExactMass e = green(outline(p, 1));
        // The error grows with slenderness: the corners themselves are only given to 1e-7.
        const long double slender = e.inertia / (e.area * e.area);
        expect_mass(compute_mass(p, 3), e, 3, 2e-6L * std::max(1.0L, slender));
        ASSERT_LE(std::hypot(p.centroid.x - e.x, p.centroid.y - e.y), 2e-6L * std::max(1.0L, slender));
        ++solid;
    }
    EXPECT_GT(solid, 4000);
}

TEST(Mass, OfRoundedPolygonsIsThatOfTheExactMinkowskiSum) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> exponent(-6, 3);
    for (int trial = 0; trial < 150; ++trial) {
        const Polygon p = random_polygon(random, std::exp2(exponent(random)));
        if (p.count == 0) continue;
        const ExactMass e = green(outline(p, 2000));
        expect_mass(compute_mass(p, 0.7f), e, 0.7f, 2e-6L * std::max(1.0L, e.inertia / (e.area * e.area)));
        // Steiner's formula, so that the test's own outline is known to be right: area + perimeter r + pi r^2.
        long double perimeter = 0;
        Polygon core = p;
        core.radius = 0;
        for (std::uint32_t i = 0; i < p.count; ++i) perimeter += distance(p.vertices[i], p.vertices[(i + 1) % p.count]);
        const long double r = p.radius, steiner = green(outline(core, 1)).area + perimeter * r + exact_pi * r * r;
        ASSERT_NEAR(static_cast<double>(e.area / steiner), 1, 1e-6);
    }
}

TEST(Mass, OfBoxesFollowsTheTextbook) {
    const MassData box = compute_mass(make_box(1.5f, 0.5f), 2);
    EXPECT_FLOAT_EQ(box.mass, 2 * 3 * 1);
    EXPECT_FLOAT_EQ(box.inertia, 6.0f * (9 + 1) / 12);
    EXPECT_EQ(box.center, Vec2{});
}

TEST(Mass, OfARoundedBoxWithAlmostNoCoreIsThatOfADisc) {
    const MassData disc = compute_mass(Circle{{}, 0.5f}, 4), box = compute_mass(make_rounded_box(1e-5f, 1e-5f, 0.5f), 4);
    EXPECT_NEAR(box.mass, disc.mass, 2e-4f);
    EXPECT_NEAR(box.inertia, disc.inertia, 1e-4f);
}

TEST(Mass, DoesNotDependOnTheDistanceFromTheOrigin) {
    const Polygon near = make_rounded_box(0.5f, 0.25f, 0.125f);
    const Polygon far = transform_polygon({{4096, -8192}, {}}, near);
    const MassData a = compute_mass(near, 1), b = compute_mass(far, 1);
    EXPECT_FLOAT_EQ(a.mass, b.mass);
    EXPECT_FLOAT_EQ(a.inertia, b.inertia);
    EXPECT_EQ(b.center, (Vec2{4096, -8192}));
    EXPECT_EQ(far.centroid, (Vec2{4096, -8192}));
}

TEST(Mass, OfCirclesFollowsTheTextbook) {
    const MassData m = compute_mass(Circle{{3, 4}, 0.5f}, 8);
    EXPECT_FLOAT_EQ(m.mass, 2 * pi);
    EXPECT_FLOAT_EQ(m.inertia, 0.25f * pi);
    EXPECT_EQ(m.center, (Vec2{3, 4}));
}

TEST(Mass, OfCapsulesMatchesGreensTheorem) {
    std::mt19937 random(6);
    std::uniform_real_distribution<float> place(-5, 5), exponent(-4, 3);
    for (int trial = 0; trial < 100; ++trial) {
        const Capsule c{{place(random), place(random)}, {place(random), place(random)}, std::exp2(exponent(random))};
        if (!is_valid(c)) continue;
        Polygon two_corners;  // not a valid polygon, but the outline of a capsule all the same
        two_corners.count = 2;
        two_corners.vertices[0] = c.point1;
        two_corners.vertices[1] = c.point2;
        two_corners.radius = c.radius;
        expect_mass(compute_mass(c, 5), green(outline(two_corners, 3000)), 5, 2e-6L);
    }
}

TEST(Mass, OfAnInvalidShapeOrDensityIsZero) {
    for (const float bad : {-1.0f, nan, inf}) {
        EXPECT_EQ(compute_mass(make_box(1, 1), bad).mass, 0.0f);
        EXPECT_EQ(compute_mass(Circle{{}, bad}, 1).mass, 0.0f);
        EXPECT_EQ(compute_mass(Capsule{{}, {1, 0}, bad}, 1).mass, 0.0f);
    }
    EXPECT_EQ(compute_mass(Polygon{}, 1).mass, 0.0f);
    EXPECT_EQ(compute_mass(Circle{{}, 1e6f}, 1e30f).inertia, 0.0f);  // would overflow
    EXPECT_EQ(compute_mass(make_box(1, 2), 0).mass, 0.0f);           // no density is allowed: a shape without mass
    EXPECT_TRUE(is_finite(compute_mass(make_rounded_box(1e7f, 1e7f, 1e7f), 1000).inertia));
}

// The box must hold the whole outline, and touch it on all four sides.
void expect_tight(const Aabb& box, const std::vector<LongPoint>& points, double slack) {
    long double left = 1e9L, bottom = 1e9L, right = -1e9L, top = -1e9L;
    for (const LongPoint p : points) {
        left = std::min(left, p.x);
        right = std::max(right, p.x);
        bottom = std::min(bottom, p.y);
        top = std::max(top, p.y);
    }
    ASSERT_NEAR(box.lower.x, static_cast<double>(left), slack);
    ASSERT_NEAR(box.lower.y, static_cast<double>(bottom), slack);
    ASSERT_NEAR(box.upper.x, static_cast<double>(right), slack);
    ASSERT_NEAR(box.upper.y, static_cast<double>(top), slack);
}

TEST(Bounds, AreTightAroundTheMovedOutlineOfEveryShape) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> number(-4, 4);
    for (int trial = 0; trial < 200; ++trial) {
        const Transform t{{number(random), number(random)}, make_rot(number(random))};
        const auto moved = [&](std::vector<LongPoint> points) {
            for (LongPoint& p : points) {
                const LongPoint q = p;
                p = {t.q.c * q.x - t.q.s * q.y + t.p.x, t.q.s * q.x + t.q.c * q.y + t.p.y};
            }
            return points;
        };
        Polygon two_corners;
        two_corners.count = 2;
        two_corners.vertices[0] = {number(random), number(random)};
        two_corners.vertices[1] = {number(random), number(random)};
        const Segment segment{two_corners.vertices[0], two_corners.vertices[1]};
        expect_tight(compute_aabb(segment, t), moved({exact(segment.point1), exact(segment.point2)}), 3e-6);
        two_corners.radius = 0.6f;
        expect_tight(compute_aabb(Capsule{segment.point1, segment.point2, 0.6f}, t), moved(outline(two_corners, 1000)), 5e-6);
        two_corners.vertices[1] = two_corners.vertices[0] + Vec2{1e-6f, 0};
        expect_tight(compute_aabb(Circle{segment.point1, 0.6f}, t), moved(outline(two_corners, 1000)), 5e-6);
        const Polygon polygon = random_polygon(random, trial % 2 == 0 ? 0.0f : 0.3f);
        if (polygon.count > 0) expect_tight(compute_aabb(polygon, t), moved(outline(polygon, 1000)), 5e-6);
    }
}

TEST(Validity, AcceptsWhatTheMakersMake) {
    std::mt19937 random(8);
    std::uniform_real_distribution<float> number(-1, 1), exponent(-8, 10);
    for (int trial = 0; trial < cases(20000); ++trial) {
        const Vec2 place{1000 * number(random), 1000 * number(random)};
        const Hull hull = [&] {
            const float size = std::exp2(exponent(random));
            std::vector<Vec2> points(8);
            for (Vec2& p : points) p = place + size * Vec2{number(random), number(random)};
            return compute_hull(points);
        }();
        ASSERT_EQ(make_polygon(hull, 0.1f).count, hull.count);  // no hull is refused
        const Polygon box =
            make_offset_box(std::exp2(exponent(random)), std::exp2(exponent(random)) + 0.01f, {place, make_rot(number(random))});
        ASSERT_TRUE(is_valid(box));
    }
    EXPECT_TRUE(is_valid(make_box(1e-4f, 1e-4f)));
    EXPECT_TRUE(is_valid(make_box(1e6f, 1)));
}

TEST(Validity, RefusesPolygonsThatAreNot) {
    const Polygon good = make_rounded_box(1, 1, 0.1f);
    ASSERT_TRUE(is_valid(good));
    const auto broken = [&](auto change) {
        Polygon p = good;
        change(p);
        return !is_valid(p);
    };
    EXPECT_TRUE(broken([](Polygon& p) { p.count = 0; }));
    EXPECT_TRUE(broken([](Polygon& p) { p.count = 2; }));
    EXPECT_TRUE(broken([](Polygon& p) { p.count = 9; }));
    EXPECT_TRUE(broken([](Polygon& p) { p.count = 0xffffffff; }));
    EXPECT_TRUE(broken([](Polygon& p) { p.radius = -0.1f; }));
    EXPECT_TRUE(broken([](Polygon& p) { p.radius = nan; }));
    EXPECT_TRUE(broken([](Polygon& p) { p.vertices[1].x = nan; }));
    EXPECT_TRUE(broken([](Polygon& p) { p.vertices[1].x = inf; }));
    EXPECT_TRUE(broken([](Polygon& p) { p.normals[1].y = nan; }));
    EXPECT_TRUE(broken([](Polygon& p) { p.centroid.x = nan; }));
    EXPECT_TRUE(broken([](Polygon& p) { p.centroid.x = 1.5f; }));                       // outside
    EXPECT_TRUE(broken([](Polygon& p) { p.normals[2] = {0, 1.1f}; }));                  // not unit
    EXPECT_TRUE(broken([](Polygon& p) { p.normals[2] = {0, -1}; }));                    // inward
    EXPECT_TRUE(broken([](Polygon& p) { p.normals[2] = {0.6f, 0.8f}; }));               // leaning
    EXPECT_TRUE(broken([](Polygon& p) { p.vertices[2] = p.vertices[1]; }));             // an edge of no length
    EXPECT_TRUE(broken([](Polygon& p) { std::reverse(p.vertices, p.vertices + 4); }));  // clockwise
    EXPECT_TRUE(broken([](Polygon& p) { std::swap(p.vertices[1], p.vertices[2]); }));   // crossing itself

    // Five corners each with the right normal, but concave, collinear, or going round twice.
    const auto with_normals = [](std::vector<Vec2> corners) {
        Polygon p;
        p.count = static_cast<std::uint32_t>(corners.size());
        for (std::uint32_t i = 0; i < p.count; ++i) {
            p.vertices[i] = corners[i];
            p.normals[i] = normalize(right_perp(corners[(i + 1) % p.count] - corners[i]));
        }
        return p;
    };
    EXPECT_TRUE(is_valid(with_normals({{-1, -1}, {1, -1}, {1, 1}, {0, 1.2f}, {-1, 1}})));
    EXPECT_FALSE(is_valid(with_normals({{-1, -1}, {1, -1}, {1, 1}, {0, 0.8f}, {-1, 1}})));
    EXPECT_FALSE(is_valid(with_normals({{-1, -1}, {1, -1}, {1, 1}, {0, 1}, {-1, 1}})));
    std::vector<Vec2> star;
    for (int i = 0; i < 5; ++i)
        star.push_back({make_rot(0.8f * pi * static_cast<float>(i)).c, make_rot(0.8f * pi * static_cast<float>(i)).s});
    EXPECT_FALSE(is_valid(with_normals(star)));
}

TEST(Validity, RefusesBadCirclesCapsulesAndSegments) {
    EXPECT_TRUE(is_valid(Circle{{1, 2}, 0.01f}));
    EXPECT_TRUE(is_valid(Capsule{{0, 0}, {0, 0.006f}, 0.01f}));
    EXPECT_TRUE(is_valid(Segment{{0, 0}, {0.006f, 0}}));
    EXPECT_TRUE(is_valid(ChainSegment{{-1, 0}, {{0, 0}, {1, 0}}, {2, 0}}));
    for (const float bad : {0.0f, -1.0f, nan, inf, 1e8f}) {
        EXPECT_FALSE(is_valid(Circle{{1, 2}, bad}));
        EXPECT_FALSE(is_valid(Capsule{{0, 0}, {1, 0}, bad}));
    }
    for (const float bad : {nan, inf, -inf, 1e8f}) {
        EXPECT_FALSE(is_valid(Circle{{1, bad}, 1}));
        EXPECT_FALSE(is_valid(Capsule{{0, 0}, {bad, 0}, 1}));
        EXPECT_FALSE(is_valid(Segment{{0, bad}, {1, 0}}));
        EXPECT_FALSE(is_valid(ChainSegment{{bad, 0}, {{0, 0}, {1, 0}}, {2, 0}}));
        EXPECT_FALSE(is_valid(ChainSegment{{-1, 0}, {{0, 0}, {1, 0}}, {2, bad}}));
    }
    EXPECT_FALSE(is_valid(Capsule{{0, 0}, {0, 0.004f}, 1}));  // shorter than 5 mm
    EXPECT_FALSE(is_valid(Segment{{3, 3}, {3, 3}}));
    EXPECT_FALSE(is_valid(ChainSegment{{-1, 0}, {{0, 0}, {0, 0}}, {2, 0}}));
}

}  // namespace
