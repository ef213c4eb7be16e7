// The headless runner: lists the scenes, runs one, prints what happened, and says by its exit status whether the scene's check passed. Or it
// times scenes, in Islet and in other engines, runs those that show how steady an engine is from all their starts, or sweeps a scene over parameters.
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "bench.hpp"
#include "common/command_line.hpp"
#include "common/finite_number.hpp"
#include "common/output_file.hpp"
#include "common/progress.hpp"
#include "common/read_file.hpp"
#include "common/similar_scenes.hpp"
#include "harness/world_recording.hpp"
#include "html.hpp"
#include "replay_file.hpp"
#include "report.hpp"
#include "runner.hpp"
#include "scene_files/printable.hpp"
#include "scene_files/scene_file.hpp"
#include "small_worlds.hpp"
#include "steady.hpp"
#include "svg.hpp"
#include "sweep.hpp"
#include "sweep_cluster.hpp"
#include "worker_span.hpp"

namespace {

using namespace islet::tools;

enum ExitStatus { ok = 0, check_failed = 1, wrong_usage = 2, interrupted = 130 };

struct RunCommand {
    std::string scene, csv_path, svg_path, html_path, recording_path;
    std::vector<std::string> draw;  // names of layers
    std::optional<int> start;       // of a scene that has several
    RunOptions options;
    std::uint64_t memory_limit = islet::tools::usual_memory_limit;
    bool json = false;
};

struct ReplayCommand {
    std::string path;
    std::uint64_t memory_limit = islet::tools::usual_memory_limit;
    std::uint64_t until = ~std::uint64_t{0};
    std::uint32_t lanes = 0;
};

struct BenchCommand {
    std::vector<std::string> scenes, engines;
    BenchOptions options;
    bool json = false, quick = false, small = false, span = false;
    bool has_workers = false;  // numbers of workers were given
    std::string small_world;   // the one to step, for valgrind
    std::uint32_t lanes = 0;   // of that one
};

struct SteadyCommand {
    std::vector<std::string> scenes, engines;
    std::optional<int> starts;
    unsigned jobs = 0;
    bool json = false, quick = false;
};

struct SweepCommand {
    Sweep sweep;
    std::vector<std::string> vary, merge;  // axes; files
    std::string csv_path, plot_path, manifest_path, scheduler;
    std::uint64_t shards = 1, shard = 0;
    std::uint32_t jobs = 0;
    std::uint64_t memory_limit = islet::tools::usual_memory_limit;
    bool json = false;
};

int wrong(const std::string& message) {
    fmt::print(stderr, "islet: {}\n", printable(message));
    return wrong_usage;
}

int unknown_scene(const std::string& name) {
    const std::vector<std::string> similar = similar_scenes(name);
    if (similar.empty()) return wrong(fmt::format("there is no scene '{}'; `islet list` shows them all", name));
    return wrong(fmt::format("there is no scene '{}'; near names: {}", name, fmt::join(similar, ", ")));
}

using islet::DebugDraw;

/// What can be drawn besides shapes, by its name on the command line.
const std::map<std::string, void (*)(DebugDraw&)> layers = {
    {"shapes", [](DebugDraw&) {}},
    {"joints", [](DebugDraw& d) { d.joints = true; }},
    {"contacts", [](DebugDraw& d) { d.contacts = true; }},
    {"normals", [](DebugDraw& d) { d.normals = true; }},
    {"impulses", [](DebugDraw& d) { d.impulses = true; }},
    {"boxes", [](DebugDraw& d) { d.boxes = true; }},
    {"fat-boxes", [](DebugDraw& d) { d.fat_boxes = true; }},
    {"tree", [](DebugDraw& d) { d.tree = true; }},
    {"centers", [](DebugDraw& d) { d.centers = true; }},
    {"names", [](DebugDraw& d) { d.names = true; }},
    {"islands", [](DebugDraw& d) { d.body_colors = islet::BodyColors::island; }},
    {"constraint-colors", [](DebugDraw& d) { d.constraint_colors = true; }},
};

DebugDraw drawing_of(const std::vector<std::string>& names) {
    if (names.empty()) return usual_drawing();
    DebugDraw draw;
    draw.joints = false;
    for (const std::string& name : names) layers.at(name)(draw);
    return draw;
}

bool is_file(const std::string& scene) { return scene.ends_with(".json"); }

/// A scene that is named by the command line: of the catalogue, or in a file.
struct NamedScene {
    Scene scene;
    bool is_found = false;
};

NamedScene scene_named(const std::string& name) {
    if (is_file(name)) {
        const std::string text = read_file(name);
        if (const std::string kind = kind_of(text); kind != "a JSON file" && kind != "a file of another kind")
            throw SceneFileError("this is " + kind + ", no scene" + (kind == "a recording" ? "; `islet replay` takes it" : ""));
        NamedScene named{read_scene(text), true};
        if (named.scene.name.empty()) named.scene.name = printable(name);
        return named;
    }
    const SceneInfo* info = find_scene(name);
    return info != nullptr ? NamedScene{info->make(), true} : NamedScene{};
}

/// Puts another start of the scene in its place. What is wrong with that, if something is.
std::string choose_start(Scene& scene, const std::string& name, int start) {
    const SceneInfo* const info = is_file(name) ? nullptr : find_scene(name);
    if (info == nullptr || info->make_start == nullptr) return fmt::format("'{}' has one start only", name);
    if (start >= info->starts) return fmt::format("'{}' has starts 0 to {}", name, info->starts - 1);
    scene = info->make_start(start);
    return {};
}

int write_scene_file(const std::string& name) {
    const NamedScene named = scene_named(name);
    if (!named.is_found) return unknown_scene(name);
    if (has_script(named.scene)) return wrong(fmt::format("'{}' has a script, which no file can hold", name));
    fmt::print("{}", write_scene(named.scene));
    return ok;
}

/// What has no room passes through things: that must not go unseen.
void warn_of_dropped(const RunResult& result, bool is_in_file) {
    if (result.dropped_contacts == 0) return;
    fmt::print(stderr,
               "islet: there was no room for some contacts (the most in one step: {}), and what they would have kept apart passes through each other: raise {}\n",
               result.most_dropped_contacts, is_in_file ? "the file's \"extra_contacts\"" : "the scene's extra_contacts, which become Capacity::contacts");
}

int run_scene(const RunCommand& command) {
    NamedScene named = scene_named(command.scene);
    if (!named.is_found) return unknown_scene(command.scene);
    if (command.start) {
        if (const std::string why = choose_start(named.scene, command.scene, *command.start); !why.empty()) return wrong(why);
    }
    if (const std::string why = beyond_memory_limit(capacity_of(named.scene), command.memory_limit); !why.empty())
        return wrong(fmt::format("'{}': {}", command.scene, why));
    // Opened before the run, so that a wrong path does not cost one.
    OutputFile csv(command.csv_path), svg(command.svg_path), html(command.html_path), recording(command.recording_path);
    OutputFile* const files[] = {&csv, &svg, &html, &recording};
    for (const OutputFile* file : files)
        if (!file->good()) return wrong(file->error());

    Run run(std::move(named.scene), command.options);
    std::optional<MovieMaker> movie;
    if (html.is_open()) movie.emplace(run);
    std::optional<WorldRecording> calls;
    if (recording.is_open()) calls.emplace(run.engine.world());
    ProgressBar bar(run.scene.steps);
    csv.write(csv_header());
    const RunResult result = run.run([&](const StepRecord& record) {
        if (csv.is_open()) csv.write(csv_line(record, run));
        if (movie) movie->observe(record);
        if (calls) calls->after_step();
        bar.update(record.step);
    });
    bar.clear();

    if (svg.is_open()) svg.write(draw_svg(run, drawing_of(command.draw)));
    if (movie) {
        html.write(player_page(run, result, *movie));
        if (movie->stride() > 1)
            fmt::print(stderr, "islet: to keep the page small, '{}' shows one step of every {}{}\n", command.html_path, movie->stride(),
                       movie->has_contacts() ? "" : ", without contacts");
    }
    if (calls) {
        const std::span<const std::byte> bytes = calls->finish();
        if (bytes.empty()) return wrong("a step had too many calls to be recorded");
        recording.write({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    }
    for (OutputFile* file : files)
        if (!file->close()) return wrong(file->error());
    warn_of_dropped(result, is_file(command.scene));
    fmt::print("{}", command.json ? json_of(result) : table_of(result));
    return result.passed() ? ok : check_failed;
}

int replay_recording(const ReplayCommand& command) {
    const Replayed replayed = replay_file(command.path, command.until, command.lanes, command.memory_limit);
    if (!replayed.error.empty()) return wrong(fmt::format("'{}': {}", command.path, replayed.error));
    const islet::ReplayResult& result = replayed.result;
    if (result.end == islet::ReplayEnd::differs) {
        fmt::print("step {} came out differently: hash {:016x}, recorded {:016x}\n", result.steps, result.hash, result.recorded_hash);
        fmt::print("{}\n", result.body ? fmt::format("the first body that differs is the one in slot {}", result.body.index1 - 1)
                                       : "no body that moved differs, or the recording does not tell them apart");
        return check_failed;
    }
    fmt::print("{} steps replayed, every hash as recorded; hash {:016x}{}\n", result.steps, replayed.hash,
               result.end == islet::ReplayEnd::stopped ? " (stopped before the end)" : "");
    return ok;
}

int unknown_engine(const std::string& name) {
    std::vector<std::string> names;
    for (const islet::engines::EngineInfo& info : islet::engines::registry()) names.emplace_back(info.name);
    return wrong(fmt::format("there is no engine '{}' in this build; there are: {}", name, fmt::join(names, ", ")));
}

/// Appends what is not there yet.
template <class Item>
void add_once(std::vector<const Item*>& list, const Item& item) {
    if (std::find(list.begin(), list.end(), &item) == list.end()) list.push_back(&item);
}

constexpr int quick_steps = 60;  // a second of most scenes

volatile std::sig_atomic_t is_interrupted = 0;

std::string duration(double seconds) {
    return seconds < 90 ? fmt::format("{:.0f} s", seconds) : seconds < 5400 ? fmt::format("{:.0f} min", seconds / 60) : fmt::format("{:.1f} h", seconds / 3600);
}

int run_small_bench(const BenchCommand& command) {
    if (!command.small_world.empty()) {
        step_small_world(*find_small_world(command.small_world), command.options.steps.value_or(1), command.lanes);
        return ok;
    }
    SmallOptions options;
    for (const SmallWorld& world : small_worlds()) options.worlds.push_back(&world);
    std::error_code error;
    if (has_valgrind()) options.program = std::filesystem::read_symlink("/proc/self/exe", error).string();
    const bool counts = !options.program.empty();
    if (!counts) fmt::print(stderr, "islet: instructions are counted by valgrind, which is not installed; steps are timed instead\n");
    if (!command.json) fmt::print("{}", small_header(counts));
    const std::vector<SmallResult> results = measure_small_worlds(options, [&](const SmallResult& result) {
        if (!command.json) fmt::print("{}", small_row(result));
        std::fflush(stdout);
    });
    if (command.json) fmt::print("{}", json_of(results));
    return ok;
}

int run_span_bench(const BenchCommand& command, const BenchOptions& bench) {
    SpanOptions options;
    options.scenes = bench.scenes;
    options.steps = bench.steps;
    options.most_steps = bench.most_steps;
    options.repeat = bench.repeat;
    if (command.has_workers) options.workers = bench.workers;
    std::optional<ProgressBar> bar;
    const auto stepped = [&bar](int done, int total) {
        if (!bar) bar.emplace(total, "step", 10);
        bar->update(done);
    };
    bool any = false;
    const std::vector<SpanResult> results = measure_span(options, stepped, [&](const SpanResult& result) {
        if (command.json) return;
        if (bar) bar->clear();
        fmt::print("{}{}", any ? "\n" : "", span_table(result));
        std::fflush(stdout);
        any = true;
    });
    if (bar) bar->clear();
    if (command.json) fmt::print("{}", json_of(results));
    return ok;
}

int run_bench(const BenchCommand& command) {
    if (command.small || !command.small_world.empty()) return run_small_bench(command);
    BenchOptions options = command.options;
    for (const std::string& name : command.scenes) {
        const SceneInfo* info = find_scene(name);
        if (info == nullptr) return unknown_scene(name);
        add_once(options.scenes, *info);
    }
    for (const std::string& name : command.engines) {
        const islet::engines::EngineInfo* info = islet::engines::find_engine(name);
        if (info == nullptr) return unknown_engine(name);
        add_once(options.engines, *info);
    }
    for (const SceneInfo& info : catalogue()) {
        if (command.scenes.empty() && std::string(info.group) == "benchmark") options.scenes.push_back(&info);
    }
    for (const islet::engines::EngineInfo& info : islet::engines::registry()) {
        if (command.engines.empty()) options.engines.push_back(&info);
    }

    if (command.quick) {
        options.repeat = 1;
        options.most_steps = quick_steps;
    }
    if (command.span) return run_span_bench(command, options);
    std::signal(SIGINT, [](int) {
        is_interrupted = 1;
        std::signal(SIGINT, SIG_DFL);  // the second time it ends at once
    });
    if (const double seconds = estimate_seconds(options); seconds >= 5)
        fmt::print(stderr, "islet: this takes about {}; Ctrl-C ends it and prints what there is{}\n", duration(seconds), command.quick ? "" : ", --quick gives a first impression");
    std::vector<std::string> scenes, engines;
    for (const SceneInfo* info : options.scenes) scenes.emplace_back(info->name);
    for (const islet::engines::EngineInfo* info : options.engines) engines.emplace_back(info->name);
    BenchTable table(scenes, engines);
    if (!command.json) fmt::print("{}", table.header());
    std::fflush(stdout);
    std::optional<ProgressBar> bar;
    BenchObserver observer;
    observer.stepped = [&bar](int done, int total) {
        if (!bar) bar.emplace(total, "step", 10);
        bar->update(done);
    };
    observer.ended = [&](const BenchResult& result) {
        if (command.json) return;
        if (bar) bar->clear();
        fmt::print("{}", table.row(result));
        std::fflush(stdout);
    };
    observer.is_stopped = [] { return is_interrupted != 0; };
    const std::vector<BenchResult> results = bench(options, observer);
    if (bar) bar->clear();
    if (command.json) fmt::print("{}", json_of(results));
    if (is_interrupted == 0) return ok;
    fmt::print(stderr, "islet: interrupted; this is what whole runs there were\n");
    return interrupted;
}

int run_steady_table(const SteadyCommand& command) {
    SteadyOptions options;
    for (const std::string& name : command.scenes) {
        const SceneInfo* info = find_scene(name);
        if (info == nullptr) return unknown_scene(name);
        if (info->make_start == nullptr) return wrong(fmt::format("'{}' is no row of this table: it has one start only", name));
        add_once(options.scenes, *info);
    }
    for (const std::string& name : command.engines) {
        const islet::engines::EngineInfo* info = islet::engines::find_engine(name);
        if (info == nullptr) return unknown_engine(name);
        add_once(options.engines, *info);
    }
    if (command.scenes.empty()) options.scenes = scenes_with_starts();
    if (command.engines.empty()) options.engines.push_back(&islet::engines::registry().front());
    if (command.quick) options.most_starts = 1;
    if (command.starts) options.most_starts = *command.starts;
    options.jobs = command.jobs != 0 ? command.jobs : std::max(1u, std::thread::hardware_concurrency());

    std::optional<ProgressBar> bar;
    const SteadyTable table = run_steady(options, [&bar](int done, int total) {
        if (!bar) bar.emplace(total, "run", 10);
        bar->update(done);
    });
    if (bar) bar->clear();
    fmt::print("{}", command.json ? json_of(table) : table_of(table));
    for (const std::string& line : table.broken) fmt::print(stderr, "islet: {}\n", line);
    return table.broken.empty() ? ok : check_failed;
}

/// The scene of a sweep, made anew for each run; what is in a file has no script, and is copied.
SceneMaker maker_of(const std::string& name) {
    if (!is_file(name)) return [info = find_scene(name)](std::optional<int> start) { return start ? info->make_start(*start) : info->make(); };
    return [scene = scene_named(name).scene](std::optional<int>) { return scene; };
}

SweepPart merged(const std::vector<std::string>& paths) {
    std::vector<SweepPart> parts;
    for (const std::string& path : paths) {
        try {
            parts.push_back(read_manifest(read_file(path)));
        } catch (const std::exception& error) { throw SweepError(fmt::format("'{}': {}", path, error.what())); }
    }
    return merge(parts, paths);
}

/// The runs that the command asks for. What is wrong with the command, if something is, stands in `why`.
SweepPart swept(const SweepCommand& command, std::string& why) {
    SweepPart part{command.sweep, {}};
    for (const std::string& axis : command.vary) part.sweep.axes.push_back(read_axis(axis));
    if (!command.plot_path.empty()) check_plot(part.sweep);
    const SceneMaker make = maker_of(command.sweep.scene);
    if (command.sweep.start) {
        Scene scene = make({});
        why = choose_start(scene, command.sweep.scene, *command.sweep.start);
        if (!why.empty()) return part;
    }
    prepare(part.sweep, make, command.memory_limit);
    const std::uint32_t jobs = command.jobs != 0 ? command.jobs : std::max(1u, std::thread::hardware_concurrency());
    ProgressBar bar(static_cast<int>((part.sweep.runs() + command.shards - 1) / command.shards), "run", 10);
    part.runs = run_sweep(part.sweep, make, jobs, command.shard, command.shards, [&bar](int done) { bar.update(done); });
    return part;
}

int run_sweep_command(const SweepCommand& command) {
    const bool merges = !command.merge.empty();
    if (merges == !command.sweep.scene.empty()) return wrong("a sweep needs a scene, or manifests to --merge");
    if (merges && (!command.vary.empty() || command.shards > 1 || !command.manifest_path.empty()))
        return wrong("--merge takes what the manifests say, and writes none");
    if (!merges && !is_file(command.sweep.scene) && find_scene(command.sweep.scene) == nullptr) return unknown_scene(command.sweep.scene);
    if (command.shard >= command.shards) return wrong(fmt::format("--shard is 0 to {}: there are {} shards", command.shards - 1, command.shards));
    if (command.shards > 1 && command.manifest_path.empty()) return wrong("one shard makes no table: --manifest names the file for --merge");
    const bool is_whole = command.shards == 1;
    if (!is_whole && (command.json || !command.plot_path.empty())) return wrong("one shard makes no table: --json and --plot are for --merge");
    OutputFile csv(command.csv_path), plot(command.plot_path), manifest(command.manifest_path);
    OutputFile* const files[] = {&csv, &plot, &manifest};
    for (const OutputFile* file : files)
        if (!file->good()) return wrong(file->error());
    std::string why;
    const SweepPart part = merges ? merged(command.merge) : swept(command, why);
    if (!why.empty()) return wrong(why);
    if (csv.is_open()) csv.write(csv_of(part));
    if (manifest.is_open()) manifest.write(manifest_of(part));
    if (is_whole) {
        const SweepTable table = tabulate(part);
        if (plot.is_open()) plot.write(plot_of(part.sweep, table));
        fmt::print("{}", command.json ? json_of(part.sweep, table) : table_of(part.sweep, table));
    } else {
        fmt::print("shard {} of {}: {} of {} runs\n", command.shard, command.shards, part.runs.size(), part.sweep.runs());
    }
    for (OutputFile* file : files)
        if (!file->close()) return wrong(file->error());
    const auto dropped = std::count_if(part.runs.begin(), part.runs.end(), [](const SweepRun& run) { return run.dropped_contacts > 0; });
    if (dropped > 0)
        fmt::print(stderr, "islet: in {} runs there was no room for some contacts, and what they would have kept apart passes through each other\n", dropped);
    return ok;
}

void limit_memory(CLI::App& command, std::uint64_t& limit) {
    command.add_option("--memory-limit", limit, "the most bytes that the world may take, such as 500MB or 4GB; 2GB if not given")->transform(CLI::AsSizeValue(true));
}

/// The command line, and where what it says is kept.
struct CommandLine {
    CLI::App app{"Islet: runs the scenes of the 2D physics engine without a screen"};
    CLI::App* list = app.add_subcommand("list", "every scene, grouped, with one line each");
    CLI::App* run = app.add_subcommand("run", "runs a scene and prints what happened; exit status 1 if its check failed");
    CLI::App* scene = app.add_subcommand("scene", "prints a scene that has no script as a JSON file, for `islet run FILE.json`");
    CLI::App* replay = app.add_subcommand("replay", "makes the calls of a recording again; exit status 1 if a step comes out differently");
    CLI::App* bench =
        app.add_subcommand("bench", "times scenes in several engines, taken in turns: medians, and how many times Islet's time");
    CLI::App* steady =
        app.add_subcommand("steady", "runs scenes from many starts and prints the worst beside what is wanted; exit status 1 if a check failed");
    CLI::App* sweep = app.add_subcommand("sweep", "runs a scene for each combination of parameters from many starts, and prints what the runs came to");
    bool list_json = false;
    std::string scene_name;
    RunCommand command;
    BenchCommand bench_command;
    ReplayCommand replay_command;
    SteadyCommand steady_command;
    SweepCommand sweep_command;

    CommandLine() {
        app.require_subcommand(1);
        list->add_flag("--json", list_json, "as a JSON list");

        RunOptions& o = command.options;
        run->add_option("scene", command.scene, "name of the scene, or of a file with one that ends in .json")->required();
        scene->add_option("scene", scene_name, "name of the scene")->required();
        run->add_option("--start", command.start, "which start, from 0, of a scene that has several: see `islet steady`")->check(CLI::Range(0, 1'000'000));
        run->add_option("--steps", o.steps, "steps to take; the scene's own if not given")->check(CLI::Range(0, 100'000'000));
        run->add_option("--dt", o.dt, "length of a step, s")->check(CLI::Range(1e-6, 1.0))->check(finite_number);
        run->add_option("--substeps", o.substeps, "substeps of a step")->check(CLI::Range(1, 64));
        static const std::map<std::string, islet::JointTrees> joint_trees = {
            {"off", islet::JointTrees::off}, {"automatic", islet::JointTrees::automatic}, {"all", islet::JointTrees::all}};
        add_choice(*run, "--joint-trees", o.joint_trees, joint_trees, "which trees of hinges are solved exactly; the scene's own choice if not given");
        run->add_option("--iterations", o.iterations, "biased sweeps of a substep")->check(CLI::Range(1, 256));
        run->add_option("--relax-iterations", o.relax_iterations, "unbiased sweeps of a substep")->check(CLI::Range(0, 256));
        static const std::map<std::string, islet::SweepOrder> sweep_orders = {{"colored", islet::SweepOrder::colored},
                                                                              {"as-found", islet::SweepOrder::as_found},
                                                                              {"upward", islet::SweepOrder::upward},
                                                                              {"downward", islet::SweepOrder::downward}};
        add_choice(*run, "--sweep-order", o.sweep_order, sweep_orders, "the order in which contacts are swept");
        run->add_flag("--block-contacts", o.block_contacts, "solve the two points of a contact together");
        run->add_option("--shock", o.shock, "shock propagation: 0 none, 0.5 the most")->check(CLI::Range(0.0f, islet::max_shock))->check(finite_number);
        run->add_option("--tolerance", o.tolerance, "end sweeps at this residual, m/s")->check(CLI::NonNegativeNumber)->check(finite_number);
        run->add_flag("--residual", o.measure_residual, "measure how far the impulses are from a solution");
        run->add_option("--workers", o.workers, "threads to step with")->check(CLI::Range(1u, islet::max_workers));
        run->add_option("--lanes", o.lanes, "constraints solved at once; 0 picks the widest")->check(CLI::IsMember({0, 1, 4, 8, 16}));
        run->add_option("--hash-every", o.hash_every, "print the state's hash every so many steps")->check(CLI::Range(1, 100'000'000));
        run->add_option("--csv", command.csv_path, "write a line of numbers per step to this file")->check(not_empty);
        run->add_option("--svg", command.svg_path, "draw the last state to this file")->check(not_empty);
        run->add_option("--draw", command.draw, "what the picture shows besides shapes; joints,contacts,normals if not given")
            ->delimiter(',')
            ->check(CLI::IsMember(layers));
        run->add_option("--html", command.html_path, "write a page that plays the run back to this file")->check(not_empty);
        run->add_option("--record", command.recording_path, "write every call and the hash after each step to this file, for `islet replay`")->check(not_empty);
        run->add_flag("--json", command.json, "print one JSON object");
        limit_memory(*run, command.memory_limit);

        replay->add_option("file", replay_command.path, "a recording, made by `islet run --record` or by a program of yours")->required();
        replay->add_option("--until", replay_command.until, "stop after so many steps")->check(CLI::Range(1ull, ~0ull));
        replay->add_option("--lanes", replay_command.lanes, "constraints solved at once; 0 picks the widest")->check(CLI::IsMember({0, 1, 4, 8, 16}));
        limit_memory(*replay, replay_command.memory_limit);

        // The bounds keep the number of all steps below 2^31.
        BenchOptions& b = bench_command.options;
        bench->add_option("scene", bench_command.scenes, "names of scenes; the group benchmark if none is given");
        CLI::Option* const engine = bench->add_option("--engine", bench_command.engines, "an engine to time, once or more; all there are if not given");
        bench->add_option("--workers", b.workers, "threads to step with, for engines that have them; several numbers (1,2,4) are timed beside each other")
            ->delimiter(',')
            ->check(CLI::Range(1u, islet::max_workers))
            ->each([this](const std::string&) { bench_command.has_workers = true; });
        CLI::Option* const quick = bench->add_flag("--quick", bench_command.quick, fmt::format("one run of at most {} steps: a first impression", quick_steps));
        bench->add_option("--repeat", b.repeat, "runs of each engine, of which the medians are taken")->check(CLI::Range(1, 100))->excludes(quick);
        bench->add_option("--steps", b.steps, "steps of a run; the scene's own if not given")->check(CLI::Range(1, 100'000))->excludes(quick);
        CLI::Option* const small =
            bench->add_flag("--small", bench_command.small, "small worlds in Islet alone: the instructions that a step takes, counted by valgrind")
                ->excludes(quick);
        bench
            ->add_flag("--span", bench_command.span,
                       "what each stage of a step would take with 2, 4, 8 and 16 workers: their tasks, one after another, in Islet alone")
            ->excludes(small)
            ->excludes(engine);
        std::vector<std::string> worlds;
        for (const SmallWorld& world : small_worlds()) worlds.emplace_back(world.name);
        bench->add_option("--small-world", bench_command.small_world, "step this small world and print nothing")->check(CLI::IsMember(worlds))->group("");
        bench->add_option("--lanes", bench_command.lanes, "of --small-world")->check(CLI::IsMember({0, 1, 4, 8, 16}))->group("");
        bench->add_flag("--json", bench_command.json, "print a JSON list; its profile is Islet's stages in ms, of all steps together");

        SteadyCommand& s = steady_command;
        steady->add_option("scene", s.scenes, "names of scenes; all that have several starts if none is given");
        steady->add_option("--engine", s.engines, "an engine, once or more: the first is judged, the others are put beside it; islet if not given");
        CLI::Option* const one = steady->add_flag("--quick", s.quick, "one start of each scene");
        steady->add_option("--starts", s.starts, "so many starts of each scene; all if not given")->check(CLI::Range(1, 1'000'000))->excludes(one);
        steady->add_option("--jobs", s.jobs, "runs at a time; as many as there are processors if not given")->check(CLI::Range(1u, 256u));
        steady->add_flag("--json", s.json, "as a JSON list");
        add_sweep();
    }

    void add_sweep() {
        SweepCommand& w = sweep_command;
        sweep->add_option("scene", w.sweep.scene, "name of the scene, or of a file with one that ends in .json");
        sweep
            ->add_option(
                "--vary", w.vary,
                fmt::format("a parameter and its values, NAME=FIRST:LAST:COUNT or NAME=VALUE,VALUE,...; given more than once, all combinations are run. "
                            "Parameters: {}",
                            fmt::join(parameter_names(), ", ")))
            ->allow_extra_args(false);
        sweep->add_option("--seeds", w.sweep.seeds, "runs of each combination: seed 0 is the scene as it is, others nudge the starts of dynamic bodies")
            ->check(CLI::Range(1ull, 10'000'000ull))
            ->capture_default_str();
        sweep->add_option("--nudge", w.sweep.nudge, "the farthest that a seed moves a body along x and y, m")
            ->check(CLI::Range(0.0, 1000.0))
            ->check(finite_number)
            ->capture_default_str();
        sweep->add_option("--start", w.sweep.start, "which start, from 0, of a scene that has several")->check(CLI::Range(0, 1'000'000));
        sweep->add_option("--steps", w.sweep.steps, "steps of a run; the scene's own if not given")->check(CLI::Range(0, 100'000'000));
        sweep->add_option("--jobs", w.jobs, "runs at a time; as many as there are processors if not given. The results are the same")
            ->check(CLI::Range(1u, islet::max_workers));
        sweep->add_option("--shards", w.shards, "make one share of the runs, of so many")->check(CLI::Range(1ull, 1'000'000ull));
        sweep->add_option("--shard", w.shard, "which share, from 0");
        sweep->add_option("--manifest", w.manifest_path, "write the runs to this JSON file, for --merge")->check(not_empty);
        sweep->add_option("--merge", w.merge, "put the runs of these manifests together; they must be all runs of one sweep");
        sweep->add_option("--csv", w.csv_path, "write a line for each run to this file")->check(not_empty);
        sweep->add_option("--plot", w.plot_path, "draw the table to this SVG file")->check(not_empty);
        sweep->add_flag("--json", w.json, "print the table as one JSON object");
        sweep->add_option("--scheduler", w.scheduler, "address of a Dask scheduler whose workers make the runs: calls python3 -m islet.sweep")
            ->check(not_empty);
        limit_memory(*sweep, w.memory_limit);
    }
};

int execute(CommandLine& line) {
    if (line.list->parsed()) {
        fmt::print("{}", line.list_json ? catalogue_json() : catalogue_table());
        return ok;
    }
    if (line.scene->parsed()) return write_scene_file(line.scene_name);
    if (line.replay->parsed()) return replay_recording(line.replay_command);
    if (line.steady->parsed()) return run_steady_table(line.steady_command);
    if (line.sweep->parsed()) return run_sweep_command(line.sweep_command);
    return line.bench->parsed() ? run_bench(line.bench_command) : run_scene(line.command);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        CommandLine line;
        if (const std::optional<int> status = parse_or_explain(line.app, argc, argv, "islet")) return *status;
        const std::string& scene = line.scene->parsed()    ? line.scene_name
                                   : line.replay->parsed() ? line.replay_command.path
                                   : line.sweep->parsed()  ? line.sweep_command.sweep.scene
                                                           : line.command.scene;
        try {
            if (!line.sweep_command.scheduler.empty()) return wrong(sweep_on_cluster(argc, argv));
            const int status = execute(line);
            return all_printed() ? status : wrong("cannot write all of the standard output");
        } catch (const std::exception& error) { return wrong(is_file(scene) || line.replay->parsed() ? fmt::format("'{}': {}", scene, error.what()) : error.what()); }
    } catch (const std::exception& error) { return wrong(error.what()); }
}
