// The direct method against every choice of active bounds there is, on problems made to be hard for it, and on some without a solution.
#include <gtest/gtest.h>

#include "lcp_problems.hpp"

namespace islet::test {
namespace {

using lcp::Method;
using lcp::Status;


/// Gauss-Jordan elimination in long double; false if the matrix is singular.
bool solve_exactly(std::vector<std::vector<long double>> a, std::vector<long double>& b) {
    const std::size_t n = b.size();
    for (std::size_t k = 0; k < n; ++k) {
        std::size_t p = k;
        for (std::size_t i = k; i < n; ++i)
            if (std::fabs(a[i][k]) > std::fabs(a[p][k])) p = i;
        if (std::fabs(a[p][k]) < 1e-14L) return false;
        std::swap(a[p], a[k]);
        std::swap(b[p], b[k]);
        for (std::size_t i = 0; i < n; ++i) {
            if (i == k) continue;
            const long double f = a[i][k] / a[k][k];
            for (std::size_t j = k; j < n; ++j) a[i][j] -= f * a[k][j];
            b[i] -= f * b[k];
        }
    }
    for (std::size_t k = 0; k < n; ++k) b[k] /= a[k][k];
    return true;
}

/// Every solution that some choice of rows at their lower bound, at their upper bound and between them leads to: 2^n or 3^n choices.
std::vector<std::vector<double>> enumerate(const LcpCase& c) {
    const LcpData<double> p(c);
    const auto lo = [&](std::size_t i) { return c.lo.empty() ? 0.0 : c.lo[i]; };
    const auto hi = [&](std::size_t i) { return c.hi.empty() ? inf : c.hi[i]; };
    std::vector<std::vector<double>> found;
    std::vector<int> choice(c.n, 0);
    for (;;) {
        std::vector<std::size_t> free;
        std::vector<long double> x(c.n, 0);
        bool possible = true;
        for (std::size_t i = 0; i < c.n; ++i) {
            if (choice[i] == 1) free.push_back(i);
            if (choice[i] != 1) x[i] = choice[i] == 0 ? lo(i) : hi(i);
            possible = possible && std::isfinite(x[i]);
        }
        if (possible) {
            std::vector<std::vector<long double>> a(free.size(), std::vector<long double>(free.size()));
            std::vector<long double> b(free.size());
            for (std::size_t k = 0; k < free.size(); ++k) {
                b[k] = -p.q[free[k]];
                for (std::size_t j = 0; j < c.n; ++j) b[k] -= p.dense[free[k] * c.n + j] * x[j];
                for (std::size_t l = 0; l < free.size(); ++l) a[k][l] = p.dense[free[k] * c.n + free[l]];
            }
            if (solve_exactly(a, b)) {
                std::vector<double> candidate(x.begin(), x.end());
                for (std::size_t k = 0; k < free.size(); ++k) candidate[free[k]] = double(b[k]);
                if (own_residuals(p, candidate).natural < 1e-12L) found.push_back(candidate);
            }
        }
        std::size_t i = 0;
        while (i < c.n && ++choice[i] == 3) choice[i++] = 0;
        if (i == c.n) return found;
    }
}

LcpRun<double> lemke(const LcpCase& c, double tolerance = 1e-10, std::uint32_t limit = 5000, std::vector<double> start = {}) {
    const LcpData<double> data(c);
    return run(data.sparse_problem(), lcp::Options<double>{.method = Method::lemke, .max_iterations = limit, .tolerance = tolerance},
               std::move(start));
}

TEST(LcpExact, LemkeFindsTheOneSolutionThatEnumerationFinds) {
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        const std::size_t n = 1 + seed % 7;
        for (const LcpCase& c : {positive_definite_case(n, true, seed), positive_definite_case(n, false, seed), p_matrix_case(n, seed)}) {
            const auto all = enumerate(c);
            ASSERT_FALSE(all.empty());
            const LcpRun<double> r = lemke(c, 1e-12);
            ASSERT_EQ(r.result.status, Status::converged) << c.name << ", seed " << seed;
            for (std::size_t i = 0; i < n; ++i) EXPECT_NEAR(r.x[i], all[0][i], 1e-10) << c.name << ", seed " << seed;
        }
    }
}

TEST(LcpExact, TenRowsInAllTheirChoices) {
    const LcpCase c = p_matrix_case(10, 77);
    const auto all = enumerate(c);
    ASSERT_EQ(all.size(), 1u);
    const LcpRun<double> r = lemke(c);
    for (std::size_t i = 0; i < 10; ++i) EXPECT_NEAR(r.x[i], all[0][i], 1e-11);
}

TEST(LcpExact, LemkeSaysRayExactlyWhereEnumerationFindsNothing) {
    // Positive semi-definite of rank 1 or 2, with any q: there Lemke's ray means that there is no solution.
    int with = 0, without = 0;
    for (std::uint32_t seed = 0; seed < 120; ++seed) {
        Random random(seed);
        const std::size_t n = 2 + seed % 4;
        const std::vector<double> m = random_gram(n, 1 + seed % 2, 0, random);
        const LcpCase c = lcp_case("rank " + std::to_string(1 + seed % 2), m, random_vector(n, -1, 2, random));
        const bool solvable = !enumerate(c).empty();
        const Status status = lemke(c, 1e-9).result.status;
        EXPECT_EQ(status, solvable ? Status::converged : Status::ray) << c.name << ", seed " << seed;
        ++(solvable ? with : without);
    }
    EXPECT_GT(with, 20);
    EXPECT_GT(without, 20);
}

TEST(LcpExact, SemiDefiniteProblemsWithManySolutionsGetOneOfThem) {
    for (const std::size_t n : {2, 5, 10, 40, 80}) EXPECT_EQ(lemke(semi_definite_case(n, 5)).result.status, Status::converged) << n;
}

TEST(LcpExact, DegenerateTiesEndToo) {
    // All rows alike: every ratio of every pivot ties with all others.
    for (const std::size_t n : {2, 5, 12}) {
        const LcpCase ones = lcp_case("ones", std::vector<double>(n * n, 1), std::vector<double>(n, -1));
        EXPECT_EQ(lemke(ones).result.status, Status::converged) << n;
        LcpCase boxed = ones;
        boxed.lo.assign(n, 0);
        boxed.hi.assign(n, 1.0 / static_cast<double>(n));
        const LcpRun<double> r = lemke(boxed);
        EXPECT_EQ(r.result.status, Status::converged) << n;
    }
    // Four legs of a stool where three would do, on top of each other: the equations of the tower are singular.
    for (const std::size_t boxes : {1, 2, 5, 12}) EXPECT_EQ(lemke(tower_case(boxes, 0, 0)).result.status, Status::converged) << boxes;
}

// A P-matrix on which pivoting can go round for ever where ties are decided without care (of the kind in Kostreva: Cycling in linear complementarity
// problems, 1979): rows in a ring, all of them equal.
TEST(LcpExact, RowsInARingDoNotSendThePivotsRound) {
    const LcpCase c = lcp_case("cycle", {1, 2, 0, 0, 1, 2, 2, 0, 1}, {-1, -1, -1});
    const LcpRun<double> r = lemke(c);
    EXPECT_EQ(r.result.status, Status::converged);
    for (const double x : r.x) EXPECT_NEAR(x, 1.0 / 3, 1e-14);
}

TEST(LcpExact, MurtysAndFathisFamiliesAreSolvedAndTakeManyPivots) {
    for (const std::size_t n : {2, 4, 8, 10}) {
        for (const LcpCase& c : {murty_case(n), fathi_case(n)}) {
            const LcpRun<double> r = lemke(c);
            ASSERT_EQ(r.result.status, Status::converged) << c.name;
            for (std::size_t i = 0; i < n; ++i) EXPECT_NEAR(r.x[i], c.known[i], 1e-9) << c.name;
        }
    }
    // The q that sends Lemke's method through every vertex (Murty 1978): 2^n pivots.
    const auto hard = [](std::size_t n) {
        LcpCase c = murty_case(n);
        double sum = 0;
        for (std::size_t i = 0; i < n; ++i) c.q[i] = -(sum += std::exp2(static_cast<double>(n - i)));
        return c;
    };
    for (const std::size_t n : {3, 6, 9}) {
        EXPECT_GE(lemke(hard(n)).result.iterations, std::size_t{1} << n);
        EXPECT_EQ(lemke(hard(n)).result.status, Status::converged);
    }
    const auto cut = lemke(hard(9), 1e-10, 100).result;
    EXPECT_EQ(cut.status, Status::iteration_limit);
    EXPECT_EQ(cut.iterations, 100u);
    EXPECT_GT(cut.residuals.natural, 1);
}

TEST(LcpExact, RowsWithoutBoundsAreEquations) {
    // The least of x^2 + y^2 over x + y = 1, with the multiplier as the third unknown, whose diagonal is zero.
    LcpCase c = lcp_case("saddle", {1, 0, -1, 0, 1, -1, 1, 1, 0}, {0, 0, -1});
    c.lo.assign(3, -inf);
    c.hi.assign(3, inf);
    const LcpRun<double> r = lemke(c);
    EXPECT_EQ(r.result.status, Status::converged);
    EXPECT_NEAR(r.x[0], 0.5, 1e-14);
    EXPECT_NEAR(r.x[1], 0.5, 1e-14);
    EXPECT_NEAR(r.x[2], 0.5, 1e-14);
    // The same with x no more than 0.2.
    c.hi[0] = 0.2;
    const LcpRun<double> held = lemke(c);
    EXPECT_EQ(held.result.status, Status::converged);
    EXPECT_NEAR(held.x[0], 0.2, 1e-14);
    EXPECT_NEAR(held.x[1], 0.8, 1e-14);
    // An equation for nothing.
    LcpCase empty = lcp_case("empty equation", {0}, {1});
    empty.lo = {-inf};
    const auto refused = lemke(empty).result;
    EXPECT_EQ(refused.status, Status::singular);
    EXPECT_EQ(refused.row, 0u);
}

TEST(LcpExact, TheLastDigitsAreRightAfterManyPivots) {
    // What hundreds of pivots pile up in rounding, solving the free rows once more takes away: in float, to a few units in the last place.
    for (std::uint32_t seed = 0; seed < 10; ++seed) {
        const LcpCase c = positive_definite_case(80, true, seed);
        const LcpData<float> data(c);
        const LcpRun<float> r = run(data.sparse_problem(), lcp::Options<float>{.method = Method::lemke, .tolerance = 3e-6f});
        EXPECT_EQ(r.result.status, Status::converged) << r.result.residuals.natural;
    }
    const LcpData<float> tower(tower_case(40, 0, 0));
    const LcpRun<float> r = run(tower.sparse_problem(), lcp::Options<float>{.method = Method::lemke, .tolerance = 5e-6f});
    EXPECT_EQ(r.result.status, Status::converged) << r.result.residuals.natural;
}

TEST(LcpExact, NewtonAgreesWithLemke) {
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        const std::size_t n = 1 + seed % 20;
        for (const LcpCase& c : {positive_definite_case(n, true, seed), p_matrix_case(n, seed)}) {
            const LcpData<double> data(c);
            const LcpRun<double> r = run(data.sparse_problem(), lcp::Options<double>{.method = Method::newton, .tolerance = 1e-11});
            ASSERT_EQ(r.result.status, Status::converged) << c.name << ", seed " << seed;
            const LcpRun<double> exact = lemke(c);
            for (std::size_t i = 0; i < n; ++i) EXPECT_NEAR(r.x[i], exact.x[i], 1e-9) << c.name << ", seed " << seed;
        }
    }
}

