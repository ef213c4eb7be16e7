// Functions of islet.h: recording.
//
// Made by bindings/c/generate.py; do not edit.
#include "glue.hpp"

using namespace islet;
using namespace islet::c;

extern "C" {

bool islet_world_start_recording(IsletWorld* world, void* buffer, size_t buffer_bytes, bool bodies) {
    if (world == nullptr) return false;
    if (buffer == nullptr && buffer_bytes != 0) return refuse(world, ISLET_ERROR_NULL_POINTER), false;
    return of(world).start_recording(span_of<std::byte>(buffer, buffer_bytes), bodies);
}

bool islet_world_is_recording(const IsletWorld* world) {
    if (world == nullptr) return false;
    return of(world).is_recording();
}

size_t islet_world_recorded_bytes(const IsletWorld* world) {
    if (world == nullptr) return 0;
    return of(world).recorded_bytes();
}

bool islet_world_move_recording(IsletWorld* world, void* buffer, size_t buffer_bytes) {
    if (world == nullptr) return false;
    if (buffer == nullptr && buffer_bytes != 0) return refuse(world, ISLET_ERROR_NULL_POINTER), false;
    return of(world).move_recording(span_of<std::byte>(buffer, buffer_bytes));
}

size_t islet_world_stop_recording(IsletWorld* world) {
    if (world == nullptr) return 0;
    return of(world).stop_recording();
}

IsletError islet_replay(IsletWorld* world, const void* recording, size_t recording_bytes, uint64_t steps, IsletReplayResult* out) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (recording == nullptr && recording_bytes != 0) return refuse(world, ISLET_ERROR_NULL_POINTER);
    if (!fits<ReplayResult>(world, out)) return why(out);
    give<ReplayResult>(out, islet::replay(of(world), span_of<const std::byte>(recording, recording_bytes), steps));
    return ISLET_ERROR_NONE;
}

}  // extern "C"
