// Workers change nothing: whatever order the tasks of a step run in, and on however many threads, the hashes are those of golden.txt. Orders are played
// by task systems that run everything on one thread, so they are the same in every run of this test.
#include <gtest/gtest.h>

#include <numeric>
#include <string>
#include <thread>
#include <vector>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "golden.hpp"
#include "support/random.hpp"
#include "support/test_world.hpp"
#include "workers/thread_pool.hpp"

namespace islet::test {
namespace {

using Task = void (*)(void* data, std::uint32_t index);

// Task systems of one thread, which claim to have four.
struct Order {
    std::uint64_t calls = 0, tasks = 0;
    Random random{7};

    void count(std::uint32_t n) {
        ++calls;
        tasks += n;
    }
    // Any number, also 0 and more than there are.
    static std::uint32_t some(void* order) { return static_cast<Order*>(order)->random.below(12); }
    static void backwards(void* order, std::uint32_t count, Task task, void* data) {
        static_cast<Order*>(order)->count(count);
        for (std::uint32_t i = count; i-- > 0;) task(data, i);
    }
    static void shuffled(void* order, std::uint32_t count, Task task, void* data) {
        auto* self = static_cast<Order*>(order);
        self->count(count);
        std::vector<std::uint32_t> indices(count);
        std::iota(indices.begin(), indices.end(), 0u);
        for (std::uint32_t i = count; i > 1; --i) std::swap(indices[i - 1], indices[self->random.below(i)]);
        for (const std::uint32_t i : indices) task(data, i);
    }
    // As a host may have left its threads: flush-to-zero on, and rounding towards zero.
    static void other_float_mode(void* order, std::uint32_t count, Task task, void* data) {
        static_cast<Order*>(order)->count(count);
        std::thread([&] {
#if defined(__SSE2__)
            _mm_setcsr(_mm_getcsr() | 0xe040u);
#endif
            for (std::uint32_t i = 0; i < count; ++i) task(data, i);
        }).join();
    }
};

void expect_golden(const samples::SceneInfo& info, const TaskSystem& tasks, const char* what) {
    const golden::Table table = golden::read(golden::file());
    const bool large = std::string(info.group) == "benchmark";
    const std::vector<golden::Checkpoint> due = golden::checkpoints_of(table, info);
    const std::vector<golden::Checkpoint> seen = golden::run(info, due, 0, large ? 20 : 60, tasks);
    for (std::size_t i = 0; i < seen.size(); ++i)
        EXPECT_EQ(golden::hex(seen[i].hash), golden::hex(due[i].hash)) << what << ", after " << seen[i].steps << " steps";
}

class Workers : public testing::TestWithParam<samples::SceneInfo> {};

TEST_P(Workers, OrderOfTasksDecidesNothing) {
    Order order;
    expect_golden(GetParam(), {Order::backwards, &order, 4}, "backwards");
    expect_golden(GetParam(), {Order::shuffled, &order, 4}, "shuffled");
#if ISLET_THREADS
    if (std::string(GetParam().group) == "benchmark") { EXPECT_GT(order.tasks, 2 * order.calls) << "hardly anything was cut: this test shows nothing"; }
#endif
}

TEST_P(Workers, HowManyAreReadyMayChangeFromStepToStep) {
    Order order;
    expect_golden(GetParam(), {Order::shuffled, &order, 8, Order::some}, "0 to 11 of 8 workers ready");
}

INSTANTIATE_TEST_SUITE_P(Scenes, Workers, testing::ValuesIn(samples::catalogue()), [](const auto& test) { return std::string(test.param.name); });

TEST(WorkersOnThreads, HashesAreTheSameForAnyNumber) {
    for (const char* name : {"large_pyramid", "many_pyramids", "washer", "rain"}) {
        for (const std::uint32_t workers : {1u, 2u, 4u, 8u}) {
            samples::ThreadPool pool(workers);
            expect_golden(*samples::find_scene(name), pool.tasks(), name);
        }
    }
}

TEST(WorkersOnThreads, FloatModeOfAThreadDoesNotReachTheBits) {
    for (const char* name : {"large_pyramid", "many_pyramids"}) {
        Order order;
        expect_golden(*samples::find_scene(name), {Order::other_float_mode, &order, 2}, name);
    }
}

TEST(TaskSystems, OneWorkerOrNoFunctionStepsOnTheCallingThread) {
    const samples::SceneInfo& info = *samples::find_scene("many_pyramids");
    Order order;
    expect_golden(info, {Order::backwards, &order, 1}, "one worker");
    EXPECT_EQ(order.calls, 0u);
    expect_golden(info, {nullptr, nullptr, 8}, "no function");
}

TEST(TaskSystems, AreAskedOnceAStepHowManyWorkersAreReady) {
    struct Host {
        std::uint32_t ready = 1, questions = 0, calls = 0;
    } host;
    const TaskSystem tasks = {[](void* context, std::uint32_t count, Task task, void* data) {
                                  ++static_cast<Host*>(context)->calls;
                                  for (std::uint32_t i = 0; i < count; ++i) task(data, i);
                              },
                              &host, 4,
                              [](void* context) {
                                  ++static_cast<Host*>(context)->questions;
                                  return static_cast<Host*>(context)->ready;
                              }};
    samples::Scene scene = samples::find_scene("many_pyramids")->make();
    scene.world.tasks = tasks;
    samples::IsletEngine engine;
    engine.load(scene);
    for (const std::uint32_t ready : {1u, 0u}) {
        host.ready = ready;
        for (int i = 0; i < 3; ++i) engine.advance(scene, i, scene.dt);
        EXPECT_EQ(host.calls, 0u) << "the step gave tasks to workers that are not ready";
    }
    EXPECT_EQ(host.questions, 6u);
#if ISLET_THREADS
    host.ready = 2;
    engine.advance(scene, 6, scene.dt);
    EXPECT_GT(host.calls, 0u);
    EXPECT_EQ(host.questions, 7u);
#endif
}

TEST(TaskSystems, UnusableNumbersOfWorkersAreRefused) {
    TestWorld w;
    Order order;
    for (const std::uint32_t workers : {0u, max_workers + 1, 0xffffffffu}) {
        w->clear_error();
        w->set_tasks({Order::backwards, &order, workers});
        EXPECT_EQ(w->last_error(), Error::out_of_range) << workers;
        EXPECT_EQ(w->tasks().parallel_for, nullptr) << "a refused task system was kept";
        EXPECT_EQ(w->tasks().workers, 1u);

        alignas(world_alignment) static std::byte block[world_bytes({4, 4, 8})];
        WorldDef def;
        def.tasks.workers = workers;
        Error error = Error::none;
        EXPECT_EQ(World::create(block, {4, 4, 8}, def, &error), nullptr);
        EXPECT_EQ(error, Error::out_of_range);
    }
    w->clear_error();
    w->set_tasks({Order::backwards, &order, max_workers});
    EXPECT_EQ(w->last_error(), Error::none);
    EXPECT_EQ(w->tasks().workers, max_workers);
    EXPECT_EQ(w->tasks().context, &order);
}

// A gear's row reads all four bodies of its joints. Here the one it hangs on is kinematic and asleep and the other, kinematic too, turns: the gear's own
// island must be solved with that one, or what it reads depends on which batch runs first.
TEST(TaskSystems, OrderDecidesNothingWhereAGearReadsAKinematicBodyItDoesNotHangOn) {
    const auto play = [](const TaskSystem& tasks) {
        TestWorld w(roomy, {.gravity = {0, -10}, .tasks = tasks});
        const BodyId ground = w->create_body({});
        const BodyId turning = w.add_circle({0, 10}, 0.3f);
        const BodyId resting = w.add_circle({2, 10}, 0.3f);
        const BodyId driven = w.add(make_box(0.5f, 0.5f), BodyDef{.type = BodyType::dynamic, .position = {5, 10}, .enable_sleep = false});
        const JointId joint1 = w->create_joint(RevoluteJointDef{.base = {.body_a = turning, .body_b = resting, .frame_a = {{2, 0}}}});
        const JointId joint2 = w->create_joint(RevoluteJointDef{.base = {.body_a = ground, .body_b = driven, .frame_a = {{5, 10}}}});
        EXPECT_TRUE(w->create_joint(GearJointDef{.joint1 = joint1, .joint2 = joint2, .ratio = 1}));
        w->set_type(turning, BodyType::kinematic);
        w->set_type(resting, BodyType::kinematic);
        for (int i = 0; i < 60; ++i) w->step(1.0f / 60);
        EXPECT_FALSE(w->is_awake(resting));
        w->set_angular_velocity(turning, 1);
        for (int i = 0; i < 60; ++i) w->step(1.0f / 60);
        EXPECT_GT(w->angle(driven), 0.5f) << "the gear does nothing: this test shows nothing";
        return w->hash();
    };
    Order order;
    EXPECT_EQ(play({Order::backwards, &order, 4}), play({}));
}

// Workers search for pairs together. When there is no room for all of them, those that are dropped are the same ones.
TEST(TaskSystems, OrderDecidesNothingWhereContactsFindNoRoom) {
    constexpr Capacity tight{.bodies = 1024, .shapes = 1024, .contacts = 1500};
    const auto play = [&](const TaskSystem& tasks) {
        TestWorld w(tight, {.gravity = {0, -10}, .tasks = tasks});
        w.add_ground();
        for (int i = 0; i < 900; ++i)
            w.add(make_box(0.5f, 0.5f), {.type = BodyType::dynamic, .position = {0.7f * static_cast<float>(i % 30), 0.7f * static_cast<float>(i / 30)}});
        std::vector<std::uint64_t> seen;
        for (int i = 0; i < 20; ++i) {
            w->step(1.0f / 60);
            seen.push_back(w->report().dropped_contacts);
            seen.push_back(w->hash());
        }
        EXPECT_GT(seen[0], 0u) << "there was room for all contacts: this test shows nothing";
        return seen;
    };
    Order order;
    const std::vector<std::uint64_t> alone = play({});
    EXPECT_EQ(play({Order::backwards, &order, 4}), alone);
    EXPECT_EQ(play({Order::shuffled, &order, 16}), alone);
}

TEST(TaskSystems, AreNoPartOfTheState) {
    TestWorld with, without;
    Order order;
    with->set_tasks({Order::backwards, &order, 4});
    EXPECT_EQ(with->hash(), without->hash());
}

}  // namespace
}  // namespace islet::test
