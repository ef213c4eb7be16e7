// The tableau of complementary pivoting: n variables, the basic ones, written in terms of the n + 1 others.
//
// The variables are x_i (number i), w_i (number n + i) and z (number 2 n), the parameter that makes up for w of the wrong sign.
#pragma once

#include "../lcp/task.hpp"

namespace islet::lcp {

template <class T>
struct Dictionary {
    std::uint32_t n;
    T* coefficients;          // n rows of n + 1: how much a basic variable moves as a nonbasic one does
    T* value;                 // of the basic variable of each row
    T* at;                    // of each x while it is nonbasic: the bound it stands at
    std::uint32_t* basic;     // the variable of each row
    std::uint32_t* nonbasic;  // the variable of each column
    std::uint32_t* place;     // of each variable: its row, or n + its column

    std::uint32_t z() const { return 2 * n; }
    T* row(std::uint32_t r) const { return coefficients + static_cast<std::size_t>(r) * (n + 1); }
    bool is_basic(std::uint32_t variable) const { return place[variable] < n; }
    std::uint32_t column_of(std::uint32_t variable) const { return place[variable] - n; }
};

/// Moves the variable of a column by so much, and all basic variables with it.
template <class T>
void move(const Dictionary<T>& d, std::uint32_t column, T by) {
    for (std::uint32_t r = 0; r < d.n; ++r) d.value[r] += d.row(r)[column] * by;
}

/// Exchanges the variable of a row with that of a column. The values are not touched but for that of the variable that comes in: `entering`.
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

/// How much later the variable of row r reaches its bound per unit of e^(k+1).
template <class T>
T delay(const Dictionary<T>& d, std::uint32_t r, T rate, std::uint32_t k) {
    const std::uint32_t w = d.n + k;
    const T owed = !d.is_basic(w) ? -d.row(r)[d.column_of(w)] : (d.basic[r] == w ? T(1) : T(0));
    return -owed / rate;
}

/// Decides between two rows whose variables reach their bounds at the same time, so that no set of basic variables comes twice. It chooses the row that would
/// be first if every q_k were raised by e^(k+1), for an e as small as you like. (The lexicographic rule of Dantzig, Orden, Wolfe 1955. A basic variable's part
/// of e^(k+1) need not be stored: it is minus its coefficient of w_k.) `rate_a` and `rate_b` are how fast the rows' variables move.
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

}  // namespace islet::lcp
