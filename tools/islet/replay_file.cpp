#include "replay_file.hpp"

#include <algorithm>

#include "common/read_file.hpp"
#include "harness/world_recording.hpp"

namespace islet::tools {

using namespace samples;

std::string beyond_memory_limit(const Capacity& c, std::uint64_t limit) {
    if (!is_valid(c)) return describe(Error::bad_capacity);
    const std::uint64_t bytes = world_bytes(c);
    if (bytes <= limit) return {};
    const auto megabytes = [](std::uint64_t n) { return std::to_string(n / 1'000'000) + " MB"; };
    return "its world would take " + megabytes(bytes) + ", and " + megabytes(limit) + " are allowed: raise --memory-limit if that is what you want";
}

Replayed replay_file(const std::string& path, std::uint64_t until, std::uint32_t lanes, std::uint64_t memory_limit) {
    const std::string bytes = read_file(path);
    const AlignedBytes recording(bytes.size());
    std::transform(bytes.begin(), bytes.end(), recording.span().begin(), [](char c) { return static_cast<std::byte>(c); });

    RecordingInfo info;
    if (const Error error = read_recording(recording.span(), info); error == Error::not_a_recording)
        return {"this is " + kind_of(bytes) + ", no recording; `islet run SCENE --record FILE` makes one", {}, 0};
    else if (error == Error::other_version) {
        char sentence[128];
        describe_format(read_format(recording.span()), sentence);
        return {sentence, {}, 0};
    } else if (error != Error::none)
        return {describe(error), {}, 0};
    const Capacity& c = info.needed;
    if (const std::string why = beyond_memory_limit(c, memory_limit); !why.empty()) return {why, {}, 0};
    const AlignedBytes block(world_bytes(c));
    Error error = Error::none;
    World* world = World::create(block.span(), c, {.lanes = lanes}, &error);
    if (world == nullptr) return {describe(error), {}, 0};
    Replayed replayed{{}, replay(*world, recording.span(), until), world->hash()};
    if (replayed.result.end == ReplayEnd::refused) replayed.error = describe(replayed.result.error);
    return replayed;
}

}  // namespace islet::tools
