// Functions written by hand: making a world, and its errors.
#include "glue.hpp"

namespace islet::c {
namespace {

/// Points to a struct that the caller may leave out. False if its size is wrong.
template <class T>
bool take_if_given(const typename Twin<T>::Type* given, T& to) {
    if (given == nullptr) return true;
    Room<T> room;
    const T* taken = take<T>(nullptr, given, room);
    if (taken == nullptr) return false;
    to = *taken;
    return true;
}

}  // namespace
}  // namespace islet::c

using namespace islet;
using namespace islet::c;

extern "C" {

IsletWorld* islet_create_world(void* block, size_t block_bytes, const IsletCapacity* capacity, const IsletWorldDef* given, IsletError* error) {
    IsletError ignored = ISLET_ERROR_NONE;
    if (error == nullptr) error = &ignored;
    Room<Capacity> room;
    const Capacity* taken = take<Capacity>(nullptr, capacity, room);
    WorldDef def;
    *error = ISLET_ERROR_NONE;
    if (block == nullptr) *error = ISLET_ERROR_NULL_POINTER;
    if (taken == nullptr) *error = why(capacity);
    if (given != nullptr) {
        if (given->struct_size != sizeof *given || !take_if_given(given->solver, def.solver) || !take_if_given(given->hooks, def.hooks) ||
            !take_if_given(given->tasks, def.tasks)) {
            *error = ISLET_ERROR_STRUCT_SIZE;
        } else {
            def.gravity = in<Vec2>(given->gravity);
            def.enable_sleep = given->enable_sleep;
            def.restitution_threshold = given->restitution_threshold;
            def.max_speed = given->max_speed;
            def.hit_threshold = given->hit_threshold;
            def.continuous = given->continuous;
            def.lanes = given->lanes;
            def.error_hook = function<ErrorHook>(given->error_hook);
            def.error_context = given->error_context;
            def.clock = given->clock;
            def.clock_context = given->clock_context;
        }
    }
    if (*error != ISLET_ERROR_NONE) {
        if (def.error_hook != nullptr) def.error_hook(static_cast<Error>(*error), def.error_context);
        return nullptr;
    }
    return reinterpret_cast<IsletWorld*>(World::create({static_cast<std::byte*>(block), block_bytes}, *taken, def, reinterpret_cast<Error*>(error)));
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
