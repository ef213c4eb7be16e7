// The golden hashes: what every scene must hash to after some steps, on every machine, by every compiler, at every width of lanes.
//
// golden.txt, beside this file, has one line per scene and checkpoint: name, steps taken, hash in 16 hex digits. Most scenes have two checkpoints,
// a near one that slow builds reach too, and a far one. No test framework here, so that bare programs can use it as well.
#pragma once

#include <algorithm>
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "harness/engine.hpp"
#include "scenes/catalogue.hpp"

namespace islet::golden {

/// golden.txt in the sources.
inline std::string file() {
    const std::string here = __FILE__;  // (<filesystem> is not to be had everywhere)
    return here.substr(0, here.find_last_of("/\\") + 1) + "golden.txt";
}

struct Checkpoint {
    int steps = 0;
    std::uint64_t hash = 0;
};

struct Entry {
    std::string scene;
    std::vector<Checkpoint> checkpoints;  // by rising steps
};

using Table = std::vector<Entry>;

inline std::string hex(std::uint64_t hash) {
    char text[17];
    std::snprintf(text, sizeof text, "%016" PRIx64, hash);
    return text;
}

/// The table in a file; empty if there is none.
inline Table read(const std::string& path) {
    Table table;
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string scene, hash;
        Checkpoint checkpoint;
        if (!(words >> scene) || scene[0] == '#' || !(words >> checkpoint.steps >> hash)) continue;
        checkpoint.hash = std::strtoull(hash.c_str(), nullptr, 16);
        if (table.empty() || table.back().scene != scene) table.push_back({scene, {}});
        table.back().checkpoints.push_back(checkpoint);
    }
    return table;
}

inline bool write(const std::string& path, const Table& table) {
    std::ofstream file(path);
    file << "# scene, steps, hash of the world after them. Rewritten when ISLET_UPDATE_GOLDEN=1; compared by golden_test and matrix.sh.\n";
    for (const Entry& entry : table)
        for (const Checkpoint& c : entry.checkpoints) file << entry.scene << ' ' << c.steps << ' ' << hex(c.hash) << '\n';
    return file.good();
}

/// The steps at which a scene is hashed: what the table says, or for a scene it does not know, a near and a far point of its run.
inline std::vector<Checkpoint> checkpoints_of(const Table& table, const samples::SceneInfo& info) {
    for (const Entry& entry : table)
        if (entry.scene == info.name) return entry.checkpoints;
    // Large scenes take 10 to 30 ms a step: their far point is chosen so that the first impacts are past. Those of the group steady are many, run for
    // minutes, and consist of what other scenes have too: so many steps of so many bodies are enough.
    const bool large = std::string(info.group) == "benchmark";
    const samples::Scene scene = info.make();
    int most = large ? 110 : 1200;
    if (std::string(info.group) == "steady") most = std::clamp(20'000 / static_cast<int>(scene.bodies.size()), 10, 300);
    const int far = std::min(scene.steps, most), near = std::min(far, large ? 10 : 60);
    std::vector<Checkpoint> points = {{near, 0}};
    if (far > near) points.push_back({far, 0});
    return points;
}

/// Runs a scene and fills in the hash at each checkpoint with at most `most_steps` steps; those beyond are left out. The hash of a
/// world that is not sound (World::validate) is taken for 0.
inline std::vector<Checkpoint> run(const samples::SceneInfo& info, const std::vector<Checkpoint>& points, std::uint32_t lanes,
                                   int most_steps, const TaskSystem& tasks = {}) {
    if (points.empty() || points.front().steps > most_steps) return {};  // a large scene takes long to make, where processors are emulated
    samples::Scene scene = info.make();
    scene.world.lanes = lanes;
    scene.world.tasks = tasks;
    samples::IsletEngine engine;
    engine.load(scene);
    std::vector<Checkpoint> seen;
    int step = 0;
    for (const Checkpoint& point : points) {
        if (point.steps > most_steps) break;
        for (; step < point.steps; ++step) engine.advance(scene, step, scene.dt);
        seen.push_back({point.steps, engine.world().validate() == nullptr ? engine.world().hash() : 0});
    }
    return seen;
}

}  // namespace islet::golden
