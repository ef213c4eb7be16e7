// What the engine's sources must not contain: they have to work without a heap, exceptions, RTTI, threads and most of the C++ library.
#include <gtest/gtest.h>

#include <functional>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "support/engine_sources.hpp"

namespace {

using namespace islet::test;

bool belongs_to_lcp(const std::string& name) { return name.rfind("src/lcp/", 0) == 0 || name == "include/islet/lcp.hpp"; }

// Every line of the engine's files, or of some of them, that matches.
std::string lines_with(
    const std::regex& pattern, const std::function<bool(const std::string& name)>& wanted = [](const std::string&) { return true; }) {
    std::string found;
    for (const Source& source : engine_sources()) {
        if (!wanted(source.name)) continue;
        std::istringstream lines(source.text);
        std::string line;
        for (int number = 1; std::getline(lines, line); ++number)
            if (std::regex_search(line, pattern)) found += source.name + ':' + std::to_string(number) + ": " + line + '\n';
    }
    return found;
}

TEST(CoreRules, TheSourcesAreFound) { EXPECT_GT(engine_sources().size(), 20u); }

TEST(CoreRules, CommentsAndLiteralsAreNotCode) {
    EXPECT_EQ(code_only("a // throw\nb"), "a         \nb");
    EXPECT_EQ(code_only("a /* new X */ b").find("new"), std::string::npos);
    EXPECT_EQ(code_only("f(\"throw \\\" it\"); throw").rfind("throw"), code_only("f(\"throw \\\" it\"); throw").find("throw"));
    EXPECT_NE(code_only("1'000 + virtual").find("virtual"), std::string::npos);
    EXPECT_NE(code_only("#include \"math/scalar.hpp\"\n").find("math/scalar"), std::string::npos);
}

TEST(CoreRules, OnlyHeadersThatNeedNoRuntimeAreIncluded) {
    // Freestanding ones, <span>, the memory functions, and the compiler's own.
    const std::set<std::string> allowed = {"bit",     "cstddef",     "cstdint", "cstring",    "initializer_list", "span",    "type_traits",
                                           "utility", "immintrin.h", "cpuid.h", "arm_neon.h", "wasm_simd128.h",   "intrin.h"};
    const std::regex include(R"(^\s*#\s*include\s*<([^>]+)>)");
    std::string bad;
    for (const Source& source : engine_sources()) {
        std::istringstream lines(source.text);
        std::string line;
        std::smatch match;
        while (std::getline(lines, line))
            if (std::regex_search(line, match, include) && allowed.count(match[1]) == 0) bad += source.name + ": " + line + '\n';
    }
    EXPECT_EQ(bad, "");
}

TEST(CoreRules, NoExceptionsNoRttiNoVirtualCalls) { EXPECT_EQ(lines_with(std::regex(R"(\b(throw|try|catch|virtual|dynamic_cast|typeid)\b)")), ""); }

TEST(CoreRules, NoHeap) {
    EXPECT_EQ(lines_with(std::regex(R"(\b(malloc|calloc|realloc|free|aligned_alloc|alloca|unique_ptr|shared_ptr)\s*[(<])")), "");
    // Placement new is the only one: the address comes first.
    EXPECT_EQ(lines_with(std::regex(R"(\bnew\s+[A-Za-z_:])")), "");
    EXPECT_EQ(lines_with(std::regex(R"(\bdelete\b(?!\s*;))")), "") << "only deleted functions may say delete";
}

TEST(CoreRules, NoThreadsNoClockNoOutput) {
    EXPECT_EQ(lines_with(std::regex(R"(\b(thread_local|mutex|printf|fopen|getenv|std::c(out|err)|chrono|clock_gettime|rand)\b)")), "");
}

TEST(CoreRules, NoDoublePrecision) {
    // The matrix solvers come in both precisions, and nothing of the engine includes them.
    EXPECT_EQ(lines_with(std::regex(R"(\bdouble\b)"), [](const std::string& name) { return !belongs_to_lcp(name); }), "") << "a Cortex-M has no unit for it";
}

// The solvers of plain matrices know nothing of bodies, nor of anything else of the engine. The engine uses none of them; the form in which they take a
// problem is known to the export of islands alone, whose header no other includes.
TEST(CoreRules, TheMatrixSolversAndTheEngineDoNotKnowEachOther) {
    const auto exports = [](const std::string& name) { return name == "include/islet/island.hpp" || name.rfind("src/export/island_", 0) == 0; };
    const std::regex own(
        R"re(^\s*#\s*include\s*["<](?!\.\./lcp/|\.\./exact\.hpp|islet/lcp\.hpp|islet/islet_lcp\.h|islet/compiler\.hpp|islet/span\.hpp|islet/version\.hpp|islet/visibility\.hpp)[a-z0-9_.]+[/.])re");
    const std::regex theirs(R"re(^\s*#\s*include\s*["<](\.\./lcp/|islet/lcp\.hpp|islet/island\.hpp|\.\./export/island_))re");
    const std::regex solvers(R"re(^\s*#\s*include\s*["<]\.\./lcp/)re");
    EXPECT_EQ(lines_with(own, belongs_to_lcp), "");
    EXPECT_EQ(lines_with(theirs, [&](const std::string& name) { return !belongs_to_lcp(name) && !exports(name); }), "");
    EXPECT_EQ(lines_with(solvers, exports), "");
    EXPECT_EQ(lines_with(std::regex(R"(lcp::(solve|residuals|describe|workspace))"), exports), "");
    EXPECT_NE(lines_with(theirs, belongs_to_lcp), "") << "the folder or its headers are called otherwise now";
    EXPECT_NE(lines_with(theirs, exports), "") << "the export's files are called otherwise now";
}

