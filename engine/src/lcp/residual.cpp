#include "lcp/residual.hpp"

#include "lcp/check.hpp"

namespace islet::lcp {
namespace {

template <class T>
T infeasibility_of(T x, T w, Bounds<T> b) {
    T most = larger(larger(b.lo - x, x - b.hi), T(0));
    if (x <= b.lo && x < b.hi) most = worse(most, -w);
    if (x >= b.hi && x > b.lo) most = worse(most, w);
    return most;
}

template <class T>
T complementarity_of(T x, T w, Bounds<T> b) {
    if (w == T(0)) return T(0);
    const T to_lo = magnitude(x - b.lo);
    const T to_hi = magnitude(b.hi - x);
    T gap = w > T(0) ? to_lo : to_hi;
    if (!is_finite(gap)) gap = w > T(0) ? to_hi : to_lo;
    if (!is_finite(gap)) gap = T(1);
    return magnitude(w) * gap;
}

}  // namespace

template <class T>
T natural_residual(const Problem<T>& problem, const T* x) {
    T most = T(0);
    for (std::uint32_t i = 0; i < row_count(problem); ++i)
        most = worse(most, magnitude(natural_map(x[i], row_value(problem, i, x), bounds_of(problem, i, x))));
    return most;
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

template <class T>
Residuals<T> residuals(const Problem<T>& problem, std::span<const T> x) {
    constexpr T inf = Numbers<T>::infinity;
    if (!check(problem, x).good()) return {inf, inf, inf};
    return all_residuals(problem, x.data());
}

template float natural_residual(const Problem<float>&, const float*);
template double natural_residual(const Problem<double>&, const double*);
template Residuals<float> all_residuals(const Problem<float>&, const float*);
template Residuals<double> all_residuals(const Problem<double>&, const double*);
template Residuals<float> residuals(const Problem<float>&, std::span<const float>);
template Residuals<double> residuals(const Problem<double>&, std::span<const double>);

}  // namespace islet::lcp
