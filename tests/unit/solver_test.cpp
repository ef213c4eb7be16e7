// The contact kernel: every width gives the same bits, the numbers are those of a plain solver, and a converged solve obeys the contact laws.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "contact_problem.hpp"
#include "support/test_world.hpp"

namespace {

using namespace islet;
using namespace islet::detail;
using namespace islet::test;

SweepNumbers soft_numbers() {
    SweepNumbers n;
    n.inv_h = 240;
    n.bias_rate = 9.0f;
    n.mass_scale = 0.9f;
    n.impulse_scale = 0.1f;
    n.push_speed = 3;
    return n;
}

SweepNumbers rigid_numbers() {
    SweepNumbers n;
    n.inv_h = 240;
    return n;
}

SweepNumbers baumgarte_numbers() {
    SweepNumbers n;
    n.inv_h = 240;
    n.bias_rate = 48;
    n.push_speed = 3;
    n.slop = 0.005f;
    return n;
}

// -- widths ------------------------------------------------------------------------------------------------------------------------------

void expect_same_bits(const Solved& a, const Solved& b) {
    for (std::size_t i = 1; i < a.bodies.size(); ++i)
        ASSERT_EQ(std::memcmp(&a.bodies[i], &b.bodies[i], sizeof(SolverBody)), 0) << "body " << i << ": " << a.bodies[i].v.x << " and " << b.bodies[i].v.x;
    for (std::size_t i = 0; i < a.manifolds.size(); ++i)
        ASSERT_EQ(std::memcmp(&a.manifolds[i], &b.manifolds[i], sizeof(ContactManifold)), 0) << "contact " << i;
}

TEST(ContactKernel, OneLaneAndFourGiveTheSameBits) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        for (const std::uint32_t per_group : {1u, 3u, 4u, 7u, 32u}) {  // with padding and without
            const ContactProblem p = random_problem(seed, 5, per_group, true);
            const Solved one = run_kernel<Lane1>(p, soft_numbers(), rigid_numbers(), 4, true);
            const Solved four = run_kernel<Lane4>(p, soft_numbers(), rigid_numbers(), 4, true);
            ASSERT_NO_FATAL_FAILURE(expect_same_bits(one, four)) << "seed " << seed << ", " << per_group << " contacts a group";
            ASSERT_TRUE(is_finite(one.bodies[1].v));
        }
    }
}

// Two blocks of a colour are solved at once if both have as many points, whatever else their contacts have; else one by one.
TEST(ContactKernel, BlocksInTwosGiveTheBitsOfEachAlone) {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        for (const std::uint32_t per_group : {3u, 8u, 11u, 32u, 65u}) {
            ContactProblem p = random_problem(seed, 4, per_group, seed % 2 == 0);
            Random random(seed);
            for (ContactManifold& m : p.manifolds) {
                if (seed % 5 == 0 && random.one_in(4)) m.flags |= contact_ahead;  // lands
                if (seed % 7 == 0 && random.one_in(4)) m.flags |= 1u << contact_sharers_shift;
            }
            SweepNumbers soft = soft_numbers();
            soft.shares = seed % 7 == 0;
            const Solved one = run_kernel<Lane1>(p, soft, rigid_numbers(), 4, true);
            ASSERT_NO_FATAL_FAILURE(expect_same_bits(one, run_kernel<Lane4>(p, soft, rigid_numbers(), 4, true, true)))
                << "seed " << seed << ", " << per_group << " contacts a group";
        }
    }
}

TEST(ContactKernel, TheLanesOfAWorldDoNotChangeItsBits) {
    const auto run = [](std::uint32_t lanes, Schedule schedule) {
        WorldDef def;
        def.lanes = lanes;
        def.solver.schedule = schedule;
        if (schedule == Schedule::classic) def.solver.substeps = 1, def.solver.iterations = 8;
        TestWorld w(roomy, def);
        w.add_ground();
        for (int i = 0; i < 100; ++i) {
            ShapeDef shape;
            shape.restitution = i % 3 == 0 ? 0.5f : 0;
            shape.rolling_resistance = i % 4 == 0 ? 0.1f : 0;
            shape.tangent_speed = i % 5 == 0 ? 1.0f : 0;
            const Vec2 at{0.4f * static_cast<float>(i % 9), 1 + 0.4f * static_cast<float>(i)};
            i % 2 == 0 ? w.add_box(at, 0.4f, 0.3f, shape) : w.add_circle(at, 0.35f, shape);
        }
        std::vector<std::uint64_t> hashes;
        for (int i = 0; i < 200; ++i) {
            w.step();
            hashes.push_back(w->hash());
        }
        return hashes;
    };
    for (const Schedule schedule : {Schedule::soft, Schedule::classic}) {
        const auto one = run(1, schedule);
        EXPECT_EQ(one, run(4, schedule));
        EXPECT_EQ(one, run(8, schedule));  // four, where the processor has no eight
        EXPECT_EQ(one, run(0, schedule));
    }
}

