// What the matrix solvers refuse, in which words, and that they read nothing out of bounds while they find out (the sanitizers watch).
#include <gtest/gtest.h>

#include <cstring>

#include "lcp_problems.hpp"

namespace islet::test {
namespace {

using lcp::Method;
using lcp::Status;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Two rows, both ways, every part of it open to damage.
struct Two {
    std::vector<double> dense = {2, 1, 1, 2}, values = dense, q = {-1, -1}, lo, hi, x = {0.25, 0.5};
    std::vector<std::uint32_t> row_starts = {0, 2, 4}, columns = {0, 1, 0, 1}, friction;
    lcp::Options<double> options;
    bool sparse = false;

    lcp::Problem<double> problem() const {
        lcp::Problem<double> p = {.q = q, .lo = lo, .hi = hi, .friction = friction};
        if (sparse)
            p.sparse = {row_starts, columns, values};
        else
            p.dense = {dense};
        return p;
    }
    lcp::Result<double> solve() {
        std::vector<std::byte> memory(lcp::workspace_bytes<double>(options.method, x.size()));
        return lcp::solve<double>(problem(), options, x, memory);
    }
};

/// Refused with these words, x untouched, by solve and solve_by_sweeps; and residuals finds no number for it either if the problem is what is wrong.
void expect_refused(Two t, Status status, std::uint32_t row = lcp::no_row, bool by_the_problem = true) {
    const std::vector<double> before = t.x;
    const auto r = t.solve();
    EXPECT_EQ(r.status, status) << lcp::describe(r.status);
    EXPECT_EQ(r.row, row);
    EXPECT_EQ(r.iterations, 0u);
    EXPECT_EQ(std::memcmp(t.x.data(), before.data(), before.size() * sizeof(double)), 0);
    if (by_the_problem) {
        EXPECT_EQ(r.residuals.natural, inf);
        EXPECT_EQ(lcp::residuals<double>(t.problem(), t.x).infeasibility, inf);
    }
    std::vector<std::byte> memory(1000);
    EXPECT_EQ(lcp::solve_by_sweeps<double>(t.problem(), t.options, t.x, memory).status, status);
}

TEST(LcpArguments, AGoodProblemIsSolvedEitherWay) {
    for (const bool sparse : {false, true}) {
        Two t;
        t.sparse = sparse;
        EXPECT_EQ(t.solve().status, Status::converged);
        EXPECT_NEAR(t.x[0], 1.0 / 3, 1e-5);
    }
}

TEST(LcpArguments, SizesThatDoNotFitAreRefused) {
    const auto with = [](auto change) {
        Two t;
        change(t);
        expect_refused(t, Status::bad_size);
    };
    with([](Two& t) { t.x.pop_back(); });
    with([](Two& t) { t.x.push_back(0); });
    with([](Two& t) { t.dense.pop_back(); });
    with([](Two& t) { t.dense.clear(); });
    with([](Two& t) { t.dense.push_back(1); });
    with([](Two& t) { t.lo = {0}; });
    with([](Two& t) { t.hi = {1, 1, 1}; });
    with([](Two& t) { t.friction = {lcp::no_row}; });
    with([](Two& t) { t.sparse = true, t.row_starts.pop_back(); });
    with([](Two& t) { t.sparse = true, t.row_starts.clear(); });
    with([](Two& t) { t.sparse = true, t.columns.pop_back(); });
    with([](Two& t) { t.sparse = true, t.values.push_back(1); });
    Two both;
    lcp::Problem<double> p = both.problem();
    p.sparse = {both.row_starts, both.columns, both.values};
    std::vector<std::byte> memory(1000);
    EXPECT_EQ(lcp::solve<double>(p, both.options, both.x, memory).status, Status::bad_size);
}

TEST(LcpArguments, BrokenSparseMatricesAreRefused) {
    const auto with = [](std::uint32_t row, auto change) {
        Two t;
        t.sparse = true;
        change(t);
        expect_refused(t, Status::bad_matrix, row);
    };
    with(0, [](Two& t) { t.row_starts = {1, 2, 4}; });
    with(1, [](Two& t) { t.row_starts = {0, 2, 3}; });
    with(1, [](Two& t) { t.row_starts = {0, 2, 0xffffffffu}; });
    with(1, [](Two& t) { t.row_starts = {0, 5, 4}; });
    with(1, [](Two& t) { t.row_starts = {0, 0xfffffff0u, 4}; });
    with(1, [](Two& t) { t.columns[2] = 2; });
    with(0, [](Two& t) { t.columns[1] = 0xffffffffu; });
    with(0, [](Two& t) { t.columns = {1, 0, 0, 1}; });
    with(1, [](Two& t) { t.columns = {0, 1, 1, 1}; });
}

TEST(LcpArguments, RandomDamageToASparseMatrixIsRefusedOrHarmless) {
    for (std::uint32_t seed = 0; seed < 2000; ++seed) {
        Random random(seed);
        Two t;
        t.sparse = true;
        for (std::uint32_t k = 0; k < 2; ++k) {
            std::vector<std::uint32_t>& damaged = random.one_in(2) ? t.row_starts : t.columns;
            damaged[random.below(static_cast<std::uint32_t>(damaged.size()))] =
                random.one_in(3) ? static_cast<std::uint32_t>(random.bits()) : random.below(6);
        }
        for (int m = 0; m <= static_cast<int>(Method::lemke); ++m) {
            t.options.method = static_cast<Method>(m);
            const auto r = t.solve();
            if (r.status == Status::converged) { EXPECT_LE(r.residuals.natural, t.options.tolerance); }
        }
    }
}

TEST(LcpArguments, NumbersThatAreNotFiniteAreRefused) {
    for (const double bad : {nan, inf, -inf}) {
        const auto with = [](std::uint32_t row, auto change) {
            Two t;
            change(t);
            expect_refused(t, Status::not_finite, row);
        };
        with(1, [&](Two& t) { t.dense[2] = bad; });
        with(1, [&](Two& t) { t.sparse = true, t.values[3] = bad; });
        with(0, [&](Two& t) { t.q[0] = bad; });
        with(1, [&](Two& t) { t.x[1] = bad; });
        Two t;
        t.options.tolerance = bad;
        expect_refused(t, Status::not_finite, lcp::no_row, false);
    }
}

TEST(LcpArguments, BoundsThatLeaveNoRoomAreRefused) {
    const auto with = [](auto change, Status status, std::uint32_t row = 1) {
        Two t;
        t.lo = {0, 0};
        t.hi = {1, 1};
        change(t);
        expect_refused(t, status, row);
    };
    with([](Two& t) { t.lo[1] = 2; }, Status::bad_bounds);
    with([](Two& t) { t.lo[1] = nan; }, Status::bad_bounds);
    with([](Two& t) { t.hi[1] = nan; }, Status::bad_bounds);
    with([](Two& t) { t.lo[1] = t.hi[1] = inf; }, Status::bad_bounds);
    with([](Two& t) { t.lo[1] = t.hi[1] = -inf; }, Status::bad_bounds);
    with([](Two& t) { t.friction = {lcp::no_row, 0}, t.hi[1] = -0.5; }, Status::bad_bounds);
    with([](Two& t) { t.friction = {lcp::no_row, 0}, t.hi[1] = inf; }, Status::bad_bounds);
    with([](Two& t) { t.friction = {lcp::no_row, 0}, t.hi.clear(); }, Status::bad_bounds);
    with([](Two& t) { t.friction = {lcp::no_row, 2}; }, Status::bad_index);
    with([](Two& t) { t.friction = {lcp::no_row, 1}; }, Status::bad_index);
    with([](Two& t) { t.friction = {1, 0}; }, Status::bad_index, 0);
    Two t;
    t.friction = {lcp::no_row, 0};
    t.lo = {0, nan};
    t.hi = {1, 0.5};
    EXPECT_EQ(t.solve().status, Status::converged) << "the lower bound of a friction row is not looked at";
}

TEST(LcpArguments, OptionsOutsideTheirRangesAreRefused) {
    const auto with = [](auto change, Status status, std::uint32_t row = lcp::no_row) {
        Two t;
        change(t.options);
        const std::vector<double> before = t.x;
        const auto r = t.solve();
        EXPECT_EQ(r.status, status) << lcp::describe(r.status);
        EXPECT_EQ(r.row, row);
        EXPECT_EQ(t.x, before);
        EXPECT_GT(r.residuals.natural, 0) << "of x as it was left";
        EXPECT_LT(r.residuals.natural, 1);
    };
    using O = lcp::Options<double>;
    const std::vector<std::uint32_t> far = {0, 2}, one = {0}, shifted = {1}, twice = {0, 0}, long_list = {0, 1, 2};
    with([](O& o) { o.tolerance = -1; }, Status::bad_option);
    with([](O& o) { o.regularisation = -1; }, Status::bad_option);
    with([](O& o) { o.omega = 0; }, Status::bad_option);
    with([](O& o) { o.omega = 2; }, Status::bad_option);
    with([](O& o) { o.check_every = 0; }, Status::bad_option);
    with([](O& o) { o.method = static_cast<Method>(10); }, Status::bad_option);
    with([&](O& o) { o.order = far; }, Status::bad_index, 1);
    with([&](O& o) { o.order = one, o.method = Method::lemke; }, Status::unsupported);
    with([&](O& o) { o.blocks = one; }, Status::unsupported);
    const auto blocks = [&](const std::vector<std::uint32_t>& list, std::uint32_t row) {
        with([&](O& o) { o.blocks = list, o.method = Method::block_pgs; }, Status::bad_blocks, row);
    };
    blocks(shifted, 0);
    blocks(twice, 0);
    blocks(long_list, 0);
    blocks(far, 1);
    const LcpCase seven = string_case(7, 1, 1);
    const LcpData<double> data(seven);
    EXPECT_EQ(run(data.sparse_problem(), O{.method = Method::block_pgs, .blocks = one}).result.status, Status::bad_blocks)
        << "a block of seven";
    Two t;
    std::vector<std::byte> memory(1000);
    t.options.method = Method::jacobi;
    EXPECT_EQ(lcp::solve_by_sweeps<double>(t.problem(), t.options, t.x, memory).status, Status::unsupported);
}

TEST(LcpArguments, TooLittleWorkspaceIsRefusedAndEnoughIsEnough) {
    for (const std::size_t n : {1, 2, 7, 33}) {
        const LcpCase c = positive_definite_case(n, true, 3);
        const LcpData<double> wide(c);
        const LcpData<float> narrow(c);
        const auto check = [&]<class T>(const LcpData<T>& data) {
            for (int m = 0; m <= static_cast<int>(Method::lemke); ++m) {
                const lcp::Options<T> o = {.method = static_cast<Method>(m), .omega = T(0.6)};
                const std::size_t bytes = lcp::workspace_bytes<T>(o.method, n);
                std::vector<T> x(n, T(0));
                std::vector<std::byte> memory(bytes - 1);
                EXPECT_EQ(lcp::solve<T>(data.dense_problem(), o, x, memory).status, Status::too_little_memory) << m;
                for (std::size_t shift = 0; shift < sizeof(T); ++shift) {
                    // No byte outside what was asked for is written, however badly aligned it is.
                    memory.assign(bytes + 2 * sizeof(T), std::byte{0xa5});
                    const auto r = lcp::solve<T>(data.dense_problem(), o, x, std::span(memory).subspan(sizeof(T) + shift, bytes));
                    EXPECT_NE(r.status, Status::too_little_memory);
                    for (std::size_t k = 0; k < sizeof(T) + shift; ++k) EXPECT_EQ(memory[k], std::byte{0xa5}) << m;
                    for (std::size_t k = sizeof(T) + shift + bytes; k < memory.size(); ++k) EXPECT_EQ(memory[k], std::byte{0xa5}) << m;
                }
            }
        };
        check(wide);
        check(narrow);
    }
    EXPECT_EQ(lcp::workspace_bytes<double>(Method::pgs, lcp::max_rows + std::size_t{1}), static_cast<std::size_t>(-1));
}

TEST(LcpArguments, ProblemsWithoutRowsAreSolved) {
    for (int m = 0; m <= static_cast<int>(Method::lemke); ++m) {
        const auto r = run(lcp::Problem<double>{}, lcp::Options<double>{.method = static_cast<Method>(m)}).result;
        EXPECT_EQ(r.status, Status::converged);
        EXPECT_EQ(r.iterations, 0u);
        EXPECT_EQ(r.residuals.natural, 0);
    }
}

TEST(LcpArguments, AZeroOrTinyDiagonalIsRefusedByItsRowOrRegularised) {
    for (const double diagonal : {0.0, -1.0, 1e-17, 1e-310}) {
        const LcpCase c = lcp_case("weak", {2, 1, 0, 1, diagonal, 0.5, 0, 0.5, 2}, {-1, 1, -1});
        const LcpData<double> data(c);
        for (int m = 0; m < static_cast<int>(Method::newton); ++m) {
            lcp::Options<double> o = {.method = static_cast<Method>(m), .tolerance = 1e-9, .omega = m == 5 ? 0.5 : 1.0};
            const LcpRun<double> refused = run(data.sparse_problem(), o, {0.5, 0.5, 0.5});
            EXPECT_EQ(refused.result.status, Status::bad_diagonal) << m;
            EXPECT_EQ(refused.result.row, 1u);
            EXPECT_EQ(refused.x, (std::vector<double>{0.5, 0.5, 0.5}));
            EXPECT_LT(refused.result.residuals.natural, 10);
            o.regularisation = 2;
            const LcpRun<double> r = run(data.sparse_problem(), o);
            EXPECT_EQ(r.result.status, Status::converged) << m;
            EXPECT_NEAR(r.x[0], 0.5, 1e-8);
            EXPECT_NEAR(r.x[1], 0, 1e-8);
            EXPECT_NEAR(r.x[2], 0.5, 1e-8);
        }
    }
}

TEST(LcpArguments, RegularisationChangesTheStepsAndNotTheSolution) {
    // x_0 = 1 because of row 1, whose diagonal is missing; x_1 = 1 because of row 0.
    const LcpCase c = lcp_case("no diagonal", {2, -1, 1, 0}, {-1, -1});
    const LcpData<double> data(c);
    const std::vector<std::uint32_t> together = {0};
    for (const Method m : {Method::pgs, Method::symmetric_pgs, Method::red_black, Method::block_pgs, Method::newton, Method::lemke}) {
        lcp::Options<double> o = {.method = m, .max_iterations = 10000, .tolerance = 1e-10, .regularisation = 1};
        if (m == Method::block_pgs) o.blocks = together;
        const LcpRun<double> r = run(data.sparse_problem(), o);
        EXPECT_EQ(r.result.status, Status::converged) << static_cast<int>(m);
        for (const double x : r.x) EXPECT_NEAR(x, 1, 1e-9) << static_cast<int>(m);
    }
}

TEST(LcpArguments, ARowOfNothingIsJudgedByItsQ) {
    // w = q whatever x is: with q = 0 any x within the bounds will do, with q > 0 only 0 does, with q < 0 nothing does.
    for (int m = 0; m <= static_cast<int>(Method::lemke); ++m) {
        const auto with = [&](double q, double start) {
            const LcpCase c = lcp_case("nothing", {0}, {q});
            const LcpData<double> data(c);
            return run(
                data.dense_problem(),
                lcp::Options<double>{.method = static_cast<Method>(m), .max_iterations = 50, .tolerance = 1e-9, .regularisation = 0.5},
                {start});
        };
        EXPECT_EQ(with(0, 3).result.status, Status::converged) << m;
        EXPECT_EQ(with(0, 3).x[0], 3) << m;
        EXPECT_EQ(with(0, -3).result.status, Status::converged) << m;
        EXPECT_EQ(with(0, -3).x[0], 0) << m;
        EXPECT_EQ(with(1, 3).result.status, Status::converged) << m;
        EXPECT_EQ(with(1, 3).x[0], 0) << m;
        EXPECT_NE(with(-1, 3).result.status, Status::converged) << m;
        EXPECT_GE(with(-1, 3).result.residuals.natural, 1) << m;
    }
}

TEST(LcpArguments, OverflowIsReportedAndLeavesFiniteNumbers) {
    // An M of negative eigenvalues: each sweep throws x further.
    const LcpCase c = lcp_case("explosion", {1, -4, -4, 1}, {-1, -1});
    const LcpData<float> data(c);
    for (int m = 0; m < static_cast<int>(Method::newton); ++m) {
        const LcpRun<float> r = run(data.dense_problem(), lcp::Options<float>{.method = static_cast<Method>(m), .max_iterations = 100000});
        EXPECT_EQ(r.result.status, Status::diverged) << m;
        EXPECT_NE(r.result.row, lcp::no_row);
        for (const float x : r.x) EXPECT_TRUE(std::isfinite(x)) << m;
    }
}

TEST(LcpArguments, ResidualsAreThoseOfTheDefinition) {
    // w = (1, -1, 2) at x = (0.5, 2, -3), by hand.
    const std::vector<double> m = {0, 0, 0, 0, 0, 0, 0, 0, 0}, q = {1, -1, 2}, lo = {0, 0, -1}, hi = {4, 3, 1}, x = {0.5, 2, -3};
    const auto r = lcp::residuals<double>({.dense = {m}, .q = q, .lo = lo, .hi = hi}, x);
    EXPECT_EQ(r.infeasibility, 2);    // the third is 2 below its bound
    EXPECT_EQ(r.complementarity, 4);  // and that times its w
    EXPECT_EQ(r.natural, 2);          // -3 - clamp(-3 - 2, -1, 1)
    const std::vector<double> y = {0.5, 2, -1};
    const auto s = lcp::residuals<double>({.dense = {m}, .q = q, .lo = lo, .hi = hi}, y);
    EXPECT_EQ(s.infeasibility, 0);
    EXPECT_EQ(s.complementarity, 1);
    EXPECT_EQ(s.natural, 1);
    // At a bound w may have one sign only.
    const std::vector<double> z = {4, 0, 0};
    const auto t = lcp::residuals<double>({.dense = {m}, .q = q, .lo = lo, .hi = hi}, z);
    EXPECT_EQ(t.infeasibility, 1);
    EXPECT_EQ(t.complementarity, 4);
}

TEST(LcpArguments, EveryStatusHasASentence) {
    std::vector<std::string> seen;
    for (int s = 0; s <= static_cast<int>(Status::too_little_memory); ++s) seen.push_back(lcp::describe(static_cast<Status>(s)));
    std::sort(seen.begin(), seen.end());
    EXPECT_EQ(std::adjacent_find(seen.begin(), seen.end()), seen.end());
    EXPECT_EQ(std::find(seen.begin(), seen.end(), lcp::describe(static_cast<Status>(200))), seen.end());
}

}  // namespace
}  // namespace islet::test
