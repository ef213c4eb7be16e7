// Bodies that a solve reads and writes in lanes: bit by bit what the formulas of the headers give for each alone.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <vector>

#include "solver/body_vectors.hpp"
#include "support/random.hpp"

#if ISLET_BODY_VECTORS

namespace {

using namespace islet;
using namespace islet::detail;
using namespace islet::test;

struct Records {
    std::vector<Pose> poses;
    std::vector<Motion> motions;
    std::vector<Body> bodies;
    std::vector<SolverBody> solved;
    std::vector<SolverMotion> motions_solved;
    std::vector<PlanIndex> body_of;
};

// Slots in an order of their own; slot 0 stands for static bodies.
Records random_records(std::uint64_t seed, std::uint32_t count) {
    Random random(seed);
    const auto vector = [&](float reach) { return Vec2{random.between(-reach, reach), random.between(-reach, reach)}; };
    Records r{std::vector<Pose>(count), std::vector<Motion>(count), std::vector<Body>(count), std::vector<SolverBody>(count + 1),
              std::vector<SolverMotion>(count + 1), std::vector<PlanIndex>(count + 1)};
    for (std::uint32_t i = 0; i < count; ++i) {
        r.body_of[i + 1] = static_cast<PlanIndex>((i * 7 + 3) % count);
        const bool is_dynamic = !random.one_in(5);
        const float inv_mass = is_dynamic ? random.between(0.1f, 9) : 0, inv_inertia = is_dynamic && !random.one_in(4) ? random.between(0.1f, 9) : 0;
        r.poses[i] = {vector(100), make_rot(random.between(-3, 3)), inv_mass, inv_inertia, 1, 77};
        r.motions[i].v = random.one_in(4) ? Vec2{-0.0f, 0} : vector(30);
        r.motions[i].w = random.one_in(4) ? -0.0f : random.between(-9, 9);
        r.motions[i].force = random.one_in(2) ? Vec2{} : vector(50);
        r.motions[i].torque = random.one_in(2) ? 0 : random.between(-9, 9);
        r.motions[i].slack = random.between(0, 1);
        r.motions[i].sleep_time = random.between(0, 1);
        r.bodies[i].linear_damping = random.one_in(2) ? 0 : random.between(0, 2);
        r.bodies[i].angular_damping = random.one_in(2) ? 0 : random.between(0, 2);
        r.bodies[i].gravity_scale = random.one_in(3) ? random.between(-2, 2) : 1;
        r.bodies[i].stretch = random.one_in(3) ? random.between(0, 4) : 0;
        SolverBody& b = r.solved[i + 1];
        b.v = random.one_in(4) ? Vec2{} : vector(30);
        b.w = random.between(-9, 9);
        b.dp = vector(0.5f);
        b.dq = random.one_in(4) ? 0 : random.between(-1.5f, 1.5f);
    }
    return r;
}

void expect_bits(float a, float b, const char* what, std::uint32_t slot) {
    ASSERT_EQ(std::bit_cast<std::uint32_t>(a), std::bit_cast<std::uint32_t>(b)) << what << " of slot " << slot << ": " << a << " and " << b;
}

TEST(BodiesInLanes, AreReadAsEachAlone) {
    constexpr float h = 1.0f / 240;
    constexpr Vec2 gravity = {0.7f, -10};
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        constexpr std::uint32_t count = 31;  // prime to the 7 that slots step by
        Records r = random_records(seed, count);
        const std::vector<Body> before = r.bodies;
        const BodyInput in{r.solved.data(), r.motions_solved.data(), r.body_of.data(), r.poses.data(), r.motions.data(), r.bodies.data(), gravity, h};
        ASSERT_EQ((read_bodies<Lane4>(in, 1, count + 1)), 29u) << "seven blocks of four";
        for (std::uint32_t slot = 1; slot < 29; ++slot) {
            const std::uint32_t i = r.body_of[slot];
            const Pose& pose = r.poses[i];
            const Motion& motion = r.motions[i];
            const Body& body = before[i];
            const SolverBody& b = r.solved[slot];
            const SolverMotion& m = r.motions_solved[slot];
            const bool moves = pose.inv_mass > 0;
            expect_bits(b.v.x, motion.v.x + 0.0f, "v.x", slot);
            expect_bits(b.v.y, motion.v.y + 0.0f, "v.y", slot);
            expect_bits(b.w, motion.w + 0.0f, "w", slot);
            expect_bits(b.inv_mass, pose.inv_mass, "inverse mass", slot);
            // The inertia is at least the stretch.
            expect_bits(b.inv_inertia, body.stretch * pose.inv_inertia > 1 ? 1 / body.stretch : pose.inv_inertia, "inverse inertia", slot);
            expect_bits(b.warm_v.x, 0, "warm start", slot);
            expect_bits(b.warm_w, 0, "warm start", slot);
            expect_bits(m.v_free.x, 0, "free velocity", slot);
            expect_bits(m.a.x, moves ? h * (body.gravity_scale * gravity.x + pose.inv_mass * motion.force.x) : 0, "gain along x", slot);
            expect_bits(m.a.y, moves ? h * (body.gravity_scale * gravity.y + pose.inv_mass * motion.force.y) : 0, "gain along y", slot);
            expect_bits(m.alpha, moves ? h * (pose.inv_inertia * motion.torque) : 0, "gain of the turn", slot);
            expect_bits(m.linear_factor, moves ? 1 / (1 + h * body.linear_damping) : 1, "damping", slot);
            expect_bits(m.angular_factor, moves ? 1 / (1 + h * body.angular_damping) : 1, "damping of the turn", slot);
            EXPECT_EQ(r.bodies[i].stretch, 0);
        }
    }
}

