#include "shrink.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>

namespace islet::lockstep {

double seconds_now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

namespace {

// "worlds differ: four lanes, poses" and "worlds differ: sixteen lanes, motions" are the same finding.
std::string kind_of(const std::string& what) { return what.substr(0, what.find(':')); }

bool breaks(const Setup& setup, const Deeds& deeds, const std::string& what) { return kind_of(attempt(setup, deeds)) == kind_of(what); }

struct Budget {
    double end;
    bool over() const { return seconds_now() > end; }
};

bool drop_calls(const Setup& setup, Deeds& deeds, const std::string& what, const Budget& budget) {
    bool dropped = false;
    for (std::size_t piece = std::max<std::size_t>(deeds.size() / 2, 1); piece > 0 && !budget.over(); piece /= 2) {
        for (std::size_t at = deeds.size(); at > 0 && !budget.over();) {
            const std::size_t begin = at > piece ? at - piece : 0;
            Deeds fewer(deeds.begin(), deeds.begin() + static_cast<std::ptrdiff_t>(begin));
            fewer.insert(fewer.end(), deeds.begin() + static_cast<std::ptrdiff_t>(at), deeds.end());
            if (breaks(setup, fewer, what)) {
                deeds = fewer;
                dropped = true;
            }
            at = begin;
        }
        deeds.shrink_to_fit();
    }
    return dropped;
}

bool simplify_numbers(const Setup& setup, Deeds& deeds, const std::string& what, const Budget& budget) {
    bool simplified = false;
    for (std::size_t i = 0; i < deeds.size(); ++i) {
        const std::uint32_t n = deeds[i]->numbers();
        for (std::uint32_t k = 0; k < n && !budget.over(); ++k) {
            for (std::uint32_t how = 0; how < test::Numbers::ways; ++how) {
                const auto other = deeds[i]->simpler(k, how);
                if (other == nullptr) continue;
                Deeds changed = deeds;
                changed[i] = other;
                if (!breaks(setup, changed, what)) continue;
                deeds = changed;
                simplified = true;
                break;
            }
        }
    }
    return simplified;
}

template <class Member, class Value>
void try_default(Setup& setup, const Deeds& deeds, const std::string& what, Member WorldDef::*member, const Value& value) {
    Setup other = setup;
    other.def.*member = value;
    if (breaks(other, deeds, what)) setup = other;
}
template <class Member>
void try_solver_default(Setup& setup, const Deeds& deeds, const std::string& what, Member SolverDef::*member) {
    Setup other = setup;
    other.def.solver.*member = SolverDef{}.*member;
    if (other.def.solver == setup.def.solver) return;
    if (breaks(other, deeds, what)) setup = other;
}

void simplify_setup(Setup& setup, const Deeds& deeds, const std::string& what) {
    const WorldDef usual;
    setup.threads = false;
    try_default(setup, deeds, what, &WorldDef::solver, usual.solver);
    try_default(setup, deeds, what, &WorldDef::gravity, usual.gravity);
    try_default(setup, deeds, what, &WorldDef::enable_sleep, usual.enable_sleep);
    try_default(setup, deeds, what, &WorldDef::continuous, usual.continuous);
    try_default(setup, deeds, what, &WorldDef::restitution_threshold, usual.restitution_threshold);
    try_default(setup, deeds, what, &WorldDef::hit_threshold, usual.hit_threshold);
    try_default(setup, deeds, what, &WorldDef::max_speed, usual.max_speed);
    try_solver_default(setup, deeds, what, &SolverDef::schedule);
    try_solver_default(setup, deeds, what, &SolverDef::substeps);
    try_solver_default(setup, deeds, what, &SolverDef::iterations);
    try_solver_default(setup, deeds, what, &SolverDef::relax_iterations);
    try_solver_default(setup, deeds, what, &SolverDef::sweep_order);
    try_solver_default(setup, deeds, what, &SolverDef::joint_trees);
    try_solver_default(setup, deeds, what, &SolverDef::block_contacts);
    try_solver_default(setup, deeds, what, &SolverDef::shock);
    try_solver_default(setup, deeds, what, &SolverDef::measure_residual);
    try_solver_default(setup, deeds, what, &SolverDef::tolerance);
    try_solver_default(setup, deeds, what, &SolverDef::warm_start);
    try_solver_default(setup, deeds, what, &SolverDef::omega);
    try_solver_default(setup, deeds, what, &SolverDef::contact_hertz);
    try_solver_default(setup, deeds, what, &SolverDef::contact_damping_ratio);
}

std::string text_of(const Capacity& c) {
    return "{.bodies = " + std::to_string(c.bodies) + ", .shapes = " + std::to_string(c.shapes) + ", .contacts = " + std::to_string(c.contacts) +
           ", .joints = " + std::to_string(c.joints) + ", .geometries = " + std::to_string(c.geometries) + ", .hits = " + std::to_string(c.hits) + ", .events = " + std::to_string(c.events) + "}";
}

std::string text_of(const WorldDef& d) {
    using test::cpp_text;
    const WorldDef usual;
    std::string s = ".gravity = " + cpp_text(d.gravity);
    if (!(d.solver == usual.solver)) s += ", .solver = " + cpp_text(d.solver);
    if (!d.enable_sleep) s += ", .enable_sleep = false";
    if (d.restitution_threshold != usual.restitution_threshold) s += ", .restitution_threshold = " + cpp_text(d.restitution_threshold);
    if (d.max_speed != usual.max_speed) s += ", .max_speed = " + cpp_text(d.max_speed);
    if (d.hit_threshold != usual.hit_threshold) s += ", .hit_threshold = " + cpp_text(d.hit_threshold);
    if (!d.continuous) s += ", .continuous = false";
    return s;
}

// "hooks_of" as one line is what the preprocessor leaves of it.
std::string hooks_text() { return std::string(test::hook_menu_text) + "\n"; }

}  // namespace

std::string attempt(const Setup& setup, const Deeds& deeds) {
    static Stand stand;
    int ends[2];
    if (pipe(ends) != 0) return "no pipe";
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        close(2);  // what a sanitizer says of it
        alarm(20);
        std::string what;
        try {
            Chorus all;
            stand.begin(setup, all);
            for (const auto& deed : deeds) deed->run(all);
            all.check();
        } catch (const Broken& broken) {
            what = broken.what;
        }
        if (!what.empty() && write(ends[1], what.data(), what.size()) < 0) _exit(2);
        _exit(0);
    }
    close(ends[1]);
    std::string what;
    char text[256];
    for (ssize_t n = 0; (n = read(ends[0], text, sizeof text)) > 0;) what.append(text, static_cast<std::size_t>(n));
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    if (WIFSIGNALED(status)) return WTERMSIG(status) == SIGALRM ? "it takes for ever" : "it crashes";
    return WEXITSTATUS(status) != 0 ? "it crashes" : what;
}

