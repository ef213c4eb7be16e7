// Speed side by side: whole runs of both engines in one process, taken in turns so that a noisy machine disturbs both alike.
#pragma once

#include <string>
#include <vector>

#include "engine.hpp"

namespace islet::compare {

struct Timing {
    std::string scene;
    std::string reference;
    std::string lacks;  // why the reference cannot run it; empty if it can
    int steps = 0;
    std::vector<double> islet_ms, reference_ms;  // one per run, all steps of it
    double ratio = 0;                            // median over the runs of reference / islet
};

inline constexpr int timed_runs = 3;

/// Times World::step against b2World::Step (one call of dt, 8 velocity and 3 position iterations, shapes as a user of Box2D makes them, without
/// continuous collision, which Islet has not), with the scene's scripts, without its loading. steps 0: as many as the scene has.
Timing time_both(const samples::SceneInfo& info, int steps);

std::string to_table(const std::vector<Timing>& timings);
std::string to_json(const std::vector<Timing>& timings);

}  // namespace islet::compare
