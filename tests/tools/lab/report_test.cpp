// What islet-lab prints and draws.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include <nlohmann/json.hpp>

#include "lab/lab.hpp"
#include "lab/plot.hpp"
#include "lab/report.hpp"
#include "small_problems.hpp"

namespace islet::test {
namespace {

/// A tower measured by some methods, as if it came from a scene.
lab::IslandReport tower_report() {
    lab::Island island;
    island.scene = "it's a tower";
    island.step = 12;
    island.h = 0.004;
    island.bodies = 3;
    island.contacts = 3;
    island.problem = owned(tower_case(3, 0.4, 0.1));
    lab::LabOptions options;
    options.measure.iterations = 300;
    options.measure.timing_seconds = 0;
    for (const char* name : {"pgs", "psor", "newton"}) options.methods.push_back(lab::find_method(name));
    return lab::examine(island, options, [] {});
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

TEST(LabReport, TheTableHasEveryMethodColdAndWarmAndWhatWarmSaves) {
    const std::vector<std::string> lines = lines_of(lab::table_of(tower_report()));
    ASSERT_EQ(lines.size(), 3 + 2 + 3 * 3u);
    EXPECT_NE(lines[0].find("it's a tower after step 12, island 0: 3 bodies, 3 contacts, 0 joints; 12 rows"), std::string::npos);
    EXPECT_NE(lines[2].find("exact answer"), std::string::npos);
    for (std::size_t method = 0; method < 3; ++method) {
        const std::size_t first = 5 + 3 * method;
        const char* const names[] = {"pgs", "psor 1.3", "newton"};
        EXPECT_EQ(lines[first].find(names[method]), 2u);
        EXPECT_NE(lines[first].find(" cold "), std::string::npos);
        EXPECT_NE(lines[first + 1].find(" warm "), std::string::npos);
        EXPECT_NE(lines[first + 2].find(" saves "), std::string::npos);
        EXPECT_NE(lines[first + 2].find(" 0%"), std::string::npos) << "the warm start is zero here, and saves nothing";
    }
    // What was not reached is a dash.
    lab::IslandReport report = tower_report();
    for (lab::Measurement& m : report.measurements) m.reached = {};
    for (const std::string& line : lines_of(lab::table_of(report))) {
        if (line.find(" cold ") != std::string::npos) { EXPECT_EQ(count_of(line, " -"), 9u) << line; }
    }
}

TEST(LabReport, JsonIsAListWithAnObjectForEachMethodAndStart) {
    const lab::IslandReport report = tower_report();
    const nlohmann::json list = nlohmann::json::parse(lab::json_of({report}));
    ASSERT_EQ(list.size(), 6u);
    for (std::size_t i = 0; i < list.size(); ++i) {
        const nlohmann::json& object = list[i];
        const lab::Measurement& m = report.measurements[i];
        EXPECT_EQ(object["scene"], "it's a tower");
        EXPECT_EQ(object["step"], 12);
        EXPECT_EQ(object["rows"], 12);
        EXPECT_EQ(object["reference"]["exact"], true);
        EXPECT_EQ(object["method"], m.method->name);
        EXPECT_EQ(object["start"], i % 2 == 0 ? "cold" : "warm");
        EXPECT_EQ(object["omega"].is_null(), object["method"] != "psor");
        EXPECT_EQ(object["iterations"], m.iterations);
        EXPECT_EQ(object["residual"].get<double>(), m.residual);
        ASSERT_EQ(object["levels"].size(), 3u);
        for (std::size_t level = 0; level < 3; ++level) {
            const nlohmann::json& reached = object["levels"][level];
            EXPECT_EQ(reached["residual"].get<double>(), lab::levels[level]);
            EXPECT_EQ(reached["iterations"].is_null(), !m.reached[level]);
            if (m.reached[level]) { EXPECT_EQ(reached["iterations"], m.reached[level]->iterations); }
        }
    }
}

TEST(LabReport, CsvHasALineForEachPoint) {
    const lab::IslandReport report = tower_report();
    std::size_t points = 0;
    for (const lab::Measurement& m : report.measurements) points += lab::thinned(m.history).size();
    const std::vector<std::string> lines = lines_of(lab::csv_of({report}));
    ASSERT_EQ(lines.size(), points + 1);
    EXPECT_EQ(lines[0], "scene,island,method,start,iteration,seconds,residual");
    for (const std::string& line : lines) EXPECT_EQ(count_of(line, ","), 6u) << line;
    EXPECT_EQ(lines[1].find("it's a tower,0,pgs,cold,0,"), 0u);
}

/// Whether every tag that is opened is closed, in order. Enough of XML for what gnuplot writes.
bool well_formed(const std::string& text) {
    std::vector<std::string> open;
    for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at)) {
        const bool comment = text.compare(at, 4, "<!--") == 0;
        const std::size_t end = comment ? text.find("-->", at) : text.find('>', at);
        if (end == std::string::npos) return false;
        const std::string tag = text.substr(at + 1, end - at - 1);
        at = end;
        if (comment || tag.empty() || tag[0] == '?' || tag[0] == '!') continue;
        const std::string name = tag.substr(tag[0] == '/' ? 1 : 0, tag.find_first_of(" \t\r\n/", 1) - (tag[0] == '/' ? 1 : 0));
        if (tag[0] == '/') {
            if (open.empty() || open.back() != name) return false;
            open.pop_back();
        } else if (tag.back() != '/') {
            open.push_back(name);
        }
    }
    return open.empty();
}

TEST(LabReport, ThePictureIsWellFormedAndNamesItsMethods) {
    if (!lab::can_plot()) GTEST_SKIP() << "there is no gnuplot";
    const std::string path = testing::TempDir() + "islet lab's picture.svg";
    ASSERT_TRUE(lab::run_gnuplot(lab::plot_script(tower_report(), path)));
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    const std::string svg = text.str();
    EXPECT_TRUE(well_formed(svg));
    EXPECT_FALSE(well_formed(svg.substr(0, svg.size() - 8))) << "so that this test can fail";
    for (const char* word : {"</svg>", "tower after step 12", "3 bodies", ">pgs<", ">psor 1.3<", ">newton<", "iterations", ">ms<"})
        EXPECT_NE(svg.find(word), std::string::npos) << word;
}

TEST(LabReport, ASceneIsMeasuredFromItsOwnIslands) {
    lab::LabOptions options;
    options.step = 300;
    options.measure.iterations = 400;
    options.measure.timing_seconds = 0;
    options.methods = {lab::find_method("pgs")};
    std::vector<lab::Island> islands = lab::take_islands(*samples::find_scene("mass_ratio"), options, [](int) {});
    ASSERT_EQ(islands.size(), 1u);
    EXPECT_EQ(islands[0].scene, "mass_ratio");
    EXPECT_EQ(islands[0].step, 300);
    EXPECT_NEAR(islands[0].h, 1.0 / 240, 1e-6);
    const lab::IslandReport report = lab::examine(islands[0], options, [] {});
    EXPECT_TRUE(report.reference.exact());
    EXPECT_EQ(report.measurements.size(), 2u);
    EXPECT_LT(report.warm_residual, 1);

    options.substep_h = 0.01;
    options.substeps = 8;
    options.step = 5;
    islands = lab::take_islands(*samples::find_scene("pyramid"), options, [](int) {});
    EXPECT_NEAR(islands.at(0).h, 0.01, 1e-9);
    options.all_islands = true;
    EXPECT_EQ(lab::take_islands(*samples::find_scene("mass_ratio"), options, [](int) {}).size(), 2u) << "a slab on columns, and a pyramid";
}

}  // namespace
}  // namespace islet::test
