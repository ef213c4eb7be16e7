// The list of all scenes, and how to find one by its name.
#pragma once

#include <string>
#include <vector>

#include "harness/scene.hpp"

namespace islet::samples {

/// An entry of the catalogue.
struct SceneInfo {
    const char* name;
    const char* group;        // basics, stacks, benchmark, ...
    const char* description;  // one line
    Scene (*make)();
    Scene (*make_start)(int start) = nullptr;  // if it has several starts: start 0 to starts - 1, each for the table of `islet steady`
    int starts = 0;
};

/// All scenes, grouped, in the catalogue's order.
const std::vector<SceneInfo>& catalogue();
/// The entry of that name, or null.
const SceneInfo* find_scene(const std::string& name);

}  // namespace islet::samples
