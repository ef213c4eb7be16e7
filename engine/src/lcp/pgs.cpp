// Projected Gauss-Seidel in its orders: as given, forward and back, red and black.
//
// For symmetric positive semi-definite M, each row's step is the exact minimum of x.M x / 2 + q.x along that row's axis, so the sweeps descend. For the theory
// see Cottle, Pang, Stone: The Linear Complementarity Problem (1992), chapter 5.
#include "../exact.hpp"

#include "../lcp/sweep.hpp"

namespace islet::lcp {
namespace {

template <class T>
std::uint32_t red_black_sweep(const Task<T>& task, const T* divisors) {
    for (std::uint32_t color = 0; color < 2; ++color)
        for (std::uint32_t i = color; i < task.rows; i += 2)
            if (!solve_row(task.problem, i, task.options.omega, divisors[i], task.x)) return i;
    return no_row;
}

template <class T>
std::uint32_t one_iteration(const Task<T>& task, const T* divisors) {
    const Options<T>& o = task.options;
    if (o.method == Method::red_black) return red_black_sweep(task, divisors);
    const T omega = o.method == Method::pgs ? T(1) : o.omega;
    const std::uint32_t failed = sweep(task.problem, o.order, false, omega, divisors, task.x);
    if (failed != no_row || o.method != Method::symmetric_pgs) return failed;
    return sweep(task.problem, o.order, true, omega, divisors, task.x);
}

}  // namespace

template <class T>
Result<T> run_sweeps(Task<T> task) {
    T* const divisors = task.memory.template take<T>(task.size());
    return iterate(task, false, divisors, [&] { return one_iteration(task, divisors); });
}

template <class T>
Result<T> solve_by_sweeps(const Problem<T>& problem, const Options<T>& options, span<T> x, span<std::byte> workspace) {
    if (const Verdict v = check_all(problem, options, x, workspace); !v.good()) return refuse(problem, x, v);
    if (options.method > Method::red_black) return refuse(problem, x, {Status::unsupported, no_row});
    return run_sweeps(Task<T>{problem, options, x.data(), row_count(problem), Workspace(workspace)});
}

template Result<float> run_sweeps(Task<float>);
template Result<double> run_sweeps(Task<double>);
template Result<float> solve_by_sweeps(const Problem<float>&, const Options<float>&, span<float>, span<std::byte>);
template Result<double> solve_by_sweeps(const Problem<double>&, const Options<double>&, span<double>, span<std::byte>);

}  // namespace islet::lcp
