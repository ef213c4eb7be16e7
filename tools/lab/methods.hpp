// The methods by their names, and the settings that each is measured with.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problem.hpp"

namespace islet::lab {

struct MethodInfo {
    const char* name;
    lcp::Method method;
    bool dense;  // needs rows * rows numbers and rows^3 time
};

/// All of islet::lcp, in its order.
const std::vector<MethodInfo>& methods();
/// Null if there is none of that name.
const MethodInfo* find_method(const std::string& name);

/// The relaxation that a method is measured with, nothing for those that know none. psor's is `psor_omega`; jacobi's is made of the largest eigenvalue
/// of the scaled matrix: see jacobi_omega; the others' is 1.
std::optional<double> omega_of(const MethodInfo& method, const Problem& scaled, double psor_omega);

/// 1.8 divided by the largest eigenvalue of M (whose diagonal is 1), by power iteration; at most 1. Jacobi diverges from 2 on.
double jacobi_omega(const Problem& scaled);

}  // namespace islet::lab
