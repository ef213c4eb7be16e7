#include "thread_pool.hpp"

#if defined(__linux__)
#include <pthread.h>
#include <sched.h>
#include <time.h>
#endif

namespace islet::samples {
namespace {

constexpr std::uint64_t closed = 0;                  // a share that belongs to no job
constexpr std::chrono::microseconds spin_time{100};  // longer than the stages of a step that have nothing to share
constexpr int rest_per_wait = 20;                    // a worker that held up the caller rests so many times as long
constexpr std::chrono::seconds longest_rest{1};
constexpr std::chrono::microseconds shared_core_time{100};  // how long a worker on the caller's core is taken to have held it up

void pause() {
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#elif defined(__aarch64__) || defined(__arm__)
    __asm__ volatile("yield");
#endif
}

/// True once `done()` is, false if that takes longer than spin_time. Looks at the clock now and then only, and calls `now_and_then` then.
template <class Done, class Do>
bool spin_until(Done&& done, Do&& now_and_then) {
    const auto end = std::chrono::steady_clock::now() + spin_time;
    do {
        for (int i = 0; i < 64; ++i) {
            if (done()) return true;
            pause();
        }
        now_and_then();
    } while (std::chrono::steady_clock::now() < end);
    return false;
}
template <class Done>
bool spin_until(Done&& done) {
    return spin_until(done, [] {});
}

using Nanoseconds = Machine::Nanoseconds;

#if defined(__linux__)
Nanoseconds read_clock(clockid_t clock) {
    timespec time{};
    if (clock_gettime(clock, &time) != 0) return Nanoseconds(-1);
    return std::chrono::seconds(time.tv_sec) + Nanoseconds(time.tv_nsec);
}
#endif

}  // namespace

Nanoseconds Machine::now() { return std::chrono::steady_clock::now().time_since_epoch(); }

#if defined(__linux__)
int Machine::own_core() { return sched_getcpu(); }
Nanoseconds Machine::own_time_on_core() { return read_clock(CLOCK_THREAD_CPUTIME_ID); }
Nanoseconds Machine::time_on_core(std::thread& thread) {
    clockid_t clock{};
    return pthread_getcpuclockid(thread.native_handle(), &clock) == 0 ? read_clock(clock) : Nanoseconds(-1);
}
#else
int Machine::own_core() { return -1; }
Nanoseconds Machine::own_time_on_core() { return Nanoseconds(0); }
Nanoseconds Machine::time_on_core(std::thread&) { return Nanoseconds(-1); }
#endif

Machine& this_machine() {
    static Machine machine;
    return machine;
}

ThreadPool::ThreadPool(std::uint32_t workers, Machine& machine)
    : workers_(workers > 1 ? workers : 1), machine_(machine), shares_(std::make_unique<Share[]>(workers_)), rests_(workers_) {
    for (std::uint32_t i = 1; i < workers_; ++i) threads_.emplace_back([this, i] { work(i); });
}

ThreadPool::~ThreadPool() {
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        ends_ = true;
    }
    wake_.notify_all();
    end_of_rest_.notify_all();
    for (std::thread& thread : threads_) thread.join();
}

TaskSystem ThreadPool::tasks() {
    const auto parallel_for = [](void* pool, std::uint32_t count, Task task, void* data) { static_cast<ThreadPool*>(pool)->parallel_for(count, task, data); };
    return {parallel_for, this, workers_, [](void* pool) { return static_cast<ThreadPool*>(pool)->ready_workers(); }};
}

std::uint32_t ThreadPool::ready_workers() {
    if (resting_ != 0) end_rests();
    return workers_ - resting_;
}

