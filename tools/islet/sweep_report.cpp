// The table of a sweep: what is printed, as text, JSON and CSV.
#include "sweep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "common/hash_text.hpp"
#include "scene_files/printable.hpp"

namespace islet::tools {
namespace {

using Json = nlohmann::ordered_json;

/// FNV-1a over the bytes of hashes, lowest first.
class HashOfHashes {
public:
    void add(std::uint64_t hash) {
        for (int i = 0; i < 8; ++i) sum_ = (sum_ ^ (hash >> (8 * i) & 255)) * 1099511628211u;
    }
    std::uint64_t sum() const { return sum_; }

private:
    std::uint64_t sum_ = 14695981039346656037u;
};

void add(SweepFigure& figure, double value) {
    if (std::isnan(value)) return;
    figure.least = figure.count == 0 ? value : std::min(figure.least, value);
    figure.most = figure.count == 0 ? value : std::max(figure.most, value);
    figure.mean += value;  // the sum, so far
    ++figure.count;
}

Json json_or_null(const SweepFigure& figure, double value) { return figure.count > 0 ? Json(value) : Json(nullptr); }

std::string figure_text(const SweepFigure& figure) {
    return figure.count == 0 ? "-" : fmt::format("{:.4g} ({:.4g} to {:.4g})", figure.mean, figure.least, figure.most);
}

}  // namespace

SweepTable tabulate(const SweepPart& whole) {
    SweepTable table;
    HashOfHashes all;
    for (std::uint64_t p = 0; p < whole.sweep.points(); ++p) {
        SweepPoint point;
        const std::vector<std::size_t> places = whole.sweep.places(p);
        for (std::size_t i = 0; i < places.size(); ++i) point.values.push_back(whole.sweep.axes[i].values[places[i]]);
        HashOfHashes hashes;
        for (std::uint64_t seed = 0; seed < whole.sweep.seeds; ++seed) {
            const SweepRun& run = whole.runs[static_cast<std::size_t>(p * whole.sweep.seeds + seed)];
            hashes.add(run.hash);
            all.add(run.hash);
            for (std::size_t m = 0; m < measure_count; ++m) add(point.figures[m], run.values[m]);
        }
        for (SweepFigure& figure : point.figures) figure.mean /= static_cast<double>(std::max<std::uint64_t>(figure.count, 1));
        point.hash = hashes.sum();
        table.points.push_back(std::move(point));
    }
    table.hash = all.sum();
    return table;
}

std::string table_of(const Sweep& sweep, const SweepTable& table) {
    // What no run has needs no column.
    std::vector<std::size_t> shown;
    for (std::size_t m = 0; m < measure_count; ++m)
        if (std::any_of(table.points.begin(), table.points.end(),
                        [m](const SweepPoint& p) { return p.figures[m].count > 0 && (p.figures[m].most != 0 || m < 4); }))
            shown.push_back(m);
    std::vector<std::vector<std::string>> rows(1);
    for (const SweepAxis& axis : sweep.axes) rows[0].push_back(axis.name);
    for (const std::size_t m : shown) rows[0].push_back(fmt::format("{}, {}", measures[m].name, measures[m].unit));
    rows[0].emplace_back("asleep");
    rows[0].emplace_back("hash");
    for (const SweepPoint& point : table.points) {
        std::vector<std::string> row;
        for (std::size_t i = 0; i < point.values.size(); ++i) row.push_back(value_text(sweep.axes[i].name, point.values[i], 6));
        for (const std::size_t m : shown) row.push_back(figure_text(point.figures[m]));
        row.push_back(fmt::format("{}", point.figures[static_cast<std::size_t>(Measure::sleep_time)].count));
        row.push_back(hash_text(point.hash));
        rows.push_back(std::move(row));
    }
    std::vector<std::size_t> widths(rows[0].size());
    for (const auto& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
    std::string text;
    for (const auto& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i) line += fmt::format("{}{:<{}}", i == 0 ? "" : "  ", row[i], widths[i]);
        text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    }
    return text + fmt::format("{}: {} runs ({} points, {} seeds); mean (smallest to largest); hash of all {}\n", printable(sweep.scene), sweep.runs(),
                              sweep.points(), sweep.seeds, hash_text(table.hash));
}

std::string json_of(const Sweep& sweep, const SweepTable& table) {
    Json points = Json::array();
    for (const SweepPoint& point : table.points) {
        Json row = Json::object();
        for (std::size_t i = 0; i < point.values.size(); ++i) {
            const std::string& name = sweep.axes[i].name;
            row[name] = value_names(name) != nullptr ? Json(value_text(name, point.values[i])) : Json(point.values[i]);
        }
        for (std::size_t m = 0; m < measure_count; ++m) {
            const SweepFigure& f = point.figures[m];
            row[measures[m].name] = {
                {"count", f.count}, {"min", json_or_null(f, f.least)}, {"mean", json_or_null(f, f.mean)}, {"max", json_or_null(f, f.most)}};
        }
        row["hash"] = hash_text(point.hash);
        points.push_back(std::move(row));
    }
    const Json json = {{"scene", sweep.scene}, {"seeds", sweep.seeds}, {"runs", sweep.runs()},
                       {"nudge", sweep.nudge}, {"points", points},     {"hash", hash_text(table.hash)}};
    return json.dump(2) + "\n";
}

std::string csv_of(const SweepPart& part) {
    std::string text = "run";
    for (const SweepAxis& axis : part.sweep.axes) text += "," + axis.name;
    text += ",seed";
    for (const MeasureInfo& measure : measures) text += fmt::format(",{}", measure.name);
    text += ",hash\n";
    for (const SweepRun& run : part.runs) {
        text += fmt::format("{}", run.index);
        const std::vector<std::size_t> places = part.sweep.places(run.index / part.sweep.seeds);
        for (std::size_t i = 0; i < places.size(); ++i) text += "," + value_text(part.sweep.axes[i].name, part.sweep.axes[i].values[places[i]]);
        text += fmt::format(",{}", run.index % part.sweep.seeds);
        for (const double value : run.values) text += std::isnan(value) ? "," : fmt::format(",{}", value);
        text += "," + hash_text(run.hash) + "\n";
    }
    return text;
}

}  // namespace islet::tools
