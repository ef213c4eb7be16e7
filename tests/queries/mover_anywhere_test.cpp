// The character mover anywhere: the same bits after a snapshot, random worlds, bad input.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "hero.hpp"
#include "support/effort.hpp"
#include "support/hard_shapes.hpp"

namespace {

using namespace hero;

using test::cases;

// A walk over everything: stairs, a crate, a lift, jumps.
struct Course {
    TestWorld w;
    Hero hero;
    int at = 0;
    Course() : hero(w, {0, gap}) {
        add_stairs(w, 4, 0.3f, 0.5f);
        w.add_box({-3, 0.5f}, 0.5f, 0.5f);
        w.add_circle({-5, 0.5f});
        w->set_linear_velocity(w.add_box({6, 1.5f}, 1, 0.2f, {}, BodyType::kinematic), {0, 0.4f});
        hero.def = {};
    }
    void run(int steps) {
        for (int i = 0; i < steps; ++i, ++at) {
            const float walk = (at / 100) % 3 == 0 ? -4.0f : 5.0f;
            hero.step({.walk = walk, .jump = at % 70 == 0 ? 5.0f : 0});
        }
    }
};

TEST(Mover, GoesBackWithASnapshotOfTheWorldAndComesToTheSameBits) {
    Course one, two;
    one.run(150);
    two.run(150);
    std::vector<std::byte> image(max_snapshot_bytes(one.w->capacity()));
    ASSERT_GT(one.w->save(image), 0u);
    const MoverState then = one.hero.state;
    one.run(200);
    two.run(200);
    EXPECT_EQ(std::memcmp(&one.hero.state, &two.hero.state, sizeof(MoverState)), 0);
    ASSERT_TRUE(two.w->restore(std::span(image).first(one.w->snapshot_bytes())) || two.w->restore(image));
    two.hero.state = then;
    two.at = 150;
    two.run(200);
    EXPECT_EQ(one.w->hash(), two.w->hash());
    EXPECT_EQ(std::memcmp(&one.hero.state, &two.hero.state, sizeof(MoverState)), 0);
    EXPECT_LE(one.hero.worst_overlap, 0.003f);
}

// Anything may happen in these worlds: heaps of bodies of all shapes, resting, falling, turning, a mover that does what chance says.
TEST(Mover, SinksIntoNothingInRandomWorldsUnlessItSaysThatItHasNoRoom) {
    exact::Random r;
    int squeezed = 0, grounded = 0, steps = 0;
    float worst = 0;
    for (int world = 0; world < (test::slow_build ? 8 : 40); ++world) {
        TestWorld w;
        w.add_ground(0, 20);
        for (const float side : {-1.0f, 1.0f}) w.add_box({side * 13, 5}, 1, 10, {}, BodyType::static_body);
        for (int i = 0; i < 30; ++i) {
            BodyDef def;
            def.type = i % 3 == 0 ? BodyType::static_body : i % 3 == 1 ? BodyType::kinematic : BodyType::dynamic;
            def.position = {r.in(-11, 11), r.in(0.5, 9)};
            def.angle = test::hard_angle(r);
            if (def.type == BodyType::kinematic) {
                def.linear_velocity = {r.in(-0.5, 0.5), r.in(-0.3, 0.3)};
                def.angular_velocity = r.in(-1, 1);
            }
            const BodyId body = w->create_body(def);
            switch (r.below(4)) {
            case 0: w->create_shape(body, Circle{{0, 0}, r.in(0.2, 1)}); break;
            case 1: w->create_shape(body, test::hard_polygon(r, 1.2)); break;
            case 2: w->create_shape(body, Capsule{{-0.7f, 0}, {0.7f, 0}, 0.3f}); break;
            default: w->create_shape(body, make_rounded_box(0.7f, 0.3f, 0.1f));
            }
        }
        Hero hero(w, {r.in(-10, 10), 11});
        hero.def = {};
        MoverInput input;
        float surface = 0;  // m/s, the fastest that there has been
        for (int i = 0; i < 600; ++i, ++steps) {
            if (r.below(30) == 0) input.walk = r.in(-6, 6);
            input.jump = r.below(40) == 0 ? r.in(2, 9) : 0;
            hero.worst_overlap = 0;
            hero.step(input);
            ASSERT_TRUE(is_finite(hero.state.position) && is_finite(hero.state.velocity));
            for (const BodyId body : w.bodies()) {
                constexpr float reach = 2;  // m, farther than any point of a body is from its centre
                surface = std::max(surface, length(w->linear_velocity(body)) + reach * std::abs(w->angular_velocity(body)));
            }
            // By itself it walks, jumps and falls at up to 31 m/s. It takes the speed of a ground along to the next, and is told relative to that.
            ASSERT_LT(length(hero.state.velocity), 40 + 2 * surface);
            grounded += hero.state.ground ? 1 : 0;
            squeezed += hero.state.squeezed != 0 ? 1 : 0;
            if (hero.state.squeezed == 0) {
                ASSERT_LE(hero.worst_overlap, 0.005f) << "world " << world << ", step " << i;
                worst = std::max(worst, hero.worst_overlap);
            }
        }
        EXPECT_TRUE(w.errors.empty());
    }
    std::printf("%d steps, %d on the ground, %d squeezed, deepest overlap %.2g m\n", steps, grounded, squeezed, static_cast<double>(worst));
    EXPECT_GT(grounded, steps / 6);
    EXPECT_LT(squeezed, steps / 10);
}

TEST(Mover, BadInputIsRefusedAndChangesNothing) {
    TestWorld w;
    w.add_ground(0);
    const float nan = __builtin_nanf("");
    const auto refused = [&](Error error, auto&& spoil) {
        MoverDef def;
        MoverState state{.position = {0, 1}};
        MoverInput input{};
        float step = dt;
        spoil(def, state, input, step);
        const MoverState before = state;
        w->clear_error();
        EXPECT_FALSE(step_mover(*w, def, state, input, step));
        EXPECT_EQ(w->last_error(), error);
        EXPECT_EQ(std::memcmp(&before, &state, sizeof state), 0);
    };
    using D = MoverDef;
    using S = MoverState;
    using I = MoverInput;
    refused(Error::bad_time_step, [](D&, S&, I&, float& t) { t = 0; });
    refused(Error::bad_time_step, [](D&, S&, I&, float& t) { t = 9.0e-7f; });
    refused(Error::bad_time_step, [&](D&, S&, I&, float& t) { t = nan; });
    refused(Error::bad_geometry, [](D& d, S&, I&, float&) { d.capsule.radius = -1; });
    refused(Error::out_of_range, [](D& d, S&, I&, float&) { d.up = {0, 2}; });
    refused(Error::not_finite, [&](D& d, S&, I&, float&) { d.up = {nan, 0}; });
    refused(Error::out_of_range, [](D& d, S&, I&, float&) { d.max_slope = 1.6f; });
    refused(Error::out_of_range, [](D& d, S&, I&, float&) { d.step_height = -1; });
    refused(Error::out_of_range, [](D& d, S&, I&, float&) { d.mass = -1; });
    refused(Error::not_finite, [&](D& d, S&, I&, float&) { d.max_push_force = nan; });
    refused(Error::not_finite, [&](D&, S& s, I&, float&) { s.position.x = nan; });
    refused(Error::out_of_range, [](D&, S& s, I&, float&) { s.position.x = 2e7f; });
    refused(Error::out_of_range, [](D&, S& s, I&, float&) { s.velocity.y = 2e6f; });
    refused(Error::not_finite, [&](D&, S& s, I&, float&) { s.ground_point.y = nan; });
    refused(Error::not_finite, [&](D&, S&, I& i, float&) { i.walk = nan; });
    refused(Error::out_of_range, [](D&, S&, I& i, float&) { i.jump = -1; });
}

TEST(Mover, NoFiniteInputGivesANaN) {
    exact::Random r;
    const float sizes[] = {0, 1e-30f, 1e-6f, 0.3f, 1, 50, 1e3f, 1e6f, 1e7f, 1e30f};
    const auto number = [&] { return sizes[r.below(10)] * (r.below(2) == 0 ? 1.0f : -1.0f); };
    int steps = 0;
    for (int i = 0; i < cases(20000); ++i) {
        static TestWorld w;
        if (i == 0) {
            w.add_ground(0);
            w.add_box({1, 1}, 0.5f, 0.5f);
            w->set_linear_velocity(w.add_box({3, 0.2f}, 1, 0.1f, {}, BodyType::kinematic), {1, 0});
        }
        w->set_gravity({0, r.below(10) == 0 ? number() : -10});
        MoverDef def;
        MoverState state{.position = {r.in(-2, 4), r.in(-1, 2)}};
        if (r.below(3) == 0) state.position = {number(), number()};
        if (r.below(3) == 0) state.velocity = {number(), number()};
        if (r.below(2) == 0) state.ground = w->body_at(r.below(3));
        if (r.below(2) == 0) state.ground_normal = {number(), number()};
        if (r.below(2) == 0) state.ground_point = {number(), number()};
        if (r.below(4) == 0) def.capsule = {{number(), number()}, {number(), number()}, std::fabs(number())};
        if (r.below(4) == 0) def.ground_acceleration = std::fabs(number());
        if (r.below(4) == 0) def.gravity_scale = number();
        if (r.below(4) == 0) def.step_height = std::fabs(number());
        if (r.below(4) == 0) def.snap_distance = std::fabs(number());
        if (r.below(4) == 0) def.mass = std::fabs(number());
        if (r.below(4) == 0) def.max_push_force = std::fabs(number());
        steps += step_mover(*w, def, state, {.walk = number(), .jump = std::fabs(number())}, r.below(2) == 0 ? dt : 1) ? 1 : 0;
        ASSERT_TRUE(is_finite(state.position) && is_finite(state.velocity) && is_finite(state.ground_normal) && is_finite(state.ground_point)) << i;
        if (i % 50 == 0) w.step();
        ASSERT_TRUE(w.is_finite()) << i;
    }
    EXPECT_GT(steps, cases(2000));
}

TEST(Mover, WhatItStoodOnMayGo) {
    TestWorld w;
    const BodyId floor = w.add_ground(0);
    Hero hero(w, {0, gap});
    hero.step({}, 3);
    ASSERT_EQ(hero.state.ground, floor);
    w->destroy_body(floor);
    w.errors.clear();
    hero.step({}, 30);
    EXPECT_FALSE(hero.state.ground);
    EXPECT_LT(hero.state.position.y, -1);
    EXPECT_TRUE(w.errors.empty());
}

}  // namespace
