// Fat boxes, extents and mass of bodies, from their shapes.
#pragma once

#include "../collide/manifold.hpp"
#include "../data/core.hpp"
#include "../shapes/shape_types.hpp"

namespace islet::detail {

// Lighter and heavier bodies are taken for this light and this heavy, so that no inverse overflows.
inline constexpr float min_mass = 1.0e-12f;     // kg
inline constexpr float min_inertia = 1.0e-15f;  // kg m^2
inline constexpr float max_mass = 1.0e30f;      // kg; the largest inertia too, kg m^2

Transform body_transform(const Core& core, std::uint32_t body);
/// Tight box of a shape in the world.
Aabb shape_aabb(const Core& core, std::uint32_t shape);
/// Sets the body's fat boxes anew, marks those that changed, and sets the slack. Unless forced, a fat box that still holds the shape is kept.
void update_boxes(Core& core, std::uint32_t body, bool force);
/// The same, but if `changed` is given writes to it, by shape, whether its box changed, for mark_changed: marks are shared, so bodies that are moved side
/// by side are marked afterwards.
void fit_boxes(Core& core, std::uint32_t body, bool force, bool* changed);
void mark_changed(Core& core, std::uint32_t body, const bool* changed);
/// Mass, centre and inertia from the shapes, unless overridden; keeps the velocity of the material. Updates the extents too.
void update_mass(Core& core, std::uint32_t body);
/// Sets mass data as given and all that follows from it. Call update_boxes afterwards: a new centre changes how exactly the body's place is known.
void apply_mass(Core& core, std::uint32_t body, const MassData& mass);
/// Farthest distance of any point from a centre, and the smallest half-thickness of what is solid, m.
struct Extent {
    float max = 0;
    float min = 0;
};
/// Of the body's shapes about its centre of mass.
Extent body_extent(const Core& core, std::uint32_t body);
/// How far the body may move now without one of its shapes leaving its fat box, m.
float slack_of(const Core& core, std::uint32_t body);

}  // namespace islet::detail
