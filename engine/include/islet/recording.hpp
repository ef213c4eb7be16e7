// Recordings: every call that changes a world, written down as it is made, to be replayed anywhere: to find a fault, to report one, to compare two builds.
//
//     world.start_recording(buffer);           // at any time: a recording begins with a snapshot
//     ... calls and steps ...
//     const std::size_t bytes = world.stop_recording();
//
//     RecordingInfo info;                      // elsewhere, another day:
//     if (read_recording({buffer.data(), bytes}, info) == Error::none) {
//         if (world_bytes(info.needed) > block.size()) ...                // a file from outside may ask for more than you give
//         World* world = World::create(block, info.needed, {});
//         ReplayResult result = replay(*world, {buffer.data(), bytes});   // the same calls, the same hash after each step, or the first that differs
//     }
//
// Calls that fail are recorded too. What is no part of a world's value is not: hooks, the clock, the task system and the lanes are the replayer's own; a
// world that was recorded with hooks must be given equal ones.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "islet/types.hpp"

ISLET_API_BEGIN
namespace islet {

/// Alignment of the memory a recording is in, bytes.
inline constexpr std::size_t recording_alignment = 8;

/// What a recording says of itself.
struct RecordingInfo {
    Capacity capacity = {};   ///< of the world it was made of, as the recording claims: a forged one may claim any
    Capacity needed = {};     ///< what a world needs to replay it alike: the capacity claimed, but no more than the recording's snapshots and calls could
                              ///< ever fill. (That is at most one shape for each byte of the recording, and the square of the shapes in contacts.)
    std::uint64_t bytes = 0;  ///< of the whole recording
    bool bodies = false;      ///< whether each step tells body from body
};

/// Reads the head of a recording, and goes through its calls without making them. Errors, on which `out` stays as it was: image_misaligned;
/// not_a_recording; other_version; truncated_image; corrupt_recording if the head contradicts itself; and what read_snapshot finds wrong with the snapshot
/// that the recording begins with. Damaged calls are no error here: the reading ends at the first of them, as a replay does.
Error read_recording(std::span<const std::byte> recording, RecordingInfo& out);

/// How a replay ended.
enum class ReplayEnd : std::uint8_t {
    complete,  ///< everything was replayed and each hash was the recorded one
    stopped,   ///< so far as was asked for
    differs,   ///< a step came out differently
    refused,   ///< the recording is not sound: see error
};

struct ReplayResult {
    ReplayEnd end = ReplayEnd::complete;
    Error error = Error::none;                  ///< refused: what read_recording or World::load says, or corrupt_recording
    std::uint64_t steps = 0;                    ///< steps replayed, the one that differs included
    std::uint64_t recorded_hash = 0, hash = 0;  ///< differs: after that step
    BodyId body = {};  ///< differs: the first body, by slot, that came out differently, if the recording tells body from body; null too where
                       ///< so far no body but a contact or a joint differs
};

class World;

/// Puts the world into the state the recording began with and makes its calls again, up to and including `steps` steps. The world's capacity should be
/// RecordingInfo::needed, or the recorded one. A recording may be hostile: nothing it holds is used unchecked, and a step's calls are known to be the recorded
/// ones after that step.
ReplayResult replay(World& world, std::span<const std::byte> recording, std::uint64_t steps = ~std::uint64_t{0});

}  // namespace islet
ISLET_API_END