// -- a plain solver ------------------------------------------------------------------------------------------------------------------------

void compare_with_plain(const SweepNumbers& first, const SweepNumbers& second, int sweeps, bool surfaces) {
    int compared = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        ContactProblem p = random_problem(seed, 3, 6, false);
        if (surfaces) {
            for (std::size_t c = 0; c < p.manifolds.size(); c += 2) {
                p.materials[c].tangent_speed = 1.5f;
                p.manifolds[c].flags |= contact_special;
            }
        }
        PlainSolver plain(p);
        for (int i = 0; i < sweeps; ++i) {
            plain.sweep(first);
            plain.integrate();
            plain.sweep(second);
        }
        if (plain.on_edge) continue;
        ++compared;
        const Solved got = run_kernel<Lane4>(p, first, second, sweeps, false);
        // Single precision, through a few sweeps of numbers around one.
        const auto expect_near = [](float value, double expected) { EXPECT_NEAR(wide(value), expected, 2e-4 * (1 + std::abs(expected))); };
        for (std::size_t i = 1; i < p.bodies.size(); ++i) {
            expect_near(got.bodies[i].v.x, plain.bodies[i].v.x);
            expect_near(got.bodies[i].v.y, plain.bodies[i].v.y);
            expect_near(got.bodies[i].w, plain.bodies[i].w);
        }
        for (std::size_t c = 0; c < p.manifolds.size(); ++c) {
            for (std::uint32_t i = 0; i < p.manifolds[c].count(); ++i) {
                expect_near(got.manifolds[c].normal_impulse[i], plain.impulses[c].n[i]);
                expect_near(got.manifolds[c].tangent_impulse[i], plain.impulses[c].t[i]);
            }
        }
        ASSERT_FALSE(testing::Test::HasFailure()) << "seed " << seed;
    }
    EXPECT_GE(compared, 15);
}

// One round: a speculative contact then closes its gap exactly, and a soft row jumps at a separation of 0, where rounding alone would decide.
TEST(ContactKernel, MatchesAPlainSolverForSoftContacts) { compare_with_plain(soft_numbers(), rigid_numbers(), 1, false); }
TEST(ContactKernel, MatchesAPlainSolverForBaumgarte) { compare_with_plain(baumgarte_numbers(), baumgarte_numbers(), 2, false); }
TEST(ContactKernel, MatchesAPlainSolverWithMovingSurfaces) { compare_with_plain(rigid_numbers(), rigid_numbers(), 2, true); }

// -- the contact laws ----------------------------------------------------------------------------------------------------------------------

// Towers of bodies thrown at the ground, every contact closed.
ContactProblem towers(std::uint64_t seed) {
    Random random(seed);
    ContactProblem p;
    p.numbers.dt = p.numbers.h = 1.0f / 60;
    p.numbers.inv_h = 60;
    p.numbers.warm = 0;
    p.add_body({}, 0, 0);
    for (int tower = 0; tower < 4; ++tower) {
        std::uint32_t below = 0;
        for (int floor = 0; floor < 5; ++floor) {
            const Vec2 center{3.0f * static_cast<float>(tower), 0.5f + static_cast<float>(floor)};
            const float mass = random.between(0.5f, 2);
            const Vec2 v{random.between(-0.5f, 0.5f), random.between(-4, 0.5f)};
            const std::uint32_t body = p.add_body(center, mass, mass / 6, v, random.between(-1, 1));
            const Vec2 foot = center - Vec2{0, 0.5f} - p.poses[below].center;
            p.add_contact(static_cast<std::size_t>(floor), below, body, {0, 1}, {foot - Vec2{0.5f, 0}, foot + Vec2{0.5f, 0}}, random.between(0, 1));
            below = body;
        }
    }
    return p;
}

struct Speeds {
    double n, t;
};

// Relative velocity at a point, in double precision, from what the kernel left.
Speeds speeds_at(const ContactProblem& p, const Solved& s, std::size_t c, std::uint32_t i) {
    PlainSolver view(p);
    for (std::size_t b = 0; b < s.bodies.size(); ++b) view.bodies[b] = {wide(s.bodies[b].v), {}, wide(s.bodies[b].w), 0, 0, 0};
    return {view.speed(c, i, view.normal(c)), view.speed(c, i, view.tangent(c))};
}

