#include "../exact.hpp"

#include "islet/lcp.hpp"

namespace islet::lcp {

const char* describe(Status s) {
    switch (s) {
        case Status::converged: return "Solved: the natural residual is within the tolerance.";
        case Status::iteration_limit: return "Not solved within max_iterations: allow more, start closer, or take another method.";
        case Status::stalled: return "Got no further: raise the tolerance to what the numbers' precision allows, or take another method.";
        case Status::diverged: return "The values grew beyond all bounds: lower omega, or take a method that suits the matrix.";
        case Status::ray: return "Ended on a ray: if the matrix is positive semi-definite the problem has no solution.";
        case Status::singular: return "The equations of the rows between their bounds have no unique solution: give a regularisation, or take another method.";
        case Status::bad_diagonal: return "A diagonal is zero, negative or tiny: give a regularisation, or take a method that does not divide by it.";
        case Status::not_finite: return "A number is NaN or infinite where only bounds may be.";
        case Status::bad_size: return "The sizes do not fit: q, x, lo, hi and friction have one number per row, and one matrix is given.";
        case Status::bad_matrix:
            return "The sparse matrix is broken: row starts must ascend to the number of values, columns must ascend within a row and exist.";
        case Status::bad_bounds: return "A lower bound is above the upper one, or a coefficient of friction is not a number of at least 0.";
        case Status::bad_index: return "Friction must name another row, without friction of its own; an order must name rows that exist.";
        case Status::bad_blocks: return "Blocks must begin with row 0, ascend, and have at most max_block_rows rows each.";
        case Status::bad_option: return "An option is outside its range: the comments on Options give the ranges.";
        case Status::unsupported: return "This method has no use for the order or blocks given, or this function does not have the method.";
        case Status::too_little_memory: return "The workspace is too small: workspace_bytes says how much is needed.";
    }
    return "Unknown status.";
}

}  // namespace islet::lcp
