// The matrix solvers for C (islet/islet_lcp.h): pointers and counts become spans, and the C++ functions do the rest.
#include "../exact.hpp"

#include "islet/islet_lcp.h"
#include "islet/lcp.hpp"

namespace islet::lcp {

namespace {

static_assert(static_cast<int>(Method::lemke) == ISLET_LCP_METHOD_LEMKE && static_cast<int>(Status::too_little_memory) == ISLET_LCP_STATUS_TOO_LITTLE_MEMORY);
static_assert(static_cast<int>(Status::bad_diagonal) == ISLET_LCP_STATUS_BAD_DIAGONAL && static_cast<int>(Method::jacobi) == ISLET_LCP_METHOD_JACOBI);
static_assert(no_row == ISLET_LCP_NO_ROW && max_rows == ISLET_LCP_MAX_ROWS && max_block_rows == ISLET_LCP_MAX_BLOCK_ROWS);

/// An array of the caller's; empty if there is none.
template <class T>
span<T> array(T* data, std::size_t count) {
    return {data, data == nullptr ? 0 : count};
}

/// What the C functions of one type of number take and give.
template <class T>
struct Twins;
template <>
struct Twins<float> {
    using Problem = IsletLcpProblem;
    using Options = IsletLcpOptions;
    using Result = IsletLcpResult;
    using Residuals = IsletLcpResiduals;
};
template <>
struct Twins<double> {
    using Problem = IsletLcpProblem_double;
    using Options = IsletLcpOptions_double;
    using Result = IsletLcpResult_double;
    using Residuals = IsletLcpResiduals_double;
};

template <class T>
typename Twins<T>::Residuals given(const Residuals<T>& r) {
    return {r.infeasibility, r.complementarity, r.natural};
}

/// Of a problem that is refused.
template <class T>
typename Twins<T>::Residuals endless() {
    const T far = static_cast<T>(__builtin_huge_valf());
    return {far, far, far};
}

/// What C can get wrong: null pointers, sizes, and arrays without a place but with a count.
template <class T>
IsletLcpStatus fault_of(const typename Twins<T>::Problem* p) {
    if (p == nullptr) return ISLET_LCP_STATUS_NULL_POINTER;
    if (p->struct_size != sizeof *p) return ISLET_LCP_STATUS_STRUCT_SIZE;
    const bool sparse = p->row_starts != nullptr || p->columns != nullptr || p->values != nullptr || p->entry_count != 0;
    const bool whole = p->row_starts != nullptr && (p->entry_count == 0 || (p->columns != nullptr && p->values != nullptr));
    if ((p->row_count != 0 && p->q == nullptr) || (sparse && !whole)) return ISLET_LCP_STATUS_NULL_POINTER;
    return p->row_count > max_rows ? ISLET_LCP_STATUS_BAD_SIZE : ISLET_LCP_STATUS_CONVERGED;
}
template <class T>
IsletLcpStatus fault_of_options(const typename Twins<T>::Options* o) {
    if (o == nullptr) return ISLET_LCP_STATUS_CONVERGED;
    if (o->struct_size != sizeof *o) return ISLET_LCP_STATUS_STRUCT_SIZE;
    const bool there =
        (o->order_count == 0 || o->order != nullptr) && (o->block_count == 0 || o->blocks != nullptr) && (o->history_count == 0 || o->history != nullptr);
    return there ? ISLET_LCP_STATUS_CONVERGED : ISLET_LCP_STATUS_NULL_POINTER;
}

template <class T>
Problem<T> problem_of(const typename Twins<T>::Problem& p) {
    const std::size_t n = p.row_count;
    Problem<T> made;
    made.dense.values = array(p.dense, n * n);  // on a processor of 32 bits more rows than fit into memory; the product is then too small, and refused
    made.sparse.row_starts = array(p.row_starts, n + 1);
    made.sparse.columns = array(p.columns, p.entry_count);
    made.sparse.values = array(p.values, p.entry_count);
    made.q = array(p.q, n);
    made.lo = array(p.lo, n);
    made.hi = array(p.hi, n);
    made.friction = array(p.friction, n);
    return made;
}

template <class T>
Options<T> options_of(const typename Twins<T>::Options& o) {
    Options<T> made;
    made.method = static_cast<Method>(o.method);
    made.max_iterations = o.max_iterations;
    made.tolerance = o.tolerance;
    made.omega = o.omega;
    made.regularisation = o.regularisation;
    made.check_every = o.check_every;
    made.order = array(o.order, o.order_count);
    made.blocks = array(o.blocks, o.block_count);
    made.history = array(o.history, o.history_count);
    return made;
}

template <class T>
using Solver = Result<T> (*)(const Problem<T>&, const Options<T>&, span<T>, span<std::byte>);

template <class T>
IsletLcpStatus solve_with(Solver<T> solver, const typename Twins<T>::Problem* p, const typename Twins<T>::Options* o, T* x, void* workspace, std::size_t bytes,
                          typename Twins<T>::Result* out) {
    IsletLcpStatus fault = fault_of<T>(p);
    if (fault == ISLET_LCP_STATUS_CONVERGED) fault = fault_of_options<T>(o);
    const bool there = fault != ISLET_LCP_STATUS_CONVERGED || ((x != nullptr || p->row_count == 0) && (workspace != nullptr || bytes == 0));
    if (!there) fault = ISLET_LCP_STATUS_NULL_POINTER;
    if (fault != ISLET_LCP_STATUS_CONVERGED) {
        if (out != nullptr) *out = {fault, no_row, 0, endless<T>()};
        return fault;
    }
    const Result<T> result = solver(problem_of<T>(*p), o == nullptr ? Options<T>{} : options_of<T>(*o), array(x, p->row_count),
                                    span<std::byte>{static_cast<std::byte*>(workspace), bytes});
    if (out != nullptr) *out = {static_cast<IsletLcpStatus>(result.status), result.row, result.iterations, given(result.residuals)};
    return static_cast<IsletLcpStatus>(result.status);
}

template <class T>
typename Twins<T>::Residuals residuals_of(const typename Twins<T>::Problem* p, const T* x) {
    if (fault_of<T>(p) != ISLET_LCP_STATUS_CONVERGED || (x == nullptr && p->row_count != 0)) return endless<T>();
    return given(residuals<T>(problem_of<T>(*p), array(x, p->row_count)));
}

}  // namespace
}  // namespace islet::lcp

