// What scenes measure of joints, and prefabs: the scene side's formulas agree with the world's own, and a ragdoll can be used on a bare World.
#include <gtest/gtest.h>

#include <vector>

#include "harness/engine.hpp"
#include "harness/joint_measure.hpp"
#include "scenes/benchmark_doll.hpp"
#include "scenes/build.hpp"
#include "support/test_world.hpp"

namespace islet::test {
namespace {

using namespace islet::samples;

/// Every type of joint, each between the ground or a first body and a second one, all turned and moving, so that every joint is off a little.
Scene every_joint() {
    Scene scene;
    const std::size_t ground = add_body(scene, {}, {});
    ShapeDef ghost;
    ghost.filter.mask = 0;
    const auto add = [&](float x, float y, float angle) { return add_dynamic(scene, {x, y}, make_box(0.5f, 0.3f), ghost, angle); };
    const auto next = [&](float x) { return std::pair{add(x, 0, 0.3f), add(x + 1.2f, 0.1f, -0.2f)}; };

    const auto [h1, h2] = next(0);
    RevoluteJointDef hinge = hinge_at(scene, h1, h2, {0.6f, 0});
    hinge.limit = {.enable = true, .lower = -0.1f, .upper = 0.1f};
    add_joint(scene, h1, h2, hinge);
    const auto [s1, s2] = next(4);
    PrismaticJointDef slider = slider_at(scene, s1, s2, {4.6f, 0}, {1, 0.5f});
    slider.limit = {.enable = true, .lower = -0.1f, .upper = 0.1f};
    add_joint(scene, s1, s2, slider);
    const auto [w1, w2] = next(8);
    add_joint(scene, w1, w2, wheel_at(scene, w1, w2, {8.6f, 0}, {0, 1}));
    const auto [r1, r2] = next(12);
    add_joint(scene, r1, r2, rod_between(scene, r1, r2, {12, 0.2f}, {13, 0}));
    const auto [e1, e2] = next(16);
    add_joint(scene, e1, e2, rope_between(scene, e1, e2, {16, 0.2f}, {17, 0}));
    const auto [g1, g2] = next(20);
    add_joint(scene, g1, g2, weld_at(scene, g1, g2, {20.6f, 0}));
    const auto [p1, p2] = next(24);
    PulleyJointDef pulley = pulley_over(scene, p1, p2, {24, 0.2f}, {24, 3}, {25, 3}, {25, 0.2f});
    pulley.ratio = 2;
    add_joint(scene, p1, p2, pulley);
    const std::size_t a = add(28, 0, 0), b = add(30, 0, 0);
    const std::size_t axle_a = add_joint(scene, ground, a, hinge_at(scene, ground, a, {28, 0}));
    const std::size_t axle_b = add_joint(scene, ground, b, hinge_at(scene, ground, b, {30.2f, 0}));
    add_gear(scene, axle_a, axle_b, 1.5f);

    for (std::size_t i = 1; i < scene.bodies.size(); ++i) {
        const auto k = static_cast<float>(i % 3);
        scene.bodies[i].def.linear_velocity = {3 - 2 * k, k - 1};
        scene.bodies[i].def.angular_velocity = 4 * (k - 1);
    }
    return scene;
}

TEST(JointMeasure, TheScenesFormulasGiveTheWorldsErrors) {
    const Scene scene = every_joint();
    IsletEngine engine;
    engine.load(scene);
    const World& world = engine.world();
    ASSERT_EQ(world.joint_count(), scene.joints.size());
    for (int step = 0; step < 40; ++step) {
        engine.advance(scene, step, scene.dt);
        for (std::uint32_t i = 0; i < scene.joints.size(); ++i) {
            // Joints of a fresh world lie in the order they were made.
            const JointError ours = engine.joint_error(i), own = world.joint_error(world.joint_at(i));
            EXPECT_NEAR(ours.linear, own.linear, 2e-5f) << "joint " << i << ", step " << step;
            EXPECT_NEAR(ours.angular, own.angular, 2e-5f) << "joint " << i << ", step " << step;
        }
    }
    EXPECT_GT(engine.max_joint_error().linear, 0);
}

TEST(JointMeasure, TheScenesAnchorsAreTheWorlds) {
    const Scene scene = every_joint();
    IsletEngine engine;
    engine.load(scene);
    for (int step = 0; step < 10; ++step) engine.advance(scene, step, scene.dt);
    const World& world = engine.world();
    for (std::uint32_t i = 0; i < scene.joints.size(); ++i) {
        const JointId id = world.joint_at(i);
        if (world.joint_type(id) == JointType::gear) continue;
        const Anchors anchors = anchors_of(engine, i);
        EXPECT_LT(distance(anchors.a, world.anchor_a(id)), 1e-5f) << "joint " << i;
        EXPECT_LT(distance(anchors.b, world.anchor_b(id)), 1e-5f) << "joint " << i;
    }
}

TEST(JointMeasure, JointsMadeFromTheWorldStartWithoutError) {
    const Scene scene = every_joint();
    IsletEngine engine;
    engine.load(scene);
    EXPECT_LT(engine.max_joint_error().linear, 1e-5f);
    EXPECT_LT(engine.max_joint_error().angular, 1e-6f);
    EXPECT_NEAR(engine.joint_position(0), 0, 1e-6f);
    EXPECT_NEAR(engine.joint_position(1), 0, 1e-6f);
}

TEST(JointMeasure, IndicesStayWhenJointsGo) {
    Scene scene = every_joint();
    scene.extra_joints = 1;
    IsletEngine engine;
    engine.load(scene);
    const std::size_t count = scene.joints.size();
    engine.destroy_joint(1);
    EXPECT_FALSE(engine.joint_exists(1));
    engine.destroy_body(scene.joints[3].body_b);
    EXPECT_FALSE(engine.joint_exists(3)) << "a joint goes with its body";
    engine.destroy_joint(count - 2);
    EXPECT_FALSE(engine.joint_exists(count - 1)) << "a gear goes with its joint";
    EXPECT_EQ(engine.joint_slots(), count);
    EXPECT_EQ(engine.create_joint(scene.joints[1]), count);
    EXPECT_TRUE(engine.joint_exists(count));
    EXPECT_EQ(engine.counts().joints, count - 4 + 1);
}

TEST(Prefab, ARagdollStandsTogetherInAWorldOfYourOwn) {
    TestWorld world({.bodies = 64, .shapes = 64, .contacts = 256, .joints = 32});
    world.add_ground();
    const PrefabIds doll = spawn(*world, make_benchmark_doll({.position = {0, 0.1f}}));
    ASSERT_EQ(doll.bodies.size(), bone_count);
    ASSERT_EQ(doll.joints.size(), bone_count - 1);
    for (const JointId joint : doll.joints) EXPECT_LT(world->joint_error(joint).linear, 1e-6f);
    const float hip = world->position(doll.bodies[static_cast<std::size_t>(Bone::hip)]).y;
    EXPECT_NEAR(hip, 0.1f + 0.95f, 1e-6f);

    for (int i = 0; i < 300; ++i) world->step(1.0f / 60);
    for (const JointId joint : doll.joints) {
        EXPECT_LT(world->joint_error(joint).linear, 0.01f);
        EXPECT_LT(world->joint_error(joint).angular, 0.1f);
    }
    EXPECT_TRUE(world.errors.empty());

    destroy(*world, doll);
    EXPECT_EQ(world->joint_count(), 0u);
    EXPECT_EQ(world->body_count(), 1u);
    EXPECT_EQ(world->validate(), nullptr);
}

TEST(Prefab, TheSameRagdollInASceneAndInAScript) {
    const Prefab doll = make_benchmark_doll({});
    Scene scene;
    add_body(scene, {}, {});
    const Placed first = add_prefab(scene, doll);
    EXPECT_EQ(first.first_body, 1u);
    EXPECT_EQ(scene.joints[0].body_b, 2u);
    scene.extra_bodies = bone_count;
    scene.extra_joints = bone_count - 1;
    scene.extra_shapes = bone_count + 2;
    IsletEngine engine;
    engine.load(scene);
    const Placed second = create_prefab(engine, doll);
    EXPECT_EQ(second.first_body, 1 + bone_count);
    EXPECT_EQ(second.first_joint, bone_count - 1);
    EXPECT_EQ(engine.counts().joints, 2 * (bone_count - 1));
    for (std::size_t i = 0; i < bone_count; ++i)
        EXPECT_EQ(engine.body(second.first_body + i).mass, engine.body(first.first_body + i).mass) << "bone " << i;
}

}  // namespace
}  // namespace islet::test
