// Projected Jacobi: every row is solved from the values of the last iteration, so the rows could be solved in any order or all at once. The price is slower
// convergence: rows that push against each other overshoot together, so omega must be small enough for the most coupled rows.
//
// If each row is divided by its sum of magnitudes instead, any omega up to 1 will do, because the largest eigenvalue of D^-1 M is at most 1. (The l1 smoother
// of Baker, Falgout, Kolev, Yang: Multigrid smoothers for ultraparallel computing, 2011.)
#include "../exact.hpp"

#include "../lcp/sweep.hpp"

namespace islet::lcp {

template <class T>
Result<T> run_jacobi(Task<T> task) {
    const Options<T>& o = task.options;
    T* const divisors = task.memory.template take<T>(task.size());
    T* const next = task.memory.template take<T>(task.size());
    return iterate(task, o.method == Method::l1_jacobi, divisors, [&] {
        for (std::uint32_t i = 0; i < task.rows; ++i) {
            const Bounds<T> b = bounds_of(task.problem, i, task.x);
            next[i] = clamp(task.x[i] - o.omega * row_value(task.problem, i, task.x) / divisors[i], b.lo, b.hi);
            if (!is_finite(next[i])) return i;
        }
        for (std::uint32_t i = 0; i < task.rows; ++i) task.x[i] = next[i];
        return no_row;
    });
}

template Result<float> run_jacobi(Task<float>);
template Result<double> run_jacobi(Task<double>);

}  // namespace islet::lcp
