// Functions written by hand: what a recording says about itself.
#include "glue.hpp"

using namespace islet;
using namespace islet::c;

extern "C" {

IsletError islet_read_recording(const void* recording, size_t recording_bytes, IsletRecordingInfo* info) {
    if (info == nullptr || (recording == nullptr && recording_bytes != 0)) return ISLET_ERROR_NULL_POINTER;
    if (info->struct_size != sizeof *info || !fits_if_wanted(info->capacity) || !fits_if_wanted(info->needed)) return ISLET_ERROR_STRUCT_SIZE;
    RecordingInfo found;
    const Error error = islet::read_recording(span_of<const std::byte>(recording, recording_bytes), found);
    if (error != Error::none) return out(error);
    info->bytes = found.bytes;
    info->bodies = found.bodies;
    if (info->capacity != nullptr) give<Capacity>(info->capacity, found.capacity);
    if (info->needed != nullptr) give<Capacity>(info->needed, found.needed);
    return ISLET_ERROR_NONE;
}

}  // extern "C"
