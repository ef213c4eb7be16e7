// The matrix solvers with numbers at the ends of their range: x stays finite, "solved" stays true, and the two forms of a matrix stay the same.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "islet/lcp.hpp"

namespace islet::test {
namespace {

using lcp::Method;
using lcp::Status;

template <class T>
struct Extremes : ::testing::Test {
    static constexpr T inf = std::numeric_limits<T>::infinity();
    static constexpr T big = std::numeric_limits<T>::max();
    static constexpr std::size_t methods = static_cast<std::size_t>(Method::lemke) + 1;

    std::vector<T> m, q, lo, hi, start;
    std::vector<std::uint32_t> friction;
    lcp::Options<T> options;
    std::vector<T> x;

    lcp::Problem<T> problem() const { return {.dense = {m}, .q = q, .lo = lo, .hi = hi, .friction = friction}; }
    lcp::Result<T> solve(Method method) {
        options.method = method;
        x = start;
        std::vector<std::byte> memory(lcp::workspace_bytes<T>(method, q.size()));
        return lcp::solve<T>(problem(), options, x, memory);
    }
    void expect_finite_by_every_method() {
        for (std::size_t k = 0; k < methods; ++k) {
            const Method method = static_cast<Method>(k);
            static const std::uint32_t one_block[] = {0};
            options.blocks = {};
            if (method == Method::block_pgs) options.blocks = one_block;
            const lcp::Result<T> r = solve(method);
            for (const T value : x) EXPECT_TRUE(std::isfinite(value)) << "method " << k << ": " << value << ", " << lcp::describe(r.status);
        }
    }
};

using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Extremes, Scalars);

// Newton's step went to infinity, where |F|^2 is infinite and, compared with another infinity, no worse.
TYPED_TEST(Extremes, TheLargestBoundLeavesXFinite) {
    using T = TypeParam;
    this->m = {T(2e27), T(1.5e9), T(437.8), T(5.5e23)};
    this->q = {T(1.25), T(1.25)};
    this->lo = {-this->big, T(-1.125)};
    this->hi = {-this->big, T(0.5)};
    this->friction = {lcp::no_row, 0};
    this->start = {T(0.875), 0};
    for (const T regularisation : {T(0), T(0.015)}) {
        this->options.regularisation = regularisation;
        this->options.tolerance = 0;
        this->expect_finite_by_every_method();
    }
}

// block_pgs went beyond a bound by its omega, and the bounds that friction has there were 0 times infinity.
TYPED_TEST(Extremes, ABlockOverrelaxedToTheLargestBoundLeavesXFinite) {
    using T = TypeParam;
    this->m = {1, std::numeric_limits<T>::denorm_min(), 2, 1};
    this->q = {T(0.5), T(-1)};
    this->lo = {-this->inf, T(0.5)};
    this->hi = {-this->big, T(1.5)};
    this->start = {0, T(-0.1875)};
    this->options.omega = T(1.54);
    this->expect_finite_by_every_method();
    this->lo = {-this->big, 0};
    this->hi = {this->big, 0};
    this->friction = {lcp::no_row, 0};
    this->q = {-this->big, 1};
    this->expect_finite_by_every_method();
}

// Entries of 1e30 with ordinary bounds: in float their products leave the range of numbers, and their squares that of the map.
TYPED_TEST(Extremes, LargeEntriesWithOrdinaryBoundsLeaveXFinite) {
    using T = TypeParam;
    const T a = sizeof(T) == sizeof(float) ? T(1e30) : T(1e250);
    for (const T b : {T(1e-30), T(1e-4), T(1), T(1e4), T(1e26)}) {
        this->m = {0, T(-10) * a, T(-10) * a, T(7) * a};
        this->q = {0, 0};
        this->lo = {0, 1};
        this->hi = {T(4) * a / T(1000), b < 1 ? T(2) : b};
        this->start = {0, 1};
        this->options.tolerance = 0;
        this->options.max_iterations = 30;
        this->expect_finite_by_every_method();
        this->m = {a, b, b, b, a, T(-1), b, T(-1), 1 / a};
        this->q = {-a, -b, -1};
        this->lo = {0, 0, 0};
        this->hi = {this->inf, a, 1};
        this->start = {0, 0, 0};
        this->expect_finite_by_every_method();
    }
}

// The sum M x overflows on its way to a w of -2 times what fits: w has the wrong sign for a row at its lower bound.
TYPED_TEST(Extremes, ASumThatOverflowsOnItsWayIsNotTakenForASolution) {
    using T = TypeParam;
    const T most = this->big;
    this->m = {most, -most, -most, -most, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    this->q = {0, 0, 0, 0};
    this->lo = this->hi = this->start = {T(1.5), 1, 1, 1};
    this->hi[0] = 2;
    const lcp::Residuals<T> r = lcp::residuals<T>(this->problem(), this->start);
    EXPECT_EQ(r.natural, T(0.5));
    EXPECT_EQ(this->solve(Method::pgs).status, Status::converged);
    EXPECT_EQ(this->x[0], T(2));
}

TYPED_TEST(Extremes, AnInfiniteWAtItsBoundIsComplementary) {
    using T = TypeParam;
    this->m = {this->big, this->big, 0, 1};
    this->q = {0, 0};
    this->lo = this->hi = this->start = {1, 1};
    this->hi[0] = 2;
    const lcp::Residuals<T> r = lcp::residuals<T>(this->problem(), this->start);
    EXPECT_EQ(r.natural, T(0));
    EXPECT_EQ(r.infeasibility, T(0));
    EXPECT_EQ(r.complementarity, T(0));
}

// A zero that a sparse matrix leaves out met an infinite step in a dense one, and they make a NaN.
TYPED_TEST(Extremes, NewtonTakesAZeroForAnEntryThatIsNotThere) {
    using T = TypeParam;
    this->m = {1, 0, 0, 1};
    this->q = {-1, 0};
    this->lo = {0, -this->big};
    this->hi = {this->big, -this->big};
    this->start = {0, this->big / 2};
    this->options.max_iterations = 1;
    this->options.tolerance = 0;
    this->solve(Method::newton);
    const std::vector<T> dense = this->x;
    const std::vector<T> ones = {1, 1};
    const std::vector<std::uint32_t> starts = {0, 1, 2}, columns = {0, 1};
    const lcp::Problem<T> sparse = {.sparse = {starts, columns, ones}, .q = this->q, .lo = this->lo, .hi = this->hi};
    std::vector<T> other = this->start;
    std::vector<std::byte> memory(lcp::workspace_bytes<T>(Method::newton, 2));
    (void)lcp::solve<T>(sparse, this->options, other, memory);
    EXPECT_EQ(dense, other);
}

TYPED_TEST(Extremes, ConjugateGradientsLeaveARowThatIsNotInTheOrderAsItIs) {
    using T = TypeParam;
    this->m = {1, 0, 0, 1};
    this->q = {0, 0};
    this->lo = {0, -this->inf};
    this->hi = {0, -1};
    this->start = {0, -T(0)};
    static const std::uint32_t order[] = {0};
    this->options.order = order;
    this->options.tolerance = 0;
    this->options.max_iterations = 3;
    this->solve(Method::nncg);
    EXPECT_TRUE(std::signbit(this->x[1]));
}

// A sweep ends at a row that cannot be solved, before it has come to one that the step along the direction put outside its bounds.
TYPED_TEST(Extremes, ConjugateGradientsThatFailKeepTheBounds) {
    using T = TypeParam;
    const T most = this->big * T(0.88);
    this->m = {0, 0, 0, 0, 0, -most, 0, 0, 0};
    this->q = {0, 0, most};
    this->lo = {1, -this->inf, T(-0.5)};
    this->hi = {1, 0, 0};
    this->start = {0, 0, 1};
    this->options.regularisation = this->big / 2;
    this->options.tolerance = 0;
    for (std::uint32_t limit = 1; limit < 12; ++limit) {
        this->options.max_iterations = limit;
        this->solve(Method::nncg);
        EXPECT_EQ(this->x[0], T(1));
        EXPECT_LE(this->x[1], T(0));
        EXPECT_GE(this->x[2], T(-0.5)) << limit;
        EXPECT_LE(this->x[2], T(0)) << limit;
    }
}

}  // namespace
}  // namespace islet::test
