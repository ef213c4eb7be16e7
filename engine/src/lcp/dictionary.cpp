#include "../exact.hpp"

#include "../lcp/dictionary.hpp"

namespace islet::lcp {

template <class T>
void move(const Dictionary<T>& d, std::uint32_t column, T by) {
    for (std::uint32_t r = 0; r < d.n; ++r) d.value[r] += d.row(r)[column] * by;
}

template <class T>
void exchange(const Dictionary<T>& d, std::uint32_t row, std::uint32_t column, T entering) {
    T* const pivot_row = d.row(row);
    const T inverse = T(1) / pivot_row[column];
    // basic = p * entering + rest   becomes   entering = basic / p - rest / p
    for (std::uint32_t c = 0; c <= d.n; ++c) pivot_row[c] = c == column ? inverse : -pivot_row[c] * inverse;
    for (std::uint32_t r = 0; r < d.n; ++r) {
        T* const other = d.row(r);
        const T factor = other[column];
        if (r == row || factor == T(0)) continue;
        for (std::uint32_t c = 0; c <= d.n; ++c) other[c] = c == column ? factor * inverse : other[c] + factor * pivot_row[c];
    }
    const std::uint32_t in = d.nonbasic[column], out = d.basic[row];
    d.basic[row] = in;
    d.nonbasic[column] = out;
    d.place[in] = row;
    d.place[out] = d.n + column;
    d.value[row] = entering;
}

namespace {

/// How much later the variable of row r reaches its bound per unit of e^(k+1).
template <class T>
T delay(const Dictionary<T>& d, std::uint32_t r, T rate, std::uint32_t k) {
    const std::uint32_t w = d.n + k;
    const T owed = !d.is_basic(w) ? -d.row(r)[d.column_of(w)] : (d.basic[r] == w ? T(1) : T(0));
    return -owed / rate;
}

}  // namespace

template <class T>
bool comes_first(const Dictionary<T>& d, std::uint32_t a, T rate_a, std::uint32_t b, T rate_b) {
    for (std::uint32_t k = 0; k < d.n; ++k) {
        const T delay_a = delay(d, a, rate_a, k);
        const T delay_b = delay(d, b, rate_b, k);
        const T rounding = T(256) * Numbers<T>::epsilon * larger(magnitude(delay_a), magnitude(delay_b));
        if (delay_a < delay_b - rounding) return true;
        if (delay_b < delay_a - rounding) return false;
    }
    return a < b;
}

template void move(const Dictionary<float>&, std::uint32_t, float);
template void move(const Dictionary<double>&, std::uint32_t, double);
template void exchange(const Dictionary<float>&, std::uint32_t, std::uint32_t, float);
template void exchange(const Dictionary<double>&, std::uint32_t, std::uint32_t, double);
template bool comes_first(const Dictionary<float>&, std::uint32_t, float, std::uint32_t, float);
template bool comes_first(const Dictionary<double>&, std::uint32_t, double, std::uint32_t, double);

}  // namespace islet::lcp