void ThreadPool::parallel_for(std::uint32_t count, Task task, void* data) {
    if (ready_workers() > 1 && count > 1) part_from_caller();
    if (workers_ == 1 + resting_ || count <= 1) {
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
    wait_for_tasks();
}

// Waits until the tasks that other workers took have returned. A worker that had taken one and was on a core for less than half of a long wait has to rest.
// (What counts is how long the caller was on a core itself while it waited.)
void ThreadPool::wait_for_tasks() {
    const auto all_returned = [this] { return left_.load(std::memory_order_acquire) == 0; };
    if (spin_until(all_returned)) return;
    const Nanoseconds begin = machine_.own_time_on_core();
    for (std::uint32_t i = 1; i < workers_; ++i) {
        const bool works = shares_[i].works.load(std::memory_order_acquire) && !shares_[i].rests.load(std::memory_order_relaxed);
        rests_[i].ran = works ? machine_.time_on_core(threads_[i - 1]) : Nanoseconds(-1);
    }
    while (!spin_until(all_returned)) std::this_thread::yield();
    const Nanoseconds waited = machine_.own_time_on_core() - begin;
    for (std::uint32_t i = 1; i < workers_; ++i) {
        if (rests_[i].ran.count() < 0 || 2 * (machine_.time_on_core(threads_[i - 1]) - rests_[i].ran) >= waited) continue;
        begin_rest(i, waited + spin_time);
    }
}

// Workers that are on the caller's core rest: what they do there, the caller could do itself.
void ThreadPool::part_from_caller() {
    const int core = machine_.own_core();
    if (core < 0) return;
    if (core != caller_core_.load(std::memory_order_relaxed)) caller_core_.store(core, std::memory_order_relaxed);
    for (std::uint32_t i = 1; i < workers_; ++i)
        if (shares_[i].shared_core.load(std::memory_order_relaxed) == core && !shares_[i].rests.load(std::memory_order_relaxed))
            begin_rest(i, shared_core_time);
}

void ThreadPool::begin_rest(std::uint32_t worker, Nanoseconds held_up) {
    Rest& rest = rests_[worker];
    const auto now = machine_.now();
    Nanoseconds length = rest_per_wait * held_up;
    const bool again = now - rest.end < rest.length;
    if (again && 2 * rest.length > length) length = 2 * rest.length;
    rest.length = length < longest_rest ? length : Nanoseconds(longest_rest);
    rest.end = now + rest.length;
    shares_[worker].rests = true;
    ++resting_;
}

void ThreadPool::end_rests() {
    const auto now = machine_.now();
    bool any = false;
    for (std::uint32_t i = 1; i < workers_; ++i) {
        if (!shares_[i].rests.load(std::memory_order_relaxed) || now < rests_[i].end) continue;
        const std::lock_guard<std::mutex> lock(mutex_);
        shares_[i].shared_core = -1;  // the system may wake it on another one
        shares_[i].rests = false;
        --resting_;
        any = true;
    }
    if (any) end_of_rest_.notify_all();
}

void ThreadPool::take_tasks(std::uint32_t job, std::uint32_t worker) {
    shares_[worker].works.store(true, std::memory_order_release);
    for (std::uint32_t k = 0; k < workers_; ++k) {
        const std::uint32_t share = (worker + k) % workers_;
        std::atomic<std::uint64_t>& taken = shares_[share].taken;
        std::uint64_t seen = taken.load(std::memory_order_acquire);
        while (seen >> 32 == job) {
            const std::uint64_t count = count_.load(std::memory_order_acquire);
            const Task task = task_.load(std::memory_order_acquire);
            void* const data = data_.load(std::memory_order_acquire);
            const auto first = static_cast<std::uint32_t>(count * share / workers_), end = static_cast<std::uint32_t>(count * (share + 1) / workers_);
            const std::uint32_t index = first + static_cast<std::uint32_t>(seen);
            if (index >= end) break;
            if (!taken.compare_exchange_weak(seen, seen + 1, std::memory_order_acq_rel, std::memory_order_acquire)) continue;
            task(data, index);
            left_.fetch_sub(1, std::memory_order_acq_rel);
            seen = taken.load(std::memory_order_acquire);
        }
    }
    shares_[worker].works.store(false, std::memory_order_release);
}

std::uint32_t ThreadPool::wait_for_job(std::uint32_t last, std::uint32_t worker) {
    const std::atomic<bool>& rests = shares_[worker].rests;
    const auto is_called = [&] { return ends_.load() || (job_.load() != last && !rests.load()); };
    const auto tell_core = [&] {
        const int core = machine_.own_core(), shared = core == caller_core_.load(std::memory_order_relaxed) ? core : -1;
        if (shared != shares_[worker].shared_core.load(std::memory_order_relaxed)) shares_[worker].shared_core.store(shared, std::memory_order_relaxed);
    };
    if (spin_until(is_called, tell_core)) return job_.load();
    std::unique_lock<std::mutex> lock(mutex_);
    while (!is_called()) {
        if (rests) {
            end_of_rest_.wait(lock);
            continue;
        }
        ++asleep_;
        if (!is_called()) wake_.wait(lock);  // asked again: the caller looks whether anybody sleeps after it has set the job
        --asleep_;
    }
    return job_.load();
}

void ThreadPool::work(std::uint32_t worker) {
    std::uint32_t job = 0;
    for (;;) {
        job = wait_for_job(job, worker);
        if (ends_) return;
        take_tasks(job, worker);
    }
}

}  // namespace islet::samples
