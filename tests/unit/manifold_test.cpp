// Contact manifolds of every pair of shapes, against exact geometry in double precision and against situations with a known answer.
#include "shapes/manifolds.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <string>

#include "collide/outline_pair.hpp"
#include "exact_geometry.hpp"
#include "support/effort.hpp"

namespace {

using namespace islet;
using exact::Core;
using exact::Point;
using islet::detail::collide;
using islet::detail::linear_slop;
using islet::detail::Manifold;
using islet::detail::ManifoldPoint;
using islet::detail::separation_tie;
using islet::detail::speculative_distance;
using islet::test::cases;

constexpr double tie = static_cast<double>(separation_tie);
constexpr float margin = speculative_distance;
constexpr float half_pi = 0.5f * pi;

// Positions in the random cases are a few metres: what is left of single precision there.
constexpr double rounding = 3e-6;  // m

double as_double(float a) { return static_cast<double>(a); }

// A manifold under the rules of manifold.hpp, whatever the shapes.
void expect_well_formed(const Manifold& m, float limit, const std::string& what) {
    ASSERT_LE(m.count, 2u) << what;
    if (m.count == 0) return;
    ASSERT_NEAR(exact::length(exact::of(m.normal)), 1.0, 1e-5) << what;
    for (std::uint32_t i = 0; i < m.count; ++i) {
        ASSERT_TRUE(is_finite(m.points[i].point) && is_finite(m.points[i].separation)) << what;
        ASSERT_LE(m.points[i].separation, limit) << what;
    }
    if (m.count == 2) { ASSERT_NE(m.points[0].id, m.points[1].id) << what; }
}

double deepest(const Manifold& m) {
    double least = as_double(m.points[0].separation);
    if (m.count == 2) least = std::min(least, as_double(m.points[1].separation));
    return least;
}

// The two surface points that a manifold point stands midway between.
Point on_a(const Manifold& m, std::uint32_t i) { return exact::of(m.points[i].point) - (0.5 * as_double(m.points[i].separation)) * exact::of(m.normal); }
Point on_b(const Manifold& m, std::uint32_t i) { return exact::of(m.points[i].point) + (0.5 * as_double(m.points[i].separation)) * exact::of(m.normal); }

// -- random pairs of polygons against exact geometry -------------------------------------------------------------------------------------

struct Pair {
    Polygon a, b;
    Transform pose;
    Core core_a, core_b;
    double radii = 0;
};

// Two polygons of about a metre, in every third pair boxes, mostly moved so that they are close to touching (by up to `reach` metres either way).
Pair random_pair(exact::Random& r, double reach) {
    Pair p;
    const float radius_a = r.below(2) ? r.in(0.01, 0.3) : 0.0f, radius_b = r.below(2) ? r.in(0.01, 0.3) : 0.0f;
    const bool boxes = r.below(3) == 0;
    const auto polygon = [&](float radius) {
        return boxes ? make_offset_box(r.in(0.1, 1), r.in(0.1, 1), r.pose(0.3), radius) : exact::random_polygon(r, 1, radius);
    };
    p.a = polygon(radius_a);
    p.b = polygon(radius_b);
    p.radii = as_double(radius_a) + as_double(radius_b);
    p.pose.q = make_rot(r.below(4) ? r.in(-3.2, 3.2) : static_cast<float>(r.below(8)) * 0.5f * half_pi + r.in(-0.001, 0.001));
    // Slide B along a random direction until the exact distance is what we want.
    const double angle = as_double(r.in(-3.2, 3.2));
    const Point direction = {std::cos(angle), std::sin(angle)};
    p.core_a = exact::core_of(p.a);
    const Core turned = exact::core_of(p.b, p.pose);
    const double wanted = p.radii + as_double(r.in(-reach, reach));
    double near = 0, far = 6;
    for (int i = 0; i < 32; ++i) {
        const double middle = 0.5 * (near + far);
        Core there = turned;
        for (Point& q : there) q = q + middle * direction;
        (exact::distance(p.core_a, there) < std::max(wanted, 0.0) + 1e-9 ? near : far) = middle;
    }
    const double place = far + std::min(wanted, 0.0);
    p.pose.p = {static_cast<float>(place * direction.x), static_cast<float>(place * direction.y)};
    p.core_b = exact::core_of(p.b, p.pose);
    return p;
}

TEST(PolygonManifold, SeparationIsTheExactDistanceWhenTheCoresAreApart) {
    // Face contact is preferred where it is at most 0.5 mm worse than the true closest points: that is the tolerance.
    exact::Random r;
    int in_contact = 0;
    for (int i = 0; i < cases(100000); ++i) {
        const Pair p = random_pair(r, 0.05);
        const double core = exact::distance(p.core_a, p.core_b);
        if (core <= tie) continue;
        const double gap = core - p.radii;
        const Manifold m = collide(p.a, p.b, p.pose, margin);
        const std::string what = "case " + std::to_string(i);
        expect_well_formed(m, margin, what);
        if (gap > as_double(margin) + rounding) {
            ASSERT_EQ(m.count, 0u) << what;
        } else if (gap < as_double(margin) - tie - rounding) {
            ASSERT_GE(m.count, 1u) << what << " gap " << gap;
        }
        if (m.count == 0) continue;
        ++in_contact;
        ASSERT_GE(deepest(m), gap - rounding) << what;
        ASSERT_LE(deepest(m), gap + 2 * tie + rounding) << what;
        const double beside = rounding + (detail::is_box(p.a) && detail::is_box(p.b) ? tie : 0);  // a corner may be at the end of a face
        for (std::uint32_t k = 0; k < m.count; ++k) {
            ASSERT_LE(exact::to_core(p.core_a, on_a(m, k)), as_double(p.a.radius) + beside) << what;
            ASSERT_LE(exact::to_core(p.core_b, on_b(m, k)), as_double(p.b.radius) + beside) << what;
        }
    }
    EXPECT_GT(in_contact, cases(20000));
}

TEST(PolygonManifold, ShallowOverlapIsMeasuredAlongTheAxisOfLeastPenetration) {
    exact::Random r;
    int measured = 0, other_depth = 0;
    for (int i = 0; i < cases(100000); ++i) {
        Pair p = random_pair(r, 0.05);
        p.radii = as_double(p.a.radius = 0) + as_double(p.b.radius = 0);
        const double bound = std::max(exact::best_face_gap(p.core_a, p.core_b), exact::best_face_gap(p.core_b, p.core_a));
        if (bound > -1e-5) continue;
        const Manifold m = collide(p.a, p.b, p.pose, margin);
        const std::string what = "case " + std::to_string(i);
        expect_well_formed(m, margin, what);
        ASSERT_GE(m.count, 1u) << what;
        // The normal is an axis of least overlap, within the bias that keeps A the reference.
        ASSERT_NEAR(exact::gap_along(p.core_a, p.core_b, exact::of(m.normal)), bound, tie + rounding) << what;
        ASSERT_GE(deepest(m), bound - tie - rounding) << what;
        ++measured;
        other_depth += deepest(m) > bound + tie + rounding ? 1 : 0;
        for (std::uint32_t k = 0; k < m.count; ++k) {
            ASSERT_LE(exact::to_outline(p.core_a, on_a(m, k)), rounding) << what;
            ASSERT_LE(exact::to_outline(p.core_b, on_b(m, k)), rounding) << what;
        }
    }
    EXPECT_GT(measured, cases(10000));
    // The deepest corner may lie beside the reference face when shapes are smaller than their overlap; then the clipped points say less.
    EXPECT_LT(other_depth, measured / 100);
}

TEST(PolygonManifold, DeepOverlapUsesTheAxisOfLeastPenetration) {
    exact::Random r;
    for (int i = 0; i < cases(50000); ++i) {
        Pair p = random_pair(r, 0.05);
        p.pose.p = {r.in(-0.5, 0.5), r.in(-0.5, 0.5)};
        p.core_b = exact::core_of(p.b, p.pose);
        const double bound = std::max(exact::best_face_gap(p.core_a, p.core_b), exact::best_face_gap(p.core_b, p.core_a));
        if (bound > -0.05) continue;
        const Manifold m = collide(p.a, p.b, p.pose, margin);
        const std::string what = "case " + std::to_string(i);
        expect_well_formed(m, margin, what);
        ASSERT_GE(m.count, 1u) << what;
        ASSERT_NEAR(exact::gap_along(p.core_a, p.core_b, exact::of(m.normal)), bound, tie + rounding) << what;
        ASSERT_GE(deepest(m), bound - p.radii - tie - rounding) << what;
    }
}

TEST(PolygonManifold, SwappingTheShapesMirrorsTheManifold) {
    exact::Random r;
    int compared = 0;
    for (int i = 0; i < cases(60000); ++i) {
        const Pair p = random_pair(r, 0.03);
        const Transform back = {inv_rotate(p.pose.q, -p.pose.p), inverse(p.pose.q)};
        const Manifold m = collide(p.a, p.b, p.pose, margin);
        const Manifold w = collide(p.b, p.a, back, margin);
        // Where A's and B's best axes are equally good, each order prefers its own A.
        const double ab = exact::best_face_gap(p.core_a, p.core_b), ba = exact::best_face_gap(p.core_b, p.core_a);
        if (std::fabs(ab - ba) < 3 * tie) continue;
        if (m.count != w.count || m.count == 0) {
            // Only a point right at the margin may be seen from one side and not from the other.
            const Manifold& more = m.count > w.count ? m : w;
            if (m.count != w.count) {
                double most = -1;
                for (std::uint32_t k = 0; k < more.count; ++k) most = std::max(most, as_double(more.points[k].separation));
                ASSERT_NEAR(most, as_double(margin), 5e-5) << "case " << i;
            }
            continue;
        }
        ++compared;
        const Vec2 n = rotate(p.pose.q, w.normal);
        ASSERT_NEAR(as_double(dot(n, m.normal)), -1.0, 1e-6) << "case " << i;
        // Every point of one has its mirror image in the other, under the swapped name.
        for (std::uint32_t k = 0; k < m.count; ++k) {
            bool found = false;
            for (std::uint32_t l = 0; l < w.count; ++l) {
                const Vec2 there = transform_point(p.pose, w.points[l].point);
                const std::uint16_t swapped = static_cast<std::uint16_t>(w.points[l].id >> 8 | w.points[l].id << 8);
                found = found || (exact::length(exact::of(there - m.points[k].point)) < 1e-4 && swapped == m.points[k].id &&
                                  std::fabs(as_double(w.points[l].separation - m.points[k].separation)) < 2e-5);
            }
            ASSERT_TRUE(found) << "case " << i << " point " << k;
        }
    }
    EXPECT_GT(compared, cases(20000));
}

TEST(PolygonManifold, TheFastPathForBoxesAgreesWithTheGeneralOne) {
    exact::Random r;
    int compared = 0;
    for (int i = 0; i < cases(100000); ++i) {
        const Polygon a = make_offset_box(r.in(0.1, 1), r.in(0.1, 1), r.pose(1), r.below(2) ? 0.0f : r.in(0.01, 0.1));
        const Polygon b = make_offset_box(r.in(0.1, 1), r.in(0.1, 1), r.pose(1), r.below(2) ? 0.0f : r.in(0.01, 0.1));
        ASSERT_TRUE(detail::is_box(a) && detail::is_box(b));
        const Transform pose = r.pose(2);
        const Manifold fast = collide(a, b, pose, margin);
        const Manifold slow = detail::collide_cores(detail::outline_of(a, {}), detail::outline_of(b, pose, {}), {}, margin);
        const Core ca = exact::core_of(a), cb = exact::core_of(b, pose);
        if (fast.count != slow.count || (fast.count > 0 && dot(fast.normal, slow.normal) < 0.9999f)) {
            // Rounding may decide between two axes, or at the margin; then both answers must be right.
            const double bound = std::max(exact::best_face_gap(ca, cb), exact::best_face_gap(cb, ca));
            const Manifold& more = fast.count > 0 ? fast : slow;
            ASSERT_GT(more.count, 0u);
            if (fast.count > 0 && slow.count > 0 && bound < 0) {
                ASSERT_NEAR(exact::gap_along(ca, cb, exact::of(fast.normal)), bound, tie + rounding) << "case " << i;
                ASSERT_NEAR(exact::gap_along(ca, cb, exact::of(slow.normal)), bound, tie + rounding) << "case " << i;
            }
            continue;
        }
        for (std::uint32_t k = 0; k < fast.count; ++k) {
            ASSERT_NEAR(as_double(fast.points[k].separation), as_double(slow.points[k].separation), 1e-5) << "case " << i;
            ASSERT_LT(exact::length(exact::of(fast.points[k].point - slow.points[k].point)), fast.count == 1 ? tie : 1e-4) << "case " << i;
            ASSERT_EQ(fast.points[k].id, slow.points[k].id) << "case " << i;
        }
        compared += fast.count > 0 ? 1 : 0;
    }
    EXPECT_GT(compared, cases(20000));
}

// Where corners are near corners, two of them may be as near as rounding can tell, and only one tells the direction. Whichever is taken, the boxes are apart
// along the normal by what they are apart. (One that did not compare with the faces cut boxes of 5 m by up to 1.2 m, in 1 of 130 pairs 0.01 mm apart.)
TEST(PolygonManifold, BoxesCornerToCornerAreApartAlongTheNormal) {
    exact::Random r;
    int measured = 0;
    for (int i = 0; i < cases(200000); ++i) {
        const float size = r.below(2) ? 5 : 0.5f;
        const Polygon a = make_box(r.in(0.1, 1) * size, r.in(0.1, 1) * size), b = make_box(r.in(0.1, 1) * size, r.in(0.1, 1) * size);
        const Rot q = make_rot(r.below(4) ? static_cast<float>(r.below(8)) * 0.5f * half_pi + r.in(-0.1, 0.1) : r.in(-3.2, 3.2));
        const double gap = std::pow(10.0, as_double(r.in(-5, -1.8)));
        // B's corner beside A's, in a direction out of A.
        const Vec2 corner = a.vertices[2], out = rotate(make_rot(r.below(3) ? r.in(-0.1, 1.7) : r.below(2) ? 0.0f : half_pi), {1, 0});
        const Transform pose = {corner + static_cast<float>(gap) * out - rotate(q, b.vertices[r.below(4)]), q};
        const Core ca = exact::core_of(a), cb = exact::core_of(b, pose);
        const double apart = exact::distance(ca, cb);
        if (apart <= 0 || apart > 0.9 * as_double(margin)) continue;
        const Manifold m = collide(a, b, pose, margin);
        ASSERT_GE(m.count, 1u) << "case " << i;
        ASSERT_GE(exact::gap_along(ca, cb, exact::of(m.normal)), apart - 2 * tie) << "case " << i;
        ASSERT_NEAR(deepest(m), apart, 2 * tie) << "case " << i;
        for (std::uint32_t k = 0; k < m.count; ++k)
            ASSERT_LE(std::max(exact::to_core(ca, on_a(m, k)), exact::to_core(cb, on_b(m, k))), 2 * tie) << "case " << i;
        ++measured;
    }
    EXPECT_GT(measured, cases(50000));
}

// A corner at a corner: the faces that look at each other may miss each other, though the boxes overlap. Of 20 000 000 such pairs, 0.3 % are of that kind.
TEST(PolygonManifold, BoxesThatOverlapAtTheirCornersTouchThere) {
    exact::Random r;
    int overlapping = 0;
    for (int i = 0; i < cases(100000); ++i) {
        const Polygon a = make_box(r.in(0.1, 1), r.in(0.1, 1)), b = make_box(r.in(0.1, 1), r.in(0.1, 1));
        const Rot q = make_rot(r.below(4) ? static_cast<float>(r.below(8)) * 0.5f * half_pi + r.in(-0.002, 0.002) : r.in(-3.2, 3.2));
        const Vec2 off = {r.in(-0.002, 0.002), r.in(-0.002, 0.002)};
        const Transform pose = {a.vertices[r.below(4)] - rotate(q, b.vertices[r.below(4)]) + off, q};
        const Core ca = exact::core_of(a), cb = exact::core_of(b, pose);
        const double bound = std::max(exact::best_face_gap(ca, cb), exact::best_face_gap(cb, ca));
        if (bound > -1e-5) continue;
        const Manifold m = collide(a, b, pose, margin);
        ASSERT_GE(m.count, 1u) << "case " << i;
        ASSERT_NEAR(exact::gap_along(ca, cb, exact::of(m.normal)), bound, tie + rounding) << "case " << i;
        ASSERT_NEAR(deepest(m), bound, tie + rounding) << "case " << i;
        for (std::uint32_t k = 0; k < m.count; ++k)
            ASSERT_LE(std::max(exact::to_outline(ca, on_a(m, k)), exact::to_outline(cb, on_b(m, k))), rounding) << "case " << i;
        ++overlapping;
    }
    EXPECT_GT(overlapping, cases(10000));
}

// Its normals are those of a box, but where it is, corners are rounded to 6 cm. Taken for a box by its normals, it had a negative half extent.
TEST(PolygonManifold, AThinBoxWithRoundedCornersIsNoBox) {
    const Polygon thin = make_offset_box(27.7505913f, 0.0147407744f, {{1e6f, 1e6f}, {0.125771537f, 0.992059231f}});
    EXPECT_TRUE(is_valid(thin));
    EXPECT_FALSE(detail::is_box(thin));
    EXPECT_TRUE(detail::is_box(make_offset_box(27.7505913f, 0.0147407744f, {{1e3f, 1e3f}, {0.125771537f, 0.992059231f}})));
    Polygon slanted = make_box(50, 0.05f);
    slanted.vertices[2].y += 0.099f;
    EXPECT_TRUE(is_valid(slanted));
    EXPECT_FALSE(detail::is_box(slanted));
}

TEST(PolygonManifold, FarFromTheBodysOriginItStaysAccurate) {
    // Both shapes a kilometre from their bodies' origins, in frames that agree: only the digits of the corners themselves are lost.
    const Polygon ground = make_offset_box(5, 0.5f, {{1000, 0}, {}});
    const Polygon box = make_offset_box(0.5f, 0.5f, {{1000, 1}, {}});
    const Manifold m = collide(ground, box, {}, margin);
    ASSERT_EQ(m.count, 2u);
    EXPECT_EQ(m.normal, (Vec2{0, 1}));
    for (const ManifoldPoint& p : m.points) EXPECT_NEAR(as_double(p.separation), 0.0, 1e-6);
}

// -- situations with a known answer ------------------------------------------------------------------------------------------------------

std::set<std::uint16_t> ids(const Manifold& m) {
    std::set<std::uint16_t> out;
    for (std::uint32_t i = 0; i < m.count; ++i) out.insert(m.points[i].id);
    return out;
}

TEST(BoxOnBox, TwoPointsAtTheCornersOfTheUpperBox) {
    const Manifold m = collide(make_box(2, 0.5f), make_box(0.5f, 0.5f), {{0.25f, 0.998f}, {}}, margin);
    ASSERT_EQ(m.count, 2u);
    EXPECT_EQ(m.normal, (Vec2{0, 1}));
    const float left = islet::min(m.points[0].point.x, m.points[1].point.x), right = islet::max(m.points[0].point.x, m.points[1].point.x);
    EXPECT_NEAR(left, -0.25f, 1e-6f);
    EXPECT_NEAR(right, 0.75f, 1e-6f);
    for (const ManifoldPoint& p : m.points) {
        EXPECT_NEAR(p.separation, -0.002f, 1e-6f);
        EXPECT_NEAR(p.point.y, 0.499f, 1e-6f);
    }
}

TEST(BoxOnBox, AnOverhangingBoxIsHeldAtTheEdgeOfTheLowerOne) {
    const Manifold m = collide(make_box(1, 0.5f), make_box(0.5f, 0.5f), {{1.2f, 1}, {}}, margin);
    ASSERT_EQ(m.count, 2u);
    EXPECT_NEAR(islet::min(m.points[0].point.x, m.points[1].point.x), 0.7f, 1e-6f);
    EXPECT_NEAR(islet::max(m.points[0].point.x, m.points[1].point.x), 1.0f, 1e-6f);
}

TEST(BoxOnBox, ATiltedBoxStandsOnOneCorner) {
    const float h = 0.5f * 1.41421356f;
    const Manifold m = collide(make_box(2, 0.5f), make_box(0.5f, 0.5f), {{0, 0.5f + h}, make_rot(0.25f * pi)}, margin);
    ASSERT_EQ(m.count, 1u);
    EXPECT_NEAR(m.normal.y, 1.0f, 1e-6f);
    EXPECT_NEAR(m.points[0].separation, 0.0f, 1e-6f);
    EXPECT_NEAR(m.points[0].point.x, 0.0f, 1e-6f);
}

TEST(BoxOnBox, NamesPersistWhileTheBoxRocksAndSlides) {
    const Polygon ground = make_box(5, 0.5f), box = make_box(0.5f, 0.5f);
    const std::set<std::uint16_t> at_rest = ids(collide(ground, box, {{0, 1}, {}}, 0.1f));
    ASSERT_EQ(at_rest.size(), 2u);
    for (int i = -100; i <= 100; ++i) {
        const float t = 0.01f * static_cast<float>(i);
        const Manifold m = collide(ground, box, {{0.3f * t, 1 - 0.002f * t}, make_rot(0.05f * t)}, 0.1f);
        EXPECT_EQ(ids(m), at_rest) << "tilt " << 0.05f * t;
    }
}

TEST(BoxOnBox, NamesPersistWhenTheReferenceFaceFlips) {
    // A wide box tilted on a narrow one: past a small tilt the wide box's face holds the narrow one's corner, not the other way round.
    const Polygon narrow = make_box(0.2f, 0.5f), wide = make_box(3, 0.5f);
    std::set<std::uint16_t> at_rest;
    bool narrow_was_reference = false, wide_was_reference = false;
    for (int i = 0; i <= 50; ++i) {
        const float tilt = 0.0005f * static_cast<float>(i);
        const Manifold m = collide(narrow, wide, {{0, 1}, make_rot(tilt)}, 0.1f);
        ASSERT_EQ(m.count, 2u);
        if (i == 0) at_rest = ids(m);
        EXPECT_EQ(ids(m), at_rest) << "tilt " << tilt;
        (m.normal.x == 0.0f ? narrow_was_reference : wide_was_reference) = true;
    }
    EXPECT_TRUE(narrow_was_reference && wide_was_reference);
}

TEST(BoxOnBox, EqualFacesKeepOneReferenceWhileTheyJitter) {
    const Polygon box = make_box(0.5f, 0.5f);
    for (int i = -20; i <= 20; ++i) {
        const Manifold m = collide(box, box, {{0.1f, 0.999f}, make_rot(2e-5f * static_cast<float>(i))}, margin);
        ASSERT_EQ(m.count, 2u);
        EXPECT_EQ(m.normal, (Vec2{0, 1}));
    }
}

TEST(RoundedShapes, CornerAgainstCornerTouchesWhereTheRoundingsMeet) {
    const Polygon box = make_rounded_box(0.4f, 0.4f, 0.1f);
    const float step = 0.8f + 0.2f * 0.70710678f;
    const Manifold m = collide(box, box, {{step, step}, {}}, margin);
    ASSERT_EQ(m.count, 1u);
    EXPECT_NEAR(m.points[0].separation, 0.0f, 1e-6f);
    EXPECT_NEAR(m.normal.x, 0.70710678f, 1e-6f);
    EXPECT_NEAR(m.normal.y, 0.70710678f, 1e-6f);
    EXPECT_NEAR(m.points[0].point.x, 0.5f * step, 1e-6f);
}

TEST(RoundedShapes, ARoundedBoxRestsOnItsGrownFaces) {
    const Manifold m = collide(make_box(2, 0.5f), make_rounded_box(0.4f, 0.4f, 0.1f), {{0, 1}, {}}, margin);
    ASSERT_EQ(m.count, 2u);
    for (const ManifoldPoint& p : m.points) {
        EXPECT_NEAR(p.separation, 0.0f, 1e-6f);
        EXPECT_NEAR(p.point.y, 0.5f, 1e-6f);
        EXPECT_NEAR(islet::abs(p.point.x), 0.4f, 1e-6f);
    }
}

TEST(Capsules, LyingSideBySideTouchInTwoPoints) {
    const Capsule c = {{-1, 0}, {1, 0}, 0.25f};
    const Manifold m = collide(c, c, {{0.5f, 0.5f}, {}}, margin);
    ASSERT_EQ(m.count, 2u);
    EXPECT_EQ(m.normal, (Vec2{0, 1}));
    EXPECT_NEAR(islet::min(m.points[0].point.x, m.points[1].point.x), -0.5f, 1e-6f);
    EXPECT_NEAR(islet::max(m.points[0].point.x, m.points[1].point.x), 1.0f, 1e-6f);
    for (const ManifoldPoint& p : m.points) EXPECT_NEAR(p.separation, 0.0f, 1e-6f);
}

TEST(Capsules, EndToEndTouchInOnePoint) {
    const Capsule c = {{-1, 0}, {1, 0}, 0.25f};
    for (float tilt : {0.0f, 1e-5f, -1e-3f}) {
        const Manifold m = collide(c, c, {{2.5f, 0}, make_rot(tilt)}, margin);
        ASSERT_EQ(m.count, 1u) << tilt;
        EXPECT_NEAR(m.normal.x, 1.0f, 1e-4f);
        EXPECT_NEAR(m.points[0].separation, 0.0f, 1e-5f);
        EXPECT_NEAR(m.points[0].point.x, 1.25f, 1e-5f);
    }
}

TEST(Capsules, SeparationIsTheExactDistanceOfTheAxes) {
    exact::Random r;
    int in_contact = 0;
    for (int i = 0; i < cases(100000); ++i) {
        const Capsule a = {{r.in(-1, 1), r.in(-1, 1)}, {r.in(-1, 1), r.in(-1, 1)}, r.in(0.05, 0.5)};
        const Capsule b = {{r.in(-1, 1), r.in(-1, 1)}, {r.in(-1, 1), r.in(-1, 1)}, r.in(0.05, 0.5)};
        if (!is_valid(a) || !is_valid(b)) continue;
        const Transform pose = r.pose(2);
        const Core ca = {exact::of(a.point1), exact::of(a.point2)}, cb = {exact::moved(pose, exact::of(b.point1)), exact::moved(pose, exact::of(b.point2))};
        const double core = exact::distance(ca, cb), gap = core - as_double(a.radius) - as_double(b.radius);
        const Manifold m = collide(a, b, pose, margin);
        const std::string what = "case " + std::to_string(i);
        expect_well_formed(m, margin, what);
        if (gap > as_double(margin) + rounding) {
            ASSERT_EQ(m.count, 0u) << what;
        } else if (gap < as_double(margin) - tie - rounding) {
            ASSERT_GE(m.count, 1u) << what;
        }
        if (m.count == 0) continue;
        ++in_contact;
        if (core > tie) {
            ASSERT_GE(deepest(m), gap - rounding) << what;
            ASSERT_LE(deepest(m), gap + 2 * tie + rounding) << what;
            for (std::uint32_t k = 0; k < m.count; ++k) {
                ASSERT_LE(exact::to_core(ca, on_a(m, k)), as_double(a.radius) + rounding) << what;
                ASSERT_LE(exact::to_core(cb, on_b(m, k)), as_double(b.radius) + rounding) << what;
            }
        } else {
            ASSERT_LE(deepest(m), gap + 2 * tie + rounding) << what;
        }
    }
    EXPECT_GT(in_contact, cases(20000));
}

TEST(CircleManifold, SeparationIsTheExactDistanceFromEveryShape) {
    exact::Random r;
    int in_contact = 0;
    for (int i = 0; i < cases(100000); ++i) {
        const Polygon polygon = exact::random_polygon(r, 1, r.below(2) ? 0.0f : r.in(0.01, 0.2));
        const Capsule capsule = {{r.in(-1, 0), r.in(-1, 1)}, {r.in(0.1, 1), r.in(-1, 1)}, r.in(0.05, 0.5)};
        const Circle circle = {{r.in(-1, 1), r.in(-1, 1)}, r.in(0.05, 0.5)};
        const Transform pose = r.pose(1.5);
        const Point center = exact::moved(pose, exact::of(circle.center));
        const struct {
            Manifold m;
            Core core;
            float radius;
        } cases[] = {
            {collide(polygon, circle, pose, margin), exact::core_of(polygon), polygon.radius},
            {collide(capsule, circle, pose, margin), {exact::of(capsule.point1), exact::of(capsule.point2)}, capsule.radius},
            {collide(Capsule{capsule.point1, capsule.point2, 0}, circle, pose, margin), {exact::of(capsule.point1), exact::of(capsule.point2)}, 0},
            {collide(Circle{capsule.point1, capsule.radius}, circle, pose, margin), {exact::of(capsule.point1)}, capsule.radius},
        };
        for (const auto& c : cases) {
            const std::string what = "case " + std::to_string(i);
            expect_well_formed(c.m, margin, what);
            const double core = exact::holds(c.core, center) ? -exact::to_outline(c.core, center) : exact::to_outline(c.core, center);
            const double gap = core - as_double(c.radius) - as_double(circle.radius);
            if (std::fabs(gap - as_double(margin)) > rounding) { ASSERT_EQ(c.m.count, gap < as_double(margin) ? 1u : 0u) << what; }
            if (c.m.count == 0) continue;
            ++in_contact;
            ASSERT_NEAR(as_double(c.m.points[0].separation), gap, rounding) << what;
            // From A's surface along the normal by the separation lies B's surface.
            ASSERT_NEAR(exact::length(on_b(c.m, 0) - center), as_double(circle.radius), rounding) << what;
            if (core > 0.01) { ASSERT_NEAR(exact::to_core(c.core, on_a(c.m, 0)), as_double(c.radius), rounding) << what; }
        }
    }
    EXPECT_GT(in_contact, cases(50000));
}

// -- every pair at the same four poses ---------------------------------------------------------------------------------------------------

// Each pair is given as a function of how far B is above A's centre, and the height at which they touch.
struct NamedPair {
    const char* name;
    float touching_height;
    std::function<Manifold(const Transform&, float)> collide;
};

template <class A, class B>
NamedPair named(const char* name, float height, A a, B b) {
    return {name, height, [a, b](const Transform& t, float limit) { return islet::detail::collide(a, b, t, limit); }};
}

std::vector<NamedPair> all_pairs() {
    const Circle circle = {{}, 0.5f};
    const Capsule capsule = {{-0.5f, 0}, {0.5f, 0}, 0.25f};
    const Capsule segment = {{1, 0}, {-1, 0}, 0};
    const Polygon box = make_box(1, 0.5f);
    const Polygon round_box = make_rounded_box(0.9f, 0.4f, 0.1f);
    const Vec2 corners[] = {{-1, -0.5f}, {1, -0.5f}, {0.5f, 0.5f}, {-0.5f, 0.5f}, {0, 0.75f}};
    const Polygon house = make_polygon(compute_hull(corners));
    const ChainSegment link = {{3, 0}, {segment.point1, segment.point2}, {-3, 0}};
    return {
        named("circle-circle", 1.0f, circle, circle),         named("capsule-circle", 0.75f, capsule, circle),
        named("capsule-capsule", 0.5f, capsule, capsule),     named("segment-circle", 0.5f, segment, circle),
        named("segment-capsule", 0.25f, segment, capsule),    named("segment-polygon", 0.5f, segment, box),
        named("segment-house", 0.5f, segment, house),         named("polygon-circle", 1.0f, box, circle),
        named("polygon-capsule", 0.75f, box, capsule),        named("box-box", 1.0f, box, box),
        named("rounded-rounded", 1.0f, round_box, round_box), named("box-house", 1.0f, box, house),
        named("rounded-capsule", 0.75f, round_box, capsule),  named("chain-circle", 0.5f, link, circle),
        named("chain-capsule", 0.25f, link, capsule),         named("chain-polygon", 0.5f, link, box),
        named("chain-rounded", 0.5f, link, round_box),        named("chain-house", 0.5f, link, house),
    };
}

TEST(EveryPair, TouchesWithSeparationZeroAndTheNormalUp) {
    for (const NamedPair& pair : all_pairs()) {
        for (float above : {-0.004f, 0.0f, 0.015f}) {
            const Manifold m = pair.collide({{0, pair.touching_height + above}, {}}, margin);
            expect_well_formed(m, margin, pair.name);
            ASSERT_GE(m.count, 1u) << pair.name;
            EXPECT_NEAR(m.normal.y, 1.0f, 1e-6f) << pair.name;
            for (std::uint32_t i = 0; i < m.count; ++i) EXPECT_NEAR(m.points[i].separation, above, 1e-6f) << pair.name;
        }
    }
}

TEST(EveryPair, HasNoPointsBeyondTheMargin) {
    for (const NamedPair& pair : all_pairs()) {
        EXPECT_EQ(pair.collide({{0, pair.touching_height + margin + 1e-4f}, {}}, margin).count, 0u) << pair.name;
        EXPECT_GE(pair.collide({{0, pair.touching_height + margin + 1e-4f}, {}}, 0.5f).count, 1u) << pair.name;
        EXPECT_EQ(pair.collide({{10, 0}, {}}, margin).count, 0u) << pair.name;
        EXPECT_EQ(pair.collide({{1e6f, -1e6f}, {}}, margin).count, 0u) << pair.name;
    }
}

TEST(EveryPair, PushesADeepOverlapApart) {
    for (const NamedPair& pair : all_pairs()) {
        const Manifold m = pair.collide({{0, 0.6f * pair.touching_height}, {}}, margin);
        expect_well_formed(m, margin, pair.name);
        ASSERT_GE(m.count, 1u) << pair.name;
        EXPECT_NEAR(m.normal.y, 1.0f, 1e-6f) << pair.name;
        EXPECT_NEAR(deepest(m), -0.4 * as_double(pair.touching_height), 1e-6) << pair.name;
    }
}

TEST(EveryPair, IsFiniteAndUnitHoweverTheShapesCoincide) {
    exact::Random r;
    for (const NamedPair& pair : all_pairs()) {
        for (int i = 0; i < cases(20000); ++i) {
            // Coincident, nearly coincident (down to denormal), quarter turns, and anything.
            Transform t = r.pose(std::pow(10.0, as_double(r.in(-45, 1))));
            if (i % 3 == 0) t.p = {};
            if (i % 2 == 0) t.q = make_rot(static_cast<float>(i % 8) * 0.5f * half_pi);
            if (i % 5 == 0) t.q = {};
            const Manifold m = pair.collide(t, margin);
            expect_well_formed(m, margin, pair.name);
            const bool one_sided = std::string(pair.name).starts_with("chain");
            if (i % 3 == 0 && !one_sided) { ASSERT_GE(m.count, 1u) << pair.name; }
        }
    }
}

TEST(EveryPair, GivesTheSameBitsEveryTime) {
    exact::Random r;
    for (const NamedPair& pair : all_pairs()) {
        for (int i = 0; i < 200; ++i) {
            const Transform t = r.pose(1);
            const Manifold m = pair.collide(t, margin), again = pair.collide(t, margin);
            ASSERT_EQ(m.count, again.count);
            for (std::uint32_t k = 0; k < m.count; ++k) {
                ASSERT_EQ(m.points[k].point, again.points[k].point);
                ASSERT_EQ(m.points[k].separation, again.points[k].separation);
                ASSERT_EQ(m.points[k].id, again.points[k].id);
            }
        }
    }
}

}  // namespace
