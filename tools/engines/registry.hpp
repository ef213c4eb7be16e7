// Every engine that this build can load a scene into, Islet first. README.md says how each is set up.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "harness/engine.hpp"

namespace islet::engines {

struct EngineInfo {
    const char* name;                             // short and without spaces, as a command line names it
    std::string (*lacks)(const samples::Scene&);  // why it cannot build the scene: a sentence; empty if it can
    std::unique_ptr<samples::Engine> (*make)();   // set up as its users have it
    std::unique_ptr<samples::Engine> (*make_exact)() = nullptr;  // the same, but shapes are as large as the scene says, and fast bodies are followed if it can
    bool has_workers = false;                                    // it steps with as many workers as the scene's world has
};

const std::vector<EngineInfo>& registry();
/// The entry of that name, or null.
const EngineInfo* find_engine(const std::string& name);

}  // namespace islet::engines
