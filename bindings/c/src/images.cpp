// Functions of islet.h: images.
//
// Made by bindings/c/generate.py; do not edit.
#include "glue.hpp"

using namespace islet;
using namespace islet::c;

extern "C" {

IsletError islet_read_format(const void* bytes, size_t bytes_bytes, IsletFormatInfo* out) {
    if (bytes == nullptr && bytes_bytes != 0) return refuse(nullptr, ISLET_ERROR_NULL_POINTER);
    if (!fits<FormatInfo>(nullptr, out)) return why(out);
    give<FormatInfo>(out, islet::read_format(span_of<const std::byte>(bytes, bytes_bytes)));
    return ISLET_ERROR_NONE;
}

size_t islet_describe_format(const IsletFormatInfo* info, char* out, size_t out_bytes) {
    Room<FormatInfo> info_room;
    const FormatInfo* info_taken = take<FormatInfo>(nullptr, info, info_room);
    if (info_taken == nullptr) return 0;
    if (out == nullptr && out_bytes != 0) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), 0;
    return islet::describe_format(*info_taken, span_of<char>(out, out_bytes));
}

IsletError islet_world_counters(const IsletWorld* world, IsletWorldCounters* out) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    if (!fits<WorldCounters>(world, out)) return why(out);
    give<WorldCounters>(out, of(world).counters());
    return ISLET_ERROR_NONE;
}

size_t islet_world_snapshot_bytes(const IsletWorld* world) {
    if (world == nullptr) return 0;
    return of(world).snapshot_bytes();
}

size_t islet_world_save(const IsletWorld* world, void* out, size_t out_bytes) {
    if (world == nullptr) return 0;
    if (out == nullptr && out_bytes != 0) return refuse(world, ISLET_ERROR_NULL_POINTER), 0;
    return of(world).save(span_of<std::byte>(out, out_bytes));
}

bool islet_world_restore(IsletWorld* world, const void* image, size_t image_bytes) {
    if (world == nullptr) return false;
    if (image == nullptr && image_bytes != 0) return refuse(world, ISLET_ERROR_NULL_POINTER), false;
    return of(world).restore(span_of<const std::byte>(image, image_bytes));
}

bool islet_world_load(IsletWorld* world, const void* image, size_t image_bytes) {
    if (world == nullptr) return false;
    if (image == nullptr && image_bytes != 0) return refuse(world, ISLET_ERROR_NULL_POINTER), false;
    return of(world).load(span_of<const std::byte>(image, image_bytes));
}

size_t islet_max_snapshot_bytes(const IsletCapacity* capacity) {
    Room<Capacity> capacity_room;
    const Capacity* capacity_taken = take<Capacity>(nullptr, capacity, capacity_room);
    if (capacity_taken == nullptr) return 0;
    return islet::max_snapshot_bytes(*capacity_taken);
}

size_t islet_max_delta_bytes(size_t to_bytes) {
    return islet::max_delta_bytes(to_bytes);
}

size_t islet_delta(const void* from, size_t from_bytes, const void* to, size_t to_bytes, void* out, size_t out_bytes, IsletError* error) {
    if (from == nullptr && from_bytes != 0) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), 0;
    if (to == nullptr && to_bytes != 0) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), 0;
    if (out == nullptr && out_bytes != 0) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), 0;
    return islet::delta(span_of<const std::byte>(from, from_bytes), span_of<const std::byte>(to, to_bytes), span_of<std::byte>(out, out_bytes), cast<Error>(error));
}

size_t islet_apply(const void* from, size_t from_bytes, const void* delta, size_t delta_bytes, void* out, size_t out_bytes, IsletError* error) {
    if (from == nullptr && from_bytes != 0) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), 0;
    if (delta == nullptr && delta_bytes != 0) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), 0;
    if (out == nullptr && out_bytes != 0) return refuse(nullptr, ISLET_ERROR_NULL_POINTER), 0;
    return islet::apply(span_of<const std::byte>(from, from_bytes), span_of<const std::byte>(delta, delta_bytes), span_of<std::byte>(out, out_bytes), cast<Error>(error));
}

}  // extern "C"
