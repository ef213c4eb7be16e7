// The samples' pool of threads: each task runs once, on any number of threads, however many tasks there are.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

#include "workers/thread_pool.hpp"

#if defined(__linux__)
#include <sched.h>
#endif

namespace {

using islet::samples::Machine;
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

// A machine on which only the pool runs, with a caller and one worker. A test says on which cores they are and how time passes.
class QuietMachine : public Machine {
public:
    std::atomic<int> core_of_caller{0}, core_of_worker{1};
    std::atomic<Nanoseconds> time{Nanoseconds(0)}, caller_time{Nanoseconds(0)}, worker_time{Nanoseconds(0)};
    std::atomic<int> waits{0};            // how often the caller began or ended a long wait
    std::atomic<int> looks_of_worker{0};  // how often the worker looked on which core it is

    Nanoseconds now() override { return time; }
    int own_core() override {
        if (is_caller()) return core_of_caller;
        ++looks_of_worker;
        return core_of_worker;
    }
    Nanoseconds own_time_on_core() override { return caller_time; }
    Nanoseconds time_on_core(std::thread&) override {
        const Nanoseconds spent = worker_time;
        ++waits;
        return spent;
    }
    bool is_caller() const { return std::this_thread::get_id() == caller_; }

private:
    std::thread::id caller_ = std::this_thread::get_id();
};

// True once `done()` is; false if it is not for 20 seconds, which only a fault can cause.
template <class Done>
bool wait_until(Done&& done) {
    using Clock = std::chrono::steady_clock;
    for (const Clock::time_point late = Clock::now() + std::chrono::seconds(20); !done();) {
        if (Clock::now() > late) return false;
        std::this_thread::yield();
    }
    return true;
}

// A pool of a caller and a worker on a quiet machine, and jobs for the two.
struct Quiet {
    QuietMachine machine;
    ThreadPool pool{2, machine};

    // What the two do at the same time; each waits for the other to have begun. True if the worker took part.
    struct Job {
        QuietMachine& machine;
        std::chrono::microseconds wait, work;  // of the caller, and of the worker meanwhile
        std::atomic<int> begun{0};
        std::atomic<bool> met{true};

        static void task(void* data, std::uint32_t) {
            Job& job = *static_cast<Job*>(data);
            const int waits = job.machine.waits;
            ++job.begun;
            if (!wait_until([&] { return job.begun == 2; })) job.met = false;
            if (job.machine.is_caller() || !job.met || job.wait.count() == 0) return;
            if (!wait_until([&] { return job.machine.waits > waits; })) job.met = false;
            job.machine.caller_time = job.machine.caller_time.load() + job.wait;
            job.machine.worker_time = job.machine.worker_time.load() + job.work;
        }
    };
    bool both_work(std::chrono::microseconds wait = {}, std::chrono::microseconds work = {}) {
        Job job{machine, wait, work};
        pool.parallel_for(2, Job::task, &job);
        return job.met;
    }