void shrink(Setup& setup, Deeds& deeds, const std::string& what, double seconds) {
    const Budget budget{seconds_now() + seconds};
    for (int round = 0; round < 4 && !budget.over(); ++round) {
        const bool dropped = drop_calls(setup, deeds, what, budget);
        simplify_setup(setup, deeds, what);
        if (!simplify_numbers(setup, deeds, what, budget) && !dropped) break;
    }
}

Deeds renamed(const Setup& setup, const Deeds& deeds) {
    static Stand stand;
    Deeds now;
    Chorus all;
    try {
        stand.begin(setup, all);
        all.log = &now;
        all.last_call = static_cast<std::uint32_t>(deeds.size() - 1);  // the last may crash
        for (const auto& deed : deeds) deed->run(all);
    } catch (const Broken&) {
    }
    return now;
}

std::string program(const Setup& setup, const Deeds& deeds, const std::string& what) {
    bool hooks = false, travels = false, records = false, loads = false;
    std::string calls, last;
    int times = 0;
    const auto flush = [&] {
        if (times == 1) calls += "    " + last + "\n";
        if (times > 1) calls += "    for (int i = 0; i < " + std::to_string(times) + "; ++i) " + last + "\n";
        times = 0;
    };
    for (const auto& deed : deeds) {
        std::string line = deed->text();
        if (deed->is_step()) line = line.substr(3);  // step(dt), which looks at the world too
        hooks |= line.find("hooks_of") != std::string::npos;
        travels |= line.find("travel(") == 0;
        records |= line.find("begin_recording") == 0;
        loads |= line.find("load(image") != std::string::npos;
        if (line != last || !deed->is_step()) {
            flush();
            last = line;
        }
        ++times;
    }
    flush();
    std::string s = "// Found by islet_lockstep --seed " + std::to_string(setup.seed) + ": " + what +
                    "\n// g++ -std=c++20 -O2 -ffp-contract=off -I engine/include THIS build/release/engine/libislet.a\n"
                    "#include <cstdio>\n#include <string>\n#include <vector>\n#include <islet/islet.hpp>\nusing namespace islet;\n";
    if (hooks) s += hooks_text();
    s += "static constexpr Capacity capacity" + text_of(setup.capacity) + ";\n";
    s += "static constexpr Capacity larger{.bodies = 96, .shapes = 400, .contacts = 1024, .joints = 96, .geometries = 300, .hits = 300};\n"
         "static StaticWorld<capacity> here, replayed;\nstatic StaticWorld<larger> there;\n"
         "static World* w;\nstatic int mode, mistakes;\nstatic std::vector<unsigned long long> hashes;\n"
         "static void look() {\n"
         "    hashes.push_back(w->hash());\n"
         "    if (const char* fault = w->validate()) std::printf(\"  unsound: %s\\n\", fault), ++mistakes;\n"
         "    for (unsigned i = 0; i < w->capacity().bodies; ++i)\n"
         "        if (BodyId b = w->body_at(i); b && !(is_finite(w->position(b)) && is_finite(w->linear_velocity(b)) && is_finite(w->angular_velocity(b))))\n"
         "            std::printf(\"  body %u is nowhere\\n\", i), ++mistakes;\n"
         "}\n"
         "static void step(float dt) { w->step(dt); look(); }\n";
    if (travels)
        s += "static void travel(int) {\n"
             "    if (mode != 3) return;\n"
             "    static std::vector<unsigned long long> words;\n"
             "    words.resize(w->snapshot_bytes() / 8);\n"
             "    std::span<std::byte> image(reinterpret_cast<std::byte*>(words.data()), words.size() * 8);\n"
             "    w->save(image);\n"
             "    const Hooks hooks = w->hooks();\n"
             "    w = &there.create();\n"
             "    w->set_hooks(hooks);\n"
             "    if (!w->load(image)) std::printf(\"  its own image is refused: %s\\n\", describe(w->last_error())), ++mistakes;\n"
             "}\n";
    if (loads)
        s += "static void load(const unsigned long long* image, std::size_t bytes) {\n"
             "    const bool loaded = w->load({reinterpret_cast<const std::byte*>(image), bytes});\n"
             "    std::printf(\"  the image is %s\\n\", loaded ? \"loaded\" : \"refused\");\n"
             "}\n";
    if (records)
        s += "static std::vector<unsigned long long> tape(1 << 17);\n"
             "static std::span<std::byte> tape_bytes(reinterpret_cast<std::byte*>(tape.data()), tape.size() * 8);\n"
             "static void begin_recording() { w->start_recording(tape_bytes); }\n"
             "static void end_recording() {\n"
             "    const std::size_t n = w->stop_recording();\n"
             "    World& other = replayed.create({.lanes = 4});\n"
             "    other.set_hooks(w->hooks());\n"
             "    const ReplayResult r = replay(other, tape_bytes.first(n));\n"
             "    if (r.end != ReplayEnd::complete) std::printf(\"  a replay ends badly, at step %d\\n\", int(r.steps)), ++mistakes;\n"
             "}\n";
    s += "static void play() {\n" + calls + "    look();\n}\n";
    s += "int main() {\n"
         "    static void (*const backwards)(void*, unsigned, void (*)(void*, unsigned), void*) =\n"
         "        [](void*, unsigned count, void (*task)(void*, unsigned), void* data) { for (unsigned i = count; i-- > 0;) task(data, i); };\n"
         "    const unsigned lanes[] = {1, 4, 16, 16};\n"
         "    std::vector<unsigned long long> first;\n"
         "    for (mode = 0; mode < 4; ++mode) {\n"
         "        WorldDef def{" + text_of(setup.def) + "};\n"
         "        def.lanes = lanes[mode];\n"
         "        if (mode > 0) def.tasks = {backwards, nullptr, 2};\n"
         "        w = &here.create(def);\n"
         "        hashes.clear();\n"
         "        std::printf(\"%u lanes%s\\n\", lanes[mode], mode == 3 ? \", on the way through images\" : \"\");\n"
         "        play();\n"
         "        if (mode == 0) first = hashes;\n"
         "        for (std::size_t i = 0; i < hashes.size() && i < first.size(); ++i) {\n"
         "            if (hashes[i] == first[i]) continue;\n"
         "            std::printf(\"  differs from one lane after step %d\\n\", int(i + 1)), ++mistakes;\n"
         "            break;\n"
         "        }\n"
         "    }\n"
         "    std::printf(\"%d mistakes\\n\", mistakes);\n"
         "    return mistakes != 0;\n"
         "}\n";
    return s;
}

}  // namespace islet::lockstep
