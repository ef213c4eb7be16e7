// Continuous collision: a body that moved far in a step is followed from where it was to where it is, and stopped at the first shape that it would have passed.
#pragma once

#include "../collide/manifold.hpp"
#include "../collide/time_of_impact.hpp"
#include "../constraint/solver_body.hpp"
#include "../data/core.hpp"

namespace islet::detail {

/// True if the body may have passed through something: it made a way longer than this share of its smallest half-thickness.
inline constexpr float look_fraction = 0.5f;

/// The way that a body will go in dt seconds if nothing stops it. With `may_be_held`, a body slower than the pull on it would make it in dt is taken to lie on
/// something.
BodyPath path_ahead(const Core& core, std::uint32_t body, float dt, bool may_be_held);

/// The fraction of their ways at which two shapes touch: time_of_impact of the whole shapes.
float time_to_touch(const Core& core, std::uint32_t shape_a, const BodyPath& a, std::uint32_t shape_b, const BodyPath& b);

/// Takes a body with its new pose back to where its core first met a static shape, if it met one; `way` becomes the way to there. The function changes nothing
/// but this body's pose, and reads only shapes at rest besides, so bodies may be stopped in parallel.
void stop_at_static(Core& core, std::uint32_t body, SolverBody& way);

/// The same for bullets and all bodies that moved or sleep; fat boxes follow. `bodies` is by slot.
void stop_bullets(Core& core, const PlanIndex* body_of, std::uint32_t slot_count, SolverBody* bodies);

// -- parts of both --------------------------------------------------------------------------------------------------------------------

/// The way that a body has just gone.
BodyPath path_of(const Core& core, std::uint32_t body, const SolverBody& way);
BodyPath at_rest(const Core& core, std::uint32_t body);
/// The box of all points within `reach` of a centre on its way.
Aabb box_of_way(Vec2 start, Vec2 way, float reach);
/// The fraction of the way at which `shape` must stop for `other`, or no_impact.
float stop_time(const Core& core, std::uint32_t shape, const BodyPath& way, std::uint32_t other, const BodyPath& other_way, float end);
/// Puts the body where the way ends.
void place_at_end(Core& core, std::uint32_t body, const BodyPath& way, SolverBody& out);

}  // namespace islet::detail
