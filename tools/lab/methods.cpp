#include "methods.hpp"

#include <algorithm>
#include <cmath>

#include "scenes/random.hpp"

namespace islet::lab {

const std::vector<MethodInfo>& methods() {
    using lcp::Method;
    static const std::vector<MethodInfo> list = {
        {"pgs", Method::pgs, false},
        {"psor", Method::psor, false},
        {"symmetric_pgs", Method::symmetric_pgs, false},
        {"red_black", Method::red_black, false},
        {"block_pgs", Method::block_pgs, false},
        {"jacobi", Method::jacobi, false},
        {"l1_jacobi", Method::l1_jacobi, false},
        {"nncg", Method::nncg, false},
        {"newton", Method::newton, true},
        {"lemke", Method::lemke, true},
    };
    return list;
}

const MethodInfo* find_method(const std::string& name) {
    for (const MethodInfo& info : methods())
        if (name == info.name) return &info;
    return nullptr;
}

std::optional<double> omega_of(const MethodInfo& method, const Problem& scaled, double psor_omega) {
    switch (method.method) {
    case lcp::Method::psor: return psor_omega;
    case lcp::Method::jacobi: return jacobi_omega(scaled);
    default: return std::nullopt;
    }
}

double jacobi_omega(const Problem& scaled) {
    constexpr int iterations = 200;
    samples::Random random(1);
    std::vector<double> x(scaled.rows());
    for (double& v : x) v = double(random.uniform(-1, 1));
    double eigenvalue = 0;
    for (int i = 0; i < iterations; ++i) {
        double square = 0;
        for (const double v : x) square += v * v;
        if (!(square > 0)) break;
        for (double& v : x) v /= std::sqrt(square);
        std::vector<double> next = row_values(scaled, x, false);
        eigenvalue = 0;
        for (std::size_t k = 0; k < x.size(); ++k) eigenvalue += x[k] * next[k];
        x = std::move(next);
    }
    return eigenvalue > 1.8 ? 1.8 / eigenvalue : 1.0;
}

}  // namespace islet::lab
