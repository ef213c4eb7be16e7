// Workers: how a world is given threads to step with. The engine starts none itself.
#pragma once

#include <cstdint>

#include "islet/visibility.hpp"

ISLET_API_BEGIN
namespace islet {

/// Runs the pieces that a stage of a step was cut into, on whatever threads the user has: a pool, OpenMP, TBB, or one after another. How many there
/// are and in which order the pieces run never changes a result, not even a bit. See samples/workers/thread_pool.hpp for one, samples/workers/workers.cpp
/// for its use.
struct TaskSystem {
    /// Calls task(data, index) once for each 0 <= index < count, in any order and on any threads, and returns when all calls have returned; what
    /// they wrote must then be seen by the caller. Called from within World::step, on its thread, tens to hundreds of times a step, and never from
    /// within a task: keep it light. Null: the world steps on the calling thread alone.
    void (*parallel_for)(void* context, std::uint32_t count, void (*task)(void* data, std::uint32_t index), void* data) = nullptr;
    void* context = nullptr;    ///< passed on to parallel_for
    std::uint32_t workers = 1;  ///< 1 to max_workers: threads that run tasks, the calling one included. 1: parallel_for is never called.
};

/// No task system may claim more workers.
inline constexpr std::uint32_t max_workers = 64;

}  // namespace islet
ISLET_API_END