TEST(BodiesInLanes, AreWrittenAsEachAlone) {
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        constexpr std::uint32_t count = 31;
        Records r = random_records(seed, count);
        r.poses[r.body_of[2]].center = {max_position, -max_position};  // goes no farther
        const std::vector<Pose> poses = r.poses;
        const std::vector<Motion> motions = r.motions;
        const BodyOutput out{r.solved.data(), r.body_of.data(), r.poses.data(), r.motions.data(), 1e4f, 100};
        ASSERT_EQ((write_bodies<Lane4>(out, 1, count + 1)), 29u);
        for (std::uint32_t slot = 1; slot < 29; ++slot) {
            const std::uint32_t i = r.body_of[slot];
            const SolverBody& b = r.solved[slot];
            const Rot q = b.dq != 0 ? integrate(poses[i].q, b.dq) : poses[i].q;
            const Vec2 center = poses[i].center + b.dp;
            expect_bits(r.poses[i].center.x, std::fmax(std::fmin(center.x, max_position), -max_position), "x", slot);
            expect_bits(r.poses[i].center.y, std::fmax(std::fmin(center.y, max_position), -max_position), "y", slot);
            expect_bits(r.poses[i].q.c, q.c, "cosine", slot);
            expect_bits(r.poses[i].q.s, q.s, "sine", slot);
            expect_bits(r.motions[i].v.x, b.v.x + 0.0f, "v.x", slot);
            expect_bits(r.motions[i].v.y, b.v.y + 0.0f, "v.y", slot);
            expect_bits(r.motions[i].w, b.w, "w", slot);
            expect_bits(r.motions[i].force.x, 0, "force", slot);
            expect_bits(r.motions[i].force.y, 0, "force", slot);
            expect_bits(r.motions[i].torque, 0, "torque", slot);
            EXPECT_EQ(r.motions[i].slack, motions[i].slack);
            EXPECT_EQ(r.motions[i].sleep_time, motions[i].sleep_time);
            EXPECT_EQ(r.poses[i].inv_mass, poses[i].inv_mass);
            EXPECT_EQ(r.poses[i].flags, poses[i].flags);
        }
    }
}

// What is too fast, turns too far or is no number is left to the loop over single bodies, with its whole block.
TEST(BodiesInLanes, WhatIsNotOrdinaryIsLeft) {
    const float nan = std::nanf("");
    const auto written = [](auto&& change) {
        Records r = random_records(1, 31);
        change(r, r.solved[7]);
        const BodyOutput out{r.solved.data(), r.body_of.data(), r.poses.data(), r.motions.data(), 1e4f, 100};
        return write_bodies<Lane4>(out, 1, 32);
    };
    constexpr std::uint32_t before_its_block = 5;
    EXPECT_EQ(written([](Records&, SolverBody&) {}), 29u);
    EXPECT_EQ(written([](Records&, SolverBody& b) { b.v = {101, 0}; }), before_its_block);
    EXPECT_EQ(written([&](Records&, SolverBody& b) { b.v = {0, nan}; }), before_its_block);
    EXPECT_EQ(written([](Records&, SolverBody& b) { b.w = -101; }), before_its_block);
    EXPECT_EQ(written([](Records&, SolverBody& b) { b.dq = 1.6f; }), before_its_block);
    EXPECT_EQ(written([&](Records&, SolverBody& b) { b.dq = nan; }), before_its_block);
    EXPECT_EQ(written([&](Records&, SolverBody& b) { b.dp = {nan, 0}; }), before_its_block);
    EXPECT_EQ(written([](Records&, SolverBody& b) { b.dp = {0, 1e30f}; }), before_its_block);
    EXPECT_EQ(written([](Records& r, SolverBody&) { r.poses[r.body_of[7]].q = {0, 0}; }), before_its_block) << "no direction";
}

}  // namespace

#endif
