// Recordings of worlds (islet/recording.hpp) in files, and how much memory a file may ask for.
#pragma once

#include <cstdint>
#include <string>

#include <islet/islet.hpp>

namespace islet::tools {

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

}  // namespace islet::tools
