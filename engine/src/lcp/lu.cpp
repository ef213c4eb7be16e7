#include "../exact.hpp"

#include "../lcp/lu.hpp"

namespace islet::lcp {
namespace {

template <class T>
void exchange(T& a, T& b) {
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

}  // namespace

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
            for (std::uint32_t j = 0; j < n; ++j) exchange(a[p * stride + j], a[k * stride + j]);
            exchange(b[p], b[k]);
            exchange(scales[p], scales[k]);
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

template std::uint32_t solve_linear(float*, std::size_t, std::uint32_t, float*, float*);
template std::uint32_t solve_linear(double*, std::size_t, std::uint32_t, double*, double*);

}  // namespace islet::lcp
