// Chains: what slides over their links feels one smooth surface, and nothing is felt from behind.
#include <gtest/gtest.h>

#include <string>
#include <variant>

#include "shapes/manifolds.hpp"
#include "exact_geometry.hpp"
#include "support/effort.hpp"

namespace {

using namespace islet;
using exact::Core;
using exact::Point;
using islet::detail::Manifold;
using islet::detail::speculative_distance;
using test::cases;
using test::stride;

constexpr double link_tie = 0.1 * 0.005;          // m: face contact is preferred to corners where it is no more than this worse
constexpr double corner_tolerance = 0.015;  // rad: how far beyond the neighbours' normals a contact may lean

// A line of corners from right to left, so that outward is up; the first and last only serve as ghosts.
struct Chain {
    std::vector<Vec2> corners;
    std::size_t links() const { return corners.size() - 3; }
    ChainSegment link(std::size_t i) const { return {corners[i], {corners[i + 1], corners[i + 2]}, corners[i + 3]}; }
};

Chain flat_chain() {
    Chain c;
    for (int i = 0; i <= 16; ++i) c.corners.push_back({8.0f - static_cast<float>(i), 0});
    return c;
}

// Slopes, hills, a valley, a step and corners that are nearly straight.
Chain hilly_chain() {
    return {{{9, 0},
             {8, 0},
             {6, 0},
             {5, 0.02f},
             {4, 0},
             {3, 1},
             {2, 1.5f},
             {1, 1},
             {0, 0},
             {-1, 0},
             {-2, 1},
             {-3, 1},
             {-3.5f, 0},
             {-4.5f, 0},
             {-6, -0.05f},
             {-8, 0},
             {-9, 0}}};
}

using Shape = std::variant<Circle, Capsule, Polygon>;

struct Body {
    const char* name;
    Shape shape;
};

std::vector<Body> bodies() {
    const Vec2 corners[] = {{-0.3f, -0.3f}, {0.3f, -0.3f}, {0.3f, 0.2f}, {0, 0.4f}, {-0.3f, 0.2f}};
    return {{"circle", Circle{{}, 0.3f}},
            {"capsule", Capsule{{-0.3f, 0}, {0.3f, 0}, 0.2f}},
            {"box", make_box(0.4f, 0.3f)},
            {"rounded box", make_rounded_box(0.3f, 0.2f, 0.1f)},
            {"house", make_polygon(compute_hull(corners))},
            {"long box", make_box(1.6f, 0.2f)}};
}

Manifold collide(const ChainSegment& link, const Shape& shape, const Transform& t) {
    return std::visit([&](const auto& s) { return islet::detail::collide(link, s, t, speculative_distance); }, shape);
}

Core core_of(const Shape& shape, const Transform& t) {
    if (const auto* c = std::get_if<Circle>(&shape)) return {exact::moved(t, exact::of(c->center))};
    if (const auto* c = std::get_if<Capsule>(&shape)) return {exact::moved(t, exact::of(c->point1)), exact::moved(t, exact::of(c->point2))};
    return exact::core_of(std::get<Polygon>(shape), t);
}

double radius_of(const Shape& shape) {
    return static_cast<double>(std::visit([](const auto& s) { return s.radius; }, shape));
}

double distance_to(const Chain& chain, const Shape& shape, const Transform& t) {
    double best = 1e9;
    const Core core = core_of(shape, t);
    for (std::size_t i = 0; i < chain.links(); ++i) {
        const ChainSegment s = chain.link(i);
        best = std::min(best, exact::distance({exact::of(s.segment.point1), exact::of(s.segment.point2)}, core));
    }
    return best - radius_of(shape);
}

// The pose at x, turned by angle, where the shape lowered from above first touches the chain: down in steps thinner than any body here,
// then by halving.
Transform resting_pose(const Chain& chain, const Shape& shape, float x, float angle) {
    const auto clear = [&](float y) { return distance_to(chain, shape, {{x, y}, make_rot(angle)}) > 0; };
    float high = 4;
    while (clear(high - 0.2f)) high -= 0.2f;
    float low = high - 0.2f;
    for (int i = 0; i < 20; ++i) {
        const float middle = 0.5f * (low + high);
        (clear(middle) ? high : low) = middle;
    }
    return {{x, high}, make_rot(angle)};
}

double angle_between(Point a, Point b) { return std::atan2(exact::cross(a, b), exact::dot(a, b)); }

Point outward(Vec2 from, Vec2 to) {
    const Point e = exact::of(to - from);
    return (1 / exact::length(e)) * Point{e.y, -e.x};
}

// Is n a direction in which the chain's surface really faces somewhere on this link, its end corners included?
bool is_allowed(const ChainSegment& s, Vec2 normal) {
    const Point n = exact::of(normal), own = outward(s.segment.point1, s.segment.point2);
    const double turn = angle_between(own, n);
    if (std::fabs(turn) < 1e-3) return true;
    // A convex corner turns the normal clockwise towards p1's neighbour and anticlockwise towards p2's.
    const double to_first = std::min(0.0, angle_between(own, outward(s.ghost1, s.segment.point1)));
    const double to_second = std::max(0.0, angle_between(own, outward(s.segment.point2, s.ghost2)));
    // Corners flatter than 0.01 count as straight: there only the link's own normal is left.
    const double first = to_first < -0.0099 ? to_first - corner_tolerance : 0;
    const double second = to_second > 0.0099 ? to_second + corner_tolerance : 0;
    return turn >= first - 1e-3 && turn <= second + 1e-3;
}

TEST(FlatChain, WhateverIsDraggedAcrossFeelsOnlyTheNormalUp) {
    const Chain chain = flat_chain();
    int contacts = 0;
    for (const Body& body : bodies()) {
        for (float angle : {0.0f, 0.001f, -0.02f, 0.3f, 1.0f, -1.5f, 1.5707963f}) {
            const float rest = resting_pose(chain, body.shape, 0.3f, angle).p.y;
            for (float height : {-0.01f, -0.004f, 0.0f, 0.01f}) {
                for (float x = -4; x < 4; x += stride * 0.0137f) {
                    const Transform t = {{x, rest + height}, make_rot(angle)};
                    double least = 1e9;
                    for (std::size_t i = 0; i < chain.links(); ++i) {
                        const Manifold m = collide(chain.link(i), body.shape, t);
                        for (std::uint32_t k = 0; k < m.count; ++k) {
                            ASSERT_NEAR(m.normal.x, 0.0f, 1e-6f) << body.name << " at " << x << ", angle " << angle;
                            ASSERT_NEAR(m.normal.y, 1.0f, 1e-6f) << body.name << " at " << x << ", angle " << angle;
                            least = std::min(least, static_cast<double>(m.points[k].separation));
                        }
                        contacts += m.count > 0 ? 1 : 0;
                    }
                    // And it is held at every place: the links leave no gap between them.
                    ASSERT_NEAR(least, static_cast<double>(height), 2e-5) << body.name << " at " << x << ", angle " << angle;
                }
            }
        }
    }
    EXPECT_GT(contacts, cases(10000));
}

TEST(HillyChain, OnlyNormalsBetweenTheNeighboursAreUsed) {
    const Chain chain = hilly_chain();
    int contacts = 0;
    for (const Body& body : bodies()) {
        for (float angle : {0.0f, 0.1f, -0.7854f, 1.2f, 2.0f}) {
            for (float x = -6; x < 6; x += stride * 0.0731f) {
                const Transform rest = resting_pose(chain, body.shape, x, angle);
                for (float height : {-0.005f, -0.001f, 0.003f, 0.015f}) {
                    const Transform t = {{x, rest.p.y + height}, rest.q};
                    for (std::size_t i = 0; i < chain.links(); ++i) {
                        const ChainSegment link = chain.link(i);
                        const Manifold m = collide(link, body.shape, t);
                        if (m.count == 0) continue;
                        ++contacts;
                        ASSERT_TRUE(is_allowed(link, m.normal)) << body.name << " at " << x << " angle " << angle << " height " << height
                                                                << " link " << i << " normal " << m.normal.x << ", " << m.normal.y;
                    }
                }
            }
        }
    }
    EXPECT_GT(contacts, cases(10000));
}

TEST(HillyChain, TheNearestLinkReportsTheExactDistance) {
    const Chain chain = hilly_chain();
    for (const Body& body : bodies()) {
        for (float angle : {0.0f, 0.1f, -0.7854f, 1.2f, 2.0f}) {
            for (float x = -6; x < 6; x += stride * 0.0531f) {
                Transform t = resting_pose(chain, body.shape, x, angle);
                t.p.y += 0.006f;
                const double want = distance_to(chain, body.shape, t);
                double least = 1e9;
                for (std::size_t i = 0; i < chain.links(); ++i) {
                    const Manifold m = collide(chain.link(i), body.shape, t);
                    for (std::uint32_t k = 0; k < m.count; ++k) least = std::min(least, static_cast<double>(m.points[k].separation));
                }
                ASSERT_GE(least, want - 1e-5) << body.name << " at " << x << " angle " << angle;
                ASSERT_LE(least, want + 2 * link_tie) << body.name << " at " << x << " angle " << angle;
            }
        }
    }
}

TEST(Chain, NothingIsFeltFromBehind) {
    const Chain chain = flat_chain();
    for (const Body& body : bodies()) {
        for (float angle : {0.0f, 0.4f, 1.5f}) {
            for (float x = -4; x < 4; x += 0.11f) {
                for (float y : {-0.001f, -0.1f, -0.35f, -0.7f}) {
                    for (std::size_t i = 0; i < chain.links(); ++i) {
                        // The house's centroid is not at its origin; it decides on which side a polygon is.
                        const Polygon* p = std::get_if<Polygon>(&body.shape);
                        const Vec2 centroid = p != nullptr ? rotate(make_rot(angle), p->centroid) : Vec2{};
                        const Transform t = {{x, y - centroid.y}, make_rot(angle)};
                        ASSERT_EQ(collide(chain.link(i), body.shape, t).count, 0u) << body.name << " at " << x << ", " << y;
                    }
                }
            }
        }
    }
}

TEST(Chain, AConvexCornerHoldsACircleByItsVertexAndAnInnerCornerByBothFaces) {
    // An outer corner at the origin between two slopes of 45 degrees.
    const Chain ridge = {{{4, -4}, {2, -2}, {0, 0}, {-2, -2}, {-4, -4}}};
    const Circle ball = {{}, 0.5f};
    for (std::size_t i = 0; i < 2; ++i) {
        const Manifold m = detail::collide(ridge.link(i), ball, {{0, 0.5f}, {}}, speculative_distance);
        ASSERT_EQ(m.count, 1u);
        EXPECT_NEAR(m.normal.x, 0.0f, 1e-6f);
        EXPECT_NEAR(m.normal.y, 1.0f, 1e-6f);
    }
    const Chain valley = {{{4, 4}, {2, 2}, {0, 0}, {-2, 2}, {-4, 4}}};
    const float height = 0.5f * 1.41421356f;
    for (std::size_t i = 0; i < 2; ++i) {
        const Manifold m = detail::collide(valley.link(i), ball, {{0, height}, {}}, speculative_distance);
        ASSERT_EQ(m.count, 1u);
        EXPECT_NEAR(m.normal.x, i == 0 ? -0.70710678f : 0.70710678f, 1e-5f);
        EXPECT_NEAR(m.points[0].separation, 0.0f, 1e-5f);
    }
}

// A flat top from x = 2 to the ledge at the origin, then a wall straight down, its outside on the left.
Chain ledge() { return {{{4, 0}, {2, 0}, {0, 0}, {0, -2}, {0, -4}}}; }

TEST(Chain, ABoxSlidingDownTheWallIsNotCaughtByTheLedge) {
    const Chain left = ledge();
    const Chain right = {{{0, -4}, {0, -2}, {0, 0}, {-2, 0}, {-4, 0}}};
    for (const Polygon& box : {make_box(0.3f, 0.3f), make_rounded_box(0.2f, 0.2f, 0.1f)}) {
        for (float top = 0.2f; top > -0.2f; top -= 0.003f) {
            for (const bool on_left : {true, false}) {
                const float side = on_left ? -1.0f : 1.0f;
                const Transform t = {{0.298f * side, top - 0.3f}, {}};
                EXPECT_EQ(detail::collide(on_left ? left.link(0) : right.link(1), box, t, speculative_distance).count, 0u) << "top at " << top;
                const Manifold m = detail::collide(on_left ? left.link(1) : right.link(0), box, t, speculative_distance);
                ASSERT_GE(m.count, 1u) << "top at " << top;
                EXPECT_EQ(m.normal, (Vec2{side, 0})) << "top at " << top;
                for (std::uint32_t i = 0; i < m.count; ++i) EXPECT_NEAR(m.points[i].separation, -0.002f, 1e-6f);
            }
        }
    }
}

TEST(Chain, ACornerPressedIntoTheWallBelowTheLedgeIsTheWallsAlone) {
    const Chain left = ledge();
    const Chain right = {{{0, -4}, {0, -2}, {0, 0}, {-2, 0}, {-4, 0}}};
    const Polygon box = make_box(0.3f, 0.3f);
    for (const float degrees : {40.0f, 45.0f, 50.0f}) {
        const Rot q = make_rot(degrees * pi / 180);
        for (const bool on_left : {true, false}) {
            const float side = on_left ? -1.0f : 1.0f;
            const Vec2 pressed = rotate(q, {-0.3f * side, 0.3f * side});  // the corner furthest towards the wall
            for (float height = -0.001f; height > -0.2f; height -= 0.003f) {
                const Transform t = {Vec2{-0.002f * side, height} - pressed, q};
                EXPECT_EQ(detail::collide(on_left ? left.link(0) : right.link(1), box, t, speculative_distance).count, 0u) << degrees << " at " << height;
                const Manifold m = detail::collide(on_left ? left.link(1) : right.link(0), box, t, speculative_distance);
                ASSERT_GE(m.count, 1u) << degrees << " at " << height;
                EXPECT_EQ(m.normal, (Vec2{side, 0})) << degrees << " at " << height;
                const float least = m.count == 2 ? islet::min(m.points[0].separation, m.points[1].separation) : m.points[0].separation;
                EXPECT_NEAR(least, -0.002f, 1e-6f);
            }
        }
    }
}

TEST(Chain, ABoxSlidingOverTheLedgeIsNotPushedBackByTheWall) {
    const Chain chain = ledge();
    const Polygon box = make_box(0.3f, 0.3f);
    for (float x = 0.5f; x > -0.2f; x -= 0.003f) {
        const Transform t = {{x, 0.298f}, {}};
        EXPECT_EQ(detail::collide(chain.link(1), box, t, speculative_distance).count, 0u) << x;
        const Manifold m = detail::collide(chain.link(0), box, t, speculative_distance);
        ASSERT_EQ(m.count, 2u) << x;
        EXPECT_EQ(m.normal, (Vec2{0, 1})) << x;
    }
}

TEST(Chain, AFaceLeaningOnACornerIsReportedByTheLinkItLeansTowards) {
    const Chain chain = ledge();
    const Polygon box = make_box(0.3f, 0.3f);
    for (float degrees : {20.0f, 30.0f, 60.0f, 70.0f}) {
        const Rot q = make_rot(degrees * pi / 180);
        for (float gap : {-0.002f, 0.003f}) {
            // The middle of the box's lower face is at the corner; it leans from level (0) to upright (90).
            const Transform t = {rotate(q, {0, 0.3f + gap}), q};
            const std::size_t near = degrees < 45 ? 0 : 1;
            EXPECT_EQ(detail::collide(chain.link(1 - near), box, t, speculative_distance).count, 0u) << degrees;
            const Manifold m = detail::collide(chain.link(near), box, t, speculative_distance);
            ASSERT_GE(m.count, 1u) << degrees;
            EXPECT_NEAR(m.normal.x, -q.s, 1e-5f);
            EXPECT_NEAR(m.normal.y, q.c, 1e-5f);
        }
    }
}

TEST(Chain, ABoxStandingOnOneLinkHasTwoPointsWithLastingNames) {
    const Chain chain = flat_chain();
    const Polygon box = make_box(0.3f, 0.3f);
    std::uint16_t first = 0, second = 0;
    for (int i = -20; i <= 20; ++i) {
        const float t = 0.001f * static_cast<float>(i);
        const Manifold m = detail::collide(chain.link(6), box, {{0.5f + t, 0.299f}, make_rot(0.1f * t)}, speculative_distance);
        ASSERT_EQ(m.count, 2u);
        if (i == -20) first = m.points[0].id, second = m.points[1].id;
        EXPECT_EQ(m.points[0].id, first);
        EXPECT_EQ(m.points[1].id, second);
    }
    EXPECT_NE(first, second);
}

}  // namespace
