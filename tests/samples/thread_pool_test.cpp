// The samples' pool of threads: each task runs once, on any number of threads, however many tasks there are.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <set>
#include <thread>
#include <vector>

#include "workers/thread_pool.hpp"

#if defined(__linux__)
#include <pthread.h>
#include <sched.h>
#include <time.h>
#endif

namespace {

using islet::samples::ThreadPool;

// How often each task ran.
struct Counts {
    std::vector<std::atomic<int>> of;
    explicit Counts(std::size_t n) : of(n) {}
    static void task(void* counts, std::uint32_t index) { ++static_cast<Counts*>(counts)->of[index]; }
    bool all_once() const {
        for (const std::atomic<int>& n : of)
            if (n != 1) return false;
        return true;
    }
};

TEST(ThreadPool, EachTaskRunsOnceAndHasReturnedAtTheEnd) {
    for (const std::uint32_t workers : {1u, 2u, 3u, 8u}) {
        ThreadPool pool(workers);
        for (const std::uint32_t count : {0u, 1u, 2u, 3u, 7u, 8u, 9u, 1000u}) {
            Counts counts(count);
            pool.parallel_for(count, Counts::task, &counts);
            EXPECT_TRUE(counts.all_once()) << workers << " workers, " << count << " tasks";
        }
    }
}

TEST(ThreadPool, ManyShortJobsInARowMixNothingUp) {
    ThreadPool pool(4);
    for (std::uint32_t job = 0; job < 20000; ++job) {
        const std::uint32_t count = 2 + job % 5;
        Counts counts(count);
        pool.parallel_for(count, Counts::task, &counts);
        ASSERT_TRUE(counts.all_once()) << "job " << job;
    }
}

TEST(ThreadPool, WorkersThatFellAsleepWakeUp) {
    ThreadPool pool(3);
    for (int job = 0; job < 20; ++job) {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));  // longer than they spin
        Counts counts(64);
        pool.parallel_for(64, Counts::task, &counts);
        ASSERT_TRUE(counts.all_once()) << "job " << job;
    }
}

TEST(ThreadPool, TasksRunOnSeveralThreads) {
    // Two tasks that each wait for the other to have begun, though not for ever: while the worker rests, the caller runs both.
    using Clock = std::chrono::steady_clock;
    ThreadPool pool(2);
    bool together = false;
    for (const Clock::time_point end = Clock::now() + std::chrono::seconds(20); !together && Clock::now() < end;) {
        struct Meeting {
            std::atomic<int> begun{0}, met{0};
        } meeting;
        pool.parallel_for(
            2,
            [](void* data, std::uint32_t) {
                auto& [begun, met] = *static_cast<Meeting*>(data);
                ++begun;
                for (const Clock::time_point late = Clock::now() + std::chrono::milliseconds(50); begun < 2 && Clock::now() < late;) std::this_thread::yield();
                if (begun == 2) ++met;
            },
            &meeting);
        together = meeting.met == 2;
    }
    EXPECT_TRUE(together);
}

TEST(ThreadPool, WhatTasksWroteIsSeenByTheCaller) {
    ThreadPool pool(4);
    for (int job = 0; job < 1000; ++job) {
        std::vector<std::uint32_t> written(100, 0);  // plain memory: the sanitizer would see a race
        pool.parallel_for(
            100, [](void* data, std::uint32_t i) { (*static_cast<std::vector<std::uint32_t>*>(data))[i] = i + 1; }, &written);
        for (std::uint32_t i = 0; i < 100; ++i) ASSERT_EQ(written[i], i + 1);
    }
}

#if defined(__linux__)

