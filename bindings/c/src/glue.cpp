// What all functions of the C interface call.
#include "glue.hpp"

namespace islet::c {

bool is_there(const IsletWorld* world, const void* given, std::size_t count) {
    if (given != nullptr || count == 0) return true;
    refuse(world, ISLET_ERROR_NULL_POINTER);
    return false;
}

const void* take_exact(const IsletWorld* world, const void* given, std::uint32_t size, std::uint32_t start) {
    IsletError error = ISLET_ERROR_NULL_POINTER;
    if (world != nullptr && given != nullptr) {
        if (*static_cast<const std::uint32_t*>(given) == size) return static_cast<const char*>(given) + start;
        error = ISLET_ERROR_STRUCT_SIZE;
    }
    refuse(world, error);
    return nullptr;
}

int copy_exact(void* to, const void* given, std::uint32_t size, std::uint32_t start) {
    if (given == nullptr) return ISLET_ERROR_NONE;
    if (*static_cast<const std::uint32_t*>(given) != size) return ISLET_ERROR_STRUCT_SIZE;
    std::memcpy(to, static_cast<const char*>(given) + start, size - start);
    return ISLET_ERROR_NONE;
}

}  // namespace islet::c
