// Measures how long the stages of a step take, in ticks of the user's clock.
#pragma once

#include "../data/core.hpp"

namespace islet::detail {

/// Each stage ends where the next begins.
enum class Stage : std::uint32_t { begin, pairs, collide, islands, solve, finish };

/// Adds the time since the last call to the stage that ends now. Only programs that call World::profile or World::set_clock link this; in others core.clock is
/// null.
ISLET_OPTIONAL void note_stage(Core& core, Stage stage);

/// Costs a test for null in programs that do not measure.
ISLET_SHARED void note(Core& core, Stage stage) {
    if (has_profile && core.clock != nullptr) note_stage(core, stage);
}

}  // namespace islet::detail
