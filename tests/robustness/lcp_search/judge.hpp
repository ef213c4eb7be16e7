// Solves a problem and holds what came out against what lcp.hpp promises.
#pragma once

#include <cstddef>
#include <cstring>
#include <memory>
#include <span>
#include <string>

#include "problems.hpp"

namespace islet::lcp_search {

/// An array of exactly so many bytes of the heap, so that a sanitizer sees one read too far.
template <class T>
class Exactly {
public:
    explicit Exactly(std::vector<T> values) : values_(values.empty() ? nullptr : new T[values.size()]), size_(values.size()) {
        std::copy(values.begin(), values.end(), values_.get());
    }
    std::span<T> span() const { return {values_.get(), size_}; }
    operator std::span<const T>() const { return span(); }
    T& operator[](std::size_t i) const { return values_[i]; }
    std::size_t size() const { return size_; }

private:
    std::unique_ptr<T[]> values_;
    std::size_t size_;
};

template <class T>
bool same_bits(std::span<const T> a, std::span<const T> b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size_bytes()) == 0);
}

/// The arguments as solve takes them, damage done.
template <class T>
struct Arguments {
    Exactly<T> m, q, lo, hi, x, history;
    Exactly<std::uint32_t> starts, columns, friction, order, blocks;
    lcp::Options<T> options;
    std::size_t memory_bytes;

    static std::vector<T> values(const Case<T>& c, bool sparse) {
        std::vector<T> kept;
        for (std::size_t k = 0; k < c.m.size(); ++k)
            if (!sparse || c.present[k]) kept.push_back(c.m[k]);
        return kept;
    }
    static std::vector<std::uint32_t> row_starts(const Case<T>& c, bool sparse) {
        if (!sparse || c.n == 0) return {};
        std::vector<std::uint32_t> starts = {0};
        for (std::size_t i = 0; i < c.n; ++i)
            starts.push_back(starts.back() + static_cast<std::uint32_t>(std::count(&c.present[i * c.n], &c.present[i * c.n] + c.n, 1)));
        return starts;
    }
    static std::vector<std::uint32_t> column_numbers(const Case<T>& c, bool sparse) {
        std::vector<std::uint32_t> columns;
        for (std::size_t k = 0; k < c.m.size(); ++k)
            if (sparse && c.present[k]) columns.push_back(static_cast<std::uint32_t>(k % c.n));
        return columns;
    }

    Arguments(const Case<T>& c, bool sparse)
        : m(values(c, sparse)),
          q(c.q),
          lo(c.lo),
          hi(c.hi),
          x(shortened(c)),
          history(std::vector<T>(c.history, T(-7))),
          starts(row_starts(c, sparse)),
          columns(column_numbers(c, sparse)),
          friction(c.friction),
          order(c.order),
          blocks(c.blocks) {
        options.method = static_cast<lcp::Method>(c.method);
        options.max_iterations = c.max_iterations;
        options.tolerance = c.tolerance;
        options.omega = c.omega;
        options.regularisation = c.regularisation;
        options.check_every = c.check_every;
        options.order = order;
        options.blocks = blocks;
        options.history = history.span();
        memory_bytes = lcp::workspace_bytes<T>(options.method, c.n);
        is_wrong = damage(c);
    }
    lcp::Problem<T> problem() const {
        if (starts.size() > 0) return {.sparse = {starts, columns, m}, .q = q, .lo = lo, .hi = hi, .friction = friction};
        return {.dense = {m}, .q = q, .lo = lo, .hi = hi, .friction = friction};
    }

