// What the engine's sources must not contain: they have to work without a heap, exceptions, RTTI, threads and most of the C++ library.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <functional>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

fs::path engine_folder() { return fs::path(__FILE__).parent_path() / ".." / ".." / "engine"; }

struct Source {
    std::string name;
    std::string text;  // without comments and string literals
};

// Comments and literals become blanks; lines stay where they are, and so do those that include a header.
std::string code_only(const std::string& text) {
    std::string out = text;
    enum class In { code, include, line, block, string, character } in = In::code;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        const char next = i + 1 < text.size() ? text[i + 1] : '\0';
        if (in == In::code) {
            const bool digit_separator = i > 0 && std::isxdigit(static_cast<unsigned char>(text[i - 1])) != 0;
            if (text.compare(i, 8, "#include") == 0) in = In::include;
            if (c == '/' && next == '/') in = In::line;
            if (c == '/' && next == '*') in = In::block;
            if (c == '"') in = In::string;
            if (c == '\'' && !digit_separator) in = In::character;
            if (in == In::line || in == In::block) out[i] = ' ';
            continue;
        }
        if (c == '\n' && (in == In::line || in == In::include)) in = In::code;
        if (in == In::include || c == '\n') continue;
        out[i] = ' ';
        if (in == In::block && c == '/' && text[i - 1] == '*') in = In::code;
        if ((in == In::string || in == In::character) && c == '\\') {
            out[++i] = ' ';
        } else if ((in == In::string && c == '"') || (in == In::character && c == '\'')) {
            in = In::code;
        }
    }
    return out;
}

std::vector<Source> read_sources() {
    std::vector<Source> sources;
    for (const char* folder : {"include", "src"}) {
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(engine_folder() / folder)) {
            if (entry.path().extension() != ".hpp" && entry.path().extension() != ".cpp") continue;
            std::ifstream file(entry.path());
            std::stringstream text;
            text << file.rdbuf();
            sources.push_back({fs::relative(entry.path(), engine_folder()).generic_string(), code_only(text.str())});
        }
    }
    return sources;
}

const std::vector<Source>& engine_sources() {
    static const std::vector<Source> sources = read_sources();
    return sources;
}

bool belongs_to_lcp(const std::string& name) { return name.rfind("src/lcp/", 0) == 0 || name == "include/islet/lcp.hpp"; }

// Every line of the engine's files, or of some of them, that matches.
std::string lines_with(const std::regex& pattern, const std::function<bool(const std::string& name)>& wanted = [](const std::string&) { return true; }) {
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
    const std::set<std::string> allowed = {"bit",         "cstddef", "cstdint",    "cstring",       "span",
                                           "immintrin.h", "cpuid.h", "arm_neon.h", "wasm_simd128.h"};
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

TEST(CoreRules, NoExceptionsNoRttiNoVirtualCalls) {
    EXPECT_EQ(lines_with(std::regex(R"(\b(throw|try|catch|virtual|dynamic_cast|typeid)\b)")), "");
}

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
    EXPECT_EQ(lines_with(std::regex(R"(\bdouble\b)"), [](const std::string& name) { return !belongs_to_lcp(name); }), "")
        << "a Cortex-M has no unit for it";
}

// The solvers of plain matrices know nothing of bodies, nor of anything else of the engine. The engine uses none of them; the form in which they take a
// problem is known to the export of islands alone, whose header no other includes.
TEST(CoreRules, TheMatrixSolversAndTheEngineDoNotKnowEachOther) {
    const auto exports = [](const std::string& name) { return name == "include/islet/island.hpp" || name.rfind("src/export/island_", 0) == 0; };
    const std::regex own(R"re(^\s*#\s*include\s*["<](?!\.\./lcp/|\.\./exact\.hpp|islet/lcp\.hpp)[a-z0-9_.]+[/.])re");
    const std::regex theirs(R"re(^\s*#\s*include\s*["<](\.\./lcp/|islet/lcp\.hpp|islet/island\.hpp|\.\./export/island_))re");
    const std::regex solvers(R"re(^\s*#\s*include\s*["<]\.\./lcp/)re");
    EXPECT_EQ(lines_with(own, belongs_to_lcp), "");
    EXPECT_EQ(lines_with(theirs, [&](const std::string& name) { return !belongs_to_lcp(name) && !exports(name); }), "");
    EXPECT_EQ(lines_with(solvers, exports), "");
    EXPECT_EQ(lines_with(std::regex(R"(lcp::(solve|residuals|describe|workspace))"), exports), "");
    EXPECT_NE(lines_with(theirs, belongs_to_lcp), "") << "the folder or its headers are called otherwise now";
    EXPECT_NE(lines_with(theirs, exports), "") << "the export's files are called otherwise now";
}

TEST(CoreRules, FoldersIncludeOnlyFoldersBelowThem) {
    const std::vector<std::string> order = {"math", "memory", "data", "calls", "geometry", "collide", "graph", "broadphase", "lcp", "constraint",
        "island", "solver", "bodies", "step", "world", "state", "query", "mover", "draw", "export"};
    const auto rank = [&](const std::string& folder) { return std::find(order.begin(), order.end(), folder) - order.begin(); };
    const std::regex include(R"re(^\s*#\s*include\s*"(?:\.\./)?([a-z]+)/)re");
    std::string bad;
    for (const Source& source : engine_sources()) {
        if (source.name.rfind("src/", 0) != 0) continue;
        const std::string folder = source.name.substr(4, source.name.find('/', 4) - 4);
        std::istringstream lines(source.text);
        std::string line;
        std::smatch match;
        while (std::getline(lines, line))
            if (std::regex_search(line, match, include) && match[1] != "islet" && rank(match[1]) > rank(folder))
                bad += source.name + ": " + line + '\n';
    }
    EXPECT_EQ(bad, "");
}

// Compiled by hand, objects of one name would overwrite each other.
TEST(CoreRules, NoTwoFilesMakeObjectsOfOneName) {
    std::set<std::string> names;
    for (const Source& source : engine_sources()) {
        const fs::path path = source.name;
        if (path.extension() == ".cpp" && !names.insert(path.stem().string()).second) ADD_FAILURE() << source.name;
    }
}

// What the same bits need of the compiler holds for all that comes after it.
TEST(CoreRules, EveryFileBeginsWithWhatTheBitsNeed) {
    const std::regex include(R"re(^\s*#\s*include\s*["<]([^">]+)[">])re");
    std::string bad;
    for (const Source& source : engine_sources()) {
        if (fs::path(source.name).extension() != ".cpp") continue;
        std::istringstream lines(source.text);
        std::string line;
        std::smatch match;
        while (std::getline(lines, line) && !std::regex_search(line, match, include)) {}
        if (match.empty() || match[1] != "../exact.hpp") bad += source.name + ": " + line + '\n';
    }
    EXPECT_EQ(bad, "");
}

// Without CMake nothing says -I engine/src.
TEST(CoreRules, FilesOfTheEngineAreIncludedByWhereTheyLie) {
    const auto is_source = [](const std::string& name) { return name.rfind("src/", 0) == 0; };
    EXPECT_EQ(lines_with(std::regex(R"re(^\s*#\s*include\s*"(?!\.\./|islet/))re"), is_source), "");
}

}  // namespace
