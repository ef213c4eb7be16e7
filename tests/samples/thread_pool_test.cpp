// The samples' pool of threads: each task runs once, on any number of threads, however many tasks there are.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <set>
#include <thread>
#include <vector>

#include "workers/thread_pool.hpp"

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
    // Two tasks that each wait for the other to have begun: on one thread this would never end.
    ThreadPool pool(2);
    std::atomic<int> begun{0};
    pool.parallel_for(
        2,
        [](void* data, std::uint32_t) {
            auto& count = *static_cast<std::atomic<int>*>(data);
            ++count;
            while (count < 2) std::this_thread::yield();
        },
        &begun);
    EXPECT_EQ(begun, 2);
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
