// Small problems for the tests of the laboratory.
#pragma once

#include <vector>

#include "lab/problem.hpp"
#include "unit/lcp_problems.hpp"

namespace islet::test {

/// M = [4 2; 2 9], q = (-8, 3), x >= 0. The first row alone wants x = 2; then w = (0, 7): that is the solution.
inline lab::Problem two_rows() {
    lab::Problem p;
    p.row_starts = {0, 2, 4};
    p.columns = {0, 1, 0, 1};
    p.values = {4, 2, 2, 9};
    p.q = {-8, 3};
    p.lo = {0, 0};
    p.hi = {inf, inf};
    p.friction = {lcp::no_row, lcp::no_row};
    p.blocks = {0};
    p.warm = {1.5, 0};
    return p;
}

/// The same problem as the solvers' own tests have it.
inline lab::Problem owned(const LcpCase& c) {
    lab::Problem p;
    p.row_starts = c.row_starts;
    p.columns = c.columns;
    p.values = c.values;
    p.q = c.q;
    p.lo = c.lo;
    p.hi = c.hi;
    p.friction = c.friction;
    p.blocks = c.blocks;
    p.warm.assign(c.n, 0);
    return p;
}

}  // namespace islet::test
