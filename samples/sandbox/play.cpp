// What the player does beyond the engine's own functions: works a scene's controls, spawns prefabs, and drives a car.
#include <algorithm>
#include <span>

#include "prefabs/ragdoll.hpp"
#include "sandbox.hpp"

namespace islet::sandbox {
namespace {

/// Whether the world is left without a part: then the rest goes, too.
bool is_whole(const samples::Spawned& made) {
    const auto there = [](const auto id) { return static_cast<bool>(id); };
    return std::all_of(made.bodies.begin(), made.bodies.end(), there) && std::all_of(made.joints.begin(), made.joints.end(), there);
}

/// A body that has moved much less than its speed says was held back by continuous collision, which leaves the speed as it is.
bool was_stopped(const World& world, BodyId body, const Transform& before, float dt) {
    const Vec2 moved = world.transform(body).p - before.p;
    const float way = length(world.linear_velocity(body)) * dt;
    return way > 0.1f && length(moved) < 0.8f * way;
}

}  // namespace

void remember_poses(Running& running) {
    const World& world = running.engine.world();
    const std::uint32_t slots = world.capacity().bodies;
    running.before.resize(slots);
    for (std::uint32_t slot = 0; slot < slots; ++slot) {
        if (const BodyId body = world.body_at(slot)) running.before[slot] = world.transform(body);
    }
}

void find_stops(Running& running) {
    const World& world = running.engine.world();
    constexpr int kept_steps = 60;
    std::erase_if(running.stops, [&](const Stop& stop) { return stop.step + kept_steps < running.step || stop.step > running.step; });
    constexpr std::size_t most = 200;
    for (std::uint32_t slot = 0; slot < running.before.size() && running.stops.size() < most; ++slot) {
        const BodyId body = world.body_at(slot);
        if (!body || world.type(body) != BodyType::dynamic || !world.is_awake(body)) continue;
        if (was_stopped(world, body, running.before[slot], running.scene.dt)) running.stops.push_back({world.position(body), running.step});
    }
}

}  // namespace islet::sandbox

using namespace islet;
using islet::sandbox::Running;
using islet::sandbox::running_at;

extern "C" {

/// A scene's controls (samples::Controls): how many, and of each its name, or the way of the key that it suits: '<', '>', '^' or 'v'.
std::uint32_t sandbox_control_count(std::uint32_t place) {
    const auto& controls = running_at(place).scene.controls;
    return controls ? static_cast<std::uint32_t>(controls->buttons.size()) : 0;
}
const char* sandbox_control_name(std::uint32_t place, std::uint32_t i) { return running_at(place).scene.controls->buttons[i].name; }
int sandbox_control_way(std::uint32_t place, std::uint32_t i) { return running_at(place).scene.controls->buttons[i].way; }
/// Where the player is to get to, x and y (m); null: nowhere.
const float* sandbox_goal(std::uint32_t place) {
    const auto& controls = running_at(place).scene.controls;
    return controls && controls->goal ? &controls->goal->x : nullptr;
}
/// Whether the player has got there.
bool sandbox_has_won(std::uint32_t place) {
    const auto& controls = running_at(place).scene.controls;
    return controls && controls->has_won;
}
/// Whether someone plays; then sandbox_drawn has where what they play is, x and y (m).
bool sandbox_hero(std::uint32_t place) {
    Running& running = running_at(place);
    const auto& controls = running.scene.controls;
    if (!controls || !controls->taken || running.scene.traced.empty() || !running.engine.exists(running.scene.traced[0])) return false;
    const Vec2 p = running.engine.body(running.scene.traced[0]).position;
    running.drawn = {p.x, p.y};
    return true;
}
/// Bit i: control i is held. From the first that is held on, the player plays and not the script.
void sandbox_hold(std::uint32_t place, std::uint32_t held) {
    const auto& controls = running_at(place).scene.controls;
    if (!controls) return;
    controls->held = held;
    if (held != 0) controls->taken = true;
}

/// A person whose middle is at a place. False: there is no room for all of it, and nothing is made.
bool sandbox_spawn_doll(std::uint32_t place, float x, float y) {
    Running& running = running_at(place);
    samples::RagdollDef def;
    def.position = {x, y - 0.5f * def.height};
    constexpr int first_group = -1000;  // out of the way of those that scenes use
    def.filter.group = first_group - running.dolls++;
    return static_cast<bool>(samples::create_ragdoll(running.engine.world(), def));
}

/// A car whose middle is at a place, which sandbox_drive drives from now on. False: there is no room for all of it, and nothing is made.
bool sandbox_spawn_car(std::uint32_t place, float x, float y) {
    Running& running = running_at(place);
    World& world = running.engine.world();
    sandbox::Car car;
    const samples::CarDef def = {.position = {x, y - 0.7f}};
    const samples::Spawned made = samples::spawn(world, def, car.bodies, car.struts);
    const bool whole = sandbox::is_whole(made);
    if (whole)
        running.car = car;
    else
        for (const BodyId body : car.bodies)
            if (world.is_valid(body)) world.destroy_body(body);
    return whole;
}

/// Whether there is a car to drive.
bool sandbox_has_car(std::uint32_t place) {
    Running& running = running_at(place);
    const World& world = running.engine.world();
    const auto valid = [&](const auto id) { return id && world.is_valid(id); };
    return std::all_of(running.car.bodies, running.car.bodies + 3, valid) && std::all_of(running.car.struts, running.car.struts + 2, valid);
}

/// Drives the newest car at a speed, m/s to the right; at 0 its wheels turn freely.
void sandbox_drive(std::uint32_t place, float speed) {
    Running& running = running_at(place);
    if (!sandbox_has_car(place)) return;
    World& world = running.engine.world();
    const samples::Spawned car = {running.car.bodies, running.car.struts};
    world.wake(running.car.bodies[0]);
    if (speed == 0)
        samples::coast(world, car);
    else
        samples::drive(world, car, speed);
}

/// Watches where continuous collision holds bodies back.
void sandbox_watch_stops(std::uint32_t place, bool on) {
    Running& running = running_at(place);
    running.watches_stops = on;
    if (!on) running.stops.clear();
}

}  // extern "C"
