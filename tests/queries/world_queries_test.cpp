// The queries of a world against a search through all its shapes, one by one, in double precision (oracle.hpp).
#include <gtest/gtest.h>

#include "random_worlds.hpp"

namespace {

using namespace random_worlds;
using exact::Point;
using oracle::Solid;
using test::cases;
using test::known_shapes;

constexpr double relative_error_in_world = 3e-6;  // of the largest difference of corners; a shape's body turns and moves it, which rounds too

// -- casts -------------------------------------------------------------------------------------------------------------------------

struct Tally {
    int asked = 0, hits = 0, doubtful = 0;
};

// The hits that a cast must have, in order; those that single precision cannot tell from a miss, or from the order of another, are forgiven.
void check_all_hits(const std::vector<Known>& known, const ShapeProxy& moving, Vec2 way, const QueryFilter& filter, const std::vector<QueryHit>& got,
                    Tally& tally) {
    const Solid solid = oracle::solid_of(moving);
    const Point d = exact::of(way);
    ++tally.asked;
    for (std::size_t i = 1; i < got.size(); ++i) {
        const bool ordered = got[i - 1].fraction < got[i].fraction ||
                             (got[i - 1].fraction == got[i].fraction && got[i - 1].shape.index1 < got[i].shape.index1);
        ASSERT_TRUE(ordered) << "hit " << i << " is not in its place";
    }
    double around = solid.radius;
    for (const Point p : solid.core) around = std::max(around, exact::length(p - solid.core[0]) + solid.radius);
    for (const Known& k : known) {
        const auto hit = std::find_if(got.begin(), got.end(), [&](const QueryHit& h) { return h.shape == k.id; });
        const bool near = exact::point_segment(k.center, solid.core[0], solid.core[0] + d) <= k.reach + around + 1e-3;
        const bool may = near && wanted(k, filter) && !oracle::passes(solid, d, k.solid);
        const Solid w = may ? oracle::difference(solid, k.solid) : Solid{};
        const double want = may ? oracle::first_entry(w, {}, d) : oracle::never;
        if (want == oracle::never && hit == got.end()) continue;
        ASSERT_TRUE(may) << "found a shape that it should not look at";
        const double tolerance = relative_error_in_world * oracle::scale_of(solid, k.solid, d);
        if (oracle::is_doubtful(w, {}, d, tolerance)) {
            ++tally.doubtful;
            continue;
        }
        ASSERT_EQ(hit != got.end(), want != oracle::never) << "least distance on the way " << oracle::least_on_way(w, {}, d);
        ++tally.hits;
        const double at = double(hit->fraction) * exact::length(d);
        const double cosine = std::fabs(exact::dot(exact::of(hit->normal), d)) / exact::length(d);
        if (hit->separation == 0) {
            ASSERT_NEAR(at, want * exact::length(d), 2 * tolerance / std::max(cosine, 0.02));
            ASSERT_NEAR(oracle::signed_distance(oracle::moved(solid, double(hit->fraction) * d), k.solid), 0, tolerance);
        } else {
            ASSERT_NEAR(double(hit->separation), oracle::depth_at(w, {}), tolerance);
            ASSERT_EQ(hit->fraction, 0);
        }
        ASSERT_NEAR(oracle::depth_at(k.solid, exact::of(hit->point)), 0, tolerance) << "the point is not on the surface";
        ASSERT_NEAR(exact::length(exact::of(hit->normal)), 1, 1e-5);
    }
}

// Closest, any, some of them and one by one: all must agree with the full list.
template <class First, class Any, class All, class Each>
void check_forms(const std::vector<QueryHit>& all, exact::Random& r, First&& first, Any&& any, All&& some, Each&& each) {
    ASSERT_TRUE(same(first(), all.empty() ? QueryHit{} : all[0]));
    ASSERT_EQ(any(), !all.empty());
    std::vector<QueryHit> few(r.below(4));
    ASSERT_EQ(some(few), all.size()) << "the count is of all, not of those that fit";
    for (std::size_t i = 0; i < std::min(few.size(), all.size()); ++i) ASSERT_TRUE(same(few[i], all[i]));
    for (const Notes::Answer answer : {Notes::go_on, Notes::ignore}) {
        Notes notes;
        notes.answer = answer;
        notes.stop_after = r.below(2) == 0 ? 1 + r.below(12) : ~std::size_t{0};
        each(notes);
        ASSERT_EQ(notes.hits.size(), std::min(notes.stop_after, all.size()));
        for (std::size_t i = 0; i < notes.hits.size(); ++i) ASSERT_TRUE(same(notes.hits[i], all[i]));
    }
    Notes cut;
    cut.answer = Notes::cut;
    each(cut);
    const auto as_near = std::count_if(all.begin(), all.end(), [&](const QueryHit& h) { return h.fraction == all[0].fraction; });
    ASSERT_EQ(cut.hits.size() > 0, !all.empty());
    if (!all.empty() && all[0].fraction > 0) {
        ASSERT_EQ(cut.hits.size(), static_cast<std::size_t>(as_near)) << "cut at the first hit, only those as near are left";
    }
}

TEST(WorldQueries, RaysFindWhatASearchThroughAllShapesFindsIn100000RandomCases) {
    Tally tally;
    in_random_worlds(cases(200), [&](exact::Random& r, const TestWorld& w, const std::vector<Known>& known) {
        for (int i = 0; i < 500; ++i) {
            const Vec2 o{r.in(-size, size), r.in(-size, size)};
            Vec2 d{r.in(-2 * size, 2 * size), r.in(-2 * size, 2 * size)};
            if (i % 10 == 0) (i % 20 == 0 ? d.x : d.y) = 0;
            const QueryFilter filter = random_filter(r);
            std::vector<QueryHit> all(known.size());
            all.resize(w->cast_ray_all(o, d, all, filter));
            check_all_hits(known, make_proxy({&o, 1}), d, filter, all, tally);
            if (testing::Test::HasFatalFailure()) return;
            if (i % 4 != 0) continue;
            check_forms(
                all, r, [&] { return w->cast_ray(o, d, filter); }, [&] { return w->cast_ray_any(o, d, filter); },
                [&](std::span<QueryHit> out) { return w->cast_ray_all(o, d, out, filter); },
                [&](Notes& notes) { w->cast_ray_each(o, d, filter, Notes::visit, &notes); });
            if (testing::Test::HasFatalFailure()) return;
        }
    });
    std::printf("rays: %d asked, %d hits, %d too close to call\n", tally.asked, tally.hits, tally.doubtful);
    EXPECT_GE(tally.asked, cases(100000));
    EXPECT_GT(tally.hits, cases(60000) / (test::slow_build ? 3 : 1));  // of few worlds, most may be poor
    EXPECT_LT(tally.doubtful, tally.hits / 500);
}

TEST(WorldQueries, MovingShapesFindWhatASearchThroughAllShapesFindsIn100000RandomCases) {
    Tally tally;
    in_random_worlds(cases(200), [&](exact::Random& r, const TestWorld& w, const std::vector<Known>& known) {
        for (int i = 0; i < 500; ++i) {
            const ShapeProxy p = transform_proxy(test::hard_pose(r, size), test::random_shape(r, 0.7, false));
            if (p.count == 0) continue;
            const Vec2 d = i % 10 == 0 ? Vec2{0, r.in(-3, 3)} : Vec2{r.in(-size, size), r.in(-size, size)};
            const QueryFilter filter = random_filter(r);
            std::vector<QueryHit> all(known.size());
            all.resize(w->cast_shape_all(p, d, all, filter));
            check_all_hits(known, p, d, filter, all, tally);
            if (testing::Test::HasFatalFailure()) return;
            if (i % 4 != 0) continue;
            check_forms(
                all, r, [&] { return w->cast_shape(p, d, filter); }, [&] { return w->cast_shape_any(p, d, filter); },
                [&](std::span<QueryHit> out) { return w->cast_shape_all(p, d, out, filter); },
                [&](Notes& notes) { w->cast_shape_each(p, d, filter, Notes::visit, &notes); });
            if (testing::Test::HasFatalFailure()) return;
        }
    });
    std::printf("moving shapes: %d asked, %d hits, %d too close to call\n", tally.asked, tally.hits, tally.doubtful);
    EXPECT_GE(tally.asked, cases(99000));
    EXPECT_GT(tally.hits, cases(60000) / (test::slow_build ? 3 : 1));  // of few worlds, most may be poor
    EXPECT_LT(tally.doubtful, tally.hits / 500);
}

// -- overlaps ----------------------------------------------------------------------------------------------------------------------

// `distance` of each shape from what is asked about: those below 0 must be found, in the order of their slots.
template <class Distance, class Some, class Each>
void check_overlaps(const std::vector<Known>& known, const QueryFilter& filter, exact::Random& r, Distance&& distance, Some&& some, Each&& each,
                    Tally& tally) {
    std::vector<ShapeId> got(known.size());
    got.resize(some(std::span<ShapeId>(got)));
    ++tally.asked;
    std::size_t at = 0;
    for (const Known& k : known) {
        const bool found = at < got.size() && got[at] == k.id;
        at += found ? 1 : 0;
        if (!wanted(k, filter)) {
            ASSERT_FALSE(found);
            continue;
        }
        const double gap = distance(k);
        if (std::fabs(gap) < relative_error_in_world * 4 * size) {
            ++tally.doubtful;
            continue;
        }
        ASSERT_EQ(found, gap < 0) << gap;
        tally.hits += found ? 1 : 0;
    }
    ASSERT_EQ(at, got.size()) << "found twice, in another order, or not there";
    std::vector<ShapeId> few(r.below(3));
    ASSERT_EQ(some(std::span<ShapeId>(few)), got.size());
    for (std::size_t i = 0; i < std::min(few.size(), got.size()); ++i) ASSERT_EQ(few[i], got[i]);
    IdNotes notes;
    notes.stop_after = r.below(2) == 0 ? 1 + r.below(12) : ~std::size_t{0};
    each(notes);
    got.resize(std::min(got.size(), notes.stop_after));
    ASSERT_EQ(notes.ids, got);
}

void expect_enough(const char* what, const Tally& tally, int least_hits) {
    std::printf("%s: %d asked, %d found, %d too close to call\n", what, tally.asked, tally.hits, tally.doubtful);
    EXPECT_GE(tally.asked, cases(99000));
    EXPECT_GT(tally.hits, test::slow_build ? cases(least_hits) / 2 : least_hits);  // a few worlds are no mean of all
    EXPECT_LT(tally.doubtful, tally.asked / (test::slow_build ? 100 : 500));
}

TEST(WorldQueries, OverlapsAreThoseOfASearchThroughAllShapesIn100000RandomCasesEach) {
    Tally boxes, shapes, points;
    in_random_worlds(cases(200), [&](exact::Random& r, const TestWorld& w, const std::vector<Known>& known) {
        for (int i = 0; i < 500; ++i) {
            const QueryFilter filter = random_filter(r);
            const Vec2 lower{r.in(-size, size), r.in(-size, size)};
            const Aabb box{lower, lower + Vec2{r.in(0, 4), r.in(0, 4)}};
            check_overlaps(
                known, filter, r,
                [&](const Known& k) {
                    Point low{1e300, 1e300}, high{-1e300, -1e300};
                    for (const Point p : k.solid.core) {
                        low = {std::min(low.x, p.x - k.solid.radius), std::min(low.y, p.y - k.solid.radius)};
                        high = {std::max(high.x, p.x + k.solid.radius), std::max(high.y, p.y + k.solid.radius)};
                    }
                    return std::max({low.x - double(box.upper.x), double(box.lower.x) - high.x, low.y - double(box.upper.y), double(box.lower.y) - high.y});
                },
                [&](std::span<ShapeId> out) { return w->overlap_box(box, out, filter); },
                [&](IdNotes& notes) { w->overlap_box_each(box, filter, IdNotes::visit, &notes); }, boxes);
            if (testing::Test::HasFatalFailure()) return;

            const ShapeProxy p = transform_proxy(test::hard_pose(r, size), test::random_shape(r, 1));
            if (p.count == 0) continue;
            const Solid solid = oracle::solid_of(p);
            check_overlaps(
                known, filter, r, [&](const Known& k) { return oracle::signed_distance(solid, k.solid); },
                [&](std::span<ShapeId> out) { return w->overlap_shape(p, out, filter); },
                [&](IdNotes& notes) { w->overlap_shape_each(p, filter, IdNotes::visit, &notes); }, shapes);
            if (testing::Test::HasFatalFailure()) return;

            const Vec2 point{r.in(-size, size), r.in(-size, size)};
            check_overlaps(
                known, filter, r,
                [&](const Known& k) {
                    const bool thin = k.solid.core.size() == 2 && k.solid.radius == 0;
                    return thin ? 1 : oracle::depth_at(k.solid, exact::of(point));
                },
                [&](std::span<ShapeId> out) { return w->overlap_point(point, out, filter); },
                [&](IdNotes& notes) { w->overlap_point_each(point, filter, IdNotes::visit, &notes); }, points);
            if (testing::Test::HasFatalFailure()) return;
        }
    });
    expect_enough("boxes", boxes, 50000);
    expect_enough("shapes", shapes, 20000);
    expect_enough("points", points, 5000);
}

TEST(WorldQueries, TheClosestShapeIsThatOfASearchThroughAllShapesIn100000RandomCases) {
    int found = 0, asked = 0;
    in_random_worlds(cases(200), [&](exact::Random& r, const TestWorld& w, const std::vector<Known>& known) {
        for (int i = 0; i < 500; ++i, ++asked) {
            const Vec2 point{r.in(-1.5 * size, 1.5 * size), r.in(-1.5 * size, 1.5 * size)};
            const float within = i % 3 == 0 ? max_translation : r.in(0, 5);
            const QueryFilter filter = random_filter(r);
            const ClosestHit got = w->closest(point, within, filter);
            double least = oracle::never;
            const Known* of_got = nullptr;
            for (const Known& k : known) {
                if (k.id == got.shape) of_got = &k;
                if (wanted(k, filter)) least = std::min(least, std::max(0.0, oracle::depth_at(k.solid, exact::of(point))));
            }
            constexpr double tolerance = relative_error_in_world * 4 * size;
            if (!got) {
                ASSERT_GT(least, double(within) - tolerance);
                continue;
            }
            ++found;
            ASSERT_NE(of_got, nullptr);
            ASSERT_TRUE(wanted(*of_got, filter));
            const double depth = oracle::depth_at(of_got->solid, exact::of(point));
            ASSERT_NEAR(double(got.distance), least, tolerance);
            ASSERT_NEAR(double(got.distance), std::max(0.0, depth), tolerance);
            ASSERT_LT(oracle::depth_at(of_got->solid, exact::of(got.point)), tolerance);
            ASSERT_NEAR(exact::length(exact::of(got.point) - exact::of(point)), double(got.distance), tolerance);
            ASSERT_NEAR(exact::length(exact::of(got.normal)), 1, 1e-5);
        }
    });
    EXPECT_EQ(asked, cases(100000));
    EXPECT_GT(found, cases(45000));
}

TEST(WorldQueries, TheSurfacesNearAShapeAreThoseOfASearchThroughAllShapesIn100000RandomCases) {
    Tally tally;
    in_random_worlds(cases(200), [&](exact::Random& r, const TestWorld& w, const std::vector<Known>& known) {
        for (int i = 0; i < 500; ++i) {
            const ShapeProxy p = transform_proxy(test::hard_pose(r, size), test::random_shape(r, 0.7, false));
            if (p.count == 0) continue;
            const float within = i % 4 == 0 ? 0 : r.in(0, 2);
            const QueryFilter filter = random_filter(r);
            const Solid solid = oracle::solid_of(p);
            std::vector<Surface> got(known.size());
            got.resize(w->surfaces_near(p, within, got, filter));
            ++tally.asked;
            for (std::size_t k = 1; k < got.size(); ++k) {
                ASSERT_TRUE(got[k - 1].separation < got[k].separation ||
                            (got[k - 1].separation == got[k].separation && got[k - 1].shape.index1 < got[k].shape.index1));
            }
            for (const Known& k : known) {
                const auto found = std::find_if(got.begin(), got.end(), [&](const Surface& s) { return s.shape == k.id; });
                const double gap = oracle::signed_distance(solid, k.solid);
                Point n, middle;
                if (k.solid.one_sided) {
                    const Point e = k.solid.core[1] - k.solid.core[0];
                    n = (1 / exact::length(e)) * Point{e.y, -e.x};
                    for (const Point q : solid.core) middle = middle + (1.0 / double(solid.core.size())) * (q - k.solid.core[0]);
                }
                constexpr double tolerance = relative_error_in_world * 4 * size;
                // Seen from a line that it does not cross the shape is in front where a step outwards takes it farther away.
                const bool crosses = exact::distance(solid.core, k.solid.core) <= 0;
                const double outwards = k.solid.one_sided && !crosses ? oracle::signed_distance(oracle::moved(solid, 1e-5 * n), k.solid) - gap : 1;
                const bool sideways = std::fabs(outwards) < 1e-7 || (k.solid.one_sided && std::fabs(exact::dot(n, middle)) < tolerance);
                if (std::fabs(gap - double(within)) < tolerance || (gap < double(within) && sideways)) {
                    ++tally.doubtful;
                    continue;
                }
                const bool want = wanted(k, filter) && gap < double(within) && exact::dot(n, middle) >= 0 && outwards > 0;
                ASSERT_EQ(found != got.end(), want) << gap;
                if (!want) continue;
                ++tally.hits;
                const Point normal = exact::of(found->normal);
                ASSERT_NEAR(exact::length(normal), 1, 1e-5);
                if (k.solid.one_sided && crosses) {
                    // Out by the front: moved by the depth along the normal it just touches the line from there.
                    ASSERT_GT(exact::dot(normal, n), 0);
                    const Solid out = oracle::moved(solid, (1e-3 - double(found->separation)) * normal);
                    ASSERT_GT(oracle::signed_distance(out, k.solid), 0);
                    continue;
                }
                ASSERT_NEAR(double(found->separation), gap, tolerance);
                ASSERT_NEAR(oracle::depth_at(k.solid, exact::of(found->point)), 0, tolerance);
                ASSERT_NEAR(oracle::signed_distance(oracle::moved(solid, -gap * normal), k.solid), 0, 3 * tolerance);
            }
        }
    });
    expect_enough("surfaces", tally, 40000);
}

}  // namespace
