// Functions written by hand: what an image says about itself.
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

}  // extern "C"
