#include "judge.hpp"

#include <algorithm>
#include <cmath>

namespace islet::compare {

std::vector<Check> judge(const Run& run, const Tolerance& t) {
    constexpr Side islet = &Sample::islet, reference = &Sample::reference;
    const State& a = run.last().islet;
    const State& b = run.last().reference;
    std::vector<Check> checks;
    const auto check = [&](const char* name, double value, double limit, double known = not_judged) {
        if (limit >= 0) checks.push_back({name, value, limit, known});
    };
    check("rms_position", run.rms_position, t.rms_position);
    check("max_position", run.max_position, t.max_position);
    check("rms_angle", run.rms_angle, t.rms_angle);
    check("final_rms_position", run.last().apart.rms_position, t.final_rms_position);
    check("mean_height", std::abs(a.mean_height - b.mean_height), t.mean_height);
    check("top_height", std::abs(a.top_height - b.top_height), t.top_height);
    check("at_rest", std::abs(a.at_rest - b.at_rest), t.at_rest);
    check("energy_drift", std::abs(energy_drift(run, islet) - energy_drift(run, reference)), t.energy_drift);
    check("energy_gain", energy_gain(run, islet), t.energy_gain, t.known_energy_gain);
    check("momentum_drift", momentum_drift(run, islet), t.momentum_drift);
    check("penetration", deepest_penetration(run, islet) - deepest_penetration(run, reference), t.penetration, t.known_penetration);
    return checks;
}

bool Comparison::pass() const {
    return !lacks.empty() || std::all_of(checks.begin(), checks.end(), [](const Check& c) { return c.pass(); });
}

bool Comparison::is_short() const {
    return std::any_of(checks.begin(), checks.end(), [](const Check& c) { return c.is_short(); });
}

const Tolerance* find_tolerance(const std::string& scene) {
    for (const Tolerance& t : tolerances()) {
        if (scene == t.scene) return &t;
    }
    return nullptr;
}

}  // namespace islet::compare
