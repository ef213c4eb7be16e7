// Recordings: every call that changes a world, written down as it is made. A replay anywhere makes the calls again: to find a fault, to report it, or to
// compare two builds.
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
// Calls that fail are recorded, too. Hooks, the clock, the task system and the lanes are not part of a world's state and are not recorded: the replaying world
// has its own. To replay a world that had hooks, give the replaying world hooks that give equal answers.
#pragma once

#include <cstddef>
#include <cstdint>

#include "islet/span.hpp"
#include "islet/types.hpp"

ISLET_API_BEGIN
namespace islet {

/// Alignment of the memory that holds a recording, bytes.
inline constexpr std::size_t recording_alignment = 8;

/// What a recording says about itself.
struct RecordingInfo {
    Capacity capacity = {};   ///< of the recorded world, as the recording claims; a forged recording may claim any capacity
    Capacity needed = {};     ///< what a world needs for a replay with the same results: the capacity claimed, but no more than the recording's snapshots
                              ///< and calls could fill. (That is at most one shape for each byte of the recording, and the square of the shapes in contacts.)
    std::uint64_t bytes = 0;  ///< of the whole recording
    bool bodies = false;      ///< whether each step has a hash of each awake body
};

/// Reads the header of a recording, and goes through its calls without making them. On an error `out` stays as it was: image_misaligned; not_a_recording;
/// other_byte_order; other_version; truncated_image; corrupt_recording if the header contradicts itself; and the errors of read_snapshot for the recording's
/// first snapshot. Damaged calls are no error here: the function stops at the first of them, as a replay does.
Error read_recording(span<const std::byte> recording, RecordingInfo& out);

/// How a replay ended.
enum class ReplayEnd : std::uint8_t {
    complete,  ///< everything was replayed, and each hash was the recorded one
    stopped,   ///< the replay has made as many steps as you asked for
    differs,   ///< a step came out differently
    refused,   ///< the recording is not sound; `error` says why
};

struct ReplayResult {
    ReplayEnd end = ReplayEnd::complete;
    Error error = Error::none;                  ///< refused: an error of read_recording or World::load, or corrupt_recording
    std::uint64_t steps = 0;                    ///< steps replayed, including the one that differs
    std::uint64_t recorded_hash = 0, hash = 0;  ///< differs: after that step
    BodyId body = {};  ///< differs: the first body, by slot, that came out differently, if the recording has hashes of bodies; null if so far only a
                       ///< contact or a joint differs
};

class World;

/// Puts the world into the recording's first state and makes its calls again, up to and including `steps` steps. The world's capacity should be
/// RecordingInfo::needed, or the recorded one. A recording may be hostile: nothing of it is used unchecked. After each step, a sum shows whether the calls
/// before it were the recorded ones.
ReplayResult replay(World& world, span<const std::byte> recording, std::uint64_t steps = ~std::uint64_t{0});

}  // namespace islet
ISLET_API_END
