// The public functions of a world on bodies and shapes: what goes in comes out again.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/test_world.hpp"

namespace {

using namespace islet;
using namespace islet::test;

constexpr Vec2 square[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};

// -- bodies ------------------------------------------------------------------------------------------------------------------------------

TEST(World, ABodyIsAsItsDefinitionSays) {
    TestWorld w;
    BodyDef def;
    def.type = BodyType::dynamic;
    def.position = {3, -4};
    def.angle = 0.5f;
    def.linear_velocity = {1, 2};
    def.angular_velocity = -3;
    def.linear_damping = 0.25f;
    def.angular_damping = 0.75f;
    def.gravity_scale = -2;
    def.user_data = 0x0123456789abcdefull;
    const BodyId id = w->create_body(def);
    EXPECT_TRUE(id);
    EXPECT_TRUE(w->is_valid(id));
    EXPECT_EQ(w->type(id), BodyType::dynamic);
    EXPECT_EQ(w->position(id), def.position);
    EXPECT_EQ(w->transform(id).p, def.position);
    EXPECT_EQ(w->transform(id).q, make_rot(0.5f));
    EXPECT_NEAR(w->angle(id), 0.5f, 1e-6f);
    EXPECT_EQ(w->linear_velocity(id), def.linear_velocity);
    EXPECT_EQ(w->angular_velocity(id), def.angular_velocity);
    EXPECT_EQ(w->linear_damping(id), def.linear_damping);
    EXPECT_EQ(w->angular_damping(id), def.angular_damping);
    EXPECT_EQ(w->gravity_scale(id), def.gravity_scale);
    EXPECT_EQ(w->user_data(id), def.user_data);
    EXPECT_TRUE(w->is_awake(id));
    EXPECT_EQ(w->mass(id), 1.0f) << "a dynamic body without shapes weighs a kilogram";
    EXPECT_EQ(w->rotational_inertia(id), 0.0f);
    EXPECT_TRUE(w.errors.empty());
}

TEST(World, StaticBodiesNeverMoveAndAreNeverAwake) {
    TestWorld w;
    BodyDef def;
    def.linear_velocity = {1, 2};
    def.angular_velocity = 3;
    const BodyId id = w->create_body(def);
    EXPECT_EQ(w->linear_velocity(id), Vec2{});
    w->set_linear_velocity(id, {1, 1});
    w->set_angular_velocity(id, 1);
    w->apply_force_to_center(id, {1, 1});
    w->apply_linear_impulse(id, {1, 1}, {2, 0});
    w->wake(id);
    w.step(10);
    EXPECT_EQ(w->position(id), Vec2{});
    EXPECT_EQ(w->linear_velocity(id), Vec2{});
    EXPECT_EQ(w->angular_velocity(id), 0.0f);
    EXPECT_EQ(w->mass(id), 0.0f);
    EXPECT_FALSE(w->is_awake(id));
}

TEST(World, WalkingOverTheSlotsFindsEveryBodyOnce) {
    TestWorld w({.bodies = 10, .shapes = 10, .contacts = 10});
    std::vector<BodyId> ids;
    for (int i = 0; i < 7; ++i) ids.push_back(w->create_body({}));
    w->destroy_body(ids[3]);
    ids.erase(ids.begin() + 3);
    EXPECT_EQ(w.bodies(), ids);
    EXPECT_EQ(w->body_count(), 6u);
    EXPECT_FALSE(w->body_at(3));
    EXPECT_FALSE(w->body_at(10));
}

TEST(World, RecreatingThingsInTheSameOrderGivesTheSameIds) {
    const auto run = [] {
        TestWorld w({.bodies = 10, .shapes = 10, .contacts = 10});
        std::vector<std::uint32_t> seen;
        for (int round = 0; round < 3; ++round) {
            std::vector<BodyId> ids;
            for (int i = 0; i < 6; ++i) ids.push_back(w.add_box({static_cast<float>(i), 0}));
            for (const int i : {4, 1, 5, 0, 2, 3}) w->destroy_body(ids[static_cast<std::size_t>(i)]);
            for (const BodyId id : ids) seen.insert(seen.end(), {id.index1, id.generation});
        }
        return seen;
    };
    EXPECT_EQ(run(), run());
}

TEST(World, DestroyingABodyTakesItsShapesWithIt) {
    TestWorld w;
    const BodyId body = w.add_box({0, 5});
    const ShapeId box = w.shape_of(body);
    const ShapeId disc = w->create_shape(body, Circle{{1, 0}, 0.5f});
    const BodyId other = w.add_box({10, 5});
    w->destroy_body(body);
    EXPECT_FALSE(w->is_valid(body));
    EXPECT_FALSE(w->is_valid(box));
    EXPECT_FALSE(w->is_valid(disc));
    EXPECT_TRUE(w->is_valid(other));
    EXPECT_EQ(w->body_count(), 1u);
    EXPECT_EQ(w->shape_count(), 1u);
    EXPECT_EQ(w->validate(), nullptr);
}

TEST(World, UserDataChangesNothing) {
    TestWorld w;
    const BodyId body = w.add_box({0, 5});
    const std::uint64_t before = w->hash();
    w->set_user_data(body, ~0ull);
    w->set_user_data(w.shape_of(body), 77);
    EXPECT_EQ(w->user_data(body), ~0ull);
    EXPECT_EQ(w->user_data(w.shape_of(body)), 77u);
    EXPECT_EQ(w->hash(), before);
}

// -- mass --------------------------------------------------------------------------------------------------------------------------------

TEST(World, MassAddsUpOverShapesByTheParallelAxisTheorem) {
    TestWorld w;
    BodyDef def;
    def.type = BodyType::dynamic;
    def.position = {10, 20};
    const BodyId body = w->create_body(def);
    ShapeDef heavy;
    heavy.density = 3;
    w->create_shape(body, make_offset_box(0.5f, 1, {{2, 0}, {}}), heavy);  // 1 x 2 m
    w->create_shape(body, Circle{{-1, 1}, 0.5f});
    const double m1 = 3 * 2, m2 = 3.14159265358979 * 0.25;
    const double x = (m1 * 2 - m2) / (m1 + m2), y = m2 / (m1 + m2);
    const double i1 = m1 * (1 + 4) / 12, i2 = m2 * 0.25 / 2;
    const double inertia = i1 + m1 * ((2 - x) * (2 - x) + y * y) + i2 + m2 * ((x + 1) * (x + 1) + (1 - y) * (1 - y));
    EXPECT_NEAR(w->mass(body), m1 + m2, 1e-5);
    EXPECT_NEAR(w->local_center_of_mass(body).x, x, 1e-6);
    EXPECT_NEAR(w->local_center_of_mass(body).y, y, 1e-6);
    EXPECT_NEAR(w->center_of_mass(body).x, 10 + x, 1e-5);
    EXPECT_NEAR(w->center_of_mass(body).y, 20 + y, 1e-5);
    EXPECT_NEAR(w->rotational_inertia(body), inertia, 1e-5 * inertia);

    w->destroy_shape(w.shape_of(body));  // the disc goes again
    EXPECT_NEAR(w->mass(body), m1, 1e-5);
    EXPECT_NEAR(w->local_center_of_mass(body).x, 2, 1e-6);
    EXPECT_NEAR(w->rotational_inertia(body), i1, 1e-5);
}

TEST(World, TheMassOverrideLastsUntilResetOrTheShapesChange) {
    TestWorld w;
    const BodyId body = w.add_box({0, 0});
    const auto overridden = [&] {
        w->set_mass(body, {7, {0.25f, 0}, 9});
        return w->mass(body) == 7 && w->rotational_inertia(body) == 9 && w->local_center_of_mass(body) == Vec2{0.25f, 0};
    };
    EXPECT_TRUE(overridden());
    w.step();
    EXPECT_EQ(w->mass(body), 7.0f);
    w->reset_mass(body);
    EXPECT_FLOAT_EQ(w->mass(body), 1);
    EXPECT_FLOAT_EQ(w->rotational_inertia(body), 1.0f / 6);
    EXPECT_TRUE(overridden());
    const ShapeId more = w->create_shape(body, Circle{{0, 0}, 1});
    EXPECT_NEAR(w->mass(body), 1 + pi, 1e-5f);
    EXPECT_TRUE(overridden());
    w->destroy_shape(more);
    EXPECT_FLOAT_EQ(w->mass(body), 1);
}

TEST(World, ChangingTheCentreOfMassKeepsTheVelocityOfTheMaterial) {
    WorldDef def;
    def.gravity = {0, 0};
    TestWorld w(roomy, def);
    const BodyId body = w.add_box({2, 3});
    w->set_linear_velocity(body, {1, -1});
    w->set_angular_velocity(body, 2);
    const Vec2 points[] = {{2, 3}, {2.5f, 3.5f}, {0, 0}};
    Vec2 before[3];
    for (int i = 0; i < 3; ++i) before[i] = w->velocity_at(body, points[i]);
    w->set_mass(body, {5, {0.5f, 0.25f}, 1});
    for (int i = 0; i < 3; ++i) EXPECT_LT(distance(w->velocity_at(body, points[i]), before[i]), 1e-5f);
    EXPECT_EQ(w->position(body), (Vec2{2, 3}));
}

TEST(World, MovingTheCentreOfMassOfARestingBodyMovesNothing) {
    TestWorld w;
    w.add_ground();
    const BodyId body = w.add_box({0, 0.5f});
    w.step(60);
    const float height = w->position(body).y;
    w->set_mass(body, {1, {0, 0.008f}, 1.0f / 6});
    w.step(30);
    EXPECT_NEAR(w->position(body).y, height, 0.001f);
}

// -- type --------------------------------------------------------------------------------------------------------------------------------

TEST(World, ATypeMayChangeBackAndForth) {
    TestWorld w;
    w.add_ground();
    const BodyId body = w.add_box({0, 3});
    const ShapeId shape = w.shape_of(body);
    w.step(10);
    w->set_type(body, BodyType::static_body);
    const Vec2 stopped = w->position(body);
    EXPECT_EQ(w->linear_velocity(body), Vec2{});
    EXPECT_EQ(w->mass(body), 0.0f);
    w.step(10);
    EXPECT_EQ(w->position(body), stopped);

    w->set_type(body, BodyType::kinematic);
    w->set_linear_velocity(body, {0, 1});
    w.step(60);
    EXPECT_NEAR(w->position(body).y, stopped.y + 1, 1e-4f);
    EXPECT_EQ(w->mass(body), 0.0f);

    w->set_type(body, BodyType::dynamic);
    EXPECT_FLOAT_EQ(w->mass(body), 1);
    w.step(120);
    EXPECT_NEAR(w->position(body).y, 0.5f, 0.01f) << "it falls and lands";
    EXPECT_TRUE(w->is_valid(shape));
    EXPECT_EQ(w->validate(), nullptr);
}

TEST(World, WhatStandsOnABodyThatTurnsDynamicFallsWithIt) {
    TestWorld w;
    const BodyId shelf = w.add_box({0, 5}, 1, 0.5f, {}, BodyType::static_body);
    const BodyId box = w.add_box({0, 6});
    w.step(120);
    EXPECT_FALSE(w->is_awake(box));
    w->set_type(shelf, BodyType::dynamic);
    EXPECT_TRUE(w->is_awake(box));
    w.step(60);
    EXPECT_LT(w->position(box).y, 2);
}

// -- shapes ------------------------------------------------------------------------------------------------------------------------------

TEST(World, AShapeIsAsItsDefinitionSays) {
    TestWorld w;
    const BodyId body = w->create_body({});
    ShapeDef def;
    def.friction = 0.25f;
    def.restitution = 0.5f;
    def.rolling_resistance = 0.125f;
    def.tangent_speed = -2;
    def.filter = {2, 4, -7};
    def.user_data = 99;
    const ShapeId id = w->create_shape(body, Circle{{1, 2}, 3}, def);
    EXPECT_TRUE(w->is_valid(id));
    EXPECT_EQ(w->body(id), body);
    EXPECT_EQ(w->friction(id), 0.25f);
    EXPECT_EQ(w->restitution(id), 0.5f);
    EXPECT_EQ(w->rolling_resistance(id), 0.125f);
    EXPECT_EQ(w->tangent_speed(id), -2.0f);
    EXPECT_EQ(w->filter(id).category, 2u);
    EXPECT_EQ(w->filter(id).mask, 4u);
    EXPECT_EQ(w->filter(id).group, -7);
    EXPECT_EQ(w->user_data(id), 99u);
    w->set_friction(id, 1);
    w->set_restitution(id, 0);
    w->set_rolling_resistance(id, 0.5f);
    w->set_tangent_speed(id, 3);
    EXPECT_EQ(w->friction(id), 1.0f);
    EXPECT_EQ(w->restitution(id), 0.0f);
    EXPECT_EQ(w->rolling_resistance(id), 0.5f);
    EXPECT_EQ(w->tangent_speed(id), 3.0f);
}

TEST(World, EveryGeometryComesBackAsItWasGiven) {
    TestWorld w;
    const BodyId body = w->create_body({});
    const ShapeId circle = w->create_shape(body, Circle{{1, 2}, 3});
    const ShapeId capsule = w->create_shape(body, Capsule{{1, 2}, {3, 4}, 5});
    const ShapeId segment = w->create_shape(body, Segment{{1, 2}, {3, 4}});
    const ShapeId chain = w->create_shape(body, ChainSegment{{0, 0}, {{1, 2}, {3, 4}}, {5, 5}});
    const Polygon given = make_polygon(compute_hull(square), 0.125f);
    const ShapeId polygon = w->create_shape(body, given);
    EXPECT_EQ(w->shape_type(circle), ShapeType::circle);
    EXPECT_EQ(w->circle(circle)->center, (Vec2{1, 2}));
    EXPECT_EQ(w->circle(circle)->radius, 3.0f);
    EXPECT_EQ(w->shape_type(capsule), ShapeType::capsule);
    EXPECT_EQ(w->capsule(capsule)->point2, (Vec2{3, 4}));
    EXPECT_EQ(w->shape_type(segment), ShapeType::segment);
    EXPECT_EQ(w->segment(segment)->point1, (Vec2{1, 2}));
    EXPECT_EQ(w->shape_type(chain), ShapeType::chain_segment);
    EXPECT_EQ(w->chain_segment(chain)->ghost2, (Vec2{5, 5}));
    EXPECT_EQ(w->shape_type(polygon), ShapeType::polygon);
    ASSERT_EQ(w->polygon(polygon)->count, 4u);
    EXPECT_EQ(w->polygon(polygon)->radius, 0.125f);
    EXPECT_TRUE(std::equal(given.vertices, given.vertices + 4, w->polygon(polygon)->vertices));
}

TEST(World, TheShapesOfABodyAreListedNewestFirstAsFarAsTheyFit) {
    TestWorld w;
    const BodyId body = w->create_body({});
    ShapeId made[3];
    for (ShapeId& id : made) id = w->create_shape(body, Circle{});
    ShapeId out[5];
    EXPECT_EQ(w->shapes(body, out), 3u);
    EXPECT_EQ(out[0], made[2]);
    EXPECT_EQ(out[1], made[1]);
    EXPECT_EQ(out[2], made[0]);
    EXPECT_FALSE(out[3]);
    ShapeId one[1];
    EXPECT_EQ(w->shapes(body, one), 3u);
    EXPECT_EQ(one[0], made[2]);
    w->destroy_shape(made[1]);
    EXPECT_EQ(w->shapes(body, out), 2u);
    EXPECT_EQ(out[1], made[0]);
    EXPECT_EQ(w->validate(), nullptr);
}

TEST(World, ABoxAroundAShapeFollowsItsBody) {
    TestWorld w;
    const BodyId body = w.add_box({1, 2}, 2, 1, {}, BodyType::static_body);
    EXPECT_EQ(w->aabb(w.shape_of(body)), (Aabb{{-1, 1}, {3, 3}}));
    w->set_transform(body, {10, 0}, pi / 2);
    const Aabb turned = w->aabb(w.shape_of(body));
    EXPECT_LT(distance(turned.lower, {9, -2}), 1e-5f);
    EXPECT_LT(distance(turned.upper, {11, 2}), 1e-5f);
}

TEST(World, AChainKnowsTheNeighboursOfEachOfItsSegments) {
    TestWorld w;
    const BodyId body = w->create_body({});
    ShapeId made[8];
    ASSERT_EQ(w->create_chain(body, square, true, {}, made), 4u);
    for (int i = 0; i < 4; ++i) {
        const ChainSegment* s = w->chain_segment(made[i]);
        ASSERT_NE(s, nullptr);
        EXPECT_EQ(s->ghost1, square[(i + 3) % 4]);
        EXPECT_EQ(s->segment.point1, square[i]);
        EXPECT_EQ(s->segment.point2, square[(i + 1) % 4]);
        EXPECT_EQ(s->ghost2, square[(i + 2) % 4]);
    }
    ASSERT_EQ(w->create_chain(body, square, false, {}, std::span(made, 2)), 3u);
    EXPECT_EQ(w->chain_segment(made[0])->ghost1, (Vec2{-3, -1})) << "an open end goes on straight";
    EXPECT_EQ(w->chain_segment(made[1])->ghost1, square[0]);
    EXPECT_EQ(w->shape_count(), 7u);
    EXPECT_EQ(w->create_chain(body, std::span(square, 2), false), 1u);
}

}  // namespace
