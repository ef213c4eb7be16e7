#include "runner.hpp"

#include <algorithm>
#include <utility>

#include "harness/checks.hpp"

namespace islet::tools {
bool RunResult::passed() const {
    return std::all_of(check.begin(), check.end(), [](const CheckLine& line) { return line.pass(); });
}

namespace {

// But for what only measures.
SolverDef solver_of(const Scene& scene, const RunOptions& options) {
    SolverDef def = scene.world.solver;
    def.substeps = options.substeps.value_or(def.substeps);
    def.iterations = options.iterations.value_or(def.iterations);
    def.relax_iterations = options.relax_iterations.value_or(def.relax_iterations);
    def.joint_trees = options.joint_trees.value_or(def.joint_trees);
    def.sweep_order = options.sweep_order.value_or(def.sweep_order);
    def.block_contacts = def.block_contacts || options.block_contacts;
    def.shock = options.shock.value_or(def.shock);
    def.tolerance = options.tolerance.value_or(def.tolerance);
    return def;
}

}  // namespace

Run::Run(Scene made, const RunOptions& options) : pool(options.workers), scene(std::move(made)), options_(options) {
    // A check is stated for the scene as it stands: other steps or another time step would make its numbers meaningless.
    check_applies_ = scene.check && options.steps.value_or(scene.steps) == scene.steps && options.dt.value_or(scene.dt) == scene.dt &&
                     solver_of(scene, options) == scene.world.solver;
    scene.steps = options.steps.value_or(scene.steps);
    scene.dt = options.dt.value_or(scene.dt);
    scene.world.solver = solver_of(scene, options);
    scene.world.solver.measure_residual = scene.world.solver.measure_residual || options.measure_residual;
    scene.world.lanes = options.lanes;
    scene.world.tasks = pool.tasks();
    engine.load(scene);
    trails.resize(scene.traced.size());
    for (std::size_t i = 0; i < trails.size(); ++i) trails[i].push_back(engine.body(scene.traced[i]).position);
}

RunResult Run::run(const std::function<void(const StepRecord&)>& observer) {
    RunResult result;
    for (int step = 0; step < scene.steps; ++step) {
        StepRecord record;
        record.ms = engine.advance(scene, step, scene.dt);
        record.step = step + 1;
        record.time = double(record.step) * double(scene.dt);
        result.ms_total += record.ms;
        result.ms_per_step_max = std::max(result.ms_per_step_max, record.ms);
        const std::uint32_t dropped = engine.world().report().dropped_contacts;
        result.dropped_contacts += dropped;
        most_dropped_contacts = std::max(most_dropped_contacts, dropped);
        if (options_.hash_every > 0 && record.step % options_.hash_every == 0) {
            record.hash = engine.world().hash();
            result.hashes.push_back({record.step, *record.hash});
        }
        record.joint_error = result.max_joint_error = engine.max_joint_error();
        result.worst_joint_error.linear = std::max(result.worst_joint_error.linear, result.max_joint_error.linear);
        result.worst_joint_error.angular = std::max(result.worst_joint_error.angular, result.max_joint_error.angular);
        for (std::size_t i = 0; i < trails.size(); ++i) trails[i].push_back(engine.body(scene.traced[i]).position);
        if (observer) observer(record);
    }

    result.scene = scene.name;
    result.most_dropped_contacts = most_dropped_contacts;
    result.steps = scene.steps;
    result.dt = scene.dt;
    result.substeps = scene.world.solver.substeps;
    result.workers = options_.workers;
    result.counts = engine.counts();
    result.ms_per_step_mean = scene.steps > 0 ? result.ms_total / scene.steps : 0;
    if (options_.measure_residual) result.residual = engine.world().report().residual;
    result.max_penetration = engine.max_penetration();
    result.kinetic_energy = kinetic_energy(engine);
    result.potential_energy = potential_energy(engine, scene.world.gravity);
    result.world_bytes = engine.world_bytes();
    result.snapshot_bytes = engine.snapshot_bytes();
    result.hash = engine.world().hash();
    result.has_check = static_cast<bool>(scene.check);
    result.checked = check_applies_;
    if (check_applies_) result.check = scene.check(engine);
    return result;
}

}  // namespace islet::tools
