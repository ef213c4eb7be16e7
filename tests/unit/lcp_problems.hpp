// Complementarity problems for the tests of the matrix solvers, and residuals of our own to judge them by.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "islet/lcp.hpp"
#include "support/random.hpp"

namespace islet::test {

inline constexpr double inf = std::numeric_limits<double>::infinity();

/// A problem in double precision that owns its numbers; `known` is a solution where one is.
struct LcpCase {
    std::string name;
    std::size_t n = 0;
    std::vector<std::uint32_t> row_starts, columns;
    std::vector<double> values, q, lo, hi, known;
    std::vector<std::uint32_t> friction, blocks;
};

/// From all entries of M, row after row; zeros are left out.
inline LcpCase lcp_case(std::string name, const std::vector<double>& m, std::vector<double> q) {
    LcpCase c;
    c.name = std::move(name);
    c.n = q.size();
    c.q = std::move(q);
    c.row_starts.push_back(0);
    for (std::size_t i = 0; i < c.n; ++i) {
        for (std::size_t j = 0; j < c.n; ++j) {
            if (m[i * c.n + j] == 0) continue;
            c.columns.push_back(static_cast<std::uint32_t>(j));
            c.values.push_back(m[i * c.n + j]);
        }
        c.row_starts.push_back(static_cast<std::uint32_t>(c.values.size()));
    }
    return c;
}

/// The same in float or double, as the solvers take it.
template <class T>
struct LcpData {
    std::vector<T> dense, values, q, lo, hi;
    std::vector<std::uint32_t> row_starts, columns, friction, blocks;

    explicit LcpData(const LcpCase& c)
        : values(c.values.begin(), c.values.end()),
          q(c.q.begin(), c.q.end()),
          lo(c.lo.begin(), c.lo.end()),
          hi(c.hi.begin(), c.hi.end()),
          row_starts(c.row_starts),
          columns(c.columns),
          friction(c.friction),
          blocks(c.blocks) {
        if (c.n > 400) return;  // too large to be worth it
        dense.assign(c.n * c.n, T(0));
        for (std::size_t i = 0; i < c.n; ++i)
            for (std::uint32_t k = row_starts[i]; k < row_starts[i + 1]; ++k) dense[i * c.n + columns[k]] = values[k];
    }
    lcp::Problem<T> sparse_problem() const {
        return {.sparse = {row_starts, columns, values}, .q = q, .lo = lo, .hi = hi, .friction = friction};
    }
    lcp::Problem<T> dense_problem() const { return {.dense = {dense}, .q = q, .lo = lo, .hi = hi, .friction = friction}; }
};

template <class T>
struct LcpRun {
    lcp::Result<T> result;
    std::vector<T> x;
};

template <class T>
LcpRun<T> run(const lcp::Problem<T>& problem, const lcp::Options<T>& options, std::vector<T> start = {}) {
    LcpRun<T> r;
    r.x = std::move(start);
    r.x.resize(problem.q.size(), T(0));
    std::vector<std::byte> memory(lcp::workspace_bytes<T>(options.method, problem.q.size()));
    r.result = lcp::solve<T>(problem, options, r.x, memory);
    return r;
}

/// The three residuals from their definitions, in long double; `rounding` is what computing them in T may differ by.
struct OwnResiduals {
    long double infeasibility = 0, complementarity = 0, natural = 0, rounding = 0, largest_gap = 1;
};

template <class T>
OwnResiduals own_residuals(const LcpData<T>& p, const std::vector<T>& x) {
    using Wide = long double;
    OwnResiduals worst;
    for (std::size_t i = 0; i < x.size(); ++i) {
        Wide w = p.q[i], terms = std::fabs(Wide(p.q[i]));
        for (std::uint32_t k = p.row_starts[i]; k < p.row_starts[i + 1]; ++k) {
            const Wide term = Wide(p.values[k]) * Wide(x[p.columns[k]]);
            w += term;
            terms += std::fabs(term);
        }
        Wide lo = p.lo.empty() ? 0 : Wide(p.lo[i]), hi = p.hi.empty() ? inf : Wide(p.hi[i]);
        if (!p.friction.empty() && p.friction[i] != lcp::no_row) {
            hi = Wide(p.hi[i]) * std::max(Wide(x[p.friction[i]]), Wide(0));
            lo = -hi;
        }
        const Wide at = x[i];
        const Wide count = Wide(p.row_starts[i + 1] - p.row_starts[i]) + 4;
        const Wide rounding = count * std::numeric_limits<T>::epsilon() * (terms + std::fabs(at) + (std::isfinite(hi) ? std::fabs(hi) : 0));
        worst.rounding = std::max(worst.rounding, rounding);
        worst.natural = std::max(worst.natural, std::fabs(at - std::clamp(at - w, lo, hi)));
        Wide outside = std::max({lo - at, at - hi, Wide(0)});
        if (at <= lo && at < hi) outside = std::max(outside, -w);
        if (at >= hi && at > lo) outside = std::max(outside, w);
        worst.infeasibility = std::max(worst.infeasibility, outside);
        Wide gap = w > 0 ? std::fabs(at - lo) : std::fabs(hi - at);
        if (!std::isfinite(gap)) gap = w > 0 ? std::fabs(hi - at) : std::fabs(at - lo);
        if (!std::isfinite(gap)) gap = 1;
        worst.largest_gap = std::max(worst.largest_gap, gap);
        worst.complementarity = std::max(worst.complementarity, w == 0 ? 0 : std::fabs(w) * gap);
    }
    return worst;
}

// -- random matrices --------------------------------------------------------------------------------------------------------------------------------

inline double between(Random& random, double lo, double hi) { return lo + (hi - lo) * static_cast<double>(random.between(0, 1)); }

/// A A^T of an n by `rank` matrix A of random numbers, divided by the rank, with `ridge` added to the diagonal.
inline std::vector<double> random_gram(std::size_t n, std::size_t rank, double ridge, Random& random) {
    std::vector<double> a(n * rank), m(n * n);
    for (double& v : a) v = between(random, -1, 1);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) {
            double sum = i == j ? ridge : 0;
            for (std::size_t k = 0; k < rank; ++k) sum += a[i * rank + k] * a[j * rank + k] / static_cast<double>(rank);
            m[i * n + j] = sum;
        }
    return m;
}

