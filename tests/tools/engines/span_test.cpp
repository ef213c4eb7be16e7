// `islet bench --span` on tasks whose costs are known, and on a world: a clock that the tasks move makes every time exact.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "harness/engine.hpp"
#include "islet/worker_span.hpp"

namespace {

using namespace islet;
using namespace islet::samples;
using namespace islet::tools;
using nlohmann::json;

constexpr std::uint64_t ms = 1'000'000;  // in ns

// A clock that stands still but for the work that is put on it.
struct MadeUpClock {
    std::uint64_t now = 0;
    SpanMeter::Now reader() {
        return [this] { return now; };
    }
};

// What a step of a world with one job does, with made-up costs: the stages take `alone` ms on the stepping thread, and the solve has a job of these tasks.
struct MadeUpStep {
    MadeUpClock& clock;
    std::vector<std::uint64_t> tasks;  // ms

    void run(SpanMeter& meter, std::uint64_t alone) {
        SpanMeter::tick(&meter);  // the step begins
        for (std::size_t stage = 0; stage < span_stages.size(); ++stage) {
            clock.now += alone * ms;
            if (stage == 3) {
                const TaskSystem system = meter.tasks();
                system.parallel_for(
                    system.context, static_cast<std::uint32_t>(tasks.size()),
                    [](void* data, std::uint32_t i) {
                        auto& step = *static_cast<MadeUpStep*>(data);
                        step.clock.now += step.tasks[i] * ms;
                    },
                    this);
                clock.now += alone * ms;
            }
            SpanMeter::tick(&meter);
        }
    }
};

TEST(Span, AWorkerThatIsFreeTakesTheNextTask) {
    StageTimes stage;
    stage.alone = {1, 2};
    stage.jobs = {{3, 1, 1, 1, 4}};
    EXPECT_EQ(stage.work(), 13);
    EXPECT_EQ(stage.alone_work(), 3);
    EXPECT_EQ(stage.chain(), 3 + 4);
    EXPECT_EQ(stage.time_with(1), 13);
    EXPECT_EQ(stage.time_with(2), 3 + 7);  // one takes 3 and then 4, the other 1, 1 and 1
    EXPECT_EQ(stage.time_with(3), 3 + 5);  // 3; 1, 1; 1, 4
    EXPECT_EQ(stage.time_with(16), 3 + 4);
}

TEST(Span, AJobBeginsWhenTheOneBeforeHasEnded) {
    StageTimes stage;
    stage.alone = {0, 0, 0};
    stage.jobs = {{5, 1}, {1, 5}};
    EXPECT_EQ(stage.time_with(2), 10);  // and not 6, as if the four tasks were one job
    EXPECT_EQ(stage.chain(), 10);
}

TEST(Span, TheMeterTellsTasksFromWhatTheSteppingThreadDoesAlone) {
    MadeUpClock clock;
    SpanMeter meter(4, clock.reader());
    EXPECT_EQ(meter.tasks().workers, 4u);
    MadeUpStep step{clock, {7, 3, 2}};
    step.run(meter, 1);
    clock.now += 1000 * ms;  // between two steps: nobody's
    step.run(meter, 2);
    ASSERT_EQ(meter.steps().size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        const double alone = i == 0 ? 1 : 2;
        const StepTimes& times = meter.steps()[i];
        for (const std::size_t stage : {0u, 1u, 2u, 4u}) {
            EXPECT_EQ(times[stage].work(), alone);
            EXPECT_TRUE(times[stage].jobs.empty());
        }
        EXPECT_EQ(times[3].alone, (std::vector<double>{alone, alone}));
        EXPECT_EQ(times[3].jobs, (std::vector<std::vector<double>>{{7, 3, 2}}));
    }
}

TEST(Span, RowsAreMeansOverTheStepsAndTheLastIsTheStep) {
    MadeUpClock clock;
    SpanMeter one(1, clock.reader()), two(2, clock.reader());
    MadeUpStep step{clock, {6, 6}};
    step.run(one, 1);
    step.run(one, 1);
    step.run(two, 1);
    step.run(two, 3);
    const std::vector<SpanRow> rows = span_rows(one.steps(), {2}, {two.steps()});
    ASSERT_EQ(rows.size(), 6u);
    EXPECT_EQ(rows[3].stage, "solve");
    EXPECT_EQ(rows[3].one_worker, 1 + 12 + 1);
    EXPECT_EQ(rows[3].work, (14 + 18) / 2.0);
    EXPECT_EQ(rows[3].alone, (2 + 6) / 2.0);
    EXPECT_EQ(rows[3].chain, (8 + 12) / 2.0);
    EXPECT_EQ(rows[3].time, std::vector<double>{(8 + 12) / 2.0});
    EXPECT_EQ(rows[5].stage, "step");
    EXPECT_EQ(rows[5].one_worker, 4 + 14);
    EXPECT_EQ(rows[5].time, std::vector<double>{(4 + 8 + 12 + 12) / 2.0});
}

TEST(Span, WhatDisturbedOneRunDoesNotCount) {
    std::vector<StepTimes> least(1), other(1);
    least[0][1].alone = {1, 9};
    least[0][1].jobs = {{5, 2}};
    other[0][1].alone = {2, 3};
    other[0][1].jobs = {{4, 6}};
    take_least(least, other);
    EXPECT_EQ(least[0][1].alone, (std::vector<double>{1, 3}));
    EXPECT_EQ(least[0][1].jobs, (std::vector<std::vector<double>>{{4, 2}}));
    other[0][1].jobs = {{4, 6, 1}};
    EXPECT_THROW(take_least(least, other), std::logic_error);
    other.emplace_back();
    EXPECT_THROW(take_least(least, other), std::logic_error);
}

// A world that is stepped by the meter has the bits of a world without workers, and a scene with many bodies has tasks to share.
TEST(Span, AWorldIsTheSameUnderTheMeterAndSharesItsWork) {
    std::uint64_t hashes[2] = {};
    for (const std::uint32_t workers : {1u, 8u}) {
        SpanMeter meter(workers);
        Scene scene = find_scene("large_pyramid")->make();
        scene.world.tasks = meter.tasks();
        scene.world.clock = SpanMeter::tick;
        scene.world.clock_context = &meter;
        IsletEngine engine;
        engine.load(scene);
        for (int i = 0; i < 5; ++i) engine.advance(scene, i, scene.dt);
        hashes[workers / 8] = engine.world().hash();
        ASSERT_EQ(meter.steps().size(), 5u);
        const StageTimes& solve = meter.steps()[4][3];
        EXPECT_EQ(solve.jobs.empty(), workers == 1);
        EXPECT_GE(solve.work(), solve.chain());
    }
    EXPECT_EQ(hashes[0], hashes[1]);
}

TEST(Span, ResultsNameEveryStageAndEveryNumberOfWorkers) {
    SpanOptions options;
    options.scenes = {find_scene("pyramid"), find_scene("hello")};
    options.steps = 3;
    options.repeat = 2;
    options.workers = {2, 8};
    int last = 0, total = 0;
    std::vector<std::string> ended;
    const std::vector<SpanResult> results = measure_span(
        options,
        [&](int done, int all) {
            EXPECT_EQ(done, ++last);
            total = all;
        },
        [&](const SpanResult& result) { ended.push_back(result.scene); });
    EXPECT_EQ(ended, (std::vector<std::string>{"pyramid", "hello"}));
    EXPECT_EQ(last, 2 * 3 * 2 * 3);  // scenes, steps, runs, numbers of workers and one
    EXPECT_EQ(total, last);
    const json list = json::parse(json_of(results));
    ASSERT_EQ(list.size(), 2u);
    EXPECT_EQ(list[0]["scene"], "pyramid");
    EXPECT_EQ(list[0]["steps"], 3);
    EXPECT_GT(list[0]["bodies"], 1);
    ASSERT_EQ(list[0]["stages"].size(), 6u);
    EXPECT_EQ(list[0]["stages"][5]["stage"], "step");
    for (const json& stage : list[0]["stages"]) {
        EXPECT_GE(stage["ms_work"], stage["ms_alone"]);
        EXPECT_GE(stage["ms_chain"], stage["ms_alone"]);
        ASSERT_EQ(stage["with"].size(), 2u);
        EXPECT_EQ(stage["with"][1]["workers"], 8);
        EXPECT_GE(stage["with"][1]["ms"], 0);
        EXPECT_TRUE(stage["ms_one_worker"].is_number());
    }
    const std::string table = span_table(results[0]);
    EXPECT_NE(table.find("pyramid: 3 steps"), std::string::npos) << table;
    for (const char* word : {"1 worker", "chain", "2 workers", "8 workers", "pairs", "collide", "islands", "solve", "finish", "step"})
        EXPECT_NE(table.find(word), std::string::npos) << word << " is not in " << table;
}

}  // namespace
