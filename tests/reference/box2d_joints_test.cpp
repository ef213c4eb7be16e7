// The two adapters mean the same by a joint: coordinates and their signs, forces, motors, and what becomes of joints whose bodies go.
#include <gtest/gtest.h>

#include <functional>

#include "engines/box2d_engine.hpp"
#include "scenes/build.hpp"

namespace {

using namespace islet;
using namespace islet::engines;
using namespace islet::samples;

ShapeDef ghost() {
    ShapeDef material;
    material.filter.mask = 0;
    return material;
}

/// Both engines with the same scene.
struct JointPair {
    Scene scene;
    IsletEngine islet;
    Box2dEngine box2d;

    explicit JointPair(Scene s) : scene(std::move(s)), box2d({.substeps = 4}) {
        islet.load(scene);
        box2d.load(scene);
    }
    void run(int steps) {
        for (int i = 0; i < steps; ++i) {
            islet.advance(scene, i, scene.dt);
            box2d.advance(scene, i, scene.dt);
        }
    }
    void each(const std::function<void(Engine&)>& see) {
        for (Engine* engine : {static_cast<Engine*>(&islet), static_cast<Engine*>(&box2d)}) {
            SCOPED_TRACE(engine->name());
            see(*engine);
        }
    }
};

/// A ground without shapes, and a box of 2 kg that hangs from it at the origin by a joint.
template <class Make>
Scene hanging(const Make& make) {
    Scene scene;
    scene.world.enable_sleep = false;
    add_body(scene, {}, {});
    add_dynamic(scene, {0, -1}, make_box(1, 0.5f), ghost());
    add_joint(scene, 0, 1, make(scene));
    return scene;
}

TEST(JointAdapters, WhatHangsAtRestPullsWithItsWeight) {
    const std::function<JointDef(const Scene&)> makers[] = {
        [](const Scene& s) {
            return hinge_at(s, 0, 1, {0, 0});
        },
        [](const Scene& s) {
            return weld_at(s, 0, 1, {0, 0});
        },
        [](const Scene& s) {
            return rod_between(s, 0, 1, {0, 0}, {0, -1});
        },
        [](const Scene& s) {
            return rope_between(s, 0, 1, {0, 0}, {0, -1});
        },
        [](const Scene& s) {
            PrismaticJointDef def = slider_at(s, 0, 1, {0, 0}, {0, 1});
            def.limit.enable = true;
            return def;
        },
        [](const Scene& s) {
            WheelJointDef def = wheel_at(s, 0, 1, {0, 0}, {0, 1});
            def.spring.enable = false;
            def.limit.enable = true;
            return def;
        },
        [](const Scene&) {
            MouseJointDef def;
            def.target = {0, -1};
            def.max_force = 1000;
            return def;
        },
    };
    for (std::size_t i = 0; i < std::size(makers); ++i) {
        SCOPED_TRACE("joint " + std::to_string(i));
        JointPair pair(hanging(makers[i]));
        pair.run(120);
        pair.each([](Engine& engine) {
            EXPECT_NEAR(engine.joint_force(0).x, 0, 0.05f);
            EXPECT_NEAR(engine.joint_force(0).y, 20, 0.2f);
        });
    }
}

TEST(JointAdapters, APulleyTellsThePullOnItsSecondBody) {
    Scene scene;
    scene.world.enable_sleep = false;
    add_body(scene, {}, {});
    add_dynamic(scene, {-1, 0}, make_box(1, 0.5f), ghost());
    add_dynamic(scene, {1, 0}, make_box(1, 1), ghost());
    PulleyJointDef pulley = pulley_over(scene, 1, 2, {-1, 0}, {-1, 4}, {1, 4}, {1, 0});
    pulley.ratio = 2;  // 4 kg on the double rope and 2 kg on the single one are in balance
    add_joint(scene, 1, 2, pulley);
    JointPair pair(scene);
    pair.run(60);
    pair.each([](Engine& engine) {
        EXPECT_NEAR(engine.joint_force(0).y, 40, 0.4f);
        EXPECT_NEAR(engine.body(2).position.y, 0, 0.01f);
        EXPECT_LT(engine.joint_error(0).linear, 0.002f);
    });
}

TEST(JointAdapters, CoordinatesHaveTheSameSigns) {
    Scene scene;
    scene.world.gravity = {};
    add_body(scene, {}, {});
    const auto add = [&](Vec2 place, Vec2 velocity, float spin) {
        BodyDef def;
        def.type = BodyType::dynamic;
        def.position = place;
        def.angle = 0.7f;
        def.linear_velocity = velocity;
        def.angular_velocity = spin;
        return add_body(scene, def, {{make_box(0.5f, 0.5f), ghost()}});
    };
    const std::size_t turning = add({0, 0}, {}, 2), sliding = add({5, 0}, {0.6f, 0.8f}, 0), strut = add({10, 0}, {0, -1}, 0);
    const std::size_t away = add({15, 0}, {1, 0}, 0);
    add_joint(scene, 0, turning, hinge_at(scene, 0, turning, {0, 0}));
    add_joint(scene, 0, sliding, slider_at(scene, 0, sliding, {5, 0}, {3, 4}));
    WheelJointDef wheel = wheel_at(scene, 0, strut, {10, 0}, {0, 2});
    wheel.spring.enable = false;
    add_joint(scene, 0, strut, wheel);
    DistanceJointDef rope = rope_between(scene, 0, away, {13, 0}, {15, 0});
    rope.limit.upper = 10;
    add_joint(scene, 0, away, rope);
    JointPair pair(scene);
    pair.run(30);  // half a second
    pair.each([](Engine& engine) {
        EXPECT_NEAR(engine.joint_position(0), 1, 1e-3f);
        EXPECT_NEAR(engine.joint_speed(0), 2, 1e-3f);
        EXPECT_NEAR(engine.joint_position(1), 0.5f, 1e-3f);
        EXPECT_NEAR(engine.joint_speed(1), 1, 1e-3f);
        EXPECT_NEAR(engine.joint_position(2), -0.5f, 1e-3f);
        EXPECT_NEAR(engine.joint_speed(2), -1, 1e-3f);
        EXPECT_NEAR(engine.joint_position(3), 2.5f, 1e-3f);
        EXPECT_NEAR(engine.joint_speed(3), 1, 1e-3f);
    });
}

TEST(JointAdapters, MotorsLimitsAndTargetsCanBeSetWhileRunning) {
    Scene scene;
    scene.world.gravity = {};
    add_body(scene, {}, {});
    add_dynamic(scene, {0, 0}, make_box(0.5f, 0.5f), ghost());
    add_dynamic(scene, {5, 0}, make_box(0.5f, 0.5f), ghost());
    add_dynamic(scene, {10, 0}, make_box(0.5f, 0.5f), ghost());
    add_joint(scene, 0, 1, hinge_at(scene, 0, 1, {0, 0}));
    PrismaticJointDef slider = slider_at(scene, 0, 2, {5, 0}, {1, 0});
    slider.motor = {.enable = true, .speed = 1, .max_force = 100};
    add_joint(scene, 0, 2, slider);
    MouseJointDef mouse;
    mouse.target = {10, 0};
    mouse.max_force = 1000;
    add_joint(scene, 0, 3, mouse);
    scene.before_step = [](Engine& engine, int step) {
        if (step != 0) return;
        engine.set_motor(0, {.enable = true, .speed = -3, .max_force = 100});
        engine.set_limit(1, {.enable = true, .lower = 0, .upper = 0.5f});
        engine.set_target(2, {11, 2});
    };
    JointPair pair(scene);
    pair.run(120);
    pair.each([](Engine& engine) {
        EXPECT_NEAR(engine.joint_speed(0), -3, 1e-3f);
        EXPECT_NEAR(engine.joint_position(1), 0.5f, 0.01f);
        EXPECT_NEAR(engine.motor_force(1), 100, 1);  // it pushes on against the limit
        EXPECT_NEAR(engine.body(3).position.x, 11, 0.01f);
        EXPECT_NEAR(engine.body(3).position.y, 2, 0.01f);
        EXPECT_LT(engine.joint_error(1).linear, 0.01f) << "measured against the limit that was set";
    });
}

TEST(JointAdapters, JointsGoWithTheirBodiesAndGearsWithTheirJoints) {
    Scene scene;
    add_body(scene, {}, {});
    for (int i = 0; i < 3; ++i) add_dynamic(scene, {3.0f * static_cast<float>(i), 0}, make_box(0.5f, 0.5f), ghost());
    for (std::size_t i = 1; i < 4; ++i) add_joint(scene, 0, i, hinge_at(scene, 0, i, scene.bodies[i].def.position));
    add_gear(scene, 0, 1, 1);
    add_gear(scene, 1, 2, 1);
    JointPair pair(scene);
    pair.each([](Engine& engine) {
        EXPECT_EQ(engine.counts().joints, 5u);
        engine.destroy_joint(0);
        EXPECT_FALSE(engine.joint_exists(0));
        EXPECT_FALSE(engine.joint_exists(3));
        EXPECT_TRUE(engine.joint_exists(4));
        engine.destroy_body(3);
        EXPECT_FALSE(engine.joint_exists(2));
        EXPECT_FALSE(engine.joint_exists(4));
        EXPECT_TRUE(engine.joint_exists(1));
        EXPECT_EQ(engine.counts().joints, 1u);
    });
    pair.run(5);
}

TEST(JointAdapters, AJointBreaksUnderMoreThanItStands) {
    for (const bool breaks : {false, true}) {
        Scene scene = hanging([&](const Scene& s) {
            RevoluteJointDef def = hinge_at(s, 0, 1, {0, 0});
            def.base.break_force = breaks ? 15.0f : 25.0f;  // the box weighs 20 N
            return def;
        });
        JointPair pair(scene);
        pair.run(60);
        pair.each([&](Engine& engine) { EXPECT_EQ(engine.joint_exists(0), !breaks); });
    }
}

// The frequency is that of the spring with what it really moves: 2 s of swinging at 2 Hz come back to the start.
TEST(JointAdapters, AStrutSwingsAtItsFrequency) {
    Scene scene;
    scene.world.gravity = {};
    add_body(scene, {}, {});
    add_dynamic(scene, {0, 0}, make_box(0.5f, 0.5f), ghost());
    WheelJointDef wheel = wheel_at(scene, 0, 1, {0, 0}, {0, 1});
    wheel.spring = {.enable = true, .hertz = 2, .damping_ratio = 0};
    add_joint(scene, 0, 1, wheel);
    scene.bodies[1].def.position = {0, 0.2f};
    JointPair pair(scene);
    pair.run(15);  // half a period
    pair.each([](Engine& engine) { EXPECT_NEAR(engine.body(1).position.y, -0.2f, 0.03f); });
}

TEST(JointAdapters, WhatBox2dLacksIsSaid) {
    Scene scene;
    add_body(scene, {}, {});
    add_dynamic(scene, {0, 0}, make_box(0.5f, 0.5f), ghost());
    const auto lacks = [&](JointDef def) {
        scene.joints.clear();
        add_joint(scene, 0, 1, std::move(def));
        return box2d_lacks(scene);
    };
    EXPECT_EQ(lacks(RevoluteJointDef{}), "");
    EXPECT_EQ(lacks(RevoluteJointDef{.friction = 1}), "");
    EXPECT_EQ(lacks(RevoluteJointDef{.spring = {.enable = true, .hertz = 1}}), "Box2D 2.4 has no spring on a hinge");
    EXPECT_EQ(lacks(PrismaticJointDef{.spring = {.enable = true, .hertz = 1}}), "Box2D 2.4 has no spring on a slider");
    EXPECT_EQ(lacks(DistanceJointDef{.motor = {.enable = true}}), "Box2D 2.4 has no motor on a rod");
    EXPECT_EQ(lacks(WeldJointDef{.linear_hertz = 1}), "Box2D 2.4 has no weld that gives way sideways");
    EXPECT_EQ(lacks(WeldJointDef{.angular_hertz = 1}), "");
    EXPECT_EQ(lacks(MotorJointDef{.max_force = 1}), "");
    EXPECT_EQ(lacks(MotorJointDef{.linear_velocity = {1, 0}}), "Box2D 2.4 has no motor joint that drives a velocity");
}

}  // namespace
