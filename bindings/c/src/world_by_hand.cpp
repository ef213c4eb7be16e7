// Functions written by hand: making a world, and its errors.
#include "glue.hpp"

namespace islet::c {
namespace {

/// Copies a struct that the caller may leave out. False if its size is wrong.
bool copy_exact(const void* given, void* to, std::uint32_t size, std::uint32_t start) {
    if (given == nullptr) return true;
    given = take_exact(nullptr, given, size, start);
    if (given != nullptr) std::memcpy(to, given, size - start);
    return given != nullptr;
}
template <class T>
bool take_if_given(const typename Twin<T>::Type* given, T& to) {
    using Type = typename Twin<T>::Type;
    if constexpr (has_grown<T>) {
        if (given != nullptr && is_older<T>(given->struct_size)) {
            std::memcpy(&to, reinterpret_cast<const char*>(given) + start_of<T>, given->struct_size - start_of<T>);
            return true;
        }
    }
    return copy_exact(given, &to, sizeof(Type), start_of<T>);
}

// The plain settings, which stand together in both languages, are copied as a whole.
constexpr std::size_t settings_bytes = offsetof(WorldDef, lanes) + sizeof(WorldDef::lanes) - offsetof(WorldDef, enable_sleep);
#define ISLET_C_SAME_PLACE(field) \
    static_assert(offsetof(IsletWorldDef, field) - offsetof(IsletWorldDef, enable_sleep) == offsetof(WorldDef, field) - offsetof(WorldDef, enable_sleep) && \
                  sizeof(IsletWorldDef::field) == sizeof(WorldDef::field))
ISLET_C_SAME_PLACE(enable_sleep);
ISLET_C_SAME_PLACE(restitution_threshold);
ISLET_C_SAME_PLACE(max_speed);
ISLET_C_SAME_PLACE(hit_threshold);
ISLET_C_SAME_PLACE(continuous);
ISLET_C_SAME_PLACE(lanes);
#undef ISLET_C_SAME_PLACE

}  // namespace

bool take_world_def(const IsletWorldDef* given, WorldDef& def) {
    if (given == nullptr) return true;
    if (given->struct_size != sizeof *given || !take_if_given(given->solver, def.solver) || !take_if_given(given->hooks, def.hooks) ||
        !take_if_given(given->tasks, def.tasks))
        return false;
    def.gravity = in<Vec2>(given->gravity);
    std::memcpy(&def.enable_sleep, &given->enable_sleep, settings_bytes);
    def.error_hook = function<ErrorHook>(given->error_hook);
    def.error_context = given->error_context;
    def.clock = given->clock;
    def.clock_context = given->clock_context;
    return true;
}

}  // namespace islet::c

using namespace islet;
using namespace islet::c;

extern "C" {

IsletWorld* islet_create_world(void* block, size_t block_bytes, const IsletCapacity* capacity, const IsletWorldDef* given, IsletError* error) {
    Room<Capacity> room;
    const Capacity* taken = take<Capacity>(nullptr, capacity, room);
    WorldDef def;
    IsletError refused = ISLET_ERROR_NONE;
    if (block == nullptr) refused = ISLET_ERROR_NULL_POINTER;
    if (taken == nullptr) refused = why(capacity);
    if (!take_world_def(given, def)) refused = ISLET_ERROR_STRUCT_SIZE;
    if (refused == ISLET_ERROR_NONE)
        return reinterpret_cast<IsletWorld*>(World::create({static_cast<std::byte*>(block), block_bytes}, *taken, def, reinterpret_cast<Error*>(error)));
    if (error != nullptr) *error = refused;
    if (def.error_hook != nullptr) def.error_hook(static_cast<Error>(refused), def.error_context);
    return nullptr;
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