inline std::vector<double> random_vector(std::size_t n, double lo, double hi, Random& random) {
    std::vector<double> v(n);
    for (double& e : v) e = between(random, lo, hi);
    return v;
}

/// Symmetric and positive definite. With bounds: some rows one-sided, some two-sided, some fixed, some without any.
inline LcpCase positive_definite_case(std::size_t n, bool bounded, std::uint32_t seed) {
    Random random(seed);
    // (One after the other: compilers differ in the order in which they evaluate arguments.)
    const std::vector<double> m = random_gram(n, n, 0.3, random);
    LcpCase c = lcp_case("positive definite " + std::to_string(n) + (bounded ? " bounded" : ""), m, random_vector(n, -1, 1, random));
    if (!bounded) return c;
    for (std::size_t i = 0; i < n; ++i) {
        const double at = between(random, -1, 1);
        switch (random.below(6)) {
        case 0: c.lo.push_back(at), c.hi.push_back(inf); break;
        case 1: c.lo.push_back(-inf), c.hi.push_back(at); break;
        case 2: c.lo.push_back(at), c.hi.push_back(at); break;
        case 3: c.lo.push_back(-inf), c.hi.push_back(inf); break;
        default: c.lo.push_back(at), c.hi.push_back(at + 0.5); break;
        }
    }
    return c;
}

/// Symmetric, positive semi-definite of half the rank, with q such that there are solutions: w = M x + q for complementary x and w.
inline LcpCase semi_definite_case(std::size_t n, std::uint32_t seed) {
    Random random(seed);
    const std::vector<double> m = random_gram(n, (n + 1) / 2, 0, random);
    std::vector<double> q(n);
    for (std::size_t i = 0; i < n; ++i) q[i] = i % 3 == 0 ? between(random, 0.1, 1) : 0;
    std::vector<double> x(n);
    for (std::size_t i = 0; i < n; ++i) x[i] = i % 3 == 0 ? 0 : between(random, 0.1, 1);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) q[i] -= m[i * n + j] * x[j];
    LcpCase c = lcp_case("semi-definite " + std::to_string(n), m, q);
    c.known = x;
    return c;
}

/// Not symmetric: positive definite plus a skew part, which makes it a P-matrix, so that there is exactly one solution.
inline LcpCase p_matrix_case(std::size_t n, std::uint32_t seed) {
    Random random(seed);
    std::vector<double> m = random_gram(n, n, 0.3, random);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const double skew = between(random, -1, 1) / std::sqrt(static_cast<double>(n));
            m[i * n + j] += skew;
            m[j * n + i] -= skew;
        }
    return lcp_case("P-matrix " + std::to_string(n), m, random_vector(n, -1, 1, random));
}

// -- bodies, as far as a matrix knows of them ---------------------------------------------------------------------------------------------------------

