// One call of solve: its arguments, and how a method reports.
#pragma once

#include "../lcp/check.hpp"
#include "../lcp/residual.hpp"

namespace islet::lcp {

/// Hands out the caller's memory piece by piece, numbers first. workspace_bytes counts the pieces.
class Workspace {
public:
    Workspace() = default;
    explicit Workspace(span<std::byte> bytes) : next_(bytes.data()) {}

    template <class T>
    T* take(std::size_t count) {
        const std::size_t past = reinterpret_cast<std::uintptr_t>(next_) % alignof(T);
        if (past != 0) next_ += alignof(T) - past;
        T* const taken = reinterpret_cast<T*>(next_);
        next_ += count * sizeof(T);
        return taken;
    }

private:
    std::byte* next_ = nullptr;
};

template <class T>
struct Task {
    const Problem<T>& problem;
    const Options<T>& options;
    T* x;
    std::uint32_t rows;
    Workspace memory;

    std::size_t size() const { return rows; }
};

/// Whether x is good enough after so many iterations (0: before the first). Measures x where the options ask for it.
template <class T>
bool reached(const Task<T>& task, std::uint32_t iterations) {
    const Options<T>& o = task.options;
    const bool recorded = iterations > 0 && iterations <= o.history.size();
    if (!recorded && iterations % o.check_every != 0) return false;
    const T natural = natural_residual(task.problem, task.x);
    if (recorded) o.history[iterations - 1] = natural;
    return natural <= o.tolerance;
}

/// The report. Only this function decides whether the method converged: by the residual of the final x.
template <class T>
Result<T> finish(const Task<T>& task, Status status, std::uint32_t row, std::uint32_t iterations) {
    Result<T> result = {status, row, iterations, all_residuals(task.problem, task.x)};
    const bool good = result.residuals.natural <= task.options.tolerance;
    if (good && (status == Status::iteration_limit || status == Status::stalled || status == Status::diverged)) {
        result.status = Status::converged;
        result.row = no_row;
    }
    if (!good && status == Status::converged) result.status = Status::stalled;
    return result;
}

/// Checks the arguments; makes a task of them only if all are right.
template <class T>
Verdict check_all(const Problem<T>& problem, const Options<T>& options, span<T> x, span<std::byte> workspace) {
    if (const Verdict v = check(problem, span<const T>(x)); !v.good()) return v;
    if (const Verdict v = check(options, x.size()); !v.good()) return v;
    if (workspace.size() < workspace_bytes<T>(options.method, x.size())) return {Status::too_little_memory, no_row};
    return {};
}

template <class T>
Result<T> refuse(const Problem<T>& problem, span<T> x, Verdict verdict) {
    return {verdict.status, verdict.row, 0, residuals(problem, span<const T>(x))};
}

// The methods, a file each.
template <class T>
Result<T> run_sweeps(Task<T> task);
template <class T>
Result<T> run_blocks(Task<T> task);
template <class T>
Result<T> run_jacobi(Task<T> task);
template <class T>
Result<T> run_nncg(Task<T> task);
template <class T>
Result<T> run_newton(Task<T> task);
template <class T>
Result<T> run_lemke(Task<T> task);

}  // namespace islet::lcp
