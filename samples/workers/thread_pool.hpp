// A pool of threads for World::step: starts them once, and wakes and ends them as fast as it can, because a step has hundreds of short stages.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include <islet/tasks.hpp>

namespace islet::samples {

/// What a ThreadPool sees of the machine: cores and time. (Tests put a machine of their own in its place, on which no other program runs.)
class Machine {
public:
    using Nanoseconds = std::chrono::nanoseconds;

    virtual ~Machine() = default;
    /// The time since a fixed moment.
    virtual Nanoseconds now();
    /// The core on which the calling thread runs; less than 0 if that cannot be known.
    virtual int own_core();
    /// How long the calling thread has been on a core until now.
    virtual Nanoseconds own_time_on_core();
    /// How long another thread has; less than 0 if that cannot be known.
    virtual Nanoseconds time_on_core(std::thread& thread);
};

/// The computer that runs the program.
Machine& this_machine();

/// Threads that wait for tasks: at first spinning, so that the next stage of a step finds them at once, then asleep. Used by one thread at a time; not
/// from within a task. A worker begins with the share of the tasks that it had the last time, whose data may be in its core's cache still, and then
/// helps the others.
///
/// Whoever is free takes the next task, so the caller finishes alone if the workers do not run. Where another program keeps a core busy, there are two ways in
/// which a worker can hold up the caller. It has taken a task and then loses its core; or the system has put it on the caller's own core, where it takes the
/// caller's time, which counts as a tenth of a millisecond. (Threads often begin there, and are put elsewhere when they wake up after a rest.) Such a worker
/// gets no tasks for the next while, 20 times as long as it held up the caller, so it adds about a twentieth to the steps; and a world whose workers all rest
/// steps as if it had none. If it holds up the caller again soon afterwards, the next rest is twice as long, up to a second. (On Linux, where a thread can see
/// on which core it is, and whether another one runs.)
class ThreadPool {
public:
    using Task = void (*)(void* data, std::uint32_t index);

    /// `workers` threads in all (at least 1), of which the caller of parallel_for is one.
    /// `machine` must outlive the pool.
    explicit ThreadPool(std::uint32_t workers, Machine& machine = this_machine());
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    std::uint32_t workers() const { return workers_; }
    /// How many of them get tasks now: the others rest, because they held up the caller. Ends the rests that are over.
    std::uint32_t ready_workers();
    /// What WorldDef wants. The pool must outlive the world's last step.
    TaskSystem tasks();
    /// Calls task(data, index) for each index < count and returns when all have returned.
    void parallel_for(std::uint32_t count, Task task, void* data);

private:
    /// Tasks of one share that are taken so far, below the number of the job they belong to: a thread that comes late finds another job's number
    /// and takes nothing. Each has a cache line of its own.
    struct alignas(64) Share {
        std::atomic<std::uint64_t> taken{0};
        std::atomic<bool> works{false};  // the worker is taking tasks
        std::atomic<bool> rests{false};  // the worker gets no tasks
        // The core on which it was last seen awake, if the caller was there too; else -1. (Where it sleeps says nothing: the system may wake it elsewhere.)
        std::atomic<int> shared_core{-1};
    };
    /// What only the caller of parallel_for knows of a worker.
    struct Rest {
        Machine::Nanoseconds end{0};     // of the last rest
        Machine::Nanoseconds length{0};  // of that
        Machine::Nanoseconds ran{0};     // its time on a core when the caller began to wait
    };

    void work(std::uint32_t worker);
    void take_tasks(std::uint32_t job, std::uint32_t worker);
    std::uint32_t wait_for_job(std::uint32_t last, std::uint32_t worker);
    void wait_for_tasks();
    void part_from_caller();
    void begin_rest(std::uint32_t worker, Machine::Nanoseconds held_up);
    void end_rests();

    std::uint32_t workers_;
    Machine& machine_;
    std::unique_ptr<Share[]> shares_;
    // The job. Whoever has taken one of its tasks knows that it has not ended, and so that what he read is its own: shares are closed before it changes.
    std::atomic<std::uint32_t> count_{0};
    std::atomic<Task> task_{nullptr};
    std::atomic<void*> data_{nullptr};
    alignas(64) std::atomic<std::uint32_t> job_{0};   // its number
    alignas(64) std::atomic<std::uint32_t> left_{0};  // tasks that have not returned
    alignas(64) std::atomic<std::uint32_t> asleep_{0};
    std::atomic<int> caller_core_{-1};  // when the last job began; -1: not known
    std::atomic<bool> ends_{false};
    std::mutex mutex_;
    std::condition_variable wake_, end_of_rest_;
    std::vector<Rest> rests_;    // by worker; of the caller there is none
    std::uint32_t resting_ = 0;  // workers that get no tasks
    std::vector<std::thread> threads_;
};

}  // namespace islet::samples
