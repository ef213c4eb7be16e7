// The matrix solvers for C, C11 or later: linear complementarity problems with bounds and friction. islet/lcp.hpp is the same for C++, and docs/lcp.md explains
// the methods. The library is islet_lcp (islet::lcp, islet-lcp for pkg-config); it knows nothing of bodies, needs no other library and allocates nothing.
//
// Given a matrix M and a vector q, find x and w = M x + q such that for every row i
//
//     lo_i <= x_i <= hi_i,    x_i = lo_i where w_i > 0,    x_i = hi_i where w_i < 0.
//
// Each function exists for float and for double (its name ends in _double). Definitions begin with struct_size and may get further fields in later versions:
// start from their default, such as islet_lcp_default_problem(), which sets the size.
#ifndef ISLET_ISLET_LCP_H
#define ISLET_ISLET_LCP_H

#include <stddef.h>
#include <stdint.h>

#ifndef ISLET_C_API
#if defined(ISLET_SHARED_LIBRARY) && defined(__GNUC__)  // while the library itself is compiled
#define ISLET_C_API __attribute__((visibility("default")))
#else
#define ISLET_C_API
#endif
#endif

#ifdef __cplusplus
extern "C" {
#endif

/// In a problem's friction: the row has bounds of its own. In a result's row: no row in particular.
#define ISLET_LCP_NO_ROW 0xffffffffu
/// The most rows of a problem; more are refused (bad_size).
#define ISLET_LCP_MAX_ROWS (1u << 24)
/// The most rows of one block of block_pgs.
#define ISLET_LCP_MAX_BLOCK_ROWS 6u

typedef uint8_t IsletLcpMethod;
enum {
    ISLET_LCP_METHOD_PGS = 0,            ///< projected Gauss-Seidel: row after row, always with the newest values
    ISLET_LCP_METHOD_PSOR = 1,           ///< the same with each step multiplied by omega
    ISLET_LCP_METHOD_SYMMETRIC_PGS = 2,  ///< a sweep forward and one back count as one iteration; omega
    ISLET_LCP_METHOD_RED_BLACK = 3,      ///< rows 0, 2, 4, ..., then 1, 3, 5, ...; omega
    ISLET_LCP_METHOD_BLOCK_PGS = 4,      ///< block after block, the few rows of each solved together and exactly; omega
    ISLET_LCP_METHOD_JACOBI = 5,         ///< all rows from the values of the iteration before; omega
    ISLET_LCP_METHOD_L1_JACOBI = 6,      ///< the same with the row's sum of magnitudes for its diagonal: slower, but sure to converge
    ISLET_LCP_METHOD_NNCG = 7,           ///< nonsmooth nonlinear conjugate gradients around PGS
    ISLET_LCP_METHOD_NEWTON = 8,         ///< semismooth Newton, with line search: few iterations, each a dense factorisation
    ISLET_LCP_METHOD_LEMKE = 9,          ///< direct: complementary pivoting, exact except for rounding
};

/// How a call ended. From bad_diagonal on the problem was refused, and x is as it was.
typedef uint8_t IsletLcpStatus;
enum {
    ISLET_LCP_STATUS_CONVERGED = 0,           ///< the natural residual, measured at the end, is at most the tolerance
    ISLET_LCP_STATUS_ITERATION_LIMIT = 1,     ///< max_iterations came first
    ISLET_LCP_STATUS_STALLED = 2,             ///< the method got no further
    ISLET_LCP_STATUS_DIVERGED = 3,            ///< the next value of `row` would not have been finite
    ISLET_LCP_STATUS_RAY = 4,                 ///< lemke ended on a ray: if M is positive semi-definite there is no solution
    ISLET_LCP_STATUS_SINGULAR = 5,            ///< newton, lemke: the equations of the free rows have no unique solution
    ISLET_LCP_STATUS_BAD_DIAGONAL = 6,        ///< the diagonal of `row` is not positive, or tiny, even after regularisation
    ISLET_LCP_STATUS_NOT_FINITE = 7,          ///< a NaN or infinity in `row` of M, q or x, or among the options
    ISLET_LCP_STATUS_BAD_SIZE = 8,            ///< no matrix, two matrices, or too many rows
    ISLET_LCP_STATUS_BAD_MATRIX = 9,          ///< the sparse matrix is broken in `row`
    ISLET_LCP_STATUS_BAD_BOUNDS = 10,         ///< lo > hi, or a NaN, in `row`; or a coefficient of friction that is negative or infinite
    ISLET_LCP_STATUS_BAD_INDEX = 11,          ///< friction of `row`, or the entry `row` of the order, names no row that it may
    ISLET_LCP_STATUS_BAD_BLOCKS = 12,         ///< blocks that do not begin with row 0, do not ascend, or are too long; `row` is the block
    ISLET_LCP_STATUS_BAD_OPTION = 13,         ///< an option out of its range, or no such method
    ISLET_LCP_STATUS_UNSUPPORTED = 14,        ///< the method has no use for the order or blocks given
    ISLET_LCP_STATUS_TOO_LITTLE_MEMORY = 15,  ///< islet_lcp_workspace_bytes says how much is needed
    ISLET_LCP_STATUS_NULL_POINTER = 254,      ///< a pointer that must not be null is
    ISLET_LCP_STATUS_STRUCT_SIZE = 255,       ///< a struct_size that no version of Islet up to this one gives: start from the default
};

/// How far x is from a solution, in three measures; each is the largest of all rows. In the units of x and w.
typedef struct IsletLcpResiduals {
    float infeasibility;    ///< how far x is outside its bounds, and how far w has the wrong sign where x is at or outside a bound
    float complementarity;  ///< |w| times how far x is from the bound at which w may have its sign
    float natural;          ///< |x - clamp(x - w, lo, hi)|: 0 at solutions and nowhere else
} IsletLcpResiduals;

typedef struct IsletLcpResiduals_double {
    double infeasibility;
    double complementarity;
    double natural;
} IsletLcpResiduals_double;

// A problem in numbers of the type T. Give one of the matrices, and leave the pointers of the other null.
#define ISLET_LCP_STRUCTS(T, suffix)                                                                                                              \
    typedef struct IsletLcpProblem##suffix {                                                                                                      \
        uint32_t struct_size; /* sizeof(IsletLcpProblem) */                                                                                       \
        uint32_t row_count;                                                                                                                       \
        const T* dense;             /* row after row, row_count * row_count entries */                                                            \
        const uint32_t* row_starts; /* sparse: row i has the entries row_starts[i] <= k < row_starts[i + 1]; row_count + 1 of them */             \
        const uint32_t* columns;    /* of each entry, ascending within a row */                                                                   \
        const T* values;            /* of each entry */                                                                                           \
        size_t entry_count;         /* how many entries columns and values have */                                                                \
        const T* q;                                                                                                                               \
        const T* lo;                /* lower bounds, -infinity allowed; null: all 0 */                                                            \
        const T* hi;                /* upper bounds, infinity allowed; null: all infinity. For a row with friction: its coefficient, >= 0 */      \
        const uint32_t* friction;   /* the row of whose x the bounds are multiples, or ISLET_LCP_NO_ROW; null: none */                            \
    } IsletLcpProblem##suffix;                                                                                                                    \
    typedef struct IsletLcpOptions##suffix {                                                                                                      \
        uint32_t struct_size;    /* sizeof(IsletLcpOptions) */                                                                                    \
        IsletLcpMethod method;   /* default: pgs */                                                                                               \
        uint32_t max_iterations; /* default: 1000. The most sweeps, Newton steps or pivots */                                                     \
        uint32_t check_every;    /* default: 1. Measure the residual, which costs as much as a sweep, after every so many iterations */           \
        T tolerance;             /* default: 1e-5, >= 0. For the natural residual, in the units of x and w */                                     \
        T omega;                 /* default: 1, above 0 and below 2. Relaxation factor */                                                         \
        T regularisation;        /* default: 0, >= 0. Added to a diagonal entry that is zero, negative or tiny */                                 \
        const uint32_t* order;   /* default: null. The rows in the order they are visited */                                                      \
        size_t order_count;                                                                                                                       \
        const uint32_t* blocks;  /* default: null. block_pgs: the first row of each block, ascending from 0 */                                    \
        size_t block_count;                                                                                                                       \
        T* history;              /* default: null. history[k] becomes the natural residual after iteration k + 1, as far as there is room */      \
        size_t history_count;                                                                                                                     \
    } IsletLcpOptions##suffix;                                                                                                                    \
    typedef struct IsletLcpResult##suffix {                                                                                                       \
        IsletLcpStatus status;                                                                                                                    \
        uint32_t row;        /* the row that `status` is about, or ISLET_LCP_NO_ROW */                                                            \
        uint32_t iterations; /* iterations made; 0 also if x was a solution already */                                                            \
        IsletLcpResiduals##suffix residuals; /* of the final x; infinite if the problem was refused */                                            \
    } IsletLcpResult##suffix;                                                                                                                     \
    static inline IsletLcpProblem##suffix islet_lcp_default_problem##suffix(void) {                                                               \
        const IsletLcpProblem##suffix problem = {(uint32_t)sizeof problem, 0, NULL, NULL, NULL, NULL, 0, NULL, NULL, NULL, NULL};                 \
        return problem;                                                                                                                           \
    }                                                                                                                                             \
    static inline IsletLcpOptions##suffix islet_lcp_default_options##suffix(void) {                                                               \
        const IsletLcpOptions##suffix options = {                                                                                                 \
            (uint32_t)sizeof options, ISLET_LCP_METHOD_PGS, 1000, 1, (T)1e-5, 1, 0, NULL, 0, NULL, 0, NULL, 0};                                   \
        return options;                                                                                                                           \
    }
