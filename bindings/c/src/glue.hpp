// What the functions of the C interface have in common. They check what C can get wrong (null pointers, sizes of structs) and call the engine, which checks
// the rest. Structs are not converted: those of C have the fields of those of C++ at the same places, which islet_c.cpp checks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
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

/// A value of C as that of C++, and back. (Those that most calls have are made field by field, which takes less code than a copy of their bytes.)
template <class T>
T in(const typename Twin<T>::Type& value) {
    return __builtin_bit_cast(T, value);
}
template <>
inline BodyId in<BodyId>(const IsletBodyId& id) {
    return {id.index1, id.generation};
}
template <>
inline ShapeId in<ShapeId>(const IsletShapeId& id) {
    return {id.index1, id.generation};
}
template <>
inline JointId in<JointId>(const IsletJointId& id) {
    return {id.index1, id.generation};
}
template <>
inline Vec2 in<Vec2>(const IsletVec2& v) {
    return {v.x, v.y};
}
template <class T>
typename Twin<T>::Type out(const T& value) {
    return __builtin_bit_cast(typename Twin<T>::Type, value);
}
inline IsletVec2 out(const Vec2& v) { return {v.x, v.y}; }
inline IsletBodyId out(const BodyId& id) { return {id.index1, id.generation}; }
inline IsletShapeId out(const ShapeId& id) { return {id.index1, id.generation}; }
inline IsletJointId out(const JointId& id) { return {id.index1, id.generation}; }

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
IsletError refuse(const IsletWorld* world, int error);

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

/// Whether a struct had this size in an earlier version, which no size that would cut a field has.
template <class T>
bool is_older(std::uint32_t size) {
    using Type = typename Twin<T>::Type;
    return size >= sizeof(First<T>) && size < sizeof(Type) && size % alignof(Type) == 0;
}

/// Room for a struct of an older program, with the defaults of the fields that it does not know.
template <class T, bool = has_grown<T>>
struct Room {};
template <class T>
struct Room<T, true> {
    T value = {};
};

/// Where the fields of C++ begin in a struct that carries its size; null, with the error recorded, if there is none, or its size is another than `size`.
const void* take_exact(const IsletWorld* world, const void* given, std::uint32_t size, std::uint32_t start);

/// The struct of C++ that the caller gave, or null with the error recorded.
template <class T>
const T* take(const IsletWorld* world, const typename Twin<T>::Type* given, [[maybe_unused]] Room<T>& room) {
    using Type = typename Twin<T>::Type;
    if constexpr (has_grown<T>) {
        if (given != nullptr && is_older<T>(given->struct_size)) {
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
template <class T>
ISLET_NEVER_INLINE const T* take_or_default(const IsletWorld* world, const typename Twin<T>::Type* given, Room<T>& room) {
    return given == nullptr ? take_default<T>() : take<T>(world, given, room);
}

/// Whether a result can be written to a struct of the caller's; if not, the error is recorded.
template <class T>
bool fits(const IsletWorld* world, const typename Twin<T>::Type* out) {
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

/// A world's definition, with the structs that it points to. False if one has a wrong size. (`given` may be null.)
bool take_world_def(const IsletWorldDef* given, WorldDef& def);

/// Functions that draw, of C. A polygon's corners are a pointer and a count there.
struct Drawing {
    explicit Drawing(const DebugDraw& given);
    DebugDraw given;      // its functions have C's types
    DebugDraw functions;  // with the above as context
};

}  // namespace islet::c
