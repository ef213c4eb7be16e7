// Numbers by their bits.
#pragma once

#include <bit>
#include <cstdint>

namespace islet::test {

/// The next float after a positive one.
inline float next_up(float f) { return std::bit_cast<float>(std::bit_cast<std::uint32_t>(f) + 1u); }

}  // namespace islet::test
