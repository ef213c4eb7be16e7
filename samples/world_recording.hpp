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

/// A recording that was read from a file, replayed in a world of its own.
struct Replayed {
    std::string error;    // why there is no result; else empty
    ReplayResult result;
    std::uint64_t hash = 0;  // of the world in the end
};

/// Throws a FileError if the file cannot be read.
Replayed replay_file(const std::string& path, std::uint64_t until, std::uint32_t lanes);

}  // namespace islet::samples
