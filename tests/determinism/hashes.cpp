// Runs scenes and compares their hashes with golden.txt: a bare program, to be built with any compiler and any flags.
//
//     hashes GOLDEN_FILE [--lanes 1,4,8,16] [--workers 1,2,4,8] [--scene NAME]... [--most-steps N] [--large-steps N] [--recording FILE]... [--update]
//
// Exit status 0: all equal; 1: not; 2: wrong usage. --most-steps leaves out the checkpoints beyond, --large-steps those of the benchmark scenes.
// Without --workers the worlds have no task system; with it they step on a pool of so many threads. Each step of a recording is compared, too. (On a machine of
// the other byte order, which refuses it, there is nothing to compare.)
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include <islet/recording.hpp>

#include "golden.hpp"
#include "harness/world_recording.hpp"
#if !defined(__wasm__)
#include "workers/thread_pool.hpp"
#endif

using namespace islet;

namespace {

#if defined(__wasm__)
// No threads there.
struct Pool {
    explicit Pool(std::uint32_t) {}
    static TaskSystem tasks() { return {}; }
};
#else
using Pool = samples::ThreadPool;
#endif

// The numbers in a list like 1,4,16.
std::vector<std::uint32_t> numbers_in(const std::string& list) {
    std::vector<std::uint32_t> numbers;
    std::istringstream in(list);
    for (std::string number; std::getline(in, number, ',');) numbers.push_back(static_cast<std::uint32_t>(std::stoul(number)));
    return numbers;
}

/// Makes the calls of a recording again. Returns how many steps came out as recorded, or -1 if anything else happened.
long long replay_file(const std::string& path, std::uint32_t lanes, const TaskSystem& tasks) {
    std::ifstream file(path, std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    const samples::AlignedBytes recording(bytes.size());
    if (!bytes.empty()) std::memcpy(recording.span().data(), bytes.data(), bytes.size());
    RecordingInfo info;
    Error error = read_recording(recording.span(), info);
    ReplayResult result;
    if (error == Error::none) {
        const samples::AlignedBytes block(world_bytes(info.needed));
        WorldDef def;
        def.lanes = lanes;
        def.tasks = tasks;
        World* const world = World::create(block.span(), info.needed, def, &error);
        if (world != nullptr) result = replay(*world, recording.span());
    }
    if (error == Error::none && result.end == ReplayEnd::complete) return static_cast<long long>(result.steps);
    if (error == Error::other_byte_order) return 0;
    std::printf("%s, lanes %u: %s after %llu steps\n", path.c_str(), lanes,
                error != Error::none               ? describe(error)
                : result.end == ReplayEnd::differs ? "another hash"
                                                   : describe(result.error),
                static_cast<unsigned long long>(result.steps));
    return -1;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr,
                     "usage: hashes GOLDEN_FILE [--lanes 1,4,8,16] [--workers 1,2,4,8] [--scene NAME]... [--most-steps N] [--large-steps N] "
                     "[--recording FILE]... [--update]\n");
        return 2;
    }
    const std::string path = argv[1];
    std::string lanes = "1,4,8,16", workers = "1";
    std::vector<std::string> scenes;  // all if empty
    std::vector<std::string> recordings;
    int most_steps = 1 << 30, large_steps = 1 << 30;
    bool update = false;
    for (int i = 2; i < argc; ++i) {
        const std::string option = argv[i];
        if (option == "--update") {
            update = true;
        } else if (i + 1 < argc && option == "--lanes") {
            lanes = argv[++i];
        } else if (i + 1 < argc && option == "--workers") {
            workers = argv[++i];
        } else if (i + 1 < argc && option == "--scene") {
            scenes.emplace_back(argv[++i]);
        } else if (i + 1 < argc && option == "--recording") {
            recordings.emplace_back(argv[++i]);
        } else if (i + 1 < argc && option == "--most-steps") {
            most_steps = std::atoi(argv[++i]);
        } else if (i + 1 < argc && option == "--large-steps") {
            large_steps = std::atoi(argv[++i]);
        } else {
            std::fprintf(stderr, "hashes: unknown option %s\n", option.c_str());
            return 2;
        }
    }

    const golden::Table table = golden::read(path);
    golden::Table fresh;
    int compared = 0, wrong = 0;
    for (const samples::SceneInfo& info : samples::catalogue()) {
        if (!scenes.empty() && std::find(scenes.begin(), scenes.end(), info.name) == scenes.end()) continue;
        const std::vector<golden::Checkpoint> due = golden::checkpoints_of(table, info);
        if (update) {
            fresh.push_back({info.name, golden::run(info, due, 0, 1 << 30)});
            continue;
        }
        const int steps = std::string(info.group) == "benchmark" ? std::min(most_steps, large_steps) : most_steps;
        for (const std::uint32_t threads : numbers_in(workers)) {
            Pool pool(threads);
            for (const std::uint32_t width : numbers_in(lanes)) {
                const std::vector<golden::Checkpoint> seen = golden::run(info, due, width, steps, pool.tasks());
                for (std::size_t i = 0; i < seen.size(); ++i) {
                    ++compared;
                    if (seen[i].hash == due[i].hash) continue;
                    ++wrong;
                    std::printf("%s, lanes %u, workers %u, %d steps: %s, should be %s\n", info.name, width, threads, seen[i].steps,
                                golden::hex(seen[i].hash).c_str(), golden::hex(due[i].hash).c_str());
                }
            }
        }
    }
    if (update) return golden::write(path, fresh) ? 0 : 1;
    std::printf("%d hashes compared, %d differ", compared, wrong);
    long long steps = 0;
    for (const std::string& path : recordings) {
        for (const std::uint32_t threads : numbers_in(workers)) {
            Pool pool(threads);
            for (const std::uint32_t width : numbers_in(lanes)) {
                const long long taken = replay_file(path, width, pool.tasks());
                wrong += taken < 0;
                steps += std::max(taken, 0LL);
            }
        }
    }
    if (!recordings.empty()) std::printf("; %lld steps of %zu recordings came out as recorded", steps, recordings.size());
    std::printf("\n");
    return wrong == 0 && compared > 0 ? 0 : 1;
}
