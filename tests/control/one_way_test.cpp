// One-way platforms: what comes from below passes, what came from above is held, fast bodies and movers too.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "islet/mover.hpp"
#include "support/random.hpp"
#include "support/sanitized.hpp"
#include "support/test_world.hpp"

namespace islet::test {
namespace {

constexpr float ledge_top = 5, floor_depth = 20;  // m

/// Ten thousand are for the optimised build.
constexpr std::uint64_t tries = sanitized ? 1000 : 10000;

enum class Thrown { box, ball, capsule, triangle };

BodyId add_thrown(TestWorld& world, Thrown kind, const BodyDef& def, const ShapeDef& shape = {}) {
    const Vec2 corners[] = {{-0.4f, -0.3f}, {0.4f, -0.3f}, {0, 0.5f}};
    switch (kind) {
    case Thrown::box: return world.add(make_box(0.5f, 0.3f), def, shape);
    case Thrown::ball: return world.add(Circle{{}, 0.3f}, def, shape);
    case Thrown::capsule: return world.add(Capsule{{-0.3f, 0}, {0.3f, 0}, 0.2f}, def, shape);
    case Thrown::triangle: return world.add(make_polygon(compute_hull(corners)), def, shape);
    }
    return {};
}

/// A world with a floor 20 m below a ledge (if there is one) of 2 cm to 0.6 m.
struct Site {
    TestWorld world;
    BodyId ground;
    explicit Site(float thickness, const ShapeDef& ledge) : world({.bodies = 8, .shapes = 8, .contacts = 32}, awake()) {
        ground = world->create_body({});
        world->create_shape(ground, make_offset_box(500, 1, {{0, ledge_top - floor_depth - 1}, {}}));
        if (thickness > 0) world->create_shape(ground, make_offset_box(500, 0.5f * thickness, {{0, ledge_top - 0.5f * thickness}, {}}), ledge);
    }
    static WorldDef awake() {
        WorldDef def;
        def.enable_sleep = false;
        return def;
    }
    double lowest(BodyId body) const { return double(world->aabb(world.shape_of(body)).lower.y); }
};

ShapeDef upwards() {
    ShapeDef def;
    def.one_way = {0, 1};
    return def;
}

TEST(OneWay, OfTenThousandThrowsThoseThatClearTheLedgeStandOnItAndTheOthersFallBack) {
    // What it should be is told by the same throw without the ledge: it is held if all of the body was above the ledge's top at the end of any step. What
    // misses that by the slop (5 mm, by which what rests on something may be sunk into it) or less may be held too.
    constexpr double slop = 0.005;
    constexpr double rounding = 1e-4;  // m; the body moves alike in both worlds, but the engine computes the height in another frame: 20 roundings of 40 m
    int wrong = 0, held = 0, lifted = 0;
    double least_lift = 0;
    for (std::uint64_t seed = 0; seed < tries; ++seed) {
        Random random(seed);
        const float dt = random.one_in(2) ? 1.0f / 60 : 1.0f / 30;
        const auto kind = static_cast<Thrown>(random.below(4));
        BodyDef def;
        def.type = BodyType::dynamic;
        def.position = {0, ledge_top - random.between(1, 4)};
        def.linear_velocity = {random.between(-5, 5), random.one_in(4) ? random.between(15, 40) : random.between(3, 14)};
        def.angle = random.between(-pi, pi);
        def.angular_velocity = random.one_in(2) ? 0 : random.between(-10, 10);
        const float thickness = random.one_in(2) ? 0.02f : random.between(0.05f, 0.6f);
        const int steps = static_cast<int>((2 * def.linear_velocity.y / 10 + 3) / dt);
        Site without(0, {});
        const BodyId free = add_thrown(without.world, kind, def);
        double highest = -1e9;
        for (int i = 0; i < steps; ++i) {
            without.world.step(1, dt);
            highest = std::fmax(highest, without.lowest(free) - double(ledge_top));
        }
        if (highest > -slop - rounding && highest < rounding) continue;
        Site with(thickness, upwards());
        const BodyId body = add_thrown(with.world, kind, def);
        with.world.step(steps, dt);
        const bool stands = with.world->position(body).y > ledge_top;
        if (stands) ++held;
        if (stands && highest < 0) ++lifted, least_lift = std::fmin(least_lift, highest);
        if (stands != (highest > 0)) ++wrong;
    }
    EXPECT_EQ(wrong, 0) << lifted << " lifted, by up to " << -least_lift << " m";
    EXPECT_GT(held, int(tries * 3 / 10));
    EXPECT_LT(held, int(tries * 9 / 10));
}

TEST(OneWay, OfTenThousandFallsAtUpTo200MetresASecondNonePasses) {
    int through = 0;
    for (std::uint64_t seed = 0; seed < tries; ++seed) {
        Random random(seed);
        const float dt = random.one_in(2) ? 1.0f / 60 : 1.0f / 30;
        BodyDef def;
        def.type = BodyType::dynamic;
        def.position = {0, ledge_top + random.between(1, 12)};
        def.linear_velocity = {random.between(-20, 20), -random.between(0, 200)};
        def.angle = random.between(-pi, pi);
        def.angular_velocity = random.one_in(2) ? 0 : random.between(-20, 20);
        Site site(random.one_in(2) ? 0.02f : random.between(0.05f, 0.6f), upwards());
        const BodyId body = add_thrown(site.world, static_cast<Thrown>(random.below(4)), def);
        site.world.step(static_cast<int>(2.5f / dt), dt);
        if (site.world->position(body).y < ledge_top) ++through;
    }
    EXPECT_EQ(through, 0);
}

TEST(OneWay, AFastBodyIsHeldByAPlatformThatThePreSolveHookAllows) {
    for (const bool allow : {true, false}) {
        for (int phase = 0; phase < 16; ++phase) {
            ShapeDef def;
            def.pre_solve = true;
            Site site(0.02f, def);
            struct Context { bool allow; int asked; } context{allow, 0};
            site.world->set_hooks({.pre_solve = [](PreSolve& c, void* p) { auto& x = *static_cast<Context*>(p); ++x.asked; c.enabled = x.allow; }, .context = &context});
            BodyDef body = {.type = BodyType::dynamic, .position = {0, ledge_top + 8 + 0.2f * static_cast<float>(phase)}, .linear_velocity = {0, -150}};
            const BodyId ball = site.world.add(Circle{{}, 0.1f}, body);
            site.world.step(60);
            EXPECT_GT(context.asked, 0);
            EXPECT_EQ(site.lowest(ball) > double(ledge_top) - 0.05, allow) << "phase " << phase;
        }
    }
}

TEST(OneWay, OfThreeThousandFastAndSpinningBodiesNonePassesAPlateThatThePreSolveHookAllows) {
    int through = 0;
    for (std::uint64_t seed = 0; seed < 3000; ++seed) {
        Random random(seed);
        ShapeDef asks;
        asks.pre_solve = true;
        Site site(0.02f, asks);
        site.world->set_hooks({.pre_solve = [](PreSolve& c, void*) { c.enabled = true; }});
        BodyDef def;
        def.type = BodyType::dynamic;
        def.position = {0, ledge_top + random.between(1, 12)};
        def.angle = random.between(-pi, pi);
        def.linear_velocity = {random.between(-20, 20), -random.between(0, 200)};
        def.angular_velocity = random.between(-20, 20);
        const BodyId body = add_thrown(site.world, seed % 2 != 0 ? Thrown::box : Thrown::capsule, def);
        site.world.step(60, 1.0f / 30);
        if (site.world->position(body).y < ledge_top) ++through;
    }
    EXPECT_EQ(through, 0);
}

TEST(OneWay, WhatStandsOnItDropsThroughWhenTheHookSaysNoOnce) {
    ShapeDef def = upwards();
    def.pre_solve = true;
    Site site(0.2f, def);
    bool drop = false;
    site.world->set_hooks({.pre_solve = [](PreSolve& c, void* p) { if (*static_cast<bool*>(p)) c.enabled = false; }, .context = &drop});
    BodyDef at = {.type = BodyType::dynamic, .position = {0, ledge_top + 1}};
    const BodyId box = add_thrown(site.world, Thrown::box, at);
    site.world.step(120);
    EXPECT_NEAR(site.lowest(box), double(ledge_top), 0.01);
    drop = true;
    site.world.step();
    drop = false;
    site.world.step(20);
    EXPECT_LT(site.world->position(box).y, ledge_top);
    site.world.step(240);
    EXPECT_NEAR(site.lowest(box), double(ledge_top - floor_depth), 0.01);
    EXPECT_EQ(site.world->validate(), nullptr);
}

TEST(OneWay, ItHoldsOnTheSideOfItsDirectionHoweverItsBodyIsTurned) {
    // Gravity goes against the direction: the platform, of any tilt, holds from its side and lets pass from the other.
    for (int turn = 0; turn < 12; ++turn) {
        for (const bool from_front : {true, false}) {
            const float angle = 0.5f * static_cast<float>(turn);
            const Vec2 up = rotate(make_rot(angle), {0, 1});
            WorldDef def;
            def.gravity = -10.0f * up;
            TestWorld world(roomy, def);
            BodyDef platform;
            platform.angle = angle;
            world.add(make_box(5, 0.1f), platform, upwards());
            BodyDef body;
            body.type = BodyType::dynamic;
            body.position = (from_front ? 2.0f : -2.0f) * up;
            const BodyId ball = world.add(Circle{{}, 0.3f}, body);
            if (!from_front) world->set_linear_velocity(ball, 12.0f * up);  // 7 m up, and back onto it
            world.step(300);
            EXPECT_NEAR(dot(world->position(ball), up), 0.4f, 0.01f) << "turn " << turn;
        }
    }
}

TEST(OneWay, DirectionIsKeptThroughSnapshotsAndSetters) {
    Site site(0.2f, upwards());
    std::vector<ShapeId> ids(2);
    site.world->shapes(site.ground, ids);
    EXPECT_EQ(site.world->one_way(ids[0]), (Vec2{0, 1}));
    EXPECT_EQ(site.world->one_way(ids[1]), Vec2{});
    site.world->set_one_way(ids[1], {3, 4});
    EXPECT_NEAR(site.world->one_way(ids[1]).x, 0.6f, 1e-3f);
    EXPECT_NEAR(site.world->one_way(ids[1]).y, 0.8f, 1e-3f);
    const std::uint64_t hash = site.world->hash();
    std::vector<std::byte> image(site.world->snapshot_bytes());
    ASSERT_GT(site.world->save(image), 0u);
    site.world->set_one_way(ids[1], {});
    EXPECT_EQ(site.world->one_way(ids[1]), Vec2{});
    EXPECT_NE(site.world->hash(), hash);
    ASSERT_TRUE(site.world->load(image));
    EXPECT_EQ(site.world->hash(), hash);
    EXPECT_EQ(site.world->validate(), nullptr);
    site.world->set_one_way(ids[1], {std::nanf(""), 0});
    EXPECT_EQ(site.world->last_error(), Error::not_finite);
}

TEST(OneWay, AMoverJumpsThroughItFromBelowAndStandsOnIt) {
    for (int start = 0; start < 10; ++start) {
        for (const float jump : {4.0f, 9.0f}) {
            TestWorld world;
            world.add_ground(0, 100);
            const float top = 2 + 0.02f * static_cast<float>(start);
            world.add(make_box(5, 0.1f), Vec2{0, top - 0.1f}, upwards(), BodyType::static_body);
            MoverDef def;
            MoverState state;
            state.position = {0, 0.02f};
            const auto go = [&](int steps, float up) {
                for (int i = 0; i < steps; ++i) {
                    ASSERT_TRUE(step_mover(*world, def, state, {.jump = i == 0 ? up : 0.0f}, 1.0f / 60));
                    world.step();
                }
            };
            go(30, 0);
            go(180, jump);
            const bool clears = jump * jump / 20 > top;  // 0.8 m, 4.05 m
            EXPECT_NEAR(state.position.y, clears ? top + 0.01f : 0.01f, 0.02f) << "jump " << jump << ", top " << top;
            EXPECT_TRUE(state.ground);
        }
    }
}

}  // namespace
}  // namespace islet::test
