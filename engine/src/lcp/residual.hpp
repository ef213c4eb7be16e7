// How far x is from a solution. The arguments have been checked.
#pragma once

#include "../lcp/rows.hpp"

namespace islet::lcp {

/// The natural map of a row, x - clamp(x - w, lo, hi), written so that a small w is not lost beside a large x.
template <class T>
T natural_map(T x, T w, Bounds<T> b) {
    return clamp(w, x - b.hi, x - b.lo);
}

template <class T>
T natural_residual(const Problem<T>& problem, const T* x);

template <class T>
Residuals<T> all_residuals(const Problem<T>& problem, const T* x);

}  // namespace islet::lcp
