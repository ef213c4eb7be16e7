// Speed side by side: whole runs of both engines in one process, taken in turns so that a noisy machine disturbs both alike.
#pragma once

#include <string>
#include <vector>

#include "harness/engine.hpp"
#include "scenes/catalogue.hpp"

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

/// Times World::step against b2World::Step, scripts included and loading not. Box2D makes one step of dt with 8 velocity and 3 position
/// iterations, with shapes as its users make them, the nearest it has for capsules, rounded
/// polygons and hinge springs (box2d_nearest.hpp), and without continuous collision, which Islet has not (README.md says why that is kinder).
/// steps 0: as many as the scene has.
Timing time_both(const samples::SceneInfo& info, int steps);

std::string to_table(const std::vector<Timing>& timings);
std::string to_json(const std::vector<Timing>& timings);

}  // namespace islet::compare
