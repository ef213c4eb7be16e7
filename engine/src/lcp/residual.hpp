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
T natural_residual(const Problem<T>& problem, const T* x) {
    T most = T(0);
    for (std::uint32_t i = 0; i < row_count(problem); ++i) most = worse(most, magnitude(natural_map(x[i], row_value(problem, i, x), bounds_of(problem, i, x))));
    return most;
}

template <class T>
T infeasibility_of(T x, T w, Bounds<T> b) {
    T most = larger(larger(b.lo - x, x - b.hi), T(0));
    if (x <= b.lo && x < b.hi) most = worse(most, -w);
    if (x >= b.hi && x > b.lo) most = worse(most, w);
    return most;
}

template <class T>
T complementarity_of(T x, T w, Bounds<T> b) {
    const T nearer = w > T(0) ? b.lo : b.hi;
    const T other = w > T(0) ? b.hi : b.lo;
    const T gap = is_finite(nearer) ? magnitude(x - nearer) : (is_finite(other) ? magnitude(x - other) : T(1));
    return w == T(0) || gap == T(0) ? T(0) : magnitude(w) * gap;  // an infinite w times 0 would be a NaN
}

template <class T>
Residuals<T> all_residuals(const Problem<T>& problem, const T* x) {
    Residuals<T> most;
    for (std::uint32_t i = 0; i < row_count(problem); ++i) {
        const T w = row_value(problem, i, x);
        const Bounds<T> b = bounds_of(problem, i, x);
        most.natural = worse(most.natural, magnitude(natural_map(x[i], w, b)));
        most.infeasibility = worse(most.infeasibility, infeasibility_of(x[i], w, b));
        most.complementarity = worse(most.complementarity, complementarity_of(x[i], w, b));
    }
    return most;
}

}  // namespace islet::lcp
