// The problems that the laboratory measures: scaled without changing what solves them, and taken from worlds as the worlds pose them.
#include <gtest/gtest.h>

#include <cmath>

#include "lab/islands.hpp"
#include "lab/reference.hpp"
#include "small_problems.hpp"
#include "support/test_world.hpp"

namespace islet::test {
namespace {

TEST(LabProblem, ScalingMakesTheDiagonalAndTheResidualOfZeroOne) {
    // Diagonal 4 and 9: x is multiplied by 2 and 3, q divided by them, so q = (-4, 1); then everything is divided by 4.
    const lab::ScaledProblem s = lab::scale(two_rows());
    EXPECT_EQ(s.unit, 4);
    EXPECT_EQ(s.problem.values, (std::vector<double>{1, 2.0 / 6, 2.0 / 6, 1}));
    EXPECT_EQ(s.problem.q, (std::vector<double>{-1, 0.25}));
    EXPECT_EQ(s.problem.warm, (std::vector<double>{0.75, 0}));
    EXPECT_EQ(lab::residual_of(s.problem, {0, 0}), 1);
}

TEST(LabProblem, TheScaledSolutionIsTheProblemsOwn) {
    const lab::ScaledProblem s = lab::scale(two_rows());
    EXPECT_EQ(lab::residual_of(s.problem, {1, 0}), 0);
    EXPECT_EQ(1 * s.scale[0], 2);
    // And with friction, where rows have unequal diagonals: a heavy normal row and a light friction row.
    lab::Problem p = owned(tower_case(4, 0.5, 0.1));
    for (std::size_t i = 0; i < p.rows(); ++i) {
        const double stretch = i % 2 == 0 ? 3 : 0.2;
        p.q[i] *= stretch;
        if (i % 2 == 1) p.hi[i] *= 3 / 0.2;  // x of a stretched row is smaller by the stretch
        for (std::uint32_t k = p.row_starts[i]; k < p.row_starts[i + 1]; ++k) p.values[k] *= stretch * (p.columns[k] % 2 == 0 ? 3 : 0.2);
    }
    const lab::ScaledProblem scaled = lab::scale(p);
    std::vector<double> x = lab::find_reference(scaled.problem, 100).x;
    EXPECT_LE(lab::residual_of(scaled.problem, x), 1e-10);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] *= scaled.scale[i];
    EXPECT_LE(lab::residual_of(p, x), 1e-9);
}

TEST(LabProblem, EnergyNormIsTheRootOfTwiceTheEnergy) {
    // An impulse of 3 N s on a body of 4 kg: m v^2 = 9 / 4.
    lab::Problem p = two_rows();
    p.values = {0.25, 0, 0, 1};
    EXPECT_DOUBLE_EQ(lab::energy_norm(p, {3, 0}), 1.5);
}

/// A square box of 1 m and 1 kg at rest on the ground, some steps old; its inertia is 1 / 6 kg m^2.
class RestingBox : public testing::Test {
protected:
    RestingBox() {
        world.add_ground();
        world.add_box({0, 0.5f});
    }
    TestWorld world{{.bodies = 8, .shapes = 8, .contacts = 32, .joints = 1}, {.gravity = {0, -10}, .enable_sleep = false}};
    static constexpr float h = 1.0f / 240;
};

TEST_F(RestingBox, PosesTheProblemThatItsLeversSay) {
    world.step(40);
    const std::vector<lab::Island> islands = lab::islands_of(*world, h);
    ASSERT_EQ(islands.size(), 1u);
    const lab::Island& island = islands[0];
    EXPECT_EQ(island.bodies, 1u);
    EXPECT_EQ(island.contacts, 1u);
    EXPECT_EQ(island.joints, 0u);
    const lab::Problem& p = island.problem;
    ASSERT_EQ(p.rows(), 4u);
    EXPECT_EQ(p.blocks, (std::vector<std::uint32_t>{0}));
    double pushed = 0;
    for (std::uint32_t i = 0; i < 4; ++i) {
        // All levers are half a metre: 1 / m + r^2 / I = 1 + 6 / 4. It has sunk into the ground by a hair.
        for (std::uint32_t k = p.row_starts[i]; k < p.row_starts[i + 1]; ++k) {
            if (p.columns[k] == i) { EXPECT_NEAR(p.values[k], 2.5, 0.02); }
        }
        if (p.friction[i] != lcp::no_row) continue;
        EXPECT_NEAR(p.q[i], -10.0 / 240, 1e-3) << "a substep's fall";
        EXPECT_EQ(p.lo[i], 0);
        EXPECT_EQ(p.hi[i], std::numeric_limits<double>::infinity());
        pushed += p.warm[i];
    }
    EXPECT_NEAR(pushed, 10.0 / 240, 1e-3) << "the points carry the weight";
}

TEST_F(RestingBox, IsTheExportedProblemButForRounding) {
    world.step(40);
    std::vector<std::byte> memory(100'000);
    IslandProblem exported;
    ASSERT_GT(world->export_island(world->body_at(1), h, memory, exported), 0u);
    const lab::Problem p = lab::problem_of(exported);
    ASSERT_EQ(p.rows(), exported.rows.size());
    const std::vector<double> x = {0.3, -0.1, 0.2, 0.05};
    const std::vector<double> w = lab::row_values(p, x);
    for (std::size_t i = 0; i < p.rows(); ++i) {
        double sum = double(exported.lcp.q[i]);
        for (std::uint32_t k = exported.lcp.sparse.row_starts[i]; k < exported.lcp.sparse.row_starts[i + 1]; ++k)
            sum += double(exported.lcp.sparse.values[k]) * x[exported.lcp.sparse.columns[k]];
        EXPECT_NEAR(w[i], sum, 1e-5);
    }
}

TEST_F(RestingBox, IslandsComeLargestFirstAndOnceEach) {
    world.add_box({5, 0.5f});
    world.add_box({5, 1.5f});
    world.add_box({-5, 50});
    world.step(40);
    const std::vector<lab::Island> islands = lab::islands_of(*world, h);
    ASSERT_EQ(islands.size(), 2u) << "what flies touches nothing";
    EXPECT_EQ(islands[0].bodies, 2u);
    EXPECT_EQ(islands[0].problem.rows(), 8u);
    EXPECT_EQ(islands[0].problem.blocks, (std::vector<std::uint32_t>{0, 4}));
    EXPECT_EQ(islands[1].bodies, 1u);
    EXPECT_EQ(islands[1].index, 1u);
}

}  // namespace
}  // namespace islet::test
