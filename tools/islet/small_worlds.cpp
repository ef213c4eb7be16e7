#include "small_worlds.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "common/statistics.hpp"
#include "harness/engine.hpp"
#include "prefabs/chain.hpp"
#include "scenes/benchmark_doll.hpp"
#include "scenes/build.hpp"
#include "scenes/prefab_scene.hpp"

namespace islet::tools {
namespace {

using namespace samples;

// Instructions a step are the difference of two runs, so what making the world takes does not count.
constexpr int few_steps = 100, many_steps = 200;

Scene on_a_floor() {
    Scene scene;
    scene.world.enable_sleep = false;
    add_floor(scene, 30);
    return scene;
}

template <int rows>
Scene make_boxes() {
    Scene scene = on_a_floor();
    add_pyramid(scene, rows, 0.5f, -0.5f * rows, 0);
    return scene;
}

/// A box on two driven wheels, and eight boxes on the floor beside it.
Scene make_small_car() {
    constexpr float radius = 0.4f;  // m
    Scene scene = on_a_floor();
    const std::size_t chassis = add_dynamic(scene, {0, 1}, make_box(1.5f, 0.3f));
    for (const float x : {-1.0f, 1.0f}) {
        const Vec2 hub = {x, radius};
        const std::size_t wheel = add_dynamic(scene, hub, Circle{{}, radius});
        WheelJointDef strut = wheel_at(scene, chassis, wheel, hub, {0, 1});
        strut.motor = {.enable = true, .speed = -2, .max_force = 8};  // rad/s, N m
        add_joint(scene, chassis, wheel, strut);
    }
    for (int i = 0; i < 8; ++i) add_dynamic(scene, {-6 - 1.5f * static_cast<float>(i), 0.5f}, make_box(0.5f, 0.5f));
    return scene;
}

Scene make_small_ragdoll() {
    Scene scene = on_a_floor();
    add_prefab(scene, make_benchmark_doll({.position = {0, 0.5f}}));
    return scene;
}

Scene make_small_chain() {
    Scene scene = on_a_floor();
    ChainDef def;
    def.from = {0, 6};
    def.to = {2, 6};
    def.links = 10;
    def.hold_from = true;
    add_prefab(scene, prefab_of(def));
    return scene;
}

/// Eight columns of balls, each row set off a little from the one below.
Scene make_small_balls() {
    constexpr float radius = 0.25f;  // m
    Scene scene = on_a_floor();
    for (int row = 0; row < 8; ++row) {
        for (int column = 0; column < 8; ++column)
            add_dynamic(scene,
                        {2.0f * radius * static_cast<float>(column) + 0.05f * static_cast<float>(row % 2), radius + 2.0f * radius * static_cast<float>(row)},
                        Circle{{}, radius});
    }
    return scene;
}

/// What a command prints; nothing if it fails.
std::optional<std::string> output_of(const std::string& command) {
    std::FILE* const pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) return std::nullopt;
    std::string text;
    std::array<char, 4096> piece{};
    while (const std::size_t got = std::fread(piece.data(), 1, piece.size(), pipe)) text.append(piece.data(), got);
    if (pclose(pipe) != 0) return std::nullopt;
    return text;
}

std::string quoted(const std::string& word) {
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

/// The instructions of a run of so many steps, as valgrind counts them.
std::uint64_t instructions_of(const std::string& program, const SmallWorld& world, int steps, std::uint32_t lanes) {
    const std::optional<std::string> said =
        output_of(fmt::format("valgrind --tool=callgrind --callgrind-out-file=/dev/null {} bench --small-world {} --steps {} --lanes {} 2>&1", quoted(program),
                              world.name, steps, lanes));
    constexpr const char* word = "Collected :";
    const std::size_t at = said ? said->find(word) : std::string::npos;
    if (at == std::string::npos)
        throw std::runtime_error(fmt::format("valgrind cannot count the instructions of '{}'{}", world.name, said ? ": " + *said : ""));
    return std::strtoull(said->c_str() + at + std::char_traits<char>::length(word), nullptr, 10);
}

SmallResult measure(const SmallOptions& options, const SmallWorld& world, std::uint32_t lanes) {
    SmallResult result;
    result.world = world.name;
    result.lanes = lanes;
    if (options.program.empty()) {
        result.us = 1e6 * step_small_world(world, many_steps, lanes);
    } else {
        const std::uint64_t few = instructions_of(options.program, world, few_steps, lanes);
        result.instructions = (instructions_of(options.program, world, many_steps, lanes) - few) / (many_steps - few_steps);
    }
    return result;
}

}  // namespace

const std::vector<SmallWorld>& small_worlds() {
    static const std::vector<SmallWorld> list = {
        {"boxes_3", make_boxes<2>},      {"boxes_10", make_boxes<4>},       {"boxes_55", make_boxes<10>},   {"car_beside_8_boxes", make_small_car},
        {"ragdoll", make_small_ragdoll}, {"chain_of_10", make_small_chain}, {"balls_64", make_small_balls},
    };
    return list;
}

const SmallWorld* find_small_world(const std::string& name) {
    for (const SmallWorld& world : small_worlds())
        if (name == world.name) return &world;
    return nullptr;
}

double step_small_world(const SmallWorld& world, int steps, std::uint32_t lanes) {
    Scene scene = world.make();
    scene.world.lanes = lanes;
    IsletEngine engine;
    engine.load(scene);
    std::vector<double> ms;
    for (int i = 0; i < steps; ++i) ms.push_back(engine.advance(scene, i, scene.dt));
    return median(ms) / 1e3;
}

std::vector<std::uint32_t> compared_lanes() {
    Scene scene = small_worlds().front().make();
    IsletEngine engine;
    engine.load(scene);
    const std::uint32_t widest = std::min(engine.world().lanes(), 8u);  // callgrind knows no AVX-512
    return widest == 1 ? std::vector<std::uint32_t>{1} : std::vector<std::uint32_t>{1, widest};
}

bool has_valgrind() { return output_of("valgrind --version 2>/dev/null").has_value(); }

std::vector<SmallResult> measure_small_worlds(const SmallOptions& options, const std::function<void(const SmallResult&)>& ended) {
    std::vector<SmallResult> results;
    for (const SmallWorld* world : options.worlds) {
        for (const std::uint32_t lanes : compared_lanes()) {
            results.push_back(measure(options, *world, lanes));
            ended(results.back());
        }
    }
    return results;
}

std::string small_header(bool counts) { return fmt::format("{:<18} {:>5} {:>20}\n", "world", "lanes", counts ? "instructions a step" : "us a step"); }

std::string small_row(const SmallResult& r) {
    return fmt::format("{:<18} {:>5} {:>20}\n", r.world, r.lanes, r.instructions ? fmt::format("{}", *r.instructions) : fmt::format("{:.2f}", r.us));
}

std::string json_of(const std::vector<SmallResult>& results) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const SmallResult& r : results) {
        nlohmann::ordered_json object = {{"world", r.world}, {"lanes", r.lanes}};
        if (r.instructions)
            object["instructions_per_step"] = *r.instructions;
        else
            object["us_per_step"] = r.us;
        list.push_back(std::move(object));
    }
    return list.dump(2) + "\n";
}

}  // namespace islet::tools
