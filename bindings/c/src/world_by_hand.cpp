// Functions written by hand: making a world, and its errors.
#include "glue.hpp"

using namespace islet;
using namespace islet::c;

extern "C" {

IsletWorld* islet_create_world(void* block, size_t block_bytes, const IsletCapacity* capacity, const IsletWorldDef* given, IsletError* error) {
    Capacity size;
    int refused = ISLET_ERROR_NULL_POINTER;
    if (block != nullptr && capacity != nullptr) refused = copy(capacity, size);
    const WorldDef def = world_def_of(given, refused);
    if (refused != ISLET_ERROR_NONE) return cast<IsletWorld>(detail::refuse_creation(static_cast<Error>(refused), def, cast<Error>(error)));
    return cast<IsletWorld>(World::create(span_of<std::byte>(block, block_bytes), size, def, cast<Error>(error)));
}

IsletError islet_world_last_error(const IsletWorld* world) {
    return world == nullptr ? static_cast<IsletError>(ISLET_ERROR_NULL_POINTER) : out(of(world).last_error());
}

IsletError islet_world_clear_error(IsletWorld* world) {
    if (world == nullptr) return ISLET_ERROR_NULL_POINTER;
    of(world).clear_error();
    return ISLET_ERROR_NONE;
}

}  // extern "C"
