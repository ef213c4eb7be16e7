#include "measure.hpp"

#include <time.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/statistics.hpp"

namespace islet::lab {
namespace {

constexpr std::uint32_t never = std::numeric_limits<std::uint32_t>::max();
constexpr std::size_t most_repeats = 51, least_repeats = 3;
constexpr std::uint32_t pivots_per_row = 10;  // where they are useful, lemke needs about one or two
constexpr double long_solve = 0.5;            // s: repeated no more, the clock's noise is nothing to it

struct TimedSolve {
    std::uint32_t iterations = 0;
    double seconds = 0;  // the median
    std::vector<double> x;
};

/// Of this thread on its processor: what others do meanwhile on the machine is not counted.
double thread_seconds() {
    timespec now = {};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

/// The solve alone: its memory is there before, and x is set to the start between two.
TimedSolve time_solve(const Problem& problem, const lcp::Options<double>& options, const std::vector<double>& start, double budget) {
    std::vector<std::byte> memory(lcp::workspace_bytes<double>(options.method, start.size()));
    std::vector<double> seconds;
    TimedSolve timed = {options.max_iterations, 0, start};
    double total = 0;
    do {
        timed.x = start;
        const double begin = thread_seconds();
        lcp::solve<double>(problem.view(), options, timed.x, memory);
        seconds.push_back(thread_seconds() - begin);
        total += seconds.back();
    } while (seconds.back() < long_solve && seconds.size() < most_repeats && (total < budget || seconds.size() < least_repeats));
    timed.seconds = tools::median(seconds);
    return timed;
}

/// The time after any iteration, from the solves that were timed: evenly between two of them.
class Clockwork {
public:
    void add(std::uint32_t iteration, double seconds) { known_.push_back({iteration, seconds}); }
    void close() {
        std::sort(known_.begin(), known_.end(), [](const Mark& a, const Mark& b) { return a.iteration < b.iteration; });
        // A solve with more iterations may by chance have been timed as shorter.
        for (std::size_t i = 1; i < known_.size(); ++i) known_[i].seconds = std::max(known_[i].seconds, known_[i - 1].seconds);
    }
    double at(std::uint32_t iteration) const {
        std::size_t next = 0;
        while (next < known_.size() && known_[next].iteration < iteration) ++next;
        if (next == known_.size()) return known_.back().seconds;
        if (next == 0 || known_[next].iteration == iteration) return known_[next].seconds;
        const Mark &a = known_[next - 1], &b = known_[next];
        return a.seconds + (b.seconds - a.seconds) * double(iteration - a.iteration) / double(b.iteration - a.iteration);
    }

private:
    struct Mark {
        std::uint32_t iteration;
        double seconds;
    };
    std::vector<Mark> known_;
};

/// Residuals after 0, 1, 2, ... iterations of a run that is not timed; for lemke after 0 and after all.
std::vector<HistoryPoint> follow(const Problem& problem, lcp::Options<double> options, const std::vector<double>& start, Measurement& m) {
    const bool silent = options.method == lcp::Method::lemke;
    std::vector<double> residuals(silent ? 0 : options.max_iterations, std::numeric_limits<double>::quiet_NaN());
    options.history = residuals;
    std::vector<double> x = start;
    const lcp::Result<double> result = run_solver(problem, options, x);
    m.status = result.status;
    m.iterations = result.iterations;
    m.residual = result.residuals.natural;
    std::vector<HistoryPoint> history = {{0, 0, residual_of(problem, start)}};
    if (silent && result.iterations > 0) history.push_back({result.iterations, 0, m.residual});
    if (!silent) {
        for (std::uint32_t k = 0; k < std::min<std::size_t>(result.iterations, residuals.size()); ++k) {
            if (std::isfinite(residuals[k])) history.push_back({k + 1, 0, residuals[k]});
        }
    }
    return history;
}

}  // namespace

lcp::Result<double> run_solver(const Problem& problem, const lcp::Options<double>& options, std::vector<double>& x) {
    std::vector<std::byte> memory(lcp::workspace_bytes<double>(options.method, x.size()));
    return lcp::solve<double>(problem.view(), options, x, memory);
}

Measurement measure(const Problem& scaled, const MethodInfo& method, bool warm, const Reference& reference, const MeasureOptions& o) {
    Measurement m;
    m.method = &method;
    m.warm = warm;
    if (method.dense && scaled.rows() > o.dense_rows) {
        m.left_out = "more than " + std::to_string(o.dense_rows) + " rows";
        return m;
    }
    m.omega = omega_of(method, scaled, o.psor_omega);
    lcp::Options<double> options;
    options.method = method.method;
    options.max_iterations = o.iterations;
    if (method.method == lcp::Method::lemke)
        options.max_iterations = std::min(o.iterations, pivots_per_row * static_cast<std::uint32_t>(scaled.rows()));
    options.tolerance = levels.back();
    if (m.omega) options.omega = *m.omega;
    if (method.method == lcp::Method::block_pgs) options.blocks = scaled.blocks;

    const std::vector<double> start = warm ? scaled.warm : std::vector<double>(scaled.rows(), 0);
    m.history = follow(scaled, options, start, m);

    // The same iterations again, with a clock and without measuring on the way. (Lemke's tolerance ends its rounds, and it measures nothing else.)
    options.check_every = never;
    if (method.method != lcp::Method::lemke) options.tolerance = 0;
    Clockwork clock;
    const auto timed = [&](std::uint32_t iterations) {
        options.max_iterations = iterations;
        TimedSolve solve = time_solve(scaled, options, start, o.timing_seconds);
        clock.add(iterations, solve.seconds);
        return solve;
    };
    timed(0);
    for (std::size_t level = 0; level < levels.size(); ++level) {
        const auto point =
            std::find_if(m.history.begin(), m.history.end(), [level](const HistoryPoint& p) { return p.residual <= levels[level]; });
        if (point == m.history.end()) continue;
        if (level > 0 && m.reached[level - 1] && m.reached[level - 1]->iterations == point->iteration) {
            m.reached[level] = m.reached[level - 1];
        } else if (point->iteration == 0) {
            m.reached[level] = {0, 0, velocity_error(scaled, start, reference)};
        } else {
            const TimedSolve solve = timed(point->iteration);
            m.reached[level] = {point->iteration, solve.seconds, velocity_error(scaled, solve.x, reference)};
        }
    }
    const TimedSolve whole = timed(m.iterations);
    m.velocity_error = velocity_error(scaled, whole.x, reference);
    clock.close();
    m.seconds = clock.at(m.iterations);
    for (HistoryPoint& point : m.history) point.seconds = clock.at(point.iteration);
    return m;
}

std::vector<HistoryPoint> thinned(const std::vector<HistoryPoint>& history) {
    std::vector<HistoryPoint> few;
    double next = 0;
    for (std::size_t i = 0; i < history.size(); ++i) {
        if (double(history[i].iteration) < next && i + 1 < history.size()) continue;
        few.push_back(history[i]);
        if (history[i].iteration >= 100) next = double(history[i].iteration) * std::pow(10.0, 0.01);
    }
    return few;
}

}  // namespace islet::lab
