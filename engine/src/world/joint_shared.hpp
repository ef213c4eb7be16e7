// What making joints and changing them share.
#pragma once

#include "../data/core.hpp"

namespace islet::detail {

/// Destroys the contacts that the joint forbids.
void end_forbidden_contacts(Core& core, const Joint& j);

/// The coordinate of a joint that has one, now.
float joint_coordinate(const Core& core, const Joint& j);

}  // namespace islet::detail
