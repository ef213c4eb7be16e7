// The matrix solvers on many problems: each method reaches its tolerance, or says that it did not, and what it says about x is what x is.
#include <gtest/gtest.h>

#include <cstring>

#include "lcp_problems.hpp"

namespace islet::test {
namespace {

using lcp::Method;
using lcp::Status;

const std::vector<Method> all_methods = {Method::pgs,    Method::psor,      Method::symmetric_pgs, Method::red_black, Method::block_pgs,
                                         Method::jacobi, Method::l1_jacobi, Method::nncg,          Method::newton,    Method::lemke};

const char* name_of(Method m) {
    const char* const names[] = {"pgs",    "psor",      "symmetric pgs", "red-black", "block pgs",
                                 "jacobi", "l1 jacobi", "nncg",          "newton",    "lemke"};
    return names[static_cast<std::size_t>(m)];
}

bool needs_dense_memory(Method m) { return m == Method::newton || m == Method::lemke; }

template <class T>
lcp::Options<T> options_for(Method method, const LcpData<T>& data, T tolerance, std::uint32_t limit) {
    lcp::Options<T> o;
    o.method = method;
    o.tolerance = tolerance;
    o.max_iterations = limit;
    if (method == Method::psor) o.omega = T(1.2);
    if (method == Method::jacobi) o.omega = T(0.5);
    if (method == Method::block_pgs) o.blocks = data.blocks;
    return o;
}

/// Runs a method and holds what it reports against our own residuals.
template <class T>
lcp::Result<T> expect_the_truth(const LcpCase& c, const LcpData<T>& data, const lcp::Options<T>& options) {
    SCOPED_TRACE(c.name + ", " + name_of(options.method) + (sizeof(T) == sizeof(float) ? ", float" : ", double"));
    const LcpRun<T> r = run(data.sparse_problem(), options);
    const OwnResiduals own = own_residuals(data, r.x);
    for (const T x : r.x) EXPECT_TRUE(std::isfinite(x));
    if (r.result.status == Status::converged) {
        EXPECT_LE(own.natural, options.tolerance + own.rounding);
        EXPECT_EQ(r.result.row, lcp::no_row);
    } else {
        EXPECT_GT(own.natural + own.rounding, options.tolerance) << lcp::describe(r.result.status);
        EXPECT_TRUE(r.result.status == Status::iteration_limit || r.result.status == Status::stalled ||
                    r.result.status == Status::diverged || r.result.status == Status::singular || r.result.status == Status::ray ||
                    r.result.status == Status::bad_diagonal)
            << lcp::describe(r.result.status);
    }
    EXPECT_LE(r.result.iterations, options.max_iterations);
    if (own.natural > 1e12L) return r.result;  // diverged: T has not the range for what comes next
    EXPECT_NEAR(double(r.result.residuals.natural), double(own.natural), double(own.rounding));
    EXPECT_NEAR(double(r.result.residuals.complementarity), double(own.complementarity), double(2 * own.rounding * own.largest_gap));
    if (data.friction.empty()) {  // whose bounds are rounded, so that x may be at them in one precision and off them in another
        EXPECT_NEAR(double(r.result.residuals.infeasibility), double(own.infeasibility), double(own.rounding));
    }
    return r.result;
}

std::vector<LcpCase> small_cases() {
    std::vector<LcpCase> cases;
    for (const std::size_t n : {1, 2, 5, 20, 60}) {
        for (const bool bounded : {false, true}) cases.push_back(positive_definite_case(n, bounded, static_cast<std::uint32_t>(n)));
        cases.push_back(semi_definite_case(n, static_cast<std::uint32_t>(n)));
        cases.push_back(p_matrix_case(n, static_cast<std::uint32_t>(n)));
        cases.push_back(string_case(n, 0.1, static_cast<std::uint32_t>(n)));
    }
    for (const std::size_t boxes : {1, 2, 5, 10})
        for (const double friction : {0.0, 0.5}) cases.push_back(tower_case(boxes, friction, 0.1));
    cases.push_back(blocks_case(8, 2, 1));
    cases.push_back(blocks_case(8, 4, 2));
    cases.push_back(blocks_case(8, 6, 3));
    cases.push_back(murty_case(8));
    cases.push_back(fathi_case(8));
    return cases;
}

TEST(Lcp, EveryMethodReachesItsToleranceOrSaysThatItDidNot) {
    for (const LcpCase& c : small_cases()) {
        const LcpData<double> wide(c);
        const LcpData<float> narrow(c);
        for (const Method m : all_methods) {
            expect_the_truth(c, wide, options_for(m, wide, 1e-9, 300));
            expect_the_truth(c, wide, options_for(m, wide, 0.0, 20));
            expect_the_truth(c, wide, options_for(m, wide, 1e-9, 0));
            expect_the_truth(c, narrow, options_for(m, narrow, 1e-4f, 300));
            expect_the_truth(c, narrow, options_for(m, narrow, 0.0f, 20));
        }
    }
}

TEST(Lcp, EveryMethodSolvesPositiveDefiniteProblemsWithAndWithoutBounds) {
    for (const std::size_t n : {1, 2, 5, 20, 60}) {
        for (const bool bounded : {false, true}) {
            const LcpCase c = positive_definite_case(n, bounded, static_cast<std::uint32_t>(100 + n));
            const LcpData<double> wide(c);
            const LcpData<float> narrow(c);
            for (const Method m : all_methods) {
                EXPECT_EQ(expect_the_truth(c, wide, options_for(m, wide, 1e-9, 5000)).status, Status::converged)
                    << c.name << ", " << name_of(m);
                EXPECT_EQ(expect_the_truth(c, narrow, options_for(m, narrow, 1e-5f, 5000)).status, Status::converged)
                    << c.name << ", " << name_of(m);
            }
        }
    }
}

TEST(Lcp, EveryMethodStandsATowerWithoutFriction) {
    const LcpCase c = tower_case(4, 0, 0);
    const LcpData<double> data(c);
    for (const Method m : all_methods)
        EXPECT_EQ(expect_the_truth(c, data, options_for(m, data, 1e-8, 20000)).status, Status::converged) << name_of(m);
}

TEST(Lcp, EveryMethodStandsATowerWithFriction) {
    for (const double push : {0.0, 0.05}) {
        const LcpCase c = tower_case(4, 0.5, push);
        const LcpData<double> data(c);
        for (const Method m : all_methods) {
            lcp::Options<double> o = options_for(m, data, 1e-8, 20000);
            o.omega = std::min(o.omega, 1.0);
            if (m == Method::jacobi) o.omega = 0.2;
            EXPECT_EQ(expect_the_truth(c, data, o).status, Status::converged) << name_of(m);
        }
    }
}

TEST(Lcp, TheSupportForcesOfATowerAreItsWeight) {
    // Closed form: under n boxes of 1 kg the two contacts together carry n m g dt, and the same again less one box above each.
    const LcpCase c = tower_case(6, 0, 0);
    const LcpData<double> data(c);
    const LcpRun<double> r = run(data.sparse_problem(), options_for(Method::pgs, data, 1e-11, 20000));
    ASSERT_EQ(r.result.status, Status::converged);
    for (std::size_t box = 0; box < 6; ++box)
        EXPECT_NEAR(r.x[4 * box] + r.x[4 * box + 2], static_cast<double>(6 - box) * 10 / 60, 1e-8) << box;
}

TEST(Lcp, FrictionHoldsUpToItsCoefficientAndNoFurther) {
    // A box pushed sideways at speed v: its contacts can take mu times m g dt out of that, no more.
    const auto sideways = [](double speed) {
        const LcpCase c = tower_case(1, 0.5, speed);
        const LcpData<double> data(c);
        lcp::Options<double> o = options_for(Method::block_pgs, data, 1e-11, 20000);
        const LcpRun<double> r = run(data.sparse_problem(), o);
        EXPECT_EQ(r.result.status, Status::converged);
        return -(r.x[1] + r.x[3]);
    };
    EXPECT_NEAR(sideways(0.02), 0.02, 1e-8);
    EXPECT_NEAR(sideways(0.2), 0.5 * 10 / 60, 1e-8);
}

TEST(Lcp, LargeSparseProblemsAreSolvedWithMemoryForTheirRowsAlone) {
    const LcpCase c = string_case(2000, 0.05, 7);
    const LcpData<float> data(c);
    for (const Method m : all_methods) {
        if (needs_dense_memory(m)) continue;
        EXPECT_LE(lcp::workspace_bytes<float>(m, 2000), 4u * 2000 * sizeof(float));
        EXPECT_EQ(expect_the_truth(c, data, options_for(m, data, 1e-3f, 2000)).status, Status::converged) << name_of(m);
    }
}

TEST(Lcp, NewtonAndLemkeSolveAFewHundredRows) {
    const LcpCase c = positive_definite_case(150, true, 9);
    const LcpData<double> data(c);
    const auto newton = expect_the_truth(c, data, options_for(Method::newton, data, 1e-9, 100));
    EXPECT_EQ(newton.status, Status::converged);
    EXPECT_LT(newton.iterations, 15u);
    EXPECT_EQ(expect_the_truth(c, data, options_for(Method::lemke, data, 1e-9, 2000)).status, Status::converged);
}

TEST(Lcp, DenseAndSparseMatricesGiveTheSameBits) {
    for (const LcpCase& c : small_cases()) {
        const LcpData<float> data(c);
        for (const Method m : all_methods) {
            const auto o = options_for(m, data, 1e-6f, 50);
            const LcpRun<float> a = run(data.dense_problem(), o), b = run(data.sparse_problem(), o);
            ASSERT_EQ(a.x.size(), b.x.size());
            EXPECT_EQ(std::memcmp(a.x.data(), b.x.data(), a.x.size() * sizeof(float)), 0) << c.name << ", " << name_of(m);
            EXPECT_EQ(a.result.iterations, b.result.iterations);
        }
    }
}

TEST(Lcp, ZerosThatAreStoredDoNotTurnAMinusZeroAround) {
    LcpCase c = lcp_case("minus zero", {1, 0, 0, 1}, {-0.0, 0});
    c.lo = {-10, -10};
    c.hi = {10, 10};
    const LcpData<double> data(c);
    const auto o = options_for(Method::pgs, data, 0.0, 1);
    const LcpRun<double> a = run(data.dense_problem(), o, {-0.0, 5}), b = run(data.sparse_problem(), o, {-0.0, 5});
    EXPECT_EQ(std::memcmp(a.x.data(), b.x.data(), 2 * sizeof(double)), 0);
}

TEST(Lcp, AWarmStartTakesFewerIterations) {
    LcpCase c = string_case(200, 0.01, 3);
    const LcpData<double> before(c);
    for (const Method m : all_methods) {
        if (needs_dense_memory(m)) continue;
        const auto o = options_for(m, before, 1e-7, 100000);
        const LcpRun<double> cold = run(before.sparse_problem(), o);
        ASSERT_EQ(cold.result.status, Status::converged) << name_of(m);
        EXPECT_EQ(run(before.sparse_problem(), o, cold.x).result.iterations, 0u) << name_of(m) << ": a solution is one at once";
        LcpCase moved = c;
        for (double& q : moved.q) q *= 1.0001;
        const LcpData<double> after(moved);
        const LcpRun<double> again = run(after.sparse_problem(), o), warm = run(after.sparse_problem(), o, cold.x);
        EXPECT_EQ(warm.result.status, Status::converged);
        EXPECT_LT(warm.result.iterations, again.result.iterations) << name_of(m);
    }
}

TEST(Lcp, TightBlocksConvergeInFewerSweepsWhenSolvedTogether) {
    for (const std::size_t size : {2, 3, 6}) {
        const LcpCase c = blocks_case(20, size, 4);
        const LcpData<double> data(c);
        const auto rows = run(data.sparse_problem(), options_for(Method::pgs, data, 1e-9, 5000)).result;
        const auto blocks = expect_the_truth(c, data, options_for(Method::block_pgs, data, 1e-9, 5000));
        EXPECT_EQ(blocks.status, Status::converged);
        EXPECT_LT(2 * blocks.iterations, rows.iterations) << size;
    }
}

TEST(Lcp, OneBlockIsSolvedExactlyInOneIteration) {
    for (std::uint32_t seed = 0; seed < 200; ++seed) {
        LcpCase c = seed % 2 == 0 ? positive_definite_case(1 + seed % 6, true, seed) : p_matrix_case(1 + seed % 6, seed);
        c.blocks = {0};
        const LcpData<double> data(c);
        const auto r = expect_the_truth(c, data, options_for(Method::block_pgs, data, 1e-13, 1));
        EXPECT_EQ(r.status, Status::converged) << c.name << ", seed " << seed;
    }
}

TEST(Lcp, OneBlockWithFrictionIsSolvedExactlyInOneIteration) {
    for (const double push : {0.0, 0.02, 0.2}) {
        // One contact point: a normal row and its friction.
        LcpCase c = lcp_case("a point", {1.0, 0.3, 0.3, 2.0}, {-1, push});
        c.lo = {0, 0};
        c.hi = {std::numeric_limits<double>::infinity(), 0.25};
        c.friction = {lcp::no_row, 0};
        c.blocks = {0};
        const LcpData<double> data(c);
        EXPECT_EQ(expect_the_truth(c, data, options_for(Method::block_pgs, data, 1e-13, 1)).status, Status::converged) << push;
    }
}

TEST(Lcp, OneBlockOfRowsThatSayTheSameIsSolvedExactlyToo) {
    // The equations of all rows together are singular: some choice of fewer rows solves them.
    for (std::uint32_t seed = 0; seed < 100; ++seed) {
        LcpCase c = semi_definite_case(2 + seed % 5, seed);
        c.blocks = {0};
        const LcpData<double> data(c);
        EXPECT_EQ(expect_the_truth(c, data, options_for(Method::block_pgs, data, 1e-11, 1)).status, Status::converged)
            << c.name << ", seed " << seed;
    }
}

TEST(Lcp, NoFrictionWhereTheNormalRowPulls) {
    LcpCase c = lcp_case("sticky", {1, 0, 0, 1}, {0.5, -1});
    c.lo = {-1, 0};
    c.hi = {1, 0.5};
    c.friction = {lcp::no_row, 0};
    for (const Method m : all_methods) {
        const LcpData<double> data(c);
        lcp::Options<double> o = options_for(m, data, 1e-9, 100);
        const LcpRun<double> r = run(data.sparse_problem(), o);
        EXPECT_EQ(r.result.status, Status::converged) << name_of(m);
        EXPECT_NEAR(r.x[0], -0.5, 1e-8) << name_of(m);
        EXPECT_NEAR(r.x[1], 0, 1e-8) << name_of(m);
    }
}

TEST(Lcp, NewtonIsThereInOneStepWhereTheRightRowsAreFree) {
    const auto steps = [](const LcpCase& c, std::vector<double> start, std::vector<double> solution) {
        const LcpData<double> data(c);
        const LcpRun<double> r = run(data.sparse_problem(), options_for(Method::newton, data, 1e-12, 10), std::move(start));
        EXPECT_EQ(r.result.status, Status::converged) << c.name;
        for (std::size_t i = 0; i < c.n; ++i) EXPECT_NEAR(r.x[i], solution[i], 1e-12) << c.name;
        return r.result.iterations;
    };
    // A start outside the bounds: the free row must know where the other one is going.
    EXPECT_EQ(steps(lcp_case("outside", {2, 1, 1, 2}, {-5, 10}), {0, -3}, {2.5, 0}), 1u);
    // Sliding: friction follows the normal row, x_0 + 0.3 (-0.25 x_0) = 1.
    LcpCase sliding = lcp_case("sliding", {1, 0.3, 0.3, 2}, {-1, 1});
    sliding.lo = {0, 0};
    sliding.hi = {std::numeric_limits<double>::infinity(), 0.25};
    sliding.friction = {lcp::no_row, 0};
    EXPECT_EQ(steps(sliding, {0.9, -0.2}, {1 / 0.925, -0.25 / 0.925}), 1u);
    // The normal row goes to its upper bound, and friction with it.
    LcpCase pressed = lcp_case("pressed", {1, 0, 0, 1}, {-10, -10});
    pressed.lo = {0, 0};
    pressed.hi = {2, 0.5};
    pressed.friction = {lcp::no_row, 0};
    EXPECT_EQ(steps(pressed, {3, 1}, {2, 1}), 1u);
    // Rows that must be exchanged before anything can be divided.
    LcpCase crossed = lcp_case("crossed", {0, 1, 1, 0}, {-1, -2});
    crossed.lo.assign(2, -std::numeric_limits<double>::infinity());
    EXPECT_EQ(steps(crossed, {0, 0}, {2, 1}), 1u);
}

TEST(Lcp, NewtonStandsATallTowerWithFrictionInAFewSteps) {
    // Four rows for three degrees of freedom of each box: the equations have no unique solution.
    const LcpCase c = tower_case(15, 0.5, 0.05);
    const LcpData<double> data(c);
    EXPECT_EQ(expect_the_truth(c, data, options_for(Method::newton, data, 1e-8, 15)).status, Status::converged);
}

TEST(Lcp, NewtonNeverLeavesXWorseThanItWas) {
    // Matrices of no kind at all, on which it often fails.
    int failed = 0;
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
        Random random(seed);
        const std::size_t n = 2 + seed % 5;
        std::vector<double> m = random_vector(n * n, -1, 1, random);
        for (std::size_t i = 0; i < n; ++i) m[i * n + i] = 0.1;
        const LcpCase c = lcp_case("anything " + std::to_string(n), m, random_vector(n, -1, 1, random));
        const LcpData<double> data(c);
        const auto square = [&](const std::vector<double>& x) {
            double sum = 0;
            for (std::size_t i = 0; i < n; ++i) {
                double w = c.q[i];
                for (std::size_t j = 0; j < n; ++j) w += m[i * n + j] * x[j];
                sum += std::min(x[i], w) * std::min(x[i], w);
            }
            return sum;
        };
        const std::vector<double> start = random_vector(n, 0, 1, random);
        for (const std::uint32_t limit : {1u, 3u, 100u}) {
            const LcpRun<double> r = run(data.sparse_problem(), options_for(Method::newton, data, 1e-9, limit), start);
            failed += r.result.status != Status::converged ? 1 : 0;
            EXPECT_LE(square(r.x), square(start) * (1 + 1e-12)) << "seed " << seed << ", " << limit << " iterations";
        }
    }
    EXPECT_GT(failed, 50);
}

TEST(Lcp, OrderRelaxationAndDirectionMatter) {
    // Each row waits for the one before it: visited in that order one sweep is enough, in the other direction it takes one sweep per row.
    const std::size_t n = 30;
    std::vector<double> m(n * n, 0);
    for (std::size_t i = 0; i < n; ++i) {
        m[i * n + i] = 1;
        if (i > 0) m[i * n + i - 1] = -1;
    }
    const LcpCase c = lcp_case("a chain of consequences", m, std::vector<double>(n, -1));
    const LcpData<double> data(c);
    std::vector<std::uint32_t> backwards(n);
    for (std::size_t i = 0; i < n; ++i) backwards[i] = static_cast<std::uint32_t>(n - 1 - i);
    lcp::Options<double> o = options_for(Method::pgs, data, 1e-12, 1000);
    EXPECT_EQ(run(data.sparse_problem(), o).result.iterations, 1u);
    o.order = backwards;
    EXPECT_EQ(run(data.sparse_problem(), o).result.iterations, n);
    o.method = Method::symmetric_pgs;
    EXPECT_EQ(run(data.sparse_problem(), o).result.iterations, 1u);
    o = options_for(Method::red_black, data, 1e-12, 1000);
    EXPECT_EQ(run(data.sparse_problem(), o).result.iterations, n / 2) << "two rows a sweep";

    const LcpCase string = string_case(100, 0.01, 5);
    const LcpData<double> stiff(string);
    o = options_for(Method::pgs, stiff, 1e-8, 100000);
    const auto plain = run(stiff.sparse_problem(), o).result;
    o.method = Method::psor;
    o.omega = 1.7;
    const auto hurried = run(stiff.sparse_problem(), o).result;
    EXPECT_EQ(hurried.status, Status::converged);
    EXPECT_LT(2 * hurried.iterations, plain.iterations);
    o.omega = 1;
    EXPECT_EQ(run(stiff.sparse_problem(), o).result.iterations, plain.iterations);
}

TEST(Lcp, ConjugateGradientsNeedFewerSweepsOnStiffStrings) {
    const LcpCase c = string_case(200, 0.001, 6);
    const LcpData<double> data(c);
    const auto pgs = run(data.sparse_problem(), options_for(Method::pgs, data, 1e-7, 100000)).result;
    const auto nncg = expect_the_truth(c, data, options_for(Method::nncg, data, 1e-7, 100000));
    EXPECT_EQ(nncg.status, Status::converged);
    EXPECT_LT(10 * 2 * nncg.iterations, pgs.iterations) << "an iteration is two sweeps";
}

TEST(Lcp, HistoryHoldsTheResidualAfterEachIteration) {
    const LcpCase c = string_case(50, 0.01, 8);
    const LcpData<double> data(c);
    for (const Method m : all_methods) {
        if (m == Method::lemke) continue;
        std::vector<double> history(10, -1);
        lcp::Options<double> o = options_for(m, data, 1e-13, 6);
        o.history = history;
        o.check_every = 100;
        const auto full = run(data.sparse_problem(), o).result;
        for (std::uint32_t k = 1; k <= full.iterations; ++k) {
            lcp::Options<double> shorter = options_for(m, data, 1e-13, k);
            const LcpRun<double> r = run(data.sparse_problem(), shorter);
            if (m == Method::newton && k < full.iterations) continue;  // it leaves its best x, which need not be its last
            EXPECT_EQ(r.result.residuals.natural, history[k - 1]) << name_of(m) << ", iteration " << k;
        }
        EXPECT_EQ(history[full.iterations], -1) << "nothing beyond the last iteration";
    }
}

TEST(Lcp, MeasuringLessOftenFindsTheEndLater) {
    const LcpCase c = string_case(50, 0.1, 9);
    const LcpData<double> data(c);
    lcp::Options<double> o = options_for(Method::pgs, data, 1e-6, 1000);
    const auto each = run(data.sparse_problem(), o).result;
    o.check_every = 7;
    const auto seldom = run(data.sparse_problem(), o).result;
    EXPECT_EQ(seldom.status, Status::converged);
    EXPECT_EQ(seldom.iterations, (each.iterations + 6) / 7 * 7);
    o.max_iterations = each.iterations;
    EXPECT_EQ(run(data.sparse_problem(), o).result.status, Status::converged) << "the end is always measured";
}

}  // namespace
}  // namespace islet::test
