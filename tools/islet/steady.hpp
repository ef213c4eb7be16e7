// The table of how steady the engine is: each scene that has several starts, run from each of them, and the worst of each line that says what is wanted.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engines/registry.hpp"
#include "harness/scene.hpp"
#include "scenes/catalogue.hpp"

namespace islet::tools {

using namespace samples;

struct SteadyOptions {
    std::vector<const SceneInfo*> scenes;             // each with starts
    std::vector<const engines::EngineInfo*> engines;  // the first one is judged, and runs the benchmark scenes alone
    int most_starts = 1 << 30;                        // of each scene: its first ones
    unsigned jobs = 1;                                // runs at a time
};

/// What an engine came to in one row.
struct SteadyValue {
    bool is_known = false;  // false: the engine cannot build the scene, or it takes too long there
    double worst = 0;       // of all starts; of a line that counts, how many failed
    int failed = 0;         // starts in which the line broke its scene's check
};

/// A line of a scene's check, over all starts.
struct SteadyRow {
    std::string scene, what;
    int starts = 0;  // that have the line
    Wanted wanted;
    std::vector<SteadyValue> engines;                                         // in the order of the options
    bool is_reached() const { return engines.front().worst <= wanted.most; }  // NaN is not
};

struct SteadyTable {
    std::vector<std::string> engines;
    std::vector<SteadyRow> rows;
    std::vector<std::string> broken;  // lines of checks that the judged engine broke, each with its scene and start
};

/// The scenes that have several starts, in the catalogue's order.
std::vector<const SceneInfo*> scenes_with_starts();
/// Runs everything; `progress` is told how many of how many runs are done, from one thread at a time.
SteadyTable run_steady(const SteadyOptions& options, const std::function<void(int done, int total)>& progress);

std::string table_of(const SteadyTable& table);
std::string json_of(const SteadyTable& table);

}  // namespace islet::tools
