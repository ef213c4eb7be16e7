// Block PGS: the rows of a block are solved together instead of one after another. This pays where a few rows are coupled tightly, like the two points of a
// contact, or the normal and friction of one point, and blocks are coupled loosely.
//
// A block without a unique solution (two equal rows) is swept row by row.
#include "../exact.hpp"

#include "../lcp/block.hpp"
#include "../lcp/sweep.hpp"

namespace islet::lcp {
namespace {

struct Range {
    std::uint32_t first, end;
};

template <class T>
Range block_range(const Task<T>& task, std::uint32_t block) {
    const span<const std::uint32_t> starts = task.options.blocks;
    if (starts.empty()) return {block, block + 1};
    return {starts[block], block + 1 < starts.size() ? starts[block + 1] : task.rows};
}

/// Sets up the block's own problem while all other rows keep their values.
template <class T>
void cut_out(const Task<T>& task, const T* divisors, Range range, Block<T>& block) {
    block.size = range.end - range.first;
    for (std::uint32_t k = 0; k < block.size; ++k) {
        const std::uint32_t i = range.first + k;
        for (std::uint32_t l = 0; l < block.size; ++l) block.a[k][l] = T(0);
        block.b[k] = task.problem.q[i] + T(0);
        const Row<T> row = row_of(task.problem, i);
        for (std::uint32_t e = 0; e < row.count; ++e) {
            const std::uint32_t j = row.column(e);
            if (j >= range.first && j < range.end)
                block.a[k][j - range.first] = row.values[e];
            else
                block.b[k] += row.values[e] * task.x[j];
        }
        // A regularised diagonal shortens the step from x; at the solution that makes no difference.
        const T added = divisors[i] - block.a[k][k];
        block.a[k][k] = divisors[i];
        block.b[k] -= added * task.x[i];

        const std::uint32_t normal = has_friction(task.problem, i) ? task.problem.friction[i] : no_row;
        const bool inside = normal != no_row && normal >= range.first && normal < range.end;
        const Bounds<T> bounds = bounds_of(task.problem, i, task.x);
        block.friction[k] = inside ? normal - range.first : no_row;
        block.lo[k] = bounds.lo;
        block.hi[k] = inside ? task.problem.hi[i] : bounds.hi;
    }
}

/// Cuts y to its bounds. Friction rows come last: their bounds follow from values of y that are already cut.
template <class T>
void keep_bounds(const Block<T>& block, T* y) {
    for (const bool has_friction : {false, true}) {
        for (std::uint32_t k = 0; k < block.size; ++k) {
            if ((block.friction[k] != no_row) != has_friction) continue;
            const T limit = has_friction ? block.hi[k] * larger(y[block.friction[k]], T(0)) : T(0);
            y[k] = clamp(y[k], has_friction ? -limit : block.lo[k], has_friction ? limit : block.hi[k]);
        }
    }
}

/// Returns the row that failed, or no_row.
template <class T>
std::uint32_t update_block(const Task<T>& task, const T* divisors, Range range) {
    const T omega = task.options.omega;
    Block<T> block;
    T y[max_block_rows];
    for (std::uint32_t k = 0; k < range.end - range.first; ++k) y[k] = task.x[range.first + k];
    if (range.end - range.first > 1) {
        cut_out(task, divisors, range, block);
        if (solve_block(block, y)) {
            T* const x = task.x + range.first;
            if (omega != T(1)) {
                for (std::uint32_t k = 0; k < block.size; ++k) y[k] = x[k] + omega * (y[k] - x[k]);
                keep_bounds(block, y);
            }
            for (std::uint32_t k = 0; k < block.size; ++k)
                if (!is_finite(y[k])) return range.first + k;
            for (std::uint32_t k = 0; k < block.size; ++k) x[k] = y[k];
            return no_row;
        }
    }
    for (std::uint32_t i = range.first; i < range.end; ++i)
        if (!solve_row(task.problem, i, omega, divisors[i], task.x)) return i;
    return no_row;
}

}  // namespace

template <class T>
Result<T> run_blocks(Task<T> task) {
    T* const divisors = task.memory.template take<T>(task.size());
    const std::uint32_t blocks = task.options.blocks.empty() ? task.rows : static_cast<std::uint32_t>(task.options.blocks.size());
    return iterate(task, false, divisors, [&] {
        std::uint32_t failed = no_row;
        for (std::uint32_t block = 0; block < blocks && failed == no_row; ++block) failed = update_block(task, divisors, block_range(task, block));
        return failed;
    });
}

template Result<float> run_blocks(Task<float>);
template Result<double> run_blocks(Task<double>);

}  // namespace islet::lcp
