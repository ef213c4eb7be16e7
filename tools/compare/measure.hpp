// How far two engines drift apart on one scene, and what each keeps while it runs. README.md says each quantity in words.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "harness/engine.hpp"

namespace islet::compare {

/// What one engine's world is like at one moment. Only dynamic bodies count.
struct State {
    double energy = 0;       // J, kinetic and potential
    double kinetic = 0;      // J
    Vec2 momentum;           // kg m/s
    double mean_height = 0;  // m, of the centres of mass, against gravity (along y where there is none)
    double top_height = 0;   // m, the highest centre of mass
    double low_height = 0;   // m, the lowest one
    double at_rest = 0;      // share of the bodies that sleep or move slower than rest_speed and rest_spin
    double penetration = 0;  // m, deepest overlap as the engine sees it
    double weight = 0;       // N, of all together
};

inline constexpr float rest_speed = 0.05f;  // m/s
inline constexpr float rest_spin = 0.1f;    // rad/s

State measure(const samples::Engine& engine, const samples::Scene& scene);

/// How far apart the same bodies are in two engines at one moment.
struct Apart {
    double rms_position = 0;  // m, of the centres of mass
    double max_position = 0;  // m
    double rms_angle = 0;     // rad, each difference taken the short way round
    std::size_t bodies = 0;   // dynamic ones alive in both
};

Apart measure_apart(const samples::Engine& a, const samples::Engine& b);

/// One step of a run.
struct Sample {
    int step = 0;  // 0 before the first
    State islet, reference;
    Apart apart;
};

/// What a run of both engines showed.
struct Run {
    std::vector<Sample> samples;  // steps + 1 of them

    // Over the first `horizon` steps.
    double rms_position = 0;  // m
    double max_position = 0;  // m
    double rms_angle = 0;     // rad

    std::optional<int> first_divergence_step;  // the first step where two bodies are further apart than divergence_distance
    double energy_scale = 0;                   // J, what energy drifts are shares of

    const Sample& first() const { return samples.front(); }
    const Sample& last() const { return samples.back(); }
};

inline constexpr double divergence_distance = 0.02;  // m, two slops of each engine

/// Loads the scene into both engines and runs them side by side. Scripts of the scene run in each.
Run run_both(samples::Engine& islet, samples::Engine& reference, const std::function<samples::Scene()>& make, int steps, int horizon);

/// One of the two states of a sample.
using Side = State Sample::*;

double deepest_penetration(const Run& run, Side side);
/// (energy at the end - energy at the start) / energy_scale.
double energy_drift(const Run& run, Side side);
/// The most that energy ever stood above its start, / energy_scale.
double energy_gain(const Run& run, Side side);
/// |momentum at the end - at the start| / the largest momentum seen, 0 if nothing moved.
double momentum_drift(const Run& run, Side side);

}  // namespace islet::compare
