// islet_lockstep: random worlds and calls, and forged images, on worlds that are to stay equal. README.md here says what is looked for.
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "images.hpp"
#include "shrink.hpp"

namespace islet::test {

void broken(const char* what) { throw lockstep::Broken{what}; }

}  // namespace islet::test

namespace islet::lockstep {

namespace {

struct Options {
    std::uint64_t seed = 1, worlds = ~std::uint64_t{0}, steps = ~std::uint64_t{0};
    std::uint32_t calls = ~0u;
    double seconds = 60, shrink_seconds = 60;
    int family = -1;
    bool images = false, recordings = false, whole = false, dense = false;
};

/// What the hunting process leaves for the one that watches it.
struct Shared {
    std::uint64_t seed, worlds, calls, steps;
    unsigned long accepted, deltas, replays, complete_replays;  // of mutants
    std::uint32_t told;
    char what[256];
};

int usage() {
    std::printf("islet_lockstep [--seed N] [--worlds N] [--seconds S] [--steps N] [--calls N] [--family NAME] [--dense] [--images] [--recordings] [--whole] [--shrink-seconds S]\n"
                "  --seed N     the first world's (or mutants'); the next ones follow. Default 1\n"
                "  --worlds N   so many worlds (mutants with --images) at most\n"
                "  --seconds S  ends after so many seconds; 0: never. Default 60\n"
                "  --steps N    ends after so many steps\n"
                "  --calls N    so many calls a world at most\n"
                "  --family F   of numbers:");
    for (const fuzz::Family& f : fuzz::families) std::printf(" %s", f.name);
    std::printf(". Default: all of them\n"
                "  --dense      many calls between steps, in place of some steps after each\n"
                "  --images     forged images, deltas and recordings instead of calls\n"
                "  --recordings  forged recordings alone\n"
                "  --whole      prints a finding's program without making it small\n");
    return 2;
}

// The hunting process. Whatever happens to it, `shared` says in which world.
[[noreturn]] void hunt(const Options& o, Shared& shared) {
    static Stand stands[2];
    static ImageHunt images;
    images.recordings_alone = o.recordings;
    const double end = o.seconds > 0 ? seconds_now() + o.seconds : 1e300;
    for (std::uint64_t i = 0; i < o.worlds && shared.steps < o.steps && seconds_now() < end; ++i) {
        shared.seed = o.seed + i;
        shared.told = 0;
        if (!o.images || i % 1024 == 0) alarm(120);
        Setup setup = o.images ? ImageHunt::setup(shared.seed) : setup_of(shared.seed, o.family);
        setup.dense = o.dense;
        static Chorus pairs[2];
        const std::size_t which = o.images ? shared.seed % 2 : 0;
        Chorus& all = pairs[which];
        try {
            if (!o.images || i < 2) stands[which].begin(setup, all);
            all.told = 0;
            all.steps = 0;
            all.told_to = &shared.told;
            if (o.images) images.attack(shared.seed, all);
            else play(setup, all, o.calls);
        } catch (const Broken& broken) {
            std::snprintf(shared.what, sizeof shared.what, "%s", broken.what.c_str());
            _exit(1);
        }
        ++shared.worlds;
        shared.calls += all.told - all.steps;
        shared.steps += all.steps;
        shared.accepted = images.accepted;
        shared.deltas = images.deltas;
        shared.replays = images.replays;
        shared.complete_replays = images.complete_replays;
    }
    _exit(0);
}

int report(const Options& o, const Shared& shared) {
    std::printf("seed %llu: %s (after %u calls and steps)\n", static_cast<unsigned long long>(shared.seed), shared.what, shared.told);
    std::fflush(stdout);
    Setup setup = o.images ? ImageHunt::setup(shared.seed) : setup_of(shared.seed, o.family);
    setup.dense = o.dense;
    Deeds deeds;
    std::string what;
    {
        static Stand stand;
        Chorus all;
        stand.begin(setup, all);
        all.log = &deeds;
        all.last_call = shared.told;
        try {
            static ImageHunt images;
            images.recordings_alone = o.recordings;
            if (o.images) images.attack(shared.seed, all);
            else play(setup, all, o.calls);
        } catch (const Broken& broken) {
            what = broken.what;
        }
    }
    what = attempt(setup, deeds);
    std::printf("its %zu calls and steps again: %s\n", deeds.size(), what.empty() ? "nothing is wrong" : what.c_str());
    if (what.empty()) return 1;
    if (!o.whole) shrink(setup, deeds, what, o.shrink_seconds);
    std::printf("%zu calls and steps are left: %s\n\n%s\n", deeds.size(), attempt(setup, deeds).c_str(), program(setup, renamed(setup, deeds), what).c_str());
    return 1;
}

int watch(const Options& o) {
    auto* shared = static_cast<Shared*>(mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
    if (shared == MAP_FAILED) return 2;
    std::memset(static_cast<void*>(shared), 0, sizeof *shared);
    const double begin = seconds_now();
    std::fflush(nullptr);
    const pid_t hunter = fork();
    if (hunter == 0) hunt(o, *shared);
    int status = 0;
    waitpid(hunter, &status, 0);
    const double took = seconds_now() - begin;
    const auto number = [](std::uint64_t n) { return static_cast<unsigned long long>(n); };
    if (o.images) {
        std::printf("%llu mutants from seed %llu: %lu images accepted, %lu deltas applied, %lu recordings replayed, %lu of them to the end; %llu steps in lockstep; %.0f mutants/s\n",
                    number(shared->worlds), number(o.seed), shared->accepted, shared->deltas, shared->replays, shared->complete_replays, number(shared->steps),
                    static_cast<double>(shared->worlds) / took);
    } else {
        std::printf("%llu worlds from seed %llu: %llu calls, %llu steps in lockstep, %.0f steps/s\n", number(shared->worlds), number(o.seed),
                    number(shared->calls), number(shared->steps), static_cast<double>(shared->steps) / took);
    }
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return 0;
    if (WIFSIGNALED(status)) std::snprintf(shared->what, sizeof shared->what, WTERMSIG(status) == SIGALRM ? "it takes for ever" : "it crashes");
    else if (shared->what[0] == 0) std::snprintf(shared->what, sizeof shared->what, "it ends with status %d", WEXITSTATUS(status));
    return report(o, *shared);
}

}  // namespace

}  // namespace islet::lockstep

int main(int count, char** arguments) {
    using namespace islet::lockstep;
    Options o;
    for (int i = 1; i < count; ++i) {
        const std::string name = arguments[i];
        if (name == "--images" || name == "--recordings") {
            o.images = true;
            o.recordings = o.recordings || name == "--recordings";
            continue;
        }
        if (name == "--whole" || name == "--dense") {
            o.whole = o.whole || name == "--whole";
            o.dense = o.dense || name == "--dense";
            continue;
        }
        if (i + 1 == count) return usage();
        const char* value = arguments[++i];
        if (name == "--seed") o.seed = std::strtoull(value, nullptr, 0);
        else if (name == "--worlds") o.worlds = std::strtoull(value, nullptr, 0);
        else if (name == "--steps") o.steps = std::strtoull(value, nullptr, 0);
        else if (name == "--calls") o.calls = static_cast<std::uint32_t>(std::strtoul(value, nullptr, 0));
        else if (name == "--seconds") o.seconds = std::strtod(value, nullptr);
        else if (name == "--shrink-seconds") o.shrink_seconds = std::strtod(value, nullptr);
        else if (name == "--family") {
            for (std::size_t k = 0; k < std::size(islet::fuzz::families); ++k)
                if (std::strcmp(islet::fuzz::families[k].name, value) == 0) o.family = static_cast<int>(k);
            if (o.family < 0) return usage();
        } else return usage();
    }
    return watch(o);
}
