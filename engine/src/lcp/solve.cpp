#include "../exact.hpp"

#include "../lcp/task.hpp"

namespace islet::lcp {

template <class T>
Result<T> solve(const Problem<T>& problem, const Options<T>& options, span<T> x, span<std::byte> workspace) {
    if (const Verdict v = check_all(problem, options, x, workspace); !v.good()) return refuse(problem, x, v);
    const Task<T> task = {problem, options, x.data(), row_count(problem), Workspace(workspace)};
    switch (options.method) {
        case Method::pgs:
        case Method::psor:
        case Method::symmetric_pgs:
        case Method::red_black: break;
        case Method::block_pgs: return run_blocks(task);
        case Method::jacobi:
        case Method::l1_jacobi: return run_jacobi(task);
        case Method::nncg: return run_nncg(task);
        case Method::newton: return run_newton(task);
        case Method::lemke: return run_lemke(task);
    }
    return run_sweeps(task);
}

template Result<float> solve(const Problem<float>&, const Options<float>&, span<float>, span<std::byte>);
template Result<double> solve(const Problem<double>&, const Options<double>&, span<double>, span<std::byte>);

}  // namespace islet::lcp
