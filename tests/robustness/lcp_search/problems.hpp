// Random problems for the matrix solvers, with numbers from the smallest denormal to the largest finite one, and arguments that are broken on purpose.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "islet/lcp.hpp"
#include "support/random.hpp"

namespace islet::lcp_search {

using test::Random;

inline constexpr std::uint32_t method_count = static_cast<std::uint32_t>(lcp::Method::lemke) + 1;

/// What is wrong with the arguments of a problem.
enum class Damage : std::uint8_t {
    none,
    not_a_number,
    short_x,
    row_starts,
    columns,
    bounds,
    friction,
    order,
    blocks,
    option,
    memory,
    method
};
inline constexpr std::uint32_t damage_count = static_cast<std::uint32_t>(Damage::method) + 1;

/// A problem and all that goes with it; the matrix is kept dense, and `present` says which entries a sparse one has.
template <class T>
struct Case {
    std::size_t n = 0;
    bool sparse = false;
    std::vector<T> m;
    std::vector<char> present;
    std::vector<T> q, lo, hi, x;
    std::vector<std::uint32_t> friction, order, blocks;
    std::uint32_t method = 0, max_iterations = 10, check_every = 1, history = 0;
    T tolerance = T(1e-5), omega = T(1), regularisation = T(0);
    Damage damage = Damage::none;
    std::uint32_t where = 0;  // what is damaged: taken modulo how many there are
};

/// Draws numbers of one character: those of one problem are alike, as they are in life, or of all kinds, as they are not.
template <class T>
class Numbers {
public:
    explicit Numbers(Random& random) : random_(random), kind_(random.below(5)), span_(random.below(40) + 1) {}

    T any() {
        switch (kind_ == 4 ? random_.below(4) : kind_) {
        case 0: return T(random_.between(-1, 1));
        case 1: return whole_range();
        case 2: return corner();
        default: return T(random_.between(-1, 1)) * std::pow(T(10), T(random_.between(-float(span_), float(span_))));
        }
    }
    /// A finite one.
    T number() {
        const T value = any();
        return std::isfinite(value) ? value : T(1);
    }

private:
    using Limits = std::numeric_limits<T>;

    T whole_range() {
        const int exponent = Limits::min_exponent - Limits::digits +
                             static_cast<int>(random_.below(Limits::max_exponent - Limits::min_exponent + Limits::digits));
        return std::ldexp(T(random_.between(0.5f, 1)) * T(random_.one_in(2) ? 1 : -1), exponent);
    }
    T corner() {
        const T corners[] = {T(0),
                             -T(0),
                             T(1),
                             T(2),
                             T(0.5),
                             T(1) + Limits::epsilon(),
                             Limits::denorm_min(),
                             Limits::min(),
                             Limits::epsilon(),
                             Limits::max(),
                             Limits::max() / 2,
                             Limits::max() * Limits::epsilon(),
                             1 / Limits::epsilon(),
                             std::sqrt(Limits::max()),
                             std::sqrt(Limits::min())};
        return corners[random_.below(std::size(corners))] * T(random_.one_in(2) ? 1 : -1);
    }

    Random& random_;
    std::uint32_t kind_;
    std::uint32_t span_;
};

template <class T>
void draw_matrix(Case<T>& c, Random& random, Numbers<T>& numbers) {
    const std::size_t n = c.n;
    c.m.resize(n * n);
    c.present.assign(n * n, 1);
    for (T& v : c.m) v = numbers.number();
    const std::uint32_t kind = random.below(6);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < i && kind != 0; ++j) c.m[i * n + j] = c.m[j * n + i];  // symmetric
        if (kind >= 2) c.m[i * n + i] = std::fabs(c.m[i * n + i]);
    }
    if (kind == 3 && n > 1) {  // a row twice: singular
        for (std::size_t j = 0; j < n; ++j) c.m[n + j] = c.m[j];
        for (std::size_t i = 0; i < n; ++i) c.m[i * n + 1] = c.m[i * n];
    }
    if (kind == 4) {  // the diagonal outweighs the rest
        for (std::size_t i = 0; i < n; ++i) {
            T sum = 0;
            for (std::size_t j = 0; j < n; ++j) sum += std::fabs(c.m[i * n + j]);
            if (std::isfinite(sum)) c.m[i * n + i] = sum;
        }
    }
    if (kind == 5) {  // a Gram matrix
        const std::vector<T> a = c.m;
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < n; ++j) {
                T sum = 0;
                for (std::size_t k = 0; k < n; ++k) sum += a[i * n + k] * a[j * n + k];
                c.m[i * n + j] = std::isfinite(sum) ? sum : T(1);
            }
    }
    c.sparse = random.one_in(2);
    if (!random.one_in(3)) return;
    const std::uint32_t one_in = 2 + random.below(3);
    for (std::size_t k = 0; k < n * n; ++k)
        if (random.one_in(one_in) && (k % (n + 1) != 0 || random.one_in(8))) c.m[k] = 0, c.present[k] = random.one_in(4);
}

