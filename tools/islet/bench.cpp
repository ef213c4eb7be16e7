#include "bench.hpp"

#include "common/clock.hpp"
#include "workers/thread_pool.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

namespace islet::tools {
namespace {

using engines::EngineInfo;

/// An engine's part in a scene.
struct Contender {
    const EngineInfo* engine = nullptr;
    BenchResult result;
    std::vector<BenchRun> runs;
};

/// The scene's contenders, also those that cannot build it.
std::vector<Contender> contenders(const SceneInfo& info, const BenchOptions& options) {
    const Scene scene = info.make();
    std::vector<Contender> list;
    for (const EngineInfo* engine : options.engines) {
        for (const std::uint32_t workers : engine->has_workers ? options.workers : std::vector<std::uint32_t>{1}) {
            Contender contender;
            contender.engine = engine;
            contender.result.engine = engine->name;
            contender.result.scene = info.name;
            contender.result.lacks = engine->lacks(scene);
            contender.result.steps = options.steps.value_or(std::min(scene.steps, options.most_steps.value_or(scene.steps)));
            contender.result.workers = workers;
            list.push_back(std::move(contender));
        }
    }
    return list;
}

std::uint64_t nanoseconds(void*) { return nanoseconds_now(); }

void add(std::optional<BenchProfile>& sum, const StepProfile& step) {
    if (!sum) sum.emplace();
    const auto ms = [](std::uint64_t ticks) { return double(ticks) / nanoseconds_per_ms; };
    sum->pairs += ms(step.pairs);
    sum->collide += ms(step.collide);
    sum->islands += ms(step.islands);
    sum->solve += ms(step.solve);
    sum->finish += ms(step.finish);
}

/// The median of each stage; none if a run has no profile.
std::optional<BenchProfile> median_profile(const std::vector<BenchRun>& runs) {
    BenchProfile medians;
    for (double BenchProfile::*stage : {&BenchProfile::pairs, &BenchProfile::collide, &BenchProfile::islands, &BenchProfile::solve, &BenchProfile::finish}) {
        std::vector<double> values;
        for (const BenchRun& run : runs) {
            if (!run.profile) return std::nullopt;
            values.push_back((*run.profile).*stage);
        }
        medians.*stage = median(values);
    }
    return medians;
}

/// A scene in an engine, from the start. (A scene of its own for each run: scripts keep state.)
struct LoadedScene {
    ThreadPool pool;
    Scene scene;
    std::unique_ptr<Engine> engine;

    LoadedScene(const Contender& contender, const SceneInfo& info) : pool(contender.result.workers), scene(info.make()), engine(contender.engine->make()) {
        scene.world.tasks = pool.tasks();
        scene.world.clock = nanoseconds;
        engine->load(scene);
    }
    LoadedScene(const LoadedScene&) = delete;
    LoadedScene& operator=(const LoadedScene&) = delete;
};

/// Nothing if it was stopped: `stepped` returns false then.
std::optional<BenchRun> run_once(const Contender& contender, const SceneInfo& info, const std::function<bool()>& stepped) {
    const int steps = contender.result.steps;
    LoadedScene loaded(contender, info);
    BenchRun run;
    run.step_ms.reserve(static_cast<std::size_t>(steps));
    for (int i = 0; i < steps; ++i) {
        run.step_ms.push_back(loaded.engine->advance(loaded.scene, i, loaded.scene.dt));
        if (const std::optional<StepProfile> profile = loaded.engine->profile()) add(run.profile, *profile);
        if (!stepped()) return std::nullopt;
    }
    const EngineCounts counts = loaded.engine->counts();
    run.bodies = counts.bodies;
    run.contacts = counts.contacts;
    return run;
}

/// Each repeat begins with another engine, so that none always runs first. False if it was stopped.
bool take_turns(std::vector<Contender>& list, const SceneInfo& info, const BenchOptions& options, const std::function<bool()>& stepped) {
    for (int turn = 0; turn < options.repeat; ++turn) {
        for (std::size_t i = 0; i < list.size(); ++i) {
            Contender& contender = list[(i + static_cast<std::size_t>(turn)) % list.size()];
            if (!contender.result.lacks.empty()) continue;
            std::optional<BenchRun> run = run_once(contender, info, stepped);
            if (!run) return false;
            contender.runs.push_back(std::move(*run));
        }
    }
    return true;
}

}  // namespace

double total_ms(const BenchRun& run) { return std::accumulate(run.step_ms.begin(), run.step_ms.end(), 0.0); }

void summarise(const std::vector<BenchRun>& runs, const std::vector<BenchRun>& reference, BenchResult& result) {
    if (runs.empty()) return;
    std::vector<double> total, p50, p99, ratios;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        total.push_back(total_ms(runs[i]));
        p50.push_back(median(runs[i].step_ms));
        p99.push_back(percentile(runs[i].step_ms, 99));
        // Two runs of one turn are close in time: what disturbed one is likely to have disturbed the other.
        if (i < reference.size() && total_ms(reference[i]) > 0) ratios.push_back(total.back() / total_ms(reference[i]));
    }
    result.ms_total = median(total);
    result.ms_per_step_p50 = median(p50);
    result.ms_per_step_p99 = median(p99);
    if (!ratios.empty()) result.ratio = median(ratios);
    result.profile = median_profile(runs);
    result.bodies = runs.back().bodies;
    result.contacts = runs.back().contacts;
}

double estimate_seconds(const BenchOptions& options) {
    constexpr int tried = 4, least_steps = 25 * tried;  // so that trying is a small part of the whole
    using Clock = std::chrono::steady_clock;
    double seconds = 0;
    for (const SceneInfo* info : options.scenes) {
        for (const Contender& contender : contenders(*info, options)) {
            if (!contender.result.lacks.empty()) continue;
            if (contender.result.steps * options.repeat < least_steps) return 0;
            const Clock::time_point start = Clock::now();
            LoadedScene loaded(contender, *info);
            const double loading = std::chrono::duration<double>(Clock::now() - start).count();
            std::vector<double> step_ms;
            for (int i = 0; i < tried; ++i) step_ms.push_back(loaded.engine->advance(loaded.scene, i, loaded.scene.dt));
            seconds += options.repeat * (loading + contender.result.steps * median(step_ms) / 1e3);
        }
    }
    return seconds;
}

std::vector<BenchResult> bench(const BenchOptions& options, const BenchObserver& observer) {
    std::vector<std::vector<Contender>> scenes;
    int total = 0, done = 0;
    for (const SceneInfo* info : options.scenes) {
        scenes.push_back(contenders(*info, options));
        for (const Contender& c : scenes.back()) total += c.result.lacks.empty() ? options.repeat * c.result.steps : 0;
    }
    const auto stepped = [&] {
        observer.stepped(++done, total);
        return !observer.is_stopped || !observer.is_stopped();
    };

    std::vector<BenchResult> results;
    bool goes_on = true;
    for (std::size_t s = 0; s < scenes.size() && goes_on; ++s) {
        goes_on = take_turns(scenes[s], *options.scenes[s], options, stepped);
        std::vector<BenchRun> reference;
        for (const Contender& c : scenes[s]) {
            if (c.result.engine == "islet" && reference.empty()) reference = c.runs;
        }
        for (Contender& c : scenes[s]) {
            if (!goes_on && c.runs.empty()) continue;
            summarise(c.runs, reference, c.result);
            if (observer.ended) observer.ended(c.result);
            results.push_back(std::move(c.result));
        }
    }
    return results;
}

}  // namespace islet::tools
