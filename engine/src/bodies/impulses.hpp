// Which bodies can be pushed, and pushing them.
#pragma once

#include "../calls/checks.hpp"
#include "../data/core.hpp"
#include "../solver/free_motion.hpp"

namespace islet::detail {

inline bool is_enabled(const Core& core, std::uint32_t body) { return (core.bodies[body].flags & body_disabled) == 0; }

/// Forces and impulses act only on these bodies.
inline bool is_pushable(const Core& core, std::uint32_t body) { return core.is_dynamic(body) && is_enabled(core, body); }

/// A velocity without the components that the body's locks forbid.
inline Vec2 unlocked(const Body& b, Vec2 v) { return {(b.flags & body_lock_x) != 0 ? 0 : v.x, (b.flags & body_lock_y) != 0 ? 0 : v.y}; }

/// A sum that overflows stays at the largest number, and NaN becomes zero: a world may hold finite numbers only, or no image of it could be loaded.
ISLET_SHARED float capped(float a) { return within(a, no_limit); }
inline Vec2 capped(Vec2 a) { return {capped(a.x), capped(a.y)}; }

ISLET_SHARED void kick(Core& core, std::uint32_t i, Vec2 impulse, float angular_impulse) {
    Motion& m = core.motions[i];
    m.v = capped(m.v + core.poses[i].inv_mass * unlocked(core.bodies[i], impulse));
    m.w = capped(m.w + core.poses[i].inv_inertia * angular_impulse);
}

ISLET_SHARED void pull(Core& core, std::uint32_t i, Vec2 force, float torque) {
    Motion& m = core.motions[i];
    m.force = capped(m.force + force);
    m.torque = capped(m.torque + torque);
}

}  // namespace islet::detail
