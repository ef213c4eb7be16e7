// Hands out pieces of the scratch region in order; everything is given back at once when the stage ends.
#pragma once

#include <cstddef>
#include <cstdint>

namespace islet::detail {

struct Arena {
    std::byte* at = nullptr;
    std::byte* end = nullptr;

    /// An uninitialised array of n T, aligned to a cache line. The layout reserves enough for every stage, so this never fails.
    template <class T>
    T* take(std::size_t n) {
        std::byte* p = at;
        const std::size_t bytes = (n * sizeof(T) + 63) / 64 * 64;
        if (static_cast<std::size_t>(end - at) < bytes) __builtin_trap();  // the layout is wrong: an invariant of the engine
        at += bytes;
        return reinterpret_cast<T*>(p);
    }
};

}  // namespace islet::detail
