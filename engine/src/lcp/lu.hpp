// Dense factorisation with row exchanges, for the free rows of newton, lemke and the blocks.
#pragma once

#include "../lcp/rows.hpp"

namespace islet::lcp {

/// Factors the n by n matrix a (rows `stride` apart) in place and turns b into the solution of a x = b. Rows are compared in relation to their largest
/// entries (`scales`, n numbers of scratch), so that a row in other units is not taken for a small one. Returns
/// the column whose pivot is lost in rounding, with which a and b are of no use, or no_row if all went well.
template <class T>
std::uint32_t solve_linear(T* a, std::size_t stride, std::uint32_t n, T* b, T* scales);

}  // namespace islet::lcp
