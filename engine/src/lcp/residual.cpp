#include "../exact.hpp"

#include "../lcp/residual.hpp"

#include "../lcp/check.hpp"

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
    const T nearer = w > T(0) ? b.lo : b.hi;
    const T other = w > T(0) ? b.hi : b.lo;
    const T gap = is_finite(nearer) ? magnitude(x - nearer) : (is_finite(other) ? magnitude(x - other) : T(1));
    return w == T(0) || gap == T(0) ? T(0) : magnitude(w) * gap;  // an infinite w times 0 would be a NaN
}

}  // namespace

template <class T>
T overflowing_row_value(const Problem<T>& problem, std::uint32_t i, const T* x) {
    constexpr T s = Numbers<T>::shrink;
    const Row<T> row = row_of(problem, i);
    T sum = problem.q[i] * s * s;
    for (std::uint32_t k = 0; k < row.count; ++k) sum += (row.values[k] * s) * (x[row.column(k)] * s);
    return sum / s / s;
}

template <class T>
T natural_residual(const Problem<T>& problem, const T* x) {
    T most = T(0);
    for (std::uint32_t i = 0; i < row_count(problem); ++i) most = worse(most, magnitude(natural_map(x[i], row_value(problem, i, x), bounds_of(problem, i, x))));
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

template float overflowing_row_value(const Problem<float>&, std::uint32_t, const float*);
template double overflowing_row_value(const Problem<double>&, std::uint32_t, const double*);
template float natural_residual(const Problem<float>&, const float*);
template double natural_residual(const Problem<double>&, const double*);
template Residuals<float> all_residuals(const Problem<float>&, const float*);
template Residuals<double> all_residuals(const Problem<double>&, const double*);
template Residuals<float> residuals(const Problem<float>&, std::span<const float>);
template Residuals<double> residuals(const Problem<double>&, std::span<const double>);

}  // namespace islet::lcp
