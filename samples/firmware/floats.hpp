// Does the machine compute as IEEE 754 says?
#pragma once

#include <cstdint>

namespace firmware {

/// Sums, products, quotients, roots and conversions of `count` pairs of floats of every size, infinite and denormal ones included, hashed. The same on
/// every machine that rounds to nearest even and keeps denormal numbers. What is not a number counts as one value, since its bits are left open.
std::uint64_t hash_floats(std::uint32_t count);

}  // namespace firmware
