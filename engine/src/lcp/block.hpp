// The complementarity problem of a few rows, solved exactly.
#pragma once

#include "../lcp/rows.hpp"

namespace islet::lcp {

/// The problem of one block's rows, with all other rows held. `friction` names rows within the block; a friction row whose normal row is outside has ordinary
/// bounds here.
template <class T>
struct Block {
    std::uint32_t size;
    T a[max_block_rows][max_block_rows];
    T b[max_block_rows];
    T lo[max_block_rows];
    T hi[max_block_rows];  // for a friction row its coefficient
    std::uint32_t friction[max_block_rows];
};

/// Starts from y and leaves the solution in it. Returns false if it finds none: there is none, or the equations of the free rows have no unique solution.
template <class T>
bool solve_block(const Block<T>& block, T* y);

}  // namespace islet::lcp
