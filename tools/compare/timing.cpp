#include "timing.hpp"

#include <chrono>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "common/statistics.hpp"
#include "engines/box2d_engine.hpp"

namespace islet::compare {

using namespace engines;
using tools::median;

namespace {

double run_ms(samples::Engine& engine, const samples::SceneInfo& info, int steps) {
    const samples::Scene scene = info.make();
    engine.load(scene);
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < steps; ++i) engine.advance(scene, i, scene.dt);
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

Timing time_both(const samples::SceneInfo& info, int steps) {
    const samples::Scene scene = info.make();
    Timing timing;
    timing.scene = info.name;
    timing.steps = steps > 0 ? steps : scene.steps;
    timing.lacks = box2d_lacks_even_nearest(scene);
    timing.reference = Box2dEngine().name();
    if (!timing.lacks.empty()) return timing;

    std::vector<double> ratios;
    for (int run = 0; run < timed_runs; ++run) {
        samples::IsletEngine islet;
        timing.islet_ms.push_back(run_ms(islet, info, timing.steps));
        Box2dEngine reference({.skin = Skin::outside, .continuous = false, .nearest = true});
        timing.reference_ms.push_back(run_ms(reference, info, timing.steps));
        ratios.push_back(timing.reference_ms.back() / timing.islet_ms.back());
    }
    timing.ratio = median(ratios);
    return timing;
}

std::string to_table(const std::vector<Timing>& timings) {
    std::string out =
        fmt::format("{:<16} {:>5} {:>12} {:>12} {:>8}   ratio of each run\n", "scene", "steps", "islet ms", "reference ms", "ratio");
    for (const Timing& t : timings) {
        if (!t.lacks.empty()) {
            out += fmt::format("{:<16} not timed: {}\n", t.scene, t.lacks);
            continue;
        }
        out += fmt::format("{:<16} {:>5} {:>12.1f} {:>12.1f} {:>8.2f}  ", t.scene, t.steps, median(t.islet_ms), median(t.reference_ms),
                           t.ratio);
        for (std::size_t i = 0; i < t.islet_ms.size(); ++i) out += fmt::format(" {:.2f}", t.reference_ms[i] / t.islet_ms[i]);
        out += "\n";
    }
    return out;
}

std::string to_json(const std::vector<Timing>& timings) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Timing& t : timings) {
        nlohmann::ordered_json object = {{"scene", t.scene}, {"reference", t.reference}};
        if (t.lacks.empty()) {
            object["steps"] = t.steps;
            object["ms_total"] = {{"islet", t.islet_ms}, {"reference", t.reference_ms}};
            object["ratio"] = t.ratio;
        } else {
            object["unsupported"] = t.lacks;
        }
        list.push_back(object);
    }
    return list.dump(2) + "\n";
}

}  // namespace islet::compare
