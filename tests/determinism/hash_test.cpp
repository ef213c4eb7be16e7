// What the hash of a world must notice, and what it must not: everything that the future depends on, and nothing else.
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <functional>
#include <vector>

#include "data/core.hpp"
#include "support/bits.hpp"
#include "support/image.hpp"
#include "support/test_world.hpp"

namespace islet::test {
namespace {

// Two boxes in contact, one ball in flight, one body asleep.
struct Stage {
    TestWorld world;
    BodyId ground, lower, upper, ball, sleeper;

    explicit Stage(const WorldDef& def = {}) : world({.bodies = 8, .shapes = 8, .contacts = 16}, def) {
        ground = world.add_ground();
        lower = world.add_box({0, 0.5f});
        upper = world.add_box({0.25f, 1.5f});
        BodyDef flying;
        flying.type = BodyType::dynamic;
        flying.position = {4, 5};
        flying.linear_velocity = {1, 2};
        ball = world.add(Circle{}, flying);
        BodyDef asleep;
        asleep.type = BodyType::dynamic;
        asleep.position = {-6, 4};
        asleep.awake = false;
        sleeper = world.add(Circle{}, asleep);
        world.step(5);
    }
};

struct Change {
    const char* name;
    std::function<void(Stage&)> apply;
};

class Matters : public testing::TestWithParam<Change> {};

TEST_P(Matters, ChangesTheHash) {
    Stage plain, changed;
    ASSERT_EQ(plain.world->hash(), changed.world->hash());
    GetParam().apply(changed);
    EXPECT_NE(plain.world->hash(), changed.world->hash());
    EXPECT_TRUE(changed.world.errors.empty());
}

const Change matters[] = {
    {"OneBitOfAVelocity",
     [](Stage& s) {
         const Vec2 v = s.world->linear_velocity(s.ball);
         s.world->set_linear_velocity(s.ball, {next_up(v.x), v.y});
     }},
    {"OneBitOfASpin", [](Stage& s) { s.world->set_angular_velocity(s.ball, 1e-45f); }},
    {"OneBitOfAPlace",
     [](Stage& s) {
         const Vec2 p = s.world->position(s.ball);
         s.world->set_transform(s.ball, {next_up(p.x), p.y}, 0);
     }},
    {"AFriction", [](Stage& s) { s.world->set_friction(s.world.shape_of(s.ball), 0.5f); }},
    {"ARestitution", [](Stage& s) { s.world->set_restitution(s.world.shape_of(s.ball), 0.5f); }},
    {"ARollingResistance", [](Stage& s) { s.world->set_rolling_resistance(s.world.shape_of(s.ball), 0.5f); }},
    {"ATangentSpeed", [](Stage& s) { s.world->set_tangent_speed(s.world.shape_of(s.ball), 0.5f); }},
    {"AFilter",
     [](Stage& s) {
         Filter f;
         f.category = 2;
         s.world->set_filter(s.world.shape_of(s.ball), f);
     }},
    {"ADamping", [](Stage& s) { s.world->set_linear_damping(s.ball, 0.5f); }},
    {"AnAngularDamping", [](Stage& s) { s.world->set_angular_damping(s.ball, 0.5f); }},
    {"AGravityScale", [](Stage& s) { s.world->set_gravity_scale(s.ball, 0.5f); }},
    {"AFixedRotation", [](Stage& s) { s.world->set_fixed_rotation(s.ball, true); }},
    {"AMass",
     [](Stage& s) {
         s.world->set_mass(s.ball, {2, {0, 0}, 1});
     }},
    {"AForce",
     [](Stage& s) {
         s.world->apply_force_to_center(s.ball, {1, 0});
     }},
    {"ATorque", [](Stage& s) { s.world->apply_torque(s.ball, 1); }},
    {"AnImpulse",
     [](Stage& s) {
         s.world->apply_linear_impulse_to_center(s.ball, {1, 0});
     }},
    {"AType", [](Stage& s) { s.world->set_type(s.ball, BodyType::kinematic); }},
    {"ThatABodyIsAwake", [](Stage& s) { s.world->wake(s.sleeper); }},
    {"ThatABodyMaySleep", [](Stage& s) { s.world->enable_sleep(s.ball, false); }},
    {"ThatTheWorldMaySleep", [](Stage& s) { s.world->enable_sleep(false); }},
    {"Gravity",
     [](Stage& s) {
         s.world->set_gravity({0, -9.5f});
     }},
    {"TheSubsteps",
     [](Stage& s) {
         SolverDef d = s.world->solver();
         d.substeps = 5;
         s.world->set_solver(d);
     }},
    {"TheWarmStart",
     [](Stage& s) {
         SolverDef d = s.world->solver();
         d.warm_start = false;
         s.world->set_solver(d);
     }},
    {"TheRelaxationFactor",
     [](Stage& s) {
         SolverDef d = s.world->solver();
         d.omega = 1.25f;
         s.world->set_solver(d);
     }},
    {"TheOrderOfSweeps",
     [](Stage& s) {
         SolverDef d = s.world->solver();
         d.sweep_order = SweepOrder::upward;
         s.world->set_solver(d);
     }},
    {"TheShock",
     [](Stage& s) {
         SolverDef d = s.world->solver();
         d.shock = 0.5f;
         s.world->set_solver(d);
     }},
    {"TheTolerance",
     [](Stage& s) {
         SolverDef d = s.world->solver();
         d.tolerance = 1e-3f;
         s.world->set_solver(d);
     }},
    {"TheHitThreshold", [](Stage& s) { s.world->set_hit_threshold(2); }},
    {"ALock", [](Stage& s) { s.world->lock_y(s.ball, true); }},
    {"ABodyDisabled", [](Stage& s) { s.world->set_enabled(s.ball, false); }},
    {"ASleepThreshold", [](Stage& s) { s.world->set_sleep_threshold(s.ball, 0.1f); }},
    {"AMaterialsId", [](Stage& s) { s.world->set_material(s.world.shape_of(s.ball), {.id = 1}); }},
    {"ADensity", [](Stage& s) { s.world->set_density(s.world.shape_of(s.ball), 2); }},
    {"AnotherGeometry", [](Stage& s) { s.world->set_circle(s.world.shape_of(s.ball), Circle{{}, 0.4f}); }},
    {"ConsentToSensors", [](Stage& s) { s.world->enable_sensor_events(s.world.shape_of(s.ball), false); }},
    {"AShapeThatTellsOfHits", [](Stage& s) { s.world->enable_hit_events(s.world.shape_of(s.ball), true); }},
    {"AnExplosion", [](Stage& s) { s.world->explode({.position = {4, 0}, .radius = 20, .impulse_per_length = 1}); }},
    {"AWind", [](Stage& s) { s.world->apply_wind(s.world.shape_of(s.ball), {.velocity = {5, 0}}); }},
    {"ABodyMore", [](Stage& s) { s.world->create_body({}); }},
    {"AShapeMore",
     [](Stage& s) {
         s.world->create_shape(s.ground, Circle{{50, 50}, 0.5f});
     }},
    {"ABodyFewer", [](Stage& s) { s.world->destroy_body(s.sleeper); }},
    {"ABodyMadeAndDestroyed", [](Stage& s) { s.world->destroy_body(s.world->create_body({})); }},  // the next id has another generation
    {"AStep", [](Stage& s) { s.world.step(); }},
};

INSTANTIATE_TEST_SUITE_P(Hash, Matters, testing::ValuesIn(matters), [](const auto& test) { return std::string(test.param.name); });

class DoesNotMatter : public testing::TestWithParam<Change> {};

TEST_P(DoesNotMatter, LeavesTheHashAsItWas) {
    Stage plain, changed;
    GetParam().apply(changed);
    EXPECT_EQ(plain.world->hash(), changed.world->hash());
    plain.world.step(30);
    changed.world.step(30);
    EXPECT_EQ(plain.world->hash(), changed.world->hash()) << "and the future";
}

const Change does_not_matter[] = {
    {"UserDataOfABody", [](Stage& s) { s.world->set_user_data(s.ball, 0x1234567890abcdefull); }},
    {"UserDataOfAShape", [](Stage& s) { s.world->set_user_data(s.world.shape_of(s.ball), 77); }},
    {"AHookThatChangesNothing", [](Stage& s) { s.world->set_hooks({.pre_solve = [](PreSolve&, void*) {}}); }},
    {"EventsBeingRead",
     [](Stage& s) {
         EXPECT_TRUE(s.world->sensor_begin_events().empty() && s.world->sensor_end_events().empty() && s.world->hit_events().empty());
     }},
    {"AnError", [](Stage& s) { s.world->step(-1); }},
    {"AnErrorCleared",
     [](Stage& s) {
         s.world->set_friction({}, 1);
         s.world->clear_error();
     }},
    {"ARefusedBody",
     [](Stage& s) {
         BodyDef bad;
         bad.linear_damping = -1;
         s.world->create_body(bad);
     }},
    {"ARefusedShape",
     [](Stage& s) {
         s.world->create_shape(s.ball, Circle{{}, -1});
     }},
    {"ARefusedSolver",
     [](Stage& s) {
         SolverDef d = s.world->solver();
         d.substeps = 0;
         s.world->set_solver(d);
     }},
    {"ANumberSetToWhatItWas", [](Stage& s) { s.world->set_friction(s.world.shape_of(s.ball), 0.6f); }},
};

INSTANTIATE_TEST_SUITE_P(Hash, DoesNotMatter, testing::ValuesIn(does_not_matter),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(Hash, DoesNotDependOnHooksOrLanes) {
    // The same objects in a world with no hook and other lanes.
    const Stage stage;
    Block block(world_bytes(stage.world->capacity()));
    for (const std::uint32_t lanes : {1u, 4u, 8u, 16u}) {
        WorldDef def;
        def.lanes = lanes;
        const Stage other(def);
        EXPECT_EQ(stage.world->hash(), other.world->hash()) << "lanes " << lanes;
        World* bare = World::create(block.span(), stage.world->capacity(), def);
        TestWorld hooked({.bodies = 8, .shapes = 8, .contacts = 16}, def);
        EXPECT_EQ(bare->hash(), hooked->hash());
    }
}

TEST(Hash, TellsTheOrderOfCreation) {
    // Slots decide the order of the solve, so worlds filled in another order are other worlds.
    TestWorld a, b;
    a.add_box({0, 0});
    a.add_circle({5, 0});
    b.add_circle({5, 0});
    b.add_box({0, 0});
    EXPECT_NE(a->hash(), b->hash());
}

// What has ended since the last step the next one tells, so it is of the future.
TEST(Hash, TellsWhatTheNextStepWillTell) {
    TestWorld w;
    w.add_ground();
    const BodyId ball = w.add_circle({0, 0.5f}), other = w.add_circle({3, 0.5f});
    BodyDef gate;
    gate.position = {6, 1};
    w.add(make_box(1, 1), gate, {.sensor = true});
    const BodyId visitor = w.add_circle({6, 0.5f});
    w.step(5);
    const auto told = [](TestWorld& world) {
        world.step();
        std::vector<std::uint32_t> ids;
        for (const TouchEvent& e : world->end_touch_events()) ids.insert(ids.end(), {e.shape_a.index1, e.shape_a.generation, e.shape_b.index1, e.shape_b.generation});
        ids.push_back(0);
        for (const SensorEvent& e : world->sensor_end_events()) ids.insert(ids.end(), {e.sensor.index1, e.sensor.generation, e.visitor.index1, e.visitor.generation});
        return ids;
    };
    const auto expect_hash_tells = [&](std::uint32_t touches, std::uint32_t overlaps) {
        SCOPED_TRACE(touches);
        SCOPED_TRACE(overlaps);
        const Image image = save(*w);
        TestWorld same, forgetful;
        ASSERT_TRUE(same->load(image.bytes()));
        EXPECT_EQ(same->hash(), w->hash());
        ASSERT_TRUE(forgetful->load(image.bytes()));
        detail::Core& core = detail::Core::of(*forgetful);
        ASSERT_EQ(core.end_count, touches);
        ASSERT_EQ(core.sensor_ends.count, overlaps);
        core.end_count = core.sensor_ends.count = 0;
        EXPECT_EQ(forgetful->hash() != w->hash(), touches + overlaps != 0);
        TestWorld twin;
        ASSERT_TRUE(twin->load(image.bytes()));
        EXPECT_EQ(told(same), told(twin)) << "a world that was restored tells what the one saved would have told";
    };
    expect_hash_tells(0, 0);
    w->destroy_body(visitor);  // touches the ground too
    expect_hash_tells(1, 1);
    w->destroy_body(ball);
    expect_hash_tells(2, 1);
    w.step();
    EXPECT_EQ(w->end_touch_events().size(), 2u);
    EXPECT_EQ(w->sensor_end_events().size(), 1u);
    expect_hash_tells(0, 0);
    w->destroy_body(other);
    expect_hash_tells(1, 0);
}

// One end event or the other: the kind of what ended matters, and which two it were.
TEST(Hash, TellsEndedTouchesFromEndedOverlaps) {
    TestWorld w;
    w.add_ground();
    const BodyId ball = w.add_circle({0, 0.5f});
    w.step(5);
    w->destroy_body(ball);
    const std::uint64_t hash = w->hash();
    detail::Core& core = detail::Core::of(*w);
    ASSERT_EQ(core.end_count - core.end_reported, 1u);
    core.end_events[core.end_reported].shape_a.generation += 2;
    EXPECT_NE(w->hash(), hash);
    core.end_events[core.end_reported].shape_a.generation -= 2;
    EXPECT_EQ(w->hash(), hash);
    core.sensor_ends = {reinterpret_cast<SensorEvent*>(core.end_events + core.end_reported), 1};
    core.sensor_ends_reported = 0;
    core.end_count = core.end_reported;
    EXPECT_NE(w->hash(), hash);
}

}  // namespace
}  // namespace islet::test