// How long the clock's thread, or all of the program's, have been on a core.
std::chrono::nanoseconds on_core(clockid_t clock = CLOCK_THREAD_CPUTIME_ID) {
    timespec time{};
    clock_gettime(clock, &time);
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

// Binds the calling thread, and those that it starts, to one core; at the end, to those that it had.
class Bound {
public:
    Bound() { sched_getaffinity(0, sizeof all_, &all_); }
    ~Bound() { sched_setaffinity(0, sizeof all_, &all_); }
    Bound(const Bound&) = delete;
    Bound& operator=(const Bound&) = delete;

    std::size_t cores() const { return static_cast<std::size_t>(CPU_COUNT(&all_)); }
    /// To the k-th of its cores; false if the system refuses.
    bool to(std::size_t k) const {
        std::size_t core = 0;
        while (!CPU_ISSET(core, &all_) || k-- > 0) ++core;
        cpu_set_t one;
        CPU_ZERO(&one);
        CPU_SET(core, &one);
        return sched_setaffinity(0, sizeof one, &one) == 0;
    }

    /// Which of its cores that is.
    std::size_t place_of(int core) const {
        std::size_t k = 0;
        for (int i = 0; i < core; ++i) k += CPU_ISSET(static_cast<std::size_t>(i), &all_) ? 1 : 0;
        return k;
    }

private:
    cpu_set_t all_;
};

// A worker that sleeps in its tasks is to the pool like one that has lost its core. It holds up the caller for 2.5 ms and more of the caller's time on a core.
struct Sleeper {
    using Clock = std::chrono::steady_clock;
    std::thread::id caller = std::this_thread::get_id();
    clockid_t caller_clock = CLOCK_THREAD_CPUTIME_ID;
    int naps = 0, too_soon = 0;
    Clock::time_point last_end = Clock::now() - std::chrono::seconds(1);

    Sleeper() { pthread_getcpuclockid(pthread_self(), &caller_clock); }
    std::chrono::nanoseconds caller_on_core() const { return on_core(caller_clock); }
    static void task(void* data, std::uint32_t) {
        auto& sleeper = *static_cast<Sleeper*>(data);
        const Clock::time_point begin = Clock::now();
        if (std::this_thread::get_id() == sleeper.caller) {
            while (Clock::now() < begin + std::chrono::microseconds(300)) {}  // long enough for the worker to take the other task
            return;
        }
        ++sleeper.naps;
        sleeper.too_soon += begin < sleeper.last_end + std::chrono::milliseconds(50) ? 1 : 0;
        const std::chrono::nanoseconds held = sleeper.caller_on_core() + std::chrono::milliseconds(3);
        for (std::chrono::milliseconds nap{2}; sleeper.caller_on_core() < held; nap *= 2) std::this_thread::sleep_for(nap);
        sleeper.last_end = Clock::now();
    }
};

TEST(ThreadPool, AWorkerThatDoesNotRunRestsTwentyTimesAsLongAsItHeldUpTheCaller) {
    ThreadPool pool(2);
    Sleeper sleeper;
    for (int job = 0; job < 300 && sleeper.naps < 6; ++job) pool.parallel_for(2, Sleeper::task, &sleeper);
    EXPECT_EQ(sleeper.too_soon, 0) << "of " << sleeper.naps;
}

TEST(ThreadPool, AWorkerThatRestedComesBack) {
    ThreadPool pool(2);
    Sleeper sleeper;
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (sleeper.naps < 2 && std::chrono::steady_clock::now() < end) pool.parallel_for(2, Sleeper::task, &sleeper);
    EXPECT_EQ(sleeper.naps, 2);
}

TEST(ThreadPool, AWorkerWhoseTaskIsLongIsNotLeftOut) {
    struct Pair {
        std::thread::id caller = std::this_thread::get_id();
        std::atomic<int> begun{0};
        bool waits_in_vain = false, lost_core = false;
        static void task(void* data, std::uint32_t) {
            auto& pair = *static_cast<Pair*>(data);
            const auto begin = std::chrono::steady_clock::now();
            const std::chrono::nanoseconds began = on_core();
            ++pair.begun;
            if (std::this_thread::get_id() == pair.caller) {  // the worker's task begins, and lasts longer
                while (pair.begun < 2 && !pair.waits_in_vain) {
                    std::this_thread::yield();
                    pair.waits_in_vain = on_core() > began + std::chrono::milliseconds(20);
                }
                return;
            }
            while (std::chrono::steady_clock::now() < begin + std::chrono::milliseconds(5)) {}
            pair.lost_core = 10 * (on_core() - began) < 9 * (std::chrono::steady_clock::now() - begin);
        }
    };
    const Bound bound;
    if (bound.cores() < 2) GTEST_SKIP() << "only one core: the worker has to rest";
    ASSERT_TRUE(bound.to(1));
    ThreadPool pool(2);  // its thread stays there, beside the caller's core, however busy other programs are
    ASSERT_TRUE(bound.to(0));
    int alone = 0;
    for (int job = 0; job < 10; ++job) {
        Pair pair;
        pool.parallel_for(2, Pair::task, &pair);
        alone += pair.waits_in_vain ? 1 : 0;
        if (pair.lost_core) return;  // to another program: then the worker may rest
    }
    EXPECT_LE(alone, 5);  // a worker that rested after each task of 5 ms would be there for one job in six
}

// Where another program keeps the second core busy, the system may leave the worker on the caller's core.
TEST(ThreadPool, AWorkerOnTheCallersCoreTakesLittleOfTheCallersTime) {
    const Bound bound;
    ASSERT_TRUE(bound.to(0));  // the pool's thread inherits it
    ThreadPool pool(2);
    const auto task = [](void*, std::uint32_t) {
        for (const std::chrono::nanoseconds end = on_core() + std::chrono::microseconds(20); on_core() < end;) {}
    };
    const std::chrono::nanoseconds program = on_core(CLOCK_PROCESS_CPUTIME_ID), caller = on_core();
    while (on_core() < caller + std::chrono::milliseconds(300)) pool.parallel_for(2, task, nullptr);
    const std::chrono::nanoseconds of_caller = on_core() - caller, of_worker = on_core(CLOCK_PROCESS_CPUTIME_ID) - program - of_caller;
    EXPECT_LT(of_worker, of_caller / 5) << "ns; what the two did there, the caller could have done alone";
}

// True if the caller gets less than four fifths of any of its cores.
bool others_are_busy(const Bound& bound) {
    for (std::size_t k = 0; k < bound.cores(); ++k) {
        if (!bound.to(k)) return true;
        const auto begin = std::chrono::steady_clock::now();
        const std::chrono::nanoseconds began = on_core();
        while (std::chrono::steady_clock::now() < begin + std::chrono::milliseconds(50)) {}
        if (5 * (on_core() - began) < 4 * (std::chrono::steady_clock::now() - begin)) return true;
    }
    return false;
}

// A game sleeps between its frames, and so do the workers; the system may then put the caller on the core where a worker was last.
TEST(ThreadPool, AWorkerThatSleepsIsNotTakenForOneOnTheCallersCore) {
    struct Meeting {
        std::thread::id caller = std::this_thread::get_id();
        std::atomic<int> core{-1};  // of the worker
        static void task(void* data, std::uint32_t) {
            auto& meeting = *static_cast<Meeting*>(data);
            if (std::this_thread::get_id() != meeting.caller) {
                meeting.core = sched_getcpu();
                return;
            }
            for (const std::chrono::nanoseconds end = on_core() + std::chrono::milliseconds(5); meeting.core < 0 && on_core() < end;) {}
        }
    };
    const Bound bound;
    if (bound.cores() < 2) GTEST_SKIP() << "only one core: the worker has to rest";
    int most = 0;  // frames of 30 in which the worker took part; where other programs are busy, it may have to rest in some tries
    for (const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(5); most < 10 && std::chrono::steady_clock::now() < end;) {
        ThreadPool pool(2);
        int met = 0;
        std::size_t where = 0;  // the caller's core
        for (int frame = 0; frame < 30; ++frame) {
            ASSERT_TRUE(bound.to(where));
            Meeting meeting;
            pool.parallel_for(2, Meeting::task, &meeting);
            met += meeting.core >= 0 ? 1 : 0;
            where = meeting.core >= 0 ? bound.place_of(meeting.core) : where;  // the next frame finds the caller where the worker was
            std::this_thread::sleep_for(std::chrono::milliseconds(3));         // longer than workers spin
        }
        most = std::max(most, met);
    }
    if (most < 10 && others_are_busy(bound)) GTEST_SKIP() << "other programs keep the cores busy: the worker may have to rest";
    EXPECT_GE(most, 10);  // a rest lasts for six frames and more, and each is twice as long: 4 or 5 would be left
}

#endif

TEST(ThreadPool, EndsWhetherItWasUsedOrNot) {
    for (int i = 0; i < 50; ++i) {
        ThreadPool pool(4);
        if (i % 2 == 0) continue;
        Counts counts(8);
        pool.parallel_for(8, Counts::task, &counts);
    }
}

TEST(ThreadPool, NoWorkersAreTakenForOne) {
    ThreadPool pool(0);
    EXPECT_EQ(pool.workers(), 1u);
    EXPECT_EQ(pool.tasks().workers, 1u);
}

}  // namespace
