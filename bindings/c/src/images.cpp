// Functions of islet.h: images.
//
// Made by bindings/c/generate.py; do not edit.
#include "glue.hpp"

using namespace islet;
using namespace islet::c;

extern "C" {

IsletError islet_world_counters(const IsletWorld* world, IsletWorldCounters* out) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (!fits<WorldCounters>(world, out)) return why(out);
    give<WorldCounters>(out, of(world).counters());
    return ISLET_ERROR_NONE;
}

size_t islet_world_snapshot_bytes(const IsletWorld* world) {
    size_t found = {};
    if (world != nullptr) found = of(world).snapshot_bytes();
    return found;
}

size_t islet_world_save(const IsletWorld* world, void* out, size_t out_bytes) {
    size_t found = {};
    if (world != nullptr && is_there(world, out, out_bytes)) found = of(world).save(span_of<std::byte>(out, out_bytes));
    return found;
}

bool islet_world_restore(IsletWorld* world, const void* image, size_t image_bytes) {
    bool found = {};
    if (world != nullptr && is_there(world, image, image_bytes)) found = of(world).restore(span_of<const std::byte>(image, image_bytes));
    return found;
}

bool islet_world_load(IsletWorld* world, const void* image, size_t image_bytes) {
    bool found = {};
    if (world != nullptr && is_there(world, image, image_bytes)) found = of(world).load(span_of<const std::byte>(image, image_bytes));
    return found;
}

IsletError islet_read_format(const void* bytes, size_t bytes_bytes, IsletFormatInfo* out) {
    if (!is_there(nullptr, bytes, bytes_bytes)) return ISLET_ERROR_NULL_POINTER;
    if (!fits<FormatInfo>(nullptr, out)) return why(out);
    give<FormatInfo>(out, islet::read_format(span_of<const std::byte>(bytes, bytes_bytes)));
    return ISLET_ERROR_NONE;
}

size_t islet_describe_format(const IsletFormatInfo* info, char* out, size_t out_bytes) {
    Room<FormatInfo> info_room;
    const FormatInfo* info_taken = nullptr;
    size_t found = {};
    if ((info_taken = take<FormatInfo>(nullptr, info, info_room)) != nullptr && is_there(nullptr, out, out_bytes))
        found = islet::describe_format(*info_taken, span_of<char>(out, out_bytes));
    return found;
}

size_t islet_max_snapshot_bytes(const IsletCapacity* capacity) {
    Room<Capacity> capacity_room;
    const Capacity* capacity_taken = nullptr;
    size_t found = {};
    if ((capacity_taken = take<Capacity>(nullptr, capacity, capacity_room)) != nullptr) found = islet::max_snapshot_bytes(*capacity_taken);
    return found;
}

size_t islet_max_delta_bytes(size_t to_bytes) {
    return islet::max_delta_bytes(to_bytes);
}

size_t islet_delta(const void* from, size_t from_bytes, const void* to, size_t to_bytes, void* out, size_t out_bytes, IsletError* error) {
    size_t found = {};
    if (is_there(nullptr, from, from_bytes) && is_there(nullptr, to, to_bytes) && is_there(nullptr, out, out_bytes))
        found = islet::delta(span_of<const std::byte>(from, from_bytes), span_of<const std::byte>(to, to_bytes), span_of<std::byte>(out, out_bytes), cast<Error>(error));
    return found;
}

size_t islet_apply(const void* from, size_t from_bytes, const void* delta, size_t delta_bytes, void* out, size_t out_bytes, IsletError* error) {
    size_t found = {};
    if (is_there(nullptr, from, from_bytes) && is_there(nullptr, delta, delta_bytes) && is_there(nullptr, out, out_bytes))
        found = islet::apply(span_of<const std::byte>(from, from_bytes), span_of<const std::byte>(delta, delta_bytes), span_of<std::byte>(out, out_bytes), cast<Error>(error));
    return found;
}

}  // extern "C"
