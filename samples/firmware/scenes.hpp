// Small worlds. All numbers are written out: nothing here is computed differently on another machine.
#pragma once

#include <islet/islet.hpp>

namespace firmware {

/// Room for each of the scenes below.
inline constexpr islet::Capacity scene_capacity = {.bodies = 68, .shapes = 68, .contacts = 256, .joints = 16, .geometries = 16};

/// A pyramid of ten rows of boxes, a metre each, which never sleeps: what a step costs.
void build_pyramid(islet::World& world);
/// A ragdoll of eleven bones that falls on the ground: capsules and hinges with limits, friction and springs.
void build_ragdoll(islet::World& world);
/// Sixty-four balls that fall into a trough.
void build_circles(islet::World& world);
/// Every kind of shape, joint and surface: that all of it comes to the same everywhere, and how large a program is that uses it all.
void build_machine(islet::World& world);
/// The same solved by contacts in order, in blocks, with shock propagation, as often as a tolerance asks: all that the solver has.
void build_ordered_machine(islet::World& world);

}  // namespace firmware
