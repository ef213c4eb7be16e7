// islet-lab: how the matrix solvers converge on the islands of real scenes. README.md says what everything means.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "common/command_line.hpp"
#include "common/finite_number.hpp"
#include "scene_files/near_names.hpp"
#include "common/output_file.hpp"
#include "common/progress.hpp"
#include "common/similar_scenes.hpp"
#include "lab.hpp"
#include "plot.hpp"
#include "report.hpp"

namespace {

using namespace islet::lab;
using islet::tools::all_printed;
using islet::tools::OutputFile;
using islet::tools::ProgressBar;
using islet::samples::SceneInfo;

enum ExitStatus { ok = 0, failed = 1, wrong_usage = 2 };

/// Those that are hard on a solver, each in its own way: height, friction, loads on light things, a long chain under tension, joints among contacts.
constexpr const char* hard_scenes[] = {"pyramid", "card_house", "mass_ratio", "chain_ball", "ragdoll_pile"};

struct Command {
    std::vector<std::string> scenes, methods;
    bool all_hard = false, json = false;
    std::string islands = "largest", csv_path, svg_prefix;
    LabOptions options;
};

int wrong(const std::string& message) {
    fmt::print(stderr, "islet-lab: {}\n", message);
    return wrong_usage;
}

int unknown(const char* what, const std::string& name, const std::vector<std::string>& near) {
    return wrong(
        fmt::format("there is no {} '{}'{}", what, name, near.empty() ? "" : fmt::format("; near names: {}", fmt::join(near, ", "))));
}

/// Appends what is not there yet.
template <class Item>
void add_once(std::vector<const Item*>& list, const Item& item) {
    if (std::find(list.begin(), list.end(), &item) == list.end()) list.push_back(&item);
}

/// The pictures of an island, PREFIX-pyramid.svg; of further islands of the scene PREFIX-pyramid-1.svg, -2.svg, ...
std::string picture_path(const std::string& prefix, const Island& island) {
    return fmt::format("{}-{}{}.svg", prefix, island.scene, island.index == 0 ? "" : fmt::format("-{}", island.index));
}

/// The scenes asked for, by pointers into the catalogue. Nothing, after a message, if one does not exist.
std::optional<std::vector<const SceneInfo*>> choose_scenes(const Command& command) {
    std::vector<const SceneInfo*> chosen;
    std::vector<std::string> names = command.scenes;
    if (command.all_hard) names.insert(names.end(), std::begin(hard_scenes), std::end(hard_scenes));
    for (const std::string& name : names) {
        const SceneInfo* info = islet::samples::find_scene(name);
        if (info == nullptr) {
            unknown("scene", name, islet::tools::similar_scenes(name));
            return std::nullopt;
        }
        add_once(chosen, *info);
    }
    return chosen;
}

std::optional<std::vector<const MethodInfo*>> choose_methods(const Command& command) {
    std::vector<const MethodInfo*> chosen;
    std::vector<std::string> known;
    for (const MethodInfo& info : methods()) {
        known.emplace_back(info.name);
        if (command.methods.empty()) chosen.push_back(&info);
    }
    for (const std::string& name : command.methods) {
        const MethodInfo* info = find_method(name);
        if (info == nullptr) {
            std::vector<std::string> near = islet::samples::near_names(name, known);
            unknown("method", name, near.empty() ? known : near);
            return std::nullopt;
        }
        add_once(chosen, *info);
    }
    return chosen;
}

/// Why a scene's first picture may not be written, before the work begins; empty if all may.
std::string picture_error(const Command& command, const std::vector<const SceneInfo*>& scenes) {
    for (const SceneInfo* info : scenes) {
        Island island;
        island.scene = info->name;
        if (const OutputFile file(picture_path(command.svg_prefix, island)); !file.good()) return file.error();
    }
    return {};
}

std::vector<IslandReport> examine_scene(const SceneInfo& info, const LabOptions& options) {
    ProgressBar steps(options.step);
    std::vector<Island> islands = take_islands(info, options, [&steps](int done) { steps.update(done); });
    steps.clear();
    int done = 0;
    ProgressBar solves(static_cast<int>(2 * options.methods.size() * islands.size()), "measurement");
    std::vector<IslandReport> reports;
    for (Island& island : islands) reports.push_back(examine(std::move(island), options, [&] { solves.update(++done); }));
    return reports;
}

int run(Command& command) {
    if (command.scenes.empty() && !command.all_hard) return wrong("name a scene, or say --all-hard");
    const auto scenes = choose_scenes(command);
    const auto chosen = choose_methods(command);
    if (!scenes || !chosen) return wrong_usage;
    command.options.methods = *chosen;
    command.options.all_islands = command.islands == "all";
    OutputFile csv(command.csv_path);
    if (!csv.good()) return wrong(csv.error());
    if (!command.svg_prefix.empty()) {
        if (!can_plot()) return wrong("--svg needs gnuplot (Debian: gnuplot-nox)");
        if (const std::string error = picture_error(command, *scenes); !error.empty()) return wrong(error);
    }

    std::vector<IslandReport> all;
    bool drawn = true;
    for (const SceneInfo* info : *scenes) {
        std::vector<IslandReport> reports = examine_scene(*info, command.options);
        if (reports.empty())
            fmt::print(stderr, "islet-lab: in {} nothing touches or is joined after step {}\n", info->name, command.options.step);
        for (IslandReport& report : reports) {
            if (!command.json) fmt::print("{}{}", all.empty() ? "" : "\n", table_of(report));
            std::fflush(stdout);  // one island after another may take long
            if (!command.svg_prefix.empty())
                drawn = run_gnuplot(plot_script(report, picture_path(command.svg_prefix, report.island))) && drawn;
            all.push_back(std::move(report));
        }
    }
    if (command.json) fmt::print("{}", json_of(all));
    if (!all_printed()) return wrong("cannot write all of the standard output");
    if (!csv.write(csv_of(all)) || !csv.close()) return wrong(csv.error());
    if (!drawn) fmt::print(stderr, "islet-lab: gnuplot could not draw all pictures\n");
    return drawn ? ok : failed;
}

void declare(CLI::App& app, Command& command) {
    LabOptions& o = command.options;
    app.add_option("scene", command.scenes, "scenes to look at");
    app.add_flag("--all-hard", command.all_hard, fmt::format("the scenes that are hard on a solver: {}", fmt::join(hard_scenes, ", ")));
    app.add_option("--step", o.step, "steps to take before looking")->check(CLI::Range(0, 100'000))->capture_default_str();
    app.add_option("--substeps", o.substeps, "substeps of a step; the scene's own if not given")->check(CLI::Range(1, 64));
    app.add_option("--substep-h", o.substep_h, "length of the substep that is solved for, s; that of the run if not given")
        ->check(CLI::Range(1e-6, 1.0))
        ->check(islet::tools::finite_number);
    app.add_option("--islands", command.islands, "which islands: the one with the most rows, or all")
        ->check(CLI::IsMember({"largest", "all"}))
        ->capture_default_str();
    app.add_option("--method", command.methods, "a method of islet::lcp, once or more; all if not given")->allow_extra_args(false);
    app.add_option("--omega", o.measure.psor_omega, "relaxation of psor")->check(CLI::Range(0.01, 1.99))->check(islet::tools::finite_number)->capture_default_str();
    app.add_option("--iterations", o.measure.iterations, "most iterations of a method")
        ->check(CLI::Range(1, 1'000'000))
        ->capture_default_str();
    app.add_option("--dense-rows", o.measure.dense_rows, "most rows for newton and lemke")
        ->check(CLI::Range(0, 5000))
        ->capture_default_str();
    app.add_flag("--json", command.json, "print a JSON list");
    app.add_option("--csv", command.csv_path, "write the curves to this file")->check(islet::tools::not_empty);
    app.add_option("--svg", command.svg_prefix, "draw the curves, a picture for each island: PREFIX-SCENE.svg")->check(islet::tools::not_empty);
}

}  // namespace

int main(int argc, char** argv) {
    Command command;
    CLI::App app("Measures how the matrix solvers of islet::lcp converge on the islands of scenes.", "islet-lab");
    declare(app, command);
    if (const std::optional<int> status = islet::tools::parse_or_explain(app, argc, argv, "islet-lab")) return *status;
    try {
        return run(command);
    } catch (const std::exception& e) { return wrong(e.what()); }
}
