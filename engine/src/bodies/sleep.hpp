// Falling asleep and waking up. A body that falls asleep leaves the set of awake bodies, and its shapes move into the tree of resting shapes. Its contacts
// leave the set of awake contacts, unless the other body is awake.
#pragma once

#include "../bodies/bounds.hpp"
#include "../data/core.hpp"

namespace islet::detail {

inline constexpr float time_to_sleep = 0.5f;   // s at rest before an island may fall asleep
inline constexpr float time_to_learn = 0.25f;  // s at rest before its contacts learn their loads (step/contact_update.cpp)

/// Wakes a body and, along touching contacts and joints, every dynamic body of its island. No effect on static bodies.
void wake_island(Core& core, std::uint32_t body, Arena arena);
/// The same if `wake` is set. Returns whether the body, which moves, is awake then.
inline bool wake_if(Core& core, std::uint32_t body, bool wake) {
    if (wake) wake_island(core, body, core.arena());
    return wake || core.is_awake(body);
}
/// Wakes the islands of bodies that touch the body or are joined to it; the body itself stays as it is.
void wake_neighbors(Core& core, std::uint32_t body, Arena arena);
/// The same, and destroys the body's contacts.
void end_contacts(Core& core, std::uint32_t body);
/// Puts a dynamic body and its island to sleep, unless it is held awake by a kinematic body that moves.
void sleep_island(Core& core, std::uint32_t body, Arena arena);
/// Puts one body to sleep with zero velocity.
void put_to_sleep(Core& core, std::uint32_t body);

/// Updates the body's fat boxes after its mass or its shapes changed; if it is not awake, those in the tree, too.
void refit_boxes(Core& core, std::uint32_t body, std::uint32_t newest = every_shape);

/// Moves the body's shapes into the tree of resting shapes, or out of it.
void rest_shapes(Core& core, std::uint32_t body, std::uint32_t newest = every_shape);
void unrest_shapes(Core& core, std::uint32_t body);

}  // namespace islet::detail
