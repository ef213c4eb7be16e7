// Semismooth Newton on the natural map F(x) = median(w, x - hi, x - lo), whose zeros are the solutions. Where the median is w the row is free and its
// derivative is M's; elsewhere the row is at a bound and its derivative is 1 (for friction with a part in the normal row). Only the free rows need solving; the
// others follow.
//
// A step is halved until |F|^2 falls (Armijo). If the equations have no unique solution, as with equal rows, or no length of step will do, as at the kinks of
// F, the method tries a step with a damped matrix (Levenberg). If that fails, too, one sweep of PGS moves x elsewhere; the best x so far is kept. Sources: Qi
// and Sun 1993 (the method), Erleben: Numerical methods for linear complementarity problems in physics-based animation, SIGGRAPH 2013 (the minimum map and the
// falling back).
#include "../exact.hpp"

#include "../lcp/lu.hpp"
#include "../lcp/sweep.hpp"

namespace islet::lcp {
namespace {

constexpr std::uint32_t most_halvings = 12;
constexpr std::uint32_t most_without_gain = 30;  // iterations since the best x, after which the method gives up
constexpr double least_descent = 1e-4;           // Armijo's share of what the slope promises

/// Damping relative to the largest entry: the root of the rounding unit, so that half of the digits decide the direction.
template <class T>
constexpr T damping = sizeof(T) == sizeof(float) ? T(3e-4) : T(1e-8);

template <class T>
struct Newton {
    T* matrix;
    T* divisors;
    T* f;  // the natural map at x
    T* step;
    T* rhs;
    T* trial;
    T* best;
    std::uint32_t* free_rows;
    std::uint32_t* index;   // of a row among the free ones, or no_row
    std::uint32_t* normal;  // the row that a friction row at its bound follows, or no_row
    std::uint32_t* upper;   // 1: at the upper bound
    std::uint32_t free_count;
};

/// Half of which falls in every step. Sets f.
template <class T>
T squared_map(const Task<T>& task, const T* x, T* f) {
    T sum = T(0);
    for (std::uint32_t i = 0; i < task.rows; ++i) {
        f[i] = natural_map(x[i], row_value(task.problem, i, x), bounds_of(task.problem, i, x));
        sum += f[i] * f[i];
    }
    return is_finite(sum) ? sum : Numbers<T>::infinity;
}

/// Finds which rows are free at x, and what the other rows follow.
template <class T>
void classify(const Task<T>& task, Newton<T>& s) {
    s.free_count = 0;
    for (std::uint32_t i = 0; i < task.rows; ++i) {
        const T w = row_value(task.problem, i, task.x);
        const Bounds<T> b = bounds_of(task.problem, i, task.x);
        s.index[i] = s.normal[i] = no_row;
        s.upper[i] = w < task.x[i] - b.hi ? 1 : 0;
        if (w >= task.x[i] - b.hi && w <= task.x[i] - b.lo) {
            s.index[i] = s.free_count;
            s.free_rows[s.free_count++] = i;
        } else if (has_friction(task.problem, i) && task.x[task.problem.friction[i]] > T(0)) {
            s.normal[i] = task.problem.friction[i];
        }
    }
}

/// How far friction row i, at its bound, moves for a unit of its normal row's step.
template <class T>
T friction_slope(const Task<T>& task, const Newton<T>& s, std::uint32_t i) {
    return s.upper[i] != 0 ? task.problem.hi[i] : -task.problem.hi[i];
}

/// The Newton step; returns the row where its equations failed, or no_row.
template <class T>
std::uint32_t find_step(const Task<T>& task, Newton<T>& s, bool damped) {
    classify(task, s);
    const std::size_t m = s.free_count;
    for (std::uint32_t i = 0; i < task.rows; ++i)
        if (s.index[i] == no_row) s.step[i] = -s.f[i];
    for (std::uint32_t i = 0; i < task.rows; ++i) {
        if (s.normal[i] == no_row || s.index[s.normal[i]] != no_row) continue;
        s.step[i] += friction_slope(task, s, i) * s.step[s.normal[i]];
        s.normal[i] = no_row;
    }
    for (std::size_t k = 0; k < m; ++k) {
        T* const a = s.matrix + k * m;
        for (std::size_t l = 0; l < m; ++l) a[l] = T(0);
        s.rhs[k] = -s.f[s.free_rows[k]];
        const Row<T> row = row_of(task.problem, s.free_rows[k]);
        for (std::uint32_t e = 0; e < row.count; ++e) {
            const std::uint32_t j = row.column(e);
            if (row.values[e] == T(0)) continue;  // a sparse matrix may leave it out, and 0 times an infinite step is NaN
            if (s.index[j] != no_row) {
                a[s.index[j]] += row.values[e];
                continue;
            }
            s.rhs[k] -= row.values[e] * s.step[j];
            if (s.normal[j] != no_row) a[s.index[s.normal[j]]] += row.values[e] * friction_slope(task, s, j);
        }
    }
    if (damped) {
        T largest = T(0);
        for (std::size_t k = 0; k < m * m; ++k) largest = larger(largest, magnitude(s.matrix[k]));
        const T added = larger(damping<T> * largest, task.options.regularisation);
        for (std::size_t k = 0; k < m; ++k) s.matrix[k * m + k] += added;
    }
    const std::uint32_t failed = solve_linear(s.matrix, m, s.free_count, s.rhs, s.trial);
    if (failed != no_row) return s.free_rows[failed];
    for (std::size_t k = 0; k < m; ++k) s.step[s.free_rows[k]] = s.rhs[k];
    for (std::uint32_t i = 0; i < task.rows; ++i)
        if (s.normal[i] != no_row) s.step[i] += friction_slope(task, s, i) * s.step[s.normal[i]];
    return no_row;
}

template <class T>
bool all_finite(const Task<T>& task, const T* x) {
    for (std::uint32_t i = 0; i < task.rows; ++i)
        if (!is_finite(x[i])) return false;
    return true;
}

/// Goes along the step as far as |F|^2 falls enough. Returns false, with x and f as they were, if it falls nowhere.
template <class T>
bool search_along(const Task<T>& task, Newton<T>& s, T square) {
    T length = T(1);
    for (std::uint32_t halving = 0; halving <= most_halvings; ++halving, length *= T(0.5)) {
        for (std::uint32_t i = 0; i < task.rows; ++i) s.trial[i] = task.x[i] + length * s.step[i];
        if (!all_finite(task, s.trial)) continue;  // after an overflow the map means nothing
        const T trial_square = squared_map(task, s.trial, s.rhs);
        if (!is_finite(trial_square) || trial_square > (T(1) - T(2 * least_descent) * length) * square) continue;
        for (std::uint32_t i = 0; i < task.rows; ++i) task.x[i] = s.trial[i];
        return true;
    }
    return false;
}

}  // namespace

template <class T>
Result<T> run_newton(Task<T> task) {
    const std::size_t n = task.size();
    Newton<T> s = {};
    s.matrix = task.memory.template take<T>(n * n);
    for (T** array : {&s.divisors, &s.f, &s.step, &s.rhs, &s.trial, &s.best}) *array = task.memory.template take<T>(n);
    for (std::uint32_t** array : {&s.free_rows, &s.index, &s.normal, &s.upper}) *array = task.memory.template take<std::uint32_t>(n);

    // Only the fallback, a sweep of PGS, divides by the diagonal: without a good diagonal there is no fallback.
    const bool can_sweep = find_divisors(task.problem, task.options.regularisation, false, s.divisors).good();
    if (reached(task, 0)) return finish(task, Status::converged, no_row, 0);
    for (std::size_t i = 0; i < n; ++i) s.best[i] = task.x[i];
    T best_square = Numbers<T>::infinity;
    std::uint32_t since_best = 0, done = 0, row = no_row;
    Status status = Status::iteration_limit;
    for (; done < task.options.max_iterations && status == Status::iteration_limit; ++done) {
        const T square = squared_map(task, task.x, s.f);
        if (square < best_square) {
            best_square = square;
            since_best = 0;
            for (std::size_t i = 0; i < n; ++i) s.best[i] = task.x[i];
        } else if (++since_best > most_without_gain) {
            status = Status::stalled;
            break;
        }
        bool moved = false;
        std::uint32_t singular = no_row;
        for (const bool damped : {false, true}) {
            singular = find_step(task, s, damped);
            moved = singular == no_row && search_along(task, s, square);
            if (moved) break;
        }
        if (!moved) {
            if (!can_sweep) {
                status = singular != no_row ? Status::singular : Status::stalled;
                row = singular;
                break;
            }
            if (sweep(task.problem, {}, false, T(1), s.divisors, task.x) != no_row) {
                status = Status::stalled;
                break;
            }
        }
        if (reached(task, done + 1)) return finish(task, Status::converged, no_row, done + 1);
    }
    if (squared_map(task, task.x, s.f) > best_square)
        for (std::size_t i = 0; i < n; ++i) task.x[i] = s.best[i];
    return finish(task, status, row, done);
}

template Result<float> run_newton(Task<float>);
template Result<double> run_newton(Task<double>);

}  // namespace islet::lcp
