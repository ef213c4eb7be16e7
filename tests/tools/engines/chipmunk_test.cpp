// Chipmunk means the same by a scene as Islet: masses, materials, forces, filters and ids, against closed formulas. (What differs on purpose
// is in tools/engines/README.md.)
#include <gtest/gtest.h>

#include <cmath>

#include "chipmunk_fixture.hpp"
#include "scenes/catalogue.hpp"

namespace islet::test {
namespace {

// Chipmunk moves bodies by their old speed and then changes it, so n steps of length h after a start at v0 give
//     x = x0 + vx n h,   y = y0 + vy n h - g h^2 n (n - 1) / 2,   which the parabola is short of by g t h / 2.
TEST_F(Chipmunk, AProjectileFliesTheParabolaOfItsIntegrator) {
    add(dynamic({1, 2}, Circle{}));
    scene.bodies[0].def.linear_velocity = {3, 20};
    load();
    for (int n = 1; n <= 90; ++n) {
        step(1);
        ASSERT_NEAR(double(engine->body(0).position.x), 1 + 3 * n * h, 10 * rounding) << "step " << n;
        ASSERT_NEAR(double(engine->body(0).position.y), 2 + 20 * n * h - g * h * h * n * (n - 1) / 2, 10 * rounding) << "step " << n;
        ASSERT_NEAR(double(engine->body(0).linear_velocity.y), 20 - g * n * h, 10 * rounding) << "step " << n;
    }
}

TEST_F(Chipmunk, ABoxLandsRestsAndFallsAsleep) {
    add(ground());
    const std::size_t box = add(dynamic({0, 3}, make_box(0.5f, 0.25f)));
    load();
    EXPECT_EQ(engine->counts().awake_bodies, 1u);
    step(180);
    const BodyState state = engine->body(box);
    // It may sink by the overlap that is left alone, 5 mm.
    EXPECT_NEAR(state.position.y, 0.25f - 0.0025f, 0.004f);
    EXPECT_NEAR(state.position.x, 0, 1e-3f);
    EXPECT_NEAR(state.angle, 0, 1e-3f);
    EXPECT_FALSE(state.awake);
    EXPECT_EQ(engine->counts().bodies, 2u);
    EXPECT_EQ(engine->counts().shapes, 2u);
    EXPECT_EQ(engine->counts().contacts, 1u);
    EXPECT_EQ(engine->counts().awake_bodies, 0u);
    EXPECT_NEAR(engine->max_penetration(), 0.25 - double(state.position.y), 1e-4);
}

TEST_F(Chipmunk, NothingSleepsWhereTheWorldDoesNot) {
    scene.world.enable_sleep = false;
    add(ground());
    const std::size_t box = add(dynamic({0, 0.5f}, make_box(0.5f, 0.5f)));
    load();
    step(180);
    EXPECT_TRUE(engine->body(box).awake);
}

TEST_F(Chipmunk, ABodyThatNeverSleepsKeepsThoseItTouchesAwake) {
    add(ground());
    add(dynamic({0, 0.5f}, make_box(0.5f, 0.5f)));
    add(dynamic({0, 1.5f}, make_box(0.5f, 0.5f)));
    add(dynamic({5, 0.5f}, make_box(0.5f, 0.5f)));
    scene.bodies[1].def.enable_sleep = false;
    load();
    step(180);
    EXPECT_TRUE(engine->body(1).awake);
    EXPECT_TRUE(engine->body(2).awake);
    EXPECT_FALSE(engine->body(3).awake);
}

TEST_F(Chipmunk, ABodyMadeAsleepStaysUntilItIsHit) {
    scene.world.gravity = {0, 0};
    const std::size_t sleeper = add(dynamic({3, 0}, Circle{}));
    scene.bodies[sleeper].def.awake = false;
    const std::size_t hammer = add(dynamic({0, 0}, Circle{}));
    scene.bodies[hammer].def.linear_velocity = {6, 0};
    load();
    step(15);  // 1.5 m of the 2 m between them
    EXPECT_FALSE(engine->body(sleeper).awake);
    EXPECT_EQ(engine->counts().awake_bodies, 1u);
    step(15);
    // Equal masses and no restitution: both go on at half the speed.
    EXPECT_TRUE(engine->body(sleeper).awake);
    EXPECT_NEAR(engine->body(sleeper).linear_velocity.x, 3, 0.01f);
    EXPECT_NEAR(engine->body(hammer).linear_velocity.x, 3, 0.01f);
}

TEST_F(Chipmunk, MassCentreAndInertiaAreThoseOfIslet) {
    const Vec2 corners[] = {{-0.4f, -0.2f}, {0.9f, -0.3f}, {0.5f, 0.7f}, {-0.1f, 0.8f}};
    add(dynamic({1, 2}, make_polygon(compute_hull(corners), 0.1f), {.density = 3}));
    scene.bodies[0].def.angle = 0.7f;
    scene.bodies[0].shapes.push_back({Circle{{1, 0.5f}, 0.3f}, ShapeDef{.density = 5}});
    scene.bodies[0].shapes.push_back({Capsule{{0, 0}, {-1, 1}, 0.2f}, ShapeDef{.density = 2}});
    load();
    IsletEngine islet;
    islet.load(scene);
    const BodyState a = islet.body(0), b = engine->body(0);
    EXPECT_NEAR(b.mass, a.mass, 1e-5f * a.mass);
    EXPECT_NEAR(b.inertia, a.inertia, 1e-5f * a.inertia);
    EXPECT_NEAR(b.center.x, a.center.x, 1e-5f);
    EXPECT_NEAR(b.center.y, a.center.y, 1e-5f);
    EXPECT_NEAR(b.position.x, 1, 1e-5f);
    EXPECT_NEAR(b.position.y, 2, 1e-5f);
    EXPECT_NEAR(b.angle, 0.7f, 1e-5f);
}

// v + w x r: a disc 2 m from its origin that turns at 3 rad/s goes up at 6 m/s, besides what the origin does.
TEST_F(Chipmunk, VelocityFollowsTheCentreOfMassAsShapesAreAttached) {
    scene.world.gravity = {0, 0};
    add(dynamic({}, Circle{{2, 0}, 0.5f}));
    scene.bodies[0].def.linear_velocity = {1, 0};
    scene.bodies[0].def.angular_velocity = 3;
    load();
    step(60);
    EXPECT_NEAR(engine->body(0).center.x, 3, 1e-4f);
    EXPECT_NEAR(engine->body(0).center.y, 6, 1e-4f);
    EXPECT_NEAR(engine->body(0).angle, 3, 1e-4f);
}

// The geometric mean of 0.9 and 0.4 is 0.6; Chipmunk's own product would be 0.36. A slider loses mu g t.
TEST_F(Chipmunk, FrictionIsTheGeometricMean) {
    add(ground({.friction = 0.4f}));
    const std::size_t box = add(dynamic({0, 0.5f}, make_box(0.5f, 0.5f), {.friction = 0.9f}));
    scene.bodies[box].def.linear_velocity = {10, 0};
    scene.bodies[box].def.fixed_rotation = true;
    load();
    step(60);
    EXPECT_NEAR(double(engine->body(box).linear_velocity.x), 10 - 0.6 * g * 1, 0.15);  // a step's worth is 0.1 m/s
}

// A ball leaves the ground at e times the speed it came with, whatever the ground's own restitution; slower than the threshold, not at all.
TEST_F(Chipmunk, RestitutionIsTheLargerOneAboveTheThreshold) {
    add(ground());
    const std::size_t fast = add(dynamic({0, 3}, Circle{}, {.restitution = 0.8f}));
    const std::size_t slow = add(dynamic({5, 0.51f}, Circle{}, {.restitution = 0.8f}));  // lands at 0.5 m/s or less
    load();
    float last = 0, highest = 0;
    bool rebounded = false;
    for (int i = 0; i < 60; ++i) {
        step(1);
        const float now = engine->body(fast).linear_velocity.y;
        if (!rebounded && now > 0) {
            EXPECT_NEAR(now, -0.8f * last, 1e-4f);
            rebounded = true;
        }
        last = now;
        highest = std::max(highest, engine->body(slow).linear_velocity.y);
    }
    EXPECT_TRUE(rebounded);
    EXPECT_LT(highest, 1e-3f);
}

TEST_F(Chipmunk, AForceActsForOneStepAndAnImpulseAtOnce) {
    scene.world.gravity = {0, 0};
    add(dynamic({}, make_box(0.5f, 0.5f)));  // 1 kg
    add(dynamic({5, 0}, make_box(0.5f, 0.5f)));
    scene.before_step = [](Engine& e, int i) {
        if (i != 0) return;
        e.apply_force(0, {60, 0});
        e.apply_impulse(1, {0, 2});
    };
    load();
    step(3);
    EXPECT_NEAR(engine->body(0).linear_velocity.x, 1, 1e-4f);
    EXPECT_NEAR(engine->body(1).linear_velocity.y, 2, 1e-4f);
    EXPECT_NEAR(engine->body(0).angular_velocity, 0, 1e-6f);
}

// v0 / (1 + d h)^n for each kind of motion, as Islet and Box2D have it; and gravity by the body's own scale.
TEST_F(Chipmunk, DampingAndGravityScaleAreEachBodysOwn) {
    scene.world.enable_sleep = false;
    add(dynamic({}, Circle{}));
    BodyDef& def = scene.bodies[0].def;
    def.linear_velocity = {8, 0};
    def.angular_velocity = 4;
    def.linear_damping = 0.5f;
    def.angular_damping = 2;
    def.gravity_scale = 0;
    add(dynamic({5, 0}, Circle{}));
    scene.bodies[1].def.gravity_scale = -0.5f;
    load();
    step(60);
    EXPECT_NEAR(double(engine->body(0).linear_velocity.x), 8 / std::pow(1 + 0.5 * h, 60), 10 * rounding);
    EXPECT_NEAR(double(engine->body(0).linear_velocity.y), 0, rounding);
    EXPECT_NEAR(double(engine->body(0).angular_velocity), 4 / std::pow(1 + 2 * h, 60), 10 * rounding);
    EXPECT_NEAR(double(engine->body(1).linear_velocity.y), 0.5 * g * 60 * h, 10 * rounding);
}

TEST_F(Chipmunk, FixedRotationDoesNotTurn) {
    add(ground());
    const std::size_t box = add(dynamic({0, 2}, make_box(0.5f, 0.5f)));
    scene.bodies[box].def.angle = 0.3f;
    scene.bodies[box].def.angular_velocity = 5;
    scene.bodies[box].def.fixed_rotation = true;
    load();
    step(120);
    EXPECT_FLOAT_EQ(engine->body(box).angle, 0.3f);
}

// A platform that goes up at 1 m/s carries the box on it; nothing stops it.
TEST_F(Chipmunk, KinematicBodiesMoveByTheirVelocityAlone) {
    const std::size_t platform = add(body_of(BodyType::kinematic, {}, make_box(2, 0.5f)));
    scene.bodies[platform].def.linear_velocity = {0, 1};
    const std::size_t box = add(dynamic({0, 1}, make_box(0.5f, 0.5f), {.density = 100}));
    load();
    step(120);
    EXPECT_NEAR(engine->body(platform).position.y, 2, 1e-4f);
    EXPECT_NEAR(engine->body(box).position.y, 3, 0.02f);
    EXPECT_EQ(engine->body(platform).mass, 0);
}

// Every kind of shape as ground, and every kind upon it, keeps its size.
TEST_F(Chipmunk, ShapesRestAtTheirSizes) {
    const Chain chain = {{{50, 0}, {10, 0}, {0, 0}, {-10, 0}, {-50, 0}}, false};
    for (const SceneGeometry& floor : {SceneGeometry(make_offset_box(50, 1, {{0, -1}, {}})), SceneGeometry(Segment{{-50, 0}, {50, 0}}),
                                       SceneGeometry(Capsule{{-50, -1}, {50, -1}, 1}), SceneGeometry(chain)}) {
        scene.bodies.clear();
        add(fixed(floor));
        add(dynamic({-4, 0.55f}, Circle{{}, 0.5f}));
        add(dynamic({0, 0.55f}, make_box(0.5f, 0.5f)));
        add(dynamic({4, 0.55f}, make_rounded_box(0.3f, 0.3f, 0.2f)));
        add(dynamic({8, 0.55f}, Capsule{{-1, 0}, {1, 0}, 0.5f}));
        load();
        step(120);
        for (std::size_t i = 1; i < 5; ++i)
            EXPECT_NEAR(engine->body(i).position.y, 0.4975f, 0.004f) << "shape " << i << " on " << floor.index();
    }
}

TEST_F(Chipmunk, NothingCatchesOnAChainsCorners) {
    scene.world.enable_sleep = false;
    Chain chain;
    for (int x = 40; x >= -40; --x) chain.points.push_back({0.5f * static_cast<float>(x), 0});
    add(fixed(chain, {.friction = 0}));
    add(dynamic({-15, 0.5f}, Circle{}, {.friction = 0}));
    add(dynamic({-17, 0.5f}, make_box(0.5f, 0.5f), {.friction = 0}));
    for (std::size_t i : {1u, 2u}) scene.bodies[i].def.linear_velocity = {7, 0};
    load();
    step(180);
    EXPECT_EQ(engine->counts().shapes, 82u);
    for (std::size_t i : {1u, 2u}) {
        EXPECT_NEAR(engine->body(i).linear_velocity.x, 7, 0.01f);
        EXPECT_NEAR(engine->body(i).angle, 0, 0.002f);
    }
}

// Four balls over the ground: a usual one lands; one whose mask is empty, one whose category the ground does not hold and one of the ground's
// negative group fall through it.
TEST_F(Chipmunk, FiltersDecideWhoMeets) {
    ShapeDef floor;
    floor.filter = {.category = 2, .mask = 0xffffffffu & ~4u, .group = -7};
    add(ground(floor));
    ShapeDef usual, empty, unseen, family;
    empty.filter.mask = 0;
    unseen.filter.category = 4;
    family.filter.group = -7;
    float x = 0;
    for (const ShapeDef& material : {usual, empty, unseen, family}) add(dynamic({x += 3, 1}, Circle{}, material));
    load();
    step(120);
    EXPECT_NEAR(engine->body(1).position.y, 0.5f, 0.01f);
    for (std::size_t i = 2; i < 5; ++i) EXPECT_LT(engine->body(i).position.y, -5) << "ball " << i;
}

TEST_F(Chipmunk, BodiesMadeAndDestroyedLaterKeepTheirIndices) {
    for (int i = 0; i < 4; ++i) add(dynamic({3.0f * static_cast<float>(i), 0}, Circle{}));
    scene.before_step = [](Engine& e, int i) {
        if (i == 1) e.destroy_body(1);
        if (i == 2) e.create_body(dynamic({0, 50}, Circle{}));
    };
    load();
    step(4);
    EXPECT_EQ(engine->body_slots(), 5u);
    EXPECT_FALSE(engine->exists(1));
    EXPECT_TRUE(engine->exists(4));
    EXPECT_FALSE(engine->exists(5));
    EXPECT_EQ(engine->counts().bodies, 4u);
    EXPECT_NEAR(double(engine->body(4).position.y), 50 - g * h * h, 10 * rounding);  // 2 steps: n (n - 1) / 2 = 1
}

TEST_F(Chipmunk, LoadingAgainStartsAfresh) {
    add(ground());
    add(dynamic({0, 3}, make_box(0.5f, 0.5f)));
    load();
    step(100);
    load();
    EXPECT_EQ(engine->counts().bodies, 2u);
    EXPECT_EQ(engine->body_slots(), 2u);
    EXPECT_EQ(engine->body(1).position.y, 3);
    EXPECT_EQ(engine->counts().contacts, 0u);
}

TEST_F(Chipmunk, WhatItLacksIsSaid) {
    add(ground());
    add(dynamic({}, Capsule{{0, 0}, {1, 0}, 0.5f}));
    EXPECT_EQ(lacks(), "");
    ShapeDef& material = scene.bodies[1].shapes[0].def;
    material.rolling_resistance = 0.1f;
    EXPECT_EQ(lacks(), "Chipmunk 7 has no rolling resistance");
    material = {.tangent_speed = 1};
    EXPECT_EQ(lacks(), "Chipmunk 7 has no surface speed that follows an outline");
    material = {};
    material.filter.group = 1;
    EXPECT_EQ(lacks(), "Chipmunk 7 has no groups of shapes that always collide");
    material = {};
    scene.bodies[1].def.bullet = true;
    EXPECT_EQ(lacks(), "Chipmunk 7 has no continuous collision, without which bullets pass through things");
    scene.bodies[1].def.bullet = false;
    scene.bodies[1].def.sleep_threshold = 0.1f;  // of all that may sleep, so of the space
    EXPECT_EQ(lacks(), "");
    add(dynamic({5, 0}, Circle{}));
    EXPECT_EQ(lacks(), "Chipmunk 7 has no sleep thresholds of single bodies");
    scene.world.enable_sleep = false;
    EXPECT_EQ(lacks(), "");
}

// Every scene that it says it can build loads and takes steps, with as many bodies and shapes as in Islet.
TEST_F(Chipmunk, BuildsEveryScene) {
    for (const SceneInfo& info : catalogue()) {
        scene = info.make();
        if (!lacks().empty()) continue;
        load();
        IsletEngine islet;
        islet.load(scene);
        EXPECT_EQ(engine->counts().bodies, islet.counts().bodies) << info.name;
        EXPECT_EQ(engine->counts().shapes, islet.counts().shapes) << info.name;
        for (std::size_t i = 0; i < engine->body_slots(); ++i) {
            ASSERT_NEAR(engine->body(i).mass, islet.body(i).mass, 1e-4f * islet.body(i).mass) << info.name << ", body " << i;
        }
        for (int i = 0; i < 3; ++i) engine->advance(scene, i, scene.dt);
        EXPECT_TRUE(std::isfinite(engine->max_penetration())) << info.name;
    }
}

}  // namespace
}  // namespace islet::test
