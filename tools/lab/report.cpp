#include "report.hpp"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace islet::lab {
namespace {

using Json = nlohmann::ordered_json;

std::string start_of(const Measurement& m) { return m.warm ? "warm" : "cold"; }

/// Three digits are more than a clock deserves.
std::string ms(double seconds) {
    const double value = seconds * 1e3;
    return value == 0    ? "0"
           : value < 0.1 ? fmt::format("{:.4f}", value)
           : value < 10  ? fmt::format("{:.3f}", value)
                         : fmt::format("{:.1f}", value);
}

std::string error(double value) { return value == 0 ? "0" : fmt::format("{:.1e}", value); }

/// 1e-2: no digit more than it needs.
std::string short_level(double level) { return fmt::format("1e{:.0f}", std::log10(level)); }

/// The columns of one measurement, "-" where a level was not reached.
std::string row_of(const Measurement& m) {
    std::string iterations, times, errors;
    for (const auto& level : m.reached) {
        iterations += fmt::format("{:>7}", level ? fmt::format("{}", level->iterations) : "-");
        times += fmt::format("{:>8}", level ? ms(level->seconds) : "-");
        errors += fmt::format("{:>9}", level ? error(level->velocity_error) : "-");
    }
    const bool usual = m.status == lcp::Status::converged || m.status == lcp::Status::iteration_limit;
    return fmt::format("{}  {}  {}  {:>6} {:>9} {:>9}{}", iterations, times, errors, m.iterations, error(m.residual),
                       error(m.velocity_error), usual ? "" : fmt::format("  {}", lcp::describe(m.status)));
}

/// Of the iterations from zero, those that the warm start spares. "-" where one of the two did not get there, or zero is there already.
std::string saving(const std::optional<LevelReached>& cold, const std::optional<LevelReached>& warm) {
    if (!cold || !warm || cold->iterations == 0) return "-";
    return fmt::format("{:.0f}%", 100 * (1 - double(warm->iterations) / double(cold->iterations)));
}

std::string saving_row(const Measurement& cold, const Measurement& warm) {
    std::string text;
    for (std::size_t level = 0; level < levels.size(); ++level)
        text += fmt::format("{:>7}", saving(cold.reached[level], warm.reached[level]));
    return text;
}

/// JSON has no infinity and no NaN: they become null.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json object_of(const IslandReport& report, const Measurement& m) {
    const Island& island = report.island;
    Json object = {
        {"scene", island.scene},
        {"step", island.step},
        {"h", island.h},
        {"island", island.index},
        {"bodies", island.bodies},
        {"contacts", island.contacts},
        {"joints", island.joints},
        {"rows", island.problem.rows()},
        {"entries", island.problem.entries()},
        {"unit", report.unit},
        {"reference",
         {{"how", report.reference.how}, {"residual", number(report.reference.residual)}, {"exact", report.reference.exact()}}},
        {"method", m.method->name},
        {"omega", m.omega ? Json(*m.omega) : Json(nullptr)},
        {"start", start_of(m)},
    };
    if (!m.left_out.empty()) {
        object["left_out"] = m.left_out;
        return object;
    }
    object["status"] = lcp::describe(m.status);
    object["iterations"] = m.iterations;
    object["seconds"] = m.seconds;
    object["residual"] = number(m.residual);
    object["velocity_error"] = number(m.velocity_error);
    Json list = Json::array();
    for (std::size_t i = 0; i < levels.size(); ++i) {
        Json level = {{"residual", levels[i]}, {"iterations", nullptr}, {"seconds", nullptr}, {"velocity_error", nullptr}};
        if (m.reached[i]) {
            level["iterations"] = m.reached[i]->iterations;
            level["seconds"] = m.reached[i]->seconds;
            level["velocity_error"] = number(m.reached[i]->velocity_error);
        }
        list.push_back(std::move(level));
    }
    object["levels"] = std::move(list);
    return object;
}

}  // namespace

std::string label_of(const Measurement& m) { return m.omega ? fmt::format("{} {:.2g}", m.method->name, *m.omega) : m.method->name; }

std::string table_of(const IslandReport& report) {
    const Island& island = report.island;
    std::string text =
        fmt::format("{} after step {}, island {}: {} bodies, {} contacts, {} joints; {} rows, {} entries; substep of {:.4g} ms\n",
                    island.scene, island.step, island.index, island.bodies, island.contacts, island.joints, island.problem.rows(),
                    island.problem.entries(), 1e3 * island.h);
    text += fmt::format("  residual 1 is that of x = 0: {:.4g} sqrt(kg) m/s; the warm start has {}, its velocities are off by {}\n",
                        report.unit, error(report.warm_residual), error(report.warm_error));
    text += fmt::format("  {} answer: {}, residual {}\n", report.reference.exact() ? "exact" : "best known (not exact)",
                        report.reference.how, error(report.reference.residual));
    text +=
        fmt::format("  {:<16} {:<5} {:>21}  {:>24}  {:>27}  {:>26}\n", "", "", "iterations to", "ms", "velocities off by", "at the end");
    text += fmt::format("  {:<16} {:<5}", "method", "start");
    for (const int width : {7, 8, 9}) {
        for (const double level : levels) text += fmt::format("{:>{}}", short_level(level), width);
        text += "  ";
    }
    text += fmt::format("{:>6} {:>9} {:>9}\n", "iter.", "residual", "off by");
    const Measurement* cold = nullptr;
    for (const Measurement& m : report.measurements) {
        const bool second = m.warm && cold != nullptr && cold->method == m.method;
        text += fmt::format("  {:<16} ", second ? "" : label_of(m));
        if (!m.left_out.empty()) {
            text += fmt::format("{:<5} left out: {}\n", start_of(m), m.left_out);
            continue;
        }
        text += fmt::format("{:<5}{}\n", start_of(m), row_of(m));
        if (second) text += fmt::format("  {:<16} {:<5}{}\n", "", "saves", saving_row(*cold, m));
        cold = m.warm ? nullptr : &m;
    }
    return text;
}

std::string json_of(const std::vector<IslandReport>& reports) {
    Json list = Json::array();
    for (const IslandReport& report : reports) {
        for (const Measurement& m : report.measurements) list.push_back(object_of(report, m));
    }
    return list.dump(2) + "\n";
}

std::string csv_of(const std::vector<IslandReport>& reports) {
    std::string text = "scene,island,method,start,iteration,seconds,residual\n";
    for (const IslandReport& report : reports) {
        for (const Measurement& m : report.measurements) {
            for (const HistoryPoint& p : thinned(m.history)) {
                text += fmt::format("{},{},{},{},{},{:.4g},{:.6g}\n", report.island.scene, report.island.index, m.method->name, start_of(m),
                                    p.iteration, p.seconds, p.residual);
            }
        }
    }
    return text;
}

}  // namespace islet::lab
