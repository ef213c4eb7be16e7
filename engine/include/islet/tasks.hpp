// Workers: the threads that step a world. The engine starts none itself.
#pragma once

#include <cstdint>

#include "islet/visibility.hpp"

ISLET_API_BEGIN
namespace islet {

/// Runs the parts of a stage of a step on threads of yours: a pool, OpenMP, TBB, or one after another. The number of threads and the order of the parts never
/// change a bit of a result. samples/workers/thread_pool.hpp is an example; samples/workers/workers.cpp uses it.
struct TaskSystem {
    /// Calls task(data, index) once for each 0 <= index < count, in any order and on any threads, and returns when all calls have returned. The caller must
    /// then see what they wrote. World::step calls this function on its own thread, tens to hundreds of times a step, so it should be cheap. Tasks never call
    /// it. Null: the world steps on the calling thread alone.
    void (*parallel_for)(void* context, std::uint32_t count, void (*task)(void* data, std::uint32_t index), void* data) = nullptr;
    void* context = nullptr;    ///< passed on to parallel_for
    std::uint32_t workers = 1;  ///< Threads that run tasks, including the calling one, 1 to max_workers. With 1, parallel_for is never called.
    /// How many of the workers run tasks at the moment, 1 to `workers`, including the calling thread. (0 counts as 1, more than `workers` as `workers`.)
    /// World::step asks once, at its beginning, and steps with so many. So a pool can say that threads of it have lost their cores to another program, and the
    /// step is not cut into parts for them, which costs a few per cent. Null: all of them.
    std::uint32_t (*ready_workers)(void* context) = nullptr;
};

/// The most workers that a task system may have.
inline constexpr std::uint32_t max_workers = 64;

}  // namespace islet
ISLET_API_END
