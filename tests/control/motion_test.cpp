// Leading bodies: locks, targets, disabled bodies. Where things come to is worked out from geometry.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/image.hpp"
#include "support/joint_world.hpp"
#include "support/random.hpp"
#include "support/test_world.hpp"

namespace islet::test {
namespace {

// -- locks -------------------------------------------------------------------------------------------------------------------------------

TEST(Locks, ABodyMovesAlongTheOtherAxisAloneWhateverPushesIt) {
    TestWorld w;
    w.add_ground();
    const BodyId slider = w.add(make_box(0.5f, 0.5f), {.type = BodyType::dynamic, .position = {0, 3}, .linear_velocity = {1, 5}, .lock_y = true});
    EXPECT_EQ(w->linear_velocity(slider), (Vec2{1, 0}));
    for (int i = 0; i < 40; ++i) w.add_circle({-0.6f + 0.03f * static_cast<float>(i), 5 + static_cast<float>(i)}, 0.3f);
    for (int i = 0; i < 300; ++i) {
        if (i == 100) w->apply_linear_impulse(slider, {0.5f, 3}, w->center_of_mass(slider));
        if (i == 150) w->set_linear_velocity(slider, {0.5f, -3});
        if (i % 10 == 0) w->apply_force_to_center(slider, {0, 500});
        w.step();
        ASSERT_EQ(w->position(slider).y, 3) << "not by one bit";
        ASSERT_EQ(w->linear_velocity(slider).y, 0);
    }
    EXPECT_NE(w->position(slider).x, 0);
    EXPECT_EQ(w->validate(), nullptr);
}

// A wedge of slope 1:2 moves to the right by x; the piston that stands on its face, and may move up and down alone, is lifted by x / 2.
TEST(Locks, APistonOnAMovingWedgeFollowsItsSlope) {
    for (const float friction : {0.0f, 0.3f}) {
        TestWorld w;
        const Vec2 corners[] = {{-4, 0}, {4, 0}, {-4, 4}};
        const BodyId wedge = w.add(make_polygon(compute_hull(corners)), {.type = BodyType::kinematic, .linear_velocity = {1, 0}}, {.friction = friction});
        const float start = 2 + 0.5f * std::sqrt(1.25f);  // the circle of radius 0.5 over x = 0 touches the face y = 2 - x / 2 there
        const BodyId piston = w.add(Circle{{0, 0}, 0.5f}, {.type = BodyType::dynamic, .position = {0, start}, .fixed_rotation = true, .lock_x = true},
                                    {.friction = friction});
        const BodyId load = w.add_box({0, start + 1}, 0.5f, 0.5f, {.density = 5});
        w->set_fixed_rotation(load, true);
        w->lock_x(load, true);
        for (int i = 1; i <= 90; ++i) {
            w.step();
            ASSERT_EQ(w->position(piston).x, 0);
            const float moved = w->position(wedge).x;
            EXPECT_NEAR(w->position(piston).y, start + moved / 2, 0.012f) << "step " << i;
        }
        EXPECT_NEAR(w->linear_velocity(piston).y, 0.5f, 0.02f);
    }
}

// Newton's third law with a lock: of an oblique blow a locked ball takes up only the part along its free axis.
// Ball A at v hits B at rest, equal masses, contact normal n; B may move along x alone, so n . v' = n_x V with V = J n_x / m and v' = v - J n / m:
// without bouncing n . v' = n_x V gives J = m (n . v) / (1 + n_x^2).
// (The lock is a row of its own, and sweeps hand impulses to and fro between the two rows: exactness takes a few.)
TEST(Locks, ABlowMovesALockedBallAsItsFreeAxisAllows) {
    TestWorld w(roomy, {.gravity = {0, 0}, .solver = {.iterations = 8, .relax_iterations = 8}});
    const float side = std::sqrt(0.5f);
    const ShapeDef smooth{.friction = 0};
    const BodyId b = w.add(Circle{{0, 0}, 0.5f}, {.type = BodyType::dynamic, .lock_y = true}, smooth);
    const BodyId a = w.add(Circle{{0, 0}, 0.5f}, {.type = BodyType::dynamic, .position = {-side, -side}}, smooth);
    w->set_linear_velocity(a, {1, 1});
    w.step(2);
    const float j = std::sqrt(2.0f) / 1.5f;  // over m
    EXPECT_NEAR(w->linear_velocity(b).x, j * side, 0.01f);
    EXPECT_NEAR(w->linear_velocity(a).x, 1 - j * side, 0.01f);
    EXPECT_NEAR(w->linear_velocity(a).y, 1 - j * side, 0.01f);
}

TEST(Locks, BothAxesMakeAHingeAtTheCentreOfMass) {
    TestWorld w;
    const BodyId wheel = w.add(make_box(1, 0.1f), {.type = BodyType::dynamic, .position = {2, 2}, .lock_x = true, .lock_y = true});
    w->apply_angular_impulse(wheel, 0.5f);
    w.step(60);
    EXPECT_EQ(w->position(wheel), (Vec2{2, 2}));
    EXPECT_NEAR(w->angular_velocity(wheel), 0.5f / w->rotational_inertia(wheel), 1e-4f);
}

TEST(Locks, CanBeTakenAwayAndGiven) {
    TestWorld w;
    const BodyId ball = w.add_circle({0, 0});
    w->lock_y(ball, true);
    EXPECT_TRUE(w->is_y_locked(ball));
    EXPECT_FALSE(w->is_x_locked(ball));
    w.step(30);
    EXPECT_EQ(w->position(ball).y, 0);
    w->lock_y(ball, false);
    w.step(60);
    EXPECT_NEAR(w->position(ball).y, -5, 0.1f);
    w->lock_y(ball, true);
    EXPECT_EQ(w->linear_velocity(ball).y, 0);
    EXPECT_EQ(w->validate(), nullptr);
    w->destroy_body(ball);
    EXPECT_EQ(w->validate(), nullptr);
}

// A ball hung by a chain of hinges from a slider that may only move along x: together they keep their centre of mass over one place.
TEST(Locks, HoldWithJointsToo) {
    TestWorld w;
    const BodyId cart = w.add(make_box(0.5f, 0.25f), {.type = BodyType::dynamic, .fixed_rotation = true, .lock_y = true});
    BodyId last = cart;
    float sum = w->mass(cart), moment = 0;
    for (int i = 0; i < 6; ++i) {
        const BodyId link = w.add(Capsule{{-0.25f, 0}, {0.25f, 0}, 0.05f}, {.type = BodyType::dynamic, .position = {0.25f + 0.5f * static_cast<float>(i), 0}},
                                  {.density = i == 5 ? 40.0f : 1.0f, .filter = {.group = -1}});
        w->create_joint(RevoluteJointDef{.base = {.body_a = last, .body_b = link, .frame_a = {{i == 0 ? 0.0f : 0.25f, 0}}, .frame_b = {{-0.25f, 0}}}});
        sum += w->mass(link);
        moment += w->mass(link) * w->center_of_mass(link).x;
        last = link;
    }
    const float middle = moment / sum;
    float lowest = 0;
    for (int i = 0; i < 240; ++i) {
        w.step();
        ASSERT_EQ(w->position(cart).y, 0);
        float now = 0;
        for (const BodyId body : w.bodies()) now += w->mass(body) * w->center_of_mass(body).x;
        ASSERT_NEAR(now / sum, middle, 0.02f) << "no force acts along x";
        lowest = std::min(lowest, w->position(last).y);
    }
    EXPECT_LT(lowest, -2) << "it swings";
}

// -- targets -----------------------------------------------------------------------------------------------------------------------------

TEST(Targets, AKinematicBodyIsThereAfterOneStep) {
    Random random(2);
    for (int i = 0; i < 300; ++i) {
        const float dt = i % 2 == 0 ? 1.0f / 60 : random.between(0.005f, 0.05f);
        TestWorld w;
        const float angle = random.between(-3, 3);
        const BodyId body = w.add(make_box(1, 0.2f), {.type = BodyType::kinematic, .position = {random.between(-9, 9), random.between(-9, 9)}, .angle = angle});
        const Vec2 place = w->position(body) + Vec2{random.between(-1, 1), random.between(-1, 1)};
        const float turn = random.between(-1.5f, 1.5f);
        w->set_target(body, {place, make_rot(angle + turn)}, dt);
        w->step(dt);
        EXPECT_NEAR(w->position(body).x, place.x, 4e-6f);
        EXPECT_NEAR(w->position(body).y, place.y, 4e-6f);
        EXPECT_NEAR(angle_of(inv_mul(make_rot(angle + turn), w->transform(body).q)), 0, 3e-6f) << turn;
    }
}

TEST(Targets, WhatStandsOnALiftIsCarriedAlong) {
    TestWorld w;
    const BodyId lift = w.add_box({0, 0}, 2, 0.25f, {}, BodyType::kinematic);
    const BodyId crate = w.add_box({0, 0.75f});
    for (int i = 1; i <= 120; ++i) {
        const float t = static_cast<float>(i) / 60;
        w->set_target(lift, {{std::sin(t), 0.5f * t}, {}}, 1.0f / 60);
        w.step();
        EXPECT_NEAR(w->position(crate).y - w->position(lift).y, 0.75f, 0.02f);
        EXPECT_NEAR(w->position(crate).x - w->position(lift).x, 0, 0.06f);
    }
}

TEST(Targets, FartherThanAStepGoesIsApproachedAsFastAsMayBe) {
    TestWorld w(roomy, {.max_speed = 30});
    const BodyId body = w.add_box({0, 0}, 1, 1, {}, BodyType::kinematic);
    w->set_target(body, {{3, 4}, make_rot(3)}, 0.1f);
    w->step(0.1f);
    EXPECT_NEAR(w->position(body).x, 1.8f, 1e-5f) << "3 of 5 m, straight on";
    EXPECT_NEAR(w->position(body).y, 2.4f, 1e-5f);
    EXPECT_NEAR(w->angle(body), 0.5f * pi, 1e-5f);
    w->set_target(body, w->transform(body), 0.1f);
    w->step(0.1f);
    EXPECT_NEAR(w->position(body).x, 1.8f, 1e-5f) << "a target where it is stops it";
}

TEST(Targets, HaveNoEffectOnOtherBodies) {
    TestWorld w(roomy, {.gravity = {0, 0}});
    const BodyId ball = w.add_circle({0, 0}), wall = w.add_ground(-5);
    w->set_target(ball, {{1, 0}, {}}, 0.1f);
    w->set_target(wall, {{1, 0}, {}}, 0.1f);
    w.step(5);
    EXPECT_EQ(w->position(ball), Vec2{});
    EXPECT_EQ(w->last_error(), Error::none);
}

// -- disabled bodies ---------------------------------------------------------------------------------------------------------------------

TEST(Disabled, TakesPartInNothingAndComesBackAsItWas) {
    TestWorld w;
    w.add_ground();
    const BodyId shelf = w.add_box({0, 3}, 1, 0.1f, {}, BodyType::static_body), crate = w.add_box({0, 3.6f});
    w.step(30);
    ASSERT_EQ(w.contacts().size(), 1u);
    w->set_enabled(shelf, false);
    EXPECT_FALSE(w->is_enabled(shelf));
    EXPECT_EQ(w->end_touch_events().size(), 1u);
    EXPECT_EQ(w->validate(), nullptr);
    w.step(120);
    EXPECT_NEAR(w->position(crate).y, 0.5f, 0.01f) << "it fell through";
    const BodyId ball = w.add(Circle{{0, 0}, 0.5f}, {.type = BodyType::dynamic, .position = {5, 5}, .linear_velocity = {2, 0}, .enabled = false});
    w->apply_force_to_center(ball, {100, 100});
    w->apply_linear_impulse_to_center(ball, {100, 100});
    w.step(60);
    EXPECT_EQ(w->position(ball), (Vec2{5, 5}));
    EXPECT_EQ(w->linear_velocity(ball), (Vec2{2, 0})) << "velocity is kept";
    w->set_transform(ball, {0, 4}, 0);
    w->set_enabled(shelf, true);
    w->set_enabled(ball, true);
    w->set_linear_velocity(ball, {0, 0});
    EXPECT_EQ(w->validate(), nullptr);
    w.step(60);
    EXPECT_NEAR(w->position(ball).y, 3.6f, 0.01f) << "the shelf is solid again";
    EXPECT_EQ(w->body_count(), 4u);
}

TEST(Disabled, ItsJointsHoldNobodyUntilItIsBack) {
    for (const JointType type : joint_types) {
        if (type == JointType::gear || type == JointType::mouse) continue;
        TestWorld w;
        const BodyId hook = w.add_box({0, 0}, 0.2f, 0.2f, {}, BodyType::static_body), weight = w.add_box({0, -1}, 0.2f, 0.2f);
        ASSERT_TRUE(join(*w, type, hook, weight)) << name_of(type);
        w.step(10);
        w->set_enabled(hook, false);
        EXPECT_EQ(w->validate(), nullptr) << name_of(type);
        const float before = w->position(weight).y, speed = w->linear_velocity(weight).y;
        w.step(60);
        const float way = -0.5f * 10 * (1 + 1.0f / 240);  // in a second of substeps of 1/240 s
        EXPECT_NEAR(w->position(weight).y, before + speed + way, 0.002f) << name_of(type) << ": it falls freely";
        EXPECT_EQ(w->report().awake_joints, 0u);
        EXPECT_EQ(w->joint_count(), 1u);
        w->set_enabled(hook, true);
        EXPECT_EQ(w->validate(), nullptr) << name_of(type);
        w.step();
        EXPECT_EQ(w->report().awake_joints, 1u) << name_of(type);
    }
}

TEST(Disabled, RandomComingAndGoingKeepsTheWorldSound) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        TestWorld w;
        Random random(seed);
        w.add_ground();
        add_machine(*w, {0, 3});
        for (int i = 0; i < 25; ++i) w.add_box({random.between(-6, 6), random.between(0.5f, 8)}, 0.3f, 0.3f, {.sensor = random.one_in(4)});
        for (int step = 0; step < 300; ++step) {
            const std::vector<BodyId> all = w.bodies();
            const BodyId body = all[random.below(static_cast<std::uint32_t>(all.size()))];
            switch (random.below(12)) {
            case 0:
            case 1:
            case 2: w->set_enabled(body, false); break;
            case 3:
            case 4:
            case 5: w->set_enabled(body, true); break;
            case 6: w->lock_x(body, random.one_in(2)); break;
            case 7: w->set_type(body, static_cast<BodyType>(random.below(3))); break;
            case 8: w->set_transform(body, {random.between(-6, 6), random.between(0, 8)}, 1); break;
            case 9: w->wake(body); break;
            case 10: w->create_shape(body, Circle{{0, 0}, 0.3f}); break;
            default: break;
            }
            w.step();
            ASSERT_EQ(w->validate(), nullptr) << "seed " << seed << ", step " << step;
            ASSERT_TRUE(w.is_finite());
            if (step % 50 != 0) continue;
            TestWorld twin;
            ASSERT_TRUE(twin->load(save(*w).bytes())) << describe(twin->last_error());
            twin.step();
            World& original = *w;
            const Image here = save(original);
            original.step(1.0f / 60);
            EXPECT_EQ(twin->hash(), original.hash());
            ASSERT_TRUE(original.restore(here.bytes()));
        }
    }
}

TEST(SleepThreshold, DecidesWhoFallsAsleep) {
    TestWorld w(roomy, {.gravity = {0, 0}});
    const BodyId ball = w.add_circle({0, 0});
    w->set_linear_velocity(ball, {0.2f, 0});
    EXPECT_EQ(w->sleep_threshold(ball), 0.05f);
    w.step(60);
    EXPECT_TRUE(w->is_awake(ball));
    w->set_sleep_threshold(ball, 0.3f);
    EXPECT_EQ(w->sleep_threshold(ball), 0.3f);
    w.step(60);
    EXPECT_FALSE(w->is_awake(ball));
}

}  // namespace
}  // namespace islet::test
