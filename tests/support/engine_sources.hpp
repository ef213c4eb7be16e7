// The engine's sources as text, for tests of what may stand in them.
#pragma once

#include <cctype>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace islet::test {

namespace fs = std::filesystem;

inline fs::path engine_folder() { return fs::path(__FILE__).parent_path() / ".." / ".." / "engine"; }

struct Source {
    std::string name;  // from engine/ on, as src/math/trig.cpp
    std::string text;  // without comments and string literals
};

// Comments and literals become blanks; lines stay where they are, and so do those that include a header.
inline std::string code_only(const std::string& text) {
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

inline std::vector<Source> read_sources() {
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

/// All files of include and src.
inline const std::vector<Source>& engine_sources() {
    static const std::vector<Source> sources = read_sources();
    return sources;
}

}  // namespace islet::test
