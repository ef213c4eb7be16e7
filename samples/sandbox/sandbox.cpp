// What the sandbox has in WebAssembly beyond the engine's own package: the scenes of the catalogue, made and run by the code that every other program uses.
//
// There are places for some scenes: that of the player, one where a hash is computed meanwhile, and those of the gallery (src/gallery.ts).
#include <array>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <memory>
#include <utility>

#include <islet/islet.h>

#include "sandbox.hpp"
#include "scenes/catalogue.hpp"

using namespace islet;
using namespace islet::samples;

namespace islet::sandbox {
namespace {

std::array<std::unique_ptr<Running>, 16> places;

}  // namespace

Running& running_at(std::uint32_t place) { return *places[place]; }

World* run_scene(std::uint32_t place, Scene scene, std::uint32_t more, ErrorHook hook, void* context) {
    places[place] = std::make_unique<Running>();
    Running& running = *places[place];
    running.scene = std::move(scene);
    running.scene.world.error_hook = hook;
    running.scene.world.error_context = context;
    if (more > 0) {
        // A ragdoll has 13 shapes and 10 joints for its 11 bodies; a drawn shape may have many pieces.
        running.scene.extra_bodies += more;
        running.scene.extra_shapes += 3 * more;
        running.scene.extra_joints += more + 2;
    }
    running.engine.load(running.scene);
    return &running.engine.world();
}

}  // namespace islet::sandbox

using namespace islet::sandbox;

/// Ends a call with an error in JavaScript that has this sentence.
extern "C" [[noreturn]] [[clang::import_module("sandbox"), clang::import_name("thrown")]] void sandbox_thrown(const char* sentence);

extern "C" {

std::uint32_t sandbox_scene_count() { return static_cast<std::uint32_t>(catalogue().size()); }

/// 0: the name, 1: the group, 2: the description.
const char* sandbox_scene_text(std::uint32_t scene, int which) {
    const SceneInfo& info = catalogue()[scene];
    return which == 0 ? info.name : which == 1 ? info.group : info.description;
}

/// Makes a scene, with room for so many bodies more. Returns its world, whose errors the hook gets.
World* sandbox_load(std::uint32_t place, std::uint32_t scene, std::uint32_t more, ErrorHook hook, void* context) {
    return run_scene(place, catalogue()[scene].make(), more, hook, context);
}

void sandbox_unload(std::uint32_t place) { islet::sandbox::places[place].reset(); }

/// A step of the scene, with its script.
void sandbox_step(std::uint32_t place) {
    Running& running = running_at(place);
    if (running.watches_stops) remember_poses(running);
    running.engine.advance(running.scene, running.step++, running.scene.dt);
    if (running.watches_stops) find_stops(running);
}

/// The step that a scene without a script is taken back to.
void sandbox_set_step(std::uint32_t place, int step) { running_at(place).step = step; }
int sandbox_step_index(std::uint32_t place) { return running_at(place).step; }

/// What a script remembers outside of its world does not go back with the world.
bool sandbox_has_script(std::uint32_t place) { return static_cast<bool>(running_at(place).scene.before_step); }

float sandbox_time_step(std::uint32_t place) { return running_at(place).scene.dt; }

/// What a picture shows: left, bottom, right, top (m).
const float* sandbox_view(std::uint32_t place) { return &running_at(place).scene.view.lower.x; }

// WebAssembly's C++ library comes without exceptions, and nothing can be caught. What is thrown, all of it a std::exception, ends the call from JavaScript,
// which gets the sentence. What the call has made so far is lost: so a scene of the player's is read in an instance of its own first (src/scene_text.ts).
void* __cxa_allocate_exception(unsigned long bytes) { return std::malloc(bytes); }
void __cxa_throw(void* thrown, void*, void (*)(void*)) { sandbox_thrown(static_cast<std::exception*>(thrown)->what()); }
void __cxa_free_exception(void*) {}

}  // extern "C"