TEST(ContactKernel, AConvergedSolveObeysTheContactLaws) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        ContactProblem p = towers(seed);
        SweepNumbers rigid = rigid_numbers();
        rigid.inv_h = 60;
        p.numbers.h = 0;  // positions stay, so the separation stays 0
        const Solved s = run_kernel<Lane4>(p, rigid, rigid, 3000, false);
        int sliding = 0, open = 0, pressed = 0;
        for (std::size_t c = 0; c < p.manifolds.size(); ++c) {
            for (std::uint32_t i = 0; i < 2; ++i) {
                const double n = wide(s.manifolds[c].normal_impulse[i]), t = wide(s.manifolds[c].tangent_impulse[i]);
                const Speeds v = speeds_at(p, s, c, i);
                // Signorini: 0 <= lambda, 0 <= v_n, and one of them is 0.
                EXPECT_GE(n, 0);
                EXPECT_GE(v.n, -1e-4) << "seed " << seed;
                EXPECT_NEAR(n * v.n, 0, 1e-4) << "seed " << seed;
                // Coulomb: |lambda_t| <= mu lambda_n; below the bound it sticks, at the bound it slides against the impulse.
                const double bound = wide(p.manifolds[c].friction) * n;
                EXPECT_LE(std::abs(t), bound + 1e-5);
                const bool sticks = std::abs(t) < bound - 1e-3;
                EXPECT_NEAR(sticks ? v.t : 0, 0, 1e-3) << "seed " << seed;
                EXPECT_LE(t * v.t, 1e-4) << "friction pushes forward, seed " << seed;
                sliding += std::abs(v.t) > 1e-3 ? 1 : 0;
                open += v.n > 1e-3 ? 1 : 0;
                pressed += n > 1e-3 ? 1 : 0;
            }
        }
        EXPECT_GT(pressed, 0);
        EXPECT_GT(sliding + open, 0) << "the problem is too easy";
    }
}

TEST(ContactKernel, MomentumIsExchangedNotMade) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        ContactProblem p = random_problem(seed, 4, 8, true);
        for (ContactManifold& m : p.manifolds) {
            if (m.body_a == 0) m.body_a = m.body_b == 1 ? 2 : 1;  // no static body; groups no longer matter for one lane
            m.offset = p.poses[m.body_b].center - p.poses[m.body_a].center;
        }
        for (ContactManifold& m : p.manifolds) m.rotation_a = m.rotation_b = Rot{};
        for (Pose& pose : p.poses) pose.q = Rot{};
        const Solved s = run_kernel<Lane1>(p, soft_numbers(), rigid_numbers(), 3, true);
        // sum m v, and the angular momentum about the origin: sum m c x v + I w. Bodies that cannot turn take up any angular momentum.
        const auto momentum = [&](const std::vector<SolverBody>& bodies) {
            double px = 0, py = 0, l = 0;
            for (std::size_t i = 1; i < bodies.size(); ++i) {
                const SolverBody& b = bodies[i];
                const double m = 1 / wide(b.inv_mass);
                px += m * wide(b.v.x);
                py += m * wide(b.v.y);
                l += m * cross(wide(p.poses[i].center), wide(b.v)) + (b.inv_inertia > 0 ? wide(b.w) / wide(b.inv_inertia) : 0);
            }
            return std::vector<double>{px, py, l};
        };
        const bool all_turn = std::all_of(p.bodies.begin() + 1, p.bodies.end(), [](const SolverBody& b) { return b.inv_inertia > 0; });
        const auto before = momentum(p.bodies), after = momentum(s.bodies);
        EXPECT_NEAR(before[0], after[0], 2e-4) << "seed " << seed;
        EXPECT_NEAR(before[1], after[1], 2e-4) << "seed " << seed;
        EXPECT_NEAR(all_turn ? before[2] - after[2] : 0, 0, 1e-3) << "seed " << seed;
    }
}

TEST(ContactKernel, ABallBouncesWithItsRestitution) {
    for (const float e : {0.25f, 0.5f, 1.0f}) {
        for (const float speed : {0.5f, 2.0f, 5.0f}) {
            ContactProblem p;
            p.numbers.dt = p.numbers.h = 1.0f / 60;
            p.numbers.inv_h = 60;
            p.add_body({}, 0, 0);
            p.add_body({0, 1}, 2, 1, {1, -speed});
            p.add_contact(0, 0, 1, {0, 1}, {{0, 0}}, 0, {e, 0, 0});
            const Solved s = run_kernel<Lane4>(p, rigid_numbers(), rigid_numbers(), 1, true);
            const float rebound = speed > 1 ? e * speed : 0;  // slower than the threshold of 1 m/s it does not bounce
            EXPECT_NEAR(s.bodies[1].v.y, rebound, 1e-5f);
            EXPECT_EQ(s.bodies[1].v.x, 1.0f);
        }
    }
}