ISLET_LCP_STRUCTS(float, )
ISLET_LCP_STRUCTS(double, _double)
#undef ISLET_LCP_STRUCTS

/// Bytes of workspace that islet_lcp_solve needs for a problem of so many rows; SIZE_MAX if that does not fit, or there are more than ISLET_LCP_MAX_ROWS.
ISLET_C_API size_t islet_lcp_workspace_bytes(IsletLcpMethod method, size_t rows);
ISLET_C_API size_t islet_lcp_workspace_bytes_double(IsletLcpMethod method, size_t rows);

/// Solves the problem from the start x (row_count numbers: the warm start; zeros are as good as any) and leaves in x the last iterate, which is finite. Returns
/// the result's status. `options` may be null: the defaults; `result` may be null, too. x, workspace and history may overlap nothing else; workspace needs no
/// alignment. On statuses from bad_diagonal on, x is as it was.
ISLET_C_API IsletLcpStatus islet_lcp_solve(const IsletLcpProblem* problem, const IsletLcpOptions* options, float* x, void* workspace, size_t workspace_bytes,
                                           IsletLcpResult* result);
ISLET_C_API IsletLcpStatus islet_lcp_solve_double(const IsletLcpProblem_double* problem, const IsletLcpOptions_double* options, double* x, void* workspace,
                                                  size_t workspace_bytes, IsletLcpResult_double* result);

