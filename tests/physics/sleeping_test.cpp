// Sleep: whole islands fall asleep after half a second at rest and wake together.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <vector>

#include "measure.hpp"
#include "support/random.hpp"

namespace islet::test {
namespace {

// Five boxes, one on another, set down without a gap.
std::vector<BodyId> add_tower(TestWorld& world, float x) {
    std::vector<BodyId> tower;
    for (int i = 0; i < 5; ++i) tower.push_back(world.add_box({x, 0.5f + static_cast<float>(i)}));
    return tower;
}

std::size_t awake_of(const TestWorld& world, const std::vector<BodyId>& bodies) {
    return static_cast<std::size_t>(std::count_if(bodies.begin(), bodies.end(), [&](BodyId id) { return world->is_awake(id); }));
}

// Steps until nobody of the bodies is awake; never more than 10 s.
int steps_to_sleep(TestWorld& world, const std::vector<BodyId>& bodies) {
    int steps = 0;
    while (awake_of(world, bodies) > 0 && steps < 600) {
        world.step();
        ++steps;
    }
    return steps;
}

TEST(Sleep, ABodyAtRestFallsAsleepAfterHalfASecond) {
    // 0.5 s at rest are 30 steps of 1/60 s; the sum of rounded steps may need one more.
    WorldDef def;
    def.gravity = {0, 0};
    TestWorld world(roomy, def);
    const BodyId still = world.add_box({0, 0});
    BodyDef slow = dynamic_at({5, 0}), fast = dynamic_at({10, 0});
    slow.linear_velocity = {0.04f, 0};  // below the threshold of 0.05 m/s
    fast.linear_velocity = {0.06f, 0};
    const BodyId slow_id = world.add(make_box(0.5f, 0.5f), slow), fast_id = world.add(make_box(0.5f, 0.5f), fast);
    world.step(29);
    EXPECT_TRUE(world->is_awake(still));
    EXPECT_TRUE(world->is_awake(slow_id));
    world.step(2);
    EXPECT_FALSE(world->is_awake(still));
    EXPECT_FALSE(world->is_awake(slow_id));
    world.step(60);
    EXPECT_TRUE(world->is_awake(fast_id));
    EXPECT_EQ(world->linear_velocity(slow_id), (Vec2{0, 0})) << "asleep is at rest";
}

TEST(Sleep, AnIslandFallsAsleepAsAWhole) {
    TestWorld world;
    world.add_ground();
    const std::vector<BodyId> tower = add_tower(world, 0);
    std::vector<std::size_t> seen;
    bool partly = false;
    std::size_t reported = 0;
    for (int i = 0; i < 300; ++i) {
        world.step();
        reported += world->slept_bodies().size();
        const std::size_t awake = awake_of(world, tower);
        partly |= awake != 0 && awake != tower.size();
    }
    EXPECT_FALSE(partly) << "some of the tower slept while the rest was awake";
    EXPECT_EQ(awake_of(world, tower), 0u);
    EXPECT_EQ(reported, tower.size()) << "each is reported once";
    EXPECT_EQ(world->report().awake_bodies, 0u);
    EXPECT_EQ(world->report().islands, 0u);
}

TEST(Sleep, OneRestlessBodyKeepsItsIslandAwakeAndNoOther) {
    TestWorld world;
    world.add_ground();
    const std::vector<BodyId> restless = add_tower(world, 0), quiet = add_tower(world, 10);
    world->enable_sleep(restless[2], false);
    world.step(300);
    EXPECT_EQ(awake_of(world, restless), restless.size());
    EXPECT_EQ(awake_of(world, quiet), 0u);
    world->enable_sleep(restless[2], true);
    EXPECT_LT(steps_to_sleep(world, restless), 60);
}

TEST(Sleep, AnIslandWakesAsAWhole) {
    TestWorld world;
    world.add_ground();
    const std::vector<BodyId> tower = add_tower(world, 0), other = add_tower(world, 10);
    std::vector<BodyId> all = tower;
    all.insert(all.end(), other.begin(), other.end());
    const auto settle = [&] { ASSERT_LT(steps_to_sleep(world, all), 600); };

    // Whatever touches one body of an island wakes all of it, and nothing else. A push, a word, a force:
    settle();
    world->apply_linear_impulse_to_center(tower[4], {0.01f, 0});
    EXPECT_EQ(awake_of(world, tower), tower.size());
    settle();
    world->wake(tower[0]);
    EXPECT_EQ(awake_of(world, tower), tower.size());
    settle();
    world->apply_force_to_center(tower[2], {0.1f, 0});
    EXPECT_EQ(awake_of(world, tower), tower.size());
    settle();
    world->set_linear_velocity(tower[1], {0, 0.01f});
    EXPECT_EQ(awake_of(world, tower), tower.size());
    EXPECT_EQ(awake_of(world, other), 0u);
}

// -- pushes that do not wake -------------------------------------------------------------------------------------------------------------

struct NamedPush {
    const char* name;
    void (*push)(World& w, BodyId body, float by, bool wake);
};
const NamedPush pushes[] = {
    {"apply_force", [](World& w, BodyId b, float by, bool wake) { w.apply_force(b, {by, 0}, w.position(b) + Vec2{0, 0.1f}, wake); }},
    {"apply_force_to_center", [](World& w, BodyId b, float by, bool wake) { w.apply_force_to_center(b, {by, 0}, wake); }},
    {"apply_torque", [](World& w, BodyId b, float by, bool wake) { w.apply_torque(b, by, wake); }},
    {"apply_linear_impulse", [](World& w, BodyId b, float by, bool wake) { w.apply_linear_impulse(b, {by, 0}, w.position(b) + Vec2{0, 0.1f}, wake); }},
    {"apply_linear_impulse_to_center", [](World& w, BodyId b, float by, bool wake) { w.apply_linear_impulse_to_center(b, {by, 0}, wake); }},
    {"apply_angular_impulse", [](World& w, BodyId b, float by, bool wake) { w.apply_angular_impulse(b, by, wake); }},
};

TEST(Sleep, PushesThatDoNotWakeHaveNoEffectOnASleepingBody) {
    for (const NamedPush& p : pushes) {
        SCOPED_TRACE(p.name);
        TestWorld world;
        world.add_ground();
        const std::vector<BodyId> tower = add_tower(world, 0);
        ASSERT_LT(steps_to_sleep(world, tower), 600);
        const std::uint64_t before = world->hash();
        p.push(*world, tower[2], 5, false);
        EXPECT_EQ(awake_of(world, tower), 0u);
        EXPECT_EQ(world->hash(), before);
        EXPECT_TRUE(world.errors.empty());
        p.push(*world, tower[2], NAN, false);
        EXPECT_EQ(world->last_error(), Error::not_finite) << "arguments are checked all the same";
        p.push(*world, tower[2], 5, true);
        EXPECT_EQ(awake_of(world, tower), tower.size());
    }
}

// On an awake body they are the pushes that wake: of a box of 1 kg and 1/6 kg m^2, by 3 N, N m, N s or N m s over a step of 1/60 s.
TEST(Sleep, PushesThatDoNotWakeMoveAnAwakeBody) {
    for (const NamedPush& p : pushes) {
        SCOPED_TRACE(p.name);
        WorldDef def;
        def.gravity = {0, 0};
        TestWorld world(roomy, def), other(roomy, def);
        const BodyId body = world.add_box({0, 0}), same = other.add_box({0, 0});
        p.push(*world, body, 3, false);
        p.push(*other, same, 3, true);
        world.step();
        other.step();
        EXPECT_GT(length(world->linear_velocity(body)) + std::fabs(world->angular_velocity(body)), 2.9f / 60);
        EXPECT_EQ(world->linear_velocity(body), other->linear_velocity(same));
        EXPECT_EQ(world->angular_velocity(body), other->angular_velocity(same));
    }
}

// A force of 1 N on a box of 10 N that friction of 0.6 holds, in every step for 2 s.
TEST(Sleep, PushesThatDoNotWakeLetABodyAtRestFallAsleep) {
    for (const bool wake : {false, true}) {
        TestWorld world;
        world.add_ground();
        const BodyId box = world.add_box({0, 0.5f});
        for (int i = 0; i < 120; ++i) {
            world->apply_force_to_center(box, {1, 0}, wake);
            world.step();
        }
        EXPECT_EQ(world->is_awake(box), wake);
        EXPECT_NEAR(world->position(box).x, 0, 0.01f);
    }
}

TEST(Sleep, ALandingBodyWakesWhatItHits) {
    TestWorld world;
    world.add_ground();
    const std::vector<BodyId> tower = add_tower(world, 0);
    ASSERT_LT(steps_to_sleep(world, tower), 600);
    const BodyId ball = world.add_circle({0, 7}, 0.25f);
    int steps = 0;
    while (awake_of(world, tower) == 0 && steps < 120) {
        world.step();
        ++steps;
    }
    EXPECT_EQ(awake_of(world, tower), tower.size());
    // From 7 m to the tower's top at 5 m: sqrt(2 * 1.75 / g) = 0.59 s = 35.5 steps; contacts begin 0.02 m, up to one step, early.
    EXPECT_NEAR(steps, 35.5, 2);
    EXPECT_TRUE(world->is_awake(ball));
}

TEST(Sleep, TakingAwayWhatCarriesABodyWakesIt) {
    TestWorld world;
    const BodyId ground = world.add_ground();
    const std::vector<BodyId> tower = add_tower(world, 0);
    ASSERT_LT(steps_to_sleep(world, tower), 600);
    world->destroy_body(ground);
    EXPECT_EQ(awake_of(world, tower), tower.size());
    world.step(60);
    EXPECT_LT(double(world->position(tower[0]).y), -3) << "should have fallen";
}

TEST(Sleep, TouchingAMovingKinematicBodyKeepsAnIslandAwake) {
    // A slow lift, slower than the sleep threshold even: what stands on it must go along.
    TestWorld world;
    BodyDef lift;
    lift.type = BodyType::kinematic;
    lift.linear_velocity = {0, 0.2f};
    const BodyId id = world.add(make_box(2, 0.5f), lift);
    const BodyId box = world.add_box({0, 1});
    world.step(300);
    EXPECT_TRUE(world->is_awake(box));
    // It rose with the lift, 1 m in 5 s. 2 mm: the contact's give.
    EXPECT_NEAR(double(world->position(box).y), 2, 2e-3);
    world->set_linear_velocity(id, {0, 0});
    EXPECT_LT(steps_to_sleep(world, {box}), 60) << "a kinematic body that stands still lets others sleep";
}

// A lift, a turning board as slow as a clock's minute hand, and a lift with a box on it, set once and left alone for a minute. (Slower than 0.05 m/s, they stood
// still after half a second.)
TEST(Sleep, AKinematicBodyMovesAtItsSpeedHoweverSlowly) {
    for (const float speed : {0.0001f, 0.002f, 0.02f, 0.049f}) {
        TestWorld world;
        BodyDef def;
        def.type = BodyType::kinematic;
        def.linear_velocity = {0, speed};
        const BodyId lift = world.add(make_box(2, 0.2f), def);
        def.position = {10, 0};
        const BodyId loaded = world.add(make_box(2, 0.2f), def);
        const BodyId box = world.add_box({10, 0.7f});
        def.position = {-10, 0};
        def.linear_velocity = {0, 0};
        def.angular_velocity = speed;
        const BodyId hand = world.add(make_box(2, 0.2f), def);
        world.step(3600);
        const double way = 60 * double(speed), rounding = 3600 * eps * way + 1e-5;
        EXPECT_NEAR(double(world->position(lift).y), way, rounding);
        EXPECT_NEAR(double(world->position(loaded).y), way, rounding);
        EXPECT_NEAR(double(world->position(box).y), 0.7 + way, 0.005);
        EXPECT_NEAR(double(world->angle(hand)), way, 3600 * 2 * eps);
        EXPECT_TRUE(world->is_awake(box));
        world->set_linear_velocity(loaded, {0, 0});
        EXPECT_LT(steps_to_sleep(world, {box, loaded}), 120) << "stands still at last";
    }
}

TEST(Sleep, CanBeTurnedOff) {
    TestWorld world;
    world.add_ground();
    const std::vector<BodyId> tower = add_tower(world, 0);
    ASSERT_LT(steps_to_sleep(world, tower), 600);
    world->enable_sleep(false);
    EXPECT_EQ(awake_of(world, tower), tower.size()) << "turning sleep off wakes everything";
    world.step(300);
    EXPECT_EQ(awake_of(world, tower), tower.size());
}

TEST(Sleep, SleepersCostNoContactUpdates) {
    TestWorld world;
    world.add_ground();
    const std::vector<BodyId> tower = add_tower(world, 0);
    ASSERT_LT(steps_to_sleep(world, tower), 600);
    world.step();
    EXPECT_EQ(world->report().touching_contacts, 0u);
    EXPECT_EQ(world->report().recycled_contacts, 0u);
    EXPECT_EQ(world->moved_bodies().size(), 0u);
    EXPECT_EQ(world->contact_count(), 5u) << "but the contacts are kept";
}

TEST(Sleep, ABodyMadeAsleepStaysUntilItIsHit) {
    TestWorld world;
    BodyDef def = dynamic_at({0, 10});
    def.awake = false;
    const BodyId hanging = world.add(make_box(0.5f, 0.5f), def);
    world.step(120);
    EXPECT_EQ(world->position(hanging), (Vec2{0, 10}));
    const BodyId ball = world.add_circle({0, 12});
    world.step(60);
    EXPECT_LT(double(world->position(hanging).y), 9.9);
    EXPECT_TRUE(world->is_awake(ball));
}

// Motors and belts slower than what may fall asleep (0.05 m/s), which have minutes to get there.
JointBase between(BodyId a, BodyId b) { return {.body_a = a, .body_b = b}; }

struct SlowMotor {
    const char* name;
    float speed;  // m/s, or rad/s if it turns
    bool turns;
    JointId (*join)(TestWorld&, BodyId, BodyId, float);
};

template <class Def>
JointId join(TestWorld& world, BodyId frame, BodyId moved, float speed) {
    Def def;
    def.base = between(frame, moved);
    if constexpr (std::is_same_v<Def, MotorJointDef>) {
        def.linear_velocity = {speed, 0};
        def.max_force = def.max_torque = 1000;
    } else {
        def.motor = {.enable = true, .speed = speed, .max_force = 1000};
    }
    if constexpr (std::is_same_v<Def, DistanceJointDef>) def.base.frame_a.position = {-1, 0};
    return world->create_joint(def);
}

const SlowMotor slow_motors[] = {
    {"hinge", 0.02f, true, join<RevoluteJointDef>},     {"hinge that turns back", -0.02f, true, join<RevoluteJointDef>},
    {"wheel", 0.02f, true, join<WheelJointDef>},        {"angle", -0.02f, true, join<AngleJointDef>},
    {"slider", -0.01f, false, join<PrismaticJointDef>}, {"distance", 0.01f, false, join<DistanceJointDef>},
    {"motor joint", 0.01f, false, join<MotorJointDef>},
};

WorldDef without_gravity() {
    WorldDef def = weightless();
    def.enable_sleep = true;
    return def;
}

// A box of 1 m at the origin, on a motor fixed to the world.
BodyId add_driven_box(TestWorld& world, const SlowMotor& motor) {
    const BodyId frame = world.add_circle({0, 0}, 0.1f, {}, BodyType::static_body), moved = world.add_box({0, 0});
    motor.join(world, frame, moved, motor.speed);
    return moved;
}

TEST(Sleep, WhatASlowMotorMovesStaysAwakeAndGetsThere) {
    for (const SlowMotor& motor : slow_motors) {
        SCOPED_TRACE(motor.name);
        TestWorld world(roomy, without_gravity());
        const BodyId moved = add_driven_box(world, motor);
        world.step(60 * 20);
        EXPECT_TRUE(world->is_awake(moved));
        const double way = 20 * double(motor.speed);
        EXPECT_NEAR(double(motor.turns ? world->angle(moved) : world->position(moved).x), way, 0.01 * std::abs(way));
    }
}

TEST(Sleep, WhatABlockedMotorPushesSleeps) {
    for (const SlowMotor& motor : slow_motors) {
        SCOPED_TRACE(motor.name);
        TestWorld world(roomy, without_gravity());
        const BodyId moved = add_driven_box(world, motor);
        for (const float side : {-1.0f, 1.0f}) {
            world.add_box({1.02f * side, 0}, 0.5f, 0.5f, {}, BodyType::static_body);
            world.add_box({0, 1.02f * side}, 0.5f, 0.5f, {}, BodyType::static_body);
        }
        world.step(60 * 20);
        EXPECT_FALSE(world->is_awake(moved));
    }
}

TEST(Sleep, WhatAMotorMovesKeepsItsIslandAwakeAndNoOther) {
    // A slow slider under a box: what stands on it goes along.
    TestWorld world;
    world.add_ground();
    const BodyId sled = world.add(make_box(2, 0.25f), Vec2{0, 5});
    const BodyId frame = world.add_circle({-5, 5}, 0.1f, {}, BodyType::static_body);
    world->create_joint(PrismaticJointDef{.base = between(frame, sled), .motor = {.enable = true, .speed = 0.01f, .max_force = 1e5f}});
    const BodyId carried = world.add_box({0, 5.75f}), beside = world.add_box({10, 0.5f});
    world.step(60 * 20);
    EXPECT_TRUE(world->is_awake(carried));
    EXPECT_NEAR(double(world->position(carried).x), 0.2, 0.01);
    EXPECT_FALSE(world->is_awake(beside));
}

TEST(Sleep, WhatASlowBeltCarriesStaysAwakeAndGetsThere) {
    for (const float speed : {0.02f, -0.01f}) {
        TestWorld world;
        ShapeDef belt;
        belt.tangent_speed = speed;
        world.add_ground(0, 100, belt);
        const BodyId box = world.add_box({0, 0.5f}), ball = world.add_circle({5, 0.5f});
        world.step(60 * 20);
        EXPECT_TRUE(world->is_awake(box));
        EXPECT_NEAR(double(world->position(box).x), 20 * double(speed), 0.01);
        EXPECT_TRUE(world->is_awake(ball));
    }
}

TEST(Sleep, WhatIsHeldOnABeltSleeps) {
    TestWorld world;
    ShapeDef belt;
    belt.tangent_speed = 0.02f;
    world.add_ground(0, 100, belt);
    const BodyId box = world.add_box({0, 0.5f});
    for (const float side : {-1.01f, 1.01f}) world.add_box({side, 0.5f}, 0.5f, 0.5f, {}, BodyType::static_body);
    world.step(60 * 20);
    EXPECT_FALSE(world->is_awake(box));
}

// A box of 100 kg comes down on a board of 0.2 kg that lies on the ground, or leans on the box. However deep it presses, both come to rest.
TEST(Sleep, HeavyBoxesOnLightBoardsDo) {
    int awake = 0;
    constexpr int starts = slow_build ? 4 : 40;
    for (int start = 0; start < starts; ++start) {
        Random random(static_cast<std::uint64_t>(start));
        TestWorld world;
        world.add_ground();
        const BodyId board = world.add_box({0, random.between(0.6f, 4)}, 0.5f, 0.1f);
        world->set_transform(board, world->position(board), random.between(-3, 3));
        const BodyId box = world.add_box({random.between(-0.5f, 0.5f), random.between(5, 6)}, 0.5f, 0.5f, dense(100));
        world->set_transform(box, world->position(box), random.between(-3, 3));
        world.step(600);
        awake += world->report().awake_bodies != 0 ? 1 : 0;
    }
    EXPECT_LE(awake, starts / 20);  // two in five were, and shook at 2 to 8 cm/s
}

// A disabled body takes part in nothing: what its weld bore before does not keep the other body awake, even if that is more than the weld may bear now.
TEST(Sleep, WhatIsWeldedToADisabledBodySleeps) {
    TestWorld world;
    world.add_ground();
    const BodyId box = world.add_box({0, 0.5f}), other = world.add_box({1.01f, 0.5f});
    WeldJointDef weld;
    weld.base = {.body_a = box, .body_b = other, .frame_a = {{0.505f, 0}}, .frame_b = {{-0.505f, 0}}, .break_force = 1e6f};
    const JointId joint = world->create_joint(weld);
    world.step(20);
    world->set_enabled(other, false);
    world->set_break(joint, 0.1f * length(world->joint_force(joint)), 0);
    world.step(120);
    EXPECT_FALSE(world->is_awake(box));
    EXPECT_TRUE(world->is_valid(joint));
}

// A weld holds a box still, until gravity pulls harder than it can bear. If that is so from the very step in which the box would fall asleep, the weld breaks all
// the same. (It did not: the box slept on, and its joint was marked in a way that no image may have.)
TEST(Sleep, AJointThatBreaksInTheStepInWhichItsBodyWouldSleepBreaks) {
    const auto hang = [](TestWorld& world) {
        const BodyId hook = world->create_body({}), box = world.add_box({0, -1});
        WeldJointDef weld;
        weld.base = {.body_a = hook, .body_b = box, .frame_b = {{0, 1}}, .break_force = 2 * static_cast<float>(g) * world->mass(box)};
        return std::pair{box, world->create_joint(weld)};
    };
    int asleep_after = 0;
    {
        TestWorld world;
        const BodyId box = hang(world).first;
        for (; world->is_awake(box); ++asleep_after) world.step();
    }
    ASSERT_GT(asleep_after, 20);
    for (int before = 0; before < 5; ++before) {
        TestWorld world;
        const auto [box, weld] = hang(world);
        world.step(asleep_after - 1 - before);
        world->set_gravity({0, -3 * static_cast<float>(g)});  // which wakes nothing
        world.step();
        EXPECT_FALSE(world->is_valid(weld)) << before;
        EXPECT_EQ(world->broken_joints().size(), 1u) << before;
        EXPECT_TRUE(world->is_awake(box)) << before;
        EXPECT_EQ(world->validate(), nullptr) << before;
        world.step(30);
        EXPECT_LT(world->position(box).y, -1.5f) << before;
    }
}

}  // namespace
}  // namespace islet::test
