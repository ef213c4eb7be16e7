// Functions of islet.h: recording.
//
// Made by bindings/c/generate.py; do not edit.
#include "glue.hpp"

using namespace islet;
using namespace islet::c;

extern "C" {

bool islet_world_start_recording(IsletWorld* world, void* buffer, size_t buffer_bytes, bool bodies) {
    bool found = {};
    if (world != nullptr && is_there(world, buffer, buffer_bytes))
        found = of(world).start_recording(span_of<std::byte>(buffer, buffer_bytes), bodies);
    return found;
}

bool islet_world_is_recording(const IsletWorld* world) {
    bool found = {};
    if (world != nullptr) found = of(world).is_recording();
    return found;
}

size_t islet_world_recorded_bytes(const IsletWorld* world) {
    size_t found = {};
    if (world != nullptr) found = of(world).recorded_bytes();
    return found;
}

bool islet_world_move_recording(IsletWorld* world, void* buffer, size_t buffer_bytes) {
    bool found = {};
    if (world != nullptr && is_there(world, buffer, buffer_bytes)) found = of(world).move_recording(span_of<std::byte>(buffer, buffer_bytes));
    return found;
}

size_t islet_world_stop_recording(IsletWorld* world) {
    size_t found = {};
    if (world != nullptr) found = of(world).stop_recording();
    return found;
}

IsletError islet_replay(IsletWorld* world, const void* recording, size_t recording_bytes, uint64_t steps, IsletReplayResult* out) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (!is_there(world, recording, recording_bytes)) return ISLET_ERROR_NULL_POINTER;
    if (!fits<ReplayResult>(world, out)) return why(out);
    give<ReplayResult>(out, islet::replay(of(world), span_of<const std::byte>(recording, recording_bytes), steps));
    return ISLET_ERROR_NONE;
}

}  // extern "C"
