// What all functions of the C interface call.
#include "glue.hpp"

namespace islet::c {

IsletError refuse(const IsletWorld* world, int error) {
    return static_cast<IsletError>(detail::refuse_call(cast<const World>(world), static_cast<Error>(error)));
}

bool is_there(const IsletWorld* world, const void* given, std::size_t count) {
    if (given != nullptr || count == 0) return true;
    refuse(world, ISLET_ERROR_NULL_POINTER);
    return false;
}

const void* take_exact(const IsletWorld* world, const void* given, std::uint32_t size, std::uint32_t start) {
    std::uint32_t claimed = 0;
    if (given != nullptr) std::memcpy(&claimed, given, sizeof claimed);
    if (claimed == size) return static_cast<const char*>(given) + start;
    refuse(world, why(given));
    return nullptr;
}

}  // namespace islet::c
