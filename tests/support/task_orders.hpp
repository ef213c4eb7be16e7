// Task systems of one thread, which say that they have several and run the tasks in an order of their own.
#pragma once

#include <cstdint>

#include "islet/tasks.hpp"

namespace islet::test {

inline TaskSystem in_order(std::uint32_t workers) {
    const auto run = [](void*, std::uint32_t count, void (*task)(void*, std::uint32_t), void* data) {
        for (std::uint32_t i = 0; i < count; ++i) task(data, i);
    };
    return {run, nullptr, workers};
}

inline TaskSystem backwards(std::uint32_t workers) {
    const auto run = [](void*, std::uint32_t count, void (*task)(void*, std::uint32_t), void* data) {
        for (std::uint32_t i = count; i-- > 0;) task(data, i);
    };
    return {run, nullptr, workers};
}

}  // namespace islet::test
