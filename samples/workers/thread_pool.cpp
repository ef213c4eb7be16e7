#include "thread_pool.hpp"

#include <chrono>

namespace islet::samples {
namespace {

constexpr std::uint64_t closed = 0;                  // a share that belongs to no job
constexpr std::chrono::microseconds spin_time{100};  // longer than the stages of a step that have nothing to share

void pause() {
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#elif defined(__aarch64__) || defined(__arm__)
    __asm__ volatile("yield");
#endif
}

/// True once `done()` is, false if that takes longer than spin_time. Looks at the clock now and then only.
template <class Done>
bool spin_until(Done&& done) {
    const auto end = std::chrono::steady_clock::now() + spin_time;
    do {
        for (int i = 0; i < 64; ++i) {
            if (done()) return true;
            pause();
        }
    } while (std::chrono::steady_clock::now() < end);
    return false;
}

}  // namespace

ThreadPool::ThreadPool(std::uint32_t workers) : workers_(workers > 1 ? workers : 1), shares_(std::make_unique<Share[]>(workers_)) {
    for (std::uint32_t i = 1; i < workers_; ++i) threads_.emplace_back([this, i] { work(i); });
}

ThreadPool::~ThreadPool() {
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        ends_ = true;
    }
    wake_.notify_all();
    for (std::thread& thread : threads_) thread.join();
}

TaskSystem ThreadPool::tasks() {
    const auto parallel_for = [](void* pool, std::uint32_t count, Task task, void* data) {
        static_cast<ThreadPool*>(pool)->parallel_for(count, task, data);
    };
    return {parallel_for, this, workers_};
}

void ThreadPool::parallel_for(std::uint32_t count, Task task, void* data) {
    if (workers_ == 1 || count <= 1) {
        for (std::uint32_t i = 0; i < count; ++i) task(data, i);
        return;
    }
    std::uint32_t job = job_.load(std::memory_order_relaxed) + 1;
    if (job == 0) job = 1;  // 0 is the number of closed shares
    // First of all the shares of the last job are closed: a thread that is still looking through them must not take one of its tasks with this job's count.
    for (std::uint32_t i = 0; i < workers_; ++i) shares_[i].taken.store(closed, std::memory_order_relaxed);
    count_.store(count, std::memory_order_release);
    task_.store(task, std::memory_order_release);
    data_.store(data, std::memory_order_release);
    left_.store(count, std::memory_order_relaxed);
    for (std::uint32_t i = 0; i < workers_; ++i) shares_[i].taken.store(std::uint64_t{job} << 32, std::memory_order_release);
    job_.store(job);
    if (asleep_.load() != 0) {
        { const std::lock_guard<std::mutex> lock(mutex_); }  // a worker that is about to sleep has not yet, or has looked at the job
        wake_.notify_all();
    }
    take_tasks(job, 0);
    const auto all_returned = [this] { return left_.load(std::memory_order_acquire) == 0; };
    while (!spin_until(all_returned)) std::this_thread::yield();
}

void ThreadPool::take_tasks(std::uint32_t job, std::uint32_t worker) {
    for (std::uint32_t k = 0; k < workers_; ++k) {
        const std::uint32_t share = (worker + k) % workers_;
        std::atomic<std::uint64_t>& taken = shares_[share].taken;
        std::uint64_t seen = taken.load(std::memory_order_acquire);
        while (seen >> 32 == job) {
            const std::uint64_t count = count_.load(std::memory_order_acquire);
            const Task task = task_.load(std::memory_order_acquire);
            void* const data = data_.load(std::memory_order_acquire);
            const auto first = static_cast<std::uint32_t>(count * share / workers_),
                       end = static_cast<std::uint32_t>(count * (share + 1) / workers_);
            const std::uint32_t index = first + static_cast<std::uint32_t>(seen);
            if (index >= end) break;
            if (!taken.compare_exchange_weak(seen, seen + 1, std::memory_order_acq_rel, std::memory_order_acquire)) continue;
            task(data, index);
            left_.fetch_sub(1, std::memory_order_acq_rel);
            seen = taken.load(std::memory_order_acquire);
        }
    }
}

std::uint32_t ThreadPool::wait_for_job(std::uint32_t last) {
    if (spin_until([&] { return job_.load(std::memory_order_acquire) != last || ends_.load(std::memory_order_relaxed); }))
        return job_.load();
    std::unique_lock<std::mutex> lock(mutex_);
    ++asleep_;
    wake_.wait(lock, [&] { return job_.load() != last || ends_.load(); });
    --asleep_;
    return job_.load();
}

void ThreadPool::work(std::uint32_t worker) {
    std::uint32_t job = 0;
    for (;;) {
        job = wait_for_job(job);
        if (ends_) return;
        take_tasks(job, worker);
    }
}

}  // namespace islet::samples