// What the same bits need of the compiler holds for all that comes after it.
TEST(CoreRules, EveryFileBeginsWithWhatTheBitsNeed) {
    const std::regex include(R"re(^\s*#\s*include\s*["<]([^">]+)[">])re");
    std::string bad;
    for (const Source& source : engine_sources()) {
        if (std::filesystem::path(source.name).extension() != ".cpp") continue;
        std::istringstream lines(source.text);
        std::string line;
        std::smatch match;
        while (std::getline(lines, line) && !std::regex_search(line, match, include)) {}
        if (match.empty() || match[1] != "../exact.hpp") bad += source.name + ": " + line + '\n';
    }
    EXPECT_EQ(bad, "");
}

// A compiler other than GCC and Clang has to learn one header. (The others ask first who compiles, or for vectors, which only these two have.)
TEST(CoreRules, WhatOnlySomeCompilersUnderstandIsInOneHeader) {
    const std::set<std::string> asking = {"include/islet/compiler.hpp", "include/islet/visibility.hpp", "src/data/features.hpp", "src/math/avx2.hpp",
                                          "src/math/avx512.hpp",        "src/math/checksum.hpp",        "src/math/lanes.hpp"};
    const std::regex own(R"(__attribute__|\bgnu::|__builtin_(?!bit_cast|launder|huge_val|nanf|shufflevector)|__(BYTE_ORDER|FLT|DBL)_)");
    EXPECT_EQ(lines_with(own, [&](const std::string& name) { return asking.count(name) == 0 && name != "src/exact.hpp"; }), "");
    EXPECT_NE(lines_with(own, [&](const std::string& name) { return name == "include/islet/compiler.hpp"; }), "");
}

// What the formatter does not break, such as comments.
TEST(CoreRules, NoLineIsLongerThanTheFormatHasIt) {
    std::ifstream format(engine_folder() / ".." / ".clang-format");
    const std::string text{std::istreambuf_iterator<char>(format), {}};
    const std::size_t place = text.find("ColumnLimit: ");
    ASSERT_NE(place, std::string::npos);
    const std::size_t most = std::stoul(text.substr(place + 13));
    std::string bad;
    for (const Source& source : engine_sources()) {
        std::istringstream lines(source.text);
        std::string line;
        for (int number = 1; std::getline(lines, line); ++number)
            if (line.size() > most) bad += source.name + ':' + std::to_string(number) + '\n';
    }
    EXPECT_EQ(bad, "");
}

// Without CMake nothing says -I engine/src.
TEST(CoreRules, FilesOfTheEngineAreIncludedByWhereTheyLie) {
    const auto is_source = [](const std::string& name) { return name.rfind("src/", 0) == 0; };
    EXPECT_EQ(lines_with(std::regex(R"re(^\s*#\s*include\s*"(?!\.\./|islet/))re"), is_source), "");
}

}  // namespace
