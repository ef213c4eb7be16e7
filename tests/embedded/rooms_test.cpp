// The rooms of engine/src, one folder each, which its README lists in the order data flows: who may include whom, how large a room is, and what files are
// called.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "support/engine_sources.hpp"

namespace {

using namespace islet::test;

using Names = std::vector<std::string>;

/// The first cell of each row of the table.
Names listed_rooms() {
    std::ifstream file(engine_folder() / "src" / "README.md");
    Names rooms;
    for (std::string line; std::getline(file, line);)
        if (line.rfind("| `", 0) == 0) rooms.push_back(line.substr(3, line.find('`', 3) - 3));
    return rooms;
}

/// A file of src by its room and name.
struct File {
    std::string room, name;
    const std::string* text;
};

std::vector<File> files_in_rooms(const std::vector<Source>& sources) {
    std::vector<File> files;
    for (const Source& source : sources) {
        const std::size_t slash = source.name.find('/', 4);
        if (source.name.rfind("src/", 0) == 0 && slash != std::string::npos) files.push_back({source.name.substr(4, slash - 4), source.name.substr(slash + 1), &source.text});
    }
    return files;
}

struct Include {
    std::string from_room, from, to_room, to;
};

/// What files of src include of each other.
std::vector<Include> includes_between(const std::vector<Source>& sources) {
    std::vector<Include> includes;
    const std::string start = "#include \"../";
    for (const File& file : files_in_rooms(sources)) {
        std::istringstream lines(*file.text);
        for (std::string line; std::getline(lines, line);) {
            if (line.rfind(start, 0) != 0) continue;
            const std::string path = line.substr(start.size(), line.rfind('"') - start.size());
            const std::size_t slash = path.find('/');
            if (slash != std::string::npos) includes.push_back({file.room, file.name, path.substr(0, slash), path.substr(slash + 1)});
        }
    }
    return includes;
}

/// Includes of rooms that come later in the list, or that it does not have.
std::string upward(const std::vector<Source>& sources, const Names& rooms) {
    const auto place = [&](const std::string& room) { return std::find(rooms.begin(), rooms.end(), room) - rooms.begin(); };
    std::string bad;
    for (const Include& i : includes_between(sources))
        if (i.to_room != i.from_room && place(i.to_room) >= place(i.from_room)) bad += i.from_room + '/' + i.from + " includes " + i.to_room + '/' + i.to + '\n';
    return bad;
}

using Edges = std::set<std::pair<std::string, std::string>>;

/// Nodes on a circle, or on a way from one to another: what stays when, again and again, nodes that nobody leads to or that lead to nobody are taken away.
std::string circles(Edges edges) {
    for (std::size_t before = 0; before != edges.size();) {
        before = edges.size();
        std::set<std::string> from, to;
        for (const auto& [a, b] : edges) from.insert(a), to.insert(b);
        for (auto edge = edges.begin(); edge != edges.end();) edge = to.count(edge->first) == 0 || from.count(edge->second) == 0 ? edges.erase(edge) : std::next(edge);
    }
    std::string bad;
    for (const auto& [a, b] : edges) bad += a + " -> " + b + '\n';
    return bad;
}

std::string circles_of_rooms(const std::vector<Source>& sources) {
    Edges edges;
    for (const Include& i : includes_between(sources))
        if (i.from_room != i.to_room) edges.insert({i.from_room, i.to_room});
    return circles(edges);
}

std::string circles_of_files(const std::vector<Source>& sources) {
    Edges edges;
    for (const Include& i : includes_between(sources)) edges.insert({i.from_room + '/' + i.from, i.to_room + '/' + i.to});
    return circles(edges);
}

/// Rooms of more than 25 files, or of more than a fifth of the lines.
std::string too_large(const std::vector<Source>& sources) {
    std::map<std::string, std::pair<long, long>> sizes;
    long all = 0;
    for (const File& file : files_in_rooms(sources)) {
        const long lines = std::count(file.text->begin(), file.text->end(), '\n');
        ++sizes[file.room].first;
        sizes[file.room].second += lines;
        all += lines;
    }
    std::string bad;
    for (const auto& [room, size] : sizes)
        if (size.first > 25 || 5 * size.second > all) bad += room + ": " + std::to_string(size.first) + " files, " + std::to_string(size.second) + " lines\n";
    return bad;
}

/// Names that stand in two rooms. (Compiled by hand, their objects would overwrite each other.)
std::string repeated_names(const std::vector<Source>& sources) {
    std::map<std::string, std::set<std::string>> rooms_of;
    for (const File& file : files_in_rooms(sources)) rooms_of[std::filesystem::path(file.name).stem().string()].insert(file.room);
    std::string bad;
    for (const auto& [name, rooms] : rooms_of) {
        if (rooms.size() < 2) continue;
        bad += name + ':';
        for (const std::string& room : rooms) bad += ' ' + room;
        bad += '\n';
    }
    return bad;
}

/// Functions that are declared in a header of one room and defined in files of others only. They are known by name; members, and what is in namespaces without
/// a name, are left out.
std::string defined_elsewhere(const std::vector<Source>& sources) {
    std::map<std::string, std::set<std::string>> declared, defined;
    for (const File& file : files_in_rooms(sources)) {
        const std::string& text = *file.text;
        int depth = 0;     // of braces
        int unnamed = -1;  // the depth at which a namespace without a name began
        for (std::size_t at = 0, next = 0; at < text.size(); at = next) {
            // What begins at the left edge, with the lines that continue it.
            next = at;
            do next = std::min(text.find('\n', next), text.size() - 1) + 1;
            while (next < text.size() && (text[next] == ' ' || text[next] == '\t'));
            if (text.compare(at, 11, "namespace {") == 0) unnamed = depth;
            depth += static_cast<int>(std::count(&text[at], &text[next], '{') - std::count(&text[at], &text[next], '}'));
            if (unnamed >= 0 && depth > unnamed) continue;
            unnamed = -1;
            const std::size_t end = text.find_first_of(";{", at);
            const std::size_t open = text.find('(', at);
            if (end >= next || open >= end || text[at] == '#' || text[at] == ' ' || text.substr(at, end - at).find('=') != std::string::npos) continue;
            std::size_t first = open;
            while (first > at && (std::isalnum(static_cast<unsigned char>(text[first - 1])) != 0 || text[first - 1] == '_' || text[first - 1] == ':')) --first;
            const std::string name = text.substr(first, open - first);
            if (first == at || name.empty() || name.find(':') != std::string::npos) continue;
            if (text[end] == '{') {
                defined[name].insert(file.room);
            } else if (std::filesystem::path(file.name).extension() == ".hpp") {
                declared[name].insert(file.room);
            }
        }
    }
    std::string bad;
    for (const auto& [name, rooms] : declared)
        for (const std::string& room : rooms)
            if (defined.count(name) != 0 && defined[name].count(room) == 0) bad += name + ", declared in " + room + ", is defined in " + *defined[name].begin() + '\n';
    return bad;
}

TEST(Rooms, TheListHasEveryRoom) {
    Names listed = listed_rooms();
    std::sort(listed.begin(), listed.end());
    std::set<std::string> there;
    for (const File& file : files_in_rooms(engine_sources())) there.insert(file.room);
    EXPECT_EQ(listed, Names(there.begin(), there.end()));
}

TEST(Rooms, ARoomIncludesOnlyItselfAndRoomsBeforeIt) { EXPECT_EQ(upward(engine_sources(), listed_rooms()), ""); }

TEST(Rooms, NoRoomsIncludeEachOtherInACircle) {
    EXPECT_EQ(circles_of_rooms(engine_sources()), "");
    EXPECT_EQ(circles_of_files(engine_sources()), "");
}

TEST(Rooms, NoRoomIsTooLarge) { EXPECT_EQ(too_large(engine_sources()), ""); }

TEST(Rooms, NoNameStandsInTwoRooms) { EXPECT_EQ(repeated_names(engine_sources()), ""); }

TEST(Rooms, WhatAHeaderDeclaresIsDefinedInItsRoom) { EXPECT_EQ(defined_elsewhere(engine_sources()), ""); }

// Each rule is broken once, beside the sources as they are.
TEST(Rooms, PlantedFaultsAreFound) {
    const auto with = [](std::vector<Source> planted) {
        planted.insert(planted.end(), engine_sources().begin(), engine_sources().end());
        return planted;
    };
    EXPECT_NE(upward(with({{"src/math/planted.cpp", "#include \"../exact.hpp\"\n#include \"../world/shapes.hpp\"\n"}}), listed_rooms()), "");
    EXPECT_NE(upward(with({{"src/math/planted.cpp", "#include \"../cellar/planted.hpp\"\n"}}), listed_rooms()), "");
    EXPECT_NE(circles_of_rooms(with({{"src/math/planted.cpp", "#include \"../world/shapes.hpp\"\n"}})), "");
    EXPECT_NE(circles_of_files(with({{"src/math/one.hpp", "#include \"../math/two.hpp\"\n"}, {"src/math/two.hpp", "#include \"../math/one.hpp\"\n"}})), "");
    EXPECT_NE(too_large(with(std::vector<Source>(26, {"src/cellar/planted.hpp", ""}))), "");
    EXPECT_NE(too_large(with({{"src/cellar/planted.hpp", std::string(10'000, '\n')}})), "");
    EXPECT_NE(repeated_names(with({{"src/math/shapes.hpp", ""}})), "");
    EXPECT_NE(defined_elsewhere(with({{"src/math/planted.hpp", "\nvoid planted(int a,\n             int b);\n"}, {"src/world/planted.cpp", "\nvoid planted(int a, int b) {\n}\n"}})), "");
}

}  // namespace
