// A sweep of projected Gauss-Seidel, the diagonal by which its steps are divided, and the loop of the methods that sweep.
#pragma once

#include "../lcp/task.hpp"

namespace islet::lcp {

/// Finds the divisor of each row's residual: its diagonal, regularised where it is tiny, or with `l1` the sum of the row's magnitudes. Refuses the first row
/// that regularisation does not help.
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
std::uint32_t sweep(const Problem<T>& problem, span<const std::uint32_t> order, bool back, T omega, const T* divisors, T* x) {
    const std::size_t count = order.empty() ? problem.q.size() : order.size();
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t place = back ? count - 1 - k : k;
        const std::uint32_t i = order.empty() ? static_cast<std::uint32_t>(place) : order[place];
        if (!solve_row(problem, i, omega, divisors[i], x)) return i;
    }
    return no_row;
}

/// Calls iteration(), which returns the row that failed or no_row, until x is good enough. Fills the divisors first.
template <class T, class Iteration>
Result<T> iterate(const Task<T>& task, bool l1, T* divisors, Iteration&& iteration) {
    const Options<T>& o = task.options;
    if (const Verdict v = find_divisors(task.problem, o.regularisation, l1, divisors); !v.good()) return finish(task, v.status, v.row, 0);
    if (reached(task, 0)) return finish(task, Status::converged, no_row, 0);
    for (std::uint32_t done = 1; done <= o.max_iterations; ++done) {
        const std::uint32_t failed = iteration();
        if (failed != no_row) return finish(task, Status::diverged, failed, done);
        if (reached(task, done)) return finish(task, Status::converged, no_row, done);
    }
    return finish(task, Status::iteration_limit, no_row, o.max_iterations);
}

}  // namespace islet::lcp
