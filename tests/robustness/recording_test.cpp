// Recordings: what they hold, what happens when they are damaged, and when there is no room.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <vector>

#include "support/busy_world.hpp"
#include "support/forge.hpp"
#include "support/random.hpp"
#include "support/test_world.hpp"
#include "calls/recorder.hpp"

namespace islet::test {
namespace {

/// Memory for a recording.
struct Tape {
    explicit Tape(std::size_t size) : block(size), bytes(block.span()) {}
    Block block;
    std::span<std::byte> bytes;
};

// Calls every function that changes a world, so that each changes something, with steps between them.
void make_every_call(World& w) {
    const BodyId ground = w.create_body({});
    const Vec2 hills[] = {{40, 1}, {20, 0}, {0, 0}, {-20, 0}, {-40, 3}};
    w.create_chain(ground, hills, false, {.friction = 0.5f});
    const ShapeId edge = w.create_shape(ground, ChainSegment{{60, 0}, {{50, 0}, {40, 1}}, {30, 2}});
    BodyId bodies[8];
    for (std::uint32_t i = 0; i < 8; ++i)
        bodies[i] = w.create_body({.type = BodyType::dynamic, .position = {-8 + 2.5f * static_cast<float>(i), 1.5f}, .user_data = 77});
    const ShapeId disc = w.create_shape(bodies[0], Circle{{}, 0.4f});
    const ShapeId pill = w.create_shape(bodies[1], Capsule{{-0.3f, 0}, {0.3f, 0}, 0.2f});
    const ShapeId line = w.create_shape(bodies[2], Segment{{-0.4f, 0}, {0.4f, 0}});
    const ShapeId crate = w.create_shape(bodies[2], make_box(0.4f, 0.3f));
    for (int i = 3; i < 8; ++i) w.create_shape(bodies[i], make_box(0.3f, 0.3f));
    const BodyId platform = w.create_body({.type = BodyType::kinematic, .position = {0, 8}});
    w.create_shape(platform, make_box(1, 0.1f));
    w.step(1.0f / 60);

    w.set_gravity({0.5f, -9});
    SolverDef solver = w.solver();
    solver.substeps = 5;
    w.set_solver(solver);
    w.enable_continuous(false);
    w.enable_seamless_floors(false);
    w.set_hit_threshold(0.5f);
    w.set_restitution_threshold(0.8f);
    w.set_max_speed(300);
    w.explode({.position = {0, 0.5f}, .radius = 2, .falloff = 2, .impulse_per_length = 3});
    w.step(1.0f / 60);
    w.enable_sleep(false);
    w.set_transform(bodies[0], {-9, 3}, 0.3f);
    w.set_transform(bodies[0], Transform{{-9, 3.1f}, make_rot(0.2f)});
    w.set_linear_velocity(bodies[0], {1, 2});
    w.set_angular_velocity(bodies[0], 3);
    w.set_target(platform, Transform{{0.1f, 8.1f}, make_rot(0.1f)}, 1.0f / 60);
    w.apply_force(bodies[1], {10, 20}, {-5, 1});
    w.apply_force_to_center(bodies[1], {1, 2});
    w.apply_torque(bodies[1], 3);
    w.apply_linear_impulse(bodies[2], {0.1f, 0.2f}, {-3, 1.4f});
    w.apply_linear_impulse_to_center(bodies[2], {0.1f, 0.3f});
    w.apply_angular_impulse(bodies[2], 0.01f);
    w.step(1.0f / 60);
    w.set_type(bodies[3], BodyType::kinematic);
    w.set_mass(bodies[4], {3, {0.01f, 0}, 0.2f});
    w.set_mass(bodies[5], {4, {0.02f, 0}, 0.3f});
    w.reset_mass(bodies[5]);
    w.set_linear_damping(bodies[4], 0.1f);
    w.set_angular_damping(bodies[4], 0.2f);
    w.set_gravity_scale(bodies[4], 0.9f);
    w.set_fixed_rotation(bodies[5], true);
    w.lock_x(bodies[6], true);
    w.lock_y(bodies[7], true);
    w.set_enabled(bodies[0], false);
    w.set_bullet(bodies[1], true);
    w.enable_sleep(bodies[1], false);
    w.set_sleep_threshold(bodies[2], 0.1f);
    w.wake(bodies[2]);
    w.set_user_data(bodies[2], 0x123456789abcdef0ull);
    w.step(1.0f / 60);
    w.set_circle(disc, Circle{{0.1f, 0}, 0.5f});
    w.set_capsule(pill, Capsule{{-0.2f, 0}, {0.3f, 0}, 0.25f});
    w.set_segment(line, Segment{{-0.5f, 0}, {0.4f, 0.1f}});
    w.set_polygon(crate, make_box(0.3f, 0.35f));
    w.set_density(crate, 2);
    w.set_friction(crate, 0.3f);
    w.set_restitution(crate, 0.2f);
    w.set_rolling_resistance(disc, 0.1f);
    w.set_tangent_speed(pill, 0.5f);
    w.set_material(line, {.friction = 0.1f, .restitution = 0.4f, .id = 9});
    w.enable_sensor_events(pill, false);
    w.set_sensor(crate, true);
    w.set_chain_segment(edge, ChainSegment{{62, 0}, {{52, 0}, {40, 1}}, {30, 2}});
    w.enable_hit_events(pill, true);
    w.enable_pre_solve(crate, true);
    w.apply_wind(crate, {.velocity = {30, 0}});
    w.set_filter(line, {.category = 2, .mask = 4, .group = -3});
    w.set_user_data(line, 5);
    w.step(1.0f / 60);
    const BodyId machine_base = w.create_body({.position = {100, 0}});
    static_cast<void>(machine_base);
    add_machine(w, {100, 10});
    JointId joints[16];
    std::uint32_t count = 0;
    for (std::uint32_t slot = 0; slot < w.capacity().joints && count < 16; ++slot)
        if (const JointId id = w.joint_at(slot)) joints[count++] = id;
    w.step(1.0f / 60);
    for (std::uint32_t i = 0; i < count; ++i) {
        w.set_user_data(joints[i], i);
        w.set_frames(joints[i], {{0.1f, 0}, 0.1f}, {{0, 0.1f}, 0});
        w.set_collide_connected(joints[i], true);
        w.set_break(joints[i], 1e6f, 1e6f);
        w.set_spring(joints[i], {true, 3, 0.5f, 0.1f});
        w.set_limit(joints[i], {true, -1, 1});
        w.set_motor(joints[i], {true, 1, 2});
        w.set_joint_friction(joints[i], 0.2f);
        w.set_joint_length(joints[i], 1.5f);
        w.set_joint_velocity(joints[i], {0.1f, 0.2f}, 0.3f);
        w.set_joint_strength(joints[i], 5, 6);
        w.set_target(joints[i], Vec2{101, 11});
        w.set_softness(joints[i], {.linear_hertz = 4, .linear_damping_ratio = 0.6f});
        w.set_grounds(joints[i], {99, 13}, {102, 14});
        w.set_joint_ratio(joints[i], 1.5f);
    }
    for (int i = 0; i < 5; ++i) w.step(1.0f / 60);
    w.enable_sleep(true);
    w.sleep(bodies[4]);
    for (const BodyId body : {bodies[2], bodies[4]}) {
        w.apply_force(body, {1, 2}, {-5, 1}, false);
        w.apply_force_to_center(body, {0.1f, 0.2f}, false);
        w.apply_torque(body, 0.3f, false);
        w.apply_linear_impulse(body, {0.01f, 0.02f}, {-3, 1.4f}, false);
        w.apply_linear_impulse_to_center(body, {0.01f, 0.03f}, false);
        w.apply_angular_impulse(body, 0.001f, false);
    }
    w.step(1.0f / 60);
    w.destroy_joint(joints[0]);
    w.destroy_shape(pill);
    w.destroy_body(bodies[7]);
    w.create_shape(bodies[1], make_box(-1, 1));  // what fails is made again too
    w.step(-1);
    w.step(1.0f / 60);
}

TEST(Recording, HoldsEveryCallOnce) {
    Tape tape(1 << 20);
    TestWorld w({.bodies = 64, .shapes = 64, .contacts = 256, .joints = 32});
    ASSERT_TRUE(w->start_recording(tape.bytes));
    make_every_call(*w);
    const std::size_t size = w->stop_recording();
    ASSERT_GT(size, 0u);
    TestWorld other({.bodies = 64, .shapes = 64, .contacts = 256, .joints = 32}, {.lanes = 1});
    const ReplayResult result = replay(*other, tape.bytes.first(size));
    EXPECT_EQ(result.end, ReplayEnd::complete) << describe(result.error) << " step " << result.steps;
    EXPECT_EQ(other->hash(), w->hash());
    EXPECT_EQ(result.steps, w->step_count());
    // What the hash leaves out.
    for (std::uint32_t slot = 0; slot < 64; ++slot) {
        if (const BodyId body = w->body_at(slot)) {
            EXPECT_EQ(w->user_data(body), other->user_data(body));
        }
    }
    for (std::uint32_t slot = 0; slot < 32; ++slot) {
        if (const JointId joint = w->joint_at(slot)) {
            EXPECT_EQ(w->user_data(joint), other->user_data(joint));
        }
    }
}

// A call and an argument of 32 bits take four bytes, an id eight. Pushes that wake are recorded as ever, so that earlier versions read them.
TEST(Recording, OnlyPushesThatDoNotWakeSayWhetherTheyDo) {
    Tape tape(1 << 16);
    TestWorld w;
    const BodyId box = w.add_box({0, 0});
    ASSERT_TRUE(w->start_recording(tape.bytes));
    const auto bytes_of = [&](auto call) {
        const std::size_t before = w->recorded_bytes();
        call();
        return w->recorded_bytes() - before;
    };
    for (const bool wake : {true, false}) {
        const std::size_t more = wake ? 0 : 4;
        EXPECT_EQ(bytes_of([&] { w->apply_force(box, {1, 0}, {2, 0}, wake); }), 28 + more);
        EXPECT_EQ(bytes_of([&] { w->apply_force_to_center(box, {1, 0}, wake); }), 20 + more);
        EXPECT_EQ(bytes_of([&] { w->apply_torque(box, 1, wake); }), 16 + more);
        EXPECT_EQ(bytes_of([&] { w->apply_linear_impulse(box, {1, 0}, {2, 0}, wake); }), 28 + more);
        EXPECT_EQ(bytes_of([&] { w->apply_linear_impulse_to_center(box, {1, 0}, wake); }), 20 + more);
        EXPECT_EQ(bytes_of([&] { w->apply_angular_impulse(box, 1, wake); }), 16 + more);
    }
}

TEST(Recording, PushesThatDoNotWakeLeaveBodiesAsleepInReplays) {
    Tape tape(1 << 16);
    TestWorld w, other;
    w.add_ground();
    const BodyId box = w.add_box({0, 0.5f});
    ASSERT_TRUE(w->start_recording(tape.bytes));
    for (int i = 0; i < 90; ++i) {
        w->apply_force_to_center(box, {1, 0}, false);
        w.step();
    }
    ASSERT_FALSE(w->is_awake(box));
    const ReplayResult result = replay(*other, tape.bytes.first(w->stop_recording()));
    EXPECT_EQ(result.end, ReplayEnd::complete) << describe(result.error) << " step " << result.steps;
    EXPECT_FALSE(other->is_awake(box));
    EXPECT_EQ(other->hash(), w->hash());
}

TEST(Recording, BeginsAtAnyStepAndStopsAtAnyStep) {
    Tape tape(1 << 20);
    TestWorld w(busy_capacity);
    fill_busy(*w);
    ASSERT_TRUE(w->start_recording(tape.bytes));
    std::vector<std::uint64_t> hashes;
    for (int i = 0; i < 20; ++i) {
        w->step(1.0f / 60);
        hashes.push_back(w->hash());
    }
    const std::size_t size = w->stop_recording();
    for (const std::uint64_t until : {1u, 7u, 19u}) {
        TestWorld other(busy_capacity);
        const ReplayResult result = replay(*other, tape.bytes.first(size), until);
        EXPECT_EQ(result.end, ReplayEnd::stopped);
        EXPECT_EQ(result.steps, until);
        EXPECT_EQ(other->hash(), hashes[until - 1]);
    }
}

TEST(Recording, GoesOnOverARestoredSnapshot) {
    Tape tape(1 << 20);
    TestWorld w(busy_capacity);
    fill_busy(*w);
    std::vector<std::uint64_t> image(w->snapshot_bytes() / 8 + 1);
    const auto bytes = std::as_writable_bytes(std::span(image));
    const std::size_t saved = w->save(bytes);
    ASSERT_TRUE(w->start_recording(tape.bytes));
    for (int i = 0; i < 4; ++i) w->step(1.0f / 60);
    ASSERT_TRUE(w->restore(bytes.first(saved)));
    w->step(1.0f / 60);
    ASSERT_TRUE(w->load(bytes.first(saved)));
    w->set_gravity({1, 1});
    w->step(1.0f / 60);
    const std::size_t size = w->stop_recording();
    TestWorld other(busy_capacity);
    const ReplayResult result = replay(*other, tape.bytes.first(size));
    EXPECT_EQ(result.end, ReplayEnd::complete) << describe(result.error);
    EXPECT_EQ(other->hash(), w->hash());
}

TEST(Recording, SaysWhichStepAndWhichBodyDiffers) {
    // Two boxes fall on the ground; the world it is replayed in has a hook that lets the second one through. Both fall alike until it would land.
    Tape tape(1 << 20);
    const Capacity capacity{.bodies = 8, .shapes = 8, .contacts = 16};
    TestWorld w(capacity);
    w.add_ground();
    w.add_box({0, 2}), w.add_box({10, 2});
    ASSERT_TRUE(w->start_recording(tape.bytes));
    std::uint64_t landed = 0;
    for (std::uint64_t i = 1; i <= 60; ++i) {
        w->step(1.0f / 60);
        if (landed == 0 && !w->begin_touch_events().empty()) landed = i;
    }
    const std::size_t size = w->stop_recording();
    ASSERT_GT(landed, 10u);
    WorldDef def;
    def.hooks.filter = [](ShapeId, ShapeId b, void*) { return b.index1 != 3; };
    TestWorld other(capacity, def);
    const ReplayResult result = replay(*other, tape.bytes.first(size));
    EXPECT_EQ(result.end, ReplayEnd::differs);
    EXPECT_NEAR(double(result.steps), double(landed), 6) << "the pair is found a little before it touches";
    EXPECT_NE(result.hash, result.recorded_hash);
    EXPECT_EQ(result.hash, other->hash());
    // The hash differs as soon as the contact is missing; the bodies, once it bears.
    const bool is_second = result.body == other->body_at(2) || !result.body;
    EXPECT_TRUE(is_second) << result.body.index1;
}

TEST(Recording, NamesTheBodyThatDiffers) {
    // Two boxes slide over the ground; in the world of the replay a hook takes the friction of the second one's contact away: from the
    // first step on that one alone moves otherwise.
    Tape tape(1 << 20);
    const Capacity capacity{.bodies = 8, .shapes = 8, .contacts = 16};
    TestWorld w(capacity);
    w.add_ground();
    w.add_box({0, 0.5f}, 0.5f, 0.5f, {.pre_solve = true});
    const BodyId second = w.add_box({10, 0.5f}, 0.5f, 0.5f, {.pre_solve = true});
    w.step(10);
    for (std::uint32_t slot = 1; slot < 3; ++slot) w->set_linear_velocity(w->body_at(slot), {5, 0});
    ASSERT_TRUE(w->start_recording(tape.bytes));
    w.step(20);
    const std::size_t size = w->stop_recording();
    WorldDef def;
    def.hooks.pre_solve = [](PreSolve& asked, void*) {
        if (asked.contact.shape_a.index1 == 3 || asked.contact.shape_b.index1 == 3) asked.friction = 0;
    };
    TestWorld other(capacity, def);
    const ReplayResult result = replay(*other, tape.bytes.first(size));
    EXPECT_EQ(result.end, ReplayEnd::differs);
    EXPECT_EQ(result.steps, 1u);
    EXPECT_EQ(result.body.index1, second.index1);
}

TEST(Recording, AnyByteChangedIsFound) {
    Tape tape(1 << 18);
    TestWorld w({.bodies = 16, .shapes = 16, .contacts = 32, .joints = 4});
    w.add_ground();
    for (int i = 0; i < 6; ++i) w.add_box({0.1f * static_cast<float>(i), 1 + 1.1f * static_cast<float>(i)});
    ASSERT_TRUE(w->start_recording(tape.bytes));
    for (int i = 0; i < 6; ++i) {
        w->set_linear_velocity(w->body_at(3), {static_cast<float>(i), 0});
        w->set_user_data(w->body_at(2), std::uint64_t(i));
        w->step(1.0f / 60);
    }
    const std::size_t size = w->stop_recording();
    Tape damaged(size);
    TestWorld other({.bodies = 16, .shapes = 16, .contacts = 32, .joints = 4});
    std::size_t missed = 0;
    Random random(7);
    for (std::size_t at = 0; at < size; ++at) {
        std::memcpy(damaged.bytes.data(), tape.bytes.data(), size);
        damaged.bytes[at] ^= static_cast<std::byte>(1u << random.below(8));
        const ReplayResult result = replay(*other, damaged.bytes);
        if (result.end == ReplayEnd::complete || result.end == ReplayEnd::stopped) ++missed, ADD_FAILURE() << "byte " << at;
        ASSERT_LT(missed, 5u);
        ASSERT_EQ(other->validate(), nullptr);
    }
}

TEST(Recording, OneThatWasNeverEndedIsReplayedAsFarAsItGoes) {
    Tape tape(1 << 18);
    TestWorld w(busy_capacity);
    fill_busy(*w);
    ASSERT_TRUE(w->start_recording(tape.bytes));
    for (int i = 0; i < 9; ++i) w->step(1.0f / 60);
    TestWorld other(busy_capacity);
    const ReplayResult result = replay(*other, tape.bytes);
    EXPECT_EQ(result.end, ReplayEnd::complete);
    EXPECT_EQ(result.steps, 9u);
    EXPECT_EQ(other->hash(), w->hash());
}

TEST(Recording, WithoutRoomItEndsByItselfAndKeepsWhatItHas) {
    Tape tape(1 << 14), larger(1 << 18);
    TestWorld w({.bodies = 16, .shapes = 16, .contacts = 32});
    w.add_ground();
    for (int i = 0; i < 6; ++i) w.add_box({0, 1 + 1.1f * static_cast<float>(i)});
    ASSERT_TRUE(w->start_recording(tape.bytes));
    std::uint64_t steps = 0;
    for (; w->is_recording() && steps < 10000; ++steps) w->step(1.0f / 60);
    EXPECT_EQ(w->last_error(), Error::recording_full);
    EXPECT_EQ(w->recorded_bytes(), 0u);
    TestWorld other({.bodies = 16, .shapes = 16, .contacts = 32});
    const ReplayResult result = replay(*other, tape.bytes);
    EXPECT_EQ(result.end, ReplayEnd::complete);
    EXPECT_GE(result.steps + 1, steps);
    EXPECT_GT(result.steps, 20u);

    // Moved in time it goes on.
    ASSERT_TRUE(w->start_recording(tape.bytes));
    for (int i = 0; i < 10; ++i) w->step(1.0f / 60);
    ASSERT_TRUE(w->move_recording(larger.bytes));
    for (int i = 0; i < 1000; ++i) w->step(1.0f / 60);
    const std::size_t size = w->stop_recording();
    EXPECT_EQ(replay(*other, larger.bytes.first(size)).steps, 1010u);
    EXPECT_EQ(other->hash(), w->hash());
}

TEST(Recording, BadArgumentsAreRefused) {
    Tape tape(1 << 16);
    TestWorld w({.bodies = 4, .shapes = 4, .contacts = 8});
    EXPECT_EQ(w->stop_recording(), 0u);
    EXPECT_EQ(w->last_error(), Error::not_a_recording);
    EXPECT_FALSE(w->move_recording(tape.bytes));
    EXPECT_FALSE(w->start_recording(tape.bytes.first(40)));
    EXPECT_EQ(w->last_error(), Error::recording_full);
    EXPECT_FALSE(w->start_recording(tape.bytes.subspan(4)));
    EXPECT_EQ(w->last_error(), Error::image_misaligned);
    EXPECT_FALSE(w->is_recording());
    std::memset(tape.bytes.data(), 0, tape.bytes.size());
    RecordingInfo info;
    EXPECT_EQ(read_recording(tape.bytes, info), Error::not_a_recording);
    EXPECT_EQ(read_recording({}, info), Error::not_a_recording);
    EXPECT_EQ(replay(*w, tape.bytes).end, ReplayEnd::refused);
    ASSERT_TRUE(w->start_recording(tape.bytes));
    w->step(1.0f / 60);
    const std::size_t size = w->stop_recording();
    EXPECT_EQ(read_recording(tape.bytes.first(size - 4), info), Error::truncated_image);
    std::reverse(tape.bytes.begin(), tape.bytes.begin() + 4);  // as a machine of the other byte order would have begun
    EXPECT_EQ(read_recording(tape.bytes.first(size), info), Error::other_byte_order);
    std::reverse(tape.bytes.begin(), tape.bytes.begin() + 4);
    TestWorld small({.bodies = 1, .shapes = 1, .contacts = 1});
    EXPECT_EQ(replay(*small, tape.bytes.first(size)).end, ReplayEnd::complete) << "an empty world fits anywhere";
}

// -- what a recording asks for ----------------------------------------------------------------------------------------------------------

// Whatever the world's capacity was: what its calls cannot fill is not asked for, and what is asked for is enough.
TEST(RecordingNeeds, NoMoreThanWhatItHolds) {
    Tape tape(1 << 20);
    TestWorld w({.bodies = 100'000, .shapes = 150'000, .contacts = 200'000, .joints = 1000});
    ASSERT_TRUE(w->start_recording(tape.bytes));
    make_every_call(*w);
    for (int i = 0; i < 30; ++i) w->step(1.0f / 60);
    const std::size_t size = w->stop_recording();
    ASSERT_NE(size, 0u);
    RecordingInfo info;
    ASSERT_EQ(read_recording(tape.bytes.first(size), info), Error::none);
    EXPECT_EQ(info.capacity, w->capacity());
    EXPECT_LE(info.needed.bodies, 40u);
    EXPECT_GE(info.needed.bodies, w->body_count());
    EXPECT_LE(info.needed.shapes, 60u);
    EXPECT_GE(info.needed.shapes, w->shape_count());
    EXPECT_LE(info.needed.contacts, 60u * 60u);
    EXPECT_LE(info.needed.joints, 40u);
    EXPECT_GE(info.needed.joints, w->joint_count());
    EXPECT_LT(world_bytes(info.needed), 100 * size);
    TestWorld other(info.needed);
    const ReplayResult result = replay(*other, tape.bytes.first(size));
    EXPECT_EQ(result.end, ReplayEnd::complete) << describe(result.error) << ", step " << result.steps;
    EXPECT_EQ(other->hash(), w->hash());
    EXPECT_EQ(other.errors, w.errors);
}

// Where the recorded world ran out of room, the one that replays it must run out too.
TEST(RecordingNeeds, AsMuchAsTheWorldHadIfItWasFull) {
    Tape tape(1 << 20);
    TestWorld w({.bodies = 12, .shapes = 11, .contacts = 9, .joints = 2, .geometries = 5, .hits = 3});
    ASSERT_TRUE(w->start_recording(tape.bytes));
    w.add_ground();
    for (int i = 0; i < 20; ++i) {
        const BodyId box = w.add_box({0.8f * static_cast<float>(i % 5), 1 + static_cast<float>(i / 5)}, 0.5f, 0.3f + 0.1f * static_cast<float>(i % 6), {.hit_events = true});
        w->create_joint(MouseJointDef{.body = box});
        w.step(3);
    }
    const std::size_t size = w->stop_recording();
    RecordingInfo info;
    ASSERT_EQ(read_recording(tape.bytes.first(size), info), Error::none);
    EXPECT_EQ(info.needed, w->capacity());
    TestWorld other(info.needed);
    EXPECT_EQ(replay(*other, tape.bytes.first(size)).end, ReplayEnd::complete);
    EXPECT_EQ(other->hash(), w->hash());
    EXPECT_EQ(other.errors, w.errors);
}

// Snapshots that a world is taken back to count as well, and what is made after them.
TEST(RecordingNeeds, WhatItsSnapshotsHold) {
    TestWorld full(busy_capacity);
    fill_busy(*full);
    const Image image = save(*full);
    Tape tape(1 << 20);
    TestWorld w;
    ASSERT_TRUE(w->start_recording(tape.bytes));
    w.step(2);
    ASSERT_TRUE(w->load(image.bytes()));
    w.step(5);
    w.add_box({50, 50});
    w.step(5);
    const std::size_t size = w->stop_recording();
    RecordingInfo info;
    ASSERT_EQ(read_recording(tape.bytes.first(size), info), Error::none);
    SnapshotInfo held;
    ASSERT_EQ(read_snapshot(image.bytes(), held), Error::none);
    EXPECT_EQ(info.needed.bodies, held.used.bodies + 1);
    EXPECT_EQ(info.needed.shapes, held.used.shapes + 1);
    EXPECT_EQ(info.needed.joints, held.used.joints);
    TestWorld other(info.needed);
    EXPECT_EQ(replay(*other, tape.bytes.first(size)).end, ReplayEnd::complete);
    EXPECT_EQ(other->hash(), w->hash());
}

// A file that is damaged, or never ended, needs what is whole in it; and no lie about its capacity goes beyond that.
TEST(RecordingNeeds, NothingForALieInItsHead) {
    Tape tape(1 << 16);
    TestWorld w({.bodies = 40, .shapes = 40, .contacts = 90});
    ASSERT_TRUE(w->start_recording(tape.bytes));
    w.add_ground();
    for (int i = 0; i < 10; ++i) w.add_box({0.8f * static_cast<float>(i), 1});
    w.step(20);
    const std::size_t size = w->stop_recording();
    const Capacity huge{.bodies = max_capacity, .shapes = max_capacity, .contacts = max_capacity, .joints = max_capacity, .geometries = max_capacity, .hits = max_capacity};
    const auto lie = [&](const Capacity& capacity) {
        detail::ImageHeader h;
        std::byte* image = tape.bytes.data() + sizeof(detail::RecordingHead);
        std::memcpy(&h, image, sizeof h);
        h.set_capacity(capacity);
        std::memcpy(image, &h, sizeof h);
        seal({image, static_cast<std::size_t>(h.head.length)});
    };
    lie(huge);
    RecordingInfo info;
    ASSERT_EQ(read_recording(tape.bytes.first(size), info), Error::none);
    EXPECT_LE(info.needed.bodies, 12u) << "11, and an empty snapshot needs 1";
    EXPECT_LE(info.needed.shapes, 12u);
    EXPECT_LE(info.needed.contacts, 144u);
    EXPECT_EQ(info.needed.joints, 0u);
    TestWorld other(info.needed);
    EXPECT_EQ(replay(*other, tape.bytes.first(size)).end, ReplayEnd::complete);
    EXPECT_EQ(other->hash(), w->hash());
    // A thousand times damaged: still bounded by the bytes there are.
    Random random(3);
    for (int i = 0; i < 1000; ++i) {
        Tape torn(size);
        std::memcpy(torn.bytes.data(), tape.bytes.data(), size);
        const detail::RecordingHead* head = reinterpret_cast<const detail::RecordingHead*>(tape.bytes.data());
        const std::size_t first = detail::calls_at(head->image_bytes);
        for (std::uint32_t flips = 1 + random.below(4); flips > 0; --flips)
            torn.bytes[first + random.below(static_cast<std::uint32_t>(size - first))] = static_cast<std::byte>(random.below(256));
        RecordingInfo of_torn;
        ASSERT_EQ(read_recording(torn.bytes, of_torn), Error::none);
        EXPECT_LE(of_torn.needed.bodies, size / 8);
        EXPECT_LE(of_torn.needed.shapes, size / 8);
        EXPECT_LE(of_torn.needed.joints, size / 8);
    }
}

// An image from outside says what its world could hold; less than it holds itself is a lie.
TEST(RecordingNeeds, AnImageOfLessCapacityThanItUsesIsCorrupt) {
    TestWorld w;
    w.add_ground();
    w.add_box({0, 0.5f});
    w.step(2);
    for (const bool bodies : {true, false}) {
        Image image = save(*w);
        detail::ImageHeader h = header_of(image.bytes());
        Capacity capacity = h.capacity();
        (bodies ? capacity.bodies : capacity.contacts) = 0;
        h.set_capacity(capacity);
        std::memcpy(image.bytes().data(), &h, sizeof h);
        seal(image.bytes());
        SnapshotInfo info;
        EXPECT_EQ(read_snapshot(image.bytes(), info), Error::corrupt_image);
        EXPECT_FALSE(w->load(image.bytes()));
        EXPECT_EQ(w->last_error(), Error::corrupt_image);
    }
}

}  // namespace
}  // namespace islet::test
