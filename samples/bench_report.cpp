// What `islet bench` prints.
#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "bench.hpp"

namespace islet::samples {

std::string table_of(const std::vector<BenchResult>& results) {
    std::size_t scene_width = 5, engine_width = 6;
    for (const BenchResult& r : results) {
        scene_width = std::max(scene_width, r.scene.size());
        engine_width = std::max(engine_width, r.engine.size());
    }
    const auto names = [&](const std::string& scene, const std::string& engine) {
        return fmt::format("{:<{}}  {:<{}}", scene, scene_width, engine, engine_width);
    };

    std::string text = names("scene", "engine") + fmt::format(" {:>7} {:>6} {:>7} {:>9} {:>11} {:>10} {:>10} {:>9}\n", "workers", "steps",
                                                              "bodies", "contacts", "ms in all", "p50 a step", "p99 a step", "x islet");
    std::string last;
    for (const BenchResult& r : results) {
        text += names(r.scene == last ? "" : r.scene, r.engine);
        last = r.scene;
        if (!r.lacks.empty()) {
            text += fmt::format("  not timed: {}\n", r.lacks);
            continue;
        }
        text += fmt::format(" {:>7} {:>6} {:>7} {:>9} {:>11.1f} {:>10.3f} {:>10.3f} {:>9}\n", r.workers, r.steps, r.bodies, r.contacts,
                            r.ms_total, r.ms_per_step_p50, r.ms_per_step_p99, r.ratio ? fmt::format("{:.2f}", *r.ratio) : "-");
    }
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

}  // namespace islet::samples
