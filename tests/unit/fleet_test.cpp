// Fleets: each world comes to what a world by itself would, on any number of threads; what is copied, forked or reset is the same to the last bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "islet/fleet.hpp"
#include "islet/snapshot.hpp"
#include "support/random.hpp"
#include "support/task_threads.hpp"
#include "support/test_world.hpp"

namespace {

using namespace islet;
using namespace islet::test;

constexpr float dt = 1.0f / 60, not_a_number = std::numeric_limits<float>::quiet_NaN(), endless = std::numeric_limits<float>::infinity();
constexpr Capacity small{.bodies = 16, .shapes = 16, .contacts = 64, .joints = 8, .geometries = 8};

/// A cart on a floor with a pole, a driven wheel, a mouse joint that holds a ball, and loose boxes.
struct Yard {
    TestWorld w{small};
    BodyId cart, pole, wheel, ball, box;
    JointId hinge, axle, grip;

    Yard() {
        w.add_ground();
        cart = w.add_box({0, 0.5f}, 0.5f, 0.25f);
        pole = w.add_box({0, 1.25f}, 0.05f, 0.5f);
        wheel = w.add_circle({3, 0.5f});
        ball = w.add_circle({-3, 2}, 0.25f);
        box = w.add_box({6, 0.5f});
        w.add_box({6.1f, 1.5f});
        RevoluteJointDef hinge_def;
        hinge_def.base.body_a = cart;
        hinge_def.base.body_b = pole;
        hinge_def.base.frame_a.position = {0, 0.25f};
        hinge_def.base.frame_b.position = {0, -0.5f};
        hinge = w->create_joint(hinge_def);
        RevoluteJointDef axle_def;
        axle_def.base.body_a = box;
        axle_def.base.body_b = wheel;
        axle_def.base.frame_a.position = {-3, 0};
        axle_def.motor = {true, 0, 20};
        axle = w->create_joint(axle_def);
        MouseJointDef grip_def;
        grip_def.body = ball;
        grip_def.target = {-3, 2};
        grip = w->create_joint(grip_def);
        w.step(10);
    }

    std::vector<Drive> drives() const {
        return {{.kind = DriveKind::force_x, .body = cart, .scale = 10},
                {.kind = DriveKind::motor_speed, .joint = axle, .scale = 5},
                {.kind = DriveKind::target_y, .joint = grip, .scale = 2},
                {.kind = DriveKind::joint_torque, .joint = hinge, .scale = 0.5f}};
    }
    std::vector<Sense> senses() const {
        return {{.kind = SenseKind::position, .body = ball},
                {.kind = SenseKind::rotation, .body = pole},
                {.kind = SenseKind::velocity, .body = cart},
                {.kind = SenseKind::angular_velocity, .body = wheel},
                {.kind = SenseKind::joint, .joint = hinge},
                {.kind = SenseKind::touching, .body = wheel},
                {.kind = SenseKind::touching, .body = ball},
                {.kind = SenseKind::ray, .body = ball, .translation = {0, -4}}};
    }
};

/// A fleet and its memory.
struct TestFleet {
    Block block;
    Fleet* fleet;

