// What a build leaves out comes to the same as what the whole engine does not use: a world of without.cpp has one hash in both.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <islet/config.hpp>

namespace {

const std::string programs = std::string(ISLET_PROGRAMS) + "/";

// The first line that a program prints.
std::string run(const std::string& program, const std::string& arguments) {
    const std::string command = programs + program + " " + arguments;
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(command.c_str(), "r"), pclose);
    char line[256] = "";
    if (!pipe || std::fgets(line, sizeof line, pipe.get()) == nullptr) return "nothing printed by " + command;
    return line;
}

// All names, and those of which this build has an engine without.
std::vector<std::string> features() {
    std::vector<std::string> names = {"joints"};
#define ISLET_NAME(name, ...) names.emplace_back(#name);
    ISLET_FEATURES(ISLET_NAME)
#undef ISLET_NAME
    return names;
}
std::vector<std::string> switched() {
    std::istringstream given(ISLET_SWITCHED);
    std::vector<std::string> names;
    for (std::string name; std::getline(given, name, ',');) names.push_back(name);
    return names;
}

class Pairs : public testing::TestWithParam<std::string> {};

TEST_P(Pairs, LeftOutAndSwitchedOffAreOneHash) { EXPECT_EQ(run("islet_without_" + GetParam(), GetParam()), run("islet_with_all", GetParam())); }

INSTANTIATE_TEST_SUITE_P(Each, Pairs, testing::ValuesIn(switched()), [](const auto& each) { return each.param; });

TEST(PairsOfAll, LeftOutAndNotUsedAreOneHash) {
    std::string names;
    for (const std::string& name : features()) names += name + " ";
    EXPECT_EQ(run("islet_without_all", names), run("islet_with_all", names));
}

// Without shortcuts, a crowd of which few move is sorted whole.
TEST(PairsOfAll, ACrowdSortedInPartHasTheHashOfOneSortedWhole) {
    const std::string whole = run("islet_with_all", "--crowd");
    EXPECT_NE(whole.find("No error."), std::string::npos) << whole;
    EXPECT_EQ(run("islet_without_shortcuts", "--crowd"), whole);
}

// An engine with lanes takes a short way where two bodies are clearly apart. That of one lane makes each manifold.
TEST(PairsOfAll, BodiesThatPartHaveOneHashWithAndWithoutLanes) {
    const std::string whole = run("islet_with_all", "--apart");
    EXPECT_NE(whole.find("No error."), std::string::npos) << whole;
    EXPECT_EQ(run("islet_without_shortcuts", "--apart"), whole);
}

// What the small profile leaves out. The engine of these tests puts back hinges, sliders and rods.
std::vector<std::string> cut_from_small() {
    constexpr bool small = false, hinges = false, full = true;
    std::vector<std::string> names;
#define ISLET_NAME(name, needs, profile) \
    if (profile) names.emplace_back(#name);
    ISLET_FEATURES(ISLET_NAME)
#undef ISLET_NAME
#define ISLET_NAME(type, definition) names.emplace_back(#type "_joints");
    ISLET_JOINT_TYPES(ISLET_NAME)
#undef ISLET_NAME
    for (const char* name : {"revolute_joints", "prismatic_joints", "distance_joints"}) names.erase(std::find(names.begin(), names.end(), name));
    return names;
}

std::string listed(const std::vector<std::string>& names, const std::string& but = {}) {
    std::string list;
    for (const std::string& name : names) list += name == but ? "" : name + " ";
    return list;
}

TEST(SmallProfile, GivesTheWholeEnginesBits) {
    const std::string names = listed(cut_from_small());
    const std::string whole = run("islet_with_all", names);
    EXPECT_EQ(run("islet_without_small", names), whole);
    EXPECT_NE(run("islet_with_all", names + "joints"), whole) << "joints that are put back are used";
}

std::string bytes_of(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

// The small profile's worlds have contacts with 16-bit indices, those of the whole engine 32-bit ones: their images are the same bytes.
TEST(SmallProfile, ImagesGoFromEachToTheOther) {
    const std::string of_whole = testing::TempDir() + "islet_whole.image", of_small = testing::TempDir() + "islet_small.image";
    const std::string save = "--save " + listed(cut_from_small());
    const std::string end = run("islet_with_all", save + of_whole);
    EXPECT_NE(end.find("No error."), std::string::npos) << end;
    EXPECT_EQ(run("islet_without_small", save + of_small), end);
    EXPECT_GT(bytes_of(of_whole).size(), 10000u);
    EXPECT_TRUE(bytes_of(of_small) == bytes_of(of_whole));
    EXPECT_EQ(run("islet_without_small", "--load " + of_whole), end);
    EXPECT_EQ(run("islet_with_all", "--load " + of_small), end);
}

TEST(SmallProfile, RefusesWhatItLeavesOut) {
    const std::vector<std::string> cut = cut_from_small();
    EXPECT_GT(cut.size(), 20u);
    for (const std::string& name : cut) {
        if (name == "shortcuts" || name == "exact_angles") continue;  // no call asks for these
        if (name == "bullets") continue;                              // nor for this without continuous collision
        const std::string printed = run("islet_without_small", listed(cut, name));
        EXPECT_NE(printed.find("lacks a part"), std::string::npos) << name << ": " << printed;
    }
}

// The world of these tests uses what it is said to use. (Three features change no world, whoever uses them.)
TEST(PairsOfAll, WhatIsNotUsedMakesADifference) {
    const std::string whole = run("islet_with_all", "");
    for (const std::string& name : features()) {
        if (name == "recorder" || name == "profile" || name == "shortcuts") continue;
        EXPECT_NE(run("islet_with_all", name), whole) << name;
    }
}

// A world in which continuous collision, sleep or seamless floors are switched off later goes on alike in an engine that has none, which loads its snapshot.
// (Hooks are in none.)
TEST(PairsLater, SwitchedOffAndLeftOutAreOneHash) {
    for (const std::string name : {"continuous", "sleep", "seamless_floors"}) {
        const std::string image = testing::TempDir() + "islet_without_" + name + ".image";
        const std::string whole = run("islet_with_all", "--switch bullets hooks " + name + " " + image);  // writes the image
        EXPECT_EQ(run("islet_without_" + name, "--load " + image), whole) << name;
    }
}

}  // namespace
