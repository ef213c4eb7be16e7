// Chains: nothing catches on the inner corners of a flat one, and closed ones hold what is inside.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "measure.hpp"

namespace islet::test {
namespace {

const Capacity room_for_chain{.bodies = 64, .shapes = 256, .contacts = 1024};

// A flat, smooth chain at y = 0 from x = 115 to x = -5: a floor runs from right to left.
BodyId add_flat_chain(TestWorld& world) {
    std::vector<Vec2> points;
    for (int x = 115; x >= -5; --x) points.push_back({static_cast<float>(x), 0});
    const BodyId ground = world->create_body({});
    EXPECT_EQ(world->create_chain(ground, points, false, rough(0)), 120u);
    return ground;
}

using Add = std::function<BodyId(TestWorld&, const BodyDef&)>;

struct Slider {
    const char* name;
    float height;  // of the body's origin when it rests, m
    Add add;
};

class FlatChain : public testing::TestWithParam<Slider> {};

TEST_P(FlatChain, CarriesASlidingBodyOver100Metres) {
    // Without friction nothing may change the speed of 10 m/s along the chain, and nothing lifts the body at the 100 joints it crosses. It settles in
    // the first second by what a soft contact gives; then its vertical speed stays below 0.01 m/s (a body that catches hops at 0.1 to 1 m/s).
    TestWorld world(room_for_chain, sleepless());
    add_flat_chain(world);
    BodyDef def = dynamic_at({0, GetParam().height});
    def.linear_velocity = {10, 0};
    const BodyId body = GetParam().add(world, def);
    world.step(60);
    double fastest = 0, turned = 0, lowest = 1e9, highest = -1e9;
    for (int i = 0; i < 540; ++i) {
        world.step();
        fastest = std::fmax(fastest, std::abs(double(world->linear_velocity(body).y)));
        turned = std::fmax(turned, std::abs(double(world->angular_velocity(body))));
        lowest = std::fmin(lowest, double(world->position(body).y));
        highest = std::fmax(highest, double(world->position(body).y));
    }
    EXPECT_LT(fastest, 0.01);
    EXPECT_LT(turned, 0.01);
    EXPECT_GT(lowest, double(GetParam().height) - 1e-3);
    EXPECT_LT(highest, double(GetParam().height) + 1e-3);
    EXPECT_NEAR(double(world->linear_velocity(body).x), 10, 1e-3);
    // 600 roundings of a place of up to 100 m: 600 * 100 eps = 4 mm at most.
    EXPECT_NEAR(double(world->position(body).x), 100, 0.01);
}

INSTANTIATE_TEST_SUITE_P(
    Chain, FlatChain,
    testing::Values(Slider{"Box", 0.5f, [](TestWorld& w, const BodyDef& def) { return w.add(make_box(0.5f, 0.5f), def, rough(0)); }},
                    Slider{"Circle", 0.5f, [](TestWorld& w, const BodyDef& def) { return w.add(Circle{}, def, rough(0)); }},
                    Slider{"Capsule", 0.25f,
                           [](TestWorld& w, const BodyDef& def) {
                               return w.add(Capsule{{-0.5f, 0}, {0.5f, 0}, 0.25f}, def, rough(0));
                           }},
                    Slider{"RoundedBox", 0.5f,
                           [](TestWorld& w, const BodyDef& def) { return w.add(make_rounded_box(0.4f, 0.4f, 0.1f), def, rough(0)); }}),
    [](const auto& test) { return test.param.name; });

TEST(Chain, ADiscRollsOverItsJointsWithoutSlowing) {
    TestWorld world(room_for_chain, sleepless());
    std::vector<Vec2> points;
    for (int x = 60; x >= -5; --x) points.push_back({static_cast<float>(x), 0});
    world->create_chain(world->create_body({}), points, false, rough(0.9f));
    BodyDef def = dynamic_at({0, 0.5f});
    def.linear_velocity = {5, 0};
    def.angular_velocity = -10;
    const BodyId disc = world.add(Circle{}, def, rough(0.9f));
    world.step(600);
    // Rolling without slip loses nothing; 1 % for lever arms that are kept while it rolls on.
    EXPECT_NEAR(double(world->linear_velocity(disc).x), 5, 0.05);
    // It rides as deep as its kept manifold lets it come before it is made anew: half of 0.01 m.
    EXPECT_NEAR(double(world->position(disc).y), 0.5, 5e-3);
}

TEST(Chain, IsSolidOnOneSideOnly) {
    TestWorld world(room_for_chain, sleepless());
    add_flat_chain(world);
    BodyDef rising = dynamic_at({20, -3});
    rising.linear_velocity = {0, 12};
    const BodyId from_below = world.add(Circle{}, rising), from_above = world.add_circle({30, 3});
    world.step(45);
    EXPECT_GT(double(world->position(from_below).y), 0.5) << "it passes from below";
    world.step(240);
    EXPECT_NEAR(double(world->position(from_below).y), 0.5, 2e-3) << "and lands from above";
    EXPECT_NEAR(double(world->position(from_above).y), 0.5, 2e-3);
}

TEST(Chain, ALoopHoldsWhatIsInside) {
    // A ring of 64 links of radius 5, clockwise, so that the right-hand side of each link is the inside. Sixty balls thrown about in it
    // for 20 s never come farther out than the ring: 5 m less their radius, plus what a contact gives under an impact, the way of 5 ms.
    WorldDef def = sleepless();
    TestWorld world(room_for_chain, def);
    std::vector<Vec2> ring;
    for (int i = 0; i < 64; ++i) {
        const Rot q = make_rot(-2 * pi * static_cast<float>(i) / 64);
        ring.push_back({5 * q.c, 5 * q.s});
    }
    ShapeDef bouncy = rough(0.2f);
    bouncy.restitution = 0.8f;
    ASSERT_EQ(world->create_chain(world->create_body({}), ring, true, bouncy), 64u);
    std::vector<BodyId> balls;
    for (int i = 0; i < 60; ++i) {
        BodyDef ball = dynamic_at({-2.5f + static_cast<float>(i % 10) * 0.55f, -2.5f + static_cast<float>(i / 10) * 0.55f});
        const Rot q = make_rot(static_cast<float>(i));
        ball.linear_velocity = {10 * q.c, 10 * q.s};
        balls.push_back(world.add(Circle{{}, 0.2f}, ball, bouncy));
    }
    double farthest = 0, fastest = 0;
    for (int i = 0; i < 1200; ++i) {
        world.step();
        for (const BodyId ball : balls) {
            farthest = std::fmax(farthest, double(length(world->position(ball))));
            fastest = std::fmax(fastest, double(length(world->linear_velocity(ball))));
        }
    }
    EXPECT_LT(fastest, 20);  // sixty balls of 10 m/s; one that several others hit at once is faster for a moment
    EXPECT_LT(farthest, 5 - 0.2 + 0.005 * fastest);
    EXPECT_TRUE(world.errors.empty());
}

}  // namespace
}  // namespace islet::test