/// A tower of boxes under gravity: normal and friction of two contact points below each. J M^-1 J^T with one step's fall and a push to the side as q.
inline LcpCase tower_case(std::size_t boxes, double friction, double push) {
    const std::size_t points = 2 * boxes, n = 2 * points, unknowns = 3 * boxes;
    std::vector<double> j(n * unknowns, 0), m(n * n, 0), q(n, 0);
    const double half = 0.5, inverse_mass = 1, inverse_inertia = 6;  // a unit box of 1 kg
    for (std::size_t p = 0; p < points; ++p) {
        const std::size_t box = p / 2;
        const double x = p % 2 == 0 ? -half : half;
        double* const normal = &j[2 * p * unknowns];
        double* const tangent = &j[(2 * p + 1) * unknowns];
        normal[3 * box + 1] = 1, normal[3 * box + 2] = x;
        tangent[3 * box] = 1, tangent[3 * box + 2] = half;
        if (box == 0) continue;
        normal[3 * box - 2] = -1, normal[3 * box - 1] = -x;
        tangent[3 * box - 3] = -1, tangent[3 * box - 1] = half;
    }
    for (std::size_t r = 0; r < n; ++r) {
        for (std::size_t s = 0; s < n; ++s)
            for (std::size_t u = 0; u < unknowns; ++u)
                m[r * n + s] += j[r * unknowns + u] * j[s * unknowns + u] * (u % 3 == 2 ? inverse_inertia : inverse_mass);
        for (std::size_t b = 0; b < boxes; ++b) q[r] += j[r * unknowns + 3 * b + 1] * -10.0 / 60 + j[r * unknowns + 3 * b] * push;
    }
    LcpCase c = lcp_case("tower of " + std::to_string(boxes) + (friction > 0 ? " with friction" : ""), m, q);
    for (std::size_t r = 0; r < n; ++r) {
        c.lo.push_back(0);
        c.hi.push_back(r % 2 == 0 ? std::numeric_limits<double>::infinity() : friction);
        c.friction.push_back(r % 2 == 0 ? lcp::no_row : static_cast<std::uint32_t>(r - 1));
        if (r % 4 == 0) c.blocks.push_back(static_cast<std::uint32_t>(r));
    }
    return c;
}

// -- sparse ones of any size --------------------------------------------------------------------------------------------------------------------------

/// An elastic string over an obstacle: 2 + `ridge` on the diagonal, -1 beside it.
inline LcpCase string_case(std::size_t n, double ridge, std::uint32_t seed) {
    Random random(seed);
    LcpCase c;
    c.name = "string " + std::to_string(n);
    c.n = n;
    c.q = random_vector(n, -1, 1, random);
    c.row_starts.push_back(0);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = i > 0 ? i - 1 : 0; j < std::min(n, i + 2); ++j) {
            c.columns.push_back(static_cast<std::uint32_t>(j));
            c.values.push_back(i == j ? 2 + ridge : -1);
        }
        c.row_starts.push_back(static_cast<std::uint32_t>(c.values.size()));
    }
    return c;
}

/// Tight blocks of `size` rows between wide bounds, each row coupled loosely to its likes in the blocks beside.
inline LcpCase blocks_case(std::size_t count, std::size_t size, std::uint32_t seed) {
    Random random(seed);
    LcpCase c;
    c.name = "blocks of " + std::to_string(size);
    c.n = count * size;
    c.q = random_vector(c.n, -1, 1, random);
    c.lo.assign(c.n, -4);
    c.hi.assign(c.n, 4);
    c.row_starts.push_back(0);
    for (std::size_t b = 0; b < count; ++b) {
        c.blocks.push_back(static_cast<std::uint32_t>(b * size));
        for (std::size_t k = 0; k < size; ++k) {
            const auto add = [&](std::size_t column, double value) {
                c.columns.push_back(static_cast<std::uint32_t>(column));
                c.values.push_back(value);
            };
            if (b > 0) add((b - 1) * size + k, -0.02);
            for (std::size_t l = 0; l < size; ++l) add(b * size + l, k == l ? 1 : 0.9);
            if (b + 1 < count) add((b + 1) * size + k, -0.02);
            c.row_starts.push_back(static_cast<std::uint32_t>(c.values.size()));
        }
    }
    return c;
}

// -- hard for pivoting: 1 on the diagonal and 2 below it, and that times its transpose. Both have the solution (1, 0, 0, ...) for q = -1. ---------------------

inline std::vector<double> murty_matrix(std::size_t n) {
    std::vector<double> m(n * n, 0);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j <= i; ++j) m[i * n + j] = i == j ? 1 : 2;
    return m;
}

inline LcpCase murty_case(std::size_t n) {
    LcpCase c = lcp_case("Murty " + std::to_string(n), murty_matrix(n), std::vector<double>(n, -1));
    c.known.assign(n, 0);
    c.known[0] = 1;
    return c;
}

inline LcpCase fathi_case(std::size_t n) {
    const std::vector<double> l = murty_matrix(n);
    std::vector<double> m(n * n, 0);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
            for (std::size_t k = 0; k < n; ++k) m[i * n + j] += l[i * n + k] * l[j * n + k];
    LcpCase c = lcp_case("Fathi " + std::to_string(n), m, std::vector<double>(n, -1));
    c.known.assign(n, 0);
    c.known[0] = 1;
    return c;
}

}  // namespace islet::test
