// Times scenes in one engine after another, in turns within one process, so that a noisy machine disturbs all alike.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "common/statistics.hpp"
#include "engines/registry.hpp"
#include "harness/scene.hpp"
#include "scenes/catalogue.hpp"

namespace islet::tools {

using namespace samples;

struct BenchOptions {
    std::vector<const SceneInfo*> scenes;
    std::vector<const engines::EngineInfo*> engines;
    std::optional<int> steps;   // the scene's own if not given
    std::optional<int> most_steps;  // of a scene's own
    int repeat = 3;                         // runs of each engine, at least 1
    std::vector<std::uint32_t> workers{1};  // engines that have workers run once with each of these; the others have one thread
};

/// What the stages of Islet's steps took, summed over a run.
struct BenchProfile {
    double pairs = 0, collide = 0, islands = 0, solve = 0, finish = 0;  // ms
};

/// One run of one scene in one engine, from a fresh world.
struct BenchRun {
    std::vector<double> step_ms;  // the engine's own step alone, scripts left out
    std::size_t bodies = 0;       // after the last step
    std::size_t contacts = 0;     // after the last step, as the engine counts them
    std::optional<BenchProfile> profile;  // if the engine tells it
};

/// What the runs of an engine come to.
struct BenchResult {
    std::string engine, scene;
    std::string lacks;  // why the engine cannot build the scene: a sentence, and nothing below holds; else empty
    std::uint32_t workers = 1;
    int steps = 0;
    std::size_t bodies = 0, contacts = 0;
    double ms_total = 0, ms_per_step_p50 = 0, ms_per_step_p99 = 0;  // each the median over the runs
    std::optional<BenchProfile> profile;  // each stage the median over the runs
    std::optional<double> ratio;  // median over the turns of its time by Islet's (with the first number of workers); none if Islet was not timed
};

double total_ms(const BenchRun& run);
/// Fills in the numbers: medians over `runs`, and against `reference`, which has as many runs in the same turns, or is empty.
void summarise(const std::vector<BenchRun>& runs, const std::vector<BenchRun>& reference, BenchResult& result);

/// What is told while the bench is at work.
struct BenchObserver {
    std::function<void(int done, int total)> stepped;      // after each step: how many were taken of how many
    std::function<void(const BenchResult&)> ended = {};    // each result when it is known: at the end of its scene
    std::function<bool()> is_stopped = {};                 // asked after each step; then what whole runs there are is all there will be
};

/// Scene by scene, each with its engines in the order asked for.
std::vector<BenchResult> bench(const BenchOptions& options, const BenchObserver& observer);
/// How long that will take, s, as far as loading each scene into each engine and a few steps tell. 0 if that would take about as long as the bench.
double estimate_seconds(const BenchOptions& options);

/// The table of results, line by line: as wide as the names of what is to come.
class BenchTable {
public:
    BenchTable(const std::vector<std::string>& scenes, const std::vector<std::string>& engines);
    std::string header() const;
    std::string row(const BenchResult& result);

private:
    std::string names(const std::string& scene, const std::string& engine) const;

    std::size_t scene_width_ = 5, engine_width_ = 6;
    std::string last_scene_;
};

std::string table_of(const std::vector<BenchResult>& results);
std::string json_of(const std::vector<BenchResult>& results);

}  // namespace islet::tools
