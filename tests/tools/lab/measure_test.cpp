// What the laboratory says of a method is what the method does.
#include <gtest/gtest.h>

#include <cmath>

#include "lab/measure.hpp"
#include "small_problems.hpp"

namespace islet::test {
namespace {

using lab::find_method;

/// Quick: the clock's part in it is not looked at here.
lab::MeasureOptions quick(std::uint32_t iterations = 2000) {
    lab::MeasureOptions options;
    options.iterations = iterations;
    options.timing_seconds = 0;
    return options;
}

TEST(LabMeasure, TwoRowsByHand) {
    // Scaled: M = [1 1/3; 1/3 1], q = (-1, 1/4). A sweep from zero: x_0 = 1; then w_1 = 1/4 + 1/3, which must not pull: x_1 = 0. That is the solution.
    const lab::Problem p = lab::scale(two_rows()).problem;
    const lab::Reference reference = lab::find_reference(p, 100);
    ASSERT_TRUE(reference.exact());
    EXPECT_NEAR(reference.x[0], 1, 1e-12);
    EXPECT_NEAR(reference.x[1], 0, 1e-12);

    const lab::Measurement cold = lab::measure(p, *find_method("pgs"), false, reference, quick());
    ASSERT_EQ(cold.history.size(), 2u);
    EXPECT_EQ(cold.history[0].residual, 1);
    EXPECT_EQ(cold.history[1].residual, 0);
    EXPECT_EQ(cold.iterations, 1u);
    EXPECT_EQ(cold.velocity_error, 0);
    for (const auto& level : cold.reached) {
        ASSERT_TRUE(level);
        EXPECT_EQ(level->iterations, 1u);
    }

    // The warm start is 1.5 of 2, so x . M x differs by a quarter squared of the whole; its residual is what is missing.
    const lab::Measurement warm = lab::measure(p, *find_method("pgs"), true, reference, quick());
    EXPECT_DOUBLE_EQ(warm.history[0].residual, 0.25);
    EXPECT_DOUBLE_EQ(lab::velocity_error(p, p.warm, reference), 0.25);

    // A damped sweep from zero leaves 1 - omega of the first row after each iteration: (1 / 2)^k.
    const lab::Measurement psor = lab::measure(p, *find_method("psor"), false, reference, [] {
        lab::MeasureOptions o = quick();
        o.psor_omega = 0.5;
        return o;
    }());
    ASSERT_TRUE(psor.reached[0]);
    EXPECT_EQ(psor.reached[0]->iterations, 7u) << "2^-7 is the first below 1e-2";
    EXPECT_DOUBLE_EQ(psor.history[3].residual, 0.125);
}

TEST(LabMeasure, TheHistoryIsTheResidualOfWhatIsThereAfterSoManyIterations) {
    const lab::Problem p = lab::scale(owned(tower_case(6, 0.4, 0.1))).problem;
    const lab::Reference reference = lab::find_reference(p, 100);
    for (const lab::MethodInfo& info : lab::methods()) {
        if (info.method == lcp::Method::lemke) continue;
        SCOPED_TRACE(info.name);
        const lab::Measurement m = lab::measure(p, info, false, reference, quick(50));
        ASSERT_EQ(m.history.size(), m.iterations + 1);
        for (const std::uint32_t k : {1u, 2u, 5u, 12u}) {
            if (k >= m.history.size()) continue;
            lcp::Options<double> options;
            options.method = info.method;
            options.max_iterations = k;
            options.tolerance = 0;
            if (m.omega) options.omega = *m.omega;
            if (info.method == lcp::Method::block_pgs) options.blocks = p.blocks;
            std::vector<double> x(p.rows(), 0);
            lab::run_solver(p, options, x);
            EXPECT_EQ(m.history[k].iteration, k);
            EXPECT_EQ(m.history[k].residual, lcp::residuals<double>(p.view(), x).natural);
        }
    }
}

TEST(LabMeasure, ALevelIsReachedWhenTheResidualIsThereForTheFirstTime) {
    const lab::Problem p = lab::scale(owned(tower_case(6, 0.4, 0.1))).problem;
    const lab::Reference reference = lab::find_reference(p, 100);
    const lab::Measurement m = lab::measure(p, *find_method("nncg"), false, reference, quick());
    for (std::size_t level = 0; level < lab::levels.size(); ++level) {
        ASSERT_TRUE(m.reached[level]);
        const std::uint32_t k = m.reached[level]->iterations;
        EXPECT_LE(m.history[k].residual, lab::levels[level]);
        for (std::uint32_t i = 0; i < k; ++i) EXPECT_GT(m.history[i].residual, lab::levels[level]);
    }
    EXPECT_LT(m.reached[2]->velocity_error, m.reached[0]->velocity_error);
    const lab::Measurement short_run = lab::measure(p, *find_method("l1_jacobi"), false, reference, quick(3));
    EXPECT_EQ(short_run.iterations, 3u);
    EXPECT_FALSE(short_run.reached[2]);
}

TEST(LabMeasure, AnExactStartNeedsNothing) {
    lab::Problem p = lab::scale(two_rows()).problem;
    p.warm = {1, 0};
    const lab::Reference reference = lab::find_reference(p, 100);
    for (const lab::MethodInfo& info : lab::methods()) {
        SCOPED_TRACE(info.name);
        const lab::Measurement m = lab::measure(p, info, true, reference, quick());
        ASSERT_TRUE(m.reached[2]);
        EXPECT_EQ(m.reached[2]->iterations, 0u);
        EXPECT_EQ(m.reached[2]->seconds, 0);
    }
}

TEST(LabMeasure, TimeNeverRunsBackwards) {
    const lab::Problem p = lab::scale(owned(tower_case(3, 0.4, 0.1))).problem;
    const lab::Measurement m = lab::measure(p, *find_method("pgs"), false, lab::find_reference(p, 100), quick());
    for (std::size_t i = 1; i < m.history.size(); ++i) EXPECT_GE(m.history[i].seconds, m.history[i - 1].seconds);
    EXPECT_GT(m.history.back().seconds, 0);
    EXPECT_EQ(m.seconds, m.history.back().seconds);
}

TEST(LabMeasure, ImpulsesThatMoveNothingAreNoError) {
    // Both friction rows of a box on the ground say the same: what one pulls more the other may pull less.
    const lab::Problem p = lab::scale(owned(tower_case(1, 0.5, 0.01))).problem;
    const lab::Reference reference = lab::find_reference(p, 100);
    ASSERT_TRUE(reference.exact());
    std::vector<double> x = reference.x;
    x[1] += 0.01;
    x[3] -= 0.01;
    EXPECT_NEAR(lab::velocity_error(p, x, reference), 0, 1e-7);
    x[3] += 0.02;
    EXPECT_GT(lab::velocity_error(p, x, reference), 1e-3);
}

TEST(LabMeasure, LargeProblemsSpareTheDenseMethods) {
    const lab::Problem p = lab::scale(owned(tower_case(3, 0, 0))).problem;
    lab::MeasureOptions options = quick();
    options.dense_rows = p.rows() - 1;
    const lab::Reference reference = lab::find_reference(p, options.dense_rows);
    EXPECT_TRUE(reference.exact());
    EXPECT_NE(lab::measure(p, *find_method("newton"), false, reference, options).left_out, "");
    EXPECT_EQ(lab::measure(p, *find_method("pgs"), false, reference, options).left_out, "");
}

TEST(LabMeasure, JacobisOmegaIsBelowTwoByTheLargestEigenvalue) {
    // [1 1/3; 1/3 1] has 4/3: any omega up to 1.5 would do, so it is left at 1. Ones everywhere: n.
    EXPECT_EQ(lab::jacobi_omega(lab::scale(two_rows()).problem), 1);
    const lab::Problem ones = owned(lcp_case("ones", std::vector<double>(36, 1), std::vector<double>(6, -1)));
    EXPECT_NEAR(lab::jacobi_omega(ones), 1.8 / 6, 1e-9);
}

TEST(LabMeasure, ThinnedCurvesKeepTheirBeginningAndTheirEnd) {
    std::vector<lab::HistoryPoint> history;
    for (std::uint32_t k = 0; k <= 20'000; ++k) history.push_back({k, 0, 1});
    const std::vector<lab::HistoryPoint> few = lab::thinned(history);
    EXPECT_LT(few.size(), 450u);
    for (std::uint32_t k = 0; k <= 100; ++k) EXPECT_EQ(few[k].iteration, k);
    for (std::size_t i = 1; i < few.size(); ++i) EXPECT_GT(few[i].iteration, few[i - 1].iteration);
    EXPECT_EQ(few.back().iteration, 20'000u);
}

}  // namespace
}  // namespace islet::test
