#include "reference.hpp"

#include <cstdint>

#include "measure.hpp"

namespace islet::lab {
namespace {

using lcp::Method;

constexpr std::uint32_t newton_steps = 200, lemke_pivots = 20'000, nncg_iterations = 20'000, pgs_sweeps = 100'000;
constexpr double unreachable = 1e-15;  // so that a method goes on for as long as it gets anywhere

class Search {
public:
    Search(const Problem& problem, bool dense) : problem_(problem), dense_(dense) {}

    /// Goes on from `from` by a method, and then by Newton if there is room for that. True if the search is over.
    bool attempt(Method method, std::uint32_t limit, std::vector<double> from, const std::string& how) {
        lcp::Options<double> options;
        options.method = method;
        options.max_iterations = limit;
        options.tolerance = unreachable;
        options.check_every = 16;
        run_solver(problem_, options, from);
        keep(from, how);
        if (dense_ && method != Method::newton && !best.exact()) {
            options.method = Method::newton;
            options.max_iterations = newton_steps;
            run_solver(problem_, options, from);
            keep(from, how + ", then newton");
        }
        return best.exact();
    }

    Reference best;

private:
    void keep(const std::vector<double>& x, const std::string& how) {
        const double residual = residual_of(problem_, x);
        if (best.x.empty() || residual < best.residual) best = {x, how, residual};
    }

    const Problem& problem_;
    bool dense_;
};

}  // namespace

Reference find_reference(const Problem& scaled, std::size_t dense_rows) {
    const bool dense = scaled.rows() <= dense_rows;
    const std::vector<double> zero(scaled.rows(), 0);
    Search search(scaled, dense);
    const bool found = (dense && (search.attempt(Method::newton, newton_steps, scaled.warm, "newton from the warm start") ||
                                  search.attempt(Method::newton, newton_steps, zero, "newton from zero") ||
                                  search.attempt(Method::lemke, lemke_pivots, zero, "lemke"))) ||
                       search.attempt(Method::nncg, nncg_iterations, scaled.warm, "nncg, at most 20000 iterations") ||
                       search.attempt(Method::pgs, pgs_sweeps, scaled.warm, "pgs, at most 100000 sweeps");
    static_cast<void>(found);
    return search.best;
}

double velocity_error(const Problem& scaled, const std::vector<double>& x, const Reference& reference) {
    std::vector<double> apart = x;
    for (std::size_t i = 0; i < x.size(); ++i) apart[i] -= reference.x[i];
    const double whole = energy_norm(scaled, reference.x);
    return energy_norm(scaled, apart) / (whole > 0 ? whole : 1);
}

}  // namespace islet::lab
