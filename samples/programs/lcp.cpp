// A complementarity problem solved by itself, without a world: three boxes of 1 kg stand on each other and fall at 1 m/s for a moment, a fourth above
// them is on its way up. Which impulses stop the fall? docs/lcp.md goes through it sweep by sweep.
#include <cstdio>

#include <islet/lcp.hpp>

using namespace islet;

int main() {
    const float m[] = {1, -1, 0, 0, -1, 2, -1, 0, 0, -1, 2, -1, 0, 0, -1, 2};  // what a unit of each impulse does to each gap
    const float q[] = {-1, 0, 0, 1.5f};  // how fast each gap opens without any: ground to first box, first to second, ...
    float x[4] = {};                     // the impulses, to be found: x >= 0, w = m x + q >= 0, x w = 0
    std::byte memory[lcp::workspace_bytes<float>(lcp::Method::pgs, 4)];

    const lcp::Problem<float> problem = {.dense = {m}, .q = q};
    const lcp::Result<float> result = lcp::solve_by_sweeps<float>(problem, {.tolerance = 1e-5f}, x, memory);

    std::printf("%u sweeps. %s\n", result.iterations, lcp::describe(result.status));
    for (int i = 0; i < 4; ++i) {
        float w = q[i];  // how fast the gap opens now
        for (int j = 0; j < 4; ++j) w += m[4 * i + j] * x[j];
        std::printf("gap %d: impulse %.4f kg m/s, opens at %.4f m/s: %s\n", i, double(x[i]), double(w), x[i] > 0 ? "pushes" : "parts");
        if (x[i] < 0 || w < -1e-4f || x[i] * w > 1e-4f) return 1;
    }
}