    TestFleet(const World& prototype, std::uint32_t worlds, const TaskSystem& tasks = {})
        : block(Fleet::bytes(worlds, prototype.capacity(), tasks.workers)), fleet(Fleet::create(block.span(), prototype, worlds, tasks)) {}
    Fleet* operator->() const { return fleet; }
    World& operator[](std::uint32_t k) const { return (*fleet)[k]; }
};

std::vector<float> random_actions(std::size_t count, std::uint64_t seed) {
    Random random(seed);
    std::vector<float> actions(count);
    for (float& action : actions) action = random.between(-1, 1);
    return actions;
}

TEST(Fleet, EachWorldComesToWhatAWorldByItselfComesTo) {
    constexpr std::uint32_t worlds = 9;
    const Yard yard;
    const auto drives = yard.drives();
    const auto senses = yard.senses();
    for (const std::uint32_t workers : {1u, 3u}) {
        const TestFleet fleet(*yard.w, worlds, threads(workers));
        std::vector<std::unique_ptr<Yard>> alone;
        for (std::uint32_t k = 0; k < worlds; ++k) alone.push_back(std::make_unique<Yard>());
        std::vector<float> observations(worlds * columns(senses));
        for (std::uint64_t step = 0; step < 120; ++step) {
            const auto actions = random_actions(worlds * drives.size(), step);
            ASSERT_EQ(fleet->step({.dt = dt, .drives = drives, .actions = actions, .senses = senses, .observations = observations}), Error::none);
            for (std::uint32_t k = 0; k < worlds; ++k) {
                World& w = *alone[k]->w;
                const float* a = &actions[k * drives.size()];
                w.apply_force_to_center(yard.cart, {10 * a[0], 0});
                JointMotor motor = w.motor(yard.axle);
                motor.speed = 5 * a[1];
                w.set_motor(yard.axle, motor);
                w.set_target(yard.grip, {w.target(yard.grip).x, 2 * a[2]});
                w.apply_torque(yard.cart, -0.5f * a[3]);
                w.apply_torque(yard.pole, 0.5f * a[3]);
                w.step(dt);
            }
        }
        for (std::uint32_t k = 0; k < worlds; ++k) EXPECT_EQ(fleet[k].hash(), alone[k]->w->hash()) << "world " << k << ", " << workers << " workers";
        EXPECT_NE(fleet[0].hash(), fleet[1].hash()) << "the actions do nothing";
    }
}

TEST(Fleet, ObservationsAreWhatTheWorldSays) {
    const Yard yard;
    const TestFleet fleet(*yard.w, 2);
    const auto senses = yard.senses();
    std::vector<float> seen(2 * columns(senses), -7);
    const std::uint8_t mask[] = {0, 1};
    ASSERT_EQ(fleet->step({.dt = dt, .repeat = 3, .mask = mask, .senses = senses, .observations = seen}), Error::none);
    for (std::size_t i = 0; i < columns(senses); ++i) EXPECT_EQ(seen[i], -7) << "a world that did not step was observed";
    EXPECT_EQ(fleet[0].hash(), yard.w->hash());

    yard.w->step(dt), yard.w->step(dt), yard.w->step(dt);
    const World& w = *yard.w;
    EXPECT_EQ(fleet[1].hash(), w.hash());
    const float below = transform_point(w.transform(yard.ball), {0, 0}).y;  // the ray goes 4 m down, and the floor is at 0
    const float wanted[] = {w.position(yard.ball).x, w.position(yard.ball).y, w.transform(yard.pole).q.c, w.transform(yard.pole).q.s,
                            w.linear_velocity(yard.cart).x, w.linear_velocity(yard.cart).y, w.angular_velocity(yard.wheel),
                            w.joint_position(yard.hinge), w.joint_speed(yard.hinge), 1, 0};
    for (std::size_t i = 0; i < std::size(wanted); ++i) EXPECT_EQ(seen[columns(senses) + i], wanted[i]) << "column " << i;
    EXPECT_NEAR(seen.back(), below / (4 * w.transform(yard.ball).q.c), 1e-5f);
}

TEST(Fleet, WhatIsGoneFromAWorldIsNotDrivenAndReadsZero) {
    const Yard yard;
    const TestFleet fleet(*yard.w, 2);
    const auto drives = yard.drives();
    const auto senses = yard.senses();
    for (const BodyId gone : {yard.cart, yard.pole, yard.wheel, yard.ball}) fleet[1].destroy_body(gone);
    const auto actions = random_actions(2 * drives.size(), 1);
    std::vector<float> seen(2 * columns(senses), -7);
    const std::size_t errors = yard.w.errors.size();
    ASSERT_EQ(fleet->step({.dt = dt, .drives = drives, .actions = actions, .senses = senses, .observations = seen}), Error::none);
    EXPECT_EQ(yard.w.errors.size(), errors);
    for (std::size_t i = 0; i < columns(senses); ++i) EXPECT_EQ(seen[columns(senses) + i], 0) << "column " << i;
}

TEST(Fleet, CopiesAndForksGoOnAsTheirOriginals) {
    const Yard yard;
    constexpr std::uint32_t worlds = 20;  // more than one worker takes at a time
    const TestFleet fleet(*yard.w, worlds, threads(2));
    const auto drives = yard.drives();
    for (std::uint64_t step = 0; step < 30; ++step) {
        const auto actions = random_actions(worlds * drives.size(), step);
        ASSERT_EQ(fleet->step({.dt = dt, .drives = drives, .actions = actions}), Error::none);
    }
    fleet[4].destroy_body(yard.box);  // its touches have ended, which the next step tells
    ASSERT_EQ(fleet->copy(4, 0), Error::none);
    EXPECT_EQ(fleet[0].hash(), fleet[4].hash());
    const std::uint32_t parents[worlds] = {0, 2, 2, 0, 4, 2, 2, 7, 7, 0, 10, 11, 4, 4, 15, 15, 2, 0, 15, 19};
    ASSERT_EQ(fleet->fork(parents), Error::none);
    ASSERT_EQ(fleet->step({.dt = dt}), Error::none);
    EXPECT_EQ(fleet[0].end_touch_events().size(), fleet[4].end_touch_events().size());
    EXPECT_GT(fleet[0].end_touch_events().size(), 0u);
    for (int i = 0; i < 60; ++i) ASSERT_EQ(fleet->step({.dt = dt}), Error::none);
    for (std::uint32_t k = 0; k < worlds; ++k) {
        EXPECT_EQ(fleet[k].hash(), fleet[parents[k]].hash()) << k;
        EXPECT_EQ(fleet[k].validate(), nullptr);
    }
    EXPECT_NE(fleet[0].hash(), fleet[2].hash());
}

TEST(Fleet, ResetsVaryWithTheSeedAlone) {
    const Yard yard;
    const TestFleet fleet(*yard.w, 3);
    std::vector<std::byte> image(yard.w->snapshot_bytes());
    yard.w->save(image);
    for (int i = 0; i < 20; ++i) ASSERT_EQ(fleet->step({.dt = dt}), Error::none);
    const Variation variations[] = {{.body = yard.ball, .position = {0.1f, 0.2f}, .velocity = {1, 2}, .angular_velocity = 3}};
    ASSERT_EQ(fleet->reset(0, image, 7, variations), Error::none);
    ASSERT_EQ(fleet->reset(1, image, 7, variations), Error::none);
    ASSERT_EQ(fleet->reset(2, image), Error::none);
    EXPECT_EQ(fleet[0].hash(), fleet[1].hash());
    EXPECT_EQ(fleet[2].hash(), yard.w->hash());
    float most = 0, sum = 0;
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
        ASSERT_EQ(fleet->reset(1, image, seed, variations), Error::none);
        const float by = fleet[1].position(yard.ball).y - yard.w->position(yard.ball).y;
        most = std::max(most, std::abs(by));
        sum += by;
    }
    EXPECT_LE(most, 0.2f + 1e-6f);
    EXPECT_GT(most, 0.19f);                   // of 1000 draws, all below it once in 10^22
    EXPECT_LT(std::abs(sum) / 1000, 0.015f);  // four of the mean's standard deviations, 0.2 m / sqrt(3) / sqrt(1000)
}

