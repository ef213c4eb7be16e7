// Hit events: which contacts tell of a blow, how hard it says it was, and when.
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

#include "support/random.hpp"
#include "support/test_world.hpp"

namespace islet::test {
namespace {

// It falls h metres: v = sqrt(2 g h). The engine's symplectic Euler integration makes that at most g dt faster or slower.
TEST(Hits, ABallThatFallsHitsOnceAsFastAsItFell) {
    for (const float height : {1.0f, 5.0f, 20.0f}) {
        for (const float restitution : {0.0f, 0.8f}) {
            TestWorld w;
            const ShapeId ground = w.shape_of(w.add_ground());
            const ShapeId ball = w.shape_of(w.add_circle({3, height + 0.5f}, 0.5f, {.restitution = restitution, .hit_events = true}));
            std::vector<HitEvent> hits;
            float way = 0;
            for (int i = 0; i < 600 && hits.empty(); ++i) {
                w.step();
                hits.assign(w->hit_events().begin(), w->hit_events().end());
                way = w->position(w->body(ball)).y;
            }
            ASSERT_EQ(hits.size(), 1u) << height;
            const HitEvent& h = hits[0];
            EXPECT_EQ(h.shape_a, ground) << "polygons come before circles";
            EXPECT_EQ(h.shape_b, ball);
            EXPECT_NEAR(h.speed, std::sqrt(2 * 10 * height), 10.0f / 60);
            EXPECT_NEAR(h.normal.y, 1, 1e-6);
            EXPECT_NEAR(h.point.x, 3, 1e-3);
            EXPECT_NEAR(h.point.y, 0, 0.5f * std::abs(way - 0.5f) + 0.01f) << "midway between the surfaces";
            if (restitution > 0) continue;
            for (int i = 0; i < 60; ++i) {
                w.step();
                EXPECT_TRUE(w->hit_events().empty()) << "it lies";
            }
        }
    }
}

// Two balls of speeds u and v along a line meet at |u - v|, whatever their masses.
TEST(Hits, TheSpeedIsThatOfTheTwoTogether) {
    TestWorld w(roomy, {.gravity = {0, 0}, .hit_threshold = 0.5f});
    const BodyId a = w.add_circle({-1, 0}, 0.5f, {.density = 10, .hit_events = true}), b = w.add_circle({1, 0}, 0.5f, {});
    w->set_linear_velocity(a, {3, 0});
    w->set_linear_velocity(b, {-4, 0});
    std::vector<float> speeds;
    for (int i = 0; i < 60; ++i) {
        w.step();
        for (const HitEvent& h : w->hit_events()) speeds.push_back(h.speed);
    }
    ASSERT_EQ(speeds.size(), 1u) << "one of the two shapes need ask";
    EXPECT_NEAR(speeds[0], 7, 1e-3);
}

TEST(Hits, SlowerThanTheThresholdTellsNothingAndItCanBeSet) {
    for (const float threshold : {1.9f, 2.1f}) {
        TestWorld w(roomy, {.gravity = {0, 0}});
        w->set_hit_threshold(threshold);
        EXPECT_EQ(w->hit_threshold(), threshold);
        const BodyId a = w.add_circle({-1, 0}, 0.5f, {.hit_events = true});
        w.add_circle({1, 0});
        w->set_linear_velocity(a, {2, 0});
        std::size_t hits = 0;
        for (int i = 0; i < 60; ++i) {
            w.step();
            hits += w->hit_events().size();
        }
        EXPECT_EQ(hits, threshold < 2 ? 1u : 0u);
    }
}

// A contact is made before the surfaces meet. In steps of 1/240 s a ball of 1.5 m/s has one for two steps before the one in which it arrives.
TEST(Hits, NothingIsToldBeforeThePush) {
    TestWorld w(roomy, {.gravity = {0, 0}});
    const BodyId a = w.add_circle({-1.1f, 0}, 0.5f, {.hit_events = true}), b = w.add_circle({0, 0});
    w->set_linear_velocity(a, {1.5f, 0});
    int touched = 0, hits = 0;
    for (int i = 0; i < 60; ++i) {
        const bool apart = w->linear_velocity(b) == Vec2{};
        w.step(1, 1.0f / 240);
        const bool still_apart = w->linear_velocity(b) == Vec2{};
        touched += apart && !w.contacts().empty();
        hits += static_cast<int>(w->hit_events().size());
        EXPECT_EQ(w->hit_events().size(), apart && !still_apart ? 1u : 0u) << i;
    }
    EXPECT_GE(touched, 2);
    EXPECT_EQ(hits, 1);
}

TEST(Hits, OnlyShapesThatAskTellAndAskingCanChange) {
    const auto count = [](bool asks, bool switched) {
        TestWorld w;
        const ShapeId ground = w.shape_of(w.add_ground(0, 100, {.hit_events = asks}));
        w.add_box({0, 3});
        w.step();
        if (switched) w->enable_hit_events(ground, !asks);
        EXPECT_EQ(w->hit_events_enabled(ground), asks != switched);
        std::size_t hits = 0;
        for (int i = 0; i < 120; ++i) {
            w.step();
            hits += w->hit_events().size();
        }
        EXPECT_EQ(w->validate(), nullptr);
        return hits;
    };
    EXPECT_EQ(count(false, false), 0u);
    EXPECT_GE(count(true, false), 1u);
    EXPECT_GE(count(false, true), 1u);
    EXPECT_EQ(count(true, true), 0u);
}

TEST(Hits, ComeInTheOrderOfTheirContactsAndThoseWithoutRoomAreCounted) {
    constexpr std::uint32_t balls = 30;
    for (const std::uint32_t room : {0u, 20u, 30u}) {
        TestWorld w(Capacity{.bodies = 40, .shapes = 40, .contacts = 80, .hits = room}, {.gravity = {0, 0}});
        w.add_ground();
        std::vector<BodyId> all;
        for (std::uint32_t i = 0; i < balls; ++i) all.push_back(w.add_circle({2.0f * static_cast<float>(i) - 30, 0.6f}, 0.5f, {.hit_events = true}));
        for (const BodyId ball : all) w->set_linear_velocity(ball, {0, -30});
        w.step();
        const std::uint32_t fit = room == 0 ? 10 : room;
        ASSERT_EQ(w->hit_events().size(), std::min(fit, balls));
        EXPECT_EQ(w->report().dropped_hits, balls - std::min(fit, balls));
        EXPECT_EQ(w->last_error(), fit < balls ? Error::hits_full : Error::none);
        const std::vector<ContactInfo> contacts = w.contacts();
        std::size_t at = 0;
        for (const HitEvent& h : w->hit_events()) {
            while (at < contacts.size() && contacts[at].shape_b != h.shape_b) ++at;
            EXPECT_LT(at, contacts.size()) << "out of order";
        }
        w.step();
        EXPECT_EQ(w->report().dropped_hits, 0u);
    }
}

// Asking changes no bit of what happens; and lanes and workers none of what is told.
TEST(Hits, TellTheSameInAnyLanesAndWithAnyWorkersAndChangeNothing) {
    const auto backwards = [](void*, std::uint32_t count, void (*task)(void*, std::uint32_t), void* data) {
        for (std::uint32_t i = count; i-- > 0;) task(data, i);
    };
    struct Run {
        std::vector<float> told;
        std::vector<Vec2> places;
    };
    const auto run = [&](bool asks, std::uint32_t lanes, std::uint32_t workers, SweepOrder order) {
        WorldDef def{.lanes = lanes};
        def.solver.sweep_order = order;
        if (workers > 1) def.tasks = {backwards, nullptr, workers};
        TestWorld w(roomy, def);
        w.add_ground();
        Random random(4);
        for (int i = 0; i < 120; ++i) {
            const Vec2 at = {random.between(-4, 4), 1 + 0.4f * static_cast<float>(i)};
            const ShapeDef shape{.restitution = i % 5 == 0 ? 0.5f : 0.0f, .hit_events = asks && i % 3 == 0};
            i % 2 == 0 ? w.add_circle(at, 0.3f, shape) : w.add_box(at, 0.3f, 0.2f, shape);
        }
        Run r;
        for (int i = 0; i < 240; ++i) {
            w.step();
            for (const HitEvent& h : w->hit_events())
                r.told.insert(r.told.end(), {static_cast<float>(i), static_cast<float>(h.shape_a.index1), static_cast<float>(h.shape_b.index1), h.point.x,
                                             h.point.y, h.normal.x, h.normal.y, h.speed});
        }
        for (const BodyId body : w.bodies()) r.places.push_back(w->position(body));
        EXPECT_EQ(w->report().dropped_hits, 0u);
        return r;
    };
    for (const SweepOrder order : {SweepOrder::colored, SweepOrder::upward}) {
        const Run first = run(true, 1, 1, order);
        EXPECT_GT(first.told.size(), 8u * 60);
        for (const std::uint32_t lanes : {4u, 8u}) EXPECT_EQ(run(true, lanes, 1, order).told, first.told) << lanes;
        for (const std::uint32_t workers : {2u, 4u}) EXPECT_EQ(run(true, 0, workers, order).told, first.told) << workers;
        EXPECT_EQ(run(false, 1, 1, order).places, first.places);
    }
}

}  // namespace
}  // namespace islet::test
