// What games do with a world besides letting things fall: gates that count, explosions, wind, conveyors. Scripts that ask or push the world itself need
// Islet; in other engines they do nothing.
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "build.hpp"
#include "harness/checks.hpp"
#include "scenes.hpp"

namespace islet::samples {
namespace {

World* world_of(Engine& engine) {
    auto* const islet = dynamic_cast<IsletEngine*>(&engine);
    return islet != nullptr ? &islet->world() : nullptr;
}
const World* world_of(const Engine& engine) {
    const auto* const islet = dynamic_cast<const IsletEngine*>(&engine);
    return islet != nullptr ? &islet->world() : nullptr;
}

}  // namespace

// Three gates, each a sensor that knows its number by its user data, and a tray at the bottom in which all balls come to rest.
Scene make_sensors() {
    constexpr int balls = 24;
    constexpr float gates[] = {6, 4, 2};
    Scene scene;
    scene.name = "sensors";
    scene.steps = 480;
    scene.view = {{-6, -1}, {6, 12}};
    for (std::uint64_t i = 0; i < 3; ++i) {
        ShapeDef def;
        def.sensor = true;
        def.user_data = 1 + i;
        add_static(scene, {0, gates[i]}, make_box(5, 0.1f), def);
    }
    add_static(scene, {0, -0.5f}, make_box(5.5f, 0.5f));
    for (const float side : {-1.0f, 1.0f}) add_static(scene, {5.25f * side, 4}, make_box(0.25f, 5));
    ShapeDef tray;
    tray.sensor = true;
    tray.user_data = 4;
    add_static(scene, {0, 1}, make_box(5, 0.9f), tray);
    for (int i = 0; i < balls; ++i) {
        ShapeDef def;
        def.rolling_resistance = 0.1f;
        add_dynamic(scene, {-4.5f + 0.75f * static_cast<float>(i % 12) + 0.2f * static_cast<float>(i / 12), 8 + 1.5f * static_cast<float>(i / 12)},
                    Circle{{0, 0}, 0.2f + 0.01f * static_cast<float>(i % 5)}, def);
    }

    struct Seen {
        int begun[5] = {}, ended[5] = {};
    };
    auto seen = std::make_shared<Seen>();
    scene.after_step = [seen](const Engine& engine, int step) {
        const World* const w = world_of(engine);
        if (w == nullptr) return;
        if (step == 0) *seen = {};
        for (const SensorEvent& e : w->sensor_begin_events()) ++seen->begun[w->user_data(e.sensor)];
        for (const SensorEvent& e : w->sensor_end_events()) ++seen->ended[w->user_data(e.sensor)];
    };
    scene.check = [seen](const Engine& engine) {
        std::vector<CheckLine> lines;
        for (int gate = 1; gate <= 3; ++gate) {
            lines.push_back(near_line("balls that came to gate " + std::to_string(gate), seen->begun[gate], balls, 0));
            lines.push_back(near_line("and went", seen->ended[gate], balls, 0));
        }
        lines.push_back(near_line("balls in the tray", seen->begun[4] - seen->ended[4], balls, 0));
        lines.push_back(near_line("bodies awake in the end", static_cast<double>(engine.counts().awake_bodies), 0, 0));
        return lines;
    };
    return scene;
}

// Crates asleep on shelves around a charge. When it goes off each flies with J w s / m: w its width as seen from there, s what the falloff leaves.
Scene make_explosion() {
    constexpr int crates = 16, at_step = 60;
    constexpr float half = 0.3f, radius = 4, falloff = 4, strength = 8;  // m, m, m, N s/m
    Scene scene;
    scene.name = "explosion";
    scene.steps = 240;
    scene.world.gravity = {0, 0};
    scene.view = {{-14, -14}, {14, 14}};
    struct Crate {
        std::size_t body;
        float gap;  // m, from the charge to its nearest face
        Vec2 away;
    };
    std::vector<Crate> all;
    for (int i = 0; i < crates; ++i) {
        const float angle = 2 * pi * static_cast<float>(i) / crates, distance = 2 + 0.5f * static_cast<float>(i % 8);
        const Vec2 away = rotate(make_rot(angle), {1, 0});
        all.push_back({add_dynamic(scene, distance * away, make_box(half, half), {}, angle), distance - half, away});
        scene.traced.push_back(all.back().body);
    }
    struct Blast {
        double wrong = 0;   // m/s, farthest from the formula
        double turned = 0;  // rad/s
    };
    auto blast = std::make_shared<Blast>();
    scene.before_step = [blast, all](Engine& engine, int step) {
        World* const w = world_of(engine);
        if (w == nullptr || step != at_step) return;
        *blast = {};
        w->explode({.radius = radius, .falloff = falloff, .impulse_per_length = strength});
        for (const Crate& c : all) {
            const BodyState state = engine.body(c.body);
            const float left = c.gap > radius ? (radius + falloff - c.gap) / falloff : 1;
            const Vec2 due = (strength * 2 * half * left / state.mass) * c.away;
            blast->wrong = std::max(blast->wrong, double(length(state.linear_velocity - due)));
            blast->turned = std::max(blast->turned, std::abs(double(state.angular_velocity)));
        }
    };
    scene.check = [blast, all](const Engine& engine) {
        double least = 1e9;
        for (const Crate& c : all) least = std::min(least, double(length(engine.body(c.body).position)));
        return std::vector<CheckLine>{
            at_most("speed after the blast is off from the formula by (m/s)", blast->wrong, 1e-3),
            at_most("a crate that faces it turns (rad/s)", blast->turned, 1e-2),
            {"the nearest crate is from the middle (m)", least, 10, 1000},
            near_line("bodies that are not finite", static_cast<double>(count_not_finite(engine)), 0, 0),
        };
    };
    return scene;
}

// Discs fall through still air, each until its drag bears its weight, m g = rho c A v^2 / 2; and a wind from below holds one up.
Scene make_wind() {
    constexpr float radius = 0.25f, drag = 1;
    constexpr float densities[] = {0.5f, 1, 2, 4};
    Scene scene = sleepless_scene("wind", 900, {{-5, -60}, {7, 8}});
    struct Disc {
        std::size_t body;
        float density;
    };
    std::vector<Disc> discs;
    for (const float density : densities) {
        ShapeDef def;
        def.density = density;
        discs.push_back({add_dynamic(scene, {2 * static_cast<float>(discs.size()) - 4, 5}, Circle{{0, 0}, radius}, def), density});
        scene.traced.push_back(discs.back().body);
    }
    const float rho = WindDef{}.density;
    const auto terminal = [rho](float density) { return std::sqrt(density * pi * radius * radius * 10 / (0.5f * rho * drag * 2 * radius)); };
    const std::size_t held = add_dynamic(scene, {5, 0}, Circle{{0, 0}, radius});
    scene.before_step = [discs, held, terminal](Engine& engine, int) {
        World* const w = world_of(engine);
        if (w == nullptr) return;
        const auto blow = [&](std::size_t index, Vec2 velocity) {
            ShapeId shape;
            w->shapes(w->body_at(static_cast<std::uint32_t>(index)), {&shape, 1});
            w->apply_wind(shape, {.velocity = velocity, .drag = drag});
        };
        for (const Disc& d : discs) blow(d.body, {0, 0});
        blow(held, {0, terminal(1)});
    };
    scene.check = [discs, held, terminal](const Engine& engine) {
        std::vector<CheckLine> lines;
        for (const Disc& d : discs) {
            const double due = double(terminal(d.density));
            lines.push_back(near_line("speed of the disc of " + std::to_string(d.density).substr(0, 3) + " kg/m^2 (m/s)",
                                      -double(engine.body(d.body).linear_velocity.y), due, 0.02 * due));
        }
        lines.push_back(near_line("speed of the disc held up (m/s)", double(engine.body(held).linear_velocity.y), 0, 0.05));
        return lines;
    };
    return scene;
}

// Boxes set down on belts: each slides until it has the belt's speed, v = mu g t, and has then fallen behind by v^2 / (2 mu g).
Scene make_conveyor() {
    constexpr float half = 0.25f, friction = 0.4f, gravity = 10;
    constexpr float speeds[] = {0.5f, 1, 2, 3};
    Scene scene = sleepless_scene("conveyor", 150, {{-7, -1}, {7, 8}});
    struct Ride {
        std::size_t body;
        float speed;
    };
    std::vector<Ride> rides;
    for (const float speed : speeds) {
        const float height = 2 * static_cast<float>(rides.size());
        ShapeDef belt;
        belt.friction = friction;
        belt.tangent_speed = speed;
        add_static(scene, {0, height - 0.1f}, make_box(6, 0.1f), belt);
        ShapeDef def;
        def.friction = friction;
        rides.push_back({add_dynamic(scene, {-5, height + half}, make_box(half, half), def), speed});
        scene.traced.push_back(rides.back().body);
    }
    scene.check = [rides, t = double(scene.dt) * scene.steps](const Engine& engine) {
        std::vector<CheckLine> lines;
        for (const Ride& r : rides) {
            const double v = double(r.speed), way = v * t - v * v / (2 * double(friction) * double(gravity));
            const BodyState state = engine.body(r.body);
            lines.push_back(near_line("speed on the belt of " + std::to_string(r.speed).substr(0, 3) + " m/s (m/s)", double(state.linear_velocity.x), v, 0.01));
            lines.push_back(near_line("and how far it came (m)", double(state.position.x) + 5, way, 0.03));
        }
        return lines;
    };
    return scene;
}

}  // namespace islet::samples