    bool is_wrong = false;  // the damage leaves arguments that must be refused

private:
    static std::vector<T> shortened(const Case<T>& c) {
        std::vector<T> x = c.x;
        if (c.damage == Damage::short_x && !x.empty()) x.pop_back();
        return x;
    }
    bool damage(const Case<T>& c) {
        constexpr T nan = std::numeric_limits<T>::quiet_NaN(), inf = std::numeric_limits<T>::infinity();
        const auto spoil = [&](const auto& array, auto value) {
            if (array.size() == 0) return false;
            array[c.where % array.size()] = value;
            return true;
        };
        switch (c.damage) {
        case Damage::none: return false;
        case Damage::not_a_number: {
            const T bad = c.where % 3 == 0 ? nan : c.where % 3 == 1 ? inf : -inf;
            return c.where % 2 == 0 ? spoil(m, bad) : c.where % 5 < 3 ? spoil(q, bad) : spoil(x, bad);
        }
        case Damage::short_x: return c.n > 0;
        case Damage::row_starts: spoil(starts, c.where * 4000003u); return false;  // it may have been that
        case Damage::columns: return spoil(columns, static_cast<std::uint32_t>(c.n) + c.where % 3 * 1000000007u);
        case Damage::bounds: return friction.size() == 0 && spoil(lo, c.where % 2 == 0 ? nan : inf);
        case Damage::friction: spoil(friction, c.where % 7); return false;
        case Damage::order: return spoil(order, static_cast<std::uint32_t>(c.n) + c.where % 3 * 1000000007u);
        case Damage::blocks: spoil(blocks, c.where % 9); return false;
        case Damage::option:
            if (c.where % 4 == 0) options.tolerance = -std::numeric_limits<T>::denorm_min();
            if (c.where % 4 == 1) options.omega = c.where % 8 == 1 ? T(2) : nan;
            if (c.where % 4 == 2) options.regularisation = inf;
            if (c.where % 4 == 3) options.check_every = 0;
            return true;
        case Damage::memory: --memory_bytes; return true;
        case Damage::method: options.method = static_cast<lcp::Method>(method_count + c.where % (256 - method_count)); return true;
        }
        return false;
    }
};

/// The natural residual of x in long double, and how far computing in T may be off.
struct Judged {
    long double natural = 0, rounding = 0;
};

template <class T>
Judged natural_of(const Case<T>& c, std::span<const T> x) {
    using Wide = long double;
    constexpr Wide epsilon = std::numeric_limits<T>::epsilon(), least = std::numeric_limits<T>::denorm_min();
    Judged worst;
    for (std::size_t i = 0; i < c.n; ++i) {
        Wide w = c.q[i], terms = std::fabs(w);
        for (std::size_t j = 0; j < c.n; ++j) {
            const Wide term = Wide(c.m[i * c.n + j]) * Wide(x[j]);
            w += term;
            terms += std::fabs(term);
        }
        Wide lo = c.lo.empty() ? 0 : Wide(c.lo[i]), hi = c.hi.empty() ? Wide(INFINITY) : Wide(c.hi[i]);
        if (!c.friction.empty() && c.friction[i] != lcp::no_row) {
            hi = Wide(c.hi[i]) * std::max(Wide(x[c.friction[i]]), Wide(0));
            if (hi > Wide(std::numeric_limits<T>::max())) hi = INFINITY;
            lo = -hi;
        }
        const Wide at = x[i];
        // Not x - clamp(x - w): a small w must not be lost beside a large x.
        const Wide natural = std::fabs(std::clamp(w, at - hi, at - lo));
        worst.natural = std::max(worst.natural, natural);
        worst.rounding = std::max(worst.rounding, (Wide(c.n) + 4) * (epsilon * (terms + std::fabs(at) + natural) + least));
    }
    return worst;
}

