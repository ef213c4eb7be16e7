// What the stages of a step take, in ticks of the user's clock.
#pragma once

#include "../data/core.hpp"

namespace islet::detail {

/// Each stage ends where the next begins.
enum class Stage : std::uint32_t { begin, pairs, collide, islands, solve, finish };

/// Books the time since the last call to the stage that ends now. Linked only by programs that call World::profile or World::set_clock; core.clock is null
/// in the others.
ISLET_OPTIONAL void note_stage(Core& core, Stage stage);

/// A test for null where nobody asked.
ISLET_SHARED void note(Core& core, Stage stage) {
    if (has_profile && core.clock != nullptr) note_stage(core, stage);
}

}  // namespace islet::detail
