// The rules of a solver's definition.
#pragma once

#include "../data/core.hpp"

namespace islet::detail {

/// True if every number is in its range and this program has the parts that the definition asks for. Else `error` says what is wrong.
bool check_solver(const SolverDef& def, Error& error);

}  // namespace islet::detail
