// Recordings of worlds (islet/recording.hpp) in memory that grows, and in files.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "islet/islet.hpp"

namespace islet::samples {

/// Memory aligned for a recording or a world, zeroed.
class AlignedBytes {
public:
    explicit AlignedBytes(std::size_t size);
    std::span<std::byte> span() const { return {data_, size_}; }

private:
    std::vector<std::byte> memory_;
    std::byte* data_;
    std::size_t size_;
};

/// Records a world from now on. Call after_step after each step, so that there is always room for the next.
class WorldRecording {
public:
    explicit WorldRecording(World& world);
    void after_step();
    /// Ends it and returns its bytes; empty if there was not room enough for one step's calls.
    std::span<const std::byte> finish();

private:
    World* world_;
    AlignedBytes memory_;
};

/// Bytes of a world that a file may ask for, unless the user says otherwise.
inline constexpr std::uint64_t usual_memory_limit = 2'000'000'000;

/// A sentence, if a world of this capacity would take more bytes than the limit or cannot be made at all; else empty.
std::string beyond_memory_limit(const Capacity& capacity, std::uint64_t limit);

/// A recording that was read from a file, replayed in a world of its own.
struct Replayed {
    std::string error;    // why there is no result; else empty
    ReplayResult result;
    std::uint64_t hash = 0;  // of the world in the end
};

/// In a world as large as the recording needs, whatever it says, and within the limit, bytes. Throws a FileError if the file cannot be read.
Replayed replay_file(const std::string& path, std::uint64_t until, std::uint32_t lanes, std::uint64_t memory_limit = usual_memory_limit);

}  // namespace islet::samples
