// Dense LU factorisation with row exchanges, for the free rows of newton, lemke and the blocks.
#pragma once

#include "../lcp/rows.hpp"

namespace islet::lcp {

/// Factors the n by n matrix a (rows `stride` apart) in place and turns b into the solution of a x = b. Rows are compared relative to their largest entries
/// (`scales`, n numbers of scratch), so that a row in other units does not count as small. Returns no_row if all went well, else the column whose pivot is lost
/// in rounding; a and b are then of no use.
template <class T>
std::uint32_t solve_linear(T* a, std::size_t stride, std::uint32_t n, T* b, T* scales);

}  // namespace islet::lcp