    // Gives the pool two tasks, which a worker that rests leaves to the caller. Returns how many workers rest.
    std::uint32_t resting() {
        std::atomic<int> done{0};
        pool.parallel_for(
            2, [](void* data, std::uint32_t) { ++*static_cast<std::atomic<int>*>(data); }, &done);
        EXPECT_EQ(done, 2);
        return pool.workers() - pool.ready_workers();
    }
};

using std::chrono::microseconds;
using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr milliseconds tick{1};

TEST(ThreadPool, AWorkerThatDoesNotRunRestsTwentyTimesAsLongAsItHeldUpTheCaller) {
    Quiet quiet;
    ASSERT_TRUE(quiet.both_work(milliseconds(3), milliseconds(1)));  // the caller waited for 3 ms, and 0.1 ms before that
    EXPECT_EQ(quiet.resting(), 1u);
    quiet.machine.time = milliseconds(62) - tick;
    EXPECT_EQ(quiet.resting(), 1u);
    quiet.machine.time = milliseconds(62);
    EXPECT_EQ(quiet.resting(), 0u);
    EXPECT_TRUE(quiet.both_work());
}

TEST(ThreadPool, AWorkerThatHoldsUpTheCallerAgainRestsTwiceAsLongUpToASecond) {
    Quiet quiet;
    for (const int length : {62, 124, 248, 496, 992, 1000, 1000}) {
        const milliseconds rest{length};
        ASSERT_TRUE(quiet.both_work(milliseconds(3)));
        const auto begin = quiet.machine.time.load();
        quiet.machine.time = begin + rest - tick;
        EXPECT_EQ(quiet.resting(), 1u) << rest.count() << " ms";
        quiet.machine.time = begin + rest;
        EXPECT_EQ(quiet.resting(), 0u) << rest.count() << " ms";
    }
    quiet.machine.time = quiet.machine.time.load() + seconds(1);  // as long as the last rest: that is forgotten
    ASSERT_TRUE(quiet.both_work(milliseconds(3)));
    quiet.machine.time = quiet.machine.time.load() + milliseconds(62);
    EXPECT_EQ(quiet.resting(), 0u);
}

// A world that steps asks this of its task system.
TEST(ThreadPool, ItsTaskSystemCountsTheWorkersThatDoNotRest) {
    Quiet quiet;
    const islet::TaskSystem tasks = quiet.pool.tasks();
    EXPECT_EQ(tasks.workers, 2u);
    EXPECT_EQ(tasks.ready_workers(tasks.context), 2u);
    ASSERT_TRUE(quiet.both_work(milliseconds(3)));
    EXPECT_EQ(tasks.ready_workers(tasks.context), 1u);
    quiet.machine.time = milliseconds(62);
    EXPECT_EQ(tasks.ready_workers(tasks.context), 2u) << "a world that found one worker gives the pool no tasks, so this question must end the rest";
    EXPECT_TRUE(quiet.both_work());
}

TEST(ThreadPool, AWorkerWhoseTaskIsLongIsNotLeftOut) {
    Quiet quiet;
    for (int job = 0; job < 10; ++job) {
        ASSERT_TRUE(quiet.both_work(milliseconds(5), milliseconds(5)));
        EXPECT_EQ(quiet.resting(), 0u) << "job " << job;
    }
    ASSERT_TRUE(quiet.both_work(milliseconds(5), microseconds(2499)));  // less than half of that: it has lost its core
    EXPECT_EQ(quiet.resting(), 1u);
}

// Where another program keeps the second core busy, the system may leave the worker on the caller's core.
TEST(ThreadPool, AWorkerOnTheCallersCoreRestsForTwoMilliseconds) {
    Quiet quiet;
    quiet.machine.core_of_worker = 0;
    ASSERT_TRUE(wait_until([&] { return quiet.resting() == 1; }));  // once the worker has looked where it is
    quiet.machine.time = milliseconds(2) - tick;
    EXPECT_EQ(quiet.resting(), 1u);
    quiet.machine.core_of_worker = 1;
    quiet.machine.time = milliseconds(2);
    EXPECT_EQ(quiet.resting(), 0u);
    for (int job = 0; job < 10; ++job) EXPECT_TRUE(quiet.both_work());
    EXPECT_EQ(quiet.resting(), 0u);
}

// A game sleeps between its frames, and so do the workers; the system may then put the caller on the core where a worker was last.
TEST(ThreadPool, AWorkerThatSleepsIsNotTakenForOneOnTheCallersCore) {
    for (int game = 0; game < 10; ++game) {
        Quiet quiet;
        ASSERT_TRUE(quiet.both_work());
        ASSERT_TRUE(wait_until([&] { return quiet.machine.looks_of_worker > 1; }));
        std::this_thread::sleep_for(tick);  // longer than it spins
        quiet.machine.core_of_caller = quiet.machine.core_of_worker.exchange(2);
        EXPECT_EQ(quiet.resting(), 0u);
    }
}

#if defined(__linux__)
TEST(ThreadPool, TheComputerSaysHowLongAThreadWasOnACoreAndOnWhich) {
    Machine& machine = islet::samples::this_machine();
    std::atomic<bool> worked{false}, ends{false};
    std::thread worker([&] {
        while (machine.own_time_on_core() < milliseconds(2)) {}
        worked = true;
        while (!ends) std::this_thread::yield();
    });
    ASSERT_TRUE(wait_until([&] { return worked.load(); }));
    EXPECT_GE(machine.time_on_core(worker), milliseconds(2));
    ends = true;
    worker.join();

    cpu_set_t all, one;
    ASSERT_EQ(sched_getaffinity(0, sizeof all, &all), 0);
    for (int core = 0; core < CPU_SETSIZE; ++core) {
        if (!CPU_ISSET(static_cast<std::size_t>(core), &all)) continue;
        CPU_ZERO(&one);
        CPU_SET(static_cast<std::size_t>(core), &one);
        ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0);
        EXPECT_EQ(machine.own_core(), core);
    }
    sched_setaffinity(0, sizeof all, &all);
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
