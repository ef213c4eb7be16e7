// Bouncing: heights, speeds after a collision of two bodies, the threshold and the mixing rule.
#include <gtest/gtest.h>

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
    // v = sqrt(2 g h) at the ground, e v after it, so it rises to e^2 h. The engine bounces off the speed at the start of the step in
    // which surfaces meet (or come within the speculative 0.02 m), so the speed is short by up to two steps of gravity: from
    // e^2 (v - 2 g dt)^2 / (2 g) to e^2 v^2 / (2 g), give or take that margin of 0.02 m. Smaller steps narrow the band.
    for (const float dt : {1.0f / 60, 1.0f / 240, 1.0f / 960}) {
        for (const float e : {0.3f, 0.5f, 0.7f, 0.9f, 1.0f}) {
            const double v = std::sqrt(2 * g * 5), least = double(e) * (v - 2 * g * double(dt));
            const double height = rebound_height(e, 5, dt);
            EXPECT_GE(height, least * least / (2 * g) - 0.02) << "e " << e << " dt " << dt;
            EXPECT_LE(height, double(e) * double(e) * 5 + 0.02) << "e " << e << " dt " << dt;
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
