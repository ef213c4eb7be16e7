// Actions and observations of one world of a fleet.
#pragma once

#include "islet/fleet.hpp"

namespace islet::detail {

/// Columns that a sense fills; 0 if its kind is unknown.
std::uint32_t columns_of(SenseKind kind);

/// Whether kind, numbers and ids are as they must be. Whether an id's object is there, each world asks.
Error check_drive(const Drive& drive);
Error check_sense(const Sense& sense);

/// Does what the actions of one world say: a number for each drive.
void act(World& world, span<const Drive> drives, const float* actions);

/// Fills the row of one world: columns(senses) numbers.
void observe(const World& world, span<const Sense> senses, float* row);

}  // namespace islet::detail
