// A scene in the laboratory: run it, take its islands, measure every method on each.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "harness/scene.hpp"
#include "measure.hpp"
#include "scenes/catalogue.hpp"

namespace islet::lab {

struct LabOptions {
    int step = 300;                         // steps to take before the islands are looked at
    std::optional<std::uint32_t> substeps;  // of the run; the scene's own if not given
    std::optional<double> substep_h;        // s, of the problems; a step's dt divided by its substeps if not given
    bool all_islands = false;               // else the one with the most rows
    std::vector<const MethodInfo*> methods;
    MeasureOptions measure;
};

/// Runs the scene. `stepped` hears of each step.
std::vector<Island> take_islands(const samples::SceneInfo& info, const LabOptions& options, const std::function<void(int done)>& stepped);

/// Every method from zero and from the warm start. `measured` hears of each measurement.
IslandReport examine(Island island, const LabOptions& options, const std::function<void()>& measured);

}  // namespace islet::lab
