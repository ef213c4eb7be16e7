// The matrix solvers: on the world's own islands, and on small problems of any numbers, many of which are none.
#include <limits>

#include "islet/island.hpp"
#include "player.hpp"

namespace islet::fuzz {

namespace {

constexpr std::uint32_t most_rows = 6;

/// Refused problems leave x as it was; others leave it finite; and what is called a solution is one.
template <class T>
void expect_sound(const lcp::Problem<T>& problem, const lcp::Options<T>& options, const lcp::Result<T>& result, std::span<const T> before, std::span<const T> x) {
    const bool refused = result.status >= lcp::Status::bad_diagonal;
    for (std::size_t i = 0; i < x.size() && i < before.size(); ++i) {
        const bool same = x[i] == before[i] || (x[i] != x[i] && before[i] != before[i]);
        if (refused) expect(same, "a refused problem changed x");
        else expect(x[i] - x[i] == 0, "a matrix solver left what is not finite");
    }
    if (result.status == lcp::Status::converged) {
        expect(result.residuals.natural <= options.tolerance, "converged, farther from a solution than was asked for");
        expect(lcp::residuals<T>(problem, x).natural == result.residuals.natural, "the residual told is not that of x");
    }
}

template <class T>
void solve_small(Reader& in) {
    const std::uint32_t n = in.below(most_rows + 1);
    T matrix[most_rows * most_rows] = {}, q[most_rows], lo[most_rows], hi[most_rows], x[most_rows], start[most_rows], history[4];
    std::uint32_t row_starts[most_rows + 1] = {}, columns[most_rows * most_rows] = {}, friction[most_rows], order[most_rows], blocks[most_rows];

    // Symmetric and strong on its diagonal, so that most have a solution; unless bytes say otherwise.
    const std::uint32_t kind = in.byte();
    for (std::uint32_t r = 0; r < n; ++r) {
        for (std::uint32_t c = 0; c <= r; ++c) matrix[r * n + c] = matrix[c * n + r] = T(in.number()) / T(16) + (r == c ? T(16) : T(0));
        if ((kind & 1) != 0 && r > 0) matrix[r] = T(in.number());
    }
    for (std::uint32_t i = 0; i < n; ++i) {
        q[i] = T(in.number());
        lo[i] = (kind & 2) != 0 ? T(in.number()) : T(0);
        hi[i] = (kind & 2) != 0 ? lo[i] + T(in.size()) : std::numeric_limits<T>::infinity();
        x[i] = start[i] = (kind & 4) != 0 ? T(in.number()) : T(0);
        friction[i] = (kind & 8) != 0 && in.below(3) == 0 ? in.below(most_rows + 1) : lcp::no_row;
        if (friction[i] != lcp::no_row) lo[i] = T(0), hi[i] = T(in.size());
        order[i] = (kind & 16) != 0 ? in.below(most_rows) : i;
        blocks[i] = (kind & 32) != 0 ? in.below(most_rows) : i;
    }

    lcp::Problem<T> p;
    p.q = {q, n};
    if ((kind & 2) != 0 || in.flag()) p.lo = {lo, n}, p.hi = {hi, n};
    if ((kind & 8) != 0) p.friction = {friction, n};
    if ((kind & 64) != 0) {
        std::uint32_t entries = 0;
        T* const values = matrix;  // rows without their zeros, in place
        for (std::uint32_t r = 0; r < n; ++r) {
            for (std::uint32_t c = 0; c < n; ++c) {
                if (matrix[r * n + c] == T(0)) continue;
                columns[entries] = c;
                values[entries++] = matrix[r * n + c];
            }
            row_starts[r + 1] = entries;
        }
        if ((kind & 128) != 0 && entries > 0) columns[in.byte() % entries] = in.byte(), row_starts[in.byte() % (n + 1)] = in.byte();
        p.sparse = {{row_starts, n + 1}, {columns, entries}, {values, entries}};
    } else {
        p.dense = {{matrix, (kind & 128) != 0 ? in.below(most_rows * most_rows) : n * n}};
    }

    lcp::Options<T> o;
    o.method = static_cast<lcp::Method>(in.below(11));
    o.max_iterations = in.byte();
    const std::uint32_t more = in.byte();
    if ((more & 1) != 0) o.omega = T(in.size()) / T(2);
    if ((more & 2) != 0) o.regularisation = T(in.number());
    if ((more & 4) != 0) o.tolerance = T(in.size());
    if ((more & 8) != 0) o.check_every = in.below(4);
    if ((more & 16) != 0) o.order = {order, n};
    if ((more & 32) != 0) o.blocks = {blocks, n};
    if ((more & 64) != 0) o.history = {history, in.below(5)};

    alignas(16) std::byte memory[lcp::workspace_bytes<T>(lcp::Method::lemke, most_rows) + lcp::workspace_bytes<T>(lcp::Method::newton, most_rows)];
    const std::span<std::byte> workspace = (more & 128) != 0 ? std::span<std::byte>(memory + 1, in.byte()) : std::span<std::byte>(memory);
    const std::span<T> unknowns = {x, n};
    const bool by_sweeps = in.below(4) == 0;
    const lcp::Result<T> result = by_sweeps ? lcp::solve_by_sweeps<T>(p, o, unknowns, workspace) : lcp::solve<T>(p, o, unknowns, workspace);
    expect_sound<T>(p, o, result, {start, n}, unknowns);
    expect(lcp::describe(result.status) != nullptr, "a status without words");
}

}  // namespace

void Player::solve_matrix() {
    if (in.flag()) solve_small<float>(in);
    else solve_small<double>(in);
}

void Player::solve_island(BodyId b) {
    IslandProblem problem;
    const float h = in.size();
    const std::span<std::byte> memory = {f.island.data(), in.below(4) != 0 ? f.island.size() : in.byte()};
    const std::size_t bytes = w.export_island(b, h, memory, problem);
    if (bytes == 0 || bytes > memory.size()) {
        expect(problem.rows.empty() && problem.bodies.empty(), "an island that was not written has rows");
        return;
    }
    expect(problem.rows.size() == problem.lcp.q.size() && problem.impulses.size() == problem.rows.size(), "an island has rows without numbers");
    for (const IslandRow& row : problem.rows) {
        expect(row.end_count >= 1 && row.end_count <= 4, "a row without ends");
        for (std::uint32_t i = 0; i < row.end_count; ++i)
            expect(row.ends[i].body == no_body || row.ends[i].body < problem.bodies.size(), "a row of a body that is not there");
    }
    lcp::Options<float> options;
    options.method = static_cast<lcp::Method>(in.below(10));
    options.max_iterations = 30;
    if (problem.rows.size() > 60) options.method = lcp::Method::pgs;
    std::vector<std::byte> workspace(lcp::workspace_bytes<float>(options.method, problem.rows.size()));
    const std::vector<float> before(problem.impulses.begin(), problem.impulses.end());
    const lcp::Result<float> result = lcp::solve<float>(problem.lcp, options, problem.impulses, workspace);
    expect_sound<float>(problem.lcp, options, result, before, problem.impulses);
    // Absurd masses overflow, and a row that can push nothing has no diagonal; but never is it no problem.
    using enum lcp::Status;
    const lcp::Status s = result.status;
    expect(s != bad_size && s != bad_matrix && s != bad_index && s != bad_blocks && s != bad_option && s != too_little_memory, lcp::describe(s));
}

}  // namespace islet::fuzz
