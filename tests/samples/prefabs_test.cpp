// The prefabs on a world of one's own: what each promises, and that a world without room for one says so and stays whole.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "harness/engine.hpp"
#include "physics/measure.hpp"
#include "prefabs/bridge.hpp"
#include "prefabs/car.hpp"
#include "prefabs/chain.hpp"
#include "prefabs/cloth.hpp"
#include "prefabs/gripper.hpp"
#include "prefabs/rope.hpp"
#include "prefabs/soft_body.hpp"
#include "scenes/benchmark_doll.hpp"
#include "scenes/prefab_scene.hpp"

namespace islet::test {
namespace {

using namespace samples;

constexpr Capacity room{.bodies = 256, .shapes = 256, .contacts = 2048, .joints = 1024};

/// Stiffer joints than by default: under a force F they give by F / (m (2 pi 120 Hz)^2), m being the effective mass.
WorldDef stiff() {
    WorldDef def;
    def.solver.substeps = 8;
    def.solver.joint_hertz = 120;
    return def;
}

/// The ids of a prefab that is made in a world, as a program of one's own makes it.
template <class Def>
PrefabIds spawned(World& world, const Def& def) {
    const PrefabSize size = size_of(def);
    PrefabIds ids{std::vector<BodyId>(size.bodies), std::vector<JointId>(size.joints)};
    const Spawned made = spawn(world, def, ids.bodies, ids.joints);
    EXPECT_EQ(made.bodies.data(), ids.bodies.data());
    EXPECT_EQ(made.bodies.size(), size.bodies);
    EXPECT_EQ(made.joints.size(), size.joints);
    return ids;
}

/// From one end of the rope to the other along its links, m, gaps included.
double length_along(const World& world, const PrefabIds& rope, const RopeDef& def) {
    const Vec2 start = rope_start(def).position, end = rope_end(def).position;
    double sum = 0;
    Vec2 last = transform_point(world.transform(rope.bodies[0]), start);
    for (std::size_t i = 0; i < def.links; ++i) {
        for (const Vec2 local : {start, end}) {
            const Vec2 point = transform_point(world.transform(rope.bodies[i]), local);
            sum += double(distance(last, point));
            last = point;
        }
    }
    return sum;
}

TEST(Prefabs, RopeKeepsItsLengthUnderAHeavyLoad) {
    TestWorld world(room, stiff());
    const RopeDef def = {.from = {0, 6}, .to = {0, 3}, .hold_from = true};
    const PrefabIds rope = spawned(*world, def);
    // 100 kg on a rope of 3 kg.
    const BodyId load = world.add_box({0, 2.5f}, 0.5f, 0.5f, dense(100));
    RevoluteJointDef knot;
    knot.base = {.body_a = rope.bodies[def.links - 1], .body_b = load, .frame_a = rope_end(def), .frame_b = {{0, 0.5f}, 0}};
    world->create_joint(knot);
    world->set_linear_velocity(load, {3, 0});
    double longest = 0;
    for (int i = 0; i < 300; ++i) {
        world.step();
        longest = std::max(longest, length_along(*world, rope, def));
    }
    // The rope's limit gives it 1 %, and holds the load on the last link, of 0.2 kg, where the knot gives by F / (m w^2) = 1 cm, more in the swing.
    EXPECT_LT(longest, 3 * 1.03);
    EXPECT_GT(length_along(*world, rope, def), 3 * 0.999);
    EXPECT_TRUE(world.errors.empty());
    EXPECT_EQ(world->validate(), nullptr);
}

TEST(Prefabs, SlackPutsTheMiddleBelowAndTheEndsWhereTheyAre) {
    for (const float slack : {1.0f, 1.001f, 1.1f, 1.5f, 3.0f}) {
        const RopeDef def = {.from = {-2, 1}, .to = {2, 2}, .slack = slack, .links = 17};
        const Prefab rope = prefab_of(def);
        const auto at = [&](std::size_t link, Vec2 local) {
            const BodyDef& body = rope.bodies[link].def;
            return transform_point({body.position, make_rot(body.angle)}, local);
        };
        EXPECT_NEAR(distance(at(0, rope_start(def).position), def.from), 0, 1e-4) << slack;
        EXPECT_NEAR(distance(at(16, rope_end(def).position), def.to), 0, 1e-3) << slack;
        for (std::size_t i = 1; i < 17; ++i)
            EXPECT_NEAR(distance(at(i - 1, rope_end(def).position), at(i, rope_start(def).position)), 0, 1e-5) << slack;
        // The arc's depth grows with the slack: for little slack it is chord * sqrt(3/8 slack), here measured across the chord.
        const Vec2 across = right_perp(normalize(def.to - def.from));
        const double depth = double(dot(at(8, {}) - 0.5f * (def.from + def.to), across)), chord = std::sqrt(17.0);
        if (slack < 1.2f) {
            EXPECT_NEAR(depth, chord * std::sqrt(0.375 * (double(slack) - 1)), 0.05 * chord * double(slack - 1) + 1e-3) << slack;
        }
    }
}

TEST(Prefabs, ChainBreaksUnderMoreThanItsForce) {
    for (const float mass : {3.0f, 25.0f}) {
        TestWorld world(room);
        const ChainDef def = {.from = {0, 6}, .to = {0, 4}, .break_force = 300, .hold_from = true};
        const PrefabIds chain = spawned(*world, def);
        double weight = 0;
        for (std::size_t i = 0; i < def.links; ++i) weight += g * double(world->mass(chain.bodies[i]));
        // Let go all at once, a load pulls up to twice as hard as it weighs: with 30 N more the chain must hold, with 250 N more it cannot.
        ASSERT_LT(2 * (weight + 30), 300);
        ASSERT_GT(weight + 250, 300);
        const BodyId ball = world.add_circle({0, 3.5f}, 0.5f, dense(mass / (pi * 0.25f)));
        RevoluteJointDef shackle;
        shackle.base = {.body_a = chain.bodies[def.links - 1], .body_b = ball, .frame_a = chain_end(def), .frame_b = {{0, 0.5f}, 0}};
        const JointId last = world->create_joint(shackle);
        std::size_t broken = 0;
        for (int i = 0; i < 240; ++i) {
            world.step();
            broken += world->broken_joints().size();
        }
        EXPECT_EQ(broken > 0, mass > 10) << mass << " kg";
        EXPECT_TRUE(world->is_valid(last));
        EXPECT_EQ(world->validate(), nullptr);
    }
}

TEST(Prefabs, BridgeCarriesACrateAndPullsAsACableDoes) {
    TestWorld world(room, stiff());
    const BridgeDef def = {.from = {-4, 3}, .to = {4, 3}, .slack = 1.02f, .stiffness = 2};
    const PrefabIds bridge = spawned(*world, def);
    const BodyId crate = world.add_box({0, 3.5f}, 0.4f, 0.4f, dense(10));
    world.step(600);
    EXPECT_GT(world->position(crate).y, 2.0f);
    EXPECT_LT(length(world->linear_velocity(crate)), 0.05f);
    // Each bank carries half of the planks' and the crate's weight, within what the hinges' friction may hide.
    double weight = g * double(world->mass(crate));
    for (std::size_t i = 0; i < def.planks; ++i) weight += g * double(world->mass(bridge.bodies[i]));
    const std::size_t banks = bridge.joints.size() - 2;
    double carried = 0;
    for (const std::size_t bank : {banks, banks + 1}) carried += double(world->joint_force(bridge.joints[bank]).y);
    EXPECT_NEAR(carried, weight, 0.02 * weight);
    EXPECT_EQ(world->validate(), nullptr);
}

TEST(Prefabs, SoftBodyKeepsItsAreaAloneAndUnderACrate) {
    TestWorld world(room, stiff());
    world.add_ground();
    const SoftBodyDef def = {.position = {0, 1.5f}};
    const PrefabIds soft = spawned(*world, def);
    const double whole = double(round_area(def));
    EXPECT_NEAR(double(area_of(*world, soft, def)), whole, 1e-4 * whole);
    EXPECT_NEAR(whole, 3.14159 * 0.25, 0.02) << "twenty sides make less than a circle, by (2 pi / 20)^2 / 6";
    const auto run = [&](int steps, double low, double high, const char* when) {
        for (int i = 0; i < steps; ++i) {
            apply_pressure(*world, soft, def);
            world.step();
            ASSERT_GT(double(area_of(*world, soft, def)), low * whole) << when << ", step " << i;
            ASSERT_LT(double(area_of(*world, soft, def)), high * whole) << when << ", step " << i;
        }
    };
    // The skin pulls with p r = 30 N and gives by F / (m w^2) = 1.3 mm a hinge, 1 % of a link; the area is at most 2 % above the round one. Landing at
    // 5 m/s it is pressed flat for a moment: the energy m v^2 / 2 = 18 J goes into gas that takes p A ln(A / A') to press together.
    run(300, 0.6, 1.05, "landing");
    run(60, 0.95, 1.03, "at rest");
    // 4 kg on it. Pressed between two plates to half circles of radius r, w apart, with the same skin 2 pi r + 2 w = 3.14 m, its area is
    // pi r^2 + 2 r w = 0.67 m^2 when its pressure carries 40 N along w: 86 % of the round one, less for the skin's own 14 N and for its corners.
    BodyDef crate = dynamic_at({0, 1.3f});
    crate.fixed_rotation = true;  // so that it does not slide off
    world.add(make_box(0.5f, 0.1f), crate, dense(20));
    run(340, 0.4, 1.05, "a crate lands on it");
    run(60, 0.78, 0.87, "under a crate");
    EXPECT_TRUE(world.is_finite());
    EXPECT_TRUE(world.errors.empty());
    EXPECT_EQ(world->validate(), nullptr);
}

TEST(Prefabs, ClothHangsByTwoCornersWithoutStretching) {
    TestWorld world(room, stiff());
    const ClothDef def = {.corner = {-1, 4}, .columns = 9, .rows = 9};
    const PrefabIds cloth = spawned(*world, def);
    ASSERT_EQ(cloth.bodies.size(), 81u);
    const BodyId wall = world->create_body({});
    for (const std::size_t column : {std::size_t{0}, def.columns - 1}) {
        RevoluteJointDef nail;
        nail.base.body_a = wall;
        nail.base.body_b = cloth.bodies[cloth_node(def, column, 0)];
        nail.base.frame_a.position = world->position(nail.base.body_b);
        world->create_joint(nail);
    }
    for (int i = 0; i < 600; ++i) {
        world.step();
        for (std::size_t j = 0; j < cloth_rods(def); ++j) {
            ASSERT_EQ(world->joint_type(cloth.joints[j]), JointType::distance);
            // A nail carries half of 5 kg on rods whose effective mass is half a node's, 31 g: 2.2 mm, and some times that while it falls into place.
            ASSERT_LT(world->joint_error(cloth.joints[j]).linear, 0.04f * def.spacing) << "rod " << j << ", step " << i;
        }
    }
    EXPECT_EQ(world->validate(), nullptr);
}

TEST(Prefabs, CarDrivesAtItsSpeedBrakesAndCoasts) {
    TestWorld world(room);
    world.add_ground(0, 100, rough(1));
    const CarDef def = {.position = {-50, 0}};
    const PrefabIds car = spawned(*world, def);
    const BodyId body = car.bodies[std::size_t(CarPart::body)];
    world.step(60);
    drive(*world, car, 8);
    world.step(240);
    // The wheels turn as the motors say, and roll without slipping.
    EXPECT_NEAR(world->linear_velocity(body).x, 8, 0.1);
    EXPECT_NEAR(world->angle(body), 0, 0.05);
    drive(*world, car, 0);
    world.step(180);
    EXPECT_NEAR(world->linear_velocity(body).x, 0, 0.05);
    coast(*world, car);
    const float x = world->position(body).x;
    world->apply_linear_impulse_to_center(body, {world->mass(body), 0});
    world.step(60);
    EXPECT_GT(world->position(body).x, x + 0.4f) << "a car that coasts rolls when pushed";
    EXPECT_TRUE(world.errors.empty());
}

TEST(Prefabs, GripperLiftsWhatItsFrictionHoldsAndNoMore) {
    struct Case {
        float density;  // of a box of 0.6 m by 0.6 m
        bool held;
    };
    // The fingers' friction of 0.7 holds 2 * 0.7 * 100 N = 140 N.
    for (const Case& c : {Case{20, true}, Case{60, false}}) {
        TestWorld world(room);
        world.add_ground();
        const GripperDef def = {.rail = {0, 3}, .friction = 0.7f};
        const PrefabIds gripper = spawned(*world, def);
        ShapeDef material = rough(0.7f);
        material.density = c.density;
        const BodyId box = world.add_box({0, 0.3f}, 0.3f, 0.3f, material);
        command(*world, gripper, def, {.lift = -1});
        world.step(95);
        command(*world, gripper, def, {.close = true});
        world.step(60);
        for (int i = 0; i < 60; ++i) {
            command(*world, gripper, def, {.lift = 0.008f * static_cast<float>(i), .close = true});
            world.step();
        }
        EXPECT_EQ(world->position(box).y > 0.45f, c.held) << world->position(box).y;
        EXPECT_EQ(world->validate(), nullptr);
    }
}

// -- all of them ---------------------------------------------------------------------------------------------------------------------

/// A prefab, as lists and made in a world.
struct Kind {
    template <class Def>
    Kind(const char* what, const Def& def)
        : name(what), prefab(prefab_of(def)), make([def](World& world) { return spawned(world, def); }) {}
    Kind(const char* what, const Prefab& lists) : name(what), prefab(lists), make([lists](World& world) { return spawn(world, lists); }) {}

