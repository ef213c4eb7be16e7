// The adapter of Box2D 3: what scenes mean in it. Every test skips where Box2D 3 was not there when this was built.
#include <gtest/gtest.h>

#include <cmath>

#include "engines/registry.hpp"
#include "islet/bench.hpp"

namespace {

using namespace islet;
using namespace islet::samples;

constexpr double g = 10;  // m/s^2, a scene's default

SceneBody body_of(BodyType type, Vec2 position, SceneGeometry geometry, const ShapeDef& material = {}) {
    SceneBody body;
    body.def.type = type;
    body.def.position = position;
    body.shapes.push_back({std::move(geometry), material});
    return body;
}

class Box2d3 : public testing::Test {
protected:
    void SetUp() override {
        info = engines::find_engine("box2d3");
        if (info == nullptr) GTEST_SKIP() << "built without Box2D 3";
        engine = info->make();
        scene.world.enable_sleep = false;
        scene.bodies.emplace_back();  // body 0: static, at the origin, without shapes
    }
    std::size_t add(SceneBody body) {
        scene.bodies.push_back(std::move(body));
        return scene.bodies.size() - 1;
    }
    std::size_t add_disc(Vec2 place) { return add(body_of(BodyType::dynamic, place, Circle{{}, 1})); }
    std::size_t add_ground() { return add(body_of(BodyType::static_body, {}, make_offset_box(50, 1, {{0, -1}, {}}))); }
    void join(std::size_t a, std::size_t b, JointDef def) { scene.joints.push_back({a, b, std::move(def)}); }
    void load() { engine->load(scene); }
    void step(int steps) {
        for (int i = 0; i < steps; ++i) engine->advance(scene, step_++, scene.dt);
    }

