// A row of a problem: its w, its entries, its bounds.
#pragma once

#include "../lcp/arithmetic.hpp"
#include "islet/lcp.hpp"

namespace islet::lcp {

template <class T>
std::uint32_t row_count(const Problem<T>& problem) {
    return static_cast<std::uint32_t>(problem.q.size());
}

/// The entries of a row in ascending columns. `columns` is null if the row has an entry in every column.
template <class T>
struct Row {
    const T* values;
    const std::uint32_t* columns;
    std::uint32_t count;

    std::uint32_t column(std::uint32_t k) const { return columns != nullptr ? columns[k] : k; }
};

template <class T>
Row<T> row_of(const Problem<T>& problem, std::uint32_t i) {
    if (!problem.dense.values.empty()) return {problem.dense.values.data() + i * problem.q.size(), nullptr, row_count(problem)};
    const std::uint32_t first = problem.sparse.row_starts[i];
    return {problem.sparse.values.data() + first, problem.sparse.columns.data() + first, problem.sparse.row_starts[i + 1] - first};
}

/// The sum of row_value if a part of it overflowed: computed on a smaller scale and enlarged at the end. It is infinite only if w_i is, and never NaN.
template <class T>
ISLET_NEVER_INLINE T overflowing_row_value(const Problem<T>& problem, std::uint32_t i, const T* x) {
    constexpr T s = Numbers<T>::shrink;
    const Row<T> row = row_of(problem, i);
    T sum = problem.q[i] * s * s;
    for (std::uint32_t k = 0; k < row.count; ++k) sum += (row.values[k] * s) * (x[row.column(k)] * s);
    return sum / s / s;
}

/// w_i = q_i + sum of M_ij x_j. The sum is never -0 (q_i + 0 is not, nor is any sum that begins with it). So the zeros that a dense matrix adds and a sparse
/// one leaves out change no bit. If x is finite, the sum is not NaN.
template <class T>
T row_value(const Problem<T>& problem, std::uint32_t i, const T* x) {
    const Row<T> row = row_of(problem, i);
    T sum = problem.q[i] + T(0);
    if (row.columns == nullptr) {
        for (std::uint32_t j = 0; j < row.count; ++j) sum += row.values[j] * x[j];
    } else {
        for (std::uint32_t k = 0; k < row.count; ++k) sum += row.values[k] * x[row.columns[k]];
    }
    return is_finite(sum) ? sum : overflowing_row_value(problem, i, x);
}

template <class T>
struct Bounds {
    T lo;
    T hi;
};

template <class T>
bool has_friction(const Problem<T>& problem, std::uint32_t i) {
    return !problem.friction.empty() && problem.friction[i] != no_row;
}

template <class T>
Bounds<T> bounds_of(const Problem<T>& problem, std::uint32_t i, const T* x) {
    if (has_friction(problem, i)) {
        const T limit = problem.hi[i] * larger(x[problem.friction[i]], T(0));
        return {-limit, limit};
    }
    return {problem.lo.empty() ? T(0) : problem.lo[i], problem.hi.empty() ? Numbers<T>::infinity : problem.hi[i]};
}

}  // namespace islet::lcp