    const char* name;
    Prefab prefab;
    std::function<PrefabIds(World&)> make;
};

std::vector<Kind> kinds() {
    return {
        {"rope", RopeDef{.from = {0, 6}, .to = {0, 3}, .hold_from = true}},
        {"chain", ChainDef{.from = {0, 6}, .to = {2, 6}, .hold_from = true}},
        {"bridge", BridgeDef{.from = {-4, 3}, .to = {4, 3}}},
        {"car", CarDef{}},
        {"cloth", ClothDef{.corner = {-1, 4}}},
        {"soft_body", SoftBodyDef{.position = {0, 3}}},
        {"gripper", GripperDef{.rail = {0, 5}}},
        {"doll", make_benchmark_doll({.position = {0, 1}})},
    };
}

std::uint32_t shapes_of(const Prefab& prefab) {
    std::uint32_t count = 0;
    for (const SceneBody& body : prefab.bodies) count += static_cast<std::uint32_t>(body.shapes.size());
    return count;
}

TEST(Prefabs, StartWithoutErrorAndAreGoneWhenDestroyed) {
    for (const Kind& kind : kinds()) {
        TestWorld world(room);
        const Prefab& prefab = kind.prefab;
        const PrefabIds spawned = kind.make(*world);
        EXPECT_TRUE(world.errors.empty()) << kind.name;
        EXPECT_EQ(world->body_count(), prefab.bodies.size()) << kind.name;
        EXPECT_EQ(world->joint_count(), prefab.joints.size()) << kind.name;
        for (const JointId joint : spawned.joints) EXPECT_LT(world->joint_error(joint).linear, 1e-3f) << kind.name;
        world.step(10);
        EXPECT_TRUE(world.is_finite()) << kind.name;
        destroy(*world, spawned);
        EXPECT_EQ(world->body_count(), 0u) << kind.name;
        EXPECT_EQ(world->joint_count(), 0u) << kind.name;
        EXPECT_EQ(world->validate(), nullptr) << kind.name;
    }
}

TEST(Prefabs, AWorldWithoutRoomSaysWhyAndStaysWhole) {
    for (const Kind& kind : kinds()) {
        const Prefab& prefab = kind.prefab;
        const auto bodies = static_cast<std::uint32_t>(prefab.bodies.size()), joints = static_cast<std::uint32_t>(prefab.joints.size());
        const std::uint32_t shapes = shapes_of(prefab);
        const Capacity enough{.bodies = bodies, .shapes = shapes, .contacts = 16 * shapes, .joints = joints};
        struct Case {
            Error error;
            Capacity capacity;
        };
        std::vector<Case> cases = {
            {Error::none, enough}, {Error::bodies_full, enough}, {Error::shapes_full, enough}, {Error::joints_full, enough}};
        cases[1].capacity.bodies = bodies / 2;
        cases[2].capacity.shapes = shapes / 2;
        cases[3].capacity.joints = joints / 2;
        for (const Case& c : cases) {
            TestWorld world(c.capacity);
            const PrefabIds spawned = kind.make(*world);
            const std::string what = std::string(kind.name) + ": " + describe(c.error);
            EXPECT_EQ(world->last_error(), c.error) << what;
            for (const Error error : world.errors) EXPECT_EQ(error, c.error) << what;
            EXPECT_EQ(world->validate(), nullptr) << what;
            // What was made lives on, what was not has a null id.
            ASSERT_EQ(spawned.bodies.size(), prefab.bodies.size());
            ASSERT_EQ(spawned.joints.size(), prefab.joints.size());
            for (const BodyId body : spawned.bodies) EXPECT_EQ(world->is_valid(body), bool(body)) << what;
            world.errors.clear();
            world.step(10);
            EXPECT_TRUE(world.is_finite()) << what;
            EXPECT_EQ(world->validate(), nullptr) << what;
            destroy(*world, spawned);
            EXPECT_EQ(world->body_count(), 0u) << what;
            EXPECT_EQ(world->validate(), nullptr) << what;
        }
    }
}

TEST(Prefabs, ArraysThatAreTooShortGetNothing) {
    const CarDef def;
    BodyId bodies[3];
    JointId joints[2];
    TestWorld world(room);
    EXPECT_TRUE(spawn(*world, def, std::span(bodies).first(2), joints).bodies.empty());
    EXPECT_TRUE(spawn(*world, def, bodies, std::span(joints).first(1)).bodies.empty());
    EXPECT_EQ(world->body_count(), 0u);
    EXPECT_EQ(spawn(*world, def, bodies, joints).bodies.size(), 3u);
}

TEST(Prefabs, AreTheSameInASceneAndInAWorld) {
    for (const Kind& kind : kinds()) {
        Scene scene;
        add_prefab(scene, kind.prefab);
        IsletEngine engine;
        engine.load(scene);
        TestWorld world(capacity_of(scene), scene.world);
        kind.make(*world);
        for (int i = 0; i < 30; ++i) {
            engine.advance(scene, i, step_time);
            world.step();
        }
        EXPECT_EQ(engine.world().hash(), world->hash()) << kind.name;
    }
}

}  // namespace
}  // namespace islet::test
