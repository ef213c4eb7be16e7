// The matrix solvers in C: each method finds the known solution of a small problem, in float and in double, from a dense and from a sparse matrix; and what is
// null or has a wrong size is refused, with x as it was.
#include <islet/islet_lcp.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "check.h"

// Three boxes of 1 kg fall at 1 m/s, a fourth one above them moves up (docs/lcp.md): the impulses are 3, 2, 1 and 0 kg m/s.
enum { rows = 4 };
static const float dense[] = {1, -1, 0, 0, -1, 2, -1, 0, 0, -1, 2, -1, 0, 0, -1, 2}, q[] = {-1, 0, 0, 1.5f};
static const double dense_double[] = {1, -1, 0, 0, -1, 2, -1, 0, 0, -1, 2, -1, 0, 0, -1, 2}, q_double[] = {-1, 0, 0, 1.5};
static const uint32_t row_starts[] = {0, 2, 5, 8, 10}, columns[] = {0, 1, 0, 1, 2, 1, 2, 3, 2, 3};
static const float values[] = {1, -1, -1, 2, -1, -1, 2, -1, -1, 2};
static char workspace[4096];

static bool solved(const float* x) {
    for (int i = 0; i < rows; ++i)
        if (fabsf(x[i] - (float)(3 - i)) > 1e-3f) return false;
    return true;
}

static IsletLcpProblem tower(void) {
    IsletLcpProblem problem = islet_lcp_default_problem();
    problem.row_count = rows;
    problem.dense = dense;
    problem.q = q;
    return problem;
}

static void methods(void) {
    for (int method = ISLET_LCP_METHOD_PGS; method <= ISLET_LCP_METHOD_LEMKE; ++method) {
        IsletLcpOptions options = islet_lcp_default_options();
        options.method = (IsletLcpMethod)method;
        if (method == ISLET_LCP_METHOD_JACOBI) options.omega = 0.8f;
        const size_t bytes = islet_lcp_workspace_bytes(options.method, rows);
        CHECK(bytes <= sizeof workspace);
        float x[rows] = {0}, again[rows] = {0};
        const IsletLcpProblem whole = tower();
        IsletLcpResult found;
        CHECK(islet_lcp_solve(&whole, &options, x, workspace, bytes, &found) == ISLET_LCP_STATUS_CONVERGED);
        CHECK(solved(x) && found.status == ISLET_LCP_STATUS_CONVERGED && found.row == ISLET_LCP_NO_ROW && found.residuals.natural <= 1e-5f);
        IsletLcpProblem sparse = islet_lcp_default_problem();
        sparse.row_count = rows;
        sparse.row_starts = row_starts;
        sparse.columns = columns;
        sparse.values = values;
        sparse.entry_count = sizeof values / sizeof values[0];
        sparse.q = q;
        CHECK(islet_lcp_solve(&sparse, &options, again, workspace, bytes, NULL) == ISLET_LCP_STATUS_CONVERGED);
        CHECK(memcmp(x, again, sizeof x) == 0);
        CHECK(islet_lcp_residuals(&sparse, x).natural == found.residuals.natural);
        const bool sweeps = method <= ISLET_LCP_METHOD_RED_BLACK;
        CHECK(islet_lcp_solve_by_sweeps(&whole, &options, again, workspace, bytes, NULL) == (sweeps ? ISLET_LCP_STATUS_CONVERGED : ISLET_LCP_STATUS_UNSUPPORTED));
        CHECK(islet_lcp_solve(&whole, &options, again, workspace, bytes - 4, NULL) == ISLET_LCP_STATUS_TOO_LITTLE_MEMORY);

        IsletLcpProblem_double problem = islet_lcp_default_problem_double();
        problem.row_count = rows;
        problem.dense = dense_double;
        problem.q = q_double;
        IsletLcpOptions_double precise = islet_lcp_default_options_double();
        precise.method = options.method;
        precise.omega = options.omega;
        precise.tolerance = 1e-12;
        IsletLcpResult_double exact;
        double y[rows] = {0};
        CHECK(islet_lcp_workspace_bytes_double(options.method, rows) <= sizeof workspace);
        CHECK(islet_lcp_solve_double(&problem, &precise, y, workspace, sizeof workspace, &exact) == ISLET_LCP_STATUS_CONVERGED);
        for (int i = 0; i < rows; ++i) CHECK(fabs(y[i] - (3 - i)) < 1e-9);
        CHECK(islet_lcp_residuals_double(&problem, y).natural == exact.residuals.natural);
        if (sweeps) CHECK(islet_lcp_solve_by_sweeps_double(&problem, &precise, y, workspace, sizeof workspace, NULL) == ISLET_LCP_STATUS_CONVERGED);
    }
}

