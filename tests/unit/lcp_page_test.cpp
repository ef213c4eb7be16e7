// The figures of docs/lcp.md: its example, a tower of three boxes with a fourth above it, by every method.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include <islet/lcp.hpp>

namespace islet::lcp {
namespace {

constexpr float matrix[] = {1, -1, 0, 0, -1, 2, -1, 0, 0, -1, 2, -1, 0, 0, -1, 2};
constexpr std::uint32_t two_gaps[] = {0, 2};

struct Row {
    Method method;
    float omega;
    std::uint32_t iterations, again;  // from zero, and then at 1.01 m/s
    std::size_t bytes;
};

std::uint32_t iterations_of(const Row& row, float speed, float (&x)[4]) {
    const float q[] = {-speed, 0, 0, 1.5f};
    std::vector<std::byte> memory(workspace_bytes<float>(row.method, 4));
    Options<float> options = {.method = row.method, .tolerance = 1e-5f, .omega = row.omega};
    if (row.method == Method::block_pgs) options.blocks = two_gaps;
    const Result<float> result = solve<float>({.dense = {matrix}, .q = q}, options, x, memory);
    EXPECT_EQ(result.status, Status::converged);
    return result.iterations;
}

TEST(LcpPage, EveryMethodTakesTheIterationsAndBytesOfTheTable) {
    for (const Row& row : {Row{Method::pgs, 1, 39, 23, 20}, Row{Method::psor, 1.4f, 14, 9, 20}, Row{Method::symmetric_pgs, 1, 32, 19, 20},
                           Row{Method::red_black, 1, 39, 23, 20}, Row{Method::block_pgs, 1, 17, 10, 20}, Row{Method::jacobi, 0.9f, 86, 50, 36},
                           Row{Method::l1_jacobi, 1, 158, 92, 36}, Row{Method::nncg, 1, 15, 9, 52}, Row{Method::newton, 1, 1, 1, 228},
                           Row{Method::lemke, 1, 4, 4, 252}}) {
        SCOPED_TRACE(static_cast<int>(row.method));
        float x[4] = {};
        EXPECT_EQ(iterations_of(row, 1, x), row.iterations);
        EXPECT_EQ(iterations_of(row, 1.01f, x), row.again);
        EXPECT_EQ(workspace_bytes<float>(row.method, 4), row.bytes);
    }
}

TEST(LcpPage, BeyondTheBestOmegaItSoonGetsWorse) {
    float x[4] = {}, y[4] = {};
    EXPECT_EQ(iterations_of({Method::psor, 1.7f, 0, 0, 0}, 1, x), 34u);
    EXPECT_EQ(iterations_of({Method::psor, 1.9f, 0, 0, 0}, 1, y), 108u);
}

TEST(LcpPage, TheResidualFallsAsTheTableOfSweepsSays) {
    const float q[] = {-1, 0, 0, 1.5f};
    float x[4] = {}, history[40] = {};
    std::byte memory[workspace_bytes<float>(Method::pgs, 4)];
    solve<float>({.dense = {matrix}, .q = q}, {.max_iterations = 40, .tolerance = 0, .history = history}, x, memory);
    const struct {
        std::size_t sweep;
        float residual;
    } rows[] = {{1, 0.50f}, {2, 0.38f}, {3, 0.28f}, {10, 0.038f}, {20, 0.0021f}, {40, 6.7e-6f}};
    // Two digits are printed.
    for (const auto& row : rows) EXPECT_NEAR(history[row.sweep - 1], row.residual, 0.05f * row.residual) << row.sweep;
}

TEST(LcpPage, WithBoxesOfAGramTheResidualFallsAsItsTableSays) {
    float light[16];
    for (int i = 0; i < 16; ++i) light[i] = 1000 * matrix[i];
    const float q[] = {-1, 0, 0, 1.5f};
    float x[4] = {}, history[10] = {};
    std::byte memory[workspace_bytes<float>(Method::pgs, 4)];
    solve<float>({.dense = {light}, .q = q}, {.max_iterations = 10, .tolerance = 0, .history = history}, x, memory);
    EXPECT_NEAR(history[0], 0.50f, 0.005f);
    EXPECT_NEAR(history[4], 0.16f, 0.005f);
    EXPECT_NEAR(history[9], 0.038f, 0.0005f);
}

}  // namespace
}  // namespace islet::lcp