/// What is wrong with the answer to a problem, a word before the first colon saying which promise; empty if nothing is.
template <class T>
std::string finding(const Case<T>& c) {
    using lcp::Status;
    const Arguments<T> arguments(c, c.sparse);
    const Arguments<T> untouched(c, c.sparse);
    Exactly<std::byte> memory(std::vector<std::byte>(arguments.memory_bytes + 1, std::byte{0x5a}));
    const std::size_t shift = c.where % 2;  // the workspace need not be aligned
    const lcp::Result<T> r =
        lcp::solve<T>(arguments.problem(), arguments.options, arguments.x.span(), memory.span().subspan(shift, arguments.memory_bytes));
    const std::span<const T> x = arguments.x, before = untouched.x;
    const std::string told = std::string(" (") + lcp::describe(r.status) + ")";

    if (shift == 0 ? memory[memory.size() - 1] != std::byte{0x5a} : memory[0] != std::byte{0x5a})
        return "memory: written beside the workspace" + told;
    if (!same_bits<T>(arguments.m, untouched.m) || !same_bits<T>(arguments.q, untouched.q) || !same_bits<T>(arguments.lo, untouched.lo) ||
        !same_bits<T>(arguments.hi, untouched.hi))
        return "constant: the problem was written to" + told;
    if (r.status >= Status::bad_diagonal && !same_bits(x, before)) return "refused: x is not as it was" + told;
    if (arguments.is_wrong) return r.status > Status::bad_diagonal ? "" : "accepted: arguments that are wrong" + told;
    if (c.damage != Damage::none) return "";
    if (r.status > Status::bad_diagonal) return "unfounded: refuses what is sound" + told;
    for (const T value : x)
        if (!std::isfinite(value)) return "finite: x is not" + told;
    if (r.iterations > c.max_iterations) return "iterations: more than allowed" + told;

    const Judged own = natural_of(c, x);
    if (r.status == Status::converged && own.natural > c.tolerance + own.rounding) return "solved: it is not" + told;
    if (r.status < Status::ray && r.status != Status::converged && own.natural + own.rounding <= c.tolerance)
        return "unsolved: it is solved" + told;
    const long double most = std::numeric_limits<T>::max();
    const bool is_near =
        own.natural > most ? r.residuals.natural + own.rounding >= most : std::fabs(r.residuals.natural - own.natural) <= own.rounding;
    if (!is_near && own.natural + own.rounding <= most) return "residual: the natural one told is not that of x" + told;
    if (!(r.residuals.natural >= 0 && r.residuals.infeasibility >= 0 && r.residuals.complementarity >= 0))
        return "residual: a negative one or a NaN" + told;
    const lcp::Residuals<T> again = lcp::residuals<T>(arguments.problem(), x);
    if (again.natural != r.residuals.natural || again.infeasibility != r.residuals.infeasibility ||
        again.complementarity != r.residuals.complementarity)
        return "again: residuals() differs from what solve told" + told;

    const bool keeps_bounds = static_cast<lcp::Method>(c.method) != lcp::Method::newton;
    for (std::size_t i = 0; i < c.n && keeps_bounds; ++i) {
        if (!c.friction.empty() && c.friction[i] != lcp::no_row) continue;
        const T lo = c.lo.empty() ? T(0) : c.lo[i], hi = c.hi.empty() ? T(INFINITY) : c.hi[i];
        if (std::memcmp(&x[i], &before[i], sizeof(T)) != 0 && (x[i] < lo || x[i] > hi))
            return "bounds: a row that moved is outside its own" + told;
    }
    for (std::size_t k = 0; k < arguments.history.size(); ++k) {
        if (k >= r.iterations && arguments.history[k] != T(-7)) return "history: written beyond the iterations" + told;
        if (arguments.history[k] != arguments.history[k]) return "history: a NaN" + told;
    }

    // The other form of the matrix, and the function that has the sweeps alone, give the same bits.
    const Arguments<T> other(c, !c.sparse);
    Exactly<std::byte> room(std::vector<std::byte>(other.memory_bytes, std::byte{0}));
    const lcp::Result<T> o = lcp::solve<T>(other.problem(), other.options, other.x.span(), room.span());
    if (o.status != r.status || o.iterations != r.iterations || !same_bits<T>(other.x, x)) return "forms: dense and sparse differ" + told;
    if (c.method <= static_cast<std::uint32_t>(lcp::Method::red_black)) {
        const Arguments<T> swept(c, c.sparse);
        const lcp::Result<T> s = lcp::solve_by_sweeps<T>(swept.problem(), swept.options, swept.x.span(), room.span());
        if (s.status != r.status || !same_bits<T>(swept.x, x)) return "forms: solve_by_sweeps differs from solve" + told;
    }
    return "";
}

}  // namespace islet::lcp_search
