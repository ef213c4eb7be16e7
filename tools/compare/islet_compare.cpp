// islet-compare: the same scenes in Islet and in Box2D 2.4, and whether the two agree. README.md says what everything means.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <unistd.h>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "common/command_line.hpp"
#include "common/output_file.hpp"
#include "common/similar_scenes.hpp"
#include "compare.hpp"
#include "compare_report.hpp"
#include "timing.hpp"

namespace {

using namespace islet::compare;
using islet::tools::OutputFile;
using islet::samples::SceneInfo;

enum Status { ok = 0, check_failed = 1, wrong_usage = 2 };

struct Options {
    std::vector<std::string> scenes;
    bool all = false, time = false, json = false;
    int steps = 0;
    std::string csv, svg;
};

/// Picture of one scene among several: pictures/all.svg -> pictures/all-hello.svg.
std::string picture_path(const std::string& path, const std::string& scene, bool several) {
    if (path.empty() || !several) return path;
    const std::filesystem::path p(path);
    return (p.parent_path() / (p.stem().string() + "-" + scene + p.extension().string())).string();
}

void progress(const std::string& scene, std::size_t done, std::size_t total) {
    if (isatty(STDERR_FILENO) != 0) fmt::print(stderr, "\r\033[K{}/{} {}", done + 1, total, scene);
}

void end_progress() {
    if (isatty(STDERR_FILENO) != 0) fmt::print(stderr, "\r\033[K");
}

/// The scenes asked for; nothing (and a message) if one does not exist or cannot be judged.
std::optional<std::vector<const SceneInfo*>> choose(const Options& options) {
    std::vector<const SceneInfo*> chosen;
    if (options.all || (options.time && options.scenes.empty())) {
        for (const SceneInfo& info : islet::samples::catalogue()) {
            const bool benchmark = std::string(info.group) == "benchmark";
            if (options.time ? benchmark : find_tolerance(info.name) != nullptr) chosen.push_back(&info);
        }
    }
    for (const std::string& name : options.scenes) {
        const SceneInfo* info = islet::samples::find_scene(name);
        if (info == nullptr) {
            fmt::print(stderr, "islet-compare: there is no scene \"{}\"", name);
            const auto near = islet::tools::similar_scenes(name);
            if (!near.empty()) fmt::print(stderr, "; near names: {}", fmt::join(near, ", "));
            fmt::print(stderr, "\n");
            return std::nullopt;
        }
        if (!options.time && find_tolerance(name) == nullptr) {
            fmt::print(stderr, "islet-compare: no tolerance is stated for \"{}\" (tools/compare/tolerances.cpp)\n", name);
            return std::nullopt;
        }
        if (std::find(chosen.begin(), chosen.end(), info) == chosen.end()) chosen.push_back(info);
    }
    return chosen;
}

int run_timing(const Options& options, const std::vector<const SceneInfo*>& scenes) {
    std::vector<Timing> timings;
    for (const SceneInfo* info : scenes) {
        progress(info->name, timings.size(), scenes.size());
        timings.push_back(time_both(*info, options.steps));
    }
    end_progress();
    fmt::print("{}", options.json ? to_json(timings) : to_table(timings));
    return ok;
}

int run_comparison(const Options& options, const std::vector<const SceneInfo*>& scenes) {
    OutputFile csv(options.csv);
    std::vector<OutputFile> pictures;
    for (const SceneInfo* info : scenes) pictures.emplace_back(picture_path(options.svg, info->name, scenes.size() > 1));
    const auto has_failed = [](const OutputFile& file) {
        if (!file.error().empty()) fmt::print(stderr, "islet-compare: {}\n", file.error());
        return !file.error().empty();
    };
    if (has_failed(csv) || std::any_of(pictures.begin(), pictures.end(), has_failed)) return wrong_usage;

    std::vector<Comparison> comparisons;
    bool pass = true;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        progress(scenes[i]->name, i, scenes.size());
        std::string picture;
        comparisons.push_back(compare_scene(*scenes[i], *find_tolerance(scenes[i]->name), options.steps, &picture));
        pass = pass && comparisons.back().pass();
        pictures[i].write(picture);
        pictures[i].close();
    }
    end_progress();
    csv.write(to_csv(comparisons));
    csv.close();
    fmt::print("{}", options.json ? to_json(comparisons) : to_table(comparisons));
    std::fflush(stdout);
    const auto unwritten = std::count_if(pictures.begin(), pictures.end(), has_failed) + (has_failed(csv) ? 1 : 0);  // each says so
    return pass && unwritten == 0 ? ok : check_failed;
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App app("Runs scenes in Islet and in Box2D 2.4 and says how far they agree.", "islet-compare");
    app.add_option("SCENE", options.scenes, "Scenes to compare");
    app.add_flag("--all", options.all, "Every comparable scene");
    app.add_flag("--time", options.time, "Compare speed instead: whole runs in turns, median of 3 ratios (default: the benchmark scenes)");
    app.add_option("--steps", options.steps, "Run this many steps instead of the scene's own")->check(CLI::Range(1, 1000000));
    app.add_flag("--json", options.json, "Print JSON instead of a table");
    app.add_option("--csv", options.csv, "Write one line per scene and step to this file")->check(islet::tools::not_empty);
    app.add_option("--svg", options.svg, "Write a picture of both final states to this file (one per scene if there are several)")->check(islet::tools::not_empty);
    if (const std::optional<int> status = islet::tools::parse_or_explain(app, argc, argv, "islet-compare")) return *status;
    if (options.scenes.empty() && !options.all && !options.time) {
        fmt::print(stderr, "islet-compare: name a scene, or say --all\n{}", app.help());
        return wrong_usage;
    }

    const auto scenes = choose(options);
    if (!scenes) return wrong_usage;
    try {
        return options.time ? run_timing(options, *scenes) : run_comparison(options, *scenes);
    } catch (const std::exception& e) {
        fmt::print(stderr, "islet-compare: {}\n", e.what());
        return check_failed;
    }
}
