// Lemke's method for rows with two bounds.
//
// Every x starts at a bound. A variable z makes up for wrong signs of w: rows at their lower bound have w_i + z, rows at their upper bound w_i - z, and z is
// the smallest number that makes all signs right. Then z is brought to 0 along the only path there is. A variable comes in and moves; the first variable that
// thereby reaches a bound stops it and goes out. The next variable to come in is the partner of the one that went out, because either x_i is inside its bounds
// or w_i is not 0, never both. An x that reaches its other bound stops itself. If nothing stops the variable that came in, the path is a ray; if M is positive
// semi-definite, there is then no solution.
//
// Sources: Lemke 1965; Cottle, Pang, Stone: The Linear Complementarity Problem (1992), chapter 4; upper bounds
// as in the simplex method with bounded variables. Rows without bounds are made basic first. At the end the free rows are solved once more from the given
// numbers, which removes the rounding that the pivots have accumulated.
#include "../exact.hpp"

#include "../lcp/dictionary.hpp"
#include "../lcp/lu.hpp"

namespace islet::lcp {
namespace {

enum class Kind : std::uint32_t { at_lo, at_hi, fixed, unbounded };  // a row while its x is nonbasic; fixed: lo = hi; the last two are never at odds

constexpr std::uint32_t most_friction_rounds = 200;

/// A coefficient that is smaller than this, relative to the largest of its column, is rounding and stops nothing.
template <class T>
constexpr T negligible = sizeof(T) == sizeof(float) ? T(2e-6) : T(1e-12);

template <class T>
struct Lemke {
    Dictionary<T> d;
    T* lo;
    T* hi;
    std::uint32_t* kind;
    std::uint32_t pivots = 0;

