// Solves a complementarity problem without a world. A tower of three boxes of 1 kg falls at 1 m/s and has just reached the ground. A fourth box, above
// the tower, moves up. Which impulses stop the fall? docs/lcp.md shows the solution sweep by sweep.
#include <cstdio>

#include <islet/lcp.hpp>

using namespace islet;

int main() {
    const float m[] = {1, -1, 0, 0, -1, 2, -1, 0, 0, -1, 2, -1, 0, 0, -1, 2};  // row i: how the impulses change the speed of gap i
    const float q[] = {-1, 0, 0, 1.5f};  // m/s at which each gap opens before the impulses: ground to first box, first to second, ...
    float x[4] = {};                     // the impulses to find: x >= 0, w = m x + q >= 0, x w = 0
    std::byte memory[lcp::workspace_bytes<float>(lcp::Method::pgs, 4)];

    const lcp::Problem<float> problem = {.dense = {m}, .q = q};
    const lcp::Result<float> result = lcp::solve_by_sweeps<float>(problem, {.tolerance = 1e-5f}, x, memory);

    std::printf("%u sweeps. %s\n", result.iterations, lcp::describe(result.status));
    for (int i = 0; i < 4; ++i) {
        float w = q[i];  // m/s at which the gap opens after the impulses
        for (int j = 0; j < 4; ++j) w += m[4 * i + j] * x[j];
        std::printf("gap %d: impulse %.4f kg m/s, opens at %.4f m/s: %s\n", i, double(x[i]), double(w), x[i] > 0 ? "pushes" : "parts");
        if (x[i] < 0 || w < -1e-4f || x[i] * w > 1e-4f) return 1;
    }
}
