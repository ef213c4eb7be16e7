// The two adapters mean the same by a scene: masses, centres, velocities, forces, ids, and sizes in spite of Box2D's skin.
#include <gtest/gtest.h>

#include "compare/measure.hpp"
#include "engines/box2d_engine.hpp"

namespace {

using namespace islet;
using namespace islet::compare;
using namespace islet::engines;
using samples::BodyState;
using samples::IsletEngine;
using samples::Scene;
using samples::SceneBody;
using samples::SceneGeometry;

SceneBody dynamic(Vec2 position, SceneGeometry geometry, float density = 1) {
    SceneBody body;
    body.def.type = BodyType::dynamic;
    body.def.position = position;
    body.shapes.push_back({geometry, ShapeDef{.density = density}});
    return body;
}

SceneBody fixed(SceneGeometry geometry) {
    SceneBody body;
    body.shapes.push_back({geometry, {}});
    return body;
}

/// Both engines with the same scene loaded.
struct Pair {
    Scene scene;
    IsletEngine islet;
    Box2dEngine box2d;

    explicit Pair(Scene s, const Box2dOptions& options = {}) : scene(std::move(s)), box2d(options) {
        islet.load(scene);
        box2d.load(scene);
    }
    void run(int steps) {
        for (int i = 0; i < steps; ++i) {
            islet.advance(scene, i, scene.dt);
            box2d.advance(scene, i, scene.dt);
        }
    }
};

TEST(Adapters, MassCentreAndInertiaAreTheSame) {
    const Vec2 corners[] = {{-0.4f, -0.2f}, {0.9f, -0.3f}, {0.5f, 0.7f}, {-0.1f, 0.8f}};
    Scene scene;
    scene.bodies.push_back(dynamic({1, 2}, make_polygon(compute_hull(corners)), 3));
    scene.bodies[0].shapes.push_back({Circle{{1, 0.5f}, 0.3f}, ShapeDef{.density = 5}});
    Pair pair(scene);
    const BodyState a = pair.islet.body(0), b = pair.box2d.body(0);
    EXPECT_NEAR(a.mass, b.mass, 1e-5f * b.mass);
    EXPECT_NEAR(a.inertia, b.inertia, 1e-5f * b.inertia);
    EXPECT_NEAR(a.center.x, b.center.x, 1e-5f);
    EXPECT_NEAR(a.center.y, b.center.y, 1e-5f);
}

// A body is made with its origin as centre of mass; a shape moves the centre, whose velocity follows the turning: v + w x r.
TEST(Adapters, VelocityFollowsTheCentreOfMassAsShapesAreAttached) {
    Scene scene;
    scene.world.gravity = {};
    scene.bodies.push_back(dynamic({}, Circle{{2, 0}, 0.5f}));
    scene.bodies[0].def.linear_velocity = {1, 0};
    scene.bodies[0].def.angular_velocity = 3;
    Pair pair(scene);
    pair.run(60);
    for (const samples::Engine* engine : {static_cast<samples::Engine*>(&pair.islet), static_cast<samples::Engine*>(&pair.box2d)}) {
        EXPECT_NEAR(engine->body(0).center.x, 3, 1e-3f) << engine->name();
        EXPECT_NEAR(engine->body(0).center.y, 6, 1e-3f) << engine->name();
    }
}

TEST(Adapters, FreeFallIsTheSameWithSubstepsOfTheSameLength) {
    Scene scene;
    scene.bodies.push_back(dynamic({0, 100}, make_box(0.5f, 0.5f)));
    Pair pair(scene, {.substeps = static_cast<int>(scene.world.solver.substeps)});
    pair.run(120);
    EXPECT_LT(measure_apart(pair.islet, pair.box2d).max_position, 1e-3);
}

TEST(Adapters, AForceActsForOneStepAndAnImpulseAtOnce) {
    Scene scene;
    scene.world.gravity = {};
    scene.bodies.push_back(dynamic({}, make_box(0.5f, 0.5f)));  // 1 kg
    scene.bodies.push_back(dynamic({5, 0}, make_box(0.5f, 0.5f)));
    scene.before_step = [](samples::Engine& engine, int step) {
        if (step != 0) return;
        engine.apply_force(0, {60, 0});
        engine.apply_impulse(1, {0, 2});
    };
    Pair pair(scene, {.substeps = 4});
    pair.run(3);
    for (const samples::Engine* engine : {static_cast<samples::Engine*>(&pair.islet), static_cast<samples::Engine*>(&pair.box2d)}) {
        EXPECT_NEAR(engine->body(0).linear_velocity.x, 1, 1e-4f) << engine->name();
        EXPECT_NEAR(engine->body(1).linear_velocity.y, 2, 1e-4f) << engine->name();
    }
}

TEST(Adapters, TheSkinInsideKeepsHeights) {
    for (const SceneGeometry& ground : {SceneGeometry(make_offset_box(5, 1, {{0, -1}, {}})), SceneGeometry(Segment{{-5, 0}, {5, 0}}),
                                        SceneGeometry(samples::Chain{{{5, 0}, {0, 0}, {-5, 0}}, false})}) {
        Scene scene;
        scene.bodies.push_back(fixed(ground));
        scene.bodies.push_back(dynamic({0.5f, 0.5f}, make_box(0.5f, 0.5f)));
        scene.bodies.push_back(dynamic({-2, 0.5f}, Circle{{}, 0.5f}));
        Pair pair(scene);
        pair.run(120);
        for (std::size_t i : {1u, 2u}) {
            EXPECT_NEAR(pair.islet.body(i).position.y, 0.5f, 0.006f) << "ground " << ground.index();
            EXPECT_NEAR(pair.box2d.body(i).position.y, 0.5f, 0.006f) << "ground " << ground.index();
        }
    }
}

TEST(Adapters, TheSkinOutsideLiftsABoxByBothSkins) {
    Scene scene;
    scene.bodies.push_back(fixed(make_offset_box(5, 1, {{0, -1}, {}})));
    scene.bodies.push_back(dynamic({0, 0.5f}, make_box(0.5f, 0.5f)));
    Box2dEngine box2d({.skin = Skin::outside});
    box2d.load(scene);
    for (int i = 0; i < 120; ++i) box2d.advance(scene, i, scene.dt);
    EXPECT_NEAR(box2d.body(1).position.y, 0.5f + 0.02f, 0.006f);
}

TEST(Adapters, BodiesMadeAndDestroyedLaterKeepTheirIndices) {
    Scene scene;
    scene.extra_contacts = 16;
    for (int i = 0; i < 4; ++i) scene.bodies.push_back(dynamic({3.0f * static_cast<float>(i), 0}, Circle{{}, 0.5f}));
    scene.before_step = [](samples::Engine& engine, int step) {
        if (step == 1) engine.destroy_body(1);
        if (step == 2) engine.create_body(dynamic({0, 50}, Circle{{}, 0.5f}));
    };
    Pair pair(scene);
    pair.run(4);
    for (const samples::Engine* engine : {static_cast<samples::Engine*>(&pair.islet), static_cast<samples::Engine*>(&pair.box2d)}) {
        EXPECT_EQ(engine->body_slots(), 5u) << engine->name();
        EXPECT_FALSE(engine->exists(1)) << engine->name();
        EXPECT_TRUE(engine->exists(4)) << engine->name();
        EXPECT_EQ(engine->counts().bodies, 4u) << engine->name();
    }
}

TEST(Adapters, WhatBox2dLacksIsSaid) {
    Scene scene;
    scene.bodies.push_back(fixed(make_box(1, 1)));
    EXPECT_EQ(box2d_lacks(scene), "");
    scene.bodies.push_back(dynamic({}, Capsule{{0, 0}, {1, 0}, 0.5f}));
    EXPECT_EQ(box2d_lacks(scene), "Box2D 2.4 has no capsules");
    scene.bodies[1] = dynamic({}, make_rounded_box(0.5f, 0.5f, 0.1f));
    EXPECT_EQ(box2d_lacks(scene), "Box2D 2.4 has no rounded polygons");
}

}  // namespace
