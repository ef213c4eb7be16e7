// Scenes as JSON (samples/scene_files/): the page reads and writes them by the code of the program `islet`.
#include <cstring>
#include <stdexcept>
#include <string>

#include "sandbox.hpp"
#include "scene_files/scene_file.hpp"

using namespace islet;
using islet::sandbox::Running;
using islet::sandbox::running_at;

namespace {

std::string given;  // the text of a scene

/// A page has less memory than a machine.
constexpr std::size_t most_bytes = 256u << 20;

}  // namespace

extern "C" {

/// Memory for a text of so many bytes, which sandbox_load_text reads.
char* sandbox_text(std::uint32_t bytes) {
    given.assign(bytes, ' ');
    return given.data();
}

/// Like sandbox_load, for the scene in the text. What is wrong with it is thrown.
World* sandbox_load_text(std::uint32_t place, std::uint32_t more, ErrorHook hook, void* context) {
    samples::Scene scene = samples::read_scene(given);
    given.clear();
    given.shrink_to_fit();
    if (scene.name.empty()) scene.name = "scene";
    samples::Scene whole = scene;
    whole.extra_bodies += more;
    whole.extra_shapes += 3 * more;
    const Capacity capacity = samples::capacity_of(whole);
    if (!is_valid(capacity) || world_bytes(capacity) > most_bytes)
        throw std::runtime_error("The scene is too large for this page: its world would take more than 256 MB");
    return sandbox::run_scene(place, std::move(scene), more, hook, context);
}

/// The world as it is, as a scene file. Joints with this user data are left out.
const char* sandbox_save(std::uint32_t place, std::uint32_t leave_out) {
    Running& running = running_at(place);
    running.text = samples::write_scene(sandbox::scene_of(running, leave_out));
    return running.text.c_str();
}

}  // extern "C"
