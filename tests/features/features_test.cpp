// The list of features in islet/config.hpp: each name is a CMake option, stands in the manual, and is refused in a build that leaves it out. (This program's
// engine leaves out all of them.)
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string>

#include <islet/islet.hpp>
#include <islet/mover.hpp>
#include <islet/snapshot.hpp>

#include "../../engine/src/data/core.hpp"
#include "../../engine/src/data/features.hpp"
#include "support/engine_sources.hpp"

namespace {

using namespace islet;

std::set<std::string> listed_features() {
    std::set<std::string> names = {"joints"};
#define ISLET_NAME(name, ...) names.insert(#name);
    ISLET_FEATURES(ISLET_NAME)
#undef ISLET_NAME
#define ISLET_NAME(type, definition) names.insert(#type "_joints");
    ISLET_JOINT_TYPES(ISLET_NAME)
#undef ISLET_NAME
    return names;
}

// How a feature is named: -DISLET_WITHOUT_x, or a line of a header.
#define ISLET_WITHOUT_named_as_one 1
#define ISLET_WITHOUT_named_as_nothing
#define ISLET_WITHOUT_not_meant 0
static_assert(ISLET_IS_SET(ISLET_WITHOUT_named_as_one) == 1);
static_assert(ISLET_IS_SET(ISLET_WITHOUT_named_as_nothing) == 1);
static_assert(ISLET_IS_SET(ISLET_WITHOUT_not_meant) == 0);
static_assert(ISLET_IS_SET(ISLET_WITHOUT_not_named) == 0);

struct Attempt {
    World& world;
    BodyId body, other;
    ShapeId ball;
    JointBase base = {.body_a = body, .body_b = other};
};

/// What asks for a feature; true if the call says that it failed.
using Ask = std::function<bool(Attempt&)>;

const std::map<std::string, Ask>& asks() {
    static const std::map<std::string, Ask> table = {
        {"polygons", [](Attempt& a) { return !a.world.create_shape(a.body, make_box(1, 1)); }},
        {"hulls",
         [](Attempt& a) {
             constexpr Vec2 corners[] = {{0, 0}, {1, 0}, {0, 1}};
             return !a.world.create_shape(a.body, make_polygon(compute_hull(corners)));
         }},
        {"capsules",
         [](Attempt& a) {
             return !a.world.create_shape(a.body, Capsule{{0, 0}, {1, 0}, 1});
         }},
        {"segments",
         [](Attempt& a) {
             return !a.world.create_shape(a.body, Segment{{0, 0}, {1, 0}});
         }},
        {"half_spaces", [](Attempt& a) { return !a.world.create_shape(a.body, HalfSpace{}); }},
        {"chains",
         [](Attempt& a) {
             return !a.world.create_shape(a.body, ChainSegment{{-1, 0}, {{0, 0}, {1, 0}}, {2, 0}});
         }},
        {"restitution",
         [](Attempt& a) {
             return !a.world.create_shape(a.body, Circle{{}, 1}, {.restitution = 1});
         }},
        {"surfaces",
         [](Attempt& a) {
             return !a.world.create_shape(a.body, Circle{{}, 1}, {.tangent_speed = 1});
         }},
        {"sleep", [](Attempt& a) { return !a.world.create_body({.type = BodyType::dynamic, .awake = false}); }},
        {"continuous", [](Attempt& a) { return a.world.enable_continuous(true), !a.world.continuous(); }},
        {"seamless_floors", [](Attempt& a) { return a.world.enable_seamless_floors(true), !a.world.seamless_floors(); }},
        {"bullets", [](Attempt& a) { return !a.world.create_body({.type = BodyType::dynamic, .bullet = true}); }},
        {"sensors",
         [](Attempt& a) {
             return !a.world.create_shape(a.body, Circle{{}, 1}, {.sensor = true});
         }},
        {"hits",
         [](Attempt& a) {
             return !a.world.create_shape(a.body, Circle{{}, 1}, {.hit_events = true});
         }},
        {"hooks",
         [](Attempt& a) {
             return !a.world.create_shape(a.body, Circle{{}, 1}, {.pre_solve = true});
         }},
        {"one_way",
         [](Attempt& a) {
             return !a.world.create_shape(a.body, Circle{{}, 1}, {.one_way = {0, 1}});
         }},
        {"disabling", [](Attempt& a) { return a.world.set_enabled(a.body, false), a.world.is_enabled(a.body); }},
        {"queries",
         [](Attempt& a) {
             return !a.world.cast_ray({0, 10}, {0, -20});
         }},
        {"mover",
         [](Attempt& a) {
             MoverState hero;
             return !step_mover(a.world, {}, hero, {}, 1.0f / 60);
         }},
        {"recorder",
         [](Attempt& a) {
             static std::byte buffer[4096];
             return !a.world.start_recording(buffer);
         }},
        {"tuning", [](Attempt& a) { return a.world.set_solver({.block_contacts = true}), !a.world.solver().block_contacts; }},
        {"profile", [](Attempt& a) { return a.world.set_clock([](void*) { return std::uint64_t{0}; }, nullptr), true; }},
        {"joints", [](Attempt& a) { return !a.world.create_joint(RevoluteJointDef{.base = a.base}); }},
        {"revolute_joints", [](Attempt& a) { return !a.world.create_joint(RevoluteJointDef{.base = a.base}); }},
        {"prismatic_joints", [](Attempt& a) { return !a.world.create_joint(PrismaticJointDef{.base = a.base}); }},
        {"distance_joints", [](Attempt& a) { return !a.world.create_joint(DistanceJointDef{.base = a.base}); }},
        {"weld_joints", [](Attempt& a) { return !a.world.create_joint(WeldJointDef{.base = a.base}); }},
        {"wheel_joints", [](Attempt& a) { return !a.world.create_joint(WheelJointDef{.base = a.base}); }},
        {"motor_joints", [](Attempt& a) { return !a.world.create_joint(MotorJointDef{.base = a.base}); }},
        {"mouse_joints", [](Attempt& a) { return !a.world.create_joint(MouseJointDef{.body = a.body, .max_force = 1}); }},
        {"pulley_joints",
         [](Attempt& a) {
             return !a.world.create_joint(PulleyJointDef{.base = a.base, .ground_a = {0, 9}, .ground_b = {2, 9}});
         }},
        {"angle_joints", [](Attempt& a) { return !a.world.create_joint(AngleJointDef{.base = a.base}); }},
        {"gear_joints", [](Attempt& a) { return !a.world.create_joint(GearJointDef{}); }},
    };
    return table;
}

StaticWorld<Capacity{.bodies = 8, .shapes = 8, .contacts = 8, .joints = 4}> storage;

TEST(Features, EachIsRefusedWhereItIsLeftOut) {
    for (const std::string& name : listed_features()) {
        SCOPED_TRACE(name);
        if (name == "shortcuts" || name == "exact_angles") continue;  // no call asks for them
        World& world = storage.create();
        const BodyId body = world.create_body({.type = BodyType::dynamic});
        Attempt attempt{world, body, world.create_body({.type = BodyType::dynamic, .position = {2, 0}}), world.create_shape(body, Circle{{}, 0.5f})};
        ASSERT_EQ(world.last_error(), Error::none);
        const std::uint64_t before = world.hash();
        ASSERT_TRUE(asks().contains(name)) << "no call here asks for it";
        EXPECT_TRUE(asks().at(name)(attempt));
        EXPECT_EQ(world.last_error(), Error::feature_cut);
        EXPECT_EQ(world.hash(), before) << "a refused call changed the world";
    }
}

// An image whose flags claim what its shapes do not ask for: honest worlds save none, but an image may be forged.
TEST(Features, AnImageOfAContactThatNeedsWhatIsLeftOutIsRefused) {
    using namespace detail;
    World& world = storage.create({.gravity = {0, -10}, .enable_sleep = false, .continuous = false, .seamless_floors = false});
    world.create_shape(world.create_body({}), Circle{{0, -10}, 10});
    world.create_shape(world.create_body({.type = BodyType::dynamic, .position = {0, 0.5f}}), Circle{{}, 0.5f});
    for (int i = 0; i < 10; ++i) world.step(1.0f / 60);
    ASSERT_EQ(world.report().touching_contacts, 1u);
    alignas(snapshot_alignment) std::byte image[max_snapshot_bytes({.bodies = 8, .shapes = 8, .contacts = 8, .joints = 4})];
    const auto loads = [&] {
        const std::size_t bytes = world.save(image);
        return world.load({image, bytes});
    };
    ASSERT_TRUE(loads()) << describe(world.last_error());
    Core& core = Core::of(world);
    const std::uint32_t honest = core.manifolds[0].flags;
    for (const std::uint32_t flag : {contact_special, contact_bouncy, contact_sensor, contact_hits, contact_asks, contact_one_way, contact_passes}) {
        SCOPED_TRACE(flag);
        core.manifolds[0].flags = honest | flag;
        EXPECT_FALSE(loads());
        EXPECT_EQ(world.last_error(), Error::feature_cut);
    }
    core.manifolds[0].flags = honest;
    core.state->trees_stale = 0;
    core.state->exact_joints = 1;
    EXPECT_FALSE(loads());
    EXPECT_EQ(world.last_error(), Error::unsound_image);
    core.state->exact_joints = 0;
    EXPECT_TRUE(loads());
}

TEST(Features, WhatIsLeftStepsOn) {
    World& world = storage.create({.gravity = {0, -10}});
    world.create_shape(world.create_body({}), Circle{{0, -10}, 10});
    const BodyId ball = world.create_body({.type = BodyType::dynamic, .position = {0, 2}});
    world.create_shape(ball, Circle{{}, 0.5f});
    for (int i = 0; i < 120; ++i) world.step(1.0f / 60);
    EXPECT_NEAR(world.transform(ball).p.y, 0.5f, 0.01f);
    EXPECT_EQ(world.last_error(), Error::none);
}

TEST(Features, CMakeHasTheSameNames) {
    std::istringstream given(ISLET_CMAKE_FEATURES);
    std::set<std::string> names;
    for (std::string name; std::getline(given, name, ',');) names.insert(name);
    EXPECT_EQ(names, listed_features());
}

TEST(Features, TheManualNamesEach) {
    std::ifstream file(test::engine_folder().parent_path() / "docs" / "microcontrollers.md");
    const std::string page{std::istreambuf_iterator<char>(file), {}};
    for (const std::string& name : listed_features()) EXPECT_NE(page.find('`' + name + '`'), std::string::npos) << name;
}

}  // namespace