TEST(LcpExact, FrictionIsFrozenSolvedAndTakenAnew) {
    for (const double push : {0.0, 0.02, 0.05}) {
        const LcpRun<double> r = lemke(tower_case(3, 0.4, push), 1e-9, 20000);
        EXPECT_EQ(r.result.status, Status::converged) << push;
        const LcpRun<double> cut = lemke(tower_case(3, 0.4, push), 1e-9, 5);
        EXPECT_EQ(cut.result.status, Status::iteration_limit) << push;
        EXPECT_EQ(cut.result.iterations, 5u);
    }
}

TEST(LcpExact, AProblemWithoutASolutionIsCalledSolvedByNobody) {
    // x >= 0 and w = -x - 1 >= 0; and two rows that want to part from each other for ever.
    for (const LcpCase& c : {lcp_case("below", {0}, {-1}), lcp_case("apart", {1, -1, -1, 1}, {-1, -1}), lcp_case("falling", {-1}, {-1})}) {
        const LcpData<double> data(c);
        for (int m = 0; m <= static_cast<int>(Method::lemke); ++m) {
            lcp::Options<double> o = {.method = static_cast<Method>(m), .max_iterations = 2000, .tolerance = 1e-6, .regularisation = 1e-3};
            if (m == static_cast<int>(Method::block_pgs) && c.n == 2) o.blocks = std::span<const std::uint32_t>(&data.row_starts[0], 1);
            const LcpRun<double> r = run(data.sparse_problem(), o);
            EXPECT_NE(r.result.status, Status::converged) << c.name << ", method " << m;
            EXPECT_GT(r.result.residuals.natural, 0.1) << c.name << ", method " << m;
        }
        EXPECT_EQ(lemke(c).result.status, Status::ray) << c.name;
    }
}

}  // namespace
}  // namespace islet::test
