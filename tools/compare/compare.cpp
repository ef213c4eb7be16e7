#include "compare.hpp"

#include <algorithm>

#include "compare_report.hpp"
#include "engines/box2d_engine.hpp"

namespace islet::compare {

using namespace engines;

Comparison compare_scene(const samples::SceneInfo& info, const Tolerance& tolerance, int steps, std::string* svg) {
    samples::IsletEngine islet;
    Box2dEngine reference({.substeps = reference_substeps});
    const samples::Scene scene = info.make();

    Comparison result;
    result.scene = info.name;
    result.reference = reference.name();
    result.lacks = box2d_lacks(scene);
    if (!result.lacks.empty()) return result;

    if (steps <= 0) steps = tolerance.steps > 0 ? tolerance.steps : scene.steps;
    const int horizon = tolerance.horizon > 0 ? std::min(tolerance.horizon, steps) : steps;
    result.run = run_both(islet, reference, info.make, steps, horizon);
    result.checks = judge(result.run, tolerance);
    if (svg != nullptr) *svg = to_svg(scene, islet, reference, steps);
    return result;
}

}  // namespace islet::compare
