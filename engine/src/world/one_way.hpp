// One-way shapes: what comes from below passes, what came from above is held.
//
// Whether a contact holds is decided by where the other shape is along the one-way shape's direction, and kept with the contact (contact_passes) from step
// to step while the two are near each other:
//
//     held      once all of the other shape is above the one-way shape's highest point
//     passes    until then: it comes from below or from beside; and again once it is not above and touches nothing, since it has left
//     dropped   passes until the two part or it is above by more than a slop: the pre_solve hook said no to a contact that would have held
#pragma once

#include "collide/corners.hpp"
#include "memory/core.hpp"

namespace islet::detail {

/// How far the other shape is above the highest point of `shape`, m along its direction; huge if the shape is not one-way.
float height_above(const Core& core, std::uint32_t shape, std::uint32_t other);
/// The same for what is no shape of the world, at a pose.
float height_above(const Core& core, std::uint32_t shape, const Corners& other, const Transform& pose);
/// Decides anew whether the contact of a one-way shape holds, with the bodies as they stand; false: the shapes pass each other.
bool decide_one_way(const Core& core, std::uint32_t contact, std::uint32_t& flags, float dt);
/// Of a contact that holds, after its manifold was made: gives a normal that does not lead up, which the narrow phase finds on a thin shape that the other has sunk into, its direction.
void mend_one_way(Core& core, std::uint32_t contact);

}  // namespace islet::detail
