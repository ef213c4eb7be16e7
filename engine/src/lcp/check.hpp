// Checks the arguments. Nothing else in this folder checks them again.
#pragma once

#include "../lcp/rows.hpp"

namespace islet::lcp {

struct Verdict {
    Status status = Status::converged;  // converged: nothing wrong
    std::uint32_t row = no_row;

    bool good() const { return status == Status::converged; }
};

template <class T>
Verdict check_sizes(const Problem<T>& problem, span<const T> x) {
    const Verdict bad = {Status::bad_size, no_row};
    const std::size_t n = problem.q.size();
    const auto fits = [&](std::size_t size) { return size == 0 || size == n; };
    if (n > max_rows || x.size() != n || !fits(problem.lo.size()) || !fits(problem.hi.size()) || !fits(problem.friction.size())) return bad;
    if (n == 0) return {};
    const DenseMatrix<T>& dense = problem.dense;
    const SparseMatrix<T>& sparse = problem.sparse;
    const bool has_dense = !dense.values.empty();
    const bool has_sparse = !sparse.row_starts.empty() || !sparse.columns.empty() || !sparse.values.empty();
    if (has_dense == has_sparse) return bad;
    if (has_dense) return dense.values.size() / n == n && dense.values.size() % n == 0 ? Verdict{} : bad;
    return sparse.row_starts.size() == n + 1 && sparse.columns.size() == sparse.values.size() ? Verdict{} : bad;
}

template <class T>
Verdict check_sparsity(const SparseMatrix<T>& m, std::uint32_t n) {
    if (m.row_starts[0] != 0 || m.row_starts[n] != m.values.size()) return {Status::bad_matrix, m.row_starts[0] != 0 ? 0 : n - 1};
    for (std::uint32_t i = 0; i < n; ++i)
        if (m.row_starts[i] > m.row_starts[i + 1]) return {Status::bad_matrix, i};
    // The starts ascend to the number of values, so from here on every entry that they name exists.
    for (std::uint32_t i = 0; i < n; ++i) {
        for (std::uint32_t k = m.row_starts[i]; k < m.row_starts[i + 1]; ++k) {
            if (m.columns[k] >= n) return {Status::bad_matrix, i};
            if (k > m.row_starts[i] && m.columns[k] <= m.columns[k - 1]) return {Status::bad_matrix, i};
        }
    }
    return {};
}

template <class T>
Verdict check_bounds(const Problem<T>& problem, std::uint32_t i) {
    const std::uint32_t n = row_count(problem);
    if (has_friction(problem, i)) {
        const std::uint32_t j = problem.friction[i];
        if (j >= n || j == i || has_friction(problem, j)) return {Status::bad_index, i};
        if (problem.hi.empty() || !(problem.hi[i] >= T(0)) || !is_finite(problem.hi[i])) return {Status::bad_bounds, i};
        return {};
    }
    const T lo = problem.lo.empty() ? T(0) : problem.lo[i];
    const T hi = problem.hi.empty() ? Numbers<T>::infinity : problem.hi[i];
    if (!(lo <= hi) || lo == Numbers<T>::infinity || hi == -Numbers<T>::infinity) return {Status::bad_bounds, i};
    return {};
}

template <class T>
bool row_is_finite(const Problem<T>& problem, std::uint32_t i, const T* x) {
    if (!is_finite(problem.q[i]) || !is_finite(x[i])) return false;
    const Row<T> row = row_of(problem, i);
    for (std::uint32_t k = 0; k < row.count; ++k)
        if (!is_finite(row.values[k])) return false;
    return true;
}

inline bool takes_order(Method method) { return method == Method::pgs || method == Method::psor || method == Method::symmetric_pgs || method == Method::nncg; }

inline Verdict check_blocks(span<const std::uint32_t> blocks, std::size_t rows) {
    if (blocks.empty()) return {};
    if (blocks.size() > rows || blocks[0] != 0) return {Status::bad_blocks, 0};
    for (std::size_t b = 0; b < blocks.size(); ++b) {
        const std::size_t end = b + 1 < blocks.size() ? blocks[b + 1] : rows;
        if (end > rows || end <= blocks[b] || end - blocks[b] > max_block_rows) return {Status::bad_blocks, static_cast<std::uint32_t>(b)};
    }
    return {};
}

template <class T>
Verdict check(const Problem<T>& problem, span<const T> x) {
    if (const Verdict v = check_sizes(problem, x); !v.good()) return v;
    const std::uint32_t n = row_count(problem);
    if (n > 0 && problem.dense.values.empty())
        if (const Verdict v = check_sparsity(problem.sparse, n); !v.good()) return v;
    for (std::uint32_t i = 0; i < n; ++i) {
        if (!row_is_finite(problem, i, x.data())) return {Status::not_finite, i};
        if (const Verdict v = check_bounds(problem, i); !v.good()) return v;
    }
    return {};
}

template <class T>
Verdict check(const Options<T>& options, std::size_t rows) {
    if (!is_finite(options.tolerance) || !is_finite(options.omega) || !is_finite(options.regularisation)) return {Status::not_finite, no_row};
    if (options.method > Method::lemke || options.check_every == 0 || options.tolerance < T(0) || options.regularisation < T(0) ||
        !(options.omega > T(0) && options.omega < T(2)))
        return {Status::bad_option, no_row};
    if (!options.order.empty() && !takes_order(options.method)) return {Status::unsupported, no_row};
    if (!options.blocks.empty() && options.method != Method::block_pgs) return {Status::unsupported, no_row};
    for (std::size_t k = 0; k < options.order.size(); ++k)
        if (options.order[k] >= rows) return {Status::bad_index, k < no_row ? static_cast<std::uint32_t>(k) : no_row};
    return check_blocks(options.blocks, rows);
}

}  // namespace islet::lcp
