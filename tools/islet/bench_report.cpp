// What `islet bench` prints.
#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "bench.hpp"

namespace islet::tools {

BenchTable::BenchTable(const std::vector<std::string>& scenes, const std::vector<std::string>& engines) {
    for (const std::string& scene : scenes) scene_width_ = std::max(scene_width_, scene.size());
    for (const std::string& engine : engines) engine_width_ = std::max(engine_width_, engine.size());
}

std::string BenchTable::names(const std::string& scene, const std::string& engine) const {
    return fmt::format("{:<{}}  {:<{}}", scene, scene_width_, engine, engine_width_);
}

std::string BenchTable::header() const {
    return names("scene", "engine") + fmt::format(" {:>7} {:>6} {:>7} {:>9} {:>11} {:>10} {:>10} {:>9}\n", "workers", "steps", "bodies", "contacts",
                                                  "ms in all", "p50 a step", "p99 a step", "x islet");
}

std::string BenchTable::row(const BenchResult& r) {
    const std::string begin = names(r.scene == last_scene_ ? "" : r.scene, r.engine);
    last_scene_ = r.scene;
    if (!r.lacks.empty()) return begin + fmt::format("  not timed: {}\n", r.lacks);
    return begin + fmt::format(" {:>7} {:>6} {:>7} {:>9} {:>11.1f} {:>10.3f} {:>10.3f} {:>9}\n", r.workers, r.steps, r.bodies, r.contacts, r.ms_total,
                               r.ms_per_step_p50, r.ms_per_step_p99, r.ratio ? fmt::format("{:.2f}", *r.ratio) : "-");
}

std::string table_of(const std::vector<BenchResult>& results) {
    std::vector<std::string> scenes, engines;
    for (const BenchResult& r : results) {
        scenes.push_back(r.scene);
        engines.push_back(r.engine);
    }
    BenchTable table(scenes, engines);
    std::string text = table.header();
    for (const BenchResult& r : results) text += table.row(r);
    return text;
}

std::string json_of(const std::vector<BenchResult>& results) {
    using Json = nlohmann::ordered_json;
    Json list = Json::array();
    for (const BenchResult& r : results) {
        Json object = {{"engine", r.engine}, {"scene", r.scene}};
        if (!r.lacks.empty()) {
            object["unsupported"] = r.lacks;
            list.push_back(std::move(object));
            continue;
        }
        object["workers"] = r.workers;
        object["steps"] = r.steps;
        object["bodies"] = r.bodies;
        object["contacts"] = r.contacts;
        object["ms_total"] = r.ms_total;
        object["ms_per_step_p50"] = r.ms_per_step_p50;
        object["ms_per_step_p99"] = r.ms_per_step_p99;
        object["profile"] = nullptr;
        if (r.profile) {
            const BenchProfile& p = *r.profile;
            object["profile"] = {{"pairs", p.pairs}, {"collide", p.collide}, {"islands", p.islands}, {"solve", p.solve}, {"finish", p.finish}};
        }
        object["ratio"] = r.ratio ? Json(*r.ratio) : Json(nullptr);
        list.push_back(std::move(object));
    }
    return list.dump(2) + "\n";
}

}  // namespace islet::tools
