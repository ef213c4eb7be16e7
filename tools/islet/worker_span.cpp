#include "worker_span.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "common/clock.hpp"
#include "harness/engine.hpp"

namespace islet::tools {
namespace {

using namespace samples;

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

// When all tasks have returned: each worker that is free takes the next one.
double job_time(const std::vector<double>& tasks, std::uint32_t workers) {
    std::vector<double> free_at(workers, 0.0);
    for (const double task : tasks) *std::min_element(free_at.begin(), free_at.end()) += task;
    return *std::max_element(free_at.begin(), free_at.end());
}

struct SpanRun {
    std::vector<StepTimes> steps;
    EngineCounts counts;
};

SpanRun run_once(const SceneInfo& info, int steps, std::uint32_t workers, const std::function<void()>& stepped) {
    SpanMeter meter(workers);
    Scene scene = info.make();
    scene.world.tasks = meter.tasks();
    scene.world.clock = SpanMeter::tick;
    scene.world.clock_context = &meter;
    IsletEngine engine;
    engine.load(scene);
    for (int i = 0; i < steps; ++i) {
        engine.advance(scene, i, scene.dt);
        stepped();
    }
    return {meter.steps(), engine.counts()};
}

SpanRow row_of(const std::string& stage, std::size_t first, std::size_t end, const std::vector<StepTimes>& one, const std::vector<std::uint32_t>& workers,
               const std::vector<std::vector<StepTimes>>& several) {
    // Times that are added up over the stages and averaged over the steps.
    const auto mean = [&](const std::vector<StepTimes>& steps, auto&& time) {
        double all = 0;
        for (const StepTimes& step : steps)
            for (std::size_t i = first; i < end; ++i) all += time(step[i]);
        return steps.empty() ? 0 : all / static_cast<double>(steps.size());
    };
    SpanRow row;
    row.stage = stage;
    row.one_worker = mean(one, [](const StageTimes& s) { return s.work(); });
    const auto most = static_cast<std::size_t>(std::max_element(workers.begin(), workers.end()) - workers.begin());
    row.work = mean(several[most], [](const StageTimes& s) { return s.work(); });
    row.alone = mean(several[most], [](const StageTimes& s) { return s.alone_work(); });
    row.chain = mean(several[most], [](const StageTimes& s) { return s.chain(); });
    for (std::size_t k = 0; k < workers.size(); ++k) row.time.push_back(mean(several[k], [&](const StageTimes& s) { return s.time_with(workers[k]); }));
    return row;
}

}  // namespace

double StageTimes::alone_work() const { return sum(alone); }

double StageTimes::work() const {
    double all = alone_work();
    for (const std::vector<double>& tasks : jobs) all += sum(tasks);
    return all;
}

double StageTimes::chain() const {
    double all = alone_work();
    for (const std::vector<double>& tasks : jobs) all += tasks.empty() ? 0 : *std::max_element(tasks.begin(), tasks.end());
    return all;
}

double StageTimes::time_with(std::uint32_t workers) const {
    double all = alone_work();
    for (const std::vector<double>& tasks : jobs) all += job_time(tasks, workers);
    return all;
}

SpanMeter::SpanMeter(std::uint32_t workers, Now now) : workers_(workers), now_(now ? std::move(now) : Now(nanoseconds_now)) {}

TaskSystem SpanMeter::tasks() {
    const auto parallel_for = [](void* meter, std::uint32_t count, void (*task)(void* data, std::uint32_t index), void* data) {
        static_cast<SpanMeter*>(meter)->run(count, task, data);
    };
    return {parallel_for, this, workers_};
}

void SpanMeter::end_stretch(std::uint64_t now) { steps_.back()[stage_].alone.back() += static_cast<double>(now - begin_) / nanoseconds_per_ms; }

void SpanMeter::run(std::uint32_t count, void (*task)(void* data, std::uint32_t index), void* data) {
    std::uint64_t begin = now_();
    const bool within_step = stage_ < span_stages.size();
    if (within_step) end_stretch(begin);
    std::vector<double> tasks;
    tasks.reserve(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        task(data, i);
        const std::uint64_t end = now_();
        tasks.push_back(static_cast<double>(end - begin) / nanoseconds_per_ms);
        begin = end;
    }
    if (!within_step) return;
    steps_.back()[stage_].jobs.push_back(std::move(tasks));
    steps_.back()[stage_].alone.push_back(0);
    begin_ = now_();
}

// World::step reads the clock when it begins and after each stage.
std::uint64_t SpanMeter::tick(void* meter) {
    SpanMeter& m = *static_cast<SpanMeter*>(meter);
    const std::uint64_t now = m.now_();
    if (m.stage_ == span_stages.size()) {
        m.steps_.emplace_back();
        m.stage_ = 0;
    } else {
        m.end_stretch(now);
        ++m.stage_;
    }
    m.begin_ = m.now_();
    return now;
}

void take_least(std::vector<StepTimes>& least, const std::vector<StepTimes>& other) {
    const auto lesser = [](std::vector<double>& a, const std::vector<double>& b) {
        if (a.size() != b.size()) throw std::logic_error("two runs of the same scene made other tasks");
        std::transform(a.begin(), a.end(), b.begin(), a.begin(), [](double x, double y) { return std::min(x, y); });
    };
    if (least.size() != other.size()) throw std::logic_error("two runs of the same scene made other steps");
    for (std::size_t step = 0; step < least.size(); ++step) {
        for (std::size_t i = 0; i < span_stages.size(); ++i) {
            StageTimes& a = least[step][i];
            const StageTimes& b = other[step][i];
            lesser(a.alone, b.alone);
            for (std::size_t job = 0; job < a.jobs.size(); ++job) lesser(a.jobs[job], b.jobs[job]);
        }
    }
}

std::vector<SpanRow> span_rows(const std::vector<StepTimes>& one, const std::vector<std::uint32_t>& workers,
                               const std::vector<std::vector<StepTimes>>& several) {
    std::vector<SpanRow> rows;
    for (std::size_t i = 0; i < span_stages.size(); ++i) rows.push_back(row_of(span_stages[i], i, i + 1, one, workers, several));
    rows.push_back(row_of("step", 0, span_stages.size(), one, workers, several));
    return rows;
}

std::vector<SpanResult> measure_span(const SpanOptions& options, const std::function<void(int, int)>& stepped,
                                     const std::function<void(const SpanResult&)>& ended) {
    std::vector<std::uint32_t> runs = {1};
    runs.insert(runs.end(), options.workers.begin(), options.workers.end());
    const auto steps_of = [&](const SceneInfo& info) {
        if (options.steps) return *options.steps;
        const int own = info.make().steps;
        return std::min(own, options.most_steps.value_or(own));
    };
    int total = 0, done = 0;
    for (const SceneInfo* info : options.scenes) total += steps_of(*info) * options.repeat * static_cast<int>(runs.size());
    std::vector<SpanResult> results;
    for (const SceneInfo* info : options.scenes) {
        SpanResult result;
        result.scene = info->name;
        result.steps = steps_of(*info);
        result.workers = options.workers;
        std::vector<std::vector<StepTimes>> least(runs.size());
        for (int turn = 0; turn < options.repeat; ++turn) {
            for (std::size_t k = 0; k < runs.size(); ++k) {
                SpanRun run = run_once(*info, result.steps, runs[k], [&] { stepped(++done, total); });
                result.bodies = run.counts.bodies;
                result.contacts = run.counts.contacts;
                if (turn == 0)
                    least[k] = std::move(run.steps);
                else
                    take_least(least[k], run.steps);
            }
        }
        result.rows = span_rows(least.front(), options.workers, {least.begin() + 1, least.end()});
        results.push_back(std::move(result));
        ended(results.back());
    }
    return results;
}

std::string span_table(const SpanResult& result) {
    std::string text = fmt::format("{}: {} steps, {} bodies, {} contacts; ms a step\n", result.scene, result.steps, result.bodies, result.contacts);
    text += fmt::format("{:<8} {:>9} {:>9} {:>9} {:>9}", "stage", "1 worker", "work", "alone", "chain");
    for (const std::uint32_t workers : result.workers) text += fmt::format(" {:>9} {:>6}", fmt::format("{} workers", workers), "x");
    text += "\n";
    for (const SpanRow& row : result.rows) {
        text += fmt::format("{:<8} {:>9.4f} {:>9.4f} {:>9.4f} {:>9.4f}", row.stage, row.one_worker, row.work, row.alone, row.chain);
        for (const double time : row.time) text += fmt::format(" {:>9.4f} {:>6}", time, time > 0 ? fmt::format("{:.2f}", row.one_worker / time) : "-");
        text += "\n";
    }
    return text;
}

std::string json_of(const std::vector<SpanResult>& results) {
    using Json = nlohmann::ordered_json;
    Json list = Json::array();
    for (const SpanResult& r : results) {
        Json stages = Json::array();
        for (const SpanRow& row : r.rows) {
            Json with = Json::array();
            for (std::size_t k = 0; k < r.workers.size(); ++k) with.push_back({{"workers", r.workers[k]}, {"ms", row.time[k]}});
            stages.push_back({{"stage", row.stage},
                              {"ms_one_worker", row.one_worker},
                              {"ms_work", row.work},
                              {"ms_alone", row.alone},
                              {"ms_chain", row.chain},
                              {"with", std::move(with)}});
        }
        list.push_back({{"scene", r.scene}, {"steps", r.steps}, {"bodies", r.bodies}, {"contacts", r.contacts}, {"stages", std::move(stages)}});
    }
    return list.dump(2) + "\n";
}

}  // namespace islet::tools
