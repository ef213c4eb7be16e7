// Parts of a sweep in files, and how they are put together.
#include "sweep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "common/hash_text.hpp"
#include "islet/version.hpp"

namespace islet::tools {
namespace {

using Json = nlohmann::ordered_json;

constexpr int manifest_format = 1;

Json number_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json sweep_json(const Sweep& sweep) {
    Json axes = Json::array();
    for (const SweepAxis& axis : sweep.axes) axes.push_back({{"name", axis.name}, {"values", axis.values}});
    return {{"scene", sweep.scene},
            {"fingerprint", hash_text(sweep.fingerprint)},
            {"start", sweep.start ? Json(*sweep.start) : Json(nullptr)},
            {"steps", sweep.steps ? Json(*sweep.steps) : Json(nullptr)},
            {"nudge", sweep.nudge},
            {"seeds", sweep.seeds},
            {"vary", axes}};
}

std::uint64_t hash_in(const Json& text) {
    const std::string digits = text.get<std::string>();
    if (digits.size() != 16 || digits.find_first_not_of("0123456789abcdef") != std::string::npos) throw SweepError("a hash has 16 hexadecimal digits");
    return std::stoull(digits, nullptr, 16);
}

Sweep sweep_in(const Json& json) {
    Sweep sweep;
    sweep.scene = json.at("scene").get<std::string>();
    sweep.fingerprint = hash_in(json.at("fingerprint"));
    if (!json.at("start").is_null()) sweep.start = json.at("start").get<int>();
    if (!json.at("steps").is_null()) sweep.steps = json.at("steps").get<int>();
    sweep.nudge = json.at("nudge").get<double>();
    sweep.seeds = json.at("seeds").get<std::uint64_t>();
    double runs = static_cast<double>(sweep.seeds);
    for (const Json& axis : json.at("vary")) {
        sweep.axes.push_back({axis.at("name").get<std::string>(), axis.at("values").get<std::vector<double>>()});
        runs *= static_cast<double>(sweep.axes.back().values.size());
    }
    if (!(runs >= 1 && runs <= 1e7)) throw SweepError("it has no runs, or more than 10000000");
    return sweep;
}

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

bool same(const SweepRun& a, const SweepRun& b) {
    return a.hash == b.hash && a.dropped_contacts == b.dropped_contacts &&
           std::equal(a.values.begin(), a.values.end(), b.values.begin(), [](double x, double y) { return same(x, y); });
}

}  // namespace

std::string manifest_of(const SweepPart& part) {
    Json runs = Json::array();
    for (const SweepRun& run : part.runs) {
        Json row = {{"run", run.index}, {"hash", hash_text(run.hash)}, {"dropped_contacts", run.dropped_contacts}};
        for (std::size_t i = 0; i < measure_count; ++i) row[measures[i].name] = number_or_null(run.values[i]);
        runs.push_back(std::move(row));
    }
    const Json json = {{"islet_sweep", manifest_format}, {"version", ISLET_VERSION_STRING}, {"sweep", sweep_json(part.sweep)}, {"runs", runs}};
    return json.dump(1) + "\n";
}

SweepPart read_manifest(const std::string& text) {
    try {
        const Json json = Json::parse(text);
        if (!json.is_object() || !json.contains("islet_sweep")) throw SweepError("this is no manifest of a sweep");
        if (json.at("islet_sweep") != manifest_format)
            throw SweepError(
                fmt::format("this is a manifest of format {}; Islet {} reads format {}", json.at("islet_sweep").dump(), ISLET_VERSION_STRING, manifest_format));
        SweepPart part;
        part.sweep = sweep_in(json.at("sweep"));
        const std::uint64_t count = part.sweep.runs();
        for (const Json& row : json.at("runs")) {
            SweepRun run;
            run.index = row.at("run").get<std::uint64_t>();
            if (run.index >= count) throw SweepError(fmt::format("it has a run {}, of {} in all", run.index, count));
            run.hash = hash_in(row.at("hash"));
            run.dropped_contacts = row.at("dropped_contacts").get<std::uint64_t>();
            for (std::size_t i = 0; i < measure_count; ++i) {
                const Json& value = row.at(measures[i].name);
                run.values[i] = value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
            }
            part.runs.push_back(run);
        }
        return part;
    } catch (const Json::exception& error) { throw SweepError(fmt::format("this is no whole manifest of a sweep: {}", error.what())); }
}

SweepPart merge(const std::vector<SweepPart>& parts, const std::vector<std::string>& names) {
    SweepPart whole;
    whole.sweep = parts.at(0).sweep;
    const std::size_t count = static_cast<std::size_t>(whole.sweep.runs());
    std::vector<const SweepRun*> found(count);
    std::vector<std::size_t> from(count);
    for (std::size_t p = 0; p < parts.size(); ++p) {
        if (sweep_json(parts[p].sweep) != sweep_json(whole.sweep)) throw SweepError(fmt::format("'{}' and '{}' are of two sweeps", names[0], names[p]));
        for (const SweepRun& run : parts[p].runs) {
            const SweepRun*& slot = found[static_cast<std::size_t>(run.index)];
            if (slot != nullptr && !same(*slot, run))
                throw SweepError(fmt::format("'{}' and '{}' differ in run {}: hash {} and {}", names[from[static_cast<std::size_t>(run.index)]], names[p],
                                             run.index, hash_text(slot->hash), hash_text(run.hash)));
            slot = &run;
            from[static_cast<std::size_t>(run.index)] = p;
        }
    }
    const auto missing = static_cast<std::size_t>(std::count(found.begin(), found.end(), nullptr));
    if (missing != 0)
        throw SweepError(
            fmt::format("{} of {} runs are missing, the first is {}", missing, count, std::find(found.begin(), found.end(), nullptr) - found.begin()));
    for (const SweepRun* run : found) whole.runs.push_back(*run);
    return whole;
}

}  // namespace islet::tools