/// The same for pgs, psor, symmetric_pgs and red_black alone, others being unsupported: a program that calls this one and not islet_lcp_solve leaves out the
/// other methods if it is linked with --gc-sections.
ISLET_C_API IsletLcpStatus islet_lcp_solve_by_sweeps(const IsletLcpProblem* problem, const IsletLcpOptions* options, float* x, void* workspace,
                                                     size_t workspace_bytes, IsletLcpResult* result);
ISLET_C_API IsletLcpStatus islet_lcp_solve_by_sweeps_double(const IsletLcpProblem_double* problem, const IsletLcpOptions_double* options, double* x,
                                                            void* workspace, size_t workspace_bytes, IsletLcpResult_double* result);

/// How far any x (row_count numbers) is from a solution. Infinite if the problem would be refused, a pointer is null, or x has a number that is not finite.
ISLET_C_API IsletLcpResiduals islet_lcp_residuals(const IsletLcpProblem* problem, const float* x);
ISLET_C_API IsletLcpResiduals_double islet_lcp_residuals_double(const IsletLcpProblem_double* problem, const double* x);

/// A sentence that says what the status means and what to do about it. Never null.
ISLET_C_API const char* islet_lcp_describe(IsletLcpStatus status);

#ifdef __cplusplus
}
#endif

#endif
