// Continuous collision: bodies that moved far in a step are swept from where they were to where they are, and stopped at what they would have passed.
#pragma once

#include "../collide/time_of_impact.hpp"
#include "../constraint/solver_body.hpp"
#include "../data/core.hpp"

namespace islet::detail {

/// True if the body may have passed through something: it made a way longer than this share of its smallest half-thickness.
inline constexpr float swept_fraction = 0.5f;

/// The way a body will make in dt seconds if nothing stops it. If it may be held, one slower than what pulls at it makes it in dt is taken to lie on something.
Sweep sweep_ahead(const Core& core, std::uint32_t body, float dt, bool may_be_held);

/// The fraction of their ways at which two shapes touch: time_of_impact of the whole shapes.
float time_to_touch(const Core& core, std::uint32_t shape_a, const Sweep& a, std::uint32_t shape_b, const Sweep& b);

/// Takes the body, whose pose is new already, back to where its core first met a static shape, if it did; `way` becomes what it went. Of the world it
/// changes this body's pose alone, and reads what is at rest alone, so bodies may be stopped side by side.
void stop_at_static(Core& core, std::uint32_t body, SolverBody& way);

/// The same for bullets against all bodies that moved or sleep; boxes follow. `bodies` is by slot.
void stop_bullets(Core& core, const std::uint32_t* body_of, std::uint32_t slot_count, SolverBody* bodies);

// -- what both are made of ------------------------------------------------------------------------------------------------------------

/// The way a body has just made.
Sweep sweep_of(const Core& core, std::uint32_t body, const SolverBody& way);
Sweep at_rest(const Core& core, std::uint32_t body);
/// Holds all points that are within `reach` of a centre on its way.
Aabb box_of_way(Vec2 start, Vec2 way, float reach);
/// The fraction of the way at which `shape` must stop for `other`, or no_impact.
float stop_time(const Core& core, std::uint32_t shape, const Sweep& way, std::uint32_t other, const Sweep& other_way, float end);
/// Puts the body where the way ends.
void place_at_end(Core& core, std::uint32_t body, const Sweep& way, SolverBody& out);

}  // namespace islet::detail
