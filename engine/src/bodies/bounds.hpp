// Fat boxes, extents and mass of bodies, from their shapes.
#pragma once

#include "../collide/manifold.hpp"
#include "../data/core.hpp"
#include "../shapes/shape_types.hpp"

namespace islet::detail {

// Masses and inertias outside these bounds count as the bound, so that no inverse overflows.
inline constexpr float min_mass = 1.0e-12f;     // kg
inline constexpr float min_inertia = 1.0e-15f;  // kg m^2
inline constexpr float max_mass = 1.0e30f;      // kg; the largest inertia too, kg m^2

// A body's list of shapes begins with its newest. Where it is known that all others are as they were, and so is the body, only so many are looked at.
inline constexpr std::uint32_t every_shape = 0xffffffffu;

Transform body_transform(const Core& core, std::uint32_t body);
/// Tight box of a shape in the world.
Aabb shape_aabb(const Core& core, std::uint32_t shape);
/// How far a shape of a body at `t` may move before it leaves the fat box `box`, m; negative if it has left it. A fat box has to hold the shape and a little
/// more: contacts are made before surfaces meet, and each of the two boxes has room for half of that distance.
float room_in_box(const Aabb& box, const Geometry& g, const Transform& t);
/// True if a body with this centre will be put back by the next step, which does not count as its way.
inline bool is_beyond(Vec2 center) { return max(abs(center.x), abs(center.y)) > max_position; }
/// Updates the body's fat boxes, marks those that changed, and sets the slack. Unless `force` is set, a shape keeps a fat box that still holds it.
void update_boxes(Core& core, std::uint32_t body, bool force, std::uint32_t newest = every_shape);
/// The same. Threads that call it at once each pass a counter, which goes up by the shapes that were marked (mark_moved).
void fit_boxes(Core& core, std::uint32_t body, bool force, std::uint32_t* marked, std::uint32_t newest = every_shape);
/// Takes mass, centre and inertia from the shapes. The material keeps its velocity. Updates the extents, too.
void update_mass(Core& core, std::uint32_t body, std::uint32_t newest = every_shape);
/// Sets the mass data and all that follows from it. Call update_boxes afterwards: a new centre changes how the body's position is rounded.
void apply_mass(Core& core, std::uint32_t body, const MassData& mass, std::uint32_t newest = every_shape);
/// The farthest distance of any point from a centre, and the smallest half-thickness of any solid shape, m.
struct Extent {
    float max = 0;
    float min = 0;
};
/// The extent of the body's shapes about its centre of mass.
Extent body_extent(const Core& core, std::uint32_t body, std::uint32_t newest = every_shape);
void update_extent(Core& core, std::uint32_t body, std::uint32_t newest = every_shape);
/// True if the extent of the shape's body would be the same without the shape, which is not its only one.
bool is_within_others(const Core& core, std::uint32_t shape);

}  // namespace islet::detail
