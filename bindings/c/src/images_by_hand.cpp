// Functions written by hand: what an image says about itself, and copies of worlds.
#include "glue.hpp"

using namespace islet;
using namespace islet::c;

extern "C" {

IsletError islet_read_snapshot(const void* image, size_t image_bytes, IsletSnapshotInfo* info) {
    if (info == nullptr || (image == nullptr && image_bytes != 0)) return ISLET_ERROR_NULL_POINTER;
    if (info->struct_size != sizeof *info || !fits_if_wanted(info->capacity) || !fits_if_wanted(info->used)) return ISLET_ERROR_STRUCT_SIZE;
    SnapshotInfo found;
    const Error error = islet::read_snapshot(span_of<const std::byte>(image, image_bytes), found);
    if (error != Error::none) return out(error);
    info->bytes = found.bytes;
    if (info->capacity != nullptr) give<Capacity>(info->capacity, found.capacity);
    if (info->used != nullptr) give<Capacity>(info->used, found.used);
    return ISLET_ERROR_NONE;
}

IsletWorld* islet_copy_world(const IsletWorld* from, void* block, size_t block_bytes, const IsletCapacity* capacity, void* image, size_t image_bytes,
                             IsletError* error) {
    IsletError ignored;
    if (error == nullptr) error = &ignored;
    Room<Capacity> room;
    const Capacity* const taken = take<Capacity>(nullptr, capacity, room);
    *error = from == nullptr || (block == nullptr && block_bytes != 0) || (image == nullptr && image_bytes != 0)
                 ? static_cast<IsletError>(ISLET_ERROR_NULL_POINTER)
             : taken == nullptr ? why(capacity)
                                : static_cast<IsletError>(ISLET_ERROR_NONE);
    if (*error != ISLET_ERROR_NONE) return nullptr;
    return reinterpret_cast<IsletWorld*>(
        copy_world(of(from), span_of<std::byte>(block, block_bytes), *taken, span_of<std::byte>(image, image_bytes), reinterpret_cast<Error*>(error)));
}

}  // extern "C"
