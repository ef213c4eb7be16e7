#include "compare_report.hpp"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace islet::compare {

namespace {

constexpr Side islet_side = &Sample::islet, reference_side = &Sample::reference;

/// Both engines' value of a quantity.
template <class Quantity>
nlohmann::ordered_json both(const Run& run, Quantity quantity) {
    return {{"islet", quantity(run, islet_side)}, {"reference", quantity(run, reference_side)}};
}

nlohmann::ordered_json to_object(const Comparison& c) {
    nlohmann::ordered_json object = {{"scene", c.scene}, {"reference", c.reference}};
    if (!c.lacks.empty()) {
        object["unsupported"] = c.lacks;
        return object;
    }
    const Run& run = c.run;
    object["steps"] = run.last().step;
    object["rms_position"] = run.rms_position;
    object["max_position"] = run.max_position;
    object["rms_angle"] = run.rms_angle;
    object["first_divergence_step"] = run.first_divergence_step ? nlohmann::ordered_json(*run.first_divergence_step) : nullptr;
    object["final_rms_position"] = run.last().apart.rms_position;
    object["penetration"] = both(run, deepest_penetration);
    object["energy_drift"] = both(run, energy_drift);
    object["tolerance"] = nlohmann::ordered_json::object();
    object["judged"] = nlohmann::ordered_json::object();
    for (const Check& check : c.checks) {
        object["tolerance"][check.name] = check.limit;
        object["judged"][check.name] = check.value;
    }
    object["pass"] = c.pass();
    object["short"] = c.is_short();
    return object;
}

}  // namespace

std::string to_table(const std::vector<Comparison>& comparisons) {
    std::string out = fmt::format("{:<16} {:>5} {:>9} {:>9} {:>9} {:>8} {:>9} {:>8} {:>8} {:>9} {:>9}  {}\n", "scene", "steps", "rms pos",
                                  "max pos", "rms angle", "diverges", "final rms", "pen", "pen ref", "energy", "en. ref", "result");
    std::size_t passed = 0, fell_short = 0, compared = 0;
    for (const Comparison& c : comparisons) {
        if (!c.lacks.empty()) {
            out += fmt::format("{:<16} not compared: {}\n", c.scene, c.lacks);
            continue;
        }
        const Run& run = c.run;
        const std::string diverges = run.first_divergence_step ? std::to_string(*run.first_divergence_step) : "never";
        out += fmt::format("{:<16} {:>5} {:>9.4f} {:>9.4f} {:>9.4f} {:>8} {:>9.4f} {:>8.4f} {:>8.4f} {:>9.4f} {:>9.4f}  {}\n", c.scene,
                           run.last().step, run.rms_position, run.max_position, run.rms_angle, diverges, run.last().apart.rms_position,
                           deepest_penetration(run, islet_side), deepest_penetration(run, reference_side), energy_drift(run, islet_side),
                           energy_drift(run, reference_side), !c.pass() ? "FAIL" : c.is_short() ? "short" : "pass");
        for (const Check& check : c.checks) {
            if (!check.is_short()) continue;
            out += fmt::format("    {} is {:.5g}, more than {:.5g}", check.name, check.value, check.limit);
            out += check.pass() ? fmt::format(": known, up to {:.5g}\n", check.known) : "\n";
        }
        ++compared;
        if (c.pass() && !c.is_short()) ++passed;
        if (c.pass() && c.is_short()) ++fell_short;
    }
    out += fmt::format("{} of {} scenes agree with {}", passed, compared, comparisons.empty() ? "" : comparisons.front().reference);
    return out + (fell_short == 0 ? "\n" : fmt::format("; {} fall short of what a user would accept, as is known\n", fell_short));
}

std::string to_json(const std::vector<Comparison>& comparisons) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Comparison& c : comparisons) list.push_back(to_object(c));
    return list.dump(2) + "\n";
}

std::string to_csv(const std::vector<Comparison>& comparisons) {
    std::string out =
        "scene,step,rms_position,max_position,rms_angle,energy_islet,energy_reference,penetration_islet,penetration_reference,mean_height_"
        "islet,"
        "mean_height_reference\n";
    for (const Comparison& c : comparisons) {
        for (const Sample& s : c.run.samples) {
            out += fmt::format("{},{},{:.6g},{:.6g},{:.6g},{:.8g},{:.8g},{:.6g},{:.6g},{:.8g},{:.8g}\n", c.scene, s.step,
                               s.apart.rms_position, s.apart.max_position, s.apart.rms_angle, s.islet.energy, s.reference.energy,
                               s.islet.penetration, s.reference.penetration, s.islet.mean_height, s.reference.mean_height);
        }
    }
    return out;
}

}  // namespace islet::compare
