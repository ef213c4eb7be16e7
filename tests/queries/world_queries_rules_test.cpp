// What the queries of a world depend on and what they do not, and what they refuse.
#include <gtest/gtest.h>

#include <thread>

#include "random_worlds.hpp"

namespace {

using namespace random_worlds;
using test::cases;

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
