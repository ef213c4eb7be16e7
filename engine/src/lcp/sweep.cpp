#include "../exact.hpp"

#include "../lcp/sweep.hpp"

namespace islet::lcp {

template <class T>
Verdict find_divisors(const Problem<T>& problem, T regularisation, bool l1, T* divisors) {
    for (std::uint32_t i = 0; i < row_count(problem); ++i) {
        const Row<T> row = row_of(problem, i);
        T diagonal = T(0), most = T(0), sum = T(0);
        for (std::uint32_t k = 0; k < row.count; ++k) {
            if (row.column(k) == i) diagonal = row.values[k];
            most = larger(most, magnitude(row.values[k]));
            sum += magnitude(row.values[k]);
        }
        // Below this, rounding in the rest of the row would decide the step.
        const T tiny = larger(Numbers<T>::epsilon * most, Numbers<T>::smallest);
        if (!(diagonal > tiny)) {
            diagonal += regularisation;
            sum += regularisation;
        }
        if (!(diagonal > tiny)) return {Status::bad_diagonal, i};
        divisors[i] = l1 ? sum : diagonal;
    }
    return {};
}

template <class T>
std::uint32_t sweep(const Problem<T>& problem, std::span<const std::uint32_t> order, bool back, T omega, const T* divisors, T* x) {
    const std::size_t count = order.empty() ? problem.q.size() : order.size();
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t place = back ? count - 1 - k : k;
        const std::uint32_t i = order.empty() ? static_cast<std::uint32_t>(place) : order[place];
        if (!solve_row(problem, i, omega, divisors[i], x)) return i;
    }
    return no_row;
}

template Verdict find_divisors(const Problem<float>&, float, bool, float*);
template Verdict find_divisors(const Problem<double>&, double, bool, double*);
template std::uint32_t sweep(const Problem<float>&, std::span<const std::uint32_t>, bool, float, const float*, float*);
template std::uint32_t sweep(const Problem<double>&, std::span<const std::uint32_t>, bool, double, const double*, double*);

}  // namespace islet::lcp
