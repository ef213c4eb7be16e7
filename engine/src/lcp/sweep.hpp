// A sweep of projected Gauss-Seidel, and the diagonal by which its steps are divided.
#pragma once

#include "../lcp/check.hpp"
#include "../lcp/rows.hpp"

namespace islet::lcp {

/// Finds the divisor of each row's residual: its diagonal, regularised where it is tiny, or with `l1` the sum of the row's magnitudes. Refuses the first row
/// that regularisation does not help.
template <class T>
Verdict find_divisors(const Problem<T>& problem, T regularisation, bool l1, T* divisors);

/// Solves one row with the newest values of all others: takes the step that brings its w to 0, cut at the bounds. Returns false, and changes nothing, if the
/// result is not finite.
template <class T>
bool solve_row(const Problem<T>& problem, std::uint32_t i, T omega, T divisor, T* x) {
    const T w = row_value(problem, i, x);
    const Bounds<T> b = bounds_of(problem, i, x);
    const T next = clamp(x[i] - omega * w / divisor, b.lo, b.hi);
    if (!is_finite(next)) return false;
    x[i] = next;
    return true;
}

/// Sweeps the rows of `order`, or 0, 1, 2, ... if it is empty, forward or back. Returns the row that failed, or no_row.
template <class T>
std::uint32_t sweep(const Problem<T>& problem, std::span<const std::uint32_t> order, bool back, T omega, const T* divisors, T* x);

}  // namespace islet::lcp
