// The bench's arithmetic on made-up numbers, and what it promises to report. Nothing here depends on how fast anything is.
#include <gtest/gtest.h>

#include <set>

#include <nlohmann/json.hpp>

#include "islet/bench.hpp"

namespace {

using namespace islet;
using namespace islet::samples;
using namespace islet::tools;
using engines::EngineInfo;
using nlohmann::json;

std::string lacks_nothing(const Scene&) { return {}; }
std::unique_ptr<Engine> make_islet() { return std::make_unique<IsletEngine>(); }
std::unique_ptr<Engine> make_none() { throw std::logic_error("an engine that cannot build the scene was made"); }

std::vector<std::string> made;  // which engines were made, in order
constexpr EngineInfo first = {"first", lacks_nothing, [] {
                                  made.emplace_back("first");
                                  return make_islet();
                              }};
constexpr EngineInfo second = {"second", lacks_nothing, [] {
                                   made.emplace_back("second");
                                   return make_islet();
                               }};
constexpr EngineInfo poor = {"poor", [](const Scene&) { return std::string("Poor has no wheels"); }, make_none};

BenchOptions options_for(const char* scene, std::vector<const EngineInfo*> list) {
    BenchOptions options;
    options.scenes = {find_scene(scene)};
    options.engines = std::move(list);
    options.steps = 5;
    options.repeat = 2;
    return options;
}

void ignore(int, int) {}

TEST(Median, IsTheMiddleOrTheMeanOfTheMiddleTwo) {
    EXPECT_EQ(median({7}), 7);
    EXPECT_EQ(median({100, 1, 3}), 3);
    EXPECT_EQ(median({4, 100, 1, 3}), 3.5);
    EXPECT_EQ(median({}), 0);
}

TEST(Percentile, IsTheNearestRank) {
    std::vector<double> values;
    for (int i = 200; i >= 1; --i) values.push_back(i);
    EXPECT_EQ(percentile(values, 99), 198);  // 198 of 200 are no larger
    EXPECT_EQ(percentile(values, 50), 100);
    EXPECT_EQ(percentile(values, 0), 1);
    EXPECT_EQ(percentile(values, 100), 200);
    EXPECT_EQ(percentile({5, 2}, 99), 5);
    EXPECT_EQ(percentile({}, 99), 0);
}

TEST(Summary, TakesMediansOverTheRuns) {
    const std::vector<BenchRun> runs = {{{1, 2, 9}, 4, 5, {}}, {{50, 60, 70}, 4, 5, {}}, {{3, 3, 3}, 4, 6, {}}};
    BenchResult result;
    summarise(runs, {}, result);
    EXPECT_EQ(result.ms_total, 12);        // of 12, 180, 9
    EXPECT_EQ(result.ms_per_step_p50, 3);  // of 2, 60, 3
    EXPECT_EQ(result.ms_per_step_p99, 9);  // of 9, 70, 3
    EXPECT_EQ(result.bodies, 4u);
    EXPECT_EQ(result.contacts, 6u);
    EXPECT_FALSE(result.ratio.has_value());
}

// The second turn was disturbed, both runs of it: the ratio of medians would be 20 / 10, that of each turn is 2, 4, 4.
TEST(Summary, ComparesRunsOfTheSameTurn) {
    const std::vector<BenchRun> islet = {{{10}, 1, 0, {}}, {{100}, 1, 0, {}}, {{5}, 1, 0, {}}};
    const std::vector<BenchRun> other = {{{20}, 1, 0, {}}, {{400}, 1, 0, {}}, {{20}, 1, 0, {}}};
    BenchResult result;
    summarise(other, islet, result);
    EXPECT_EQ(result.ratio, 4);
    summarise(islet, islet, result);
    EXPECT_EQ(result.ratio, 1);
}

TEST(Summary, TakesTheMedianOfEachStage) {
    std::vector<BenchRun> runs = {{{1}, 1, 0, BenchProfile{1, 20, 3, 4, 5}}, {{1}, 1, 0, BenchProfile{2, 10, 9, 4, 6}}, {{1}, 1, 0, BenchProfile{3, 30, 1, 4, 7}}};
    BenchResult result;
    summarise(runs, {}, result);
    ASSERT_TRUE(result.profile.has_value());
    EXPECT_EQ(result.profile->pairs, 2);
    EXPECT_EQ(result.profile->collide, 20);
    EXPECT_EQ(result.profile->islands, 3);
    EXPECT_EQ(result.profile->solve, 4);
    EXPECT_EQ(result.profile->finish, 6);
    runs[1].profile.reset();
    summarise(runs, {}, result);
    EXPECT_FALSE(result.profile.has_value());
}

TEST(Bench, EnginesTakeTurnsAndEachBeginsOne) {
    made.clear();
    bench(options_for("hello", {&first, &second}), {ignore});
    EXPECT_EQ(made, (std::vector<std::string>{"first", "second", "second", "first"}));
}

TEST(Bench, IsletIsTimedWithEachNumberOfWorkersAgainstTheFirst) {
    BenchOptions options = options_for("pyramid", {&first, engines::find_engine("islet")});
    options.workers = {2, 1};
    const std::vector<BenchResult> results = bench(options, {ignore});
    ASSERT_EQ(results.size(), 3u);
    EXPECT_EQ(results[0].workers, 1u);
    EXPECT_EQ(results[1].workers, 2u);
    EXPECT_EQ(results[1].ratio, 1.0);
    EXPECT_EQ(results[2].engine, "islet");
    EXPECT_EQ(results[2].workers, 1u);
    EXPECT_NE(results[2].ratio, results[1].ratio);
}

TEST(Bench, CountsTheStepsOfAllRuns) {
    int calls = 0;
    bench(options_for("hello", {&first, &poor, &second}), {[&calls](int done, int total) {
        EXPECT_EQ(done, ++calls);
        EXPECT_EQ(total, 2 * 2 * 5);
    }});
    EXPECT_EQ(calls, 20);
}

TEST(Bench, TellsEachResultWhenItsSceneEnds) {
    BenchOptions options = options_for("hello", {&first, &poor});
    options.scenes.push_back(find_scene("pyramid"));
    std::vector<std::string> told;
    int steps = 0;
    const std::vector<BenchResult> results =
        bench(options, {[&](int done, int) { steps = done; }, [&](const BenchResult& r) { told.push_back(r.scene + " " + r.engine + " " + std::to_string(steps)); }});
    EXPECT_EQ(told, (std::vector<std::string>{"hello first 10", "hello poor 10", "pyramid first 20", "pyramid poor 20"}));
    EXPECT_EQ(results.size(), 4u);
}

// Stopped in the second turn: each engine's first run counts, and the scene that was not begun has no row.
TEST(Bench, KeepsWholeRunsWhenItIsStopped) {
    BenchOptions options = options_for("hello", {engines::find_engine("islet"), &first});
    options.scenes.push_back(find_scene("pyramid"));
    int steps = 0;
    const std::vector<BenchResult> results = bench(options, {[&](int done, int) { steps = done; }, {}, [&] { return steps == 12; }});
    EXPECT_EQ(steps, 12);
    ASSERT_EQ(results.size(), 2u);
    EXPECT_EQ(results[1].scene, "hello");
    EXPECT_GT(results[1].ms_total, 0);
    EXPECT_TRUE(results[1].ratio.has_value());
}

TEST(Bench, EstimatesLongOnes) {
    EXPECT_EQ(estimate_seconds(options_for("hello", {&first})), 0);  // the bench itself is as quick
    BenchOptions options = options_for("pyramid", {&first});
    options.steps = 1000;
    EXPECT_GT(estimate_seconds(options), 0);
}

TEST(Bench, CutsAScenesOwnStepsShort) {
    BenchOptions options = options_for("hello", {&first});
    options.steps.reset();
    options.most_steps = 7;
    EXPECT_EQ(bench(options, {ignore})[0].steps, 7);
}

TEST(Bench, SaysWhatAnEngineCannotBuildAndWhy) {
    const std::vector<BenchResult> results = bench(options_for("hello", {&poor, &first}), {ignore});
    ASSERT_EQ(results.size(), 2u);
    EXPECT_EQ(results[0].engine, "poor");
    EXPECT_EQ(results[0].lacks, "Poor has no wheels");
    EXPECT_NE(table_of(results).find("not timed: Poor has no wheels"), std::string::npos);
    const json list = json::parse(json_of(results));
    ASSERT_EQ(list.size(), 2u);
    EXPECT_EQ(list[0], json({{"engine", "poor"}, {"scene", "hello"}, {"unsupported", "Poor has no wheels"}}));
    EXPECT_FALSE(list[1].contains("unsupported"));
}

TEST(Bench, JsonHasTheFieldsThatArePromised) {
    const std::vector<BenchResult> results = bench(options_for("pyramid", {engines::find_engine("islet"), &first}), {ignore});
    const json list = json::parse(json_of(results));
    ASSERT_EQ(list.size(), 2u);
    for (const json& object : list) {
        std::set<std::string> keys;
        for (const auto& item : object.items()) keys.insert(item.key());
        EXPECT_EQ(keys, (std::set<std::string>{"engine", "scene", "workers", "steps", "bodies", "contacts", "ms_total", "ms_per_step_p50",
                                               "ms_per_step_p99", "profile", "ratio"}));
        EXPECT_EQ(object["scene"], "pyramid");
        EXPECT_EQ(object["workers"], 1);
        EXPECT_EQ(object["steps"], 5);
        EXPECT_EQ(object["bodies"], 56);  // 10 + 9 + ... + 1, and the ground
        EXPECT_GT(object["contacts"], 0);
        double stages = 0;
        std::set<std::string> names;
        for (const auto& item : object["profile"].items()) {
            names.insert(item.key());
            EXPECT_GT(item.value(), 0.0) << item.key();
            stages += item.value().get<double>();
        }
        EXPECT_EQ(names, (std::set<std::string>{"pairs", "collide", "islands", "solve", "finish"}));
        EXPECT_LT(stages, 2 * object["ms_total"].get<double>());  // medians of each over two runs; ms, not other units
        EXPECT_GT(object["ms_total"], 0.0);
        EXPECT_GE(object["ms_per_step_p99"], object["ms_per_step_p50"]);
    }
    EXPECT_EQ(list[0]["ratio"], 1.0);
    EXPECT_TRUE(list[1]["ratio"].is_number());
}

TEST(Bench, WithoutIsletThereIsNoRatio) {
    const json list = json::parse(json_of(bench(options_for("hello", {&first}), {ignore})));
    EXPECT_TRUE(list[0]["ratio"].is_null());
}

TEST(Registry, HasIsletFirstAndFindsEachByName) {
    ASSERT_FALSE(engines::registry().empty());
    EXPECT_STREQ(engines::registry().front().name, "islet");
    for (const EngineInfo& info : engines::registry()) EXPECT_EQ(engines::find_engine(info.name), &info);
    EXPECT_EQ(engines::find_engine("newton"), nullptr);
}

// What an engine says it can build it can, and the reason why not is a sentence that names it.
TEST(Registry, EveryEngineBuildsASceneOrSaysWhyNot) {
    for (const EngineInfo& info : engines::registry()) {
        for (const SceneInfo& scene_info : catalogue()) {
            const Scene scene = scene_info.make();
            const std::string lacks = info.lacks(scene);
            if (!lacks.empty()) {
                EXPECT_NE(lacks.find(" has no "), std::string::npos) << info.name << ", " << scene_info.name;
                continue;
            }
            const std::unique_ptr<Engine> engine = info.make();
            engine->load(scene);
            EXPECT_EQ(engine->body_slots(), scene.bodies.size()) << info.name << ", " << scene_info.name;
        }
    }
}

}  // namespace
