#include "problem.hpp"

#include <algorithm>
#include <cmath>

namespace islet::lab {

std::vector<double> row_values(const Problem& problem, const std::vector<double>& x, bool with_q) {
    std::vector<double> w(problem.rows(), 0);
    for (std::size_t i = 0; i < w.size(); ++i) {
        if (with_q) w[i] = problem.q[i];
        for (std::uint32_t k = problem.row_starts[i]; k < problem.row_starts[i + 1]; ++k) w[i] += problem.values[k] * x[problem.columns[k]];
    }
    return w;
}

double energy_norm(const Problem& problem, const std::vector<double>& x) {
    const std::vector<double> mx = row_values(problem, x, false);
    double sum = 0;
    for (std::size_t i = 0; i < x.size(); ++i) sum += x[i] * mx[i];
    return std::sqrt(std::max(sum, 0.0));  // below 0 by rounding alone
}

double residual_of(const Problem& problem, const std::vector<double>& x) { return lcp::residuals<double>(problem.view(), x).natural; }

ScaledProblem scale(const Problem& problem) {
    ScaledProblem scaled;
    Problem& p = scaled.problem = problem;
    const std::size_t n = p.rows();
    // root[i] is the square root of the row's diagonal; a row without one, which the methods will refuse, is left as it is.
    std::vector<double> root(n, 1);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::uint32_t k = p.row_starts[i]; k < p.row_starts[i + 1]; ++k)
            if (p.columns[k] == i && p.values[k] > 0) root[i] = std::sqrt(p.values[k]);
    }
    for (std::size_t i = 0; i < n; ++i) {
        for (std::uint32_t k = p.row_starts[i]; k < p.row_starts[i + 1]; ++k) p.values[k] /= root[i] * root[p.columns[k]];
        p.q[i] /= root[i];
        p.warm[i] *= root[i];
        if (p.friction[i] != lcp::no_row) {
            p.hi[i] *= root[i] / root[p.friction[i]];  // a coefficient: it multiplies another row's x
        } else {
            p.lo[i] *= root[i];
            p.hi[i] *= root[i];
        }
    }
    const double at_zero = residual_of(p, std::vector<double>(n, 0));
    if (at_zero > 0 && std::isfinite(at_zero)) scaled.unit = at_zero;
    scaled.scale.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        scaled.scale[i] = scaled.unit / root[i];
        p.q[i] /= scaled.unit;
        p.warm[i] /= scaled.unit;
        if (p.friction[i] != lcp::no_row) continue;
        p.lo[i] /= scaled.unit;
        p.hi[i] /= scaled.unit;
    }
    return scaled;
}

}  // namespace islet::lab