// A box on a floor, pushed along it: a normal row and a row of friction. Below the limit it sticks, above it the friction is at its bound.
static void friction(void) {
    const float m[] = {1, 0, 0, 1}, hi[] = {INFINITY, 0.5f};
    const uint32_t of[] = {ISLET_LCP_NO_ROW, 0};
    for (int i = 0; i < 2; ++i) {
        const float pushed[] = {-2, i == 0 ? 0.75f : 3};
        IsletLcpProblem problem = islet_lcp_default_problem();
        problem.row_count = 2;
        problem.dense = m;
        problem.q = pushed;
        problem.hi = hi;
        problem.friction = of;
        float x[2] = {0}, history[8] = {0};
        IsletLcpOptions options = islet_lcp_default_options();
        options.history = history;
        options.history_count = 8;
        IsletLcpResult found;
        CHECK(islet_lcp_solve(&problem, &options, x, workspace, sizeof workspace, &found) == ISLET_LCP_STATUS_CONVERGED);
        CHECK(x[0] == 2 && x[1] == (i == 0 ? -0.75f : -1) && found.iterations > 0 && history[found.iterations - 1] <= options.tolerance);
    }
}

static void refusals(void) {
    const float start[rows] = {1, 2, 3, 4};
    float x[rows];
    memcpy(x, start, sizeof x);
    IsletLcpResult found;
#define REFUSED(problem, options, to, memory, code)                                                                                            \
    CHECK(islet_lcp_solve(problem, options, to, memory, sizeof workspace, &found) == (code) && found.status == (code) &&                     \
          isinf(found.residuals.natural) && memcmp(x, start, sizeof x) == 0 && strlen(islet_lcp_describe(code)) > 20)
    IsletLcpProblem problem = tower();
    IsletLcpOptions options = islet_lcp_default_options();
    REFUSED(NULL, NULL, x, workspace, ISLET_LCP_STATUS_NULL_POINTER);
    REFUSED(&problem, NULL, NULL, workspace, ISLET_LCP_STATUS_NULL_POINTER);
    REFUSED(&problem, NULL, x, NULL, ISLET_LCP_STATUS_NULL_POINTER);
    problem.q = NULL;
    REFUSED(&problem, NULL, x, workspace, ISLET_LCP_STATUS_NULL_POINTER);
    problem = tower();
    problem.dense = NULL;
    REFUSED(&problem, NULL, x, workspace, ISLET_LCP_STATUS_BAD_SIZE);
    problem.values = values;
    REFUSED(&problem, NULL, x, workspace, ISLET_LCP_STATUS_NULL_POINTER);
    problem = tower();
    problem.row_count = ISLET_LCP_MAX_ROWS + 1;
    REFUSED(&problem, NULL, x, workspace, ISLET_LCP_STATUS_BAD_SIZE);
    problem = tower();
    problem.struct_size = 0;
    REFUSED(&problem, NULL, x, workspace, ISLET_LCP_STATUS_STRUCT_SIZE);
    CHECK(isinf(islet_lcp_residuals(&problem, x).natural));
    problem = tower();
    CHECK(isinf(islet_lcp_residuals(&problem, NULL).natural) && isinf(islet_lcp_residuals(NULL, x).natural));
    options.struct_size += 8;
    REFUSED(&problem, &options, x, workspace, ISLET_LCP_STATUS_STRUCT_SIZE);
    options = islet_lcp_default_options();
    options.order_count = 1;
    REFUSED(&problem, &options, x, workspace, ISLET_LCP_STATUS_NULL_POINTER);
    options = islet_lcp_default_options();
    options.method = 200;
    CHECK(islet_lcp_solve(&problem, &options, x, workspace, sizeof workspace, NULL) == ISLET_LCP_STATUS_BAD_OPTION && memcmp(x, start, sizeof x) == 0);
    for (int status = 0; status < 256; ++status) CHECK(islet_lcp_describe((IsletLcpStatus)status) != NULL);
    CHECK(islet_lcp_workspace_bytes(ISLET_LCP_METHOD_PGS, (size_t)ISLET_LCP_MAX_ROWS + 1) == SIZE_MAX);
}

int main(void) {
    methods();
    friction();
    refusals();
    return result();
}
