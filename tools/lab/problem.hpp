// A complementarity problem in double precision that owns its numbers, where it comes from, and how it is scaled before it is measured.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <islet/lcp.hpp>

namespace islet::lab {

/// As lcp::Problem: w = M x + q between bounds, with Coulomb friction. M is symmetric.
struct Problem {
    std::vector<std::uint32_t> row_starts = {0}, columns;
    std::vector<double> values, q, lo, hi;
    std::vector<std::uint32_t> friction;  // lcp::no_row where there is none
    std::vector<std::uint32_t> blocks;    // the first rows of contacts and joints: lcp::Options::blocks
    std::vector<double> warm;             // x to start from: the impulses of the substep before

    std::size_t rows() const { return q.size(); }
    std::size_t entries() const { return values.size(); }
    lcp::Problem<double> view() const {
        return {.sparse = {row_starts, columns, values}, .q = q, .lo = lo, .hi = hi, .friction = friction};
    }
};

/// Where a problem comes from.
struct Island {
    std::string scene;
    int step = 0;           // steps taken before
    double h = 0;           // s, the substep that is solved for
    std::size_t index = 0;  // among the scene's islands, which are sorted: 0 has the most rows
    std::size_t bodies = 0, contacts = 0, joints = 0;
    Problem problem;
};

/// The same problem in other units, with the same solution. README.md, "What a residual is", says why.
struct ScaledProblem {
    Problem problem;            // M has ones on its diagonal, and x = 0 the natural residual 1
    std::vector<double> scale;  // x_i = scale[i] * the scaled x_i
    double unit = 1;            // sqrt(kg) m/s: the residual of x = 0 when M's diagonal is 1, by which all is divided; 1 if that is 0
};
ScaledProblem scale(const Problem& problem);

/// w = M x + q, without q where `with_q` is false.
std::vector<double> row_values(const Problem& problem, const std::vector<double>& x, bool with_q = true);

/// sqrt(x . M x): of impulses, the root of twice the kinetic energy that they give to bodies at rest.
double energy_norm(const Problem& problem, const std::vector<double>& x);

/// Natural residual, as lcp::residuals says.
double residual_of(const Problem& problem, const std::vector<double>& x);

}  // namespace islet::lab
