// The queries of a world against a search through all its shapes, one by one, in double precision (oracle.hpp). The worlds hold every type of shape on
// static, kinematic, dynamic and sleeping bodies, sensors, disabled bodies, filters of all kinds, and holes where
// shapes were destroyed.
#include <gtest/gtest.h>

#include <thread>

#include "known.hpp"
#include "shapes.hpp"
#include "support/effort.hpp"
#include "support/random.hpp"
#include "support/test_world.hpp"

namespace {

using namespace islet;
using exact::Point;
using oracle::Solid;
using test::cases;
using test::Known;
using test::known_shapes;
using test::TestWorld;

constexpr double relative_error_in_world = 3e-6;  // of the largest difference of corners; a shape's body turns and moves it, which rounds too

bool wanted(const Known& k, const QueryFilter& f) {
    return k.enabled && (!k.sensor || f.sensors) && (f.mask & k.filter.category) != 0 && (k.filter.mask & f.category) != 0;
}

ShapeDef random_def(exact::Random& r) {
    ShapeDef def;
    if (r.below(4) == 0) def.filter = {1u << r.below(3), r.below(8), 0};
    def.sensor = r.below(8) == 0;
    return def;
}

// Bodies of all types strewn about, some asleep, a few moved by hand; then some are destroyed, and time goes on.
void fill(TestWorld& w, exact::Random& r, int bodies, double reach) {
    const auto random_body = [&](BodyType type) {
        BodyDef def;
        def.type = type;
        def.position = {r.in(-reach, reach), r.in(-reach, reach)};
        def.angle = r.in(-3, 3);
        def.linear_velocity = {r.in(-3, 3), r.in(-3, 3)};
        def.angular_velocity = r.in(-2, 2);
        def.awake = r.below(3) != 0;
        def.enabled = r.below(10) != 0;
        return w->create_body(def);
    };
    for (int i = 0; i < bodies; ++i) {
        const BodyId body = random_body(static_cast<BodyType>(r.below(3)));
        const auto point = [&] { return Vec2{r.in(-2, 2), r.in(-2, 2)}; };
        for (std::uint32_t n = 1 + r.below(2); n > 0; --n) {
            const ShapeDef def = random_def(r);
            switch (r.below(6)) {
            case 0: w->create_shape(body, Circle{point(), r.in(0.1, 1)}, def); break;
            case 1: w->create_shape(body, Capsule{point(), point(), r.in(0.1, 1)}, def); break;
            case 2: w->create_shape(body, Segment{point(), point()}, def); break;
            case 3: w->create_shape(body, exact::random_polygon(r, 1.5), def); break;
            case 4: w->create_shape(body, exact::random_polygon(r, 1, r.in(0.05, 0.5)), def); break;
            default: {
                const Vec2 points[] = {{3, r.in(-1, 1)}, {1, r.in(-1, 1)}, {-1, r.in(-1, 1)}, {-3, r.in(-1, 1)}};
                w->create_chain(body, points, false, def);
            }
            }
        }
    }
    const auto all = w.bodies();
    for (std::size_t i = 0; i < all.size(); i += 9) w->destroy_body(all[i]);
    w.step(1 + static_cast<int>(r.below(4)));
    for (std::size_t i = 4; i < all.size(); i += 9) w->set_transform(all[i], {r.in(-reach, reach), r.in(-reach, reach)}, r.in(-3, 3));
    for (std::size_t i = 5; i < all.size(); i += 9) w->destroy_shape(w.shape_of(all[i]));
    w.errors.clear();
}

QueryFilter random_filter(exact::Random& r) {
    return r.below(2) == 0 ? QueryFilter{} : QueryFilter{.category = 1u << r.below(3), .mask = r.below(8), .sensors = r.below(2) == 0};
}

constexpr double size = 12;  // half of a world's width

template <class Test>
void in_random_worlds(int worlds, Test&& test) {
    exact::Random r;
    for (int i = 0; i < worlds; ++i) {
        TestWorld w;
        // Mostly resting or mostly awake ones, few or many.
        fill(w, r, 10 + static_cast<int>(r.below(50)), size);
        const std::vector<Known> known = known_shapes(w);
        test(r, w, known);
        if (testing::Test::HasFatalFailure()) return;
        ASSERT_TRUE(w.errors.empty());
    }
}

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

bool same(const QueryHit& a, const QueryHit& b) {
    return a.shape == b.shape && a.point == b.point && a.normal == b.normal && a.fraction == b.fraction && a.separation == b.separation;
}

// What a visitor notes, and how it answers.
struct Notes {
    std::vector<QueryHit> hits;
    std::size_t stop_after = ~std::size_t{0};
    enum Answer { go_on, ignore, cut } answer = go_on;
    static float visit(const QueryHit& hit, void* context) {
        Notes& notes = *static_cast<Notes*>(context);
        notes.hits.push_back(hit);
        if (notes.hits.size() == notes.stop_after) return 0;
        return notes.answer == go_on ? 1.0f : notes.answer == ignore ? -1.0f : hit.fraction;
    }
};

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
    EXPECT_GT(tally.hits, cases(60000));
    EXPECT_LT(tally.doubtful, tally.hits / 500);
}

