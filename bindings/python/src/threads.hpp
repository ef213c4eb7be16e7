// Threads that step a world or a fleet, in this process.
#pragma once

#include <atomic>
#include <memory>

#include <pthread.h>

#include "workers/thread_pool.hpp"

namespace islet::python {

/// How often this process has been forked off since it began.
inline std::uint32_t forks() {
    static std::atomic<std::uint32_t> count{0};
    static const int told = pthread_atfork(nullptr, nullptr, [] { ++count; });
    static_cast<void>(told);
    return count.load(std::memory_order_relaxed);
}

/// A pool of threads. fork() leaves them behind, as Python's multiprocessing does: a process that was forked off starts its own when it first needs them.
class Threads {
public:
    explicit Threads(std::uint32_t workers) : workers_(workers), forks_(forks()), pool_(std::make_unique<samples::ThreadPool>(workers)) {}
    ~Threads() {
        if (forks_ != forks()) leave();
    }
    Threads(const Threads&) = delete;
    Threads& operator=(const Threads&) = delete;

    TaskSystem tasks() {
        const auto parallel_for = [](void* self, std::uint32_t count, samples::ThreadPool::Task task, void* data) {
            static_cast<Threads*>(self)->here().parallel_for(count, task, data);
        };
        const auto ready_workers = [](void* self) { return static_cast<Threads*>(self)->here().ready_workers(); };
        return {parallel_for, this, workers_, ready_workers};
    }

private:
    samples::ThreadPool& here() {
        if (forks_ != forks()) {
            leave();
            forks_ = forks();
            pool_ = std::make_unique<samples::ThreadPool>(workers_);
        }
        return *pool_;
    }
    /// The pool of the process before: it waits for its threads when it is destroyed, and they are not here.
    void leave() { static_cast<void>(pool_.release()); }

    std::uint32_t workers_, forks_;
    std::unique_ptr<samples::ThreadPool> pool_;
};

}  // namespace islet::python