    Kind kind_of(std::uint32_t i) const { return static_cast<Kind>(kind[i]); }
    void set(std::uint32_t i, Kind k) const { kind[i] = static_cast<std::uint32_t>(k); }
};

/// Starts the dictionary: x at its bounds, z = 0, and w in terms of these.
template <class T>
void fill(const Task<T>& task, const Lemke<T>& s) {
    const Dictionary<T>& d = s.d;
    const std::uint32_t n = task.rows;
    for (std::uint32_t i = 0; i < n; ++i) {
        const bool below = is_finite(s.lo[i]), above = is_finite(s.hi[i]);
        s.set(i, !below && !above ? Kind::unbounded : (s.lo[i] == s.hi[i] ? Kind::fixed : (below ? Kind::at_lo : Kind::at_hi)));
        d.at[i] = below ? s.lo[i] : (above ? s.hi[i] : T(0));
    }
    for (std::uint32_t i = 0; i < n; ++i) {
        T* const to = d.row(i);
        for (std::uint32_t c = 0; c < n; ++c) to[c] = T(0);
        const Row<T> row = row_of(task.problem, i);
        for (std::uint32_t k = 0; k < row.count; ++k) to[row.column(k)] = row.values[k];
        to[n] = s.kind_of(i) == Kind::at_lo ? T(1) : (s.kind_of(i) == Kind::at_hi ? T(-1) : T(0));
        d.value[i] = row_value(task.problem, i, d.at);
        d.basic[i] = n + i;
        d.nonbasic[i] = i;
        d.place[n + i] = i;
        d.place[i] = n + i;
    }
    d.nonbasic[n] = d.z();
    d.place[d.z()] = n + n;
}

/// Brings the rows without bounds to w = 0. Returns a row where that cannot be done, or no_row.
template <class T>
std::uint32_t settle_unbounded(const Task<T>& task, Lemke<T>& s) {
    const Dictionary<T>& d = s.d;
    T largest = T(0);
    for (std::uint32_t i = 0; i < d.n; ++i)
        for (std::uint32_t c = 0; c < d.n; ++c) largest = larger(largest, magnitude(d.row(i)[c]));
    for (std::uint32_t step = 0; step < d.n; ++step) {
        // Any w of such rows may leave for any x of such rows, so the largest pivot is taken.
        std::uint32_t row = no_row, column = no_row, left = no_row;
        T most = negligible<T> * largest;
        for (std::uint32_t r = 0; r < d.n; ++r) {
            if (d.basic[r] < d.n || d.basic[r] == d.z() || s.kind_of(d.basic[r] - d.n) != Kind::unbounded) continue;
            left = d.basic[r] - d.n;
            for (std::uint32_t c = 0; c < d.n; ++c) {
                if (d.nonbasic[c] >= d.n || s.kind_of(d.nonbasic[c]) != Kind::unbounded || magnitude(d.row(r)[c]) <= most) continue;
                most = magnitude(d.row(r)[c]);
                row = r;
                column = c;
            }
        }
        if (left == no_row) return no_row;
        if (row == no_row || s.pivots == task.options.max_iterations) return left;
        const T by = -d.value[row] / d.row(row)[column];
        const T entering = d.at[d.nonbasic[column]] + by;
        move(d, column, by);
        exchange(d, row, column, entering);
        ++s.pivots;
    }
    return no_row;
}

/// The row that needs the largest z; no_row if none needs any. Of equal rows, the one that would need it if every q_k were raised by e^(k+1).
template <class T>
std::uint32_t worst_row(const Lemke<T>& s, T& needed) {
    std::uint32_t worst = no_row;
    needed = T(0);
    for (std::uint32_t r = 0; r < s.d.n; ++r) {
        if (s.d.basic[r] < s.d.n) continue;
        const Kind kind = s.kind_of(s.d.basic[r] - s.d.n);
        if (kind != Kind::at_lo && kind != Kind::at_hi) continue;
        const T need = kind == Kind::at_lo ? -s.d.value[r] : s.d.value[r];
        const bool tie = need == needed && worst != no_row;
        const bool worst_at_hi = worst != no_row && s.kind_of(s.d.basic[worst] - s.d.n) == Kind::at_hi;
        if (need > needed || (tie && kind == Kind::at_lo && !worst_at_hi) || (tie && kind == Kind::at_hi && !worst_at_hi)) {
            needed = need;
            worst = r;
        }
    }
    return worst;
}

/// How far the variable of a row is from the bound that it moves to; infinity if there is none.
template <class T>
T room(const Lemke<T>& s, std::uint32_t r, T rate) {
    const std::uint32_t variable = s.d.basic[r];
    const T value = s.d.value[r];
    T left = Numbers<T>::infinity;
    if (variable == s.d.z()) {
        if (rate < T(0)) left = value;
    } else if (variable < s.d.n) {
        left = rate < T(0) ? value - s.lo[variable] : s.hi[variable] - value;
    } else {
        const Kind kind = s.kind_of(variable - s.d.n);
        if (kind == Kind::at_lo && rate < T(0)) left = value;
        if (kind == Kind::at_hi && rate > T(0)) left = -value;
    }
    return larger(left, T(0));
}

/// What stops the variable of a column.
template <class T>
struct Stop {
    T after = Numbers<T>::infinity;  // how far the variable moves until then
    std::uint32_t row = no_row;      // the row whose variable stops it; no_row: its own other bound, or nothing
};

template <class T>
Stop<T> find_stop(const Lemke<T>& s, std::uint32_t column, T direction, T own_room) {
    const Dictionary<T>& d = s.d;
    T largest = T(0);
    for (std::uint32_t r = 0; r < d.n; ++r) largest = larger(largest, magnitude(d.row(r)[column]));
    const T least_rate = negligible<T> * largest;
    Stop<T> stop = {own_room, no_row};
    for (std::uint32_t r = 0; r < d.n; ++r) {
        const T rate = d.row(r)[column] * direction;
        if (magnitude(rate) <= least_rate) continue;
        const T after = room(s, r, rate) / magnitude(rate);
        if (!is_finite(after)) continue;
        const T rounding = T(64) * Numbers<T>::epsilon * after;
        bool first = after < stop.after - rounding;
        if (!first && after <= stop.after + rounding) {
            // If several stop it at the same time, z comes first, because it ends the search; then rows, by the rule that prevents cycles; its own bound is
            // last.
            const bool z_waits = stop.row != no_row && d.basic[stop.row] == d.z();
            first = d.basic[r] == d.z() || stop.row == no_row || (!z_waits && comes_first(d, r, rate, stop.row, d.row(stop.row)[column] * direction));
        }
        if (first) stop = {after, r};
    }
    return stop;
}

/// Puts variables that rounding has moved off their bounds back to them, so that ties are recognised.
template <class T>
void snap(const Lemke<T>& s) {
    const Dictionary<T>& d = s.d;
    T largest = T(0);
    for (std::uint32_t r = 0; r < d.n; ++r) largest = larger(largest, magnitude(d.value[r]));
    const T rounding = T(16) * Numbers<T>::epsilon * largest;
    for (std::uint32_t r = 0; r < d.n; ++r) {
        const std::uint32_t v = d.basic[r];
        if (v < d.n && magnitude(d.value[r] - s.lo[v]) <= rounding) d.value[r] = s.lo[v];
        if (v < d.n && magnitude(d.value[r] - s.hi[v]) <= rounding) d.value[r] = s.hi[v];
        if (v >= d.n && magnitude(d.value[r]) <= rounding) d.value[r] = T(0);
    }
}

/// Follows the path until z is 0.
template <class T>
Status follow(const Task<T>& task, Lemke<T>& s) {
    const Dictionary<T>& d = s.d;
    T needed;
    const std::uint32_t first = worst_row(s, needed);
    if (first == no_row) return Status::converged;
    if (s.pivots == task.options.max_iterations) return Status::iteration_limit;
    std::uint32_t entering = d.basic[first] - d.n;
    move(d, d.n, needed);
    exchange(d, first, d.n, needed);
    for (++s.pivots; s.pivots < task.options.max_iterations; ++s.pivots) {
        snap(s);
        // A variable comes in from its bound: x_i inwards, w_i to the side that is right at the bound that x_i has reached.
        const std::uint32_t i = entering < d.n ? entering : entering - d.n;
        const std::uint32_t column = d.column_of(entering);
        const T direction = s.kind_of(i) == Kind::at_lo ? T(1) : T(-1);
        const Stop<T> stop = find_stop(s, column, direction, entering < d.n ? s.hi[i] - s.lo[i] : Numbers<T>::infinity);
        if (!is_finite(stop.after)) return Status::ray;
        move(d, column, direction * stop.after);
        if (stop.row == no_row) {
            const bool went_up = direction > T(0);
            d.at[i] = went_up ? s.hi[i] : s.lo[i];
            s.set(i, went_up ? Kind::at_hi : Kind::at_lo);
            entering = d.n + i;
            continue;
        }
        const std::uint32_t leaving = d.basic[stop.row];
        const T rate = d.row(stop.row)[column] * direction;
        exchange(d, stop.row, column, (entering < d.n ? d.at[i] : T(0)) + direction * stop.after);
        if (leaving == d.z()) {
            ++s.pivots;
            return Status::converged;
        }
        if (leaving < d.n) {
            d.at[leaving] = rate < T(0) ? s.lo[leaving] : s.hi[leaving];
            s.set(leaving, rate < T(0) ? Kind::at_lo : Kind::at_hi);
            entering = d.n + leaving;
        } else {
            entering = leaving - d.n;
        }
    }
    return Status::iteration_limit;
}

/// Writes the dictionary's values to x.
template <class T>
void read_off(const Task<T>& task, const Lemke<T>& s) {
    for (std::uint32_t i = 0; i < task.rows; ++i) {
        const T found = s.d.is_basic(i) ? s.d.value[s.d.place[i]] : s.d.at[i];
        if (is_finite(found)) task.x[i] = clamp(found, s.lo[i], s.hi[i]);
    }
}

/// Solves the free rows again from the problem's own numbers, and keeps the result if it is better. Overwrites the dictionary.
template <class T>
void refine(const Task<T>& task, const Lemke<T>& s) {
    std::uint32_t* const rows = s.d.nonbasic;
    std::uint32_t m = 0;
    for (std::uint32_t i = 0; i < task.rows; ++i)
        if (s.d.is_basic(i)) rows[m++] = i;
    std::uint32_t* const index = s.d.place;
    for (std::uint32_t i = 0; i < task.rows; ++i) index[i] = no_row;
    for (std::uint32_t k = 0; k < m; ++k) index[rows[k]] = k;
    T* const a = s.d.coefficients;
    T* const rhs = s.d.value;
    for (std::size_t k = 0; k < m; ++k) {
        for (std::size_t l = 0; l < m; ++l) a[k * m + l] = T(0);
        const Row<T> row = row_of(task.problem, rows[k]);
        for (std::uint32_t e = 0; e < row.count; ++e)
            if (index[row.column(e)] != no_row) a[k * m + index[row.column(e)]] = row.values[e];
        // Solves for a correction of x, which is right but for rounding, so that large values cost no digits.
        rhs[k] = -row_value(task.problem, rows[k], task.x);
    }
    T* const kept = s.d.at;
    if (solve_linear(a, m, m, rhs, kept) != no_row) return;
    const T before = natural_residual(task.problem, task.x);
    for (std::uint32_t k = 0; k < m; ++k) {
        const std::uint32_t i = rows[k];
        kept[i] = task.x[i];
        const T corrected = clamp(task.x[i] + rhs[k], s.lo[i], s.hi[i]);
        if (is_finite(corrected)) task.x[i] = corrected;
    }
    if (natural_residual(task.problem, task.x) <= before) return;
    for (std::uint32_t k = 0; k < m; ++k) task.x[rows[k]] = kept[rows[k]];
}

}  // namespace

template <class T>
Result<T> run_lemke(Task<T> task) {
    const std::size_t n = task.size();
    if (natural_residual(task.problem, task.x) <= T(0)) return finish(task, Status::converged, no_row, 0);
    Lemke<T> s = {};
    s.d.n = task.rows;
    s.d.coefficients = task.memory.template take<T>(n * (n + 1));
    for (T** array : {&s.d.value, &s.d.at, &s.lo, &s.hi}) *array = task.memory.template take<T>(n);
    s.d.basic = task.memory.template take<std::uint32_t>(n);
    s.d.nonbasic = task.memory.template take<std::uint32_t>(n + 1);
    s.d.place = task.memory.template take<std::uint32_t>(2 * n + 1);
    s.kind = task.memory.template take<std::uint32_t>(n);

    // With friction, the bounds are frozen and the problem solved, again and again until the bounds no longer change.
    const std::uint32_t rounds = task.problem.friction.empty() ? 1 : most_friction_rounds;
    Status status = Status::stalled;
    for (std::uint32_t round = 0; round < rounds; ++round) {
        for (std::uint32_t i = 0; i < task.rows; ++i) {
            const Bounds<T> b = bounds_of(task.problem, i, task.x);
            s.lo[i] = b.lo;
            s.hi[i] = b.hi;
        }
        fill(task, s);
        const std::uint32_t singular = settle_unbounded(task, s);
        if (singular != no_row) return finish(task, s.pivots == task.options.max_iterations ? Status::iteration_limit : Status::singular, singular, s.pivots);
        status = follow(task, s);
        if (status != Status::converged) return finish(task, status, no_row, s.pivots);
        read_off(task, s);
        refine(task, s);
        if (natural_residual(task.problem, task.x) <= task.options.tolerance) break;
        status = rounds > 1 ? Status::iteration_limit : Status::stalled;
    }
    return finish(task, status, no_row, s.pivots);
}

template Result<float> run_lemke(Task<float>);
template Result<double> run_lemke(Task<double>);

}  // namespace islet::lcp
