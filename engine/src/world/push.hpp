// What may be pushed, and pushing it.
#pragma once

#include "memory/core.hpp"

namespace islet::detail {

inline bool is_enabled(const Core& core, std::uint32_t body) { return (core.bodies[body].flags & body_disabled) == 0; }

/// Forces and impulses act on these alone.
inline bool is_pushable(const Core& core, std::uint32_t body) { return core.is_dynamic(body) && is_enabled(core, body); }

/// A velocity less what the body's locks forbid.
inline Vec2 unlocked(const Body& b, Vec2 v) { return {(b.flags & body_lock_x) != 0 ? 0 : v.x, (b.flags & body_lock_y) != 0 ? 0 : v.y}; }

ISLET_SHARED void kick(Core& core, std::uint32_t i, Vec2 impulse, float angular_impulse) {
    core.motions[i].v += core.poses[i].inv_mass * unlocked(core.bodies[i], impulse);
    core.motions[i].w += core.poses[i].inv_inertia * angular_impulse;
}

}  // namespace islet::detail
