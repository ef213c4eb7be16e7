#include "../exact.hpp"

#include "../lcp/residual.hpp"

#include "../lcp/check.hpp"

namespace islet::lcp {

template <class T>
Residuals<T> residuals(const Problem<T>& problem, span<const T> x) {
    constexpr T inf = Numbers<T>::infinity;
    if (!check(problem, x).good()) return {inf, inf, inf};
    return all_residuals(problem, x.data());
}

template Residuals<float> residuals(const Problem<float>&, span<const float>);
template Residuals<double> residuals(const Problem<double>&, span<const double>);

}  // namespace islet::lcp
