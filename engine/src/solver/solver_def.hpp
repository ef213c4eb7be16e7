// What the definition of a solver must keep.
#pragma once

#include "../data/core.hpp"

namespace islet::detail {

/// True if every number is in its range and this program has what the definition asks for; else `error` says what is wrong.
bool check_solver(const SolverDef& def, Error& error);

}  // namespace islet::detail