    const engines::EngineInfo* info = nullptr;
    Scene scene;
    std::unique_ptr<Engine> engine;

private:
    int step_ = 0;
};

// Substeps of h: a fall lasts t, and is g t h / 2 beyond the parabola.
TEST_F(Box2d3, ABodyFalls) {
    const std::size_t ball = add_disc({0, 100});
    load();
    step(60);
    const double t = 60 * double(scene.dt), h = double(scene.dt) / 4;
    EXPECT_NEAR(double(engine->body(ball).linear_velocity.y), -g * t, 1e-3);
    EXPECT_NEAR(double(engine->body(ball).position.y), 100 - g * t * t / 2 - g * t * h / 2, 1e-3);
}

TEST_F(Box2d3, MassIsDensityTimesArea) {
    const std::size_t disc = add_disc({0, 0});
    const std::size_t box = add(body_of(BodyType::dynamic, {5, 0}, make_box(1, 2), {.density = 3}));
    load();
    EXPECT_NEAR(double(engine->body(disc).mass), M_PI, 1e-5);
    EXPECT_NEAR(double(engine->body(disc).inertia), M_PI / 2, 1e-5);
    EXPECT_NEAR(double(engine->body(box).mass), 24, 1e-4);
    EXPECT_NEAR(double(engine->body(box).inertia), 24 * (4 + 16) / 12.0, 1e-4);
}

TEST_F(Box2d3, EveryKindOfShapeRestsOnEveryKindOfGround) {
    for (int kind = 0; kind < 4; ++kind) {
        scene.bodies.resize(1);
        SceneGeometry ground = make_offset_box(50, 1, {{0, -1}, {}});
        if (kind == 1) ground = Segment{{-50, 0}, {50, 0}};
        if (kind == 2) ground = Chain{{{50, 0}, {0, 0}, {-50, 0}}, false};  // solid on the right of its direction: above
        if (kind == 3) ground = HalfSpace{{0, 1}, 0};
        add(body_of(BodyType::static_body, {}, std::move(ground)));
        const std::size_t disc = add_disc({-10, 1});
        const std::size_t capsule = add(body_of(BodyType::dynamic, {-5, 0.5f}, Capsule{{-1, 0}, {1, 0}, 0.5f}));
        const std::size_t box = add(body_of(BodyType::dynamic, {5, 1}, make_box(1, 1)));
        load();
        step(120);
        EXPECT_NEAR(double(engine->body(disc).position.y), 1, 0.01) << "ground " << kind;
        EXPECT_NEAR(double(engine->body(capsule).position.y), 0.5, 0.01) << "ground " << kind;
        EXPECT_NEAR(double(engine->body(box).position.y), 1, 0.01) << "ground " << kind;
        EXPECT_LT(engine->max_penetration(), 0.01);
        EXPECT_GE(engine->counts().contacts, 3u);
        ASSERT_TRUE(engine->contact_force(box).has_value());
        EXPECT_NEAR(double(engine->contact_force(box)->y), 4 * g, 0.1 * 4 * g);
        engine = info->make();
    }
}

TEST_F(Box2d3, CoordinatesOfJointsAreTheScenes) {
    scene.world.gravity = {0, 0};
    RevoluteJointDef hinge;
    hinge.base.frame_a.position = {0, 5};
    hinge.motor = {.enable = true, .speed = 2, .max_force = 1e4f};
    join(0, add_disc({0, 5}), hinge);
    PrismaticJointDef slider;
    slider.base.frame_a = {{0, 10}, 0.5f * pi};
    slider.base.frame_b = {{}, 0.5f * pi};
    slider.motor = {.enable = true, .speed = 1, .max_force = 1e4f};
    join(0, add_disc({0, 10}), slider);
    DistanceJointDef rod;
    rod.length = 3;
    join(0, add_disc({3, 0}), rod);
    WheelJointDef wheel;
    wheel.base.frame_a = {{20, 0}, 0.5f * pi};
    join(0, add_disc({20, 0.5f}), wheel);
    load();
    EXPECT_NEAR(double(engine->joint_position(2)), 3, 1e-4);
    EXPECT_NEAR(double(engine->joint_position(3)), 0.5, 1e-4);
    step(30);
    EXPECT_NEAR(double(engine->joint_speed(0)), 2, 0.01);
    EXPECT_NEAR(double(engine->joint_position(0)), 2 * 0.5, 0.05);
    EXPECT_NEAR(double(engine->joint_speed(1)), 1, 0.01);
    EXPECT_NEAR(double(engine->joint_position(1)), 0.5, 0.05);
    EXPECT_NEAR(double(engine->body(2).position.y), 10.5, 0.05);  // along frame A's x axis, which points up
    EXPECT_NEAR(double(engine->joint_speed(2)), 0, 1e-3);
    EXPECT_LT(engine->max_joint_error().linear, 0.01f);
}

TEST_F(Box2d3, AJointTellsItsForceAndMotor) {
    RevoluteJointDef hinge;
    hinge.base.frame_a.position = {0, 5};
    hinge.friction = 1000;
    const std::size_t disc = add(body_of(BodyType::dynamic, {2, 5}, Circle{{}, 1}));
    hinge.base.frame_b.position = {-2, 0};
    join(0, disc, hinge);
    load();
    step(60);
    EXPECT_NEAR(double(engine->joint_force(0).y), M_PI * g, 0.02 * M_PI * g);
    EXPECT_NEAR(double(engine->motor_force(0)), 2 * M_PI * g, 0.02 * 2 * M_PI * g);  // friction holds the arm up
    EXPECT_NEAR(double(engine->joint_speed(0)), 0, 1e-2);
}

TEST_F(Box2d3, ARopeEndsAFallAndBreaksUnderMore) {
    DistanceJointDef rope;
    rope.base.frame_a.position = {0, 10};
    rope.length = 1;
    rope.limit = {true, 0, 3};
    join(0, add_disc({0, 9}), rope);
    DistanceJointDef thread = rope;
    thread.base.frame_a.position = {10, 10};
    thread.base.break_force = 0.5f * pi * 10;
    join(0, add_disc({10, 9}), thread);
    load();
    step(10);
    EXPECT_GT(engine->joint_position(0), 1.05f);  // it falls within the rope
    step(300);
    EXPECT_NEAR(double(engine->joint_position(0)), 3, 0.02);
    EXPECT_TRUE(engine->joint_exists(0));
    EXPECT_FALSE(engine->joint_exists(1));
}

TEST_F(Box2d3, AMouseJointPullsItsPointToTheTargetAndFollowsIt) {
    scene.world.gravity = {0, 0};
    MouseJointDef mouse;
    mouse.target = {1, 0};
    mouse.max_force = 1000;
    const std::size_t disc = add_disc({0, 0});
    join(0, disc, mouse);
    load();
    step(30);
    EXPECT_NEAR(double(engine->body(disc).position.x), 0, 1e-3);  // the point begins at the target
    engine->set_target(0, {4, 0});
    step(240);
    EXPECT_NEAR(double(engine->body(disc).position.x), 3, 0.05);
}

TEST_F(Box2d3, ADestroyedBodyTakesItsJointsAlong) {
    const std::size_t disc = add_disc({0, 0});
    join(0, disc, RevoluteJointDef{});
    load();
    EXPECT_TRUE(engine->exists(disc));
    EXPECT_EQ(engine->counts().bodies, 2u);
    engine->destroy_body(disc);
    EXPECT_FALSE(engine->exists(disc));
    EXPECT_FALSE(engine->joint_exists(0));
    EXPECT_EQ(engine->counts().bodies, 1u);
    EXPECT_EQ(engine->body_slots(), 2u);
}

TEST_F(Box2d3, ForcesAndImpulsesPush) {
    scene.world.gravity = {0, 0};
    const std::size_t pushed = add_disc({0, 0}), kicked = add_disc({10, 0}), turned = add_disc({20, 0});
    load();
    for (int i = 0; i < 60; ++i) {
        engine->apply_force(pushed, {pi, 0});
        engine->apply_torque(turned, 0.5f * pi);
        step(1);
    }
    engine->apply_impulse(kicked, {0, pi});
    EXPECT_NEAR(double(engine->body(pushed).linear_velocity.x), 1, 1e-3);
    EXPECT_NEAR(double(engine->body(kicked).linear_velocity.y), 1, 1e-3);
    EXPECT_NEAR(double(engine->body(turned).angular_velocity), 1, 1e-3);
}

TEST_F(Box2d3, SaysWhatItLacks) {
    EXPECT_EQ(info->lacks(scene), "");
    scene.joints.push_back({0, 0, GearJointDef{}});
    EXPECT_EQ(info->lacks(scene), "Box2D 3 has no gear");
    scene.joints.clear();
    add(body_of(BodyType::static_body, {}, Circle{{}, 1}, {.sensor = true}));
    EXPECT_EQ(info->lacks(scene), "Box2D 3 has no sensors that tell what overlaps them");
}

TEST_F(Box2d3, RunsTheBenchmarkScenesWithOneWorkerAndWithTwo) {
    for (const SceneInfo& scene_info : catalogue()) {
        if (std::string(scene_info.group) != "benchmark") continue;
        tools::BenchOptions options;
        options.scenes = {&scene_info};
        options.engines = {info};
        options.steps = 1;
        options.repeat = 1;
        options.workers = {1, 2};
        const std::vector<tools::BenchResult> results = tools::bench(options, {.stepped = [](int, int) {}});
        ASSERT_EQ(results.size(), 2u);
        EXPECT_EQ(results[0].lacks, "") << scene_info.name;
        EXPECT_EQ(results[1].workers, 2u);
        EXPECT_EQ(results[0].bodies, scene_info.make().bodies.size()) << scene_info.name;
    }
}

}  // namespace
