// Checks the arguments. Nothing else in this folder checks them again.
#pragma once

#include "islet/lcp.hpp"

namespace islet::lcp {

struct Verdict {
    Status status = Status::converged;  // converged: nothing wrong
    std::uint32_t row = no_row;

    bool good() const { return status == Status::converged; }
};

template <class T>
Verdict check(const Problem<T>& problem, std::span<const T> x);

template <class T>
Verdict check(const Options<T>& options, std::size_t rows);

}  // namespace islet::lcp