TEST(WorldQueries, MovingShapesFindWhatASearchThroughAllShapesFindsIn100000RandomCases) {
    Tally tally;
    in_random_worlds(cases(200), [&](exact::Random& r, const TestWorld& w, const std::vector<Known>& known) {
        for (int i = 0; i < 500; ++i) {
            const ShapeProxy p = transform_proxy(r.pose(size), test::random_shape(r, 0.7, false));
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
    EXPECT_GT(tally.hits, cases(60000));
    EXPECT_LT(tally.doubtful, tally.hits / 500);
}

// -- overlaps ----------------------------------------------------------------------------------------------------------------------

struct IdNotes {
    std::vector<ShapeId> ids;
    std::size_t stop_after = ~std::size_t{0};
    static bool visit(ShapeId id, void* context) {
        IdNotes& notes = *static_cast<IdNotes*>(context);
        notes.ids.push_back(id);
        return notes.ids.size() != notes.stop_after;
    }
};

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

            const ShapeProxy p = transform_proxy(r.pose(size), test::random_shape(r, 1));
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
            const ShapeProxy p = transform_proxy(r.pose(size), test::random_shape(r, 0.7, false));
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

// -- what must not matter ------------------------------------------------------------------------------------------------------------

TEST(WorldQueries, TheOrderOfHitsDependsNeitherOnTheTreeNorOnWhoIsAwake) {
    // The same wall of ten equal boxes, all met at the same fraction, made in the same slots: asleep, awake, and half of them woken after others came and
    // went, so that the tree has another shape.
    std::vector<std::vector<ShapeId>> orders;
    for (int variant = 0; variant < 4; ++variant) {
        TestWorld w(test::roomy, {.gravity = {0, 0}});
        std::vector<BodyId> bodies;
        for (int i = 0; i < 10; ++i) {
            BodyDef def{.type = BodyType::dynamic, .position = {5, static_cast<float>(3 * i)}};
            def.awake = variant == 1;
            bodies.push_back(w.add(make_box(1, 1), def));
        }
        if (variant >= 2) {
            std::vector<BodyId> others;
            for (int i = 0; i < 30; ++i) others.push_back(w.add_box({static_cast<float>(i), -9}, 0.5f, 0.5f, {}, BodyType::static_body));
            for (const BodyId b : others) w->destroy_body(b);
        }
        if (variant == 3) {
            for (std::size_t i = 0; i < bodies.size(); i += 2) w->wake(bodies[i]);
        }
        const ShapeProxy wall = make_proxy(make_offset_box(0.5f, 20, {{0, 13}, {}}));
        QueryHit hits[10];
        ASSERT_EQ(w->cast_shape_all(wall, {10, 0}, hits), 10u);
        std::vector<ShapeId> order;
        for (const QueryHit& h : hits) {
            EXPECT_EQ(h.fraction, hits[0].fraction);
            order.push_back(h.shape);
        }
        EXPECT_TRUE(std::is_sorted(order.begin(), order.end(), [](ShapeId a, ShapeId b) { return a.index1 < b.index1; }));
        EXPECT_EQ(w->cast_shape(wall, {10, 0}).shape, order[0]);
        orders.push_back(order);
    }
    for (const auto& order : orders) EXPECT_EQ(order, orders[0]);
}

TEST(WorldQueries, ABodySetElsewhereIsFoundThereAtOnce) {
    TestWorld w;
    for (const BodyType type : {BodyType::static_body, BodyType::kinematic, BodyType::dynamic}) {
        const BodyId body = w.add_box({0, 0}, 0.5f, 0.5f, {}, type);
        w.step();
        w->set_transform(body, {100, 50}, 0.3f);
        EXPECT_FALSE(w->cast_ray_any({-5, 0}, {10, 0}));
        EXPECT_EQ(w->cast_ray({90, 50}, {20, 0}).shape, w.shape_of(body));
        EXPECT_EQ(w->closest({100, 50}, 1).shape, w.shape_of(body));
        w->destroy_body(body);
        EXPECT_FALSE(w->cast_ray_any({90, 50}, {20, 0}));
    }
}

TEST(WorldQueries, ABodyInMotionIsFoundWhereItIsAfterEachStep) {
    TestWorld w(test::roomy, {.gravity = {0, 0}});
    BodyDef def{.type = BodyType::dynamic, .position = {0, 0}, .linear_velocity = {30, 7}, .angular_velocity = 5};
    const BodyId body = w.add(Circle{{0, 0}, 0.25f}, def);
    for (int i = 0; i < 100; ++i) {
        w.step();
        const Vec2 p = w->position(body);
        const QueryHit hit = w->cast_ray(p + Vec2{0, 3}, {0, -6});
        ASSERT_TRUE(hit);
        ASSERT_NEAR(hit.point.y, p.y + 0.25f, 1e-5f);
    }
}

TEST(WorldQueries, AWorldAskedIsAWorldUnchanged) {
    exact::Random r;
    TestWorld w;
    fill(w, r, 40, size);
    const std::uint64_t before = w->hash();
    QueryHit hits[8];
    ShapeId ids[8];
    Notes notes;
    w->cast_ray({-20, 0}, {40, 0});
    w->cast_ray_all({-20, 0}, {40, 0}, hits);
    w->cast_ray_each({-20, 0}, {40, 0}, {}, Notes::visit, &notes);
    w->cast_shape(make_proxy(Circle{{-20, 0}, 2}), {40, 0});
    w->overlap_box({{-9, -9}, {9, 9}}, ids);
    w->closest({0, 0}, 9);
    EXPECT_EQ(w->hash(), before);
    EXPECT_EQ(w->validate(), nullptr);
}

TEST(WorldQueries, ManyThreadsMayAskAtOnce) {
    exact::Random r;
    TestWorld w;
    fill(w, r, 60, size);
    std::vector<Vec2> rays;
    for (int i = 0; i < 4000; ++i) rays.push_back({r.in(-size, size), r.in(-size, size)});
    const auto ask = [&](std::vector<float>& answers) {
        for (std::size_t i = 1; i < rays.size(); ++i) {
            QueryHit hits[4];
            Surface near[4];
            answers.push_back(w->cast_ray(rays[i - 1], rays[i] - rays[i - 1]).fraction);
            answers.push_back(static_cast<float>(w->cast_shape_all(make_proxy(Circle{rays[i], 0.5f}), {5, 1}, hits)) + hits[0].fraction);
            answers.push_back(static_cast<float>(w->surfaces_near(make_proxy(Circle{rays[i], 0.5f}), 1, near)) + w->closest(rays[i], 9).distance);
        }
    };
    std::vector<float> alone;
    ask(alone);
    std::vector<float> together[4];
    std::vector<std::thread> threads;
    for (auto& answers : together) threads.emplace_back([&] { ask(answers); });
    for (std::thread& t : threads) t.join();
    for (const auto& answers : together) EXPECT_EQ(answers, alone);
}

TEST(WorldQueries, AVisitorMayAskTheWorldItself) {
    TestWorld w;
    for (int i = 0; i < 20; ++i) w.add_box({static_cast<float>(2 * i), 0}, 0.5f, 0.5f, {}, BodyType::static_body);
    struct Asker {
        const World& world;
        int matches = 0;
    } asker{*w};
    const CastVisitor visit = [](const QueryHit& hit, void* context) {
        Asker& a = *static_cast<Asker*>(context);
        ShapeId inside;
        a.matches += a.world.overlap_point(hit.point + Vec2{0.1f, 0}, {&inside, 1}) == 1 && inside == hit.shape ? 1 : 0;
        return 1.0f;
    };
    w->cast_ray_each({-5, 0}, {100, 0}, {}, visit, &asker);
    EXPECT_EQ(asker.matches, 20);
}

// -- bad input -----------------------------------------------------------------------------------------------------------------------

TEST(WorldQueries, BadInputIsRefusedWithItsErrorAndFindsNothing) {
    TestWorld w;
    w.add_box({0, 0}, 5, 5, {}, BodyType::static_body);
    const float nan = __builtin_nanf(""), inf = __builtin_inff();
    const ShapeProxy ball = make_proxy(Circle{{0, 0}, 1});
    QueryHit hit;
    ShapeId id;
    Notes notes;
    IdNotes ids;
    const auto refused = [&](Error error) {
        const bool right = w->last_error() == error && !w.errors.empty() && w.errors.back() == error;
        w->clear_error();
        w.errors.clear();
        return right;
    };
    for (const Vec2 bad : {Vec2{nan, 0}, Vec2{0, inf}, Vec2{3e7f, 0}}) {
        const Error error = is_finite(bad) ? Error::out_of_range : Error::not_finite;
        EXPECT_FALSE(w->cast_ray(bad, {1, 0})) << bad.x;
        EXPECT_TRUE(refused(error));
        EXPECT_FALSE(w->cast_ray({0, 0}, bad));
        EXPECT_TRUE(refused(error));
        EXPECT_FALSE(w->cast_ray_any({0, 0}, bad));
        EXPECT_TRUE(refused(error));
        EXPECT_EQ(w->cast_ray_all(bad, {1, 0}, {&hit, 1}), 0u);
        EXPECT_TRUE(refused(error));
        w->cast_ray_each(bad, {1, 0}, {}, Notes::visit, &notes);
        EXPECT_TRUE(refused(error));
        EXPECT_FALSE(w->cast_shape(ball, bad));
        EXPECT_TRUE(refused(error));
        EXPECT_EQ(w->overlap_point(bad, {&id, 1}), 0u);
        EXPECT_TRUE(refused(error));
        EXPECT_EQ(w->overlap_box({bad, {9, 9}}, {&id, 1}), 0u);
        EXPECT_TRUE(refused(error));
        EXPECT_FALSE(w->closest(bad, 1));
        EXPECT_TRUE(refused(error));
    }
    EXPECT_EQ(w->surfaces_near(ball, -1, {}), 0u);
    EXPECT_TRUE(refused(Error::out_of_range));
    EXPECT_FALSE(w->closest({0, 0}, -1));
    EXPECT_TRUE(refused(Error::out_of_range));
    EXPECT_FALSE(w->closest({0, 0}, nan));
    EXPECT_TRUE(refused(Error::not_finite));
    EXPECT_EQ(w->overlap_box({{1, 0}, {0, 1}}, {&id, 1}), 0u);
    EXPECT_TRUE(refused(Error::bad_geometry));
    ShapeProxy turned = make_proxy(make_box(1, 1));
    std::swap(turned.points[0], turned.points[1]);
    for (const ShapeProxy& bad : {ShapeProxy{}, turned}) {
        EXPECT_FALSE(w->cast_shape(bad, {1, 0}));
        EXPECT_TRUE(refused(Error::bad_geometry));
        EXPECT_EQ(w->cast_shape_all(bad, {1, 0}, {&hit, 1}), 0u);
        EXPECT_TRUE(refused(Error::bad_geometry));
        EXPECT_EQ(w->overlap_shape(bad, {&id, 1}), 0u);
        EXPECT_TRUE(refused(Error::bad_geometry));
        EXPECT_EQ(w->surfaces_near(bad, 1, {}), 0u);
        EXPECT_TRUE(refused(Error::bad_geometry));
        w->overlap_shape_each(bad, {}, IdNotes::visit, &ids);
        EXPECT_TRUE(refused(Error::bad_geometry));
    }
    EXPECT_TRUE(notes.hits.empty());
    EXPECT_TRUE(ids.ids.empty());
    EXPECT_FALSE(hit);
    // No visitor: nothing to call, and no error.
    w->cast_ray_each({-9, 0}, {20, 0}, {}, nullptr, nullptr);
    w->overlap_point_each({0, 0}, {}, nullptr, nullptr);
    EXPECT_TRUE(w.errors.empty());
}

TEST(WorldQueries, ExtremePlacesAndSizesGiveNoNaN) {
    exact::Random r;
    TestWorld w;
    const float far[] = {0, 1, 1e3f, 1e6f, 9.9e6f, 1e7f};
    const auto place = [&] { return Vec2{far[r.below(6)] * (r.below(2) == 0 ? 1.0f : -1.0f), far[r.below(6)] * (r.below(2) == 0 ? 1.0f : -1.0f)}; };
    for (int i = 0; i < 40; ++i) {
        w.add(Circle{{0, 0}, std::max(1e-6f, far[r.below(6)])}, place(), {}, static_cast<BodyType>(r.below(2)));
        w.add(make_box(std::max(0.01f, far[r.below(6)]), std::max(0.01f, far[r.below(6)])), place(), {}, static_cast<BodyType>(r.below(2)));
        w.add(Segment{{-1, 0}, {std::max(1.0f, far[r.below(6)]), 0}}, place(), {}, static_cast<BodyType>(r.below(2)));
    }
    int hits = 0;
    for (int i = 0; i < cases(20000); ++i) {
        const Vec2 o = place(), d = r.below(5) == 0 ? Vec2{0, 1e-20f} : place();
        const QueryHit ray = w->cast_ray(o, d), cast = w->cast_shape(make_proxy(Circle{o, std::max(1e-3f, far[r.below(6)])}), d);
        const ClosestHit near = w->closest(o, 1e7f);
        for (const QueryHit& h : {ray, cast}) {
            ASSERT_TRUE(is_finite(h.point) && is_finite(h.normal) && is_finite(h.separation)) << i;
            ASSERT_TRUE(h.fraction >= 0 && h.fraction <= 1) << i;
            hits += h ? 1 : 0;
        }
        ASSERT_TRUE(is_finite(near.point) && is_finite(near.normal) && is_finite(near.distance)) << i;
    }
    EXPECT_GT(hits, cases(20000));
    EXPECT_TRUE(w.errors.empty());
}

}  // namespace
