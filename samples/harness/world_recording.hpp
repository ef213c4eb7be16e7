// Recordings of worlds (islet/recording.hpp) in memory that grows.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <islet/islet.hpp>

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

}  // namespace islet::samples
