// Forged images, deltas and recordings.
#pragma once

#include <cstdint>

namespace islet::lockstep {

struct Tally;

/// Mutants until `seconds` are over or `count` were tried. Returns the exit status.
int hunt_images(std::uint64_t seed, std::uint64_t count, double seconds);

}  // namespace islet::lockstep
