// What a host lends to a world: a task system and a clock.
#pragma once

#include <cstdint>

#include "islet/islet.hpp"

namespace islet::fuzz {

/// One thread that claims to be several, and runs the last task first.
inline TaskSystem backwards_tasks(std::uint32_t workers) {
    return {[](void*, std::uint32_t count, void (*task)(void*, std::uint32_t), void* data) {
                for (std::uint32_t i = count; i-- > 0;) task(data, i);
            },
            nullptr, workers};
}

/// A clock that moves on whenever it is read.
inline std::uint64_t count_ticks(void*) {
    static std::uint64_t ticks;
    return ++ticks;
}

}  // namespace islet::fuzz
