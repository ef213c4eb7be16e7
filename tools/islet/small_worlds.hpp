// Small worlds, of the kind that a phone or a microcontroller steps: how many instructions a step takes. The counts do not depend on how busy the machine is.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "harness/scene.hpp"

namespace islet::tools {

struct SmallWorld {
    const char* name;
    samples::Scene (*make)();  // never sleeps, and has no scripts
};

/// All of them, in the order of the table.
const std::vector<SmallWorld>& small_worlds();
/// The world of that name, or null.
const SmallWorld* find_small_world(const std::string& name);
/// Steps the world and returns the median time of a step, s. Lanes: 0 picks the widest.
double step_small_world(const SmallWorld& world, int steps, std::uint32_t lanes);

/// What a step of one world takes.
struct SmallResult {
    std::string world;
    std::uint32_t lanes = 1;
    std::optional<std::uint64_t> instructions;  // none if they could not be counted
    double us = 0;                              // microseconds; 0 if instructions were counted
};

struct SmallOptions {
    std::vector<const SmallWorld*> worlds;
    std::string program;  // this program, which valgrind runs for a world with --small-world; empty: no instructions are counted, the steps are timed
};

/// The lanes that are compared: one, and the widest that this build, the processor and callgrind have.
std::vector<std::uint32_t> compared_lanes();
/// Whether valgrind can be run.
bool has_valgrind();
/// Each world with each of the compared lanes. `ended` is told each result.
std::vector<SmallResult> measure_small_worlds(const SmallOptions& options, const std::function<void(const SmallResult&)>& ended);

std::string small_header(bool counts);
std::string small_row(const SmallResult& result);
std::string json_of(const std::vector<SmallResult>& results);

}  // namespace islet::tools
