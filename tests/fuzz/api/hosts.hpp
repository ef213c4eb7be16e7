// What a host lends to a world: hooks, a task system and a clock.
#pragma once

#include <cstdint>

#include "islet/islet.hpp"

namespace islet::fuzz {

/// They answer by the ids of what they are asked about, so that worlds with equal ids have equal futures; and sometimes with what is no number.
inline constexpr Hooks hooks = {
    [](ShapeId a, ShapeId b, void*) { return (a.index1 * 7 + b.index1) % 5 != 0; },
    [](PreSolve& p, void*) {
        p.enabled = (p.contact.shape_a.index1 + p.contact.shape_b.index1) % 4 != 0;
        p.friction = 0.25f * static_cast<float>(p.contact.shape_a.index1 % 8);
        p.tangent_speed = static_cast<float>(p.contact.shape_b.index1 % 3);
    },
    [](float a, std::uint32_t, float b, std::uint32_t material, void*) { return material % 4 == 3 ? __builtin_nanf("") : a * b; },
    [](float a, std::uint32_t material, float b, std::uint32_t, void*) { return material % 4 == 3 ? 1e30f : a + b; },
    nullptr,
};

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
