// What the functions of the C interface have in common. They check what C can get wrong (null pointers, sizes of structs) and call the engine, which checks
// the rest. Structs are not converted: those of C have the fields of those of C++ at the same places, which islet_c.cpp checks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>
#include <type_traits>

#include "islet/fleet.hpp"
#include "islet/island.hpp"
#include "islet/islet.h"
#include "islet/islet.hpp"
#include "islet/mover.hpp"

#include "types.inc.hpp"

namespace islet::c {

/// Which struct or enumeration of C stands for one of C++, and where the fields of C++ begin in it.
template <class T>
struct Twin;
#define ISLET_C_TWIN(T)        \
    template <>                \
    struct Twin<T> {           \
        using Type = Islet##T; \
    };
ISLET_C_SAME(ISLET_C_TWIN)
#undef ISLET_C_TWIN
#define ISLET_C_TWIN(T, bytes)                        \
    template <>                                       \
    struct Twin<T> {                                  \
        using Type = Islet##T;                        \
        static constexpr std::uint32_t start = bytes; \
    };
ISLET_C_GROWS(ISLET_C_TWIN)
#undef ISLET_C_TWIN

template <class T>
inline constexpr std::uint32_t start_of = Twin<T>::start;

inline World& of(IsletWorld* world) { return *reinterpret_cast<World*>(world); }
inline const World& of(const IsletWorld* world) { return *reinterpret_cast<const World*>(world); }

/// A value of C as that of C++, and back: it has the same bytes, which stay where they are. (A copy takes code in every call.)
template <class T>
const T& in(const typename Twin<T>::Type& value) {
    return reinterpret_cast<const T&>(value);
}
template <class T>
const typename Twin<T>::Type& out(const T& value) {
    return reinterpret_cast<const typename Twin<T>::Type&>(value);
}

template <class To, class From>
To* cast(From* pointer) {
    return reinterpret_cast<To*>(pointer);
}

/// The same for functions. The types that they take are passed in the same way in both languages.
template <class To, class From>
To function(From from) {
    return reinterpret_cast<To>(reinterpret_cast<void (*)()>(from));
}

template <class T, class Pointer>
span<T> span_of(Pointer pointer, std::size_t count) {
    return {reinterpret_cast<T*>(pointer), count};
}
template <class T>
span<T> span_of(const void* pointer, std::size_t count) {
    return {static_cast<T*>(pointer), count};
}
template <class T>
span<T> span_of(void* pointer, std::size_t count) {
    return {static_cast<T*>(pointer), count};
}

/// Records an error of C, as the world records its own, and returns it. Without a world it is returned alone.
inline IsletError refuse(const IsletWorld* world, int error) {
    return static_cast<IsletError>(detail::refuse_call(cast<const World>(world), static_cast<Error>(error)));
}

/// Around a call that returns a code: its own error, none if it had none. The world's last error is then what it would be without these two. Of no world
/// begin() is false, and end() is null_pointer.
inline bool begin(IsletWorld* world) { return detail::begin_call(cast<World>(world)); }
inline IsletError end(IsletWorld* world) { return static_cast<IsletError>(detail::end_call(cast<World>(world), static_cast<Error>(ISLET_ERROR_NULL_POINTER))); }

/// Whether a pointer is not null, or what it points to has no elements; if not, the error is recorded.
bool is_there(const IsletWorld* world, const void* given, std::size_t count = 1);

/// Whether a struct has fields that an earlier version did not have.
template <class T, class = void>
inline constexpr bool has_grown = false;
template <class T>
inline constexpr bool has_grown<T, std::void_t<decltype(sizeof(First<T>))>> = true;

/// Whether a struct may have had this size in an earlier version, which no size that would cut a field has.
template <class T>
bool is_older(std::uint32_t size) {
    using Type = typename Twin<T>::Type;
    for (std::uint32_t older = sizeof(First<T>); older < sizeof(Type); older += alignof(Type))
        if (size == older) return true;
    return false;
}

/// Room for a struct of an older program, with the defaults of the fields that it does not know.
template <class T, bool = has_grown<T>>
struct Room {};
template <class T>
struct Room<T, true> {
    T value = {};
};

/// Where the fields of C++ begin in a struct that carries its size; null, with the error recorded, if there is none, or its size is another than `size`, or
/// there is no world.
const void* take_exact(const IsletWorld* world, const void* given, std::uint32_t size, std::uint32_t start);
/// The same for a call that has no world.
inline const void* take_exact(std::nullptr_t, const void* given, std::uint32_t size, std::uint32_t start) {
    return given != nullptr && *static_cast<const std::uint32_t*>(given) == size ? static_cast<const char*>(given) + start : nullptr;
}

inline bool lacks_world(std::nullptr_t) { return false; }
inline bool lacks_world(const IsletWorld* world) { return world == nullptr; }

/// The struct of C++ that the caller gave, or null with the error recorded. `world` is the call's, which is then checked too, or nullptr if it has none.
template <class T, class W>
const T* take(W world, const typename Twin<T>::Type* given, [[maybe_unused]] Room<T>& room) {
    using Type = typename Twin<T>::Type;
    if constexpr (has_grown<T>) {
        if (!lacks_world(world) && given != nullptr && is_older<T>(given->struct_size)) {
            std::memcpy(static_cast<void*>(&room.value), reinterpret_cast<const char*>(given) + start_of<T>, given->struct_size - start_of<T>);
            return &room.value;
        }
    }
    return static_cast<const T*>(take_exact(world, given, sizeof(Type), start_of<T>));
}

/// For a null pointer that stands for the default.
template <class T>
const T* take_default() {
    static constexpr T value = {};
    return &value;
}

/// A definition that may be left out. One function for all that take it.
template <class T, class W>
ISLET_NEVER_INLINE const T* take_or_default(W world, const typename Twin<T>::Type* given, Room<T>& room) {
    return given == nullptr ? take_default<T>() : take<T>(world, given, room);
}

/// The same for a call that also needs a world and `other`, which must not be null.
template <class T>
ISLET_NEVER_INLINE const T* take_with(const IsletWorld* world, const void* other, const typename Twin<T>::Type* given, Room<T>& room) {
    if (other == nullptr)
        given = nullptr;
    else if (given == nullptr && world != nullptr)
        return take_default<T>();
    return take<T>(world, given, room);
}

/// Whether a result can be written to a struct of the caller's; if not, the error is recorded.
template <class T, class W>
bool fits(W world, const typename Twin<T>::Type* out) {
    using Type = typename Twin<T>::Type;
    if constexpr (has_grown<T>) {
        if (out != nullptr && is_older<T>(out->struct_size)) return true;
    }
    return take_exact(world, out, sizeof(Type), start_of<T>) != nullptr;
}
/// Writes as much of a result as the caller's struct has.
template <class T>
void give(typename Twin<T>::Type* out, const T& value) {
    std::memcpy(reinterpret_cast<char*>(out) + start_of<T>, static_cast<const void*>(&value), out->struct_size - start_of<T>);
}

/// Why take or fits refused.
inline IsletError why(const void* given) { return given == nullptr ? ISLET_ERROR_NULL_POINTER : ISLET_ERROR_STRUCT_SIZE; }

/// Whether a capacity can be written where the caller wants it, if anywhere.
inline bool fits_if_wanted(const IsletCapacity* out) { return out == nullptr || fits<Capacity>(nullptr, out); }

/// Copies a struct of the caller's, which must have this size, without its first `start` bytes; nothing if it is null. Returns struct_size on another size.
int copy_exact(void* to, const void* given, std::uint32_t size, std::uint32_t start);

/// Copies a struct of the caller's to where its defaults stand. One of an older program has no more than its first fields.
template <class T>
int copy(const typename Twin<T>::Type* given, T& to) {
    std::uint32_t size = sizeof *given;
    if constexpr (has_grown<T>) {
        if (given != nullptr && is_older<T>(given->struct_size)) size = given->struct_size;
    }
    return copy_exact(&to, given, size, start_of<T>);
}

// The plain settings of a world stand together in both languages, and are copied as a whole; on processors with short pointers the error hook too.
constexpr std::size_t settings_bytes = offsetof(WorldDef, lanes) + sizeof(WorldDef::lanes) - offsetof(WorldDef, enable_sleep);
constexpr std::size_t with_hook_bytes = offsetof(WorldDef, error_context) + sizeof(WorldDef::error_context) - offsetof(WorldDef, enable_sleep);
constexpr bool hook_follows =
    with_hook_bytes == offsetof(IsletWorldDef, error_context) + sizeof(IsletWorldDef::error_context) - offsetof(IsletWorldDef, enable_sleep);
static_assert(!hook_follows || offsetof(IsletWorldDef, error_context) - offsetof(IsletWorldDef, error_hook) ==
                                   offsetof(WorldDef, error_context) - offsetof(WorldDef, error_hook));
#define ISLET_C_SAME_PLACE(field)                                                                                                                           \
    static_assert(offsetof(IsletWorldDef, field) - offsetof(IsletWorldDef, enable_sleep) == offsetof(WorldDef, field) - offsetof(WorldDef, enable_sleep) && \
                  sizeof(IsletWorldDef::field) == sizeof(WorldDef::field))
ISLET_C_SAME_PLACE(enable_sleep);
ISLET_C_SAME_PLACE(restitution_threshold);
ISLET_C_SAME_PLACE(max_speed);
ISLET_C_SAME_PLACE(hit_threshold);
ISLET_C_SAME_PLACE(continuous);
ISLET_C_SAME_PLACE(seamless_floors);
ISLET_C_SAME_PLACE(lanes);
#undef ISLET_C_SAME_PLACE

/// A world's definition, with the structs that it points to; null is the default. If one of them has a wrong size, `refused` becomes struct_size. (Only two
/// functions call it, of which most programs have one: as part of that it takes less code.)
ISLET_ALWAYS_INLINE inline WorldDef world_def_of(const IsletWorldDef* given, int& refused) {
    WorldDef def;
    if (given == nullptr) return def;
    if (given->struct_size != sizeof *given) {
        refused = ISLET_ERROR_STRUCT_SIZE;
        return def;
    }
    refused |= copy(given->solver, def.solver);
    refused |= copy(given->hooks, def.hooks);
    refused |= copy(given->tasks, def.tasks);
    def.gravity = in<Vec2>(given->gravity);
    std::memcpy(&def.enable_sleep, &given->enable_sleep, hook_follows ? with_hook_bytes : settings_bytes);
    if constexpr (!hook_follows) {
        def.error_hook = function<ErrorHook>(given->error_hook);
        def.error_context = given->error_context;
    }
    def.clock = given->clock;
    def.clock_context = given->clock_context;
    return def;
}

/// Functions that draw, of C. A polygon's corners are a pointer and a count there.
struct Drawing {
    explicit Drawing(const DebugDraw& given);
    DebugDraw given;      // its functions have C's types
    DebugDraw functions;  // with the above as context
};

}  // namespace islet::c
