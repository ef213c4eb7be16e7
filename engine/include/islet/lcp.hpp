// Linear complementarity problems with bounds, and methods that solve them: projected Gauss-Seidel and its relatives, on plain matrices. This is a library of
// its own: it knows nothing of bodies, and islet.hpp does not include it. docs/lcp.md explains the methods on an example.
//
// Given a matrix M and a vector q, find x and w = M x + q such that for every row i
//
//     lo_i <= x_i <= hi_i,    x_i = lo_i where w_i > 0,    x_i = hi_i where w_i < 0.
//
// With lo = 0 and hi = infinity this is the LCP: x >= 0, w >= 0, x_i w_i = 0. For a contact x is the impulse and w the velocity of separation: the contact
// either pushes or parts. The caller provides all memory, every argument is checked, and a result is called converged only if its residual was measured.
//
// All functions exist for float and for double. They compute as the engine does (no fused operations, no reordering), so all builds give the same bits. Unlike
// World, they compute in the floating-point mode of the caller.
#pragma once

#include <cstddef>
#include <cstdint>

#include "islet/span.hpp"
#include "islet/version.hpp"
#include "islet/visibility.hpp"

ISLET_API_BEGIN
namespace islet::lcp {

/// In Problem::friction: the row has bounds of its own. In Result::row: no row in particular.
inline constexpr std::uint32_t no_row = 0xffffffffu;

/// The most rows of a problem; more are refused (bad_size).
inline constexpr std::uint32_t max_rows = 1u << 24;

/// The most rows of one block of Method::block_pgs.
inline constexpr std::uint32_t max_block_rows = 6;

/// All entries, row after row: rows * rows of them.
template <class T>
struct DenseMatrix {
    span<const T> values = {};
};

/// Compressed sparse rows: row i has the entries values[k] in columns[k] for row_starts[i] <= k < row_starts[i + 1]. Within a row the columns ascend, each
/// at most once.
template <class T>
struct SparseMatrix {
    span<const std::uint32_t> row_starts = {};  ///< rows + 1 of them, the first 0, the last values.size()
    span<const std::uint32_t> columns = {};
    span<const T> values = {};
};

/// Views of the caller's numbers; q.size() is the number of rows. Give one of the matrices and leave the other empty.
template <class T>
struct Problem {
    DenseMatrix<T> dense = {};
    SparseMatrix<T> sparse = {};
    span<const T> q = {};
    /// Lower bounds, -infinity allowed; empty: all 0.
    span<const T> lo = {};
    /// Upper bounds, infinity allowed; empty: all infinity. For a row with friction: its coefficient, finite and at least 0.
    span<const T> hi = {};
    /// Coulomb friction; empty: none. If friction[i] is a row j and not no_row, the bounds of row i are -hi_i x_j and +hi_i x_j, with the newest x_j (0 while
    /// x_j is negative), and lo_i is not used. (If the product overflows, there is no bound.) Row j must have bounds of its own.
    span<const std::uint32_t> friction = {};
};

enum class Method : std::uint8_t {
    pgs,            ///< projected Gauss-Seidel: row after row, always with the newest values
    psor,           ///< the same with each step multiplied by omega
    symmetric_pgs,  ///< a sweep forward and one back count as one iteration; omega
    red_black,      ///< rows 0, 2, 4, ..., then 1, 3, 5, ...; omega
    block_pgs,      ///< block after block (Options::blocks), the few rows of each solved together and exactly; omega
    jacobi,         ///< all rows from the values of the iteration before; omega. Needs an omega below 2 / (largest eigenvalue of D^-1 M)
    l1_jacobi,      ///< the same with the row's sum of magnitudes for its diagonal: slower, converges for every symmetric positive definite M
    nncg,           ///< nonsmooth nonlinear conjugate gradients around PGS; an iteration is a sweep forward, one back, and a step
    newton,         ///< semismooth Newton on the natural map, with line search: few iterations, each a dense factorisation
    lemke,          ///< direct: complementary pivoting, exact except for rounding; the number of pivots may be exponential. The start x sets only the
                    ///< bounds of rows with friction. These are frozen for a solve and then computed again, until they no longer change
};

enum class Status : std::uint8_t {
    converged,          ///< the natural residual, measured at the end, is at most the tolerance
    iteration_limit,    ///< max_iterations came first
    stalled,            ///< the method got no further, or ended where rounding leaves the residual above the tolerance
    diverged,           ///< the next value of `row` would not have been finite
    ray,                ///< lemke ended on a ray: if M is positive semi-definite there is no solution
    singular,           ///< newton, lemke: the equations of the free rows have no unique solution and nothing helped; `row` is where it showed
    bad_diagonal,       ///< the diagonal of `row` is not positive, or tiny, even after regularisation
    not_finite,         ///< a NaN or infinity in `row` of M, q or x, or among the options
    bad_size,           ///< spans that do not fit together, no matrix, two matrices, or too many rows
    bad_matrix,         ///< the sparse matrix is broken in `row`: rows not ascending, or columns not ascending or out of range
    bad_bounds,         ///< lo > hi, or a NaN, in `row`; or a coefficient of friction that is negative or infinite
    bad_index,          ///< friction of `row` names no row, itself, or a row with friction; or an entry of `order` (its place is `row`) names no row
    bad_blocks,         ///< blocks that do not begin with row 0, do not ascend, or are longer than max_block_rows; `row` is the block
    bad_option,         ///< tolerance or regularisation negative, omega not in (0, 2), check_every 0, or no such method
    unsupported,        ///< the method has no use for the order or blocks given
    too_little_memory,  ///< workspace_bytes says how much is needed
};

/// A sentence that says what the status means and what to do about it.
const char* describe(Status);

template <class T>
struct Options {
    Method method = Method::pgs;
    /// The most sweeps, Newton steps or pivots.
    std::uint32_t max_iterations = 1000;
    /// For the natural residual, in the units of x and w. With 0, only an exact solution ends the method early.
    T tolerance = T(1e-5);
    /// Relaxation factor: below 1 damps, above 1 hurries.
    T omega = T(1);
    /// Added to a diagonal entry that is zero, negative or tiny (at most the rounding unit times the largest entry of its row), before a step is divided by it.
    /// This makes steps shorter and does not change the solution. With 0, such rows are refused (bad_diagonal). In newton: the least damping of a singular
    /// system.
    T regularisation = T(0);
    /// The residual costs as much as a sweep: pgs and its relatives measure it after every so many iterations, and at the end.
    std::uint32_t check_every = 1;
    /// pgs, psor, symmetric_pgs and nncg: the rows in the order they are visited. A row may be missing (it keeps its value) or come twice. Empty: 0, 1, 2, ...
    span<const std::uint32_t> order = {};
    /// block_pgs: the first row of each block, ascending from 0; a block ends where the next begins. Empty: every row is a block of its own.
    span<const std::uint32_t> blocks = {};
    /// If not empty, history[k] becomes the natural residual after iteration k + 1, as far as there is room. (lemke writes none.)
    span<T> history = {};
};

/// How far x is from a solution, in three measures; each is the largest of all rows.
template <class T>
struct Residuals {
    /// How far x is outside its bounds, and how far w has the wrong sign where x is at or outside a bound.
    T infeasibility = T(0);
    /// |w| times how far x is from the bound at which w may have its sign: x - lo where w > 0, hi - x where w < 0. If that bound is infinite the distance to
    /// the other one counts, and 1 if both are.
    T complementarity = T(0);
    /// The natural map |x - clamp(x - w, lo, hi)|: 0 at solutions and nowhere else.
    T natural = T(0);
};

template <class T>
struct Result {
    Status status = Status::converged;
    std::uint32_t row = no_row;    ///< the row that `status` is about
    std::uint32_t iterations = 0;  ///< iterations made; 0 also if x was a solution already
    /// The residual of the final x. Infinite if the problem was refused.
    Residuals<T> residuals = {};
};

/// Bytes of workspace that solve needs for a problem of so many rows; the number of nonzeros does not matter. The largest std::size_t if that does not fit.
template <class T>
constexpr std::size_t workspace_bytes(Method method, std::size_t rows) {
    if (rows > max_rows) return static_cast<std::size_t>(-1);
    const std::uint64_t n = rows;
    std::uint64_t numbers = n;  // the diagonal
    std::uint64_t indices = 0;
    switch (method) {
        case Method::pgs:
        case Method::psor:
        case Method::symmetric_pgs:
        case Method::red_black:
        case Method::block_pgs: break;
        case Method::jacobi:
        case Method::l1_jacobi: numbers = 2 * n; break;
        case Method::nncg: numbers = 3 * n; break;
        case Method::newton:
            numbers = n * n + 6 * n;
            indices = 4 * n;
            break;
        case Method::lemke:
            numbers = n * (n + 1) + 4 * n;
            indices = 6 * n + 2;
            break;
    }
    const std::uint64_t bytes = numbers * sizeof(T) + indices * sizeof(std::uint32_t) + alignof(T);
    return bytes > static_cast<std::size_t>(-1) ? static_cast<std::size_t>(-1) : static_cast<std::size_t>(bytes);
}

/// Solves the problem from the start x (the warm start; zeros are as good as any) and leaves in x the last iterate, which is finite. x, workspace and
/// history may overlap nothing else; workspace needs no alignment. On statuses from bad_diagonal on, x is as it was; so it is
/// where lemke ends with ray or singular, unless there is friction.
template <class T>
ISLET_API Result<T> solve(const Problem<T>& problem, const Options<T>& options, span<T> x, span<std::byte> workspace);

/// The same for pgs, psor, symmetric_pgs and red_black alone, others being unsupported: a program that calls this one and not solve need not link the
/// other methods.
template <class T>
ISLET_API Result<T> solve_by_sweeps(const Problem<T>& problem, const Options<T>& options, span<T> x, span<std::byte> workspace);

/// How far any x is from a solution. Infinite if solve would refuse the problem, or if x has the wrong size or a number that is not finite.
template <class T>
ISLET_API Residuals<T> residuals(const Problem<T>& problem, span<const T> x);

extern template Result<float> solve(const Problem<float>&, const Options<float>&, span<float>, span<std::byte>);
extern template Result<double> solve(const Problem<double>&, const Options<double>&, span<double>, span<std::byte>);
extern template Result<float> solve_by_sweeps(const Problem<float>&, const Options<float>&, span<float>, span<std::byte>);
extern template Result<double> solve_by_sweeps(const Problem<double>&, const Options<double>&, span<double>, span<std::byte>);
extern template Residuals<float> residuals(const Problem<float>&, span<const float>);
extern template Residuals<double> residuals(const Problem<double>&, span<const double>);

}  // namespace islet::lcp
ISLET_API_END
