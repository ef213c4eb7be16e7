// Hands out pieces of scratch memory, one after another, from both of its ends. All are given back at once when the stage ends.
#pragma once

#include <cstddef>
#include <cstdint>

#include "../math/inlining.hpp"
#include "islet/layout.hpp"

namespace islet::detail {

struct Arena {
    std::byte* at = nullptr;
    std::byte* end = nullptr;

    /// An uninitialised array of n T, aligned as the arrays of a world. It never fails, because the layout reserves enough for every stage.
    template <class T>
    T* take(std::size_t n) {
        return reinterpret_cast<T*>(take_bytes(n * sizeof(T)));
    }

    /// The same from the other end.
    template <class T>
    T* take_last(std::size_t n) {
        return reinterpret_cast<T*>(take_last_bytes(n * sizeof(T)));
    }

    /// Bytes that are left.
    std::size_t room() const { return static_cast<std::size_t>(end - at); }

private:
    ISLET_SHARED std::byte* take_bytes(std::size_t wanted) {
        std::byte* p = at;
        const std::size_t bytes = align_up(wanted);
        if (end - at < static_cast<std::ptrdiff_t>(bytes)) ISLET_TRAP();  // the engine's own invariant: scratch_bytes (islet/layout.hpp) is wrong
        at += bytes;
        return p;
    }
    ISLET_SHARED std::byte* take_last_bytes(std::size_t wanted) {
        take_bytes(wanted);  // for its check
        at -= align_up(wanted);
        return end -= align_up(wanted);
    }
};

}  // namespace islet::detail
