// The clock that tools measure with.
#pragma once

#include <chrono>
#include <cstdint>

namespace islet::tools {

inline constexpr double nanoseconds_per_ms = 1e6;

/// Nanoseconds on a clock that never goes back.
inline std::uint64_t nanoseconds_now() {
    return static_cast<std::uint64_t>(std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count());
}

}  // namespace islet::tools
