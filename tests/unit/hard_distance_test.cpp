// The step's own distance, contacts and time of impact for shapes that are nearly equal, touching, parallel, collinear, or much longer than wide
// (support/hard_shapes.hpp), judged in long double (support/long_geometry.hpp).
#include <gtest/gtest.h>

#include <string>
#include <variant>

#include "collide/distance.hpp"
#include "collide/outline.hpp"
#include "collide/time_of_impact.hpp"
#include "shapes/manifolds.hpp"
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

// Without the radii; and what errors are measured by in one frame: the largest coordinate, or difference of two.
Rounded cores_of(const Solid& a, const Solid& b) { return long_exact::difference({a.corners, 0}, {b.corners, 0}); }
Real frame_of(const Solid& a, const Solid& b) { return std::max({long_exact::scale_of(a, b), long_exact::reach_of(a), long_exact::reach_of(b)}); }

TEST(HardDistance, IsThatOfLongDoubleIn400000Cases) {
    // As distance_test.cpp has it: seven roundings; and twice that for square lengths that are compared. Below touching_squared cores touch.
    constexpr Real relative_error = 2e-6L, touching = 1.1e-8L;
    exact::Random r;
    int apart = 0;
    for (int i = 0; i < cases(400000); ++i) {
        const HardPair c = test::hard_pair(r, false, 1, 10);
        const ShapeProxy pa = transform_proxy(c.pose_a, c.a), pb = transform_proxy(c.pose_b, c.b);
        const Solid a = long_exact::solid_of(pa), b = long_exact::solid_of(pb);
        const Real want = std::max(Real{0}, long_exact::signed_distance(cores_of(a, b), {}));
        const detail::DistanceResult got = detail::core_distance(pa.points, pa.count, pb.points, pb.count);
        ASSERT_LE(std::fabs(Real(got.distance) - want), touching + relative_error * frame_of(a, b))
            << i << ": " << text_of(pa) << " and " << text_of(pb) << ": " << got.distance << ", not " << double(want);
        apart += want > 0 ? 1 : 0;
    }
    EXPECT_GT(apart, cases(200000));
}

TEST(HardDistance, OfLongShapesThatAreNearlyParallelIsNotThatOfTheirEnds) {
    const Vec2 capsule[] = {{0, 0}, {-59.5468826f, -13.3515434f}}, segment[] = {{-0.00540910987f, 0.0241242349f}, {-126.967285f, -28.4684792f}};
    EXPECT_NEAR(detail::core_distance(capsule, 2, segment, 2).distance, 0.0131284f, 1e-5f);
    EXPECT_NEAR(detail::core_distance(segment, 2, capsule, 2).distance, 0.0131284f, 1e-5f);
}

using AnyShape = std::variant<Circle, Capsule, Polygon>;

bool shape_of(const ShapeProxy& p, AnyShape& out) {
    if (p.count == 1) out = Circle{p.points[0], p.radius};
    if (p.count == 2) out = Capsule{p.points[0], p.points[1], p.radius};  // of radius 0: a segment
    if (p.count == 2) return is_valid(Segment{p.points[0], p.points[1]});
    if (p.count == 1) return is_valid(std::get<Circle>(out));
    Hull hull;
    hull.count = p.count;
    for (std::uint32_t i = 0; i < p.count; ++i) hull.points[i] = p.points[i];
    const Polygon polygon = make_polygon(hull, p.radius);
    out = polygon;
    return polygon.count > 0;
}

// False for the pairs that the engine asks the other way round.
bool manifold_of(const AnyShape& a, const AnyShape& b, const Transform& b_in_a, detail::Manifold& m) {
    return std::visit(
        [&](const auto& p, const auto& q) {
            if constexpr (requires { detail::collide(p, q, b_in_a, detail::speculative_distance); }) {
                m = detail::collide(p, q, b_in_a, detail::speculative_distance);
                return true;
            }
            return false;
        },
        a, b);
}