TEST(Fleet, RefusesWhatIsWrongAndChangesNothing) {
    const Yard yard;
    const TestFleet fleet(*yard.w, 2);
    const auto drives = yard.drives();
    const auto senses = yard.senses();
    std::vector<float> actions(2 * drives.size()), seen(2 * columns(senses));
    const std::uint64_t before = fleet[0].hash() ^ fleet[1].hash();
    const auto expect = [&](Error wanted, const FleetStep& step) { EXPECT_EQ(fleet->step(step), wanted) << describe(wanted); };
    expect(Error::bad_time_step, {.dt = 0});
    expect(Error::bad_time_step, {.dt = not_a_number});
    expect(Error::out_of_range, {.repeat = 0});
    expect(Error::out_of_range, {.repeat = 1001});
    expect(Error::out_of_range, {.drives = drives, .actions = span<const float>(actions).first(actions.size() - 1)});
    expect(Error::out_of_range, {.actions = actions});
    expect(Error::out_of_range, {.senses = senses, .observations = span<float>(seen).first(seen.size() - 1)});
    const std::uint8_t mask[] = {1};
    expect(Error::out_of_range, {.mask = mask});
    const Drive no_drive[] = {{.kind = static_cast<DriveKind>(99)}}, unscaled[] = {{.scale = not_a_number}};
    const float two[] = {0, 0}, bad[] = {0, not_a_number};
    expect(Error::out_of_range, {.drives = no_drive, .actions = two});
    expect(Error::not_finite, {.drives = unscaled, .actions = two});
    expect(Error::not_finite, {.drives = span<const Drive>(drives).first(1), .actions = bad});
    const Sense no_sense[] = {{.kind = static_cast<SenseKind>(99)}}, no_ray[] = {{.kind = SenseKind::ray, .translation = {not_a_number, 0}}};
    expect(Error::out_of_range, {.senses = no_sense});
    expect(Error::not_finite, {.senses = no_ray, .observations = span<float>(seen).first(2)});
    const Drive bodiless[] = {{.kind = DriveKind::torque, .joint = yard.hinge}}, jointless[] = {{.kind = DriveKind::motor_force, .body = yard.cart}};
    expect(Error::null_id, {.drives = bodiless, .actions = two});
    expect(Error::null_id, {.drives = jointless, .actions = two});
    const Sense of_nobody[] = {{.kind = SenseKind::touching, .joint = yard.hinge}}, of_no_joint[] = {{.kind = SenseKind::joint, .body = yard.cart}};
    expect(Error::null_id, {.senses = of_nobody, .observations = span<float>(seen).first(2)});
    expect(Error::null_id, {.senses = of_no_joint, .observations = span<float>(seen).first(4)});
    EXPECT_EQ(fleet->observe(senses, {}), Error::out_of_range);
    EXPECT_EQ(fleet->copy(0, 2), Error::out_of_range);
    EXPECT_EQ(fleet->copy(2, 0), Error::out_of_range);
    const std::uint32_t orphans[] = {1, 0}, few[] = {0}, far[] = {0, 2};
    EXPECT_EQ(fleet->fork(orphans), Error::out_of_range);
    EXPECT_EQ(fleet->fork(few), Error::out_of_range);
    EXPECT_EQ(fleet->fork(far), Error::out_of_range);
    EXPECT_EQ(fleet->reset(0, {}), Error::truncated_image);
    std::vector<std::byte> image(yard.w->snapshot_bytes());
    yard.w->save(image);
    EXPECT_EQ(fleet->reset(2, image), Error::out_of_range);
    const Variation narrow[] = {{.body = yard.ball, .angle = -1}}, endless_one[] = {{.body = yard.ball, .velocity = {0, endless}}};
    EXPECT_EQ(fleet->reset(0, image, 1, narrow), Error::out_of_range);
    EXPECT_EQ(fleet->reset(0, image, 1, endless_one), Error::not_finite);
    EXPECT_EQ(fleet[0].hash() ^ fleet[1].hash(), before);
}

