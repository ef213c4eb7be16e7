// How joints in Chipmunk are made, break, sleep and go, and which cannot be made.
#include <gtest/gtest.h>

#include "chipmunk_fixture.hpp"
#include "scenes/catalogue.hpp"

namespace islet::test {
namespace {

TEST_F(ChipmunkJoints, OverloadedJointsBreak) {
    for (const float x : {0.0f, 2.0f, 4.0f, 6.0f}) add(dynamic({x, 0}, make_box(0.5f, 0.5f)));  // 1 kg each
    const auto weld = [this](std::size_t body, float force, float torque) {
        JointBase base = {.break_force = force, .break_torque = torque};
        base.frame_a.position = scene.bodies[body].def.position - Vec2{0.5f, 0};
        base.frame_b.position = {-0.5f, 0};
        join(0, body, WeldJointDef{.base = base});
    };
    weld(1, 11, 0);  // it needs 10 N and 5 N m
    weld(2, 9, 0);
    weld(3, 0, 6);
    weld(4, 0, 4);
    load();
    step(60);
    EXPECT_TRUE(engine->joint_exists(0));
    EXPECT_FALSE(engine->joint_exists(1));
    EXPECT_TRUE(engine->joint_exists(2));
    EXPECT_FALSE(engine->joint_exists(3));
    EXPECT_LT(engine->body(2).position.y, -1);
    EXPECT_EQ(engine->counts().joints, 2u);
}

TEST_F(ChipmunkJoints, BodiesOfAJointCollideOnlyIfTold) {
    scene.world.gravity = {0, 0};
    for (const bool collide : {false, true}) {
        scene.bodies.resize(1);
        scene.joints.clear();
        add(dynamic({0, 0}, make_box(0.5f, 0.5f)));
        add(dynamic({0.8f, 0}, make_box(0.5f, 0.5f)));
        join(1, 2, DistanceJointDef{.base = {.collide_connected = collide}, .limit = {.enable = true, .lower = 0, .upper = 5}});
        load();
        step(60);
        EXPECT_EQ(engine->counts().contacts, collide ? 1u : 0u);
        EXPECT_NEAR(position(), collide ? 1 : 0.8f, 0.02f);
    }
}

// A chain of three on the ground body; the middle one goes, then the ground itself.
TEST_F(ChipmunkJoints, ABodyTakesItsJointsAndTheirGearsWithIt) {
    const std::size_t left = add_wheel({-2, 0}), right = add_wheel({2, 0});
    const std::size_t gear = join(left, right, GearJointDef{});
    const std::size_t hung = join(1, add(dynamic({-2, -2}, Circle{})), DistanceJointDef{.base = {}, .length = 2});
    const std::size_t loose = join(2, add(dynamic({2, -2}, Circle{})), DistanceJointDef{.spring = {.enable = true}});
    const std::size_t held = join(0, 3, MouseJointDef{.target = {-2, -2}, .max_force = 1});
    load();
    EXPECT_EQ(engine->counts().joints, 6u);
    step(10);
    engine->destroy_body(1);
    EXPECT_FALSE(engine->joint_exists(left));
    EXPECT_FALSE(engine->joint_exists(gear));
    EXPECT_FALSE(engine->joint_exists(hung));
    for (const std::size_t joint : {right, loose, held}) EXPECT_TRUE(engine->joint_exists(joint));
    step(10);
    engine->destroy_body(0);
    EXPECT_FALSE(engine->joint_exists(right));
    engine->destroy_body(2);
    EXPECT_FALSE(engine->joint_exists(loose));
    EXPECT_EQ(engine->counts().joints, 1u);
    const std::size_t again = engine->create_joint({3, 4, DistanceJointDef{.length = 4}});
    step(10);
    EXPECT_EQ(again, 6u);
    EXPECT_TRUE(engine->joint_exists(again));
    EXPECT_FALSE(engine->joint_exists(again + 1));
}

// What sleeps together with its joints wakes, changes and goes without a trace.
TEST_F(ChipmunkJoints, SleepersKeepTheirJoints) {
    scene.world.enable_sleep = true;
    add(dynamic({0, -2}, make_box(0.5f, 0.5f)));
    add(dynamic({0, -4}, make_box(0.5f, 0.5f)));
    const std::size_t upper = join(0, 1, DistanceJointDef{.length = 2}), lower = join(1, 2, DistanceJointDef{.length = 2});
    load();
    step(180);
    EXPECT_FALSE(engine->body(1).awake);
    EXPECT_TRUE(engine->joint_exists(upper));
    EXPECT_NEAR(engine->joint_force(lower).y, 10, 0.05f);
    engine->destroy_joint(lower);
    step(30);
    EXPECT_LT(engine->body(2).position.y, -4.5f);
    EXPECT_NEAR(engine->body(1).position.y, -2, 0.01f);
    step(180);
    load();  // the engine lets go of the sleeper and its joint
    EXPECT_EQ(engine->counts().joints, 2u);
}

TEST_F(ChipmunkJoints, WhatIsMissingIsSaid) {
    add(dynamic({}, Circle{}));
    add(dynamic({2, 0}, Circle{}));
    const JointSpring soft = {.enable = true, .hertz = 2, .damping_ratio = 1}, stiff = {.enable = true, .hertz = 20, .damping_ratio = 1};
    const JointMotor drive = {.enable = true, .speed = 1, .max_force = 1};
    const struct {
        JointDef def;
        const char* what;
    } cases[] = {{PulleyJointDef{}, "pulleys"},
                 {MotorJointDef{}, "motor joints"},
                 {WeldJointDef{.angular_hertz = 2}, "welds that give way"},
                 {DistanceJointDef{.motor = drive}, "motors on rods"},
                 {PrismaticJointDef{.spring = soft}, "springs on sliders"},
                 {PrismaticJointDef{.motor = drive}, "motors on sliders"},
                 {PrismaticJointDef{.friction = 1}, "friction on sliders"},
                 {RevoluteJointDef{.spring = stiff}, "springs that swing so fast with steps so long"},
                 {RevoluteJointDef{.spring = soft, .motor = drive, .friction = 1}, nullptr},
                 {WheelJointDef{.spring = soft, .motor = drive, .friction = 1}, nullptr}};
    for (const auto& [def, what] : cases) {
        scene.joints.clear();
        join(1, 2, def);
        EXPECT_EQ(lacks(), what != nullptr ? std::string("Chipmunk 7 has no ") + what : "");
    }
    scene.joints.clear();
    join(join(0, 1, RevoluteJointDef{}), join(1, 2, RevoluteJointDef{}), GearJointDef{});
    EXPECT_EQ(lacks(), "Chipmunk 7 has no gears but between hinges on static bodies");
}

// Ragdolls fall by columns. The scene destroys none before all 40 columns are there, at step 320: here the test does.
TEST_F(ChipmunkJoints, RainMakesAndDestroysRagdolls) {
    scene = find_scene("rain")->make();
    ASSERT_EQ(lacks(), "");
    load();
    IsletEngine islet;
    islet.load(scene);
    EXPECT_EQ(engine->counts().joints, islet.counts().joints);
    const std::size_t dolls = engine->counts().joints;
    step(50);
    EXPECT_EQ(engine->counts().joints, 7 * dolls);  // a column each 8 steps
    EXPECT_LT(engine->max_joint_error().linear, 0.1f);
    for (std::size_t i = 1; i < engine->body_slots(); i += 2) engine->destroy_body(i);
    EXPECT_LT(engine->counts().joints, 7 * dolls);
    for (int i = 0; i < 10; ++i) engine->advance({}, i, scene.dt);
    for (std::size_t i = 2; i < engine->body_slots(); i += 2) engine->destroy_body(i);
    EXPECT_EQ(engine->counts().joints, 0u);
    EXPECT_EQ(engine->counts().bodies, 1u);
}

}  // namespace
}  // namespace islet::test
