// What the sandbox has in WebAssembly beyond the engine's own package: the scenes of the catalogue, made and run by the code that every other program uses.
//
// There are two places for a scene: that of the player, and one where a hash is computed meanwhile.
#include <array>
#include <cstdint>
#include <cstdlib>
#include <memory>

#include <islet/islet.h>

#include "harness/engine.hpp"
#include "scenes/catalogue.hpp"

using namespace islet;
using namespace islet::samples;

namespace {

struct Running {
    Scene scene;
    IsletEngine engine;
    int step = 0;
};

std::array<std::unique_ptr<Running>, 2> places;

}  // namespace

extern "C" {

std::uint32_t sandbox_scene_count() { return static_cast<std::uint32_t>(catalogue().size()); }

/// 0: the name, 1: the group, 2: the description.
const char* sandbox_scene_text(std::uint32_t scene, int which) {
    const SceneInfo& info = catalogue()[scene];
    return which == 0 ? info.name : which == 1 ? info.group : info.description;
}

/// Makes a scene, with room for so many bodies more, of one shape each, and two joints. Returns its world, whose errors the hook gets.
World* sandbox_load(std::uint32_t place, std::uint32_t scene, std::uint32_t more, ErrorHook hook, void* context) {
    places[place] = std::make_unique<Running>();
    Running& running = *places[place];
    running.scene = catalogue()[scene].make();
    running.scene.world.error_hook = hook;
    running.scene.world.error_context = context;
    if (more > 0) {
        running.scene.extra_bodies += more;
        running.scene.extra_shapes += more;
        running.scene.extra_joints += 2;
    }
    running.engine.load(running.scene);
    return &running.engine.world();
}

void sandbox_unload(std::uint32_t place) { places[place].reset(); }

/// A step of the scene, with its script.
void sandbox_step(std::uint32_t place) {
    Running& running = *places[place];
    running.engine.advance(running.scene, running.step++, running.scene.dt);
}

/// The step that a scene without a script is taken back to.
void sandbox_set_step(std::uint32_t place, int step) { places[place]->step = step; }
int sandbox_step_index(std::uint32_t place) { return places[place]->step; }

/// What a script remembers outside of its world does not go back with the world.
bool sandbox_has_script(std::uint32_t place) { return static_cast<bool>(places[place]->scene.before_step); }

float sandbox_time_step(std::uint32_t place) { return places[place]->scene.dt; }

/// What a picture shows: left, bottom, right, top (m).
const float* sandbox_view(std::uint32_t place) { return &places[place]->scene.view.lower.x; }

// WebAssembly's C++ library comes without exceptions. The scenes' loader throws where a scene cannot be made: here that ends the page's engine.
void* __cxa_allocate_exception(unsigned long) { std::abort(); }
void __cxa_throw(void*, void*, void (*)(void*)) { std::abort(); }
void __cxa_free_exception(void*) {}

}  // extern "C"
