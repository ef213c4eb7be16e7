#include "report.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "common/hash_text.hpp"
#include "scene_files/printable.hpp"
#include "scene_files/short_number.hpp"
#include "harness/checks.hpp"
#include "scenes/catalogue.hpp"

namespace islet::tools {
namespace {

using Json = nlohmann::ordered_json;

/// JSON has no infinity and no NaN: they become null.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

std::string bytes(std::size_t count) {
    const double n = double(count);
    return count < 10'000       ? fmt::format("{} B", count)
           : count < 10'000'000 ? fmt::format("{:.1f} kB", n / 1e3)
                                : fmt::format("{:.1f} MB", n / 1e6);
}

std::string bounds(const CheckLine& line) {
    if (line.low == line.high) return fmt::format("= {:.6g}", line.low);
    if (line.low == 0) return fmt::format("<= {:.6g}", line.high);
    return fmt::format("{:.6g} to {:.6g}", line.low, line.high);
}

std::string check_table(const std::vector<CheckLine>& check) {
    std::size_t widest = 0;
    for (const CheckLine& line : check) widest = std::max(widest, line.what.size());
    std::string text;
    for (const CheckLine& line : check) {
        text += fmt::format("  {}  {:<{}}  {:>12.6g}   {}\n", line.pass() ? "PASS" : "FAIL", line.what, widest, line.value, bounds(line));
    }
    return text;
}

}  // namespace

std::string table_of(const RunResult& r) {
    std::string text;
    const auto row = [&text](const char* label, const std::string& value) { text += fmt::format("  {:<14}{}\n", label, value); };
    text += fmt::format("{}\n", printable(r.scene));
    row("run", fmt::format("{} steps of {:.6g} s, {} substeps, {} {}", r.steps, r.dt, r.substeps, r.workers,
                           r.workers == 1 ? "worker" : "workers"));
    const std::string islands = r.steps > 0 ? fmt::format(" in {} {}", r.counts.islands, r.counts.islands == 1 ? "island" : "islands") : "";
    row("bodies", fmt::format("{} ({} awake{}), {} shapes", r.counts.bodies, r.counts.awake_bodies, islands, r.counts.shapes));
    row("contacts", fmt::format("{}, {} dropped", r.counts.contacts, r.dropped_contacts));
    if (r.counts.joints > 0 || r.worst_joint_error.linear > 0) {
        row("joints",
            fmt::format("{}, off by {:.3g} m and {:.3g} rad at most, in the whole run by {:.3g} m and {:.3g} rad", r.counts.joints,
                        r.max_joint_error.linear, r.max_joint_error.angular, r.worst_joint_error.linear, r.worst_joint_error.angular));
    }
    if (r.residual) row("residual", fmt::format("{:.3g} m/s after the last step", *r.residual));
    row("overlap", fmt::format("{:.3g} m at most", r.max_penetration));
    row("energy", fmt::format("{:.6g} J kinetic, {:.6g} J potential", r.kinetic_energy, r.potential_energy));
    row("time", fmt::format("{:.3f} ms a step, {:.3f} at most, {:.1f} in all", r.ms_per_step_mean, r.ms_per_step_max, r.ms_total));
    row("memory", fmt::format("{}, of which a snapshot holds {}", bytes(r.world_bytes), bytes(r.snapshot_bytes)));
    row("hash", hash_text(r.hash));
    for (const HashRecord& h : r.hashes) row("", fmt::format("{} after step {}", hash_text(h.hash), h.step));
    if (!r.has_check) return text;
    if (!r.checked) return text + "check skipped: it holds for the scene's own steps, dt and solver\n";
    return text + fmt::format("check {}\n", r.passed() ? "passed" : "FAILED") + check_table(r.check);
}

std::string json_of(const RunResult& r) {
    Json json = {
        {"scene", r.scene},
        {"steps", r.steps},
        {"dt", short_number(r.dt)},
        {"substeps", r.substeps},
        {"workers", r.workers},
        {"bodies", r.counts.bodies},
        {"shapes", r.counts.shapes},
        {"joints", r.counts.joints},
        {"contacts", r.counts.contacts},
        {"islands", r.counts.islands},
        {"awake_bodies", r.counts.awake_bodies},
        {"dropped_contacts", r.dropped_contacts},
        {"ms_total", r.ms_total},
        {"ms_per_step_mean", r.ms_per_step_mean},
        {"ms_per_step_max", r.ms_per_step_max},
        {"max_penetration", number(r.max_penetration)},
        {"max_joint_error", number(double(r.max_joint_error.linear))},
        {"max_joint_angle_error", number(double(r.max_joint_error.angular))},
        {"worst_joint_error", number(double(r.worst_joint_error.linear))},
        {"worst_joint_angle_error", number(double(r.worst_joint_error.angular))},
        {"kinetic_energy", number(r.kinetic_energy)},
        {"potential_energy", number(r.potential_energy)},
        {"world_bytes", r.world_bytes},
        {"snapshot_bytes", r.snapshot_bytes},
        {"hash", hash_text(r.hash)},
    };
    if (r.residual) json["residual"] = number(double(*r.residual));
    if (!r.hashes.empty()) {
        Json hashes = Json::array();
        for (const HashRecord& h : r.hashes) hashes.push_back({{"step", h.step}, {"hash", hash_text(h.hash)}});
        json["hashes"] = std::move(hashes);
    }
    Json check = Json::array();
    for (const CheckLine& line : r.check) {
        check.push_back(
            {{"what", line.what}, {"value", number(line.value)}, {"low", line.low}, {"high", line.high}, {"pass", line.pass()}});
    }
    json["check"] = std::move(check);
    return json.dump(2) + "\n";
}

std::string csv_header() {
    return "step,time,ms,bodies,awake_bodies,contacts,islands,dropped_contacts,kinetic_energy,potential_energy,max_penetration,joints,max_"
           "joint_error,max_joint_angle_error,hash\n";
}

std::string csv_line(const StepRecord& record, const Run& run) {
    const EngineCounts counts = run.engine.counts();
    return fmt::format("{},{:.9g},{:.6f},{},{},{},{},{},{:.9g},{:.9g},{:.6g},{},{:.6g},{:.6g},{}\n", record.step, record.time, record.ms,
                       counts.bodies, counts.awake_bodies, counts.contacts, counts.islands, run.engine.world().report().dropped_contacts,
                       kinetic_energy(run.engine), potential_energy(run.engine, run.scene.world.gravity), run.engine.max_penetration(),
                       counts.joints, record.joint_error.linear, record.joint_error.angular, record.hash ? hash_text(*record.hash) : "");
}

std::string catalogue_table() {
    std::size_t widest = 0;
    for (const SceneInfo& info : catalogue()) widest = std::max(widest, std::string(info.name).size());
    std::string text, group;
    for (const SceneInfo& info : catalogue()) {
        if (group != info.group) {
            text += fmt::format("{}{}\n", group.empty() ? "" : "\n", info.group);
            group = info.group;
        }
        text += fmt::format("  {:<{}}  {}\n", info.name, widest, info.description);
    }
    return text;
}

std::string catalogue_json() {
    Json list = Json::array();
    for (const SceneInfo& info : catalogue())
        list.push_back({{"name", info.name}, {"group", info.group}, {"description", info.description}, {"starts", std::max(1, info.starts)}});
    return list.dump(2) + "\n";
}

}  // namespace islet::tools
