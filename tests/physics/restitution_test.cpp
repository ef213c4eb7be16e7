// Bouncing: heights, speeds after a collision of two bodies, the threshold and the mixing rule.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string_view>
#include <tuple>
#include <vector>

#include "measure.hpp"

namespace islet::test {
namespace {

ShapeDef bouncy(float e, float density = 1) {
    ShapeDef def;
    def.restitution = e;
    def.friction = 0;
    def.density = density;
    return def;
}

// Highest point of the ball's lower side after its first bounce.
double rebound_height(float e, float drop, float dt) {
    TestWorld world(roomy, sleepless());
    world.add_ground(0, 10, bouncy(0));
    const BodyId ball = world.add_circle({0, drop + 0.5f}, 0.5f, bouncy(e));
    double highest = 0;
    bool rising = false;
    for (float t = 0; t < 3.5f; t += dt) {
        world.step(1, dt);
        const double v = double(world->linear_velocity(ball).y);
        if (rising && v <= 0) break;
        rising |= v > 0;
        if (rising) highest = std::fmax(highest, double(world->position(ball).y) - 0.5);
    }
    return highest;
}

TEST(Restitution, ABallReboundsToTheSquareOfEOfItsHeight) {
    // v = sqrt(2 g h) at the ground, e v after it, so it rises to e^2 h. Velocities and heights belong to moments half a substep of dt / 4 apart, so e v may
    // be short by (1 - e) g dt / 8; twice that is allowed. Surfaces meet as soon as they come within the speculative 0.02 m.
    for (const float dt : {1.0f / 60, 1.0f / 240, 1.0f / 960}) {
        for (const float e : {0.3f, 0.5f, 0.7f, 0.9f, 1.0f}) {
            const double v = std::sqrt(2 * g * 5), least = double(e) * v - (1 - double(e)) * g * double(dt) / 4;
            const double height = rebound_height(e, 5, dt);
            EXPECT_GE(height, least * least / (2 * g) - 0.02) << "e " << e << " dt " << dt;
            EXPECT_LE(height, double(e) * double(e) * 5 + 0.02) << "e " << e << " dt " << dt;
        }
    }
}

enum class Solid { ball, box, octagon };

BodyId add_solid(TestWorld& world, Solid solid, const BodyDef& body, const ShapeDef& shape) {
    if (solid == Solid::ball) return world.add(Circle{{0, 0}, 0.5f}, body, shape);
    if (solid == Solid::box) return world.add(make_box(0.5f, 0.5f), body, shape);
    Vec2 corners[8];
    for (int i = 0; i < 8; ++i) corners[i] = rotate(make_rot(0.25f * pi * (static_cast<float>(i) + 0.5f)), {0.5f, 0});
    return world.add(make_polygon(compute_hull(corners)), body, shape);
}

// J/kg, of a body that does not turn. A velocity belongs to the middle of the substep of h that led to it, so g h / 2 is taken from it.
double bounce_energy(const TestWorld& world, BodyId body, double h) {
    const double v = double(world->linear_velocity(body).y) - g * h / 2;
    return v * v / 2 + g * double(world->position(body).y);
}

// What bounces elastically between a floor and a ceiling goes on for ever. A bounce is exact to the second order in the time step: its speed v may be off by
// (g dt)^2 / (2 v), and the energy by (g dt)^2 / 2. And it may end up to 0.02 m away from the surface, within which surfaces meet.
TEST(Restitution, WhatBouncesElasticallyKeepsItsEnergy) {
    for (const Solid solid : {Solid::ball, Solid::box, Solid::octagon}) {
        for (const float dt : {1.0f / 30, 1.0f / 60, 1.0f / 120}) {
            for (const std::uint32_t substeps : {1u, 2u, 4u, 8u}) {
                for (const float up : {0.0f, 9.0f}) {  // the second reaches the ceiling
                    WorldDef def = sleepless();
                    def.solver.substeps = substeps;
                    TestWorld world(roomy, def);
                    world.add_ground(0, 10, bouncy(0));
                    world.add_box({0, 6}, 10, 1, bouncy(0), BodyType::static_body);
                    BodyDef body = dynamic_at({0, 3});
                    body.linear_velocity = {0, up};
                    body.fixed_rotation = true;
                    const BodyId it = add_solid(world, solid, body, bouncy(1));
                    const double h = double(dt) / substeps, before = bounce_energy(world, it, h), step = g * double(dt);
                    int bounces = 0;
                    for (int i = 0; i < static_cast<int>(20 / dt); ++i) {
                        const float v = world->linear_velocity(it).y;
                        world.step(1, dt);
                        if (std::fabs(world->linear_velocity(it).y - v) > 2) ++bounces;
                    }
                    ASSERT_GT(bounces, 12);
                    EXPECT_NEAR(bounce_energy(world, it, h), before, bounces * step * step / 2 + 0.02 * g)
                        << "solid " << int(solid) << ", dt " << dt << ", substeps " << substeps << ", up " << up << ", bounces " << bounces;
                }
            }
        }
    }
}

TEST(Restitution, WithoutItNothingBounces) { EXPECT_LT(rebound_height(0, 5, step_time), 1e-3); }

struct Speeds {
    double a, b;
};

// Two balls of masses 1 and m at speeds 3 and -1 m/s meet head on.
Speeds collide_balls(float e, float m) {
    TestWorld world(roomy, weightless());
    const float density = 1 / (pi * 0.25f);
    BodyDef def = dynamic_at({-2, 0});
    def.linear_velocity = {3, 0};
    const BodyId a = world.add(Circle{}, def, bouncy(e, density));
    def.position = {2, 0};
    def.linear_velocity = {-1, 0};
    const BodyId b = world.add(Circle{}, def, bouncy(e, m * density));
    world.step(120);
    EXPECT_NEAR(double(world->linear_velocity(a).y), 0, 1e-6);
    EXPECT_NEAR(double(world->linear_velocity(b).y), 0, 1e-6);
    return {double(world->linear_velocity(a).x), double(world->linear_velocity(b).x)};
}

class TwoBodies : public testing::TestWithParam<std::tuple<float, float>> {};

TEST_P(TwoBodies, PartWithTheSpeedsOfTheCollisionFormula) {
    // With total mass M = ma + mb and approach u = va - vb:
    //     va' = (ma va + mb vb - mb e u) / M,    vb' = (ma va + mb vb + ma e u) / M.
    // The contact works on two velocities with a few dozen roundings: 1e-5 of the approach speed of 4 m/s.
    const auto [e, m] = GetParam();
    const Speeds after = collide_balls(e, m);
    const double ma = 1, mb = double(m), p = 3 * ma - mb, u = 4;
    EXPECT_NEAR(after.a, (p - mb * double(e) * u) / (ma + mb), 1e-5 * u);
    EXPECT_NEAR(after.b, (p + ma * double(e) * u) / (ma + mb), 1e-5 * u);
}

INSTANTIATE_TEST_SUITE_P(Restitution, TwoBodies,
                         testing::Combine(testing::Values(0.0f, 0.25f, 0.5f, 0.75f, 1.0f), testing::Values(0.1f, 1.0f, 4.0f, 50.0f)));

TEST(Restitution, AWallSendsTheBallBackWithESpeed) {
    // v' = -e v.
    for (const float e : {0.2f, 0.6f, 1.0f}) {
        TestWorld world(roomy, weightless());
        world.add_box({3, 0}, 0.5f, 5, bouncy(0), BodyType::static_body);
        BodyDef def = dynamic_at({0, 0});
        def.linear_velocity = {8, 0};
        const BodyId ball = world.add(Circle{}, def, bouncy(e));
        world.step(60);
        EXPECT_NEAR(double(world->linear_velocity(ball).x), -8 * double(e), 1e-4) << "e " << e;
    }
}

TEST(Restitution, BelowTheThresholdNothingBounces) {
    // Speeds just under the threshold of 1 m/s end at 0, just above it at e v.
    for (const float speed : {0.5f, 0.99f, 1.01f, 2.0f}) {
        TestWorld world(roomy, weightless());
        world.add_box({1, 0}, 0.25f, 5, bouncy(0), BodyType::static_body);
        BodyDef def = dynamic_at({0, 0});
        def.linear_velocity = {speed, 0};
        const BodyId ball = world.add(Circle{}, def, bouncy(0.5f));
        world.step(120);
        EXPECT_NEAR(double(world->linear_velocity(ball).x), speed > 1 ? -0.5 * double(speed) : 0, 1e-4) << "speed " << speed;
    }
}

// Nor does gravity lower the threshold: these surfaces meet at sqrt(0.95^2 + 2 g 0.002) = 0.97 m/s.
TEST(Restitution, BelowTheThresholdNothingThatFallsBounces) {
    TestWorld world(roomy, sleepless());
    world.add_ground(0, 10, bouncy(0));
    BodyDef body = dynamic_at({0, 0.502f});
    body.linear_velocity = {0, -0.95f};
    const BodyId ball = add_solid(world, Solid::ball, body, bouncy(1));
    for (int i = 0; i < 60; ++i) {
        world.step();
        EXPECT_LT(world->linear_velocity(ball).y, 0.2f) << "step " << i;
    }
}

// What gravity adds in two steps of one substep is more than the threshold here. It must not be taken for a speed at which the two meet.
TEST(Restitution, WhatLiesUnderStrongGravityDoesNotStartToBounce) {
    for (const Solid solid : {Solid::ball, Solid::box, Solid::octagon}) {
        for (int start = 0; start < 10; ++start) {
            const float above = std::array{-1e-3f, 0.0f, 1e-6f, 1e-4f, 1e-3f}[static_cast<std::size_t>(start / 2)];
            WorldDef def = sleepless();
            def.solver.warm_start = start % 2 == 0;
            def.gravity = {0, -27};
            def.solver.substeps = 1;
            def.restitution_threshold = 0.5f;
            TestWorld world(roomy, def);
            world.add_ground(0, 10, bouncy(0));
            const float height = solid == Solid::octagon ? 0.461939f : 0.5f;
            const BodyId it = add_solid(world, solid, dynamic_at({0, height + above}), bouncy(1));
            // At first it may rock, or rise by the spring that undoes its overlap. No rise may be higher than the speed of two steps' gravity gives.
            const float most = height + (2 * 27 * step_time) * (2 * 27 * step_time) / (2 * 27);
            for (int i = 0; i < 1200; ++i) {
                world.step();
                ASSERT_LT(world->position(it).y, most) << "solid " << int(solid) << ", " << above << " m above the floor, step " << i;
            }
        }
    }
}

TEST(Restitution, TheThresholdCanBeChosen) {
    WorldDef def = weightless();
    def.restitution_threshold = 5;
    TestWorld world(roomy, def);
    world.add_box({3, 0}, 0.25f, 5, bouncy(0), BodyType::static_body);
    BodyDef ball_def = dynamic_at({0, 0});
    ball_def.linear_velocity = {4, 0};
    const BodyId ball = world.add(Circle{}, ball_def, bouncy(1));
    world.step(120);
    EXPECT_NEAR(double(world->linear_velocity(ball).x), 0, 1e-4);
}

TEST(Restitution, TwoShapesMixByTheLarger) {
    for (const auto& [wall, own] : {std::pair{0.2f, 0.7f}, std::pair{0.7f, 0.2f}}) {
        TestWorld world(roomy, weightless());
        world.add_box({3, 0}, 0.5f, 5, bouncy(wall), BodyType::static_body);
        BodyDef def = dynamic_at({0, 0});
        def.linear_velocity = {10, 0};
        const BodyId ball = world.add(Circle{}, def, bouncy(own));
        world.step(60);
        EXPECT_NEAR(double(world->linear_velocity(ball).x), -7, 1e-4);
    }
}

TEST(Restitution, ABoxLandingFlatBouncesFlat) {
    // Both corners meet the ground at once; the box rebounds at e v without turning.
    TestWorld world(roomy, weightless());
    world.add_ground(0, 10, bouncy(0));
    BodyDef def = dynamic_at({0, 3});
    def.linear_velocity = {0, -6};
    const BodyId box = world.add(make_box(0.5f, 0.5f), def, bouncy(0.5f));
    world.step(60);
    // 1e-2: the two points share the impulse.
    EXPECT_NEAR(double(world->linear_velocity(box).y), 3, 1e-2);
    EXPECT_NEAR(double(world->angular_velocity(box)), 0, 1e-2);
}

// A frictionless floor takes no energy from what bounces with e = 1, however it lands: both corners of a box that comes down a little tilted bounce in one
// step. (The second stopped dead, and a plank kept nothing of its energy.) A later corner is given nine tenths of its rebound, so that errors take energy.
TEST(Restitution, ATiltedLandingKeepsMostOfTheEnergy) {
    struct Kind {
        const char* name;
        Polygon shape;
    };
    for (const auto& [name, shape] : {Kind{"box", make_box(0.5f, 0.5f)}, Kind{"plank", make_box(0.8f, 0.1f)},
                                      Kind{"triangle", make_polygon(compute_hull(regular(3, 0.6f)))},
                                      Kind{"octagon", make_polygon(compute_hull(regular(8, 0.5f)))}}) {
        const std::string_view kind = name;
        const float face = kind == "triangle" ? -pi / 6 : kind == "octagon" ? pi / 8 : 0.0f;  // turned by this, it lands flat
        for (const float dt : {1.0f / 60, 1.0f / 120, 1.0f / 240}) {
            for (const float tilt : {0.005f, 0.02f, 0.05f, 0.1f, 0.15f, 0.2f, 0.3f, 0.5f, 0.7f}) {
                TestWorld world(roomy, weightless());
                world.add_ground(0, 10, bouncy(1));
                const BodyId body = world->create_body(dynamic_at({0, 1.5f}, face + tilt));
                world->create_shape(body, shape, bouncy(1));
                world->set_linear_velocity(body, {0, -5});
                const double before = kinetic_energy(*world, body);
                world.step(static_cast<int>(1.0f / dt), dt);
                EXPECT_GT(world->linear_velocity(body).y, 0) << name << ", tilt " << tilt;
                EXPECT_GT(kinetic_energy(*world, body) / before, 0.75) << name << ", tilt " << tilt << ", dt " << dt;
                EXPECT_LT(kinetic_energy(*world, body) / before, 1.005) << name << ", tilt " << tilt << ", dt " << dt;
            }
        }
    }
}

// Nine frictionless bodies with e = 1 in a weightless room: energy is kept in theory, and may only fall.
TEST(Restitution, ARoomGainsNoEnergy) {
    for (const Polygon& shape : {make_box(0.6f, 0.6f), make_box(0.8f, 0.1f), make_polygon(compute_hull(regular(3, 0.7f))),
                                 make_polygon(compute_hull(regular(8, 0.6f)))}) {
        TestWorld world(roomy, weightless());
        for (int side = 0; side < 4; ++side) {
            const Rot turn = make_rot(pi / 2 * static_cast<float>(side));
            world->create_shape(world->create_body({}), make_offset_box(6, 1, {rotate(turn, {0, -6}), turn}), bouncy(1));
        }
        std::vector<BodyId> bodies;
        for (int i = 0; i < 9; ++i) {
            const auto f = static_cast<float>(i);
            bodies.push_back(world->create_body(dynamic_at({static_cast<float>(i % 3 - 1) * 3, static_cast<float>(i / 3 - 1) * 3}, f)));
            world->create_shape(bodies.back(), shape, bouncy(1));
            world->set_linear_velocity(bodies.back(), 6.0f * Vec2{std::sin(3 * f), std::cos(5 * f)});
            world->set_angular_velocity(bodies.back(), 6 * std::sin(7 * f));
        }
        const auto energy = [&] {
            double sum = 0;
            for (const BodyId body : bodies) sum += kinetic_energy(*world, body);
            return sum;
        };
        const double before = energy();
        for (int i = 0; i < (slow_build ? 600 : 3600); ++i) {
            world.step();
            ASSERT_LT(energy(), 1.1 * before) << shape.count << " corners, step " << i;
        }
    }
}

}  // namespace
}  // namespace islet::test
