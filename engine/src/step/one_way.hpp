// One-way shapes: a shape that comes from below passes, a shape that comes from above is held. (Above means along the one-way shape's direction.)
//
// Whether a contact holds depends on where the other shape is along that direction. The contact keeps the decision (contact_passes) from step to step while
// the two shapes are near each other:
//
//     held      once all of the other shape is above the one-way shape's highest point
//     passes    until then: it comes from below or from beside; and again once it is not above and touches nothing, since it has left
//     dropped   passes until the two part or it is above by more than a slop: the pre_solve hook said no to a contact that would have held
#pragma once

#include "../collide/manifold.hpp"
#include "../data/core.hpp"
#include "../shapes/shape_types.hpp"

namespace islet::detail {

inline constexpr float least_above = -linear_slop;  // m: from this height on a shape is above, since a shape at rest may be sunk in by a slop

/// How far the other shape is above the highest point of `shape`, m along its direction; huge if the shape is not one-way.
float height_above(const Core& core, std::uint32_t shape, std::uint32_t other);
/// The same for a geometry that is no shape of the world, at a pose.
float height_above(const Core& core, std::uint32_t shape, const Corners& other, const Transform& pose);
/// The same above where `shape` was dt seconds ago, if its body has kept its velocity.
float height_before(const Core& core, std::uint32_t shape, const Corners& other, const Transform& pose, float dt);
/// Decides whether the contact of a one-way shape holds as the bodies stand, and writes that to its flags. Returns false if the shapes pass each other.
/// `dt` is the time step, s.
bool decide_one_way(const Core& core, std::uint32_t contact, std::uint32_t& flags, float dt);
/// Mends the manifold of a contact that holds, after the narrow phase made it. On a thin shape that the other has sunk into, the normal may lead down: the
/// manifold then gets one point at the other's lowest corner, and the one-way direction as its normal. Points whose normal leads sideways are dropped.
void mend_one_way(Core& core, std::uint32_t contact);

}  // namespace islet::detail
