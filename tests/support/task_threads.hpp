// A task system that starts a thread for each task.
#pragma once

#include <cstdint>
#include <thread>
#include <vector>

#include "islet/tasks.hpp"

namespace islet::test {

inline TaskSystem threads(std::uint32_t workers) {
    const auto run = [](void*, std::uint32_t count, void (*task)(void*, std::uint32_t), void* data) {
        std::vector<std::thread> all;
        for (std::uint32_t i = 0; i < count; ++i) all.emplace_back(task, data, i);
        for (std::thread& one : all) one.join();
    };
    return {run, nullptr, workers};
}

}  // namespace islet::test
