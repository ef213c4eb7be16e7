// What all functions of the C interface call.
#include "glue.hpp"

namespace islet::c {

IsletError refuse(const IsletWorld* world, int error) {
    if (world != nullptr) detail::replace_error(of(world), static_cast<Error>(error), true);
    return static_cast<IsletError>(error);
}

Error begin(IsletWorld* world) { return detail::replace_error(of(world), Error::none, false); }

IsletError end(IsletWorld* world, Error before) {
    const Error error = of(world).last_error();
    if (error == Error::none) detail::replace_error(of(world), before, false);
    return static_cast<IsletError>(error);
}

const void* take_exact(const IsletWorld* world, const void* given, std::uint32_t size, std::uint32_t start) {
    std::uint32_t claimed = 0;
    if (given != nullptr) std::memcpy(&claimed, given, sizeof claimed);
    if (claimed == size) return static_cast<const char*>(given) + start;
    refuse(world, why(given));
    return nullptr;
}

}  // namespace islet::c
