// Runs one scene on Islet without a screen and says what happened.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "harness/engine.hpp"
#include "harness/scene.hpp"
#include "workers/thread_pool.hpp"

namespace islet::tools {

using namespace samples;

struct RunOptions {
    std::optional<int> steps;  // the scene's own if not given; so are those that follow
    std::optional<float> dt;   // s
    std::optional<std::uint32_t> substeps, iterations, relax_iterations;  // and all below but `workers` and `hash_every`: as in SolverDef
    std::optional<JointTrees> joint_trees;
    std::optional<SweepOrder> sweep_order;
    bool block_contacts = false;  // true: whatever the scene says
    std::optional<float> shock, tolerance;
    bool measure_residual = false;
    std::uint32_t workers = 1;
    std::uint32_t lanes = 0;  // as in WorldDef
    int hash_every = 0;       // steps; 0: never
};

/// What a step did, for the CSV file and the progress bar.
struct StepRecord {
    int step = 0;            // steps taken so far
    double time = 0;         // s
    double ms = 0;           // World::step alone
    JointError joint_error;  // the largest of all joints
    std::optional<std::uint64_t> hash;
};

struct HashRecord {
    int step = 0;
    std::uint64_t hash = 0;
};

struct RunResult {
    std::string scene;
    int steps = 0;
    float dt = 0;  // s
    std::uint32_t substeps = 0, workers = 0;
    EngineCounts counts;
    std::uint64_t dropped_contacts = 0;  // summed over the steps: a pair that waits is counted each step
    std::uint32_t most_dropped_contacts = 0;  // of one step
    double ms_total = 0, ms_per_step_mean = 0, ms_per_step_max = 0;
    std::optional<float> residual;                    // m/s, after the last step, if asked for
    double max_penetration = 0;                       // m, at the end
    JointError max_joint_error;                       // at the end
    JointError worst_joint_error;                     // after any step
    double kinetic_energy = 0, potential_energy = 0;  // J, at the end
    std::size_t world_bytes = 0, snapshot_bytes = 0;
    std::uint64_t hash = 0;
    std::vector<HashRecord> hashes;
    bool has_check = true;  // of scenes in files: false
    bool checked = false;   // false: the run differed from what the scene's check expects
    std::vector<CheckLine> check;

    bool passed() const;
};

/// Points that a body's origin went through, one per step.
using Trail = std::vector<Vec2>;

/// A scene loaded into an engine and ready to run; afterwards `engine` holds the last state.
struct Run {
    ThreadPool pool;
    Scene scene;
    IsletEngine engine;
    std::vector<Trail> trails;  // of scene.traced
    std::uint32_t most_dropped_contacts = 0;  // in one step: contacts that found no room

    Run(Scene scene, const RunOptions& options);
    /// Takes all the steps, telling `observer` of each.
    RunResult run(const std::function<void(const StepRecord&)>& observer);

private:
    RunOptions options_;
    bool check_applies_ = false;
};

}  // namespace islet::tools