using namespace islet::lcp;

extern "C" {

size_t islet_lcp_workspace_bytes(IsletLcpMethod method, size_t rows) { return workspace_bytes<float>(static_cast<Method>(method), rows); }
size_t islet_lcp_workspace_bytes_double(IsletLcpMethod method, size_t rows) { return workspace_bytes<double>(static_cast<Method>(method), rows); }

IsletLcpStatus islet_lcp_solve(const IsletLcpProblem* problem, const IsletLcpOptions* options, float* x, void* workspace, size_t workspace_bytes,
                               IsletLcpResult* result) {
    return solve_with<float>(solve<float>, problem, options, x, workspace, workspace_bytes, result);
}
IsletLcpStatus islet_lcp_solve_double(const IsletLcpProblem_double* problem, const IsletLcpOptions_double* options, double* x, void* workspace,
                                      size_t workspace_bytes, IsletLcpResult_double* result) {
    return solve_with<double>(solve<double>, problem, options, x, workspace, workspace_bytes, result);
}

IsletLcpStatus islet_lcp_solve_by_sweeps(const IsletLcpProblem* problem, const IsletLcpOptions* options, float* x, void* workspace, size_t workspace_bytes,
                                         IsletLcpResult* result) {
    return solve_with<float>(solve_by_sweeps<float>, problem, options, x, workspace, workspace_bytes, result);
}
IsletLcpStatus islet_lcp_solve_by_sweeps_double(const IsletLcpProblem_double* problem, const IsletLcpOptions_double* options, double* x, void* workspace,
                                                size_t workspace_bytes, IsletLcpResult_double* result) {
    return solve_with<double>(solve_by_sweeps<double>, problem, options, x, workspace, workspace_bytes, result);
}

IsletLcpResiduals islet_lcp_residuals(const IsletLcpProblem* problem, const float* x) { return residuals_of<float>(problem, x); }
IsletLcpResiduals_double islet_lcp_residuals_double(const IsletLcpProblem_double* problem, const double* x) { return residuals_of<double>(problem, x); }

const char* islet_lcp_describe(IsletLcpStatus status) {
    if (status == ISLET_LCP_STATUS_NULL_POINTER) return "A pointer that must not be null is: check the problem, x, and the arrays that have a count.";
    if (status == ISLET_LCP_STATUS_STRUCT_SIZE) return "A struct has no size that this version of Islet knows: start from its default, which sets struct_size.";
    return describe(static_cast<Status>(status));
}

}  // extern "C"
