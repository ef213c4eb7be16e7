#include "lab.hpp"

#include "islands.hpp"
#include "islet/runner.hpp"

namespace islet::lab {

std::vector<Island> take_islands(const samples::SceneInfo& info, const LabOptions& options, const std::function<void(int done)>& stepped) {
    tools::RunOptions run_options;
    run_options.steps = options.step;
    run_options.substeps = options.substeps;
    tools::Run run(info.make(), run_options);
    run.run([&stepped](const tools::StepRecord& record) { stepped(record.step); });
    const double h = options.substep_h.value_or(double(run.scene.dt) / double(run.scene.world.solver.substeps));
    std::vector<Island> islands = islands_of(run.engine.world(), static_cast<float>(h));
    if (!options.all_islands && islands.size() > 1) islands.resize(1);
    for (Island& island : islands) {
        island.scene = info.name;
        island.step = options.step;
    }
    return islands;
}

IslandReport examine(Island island, const LabOptions& options, const std::function<void()>& measured) {
    const ScaledProblem scaled = scale(island.problem);
    IslandReport report;
    report.unit = scaled.unit;
    report.reference = find_reference(scaled.problem, options.measure.dense_rows);
    report.warm_residual = residual_of(scaled.problem, scaled.problem.warm);
    report.warm_error = velocity_error(scaled.problem, scaled.problem.warm, report.reference);
    report.island = std::move(island);
    for (const MethodInfo* method : options.methods) {
        for (const bool warm : {false, true}) {
            report.measurements.push_back(measure(scaled.problem, *method, warm, report.reference, options.measure));
            measured();
        }
    }
    return report;
}

}  // namespace islet::lab
