// Worlds as they are: crates that came to rest and so are turned by 1e-10 to 1e-4 rad, walls turned by quarters, ramps given by their corners, bodies far from
// their world's origin. Queries and movers among them, judged in long double.
#include <gtest/gtest.h>

#include <cmath>

#include "hero.hpp"
#include "support/effort.hpp"
#include "support/hard_shapes.hpp"
#include "support/long_geometry.hpp"

namespace {

using namespace islet;
using long_exact::Point;
using long_exact::Real;
using long_exact::Rounded;
using test::cases;
using test::TestWorld;

// As a mover asks: the cast ends on what it meets, and was nowhere in it before. `tolerance` in metres.
void expect_first_contact(const ShapeProxy& moving, Vec2 way, const ShapeProxy& target, const Transform& pose, const QueryHit& hit, Real tolerance, int& hits) {
    const Rounded w = long_exact::difference(long_exact::solid_of(moving), long_exact::solid_of(target, pose));
    const Point d = long_exact::of(way);
    if (!hit) {
        ASSERT_GE(long_exact::least_on_way(w, {}, d), -tolerance) << "missed";
        return;
    }
    ++hits;
    ASSERT_LE(std::fabs(long_exact::signed_distance(w, Real(hit.fraction) * d)), tolerance) << "ends elsewhere, at " << hit.fraction;
    ASSERT_GE(long_exact::least_on_way(w, {}, Real(hit.fraction) * d), -tolerance) << "went through before " << hit.fraction;
}

TEST(HardWorlds, ACastOfACapsuleMeetsCratesThatCameToRestByThemselves) {
    exact::Random r;
    int hits = 0;
    for (int k = 0; k < cases(200); ++k) {
        TestWorld w;
        w.add_ground(0, 100, {.filter = {2, ~0u, 0}});
        std::vector<BodyId> crates;
        for (int i = 0; i < 16; ++i) {
            BodyDef def{.type = BodyType::dynamic, .position = {float(i) * 6 - 48, 0.5f + r.in(0.1, 0.6)}};
            def.angle = r.in(-0.1, 0.1);
            crates.push_back(w.add(make_box(0.5f, 0.5f), def));
        }
        w.step(240);
        for (int i = 0; i < 16; ++i) {
            const Transform pose = w->transform(crates[size_t(i)]);
            const Vec2 p = pose.p, way = i % 2 ? Vec2{r.in(1.5, 3), r.in(-0.2, 0.2)} : Vec2{r.in(1, 3), r.in(-0.6, 0.6)};
            const ShapeProxy hero = make_proxy(Capsule{{p.x - 1.6f, 0.35f}, {p.x - 1.6f, 1.6f}, 0.3f});
            expect_first_contact(hero, way, make_proxy(make_box(0.5f, 0.5f)), pose, w->cast_shape(hero, way, {.mask = 1}), 2e-5L, hits);
            if (HasFatalFailure()) return;
        }
    }
    EXPECT_GT(hits, cases(2000));
}

TEST(HardWorlds, ACastOfACapsuleMeetsWallsTurnedByQuarters) {
    exact::Random r;
    int hits = 0;
    for (const float turn : {0.0f, pi / 2, pi, -pi / 2, 2 * pi, 1e-6f}) {
        const bool upright = std::fabs(std::sin(turn)) > 0.5f;
        const Polygon wall = upright ? make_box(1.5f, 0.05f) : make_box(0.05f, 1.5f);
        for (int k = 0; k < cases(10000); ++k) {
            TestWorld w(Capacity{.bodies = 4, .shapes = 4, .contacts = 4});
            BodyDef def{.position = {3, r.in(-0.9, 2.2)}, .angle = turn};
            const BodyId body = w.add(wall, def);
            const float y = r.in(-0.5, 0.5);
            const Vec2 way{r.in(3, 6), r.in(-1, 1)};
            const ShapeProxy hero = make_proxy(Capsule{{0, y + 0.3f}, {0, y + 1.5f}, 0.3f});
            expect_first_contact(hero, way, make_proxy(wall), w->transform(body), w->cast_shape(hero, way), 2e-5L, hits);
            if (HasFatalFailure()) FAIL() << "turned by " << turn << ", case " << k;
        }
    }
    EXPECT_GT(hits, cases(30000));
}

TEST(HardWorlds, NoMoverWalksThroughAThinWallHoweverItIsTurned) {
    exact::Random r;
    for (const float turn : {0.0f, pi / 2, pi, -pi / 2, 2 * pi, -3 * pi / 2, 1e-6f, pi / 2 - 1e-5f}) {
        const bool upright = std::fabs(std::sin(turn)) > 0.5f;
        for (int k = 0; k < cases(1500); ++k) {
            TestWorld w(Capacity{.bodies = 8, .shapes = 8, .contacts = 16});
            w.add(make_offset_box(50, 0.5f, {{0, -0.5f}, {}}), Vec2{}, {}, BodyType::static_body);
            BodyDef def{.position = {3, 1.5f}, .angle = turn};
            w.add(upright ? make_box(1.5f, 0.02f) : make_box(0.02f, 1.5f), def);
            MoverState state{.position = {r.in(0, 1), r.in(0, 0.5)}};
            const float speed = r.in(5, 40);
            for (int i = 0; i < 90 && state.position.y < 2.9f; ++i) {
                w.step();
                const MoverInput input{.walk = speed, .jump = i % 10 == 0 ? r.in(0, 4) : 0};
                ASSERT_TRUE(step_mover(*w, {.ground_acceleration = 1000, .air_acceleration = 1000}, state, input, 1.0f / 60));
            }
            ASSERT_FALSE(state.position.x > 3.3f && state.position.y < 2.5f) << "turned by " << turn << ", walk " << k << " at " << speed << " m/s";
        }
    }
}

TEST(HardWorlds, WhatStandsOnALongRampIsFound) {
    exact::Random r;
    for (const float half : {10.0f, 100.0f, 500.0f, 5000.0f}) {
        SCOPED_TRACE(half);
        const float rounding = 2e-6f * half;
        for (int i = 0; i < cases(5000); ++i) {
            TestWorld w(Capacity{.bodies = 4, .shapes = 4, .contacts = 4});
            const Rot q = make_rot(r.in(-1.5, 1.5));
            const Vec2 center{r.in(-3, 3), r.in(-3, 3)};
            w.add(make_offset_box(half, 1, {{}, q}), center, {}, BodyType::static_body);
            const Vec2 along = rotate(q, {1, 0}), up = rotate(q, {0, 1});
            const float x = r.in(-0.9, 0.9) * half, hx = r.in(0.2, 1), hy = r.in(0.2, 1);
            const auto crate = [&](float gap) { return make_proxy(make_offset_box(hx, hy, {center + x * along + (1 + hy + gap) * up, q})); };
            ShapeId found[2];
            Surface near[2];
            ASSERT_EQ(w->overlap_shape(crate(-0.3f), found), 1u) << i;
            ASSERT_EQ(w->overlap_shape(crate(-0.005f - rounding), found), 1u) << i;
            ASSERT_EQ(w->overlap_shape(crate(0.005f + rounding), found), 0u) << i;
            ASSERT_EQ(w->surfaces_near(crate(0.05f), 0.1f + rounding, near), 1u) << i;
            ASSERT_NEAR(near[0].separation, 0.05f, 1e-5f + rounding) << i;
            const QueryHit hit = w->cast_shape(crate(1), -2 * up);
            ASSERT_TRUE(hit) << i;
            ASSERT_NEAR(hit.fraction, 0.5f, 1e-5f + rounding) << i;
            ASSERT_GT(dot(hit.normal, up), 0.999f) << i;
        }
    }
}

}  // namespace