template <class T>
void draw_bounds(Case<T>& c, Random& random, Numbers<T>& numbers) {
    constexpr T inf = std::numeric_limits<T>::infinity(), largest = std::numeric_limits<T>::max();
    if (!random.one_in(4)) {
        for (std::size_t i = 0; i < c.n; ++i) {
            T lo = numbers.number(), hi = numbers.number();
            if (lo > hi) std::swap(lo, hi);
            switch (random.below(9)) {
            case 0: lo = -inf; break;
            case 1: hi = inf; break;
            case 2: lo = -inf, hi = inf; break;
            case 3: hi = lo; break;
            case 4: lo = -largest; break;
            case 5: hi = largest; break;
            case 6: lo = hi = random.one_in(2) ? largest : -largest; break;
            default: break;
            }
            c.lo.push_back(lo), c.hi.push_back(hi);
        }
        if (random.one_in(8)) c.hi.clear(), std::fill(c.lo.begin(), c.lo.end(), T(0));
    }
    if (c.n > 1 && !c.hi.empty() && random.one_in(2)) {
        c.friction.assign(c.n, lcp::no_row);
        for (std::size_t i = 0; i < c.n; ++i) {
            if (!random.one_in(3)) continue;
            const std::uint32_t j = random.below(static_cast<std::uint32_t>(c.n));
            const bool is_named = std::find(c.friction.begin(), c.friction.end(), i) != c.friction.end();
            if (j == i || c.friction[j] != lcp::no_row || is_named) continue;
            c.friction[i] = j;
            c.hi[i] = std::fabs(numbers.number());
        }
    }
}

template <class T>
void draw_options(Case<T>& c, Random& random, Numbers<T>& numbers) {
    using lcp::Method;
    c.method = random.below(method_count);
    const Method method = static_cast<Method>(c.method);
    const std::uint32_t n = static_cast<std::uint32_t>(c.n);
    c.max_iterations = random.one_in(30) ? 0 : 1 + random.below(random.one_in(20) ? 400 : 30);
    const T tolerances[] = {T(0), T(1e-5), T(1e-2), std::fabs(numbers.number())};
    c.tolerance = tolerances[random.below(4)];
    if (random.one_in(2)) c.omega = T(random.between(0.01f, 1.99f));
    if (random.one_in(2)) c.regularisation = random.one_in(2) ? T(random.between(0, 1)) : std::fabs(numbers.number());
    if (random.one_in(3)) c.check_every = 1 + random.below(5);
    c.history = random.one_in(3) ? random.below(40) : 0;
    const bool takes_order = method == Method::pgs || method == Method::psor || method == Method::symmetric_pgs || method == Method::nncg;
    if (takes_order && n > 0 && random.one_in(3))
        for (std::uint32_t k = random.below(2 * n + 1); k > 0; --k) c.order.push_back(random.below(n));
    if (method == Method::block_pgs && n > 0 && !random.one_in(4))
        for (std::uint32_t first = 0; first < n; first += 1 + random.below(lcp::max_block_rows)) c.blocks.push_back(first);
}

template <class T>
Case<T> draw_case(std::uint64_t seed) {
    Random random(seed * 0x9e3779b97f4a7c15ull + (sizeof(T) == sizeof(float) ? 1 : 2));
    Numbers<T> numbers(random);
    Case<T> c;
    c.n = random.one_in(50) ? random.below(30) : 1 + random.below(7);
    draw_matrix(c, random, numbers);
    for (std::size_t i = 0; i < c.n; ++i) c.q.push_back(numbers.number());
    draw_bounds(c, random, numbers);
    const std::uint32_t start = random.below(3);
    for (std::size_t i = 0; i < c.n; ++i) c.x.push_back(start == 0 ? T(0) : start == 1 ? T(random.between(-1, 1)) : numbers.number());
    draw_options(c, random, numbers);
    if (random.one_in(10)) c.damage = static_cast<Damage>(random.below(damage_count));
    c.where = random.below(1000);
    return c;
}

}  // namespace islet::lcp_search