// Infinity less infinity is no number. A contact that does not bounce is left alone, whatever its neighbours in the block do, even if it has overflowed.
TEST(ContactKernel, WhatDoesNotBounceIsLeftAlone) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    constexpr std::uint32_t still = 2;  // the lane whose impulse overflowed
    for (const bool two_points : {false, true}) {
        std::vector<SolverBody> bodies(5);
        ContactRows<4> rows{};
        rows.bouncy = rows.rebounds = true;
        rows.two_points = two_points;
        for (std::uint32_t i = 0; i < 4; ++i) {
            bodies[i + 1].v = {0, -3};
            bodies[i + 1].inv_mass = bodies[i + 1].inv_inertia = 1;
            rows.body_b[i] = slot_scale<4> * (i + 1);
            rows.ny[i] = 1;
            rows.restitution[i] = i == still ? 0 : 0.5f;
            for (std::uint32_t k = 0; k < (two_points ? 2u : 1u); ++k) {
                rows.points[k].normal_mass[i] = 1;
                rows.points[k].normal_impulse[i] = i == still ? infinity : 1;
                rows.approach[k][i] = -3;
                rows.peak[k][i] = rows.points[k].normal_impulse[i];
            }
        }
        ContactKernel<4>::restitute(bodies.data(), &rows, 1, 1);
        EXPECT_EQ(bodies[still + 1].v.y, -3);
        EXPECT_EQ(rows.points[0].normal_impulse[still], infinity);
        EXPECT_FLOAT_EQ(bodies[1].v.y, 1.5f) << "half of what it came with";
    }
}

// An impulse that overflows leaves no number in the speed of a static body, whose share of it is 0 times infinity. What is solved again does not see that, in
// any number of lanes.
template <std::uint32_t W>
SolverBody land_with_overflow() {
    std::vector<SolverBody> bodies(2);
    bodies[1].v = {0, 2e30f};  // away from the static body: both impulses of before become 0
    bodies[1].inv_mass = bodies[1].inv_inertia = 1;
    ContactManifold manifold;
    ContactRows<W> rows{};
    set_contact(rows, 0, 0, &manifold);
    rows.body_b[0] = slot_scale<W>;
    *normal_y(rows) = 1;
    *friction_of(rows) = 1;
    rows.extra_passes[0] = 4;
    rows.points[0].rna[0] = -1;
    rows.points[0].rta[0] = 1e15f;
    rows.points[0].normal_mass[0] = 1;
    *normal_impulse_of(rows) = 1e30f;
    *tangent_impulse_of(rows) = 1e29f;
    ContactKernel<W>::solve(bodies.data(), &rows, 1, rigid_numbers());
    return bodies[1];
}

TEST(ContactKernel, WhatLandsDoesNotSeeTheOverflowOfAStaticBody) {
    const SolverBody one = land_with_overflow<1>(), four = land_with_overflow<4>();
    EXPECT_EQ(std::bit_cast<std::uint32_t>(one.v.x), std::bit_cast<std::uint32_t>(four.v.x));
    EXPECT_EQ(std::bit_cast<std::uint32_t>(one.v.y), std::bit_cast<std::uint32_t>(four.v.y));
    EXPECT_EQ(std::bit_cast<std::uint32_t>(one.w), std::bit_cast<std::uint32_t>(four.w));
}

TEST(ContactKernel, RollingResistanceStopsTurningUpToItsBound) {
    ContactProblem p;
    p.numbers.dt = p.numbers.h = 1.0f / 60;
    p.numbers.inv_h = 60;
    p.add_body({}, 0, 0);
    p.add_body({0, 1}, 1, 0.5f, {0, -2}, 3);  // lambda_n = 2
    p.numbers.h = 0;
    p.add_contact(0, 0, 1, {0, 1}, {{0, 0}}, 0, {0, 0.25f, 0});
    const Solved s = run_kernel<Lane4>(p, rigid_numbers(), rigid_numbers(), 1, false);
    EXPECT_NEAR(s.manifolds[0].normal_impulse[0], 2, 1e-6f);
    EXPECT_NEAR(s.manifolds[0].rolling_impulse, -0.25f * 2, 1e-6f);
    EXPECT_NEAR(s.bodies[1].w, 3 - 0.5f / 0.5f, 1e-6f);
}

}  // namespace
