// One method on one problem from one start: how the residual falls, how long that takes, and how far the velocities are from the right ones.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "methods.hpp"
#include "reference.hpp"

namespace islet::lab {

/// Natural residuals that the tables ask for, where x = 0 has 1.
inline constexpr std::array<double, 3> levels = {1e-2, 1e-4, 1e-6};

struct MeasureOptions {
    std::uint32_t iterations = 20'000;  // at most; lemke's pivots: at most ten for each row too
    std::size_t dense_rows = 800;       // newton and lemke are left out beyond
    double psor_omega = 1.3;
    double timing_seconds = 0.02;  // a solve is repeated for about so long, and the median is taken
};

/// The first iteration after which the residual was at a level.
struct LevelReached {
    std::uint32_t iterations = 0;
    double seconds = 0;         // of a solve of so many iterations that measures no residual between; 0 if the start is good enough
    double velocity_error = 0;  // reference.hpp
};

/// A point of the curve that a plot shows.
struct HistoryPoint {
    std::uint32_t iteration = 0;
    double seconds = 0;
    double residual = 0;
};

struct Measurement {
    const MethodInfo* method = nullptr;
    bool warm = false;
    std::optional<double> omega;
    std::string left_out;  // why it was not run; empty if it was
    lcp::Status status = lcp::Status::converged;
    std::uint32_t iterations = 0;
    double seconds = 0, residual = 0, velocity_error = 0;  // at the end
    std::array<std::optional<LevelReached>, levels.size()> reached;
    /// The start is iteration 0. Lemke, whose residual means nothing on its way, has the start and the end only.
    std::vector<HistoryPoint> history;
};

/// An island and everything that was measured on it.
struct IslandReport {
    Island island;
    double unit = 1;           // ScaledProblem::unit
    double warm_residual = 0;  // of the warm start, and how far its velocities are off
    double warm_error = 0;
    Reference reference;  // of the scaled problem
    std::vector<Measurement> measurements;
};

/// lcp::solve with a workspace of its own.
lcp::Result<double> run_solver(const Problem& problem, const lcp::Options<double>& options, std::vector<double>& x);

Measurement measure(const Problem& scaled, const MethodInfo& method, bool warm, const Reference& reference, const MeasureOptions& options);

/// Every point up to the hundredth, then a hundred for each factor of ten; the last one always. For files and pictures.
std::vector<HistoryPoint> thinned(const std::vector<HistoryPoint>& history);

}  // namespace islet::lab
