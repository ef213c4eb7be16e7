// Dense LU factorisation with row exchanges, for the free rows of newton, lemke and the blocks.
#pragma once

#include "../lcp/rows.hpp"

namespace islet::lcp {

template <class T>
void exchange_numbers(T& a, T& b) {
    const T kept = a;
    a = b;
    b = kept;
}

/// The row with the largest entry of column k, each in relation to its row.
template <class T>
std::uint32_t pivot_row(const T* a, std::size_t stride, std::uint32_t n, std::uint32_t k, const T* scales) {
    std::uint32_t best = k;
    for (std::uint32_t i = k + 1; i < n; ++i)
        if (magnitude(a[i * stride + k]) * scales[best] > magnitude(a[best * stride + k]) * scales[i]) best = i;
    return best;
}

/// Factors the n by n matrix a (rows `stride` apart) in place and turns b into the solution of a x = b. Rows are compared relative to their largest entries
/// (`scales`, n numbers of scratch), so that a row in other units does not count as small. Returns no_row if all went well, else the column whose pivot is lost
/// in rounding; a and b are then of no use.
template <class T>
std::uint32_t solve_linear(T* a, std::size_t stride, std::uint32_t n, T* b, T* scales) {
    for (std::uint32_t i = 0; i < n; ++i) {
        scales[i] = T(0);
        for (std::uint32_t j = 0; j < n; ++j) scales[i] = larger(scales[i], magnitude(a[i * stride + j]));
    }
    const T lost = Numbers<T>::epsilon * T(4) * static_cast<T>(n);
    for (std::uint32_t k = 0; k < n; ++k) {
        const std::uint32_t p = pivot_row(a, stride, n, k, scales);
        if (p != k) {
            for (std::uint32_t j = 0; j < n; ++j) exchange_numbers(a[p * stride + j], a[k * stride + j]);
            exchange_numbers(b[p], b[k]);
            exchange_numbers(scales[p], scales[k]);
        }
        const T pivot = a[k * stride + k];
        if (!(magnitude(pivot) > larger(lost * scales[k], Numbers<T>::smallest))) return k;
        for (std::uint32_t i = k + 1; i < n; ++i) {
            const T factor = a[i * stride + k] / pivot;
            if (factor == T(0)) continue;
            for (std::uint32_t j = k + 1; j < n; ++j) a[i * stride + j] -= factor * a[k * stride + j];
            b[i] -= factor * b[k];
        }
    }
    for (std::uint32_t k = n; k-- > 0;) {
        T sum = b[k];
        for (std::uint32_t j = k + 1; j < n; ++j) sum -= a[k * stride + j] * b[j];
        b[k] = sum / a[k * stride + k];
        if (!is_finite(b[k])) return k;
    }
    return no_row;
}

}  // namespace islet::lcp
