#include "steady.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <thread>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace islet::tools {
namespace {

/// One engine in one start of a scene.
struct Task {
    const SceneInfo* scene = nullptr;
    std::size_t engine = 0;
    int start = 0;
    bool is_built = false;
    std::vector<CheckLine> lines;
};

void run(Task& task, const engines::EngineInfo& info) {
    const Scene scene = task.scene->make_start(task.start);
    if (!info.lacks(scene).empty()) return;
    task.is_built = true;
    const std::unique_ptr<Engine> engine = info.make_exact();
    engine->load(scene);
    for (int step = 0; step < scene.steps; ++step) engine->advance(scene, step, scene.dt);
    task.lines = scene.check(*engine);
}

SteadyRow& row_of(SteadyTable& table, const Task& task, const CheckLine& line) {
    for (SteadyRow& row : table.rows)
        if (row.scene == task.scene->name && row.what == line.what) return row;
    SteadyRow row{task.scene->name, line.what, 0, *line.wanted, std::vector<SteadyValue>(table.engines.size())};
    table.rows.push_back(std::move(row));
    return table.rows.back();
}

void enter(SteadyTable& table, const Task& task) {
    for (const CheckLine& line : task.lines) {
        if (task.engine == 0 && !line.pass())
            table.broken.push_back(
                fmt::format("{}, start {}: {}: {:.4g}, allowed {:.4g} to {:.4g}", task.scene->name, task.start, line.what, line.value, line.low, line.high));
        if (!line.wanted) continue;
        SteadyRow& row = row_of(table, task, line);
        SteadyValue& value = row.engines[task.engine];
        // What is no number is the worst.
        const double seen = std::isfinite(line.value) ? line.value : std::numeric_limits<double>::infinity();
        value.is_known = true;
        value.worst = row.wanted.counts ? value.worst + seen : std::max(value.worst, seen);
        if (!line.pass()) ++value.failed;
        if (task.engine == 0) ++row.starts;
    }
}

/// A number in a column of 9.
std::string figure(double value) {
    return value == 0 || (std::abs(value) >= 0.001 && std::abs(value) < 1e5) ? fmt::format("{:.3g}", value) : fmt::format("{:.1e}", value);
}

std::string figure_of(const SteadyRow& row, const SteadyValue& value) {
    if (!value.is_known) return "-";
    return row.wanted.counts ? fmt::format("{} of {}", value.worst, row.starts) : figure(value.worst);
}

}  // namespace

std::vector<const SceneInfo*> scenes_with_starts() {
    std::vector<const SceneInfo*> scenes;
    for (const SceneInfo& info : catalogue())
        if (info.make_start != nullptr) scenes.push_back(&info);
    return scenes;
}

SteadyTable run_steady(const SteadyOptions& options, const std::function<void(int, int)>& progress) {
    std::vector<Task> tasks;
    for (const SceneInfo* scene : options.scenes) {
        // In the large scenes other engines would follow thousands of bodies from step to step, for minutes.
        const std::size_t engines = std::string(scene->group) == "benchmark" ? 1 : options.engines.size();
        for (std::size_t engine = 0; engine < engines; ++engine)
            for (int start = 0; start < std::min(scene->starts, options.most_starts); ++start) tasks.push_back({scene, engine, start, false, {}});
    }

    // Large scenes stand last in the catalogue: begun first, they do not keep one thread waiting for another in the end.
    std::atomic<std::size_t> next = 0;
    std::mutex mutex;
    int done = 0;
    const auto work = [&] {
        for (std::size_t i = next++; i < tasks.size(); i = next++) {
            Task& task = tasks[tasks.size() - 1 - i];
            run(task, *options.engines[task.engine]);
            const std::lock_guard<std::mutex> lock(mutex);
            progress(++done, static_cast<int>(tasks.size()));
        }
    };
    std::vector<std::thread> threads;
    for (unsigned i = 1; i < options.jobs; ++i) threads.emplace_back(work);
    work();
    for (std::thread& thread : threads) thread.join();

    SteadyTable table;
    for (const engines::EngineInfo* engine : options.engines) table.engines.emplace_back(engine->name);
    for (const Task& task : tasks) enter(table, task);
    return table;
}

std::string table_of(const SteadyTable& table) {
    std::size_t scene_width = 5, what_width = 4;
    for (const SteadyRow& row : table.rows) {
        scene_width = std::max(scene_width, row.scene.size());
        what_width = std::max(what_width, row.what.size());
    }
    std::string text = fmt::format("{:<{}}  {:<{}}  starts", "scene", scene_width, "worst of all starts", what_width);
    for (const std::string& engine : table.engines) text += fmt::format(" {:>9}", engine);
    text += fmt::format(" {:>9}\n", "wanted");
    std::string last;
    std::size_t reached = 0;
    for (const SteadyRow& row : table.rows) {
        text += fmt::format("{:<{}}  {:<{}}  {:>6}", row.scene == last ? "" : row.scene, scene_width, row.what, what_width, row.starts);
        for (const SteadyValue& value : row.engines) text += fmt::format(" {:>9}", figure_of(row, value));
        text += fmt::format(" {:>9}  {}\n", figure(row.wanted.most), row.is_reached() ? "reached" : "NOT REACHED");
        last = row.scene;
        if (row.is_reached()) ++reached;
    }
    return text + fmt::format("{} of {} reached\n", reached, table.rows.size());
}

std::string json_of(const SteadyTable& table) {
    using Json = nlohmann::ordered_json;
    Json list = Json::array();
    for (const SteadyRow& row : table.rows) {
        Json object = {{"scene", row.scene},          {"what", row.what},          {"starts", row.starts},
                       {"counts", row.wanted.counts}, {"wanted", row.wanted.most}, {"reached", row.is_reached()}};
        for (std::size_t i = 0; i < table.engines.size(); ++i)
            object[table.engines[i]] = row.engines[i].is_known && std::isfinite(row.engines[i].worst) ? Json(row.engines[i].worst) : Json(nullptr);
        list.push_back(std::move(object));
    }
    return list.dump(2) + "\n";
}

}  // namespace islet::tools
