// The table of `islet steady`: what it makes of the checks of scenes that have several starts.
#include "islet/steady.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "harness/checks.hpp"
#include "scenes/build.hpp"

namespace {

using namespace islet;
using namespace islet::tools;

/// A ball that falls for a step, and a check that says what a test wants it to.
template <std::vector<CheckLine> (*lines)(int start)>
Scene falling(int start) {
    Scene scene;
    scene.name = "falling";
    scene.steps = 1;
    add_dynamic(scene, {0, 0}, Circle{{}, 0.5f});
    scene.check = [start](const Engine&) { return lines(start); };
    return scene;
}

template <std::vector<CheckLine> (*lines)(int start)>
constexpr SceneInfo falling_info = {"falling", "steady", "a ball falls", [] { return falling<lines>(0); }, falling<lines>, 12};

SteadyTable table_for(const SceneInfo& info, int most_starts = 1000, unsigned jobs = 1) {
    return run_steady({{&info}, {&engines::registry().front()}, most_starts, jobs}, [](int, int) {});
}

std::vector<CheckLine> three_rows(int start) {
    return {
        wanted_line("way (m)", 0.1 * start, 1),
        at_most("no row", 5, 9),
        wanted_none("fell", start % 4 == 1, true),
        wanted_line("short (m)", 2, 1, 3),
    };
}

TEST(Steady, TakesTheWorstOfAllStartsAndCountsThoseThatFailed) {
    const SteadyTable table = table_for(falling_info<three_rows>);
    ASSERT_EQ(table.rows.size(), 3u);
    EXPECT_EQ(table.rows[0].what, "way (m)");
    EXPECT_EQ(table.rows[0].starts, 12);
    EXPECT_NEAR(table.rows[0].engines.at(0).worst, 1.1, 1e-12);
    EXPECT_FALSE(table.rows[0].is_reached());
    EXPECT_EQ(table.rows[1].engines.at(0).worst, 3);
    EXPECT_FALSE(table.rows[1].is_reached());
    EXPECT_FALSE(table.rows[2].is_reached());
    // 1.1 is beyond what the first row's check allows; the others are known to fall short.
    ASSERT_EQ(table.broken.size(), 1u);
    EXPECT_NE(table.broken[0].find("falling, start 11: way (m)"), std::string::npos) << table.broken[0];
    const std::string text = table_of(table);
    EXPECT_NE(text.find("3 of 12"), std::string::npos) << text;
    EXPECT_NE(text.find("NOT REACHED"), std::string::npos) << text;
    EXPECT_NE(text.find("0 of 3 reached"), std::string::npos) << text;
}

TEST(Steady, RunsTheFirstStartsAlone) {
    const SteadyTable table = table_for(falling_info<three_rows>, 1);
    EXPECT_EQ(table.rows.at(0).starts, 1);
    EXPECT_TRUE(table.rows[0].is_reached());
    EXPECT_TRUE(table.rows[1].is_reached());
    EXPECT_TRUE(table.broken.empty());
}

TEST(Steady, SaysTheSameForAnyNumberOfJobs) {
    EXPECT_EQ(table_of(table_for(falling_info<three_rows>, 1000, 4)), table_of(table_for(falling_info<three_rows>)));
}

std::vector<CheckLine> no_number(int start) { return {wanted_line("way (m)", start == 3 ? std::numeric_limits<double>::quiet_NaN() : 0, 1)}; }

TEST(Steady, WhatIsNoNumberIsNotReached) {
    const SteadyTable table = table_for(falling_info<no_number>);
    EXPECT_FALSE(table.rows.at(0).is_reached());
    EXPECT_TRUE(std::isinf(table.rows[0].engines.at(0).worst));
    EXPECT_EQ(table.broken.size(), 1u);
    EXPECT_NE(json_of(table).find("\"islet\": null"), std::string::npos) << json_of(table);
}

TEST(Steady, EveryRowOfTheCatalogueHasTenStartsThatDiffer) {
    const std::vector<const SceneInfo*> scenes = scenes_with_starts();
    EXPECT_GE(scenes.size(), 27u);
    for (const SceneInfo* info : scenes) {
        SCOPED_TRACE(info->name);
        EXPECT_GE(info->starts, 10);
        const Scene first = info->make_start(0);
        EXPECT_EQ(first.name, info->name);
        for (int start = 1; start < info->starts; ++start) {
            const Scene other = info->make_start(start);
            EXPECT_EQ(other.name, first.name);
            bool differs = other.world.gravity != first.world.gravity || other.bodies.size() != first.bodies.size() || other.world.solver != first.world.solver;
            for (std::size_t i = 0; i < first.bodies.size() && !differs; ++i) {
                const BodyDef &a = first.bodies[i].def, &b = other.bodies[i].def;
                differs = a.position != b.position || a.angle != b.angle || a.linear_velocity != b.linear_velocity || a.angular_velocity != b.angular_velocity;
            }
            // What a script pulls at is not seen here.
            if (!first.before_step) { EXPECT_TRUE(differs) << "start " << start; }
        }
        IsletEngine engine;
        engine.load(first);
        engine.advance(first, 0, first.dt);
        int rows = 0;
        for (const CheckLine& line : first.check(engine)) rows += line.wanted ? 1 : 0;
        EXPECT_GE(rows, 1) << "no line says what is wanted";
    }
}

TEST(Steady, AnEngineThatCannotBuildASceneHasNoValue) {
    const engines::EngineInfo* chipmunk = engines::find_engine("chipmunk");
    if (chipmunk == nullptr) GTEST_SKIP() << "the adapter of Chipmunk is built only where libchipmunk-dev is";
    static const SceneInfo with_bullet = {"falling",
                                          "steady",
                                          "a bullet",
                                          nullptr,
                                          [](int start) {
                                              Scene scene = falling<three_rows>(start);
                                              scene.bodies[0].def.bullet = true;
                                              return scene;
                                          },
                                          12};
    const SteadyTable table = run_steady({{&with_bullet}, {&engines::registry().front(), chipmunk}, 1, 1}, [](int, int) {});
    EXPECT_TRUE(table.rows.at(0).engines.at(0).is_known);
    EXPECT_FALSE(table.rows[0].engines.at(1).is_known);
    EXPECT_NE(table_of(table).find(" - "), std::string::npos) << table_of(table);
}

}  // namespace