TEST(Fleet, IsMadeOnlyWhereThereIsRoom) {
    const Yard yard;
    const std::size_t bytes = Fleet::bytes(4, small);
    const Block block(bytes + world_alignment);
    Error error = Error::none;
    EXPECT_EQ(Fleet::create(block.span().first(bytes - 1), *yard.w, 4, {}, &error), nullptr);
    EXPECT_EQ(error, Error::block_too_small);
    EXPECT_EQ(Fleet::create(block.span().subspan(8), *yard.w, 4, {}, &error), nullptr);
    EXPECT_EQ(error, Error::block_misaligned);
    EXPECT_EQ(Fleet::create(block.span(), *yard.w, 0, {}, &error), nullptr);
    EXPECT_EQ(error, Error::out_of_range);
    EXPECT_EQ(Fleet::create(block.span(), *yard.w, 1, {nullptr, nullptr, max_workers + 1}, &error), nullptr);
    EXPECT_EQ(error, Error::out_of_range);
    EXPECT_NE(Fleet::create(block.span(), *yard.w, 4, {}, &error), nullptr);
    EXPECT_EQ(error, Error::none);
    EXPECT_EQ(Fleet::bytes(Fleet::max_worlds + 1, small), 0u);
}

// A world of this size by itself needs 105 kB where lanes are eight wide, most of it memory that only a step needs.
TEST(Fleet, AWorldOfSixteenBodiesTakesLessThan40Kilobytes) {
    constexpr Capacity capacity{.bodies = 16, .shapes = 16, .contacts = 64, .joints = 8};
    EXPECT_LT(Fleet::bytes(1024, capacity, 2) / 1024, 40000u);
    EXPECT_GT(Fleet::bytes(2, capacity) - Fleet::bytes(1, capacity), max_snapshot_bytes(capacity));
}

}  // namespace
