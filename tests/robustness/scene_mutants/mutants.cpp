// scene_mutants [--from SEED] [--count N]: damages scene files, in their bytes and in their structure, and has each read, loaded and stepped. A mutant is
// refused with a sentence that begins with its place, or is a scene that steps, stays sound, and is the same when it is written and read back. Neither takes
// longer than a minute or more memory than its length allows. The first mutant that breaks this is printed, made shorter; exit status 1.
#include <algorithm>
#include <cctype>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iterator>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include <malloc.h>
#include <unistd.h>

#include "scene_files/printable.hpp"
#include "harness/engine.hpp"
#include "islet/runner.hpp"
#include "scene_files/scene_file.hpp"
#include "islet/svg.hpp"
#include "scenes/catalogue.hpp"
#include "support/random.hpp"

// -- what is allocated ---------------------------------------------------------------------------------------------------------------------------------

namespace {

std::size_t held = 0, most_held = 0;

void* counted(void* memory) {
    if (memory == nullptr) throw std::bad_alloc();
    held += malloc_usable_size(memory);
    most_held = std::max(most_held, held);
    return memory;
}
void released(void* memory) {
    if (memory != nullptr) held -= malloc_usable_size(memory);
    std::free(memory);
}

}  // namespace

void* operator new(std::size_t size) { return counted(std::malloc(std::max<std::size_t>(size, 1))); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    void* const memory = std::malloc(std::max<std::size_t>(size, 1));
    return memory != nullptr ? counted(memory) : nullptr;
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    const auto a = static_cast<std::size_t>(alignment);
    return counted(std::aligned_alloc(a, (size + a - 1) / a * a));
}
void operator delete(void* memory) noexcept { released(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { released(memory); }
void operator delete(void* memory, std::size_t) noexcept { released(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { released(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { released(memory); }

namespace islet::tools {
namespace {

using test::Random;

// -- mutants -----------------------------------------------------------------------------------------------------------------------------------------

/// Every kind of field, shape and joint, and what a list may hold.
const char* const everything = R"({"name": "all", "steps": 4, "dt": 0.0166, "view": [-5, -1, 5, 5], "traced": [1], "extra_contacts": 3,
"world": {"gravity": [0, -9], "solver": {"schedule": "soft", "substeps": 2, "iterations": 1, "sweep_order": "upward", "shock": 0.2, "joint_trees": "all",
 "block_contacts": true}, "max_speed": 400, "continuous": true},
"bodies": [{"shapes": [{"box": [5, 0.5], "friction": 0.8}, {"chain": {"points": [[-5, 4], [-5, 0], [5, 0], [5, 4]], "loop": false}}], "position": [0, -0.5]},
 {"type": "dynamic", "position": [0, 1], "angle": 0.3, "shapes": [{"circle": {"center": [0, 0.1], "radius": 0.5}, "density": 2, "filter": {"mask": 7, "group": -1}}]},
 {"type": "dynamic", "position": [1, 1], "shapes": [{"capsule": {"point1": [0, 0], "point2": [0.5, 0], "radius": 0.2}, "restitution": 0.5}], "bullet": true},
 {"type": "kinematic", "position": [3, 1], "linear_velocity": [0.1, 0], "shapes": [{"segment": {"point1": [0, 0], "point2": [1, 0]}, "sensor": true}]},
 {"type": "dynamic", "position": [-1, 2], "shapes": [{"polygon": {"points": [[0, 0], [1, 0], [0, 1]], "radius": 0.05}, "hit_events": true}], "user_data": 7}],
"joints": [{"type": "revolute", "body_a": 0, "body_b": 1, "frame_a": {"position": [0, 1.5]}, "limit": {"enable": true, "lower": -1, "upper": 1}, "motor": {"enable": true,
 "speed": 2, "max_force": 5}}, {"type": "prismatic", "body_a": 0, "body_b": 2, "spring": {"enable": true, "hertz": 2, "damping_ratio": 0.5}},
 {"type": "distance", "body_a": 1, "body_b": 2, "length": 1}, {"type": "weld", "body_a": 2, "body_b": 4}, {"type": "wheel", "body_a": 1, "body_b": 4},
 {"type": "motor", "body_a": 0, "body_b": 4, "max_force": 3}, {"type": "mouse", "body": 1, "target": [1, 1], "max_force": 9},
 {"type": "pulley", "body_a": 1, "body_b": 2, "ground_a": [0, 5], "ground_b": [1, 5], "ratio": 2}, {"type": "gear", "joint1": 0, "joint2": 1, "ratio": 3}]})";

std::vector<std::string> originals() {
    std::vector<std::string> texts = {everything, everything, everything, "{}"};
    for (const SceneInfo& info : catalogue()) {
        Scene scene = info.make();
        scene.steps = 3;
        if (has_script(scene) || scene.bodies.size() > 12) continue;
        texts.push_back(write_scene(scene));
    }
    return texts;
}

/// The text from `begin` to the end of the value that begins there: a word, a number, a list or an object.
std::size_t end_of_value(const std::string& text, std::size_t begin) {
    int depth = 0;
    for (std::size_t i = begin; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '"') {
            i = text.find('"', i + 1);
            if (i == std::string::npos) return text.size();
            if (depth == 0) return i + 1;
        }
        if (c == '[' || c == '{') ++depth;
        if ((c == ']' || c == '}' || c == ',') && depth == 0) return i;
        if ((c == ']' || c == '}') && --depth == 0) return i + 1;
    }
    return text.size();
}

/// The places at which values begin: after a colon, a comma within a list, or a bracket.
std::vector<std::size_t> values_in(const std::string& text) {
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i + 1 < text.size(); ++i) {
        if (text[i] != ':' && text[i] != '[' && text[i] != ',') continue;
        const std::size_t begin = text.find_first_not_of(" \n", i + 1);
        if (begin == std::string::npos || text[begin] == ']') continue;
        const std::size_t end = end_of_value(text, begin);
        if (end >= text.size() || text[end] != ':') places.push_back(begin);  // else it is a name
    }
    return places;
}

const char* const strange_values[] = {"0",
                                      "-0",
                                      "1",
                                      "-1",
                                      "2",
                                      "1e-45",
                                      "1e-38",
                                      "-1e-30",
                                      "1e38",
                                      "-1e38",
                                      "3.4028235e38",
                                      "3.5e38",
                                      "1e308",
                                      "1e999",
                                      "1e7",
                                      "1e-7",
                                      "65536",
                                      "2147483648",
                                      "4294967295",
                                      "4294967296",
                                      "9223372036854775807",
                                      "18446744073709551615",
                                      "18446744073709551616",
                                      "-9223372036854775809",
                                      "0.5",
                                      "3.14159265",
                                      "null",
                                      "true",
                                      "false",
                                      "\"\"",
                                      "\"\\uffff\"",
                                      "\"\\ud800\"",
                                      "\"\\u0000\"",
                                      "\"dynamic\"",
                                      "\"static\"",
                                      "\"gear\"",
                                      "[]",
                                      "{}",
                                      "[0]",
                                      "[0, 0]",
                                      "[0, 0, 0]",
                                      "[1e38, -1e38]",
                                      "[[0, 0], [0, 0], [0, 0]]",
                                      "[0, 0, 1, 1]",
                                      "{\"\": 0}",
                                      "01",
                                      "1.",
                                      "NaN",
                                      "Infinity",
                                      "-"};

const char* const names[] = {"type",  "shapes", "circle", "box",    "polygon", "chain",   "bodies", "joints", "friction",
                             "world", "solver", "limit",  "spring", "points",  "normals", "radius", "traced", "steps"};

/// One that may stand where `old` does, as a rule: most others are refused by their type.
std::string strange_value_for(const std::string& old, Random& random) {
    const auto any = [&] { return std::string(strange_values[random.below(std::size(strange_values))]); };
    const auto number = [&] {
        std::string value = any();
        while (std::isdigit(static_cast<unsigned char>(value.back())) == 0 || value == "01" || value == "1e999") value = any();
        return value;
    };
    if (old.empty() || random.one_in(8)) return any();
    if (old[0] == '-' || std::isdigit(static_cast<unsigned char>(old[0])) != 0) return number();
    if (old == "true" || old == "false") return old == "true" ? "false" : "true";
    if (old[0] == '[' && old.find_first_of("[{\"", 1) == std::string::npos && std::count(old.begin(), old.end(), ',') == 1)
        return "[" + number() + ", " + number() + "]";
    return any();
}

void mutate_bytes(std::string& text, Random& random) {
    if (text.empty()) return;
    const auto place = [&] { return random.below(static_cast<std::uint32_t>(text.size())); };
    const std::size_t at = place(), length = std::min<std::size_t>(random.below(40), text.size() - at);
    switch (random.below(6)) {
    case 0: text[at] = static_cast<char>(random.below(256)); break;
    case 1: text[at] = "{}[]\",:-+.eE0123456789 \n\\/utrfn"[random.below(32)]; break;
    case 2: text.erase(at, length); break;
    case 3: text.insert(place(), text.substr(at, length)); break;
    case 4: text.resize(at); break;
    default: text.insert(at, 1, static_cast<char>(random.below(256))); break;
    }
}

void mutate_structure(std::string& text, Random& random) {
    const std::vector<std::size_t> values = values_in(text);
    if (values.empty()) return;
    const auto place = [&] { return values[random.below(static_cast<std::uint32_t>(values.size()))]; };
    const std::size_t at = place(), end = end_of_value(text, at);
    const std::size_t other = place(), other_end = end_of_value(text, other);
    switch (random.below(12)) {
    case 0:
    case 1:
    case 2:
    case 8:
    case 9:
    case 10:
    case 11: text.replace(at, end - at, strange_value_for(text.substr(at, end - at), random)); break;
    case 3: text.replace(at, end - at, text.substr(other, other_end - other)); break;  // one value in place of another
    case 4: text.insert(at, text.substr(at, end - at) + ", "); break;                  // twice, if it is a list's
    case 5: {                                                                          // deeper, and as a rule closed again
        const std::string name = "\"" + std::string(names[random.below(std::size(names))]) + "\": ";
        const bool is_list = random.one_in(2);
        if (!random.one_in(4)) text.insert(end, is_list ? "]" : "}");
        text.insert(at, is_list ? "[" : "{" + name);
        break;
    }
    case 6: {  // a field more
        const std::size_t brace = text.find('{', at);
        if (brace != std::string::npos)
            text.insert(brace + 1, "\"" + std::string(names[random.below(std::size(names))]) +
                                       "\": " + strange_values[random.below(std::size(strange_values))] + ", ");
        break;
    }
    default: {  // another name
        const std::size_t quote = text.rfind('"', at),
                          before = quote == std::string::npos || quote == 0 ? quote : text.rfind('"', quote - 1);
        if (before != std::string::npos) text.replace(before + 1, quote - before - 1, names[random.below(std::size(names))]);
        break;
    }
    }
}

std::string mutant_of(const std::vector<std::string>& texts, std::uint64_t seed) {
    Random random(seed);
    std::string text = texts[random.below(static_cast<std::uint32_t>(texts.size()))];
    const std::uint32_t changes = random.one_in(50) ? 0 : 1 + random.below(random.one_in(4) ? 8 : 2);
    const bool in_bytes = random.one_in(4);
    for (std::uint32_t i = 0; i < changes; ++i) in_bytes || random.one_in(10) ? mutate_bytes(text, random) : mutate_structure(text, random);
    return text;
}

// -- judging -----------------------------------------------------------------------------------------------------------------------------------------

/// Whether it begins with a place: "line 3, column 4: ", "bodies[0].type: ", the name of a field; or speaks of the file as a whole.
bool names_its_place(const std::string& sentence) {
    const std::size_t colon = sentence.find(": ");
    return colon != std::string::npos && colon + 2 < sentence.size() && colon > 0;
}

struct Counts {
    std::uint64_t refused = 0, refused_by_engine = 0, stepped = 0;
};

/// What is wrong with how a text is taken; empty if nothing is.
std::string finding(const std::string& text, Counts& counts) {
    Scene scene;
    try {
        scene = read_scene(text);
    } catch (const SceneFileError& error) {
        ++counts.refused;
        return names_its_place(error.what()) ? "" : std::string("refused without a place: ") + error.what();
    } catch (const std::exception& error) { return std::string("not refused but thrown: ") + error.what(); }
    const std::string written = write_scene(scene);
    if (write_scene(read_scene(written)) != written) return "written and read back it is another";
    scene.steps = std::min(scene.steps, 3);
    std::optional<Run> run;
    try {
        run.emplace(std::move(scene), RunOptions{});
    } catch (const std::runtime_error& error) {
        ++counts.refused_by_engine;
        return names_its_place(error.what()) ? "" : std::string("refused by the engine without a place: ") + error.what();
    }
    run->run({});
    if (const char* fault = run->engine.world().validate()) return std::string("unsound after its steps: ") + fault;
    const std::string picture = draw_svg(*run, usual_drawing());
    if (picture.size() > 200'000 + 100 * text.size()) return "a picture of " + std::to_string(picture.size()) + " bytes";
    if (picture.find("nan") != std::string::npos && text.find("nan") == std::string::npos) return "a picture with a NaN";
    ++counts.stepped;
    return "";
}

/// The same with the memory it takes.
std::string whole_finding(const std::string& text, Counts& counts) {
    const std::size_t before = held;
    most_held = held;
    std::string found = finding(text, counts);
    const std::size_t taken = most_held - before, most = (std::size_t{16} << 20) + 4096 * text.size();
    if (found.empty() && taken > most) found = "takes " + std::to_string(taken) + " bytes of memory";
    return found;
}

/// Cuts out pieces while the finding stays.
std::string shortened(std::string text, const std::string& found) {
    const std::string kind = found.substr(0, 12);
    Counts ignored;
    for (std::size_t piece = text.size() / 2; piece > 0; piece /= 2) {
        for (std::size_t at = 0; at + piece <= text.size();) {
            std::string shorter = text;
            shorter.erase(at, piece);
            if (whole_finding(shorter, ignored).substr(0, 12) == kind)
                text = std::move(shorter);
            else
                at += piece;
        }
    }
    return text;
}

volatile std::uint64_t seed_at_work = 0;

void tell_mutant(int signal) {
    char words[80];
    const int length = std::snprintf(words, sizeof words, "scene_mutants: %s at seed %llu\n", signal == SIGALRM ? "hangs" : "stops",
                                     static_cast<unsigned long long>(seed_at_work));
    [[maybe_unused]] const auto written = write(STDERR_FILENO, words, static_cast<std::size_t>(length));
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

int search(int argc, char** argv) {
    std::uint64_t from = 0, count = 10000;
    bool show = false;
    for (int i = 1; i < argc; ++i) {
        const std::string option = argv[i];
        if (option == "--show")
            show = true;
        else if (option == "--from" && i + 1 < argc)
            from = std::strtoull(argv[++i], nullptr, 10);
        else if (option == "--count" && i + 1 < argc)
            count = std::strtoull(argv[++i], nullptr, 10);
        else
            return std::fprintf(stderr, "scene_mutants: no option %s; there are --from, --count and --show\n", argv[i]), 2;
    }
    for (const int signal : {SIGABRT, SIGSEGV, SIGFPE, SIGBUS, SIGILL, SIGALRM}) std::signal(signal, tell_mutant);
    const std::vector<std::string> texts = originals();
    Counts counts;
    for (std::uint64_t done = 0; done < count; ++done) {
        seed_at_work = from + done;
        const std::string text = mutant_of(texts, seed_at_work);
        if (show) std::printf("%s\n", text.c_str());
        alarm(60);
        const std::string found = whole_finding(text, counts);
        if (found.empty()) continue;
        alarm(0);
        std::printf("seed %llu: %s\n%s\n", static_cast<unsigned long long>(seed_at_work), found.c_str(), shortened(text, found).c_str());
        return 1;
    }
    std::printf("%llu mutants: %llu refused when read, %llu by the engine, %llu stepped\n", static_cast<unsigned long long>(count),
                static_cast<unsigned long long>(counts.refused), static_cast<unsigned long long>(counts.refused_by_engine),
                static_cast<unsigned long long>(counts.stepped));
    return 0;
}

}  // namespace
}  // namespace islet::tools

int main(int argc, char** argv) { return islet::tools::search(argc, argv); }