TEST(HardDistance, ContactsAreWhereLongDoubleHasThemIn400000Cases) {
    constexpr Real tie = Real(detail::separation_tie), margin = Real(detail::speculative_distance);
    exact::Random r;
    int contacts = 0, asked = 0;
    for (int i = 0; i < cases(400000); ++i) {
        const HardPair c = test::hard_pair(r, false, 1, 3);
        AnyShape shape_a, shape_b;
        if (!shape_of(c.a, shape_a) || !shape_of(c.b, shape_b)) continue;
        const Transform t = inv_mul(c.pose_a, c.pose_b);
        detail::Manifold m;
        if (!manifold_of(shape_a, shape_b, t, m)) continue;
        ++asked;
        const Solid a = long_exact::solid_of(c.a), b = long_exact::solid_of(c.b, t);
        const Rounded w = cores_of(a, b);
        const Real radii = a.radius + b.radius, core = long_exact::signed_distance(w, {}), gap = core - radii;
        const Real rounding = 1e-7L + 3e-6L * frame_of(a, b);
        const std::string what = std::to_string(i) + ": " + text_of(c.a) + " and " + text_of(c.b) + ", gap " + std::to_string(double(gap));
        if (m.count == 0) {
            ASSERT_GE(gap, margin - tie - rounding) << what;
            continue;
        }
        ++contacts;
        ASSERT_NEAR(exact::length(exact::of(m.normal)), 1, 1e-5) << what;
        ASSERT_LE(gap, margin + 2 * tie + rounding) << what;
        Real got = Real(m.points[0].separation);
        if (m.count == 2) got = std::min(got, Real(m.points[1].separation));
        ASSERT_GE(got, gap - 2 * tie - rounding) << what;
        if (core > tie) {
            ASSERT_GE(got, gap - rounding) << what;
            ASSERT_LE(got, gap + 2 * tie + rounding) << what;
        } else {
            // No normal may part overlapping shapes by a longer way than there is; a core that hardly has a distance hardly has a direction either.
            Real along = 1e30L, lever = 0;
            for (const Point p : w.core) {
                along = std::min(along, long_exact::dot(long_exact::of(m.normal), p));
                lever = std::max(lever, long_exact::length(p));
            }
            const Real turned = core > 0 ? rounding / core * lever : 0;
            ASSERT_GE(along, core - 2 * tie - rounding - turned) << what;
        }
    }
    EXPECT_GT(contacts, asked / 2);
}

detail::MovingCore moving_core(const ShapeProxy& p, const Transform& t) {
    detail::MovingCore s;
    s.core.count = p.count;
    s.core.radius = p.radius;
    for (std::uint32_t i = 0; i < p.count; ++i) {
        s.core.points[i] = p.points[i];
        s.reach = std::max(s.reach, length(p.points[i]));
    }
    s.path.center = t.p;
    s.path.q = t.q;
    return s;
}

TEST(HardDistance, NoTimeOfImpactIsLateIn40000Cases) {
    constexpr float gap = 0.00125f;
    exact::Random r;
    int hits = 0, tried = 0;
    for (int i = 0; i < cases(40000); ++i) {
        const HardPair c = test::hard_pair(r, false, 1, 3);
        Vec2 d = r.below(3) == 0 ? Vec2{r.in(-1, 1), r.in(-1, 1)} : float(test::random_sign(r)) * (r.below(3) != 0 ? c.out : c.along);
        d += Vec2{float(test::nudge(r, 0.3)), float(test::nudge(r, 0.3))};
        d = float(c.size * std::pow(10.0, double(r.in(-1, 1)))) * d;
        const float turn = r.below(2) == 0 ? 0 : float(test::nudge(r, 1.5)), met = r.in(0, 1);
        const detail::MovingCore a = moving_core(c.a, c.pose_a);
        detail::MovingCore b = moving_core(c.b, c.pose_b);
        b.path.way = d;
        b.path.turn = turn;
        b.path.center -= met * d;
        b.path.q = integrate(b.path.q, -met * turn);
        const Real near = Real(c.a.radius) + Real(c.b.radius);
        Real frame = 0;
        const auto left_at = [&](float fraction) {
            const Solid still = long_exact::solid_of(c.a, c.pose_a);
            const Solid there = long_exact::solid_of(c.b, {detail::center_at(b.path, fraction), detail::rotation_at(b.path, fraction)});
            frame = std::max(frame, long_exact::scale_of(still, there));
            return long_exact::signed_distance(cores_of(still, there), {}) - near;
        };
        if (left_at(0) <= 2 * Real(gap)) continue;
        ++tried;
        const float got = detail::time_of_impact(a, b, gap, 1), end = std::min(got, 1.0f);
        hits += got <= 1 ? 1 : 0;
        // The least of many places, then of closer ones around it.
        float at = 0, step = end / 48;
        Real least = left_at(0);
        const auto look = [&](float fraction) {
            if (fraction < 0 || fraction > end) return;
            const Real left = left_at(fraction);
            if (left < least) at = fraction;
            least = std::min(least, left);
        };
        for (int k = 1; k <= 48; ++k) look(end * float(k) / 48);
        for (int k = 0; k < 16; ++k) {
            step *= 0.6f;
            const float middle = at;
            look(middle - step);
            look(middle + step);
        }
        ASSERT_GE(least, (got > 1 ? 0.5L * Real(gap) : 0) - 2e-6L * frame)
            << i << ": " << text_of(c.a) << " and " << text_of(c.b) << " end at " << got << ", near at " << at;
    }
    EXPECT_GT(hits, tried / 4);
}

}  // namespace
