// A scene that runs in the page, and what its parts in C++ share.
#pragma once

#include <cstdint>
#include <vector>

#include "harness/engine.hpp"
#include "prefabs/car.hpp"

namespace islet::sandbox {

struct Car {
    BodyId bodies[3] = {};
    JointId struts[2] = {};
};

/// Where continuous collision held a body back.
struct Stop {
    Vec2 place;
    int step = 0;
};

struct Running {
    samples::Scene scene;
    samples::IsletEngine engine;
    int step = 0;
    Car car;                        // the newest that was spawned
    int dolls = 0;                  // spawned so far: each has a group of its own
    bool watches_stops = false;
    std::vector<Stop> stops;        // the newest last
    std::vector<Transform> before;  // poses before the step, by slot, while stops are watched
    std::vector<float> drawn;       // what sandbox_draw has left
    std::string text;               // what sandbox_save has left
};

/// The scene in a place: 0 is the player's.
Running& running_at(std::uint32_t place);
/// Puts a scene into a place, with room for so many bodies more. Returns its world, whose errors the hook gets.
World* run_scene(std::uint32_t place, samples::Scene scene, std::uint32_t more, ErrorHook hook, void* context);

/// Before and after a step: finds where continuous collision held bodies back.
void remember_poses(Running& running);
void find_stops(Running& running);

/// The world as it is, as a scene. Scripts and hooks are not part of it, nor are joints whose user data is `leave_out`.
samples::Scene scene_of(const Running& running, std::uint64_t leave_out);

}  // namespace islet::sandbox
