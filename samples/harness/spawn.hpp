// From a scene's plain lists to the bodies and joints of a World.
#pragma once

#include <span>
#include <vector>

#include "scene.hpp"

namespace islet::samples {

/// Makes the body with its shapes. If something will not do, world.last_error() says so, as for everything here.
BodyId spawn(World& world, const SceneBody& body);
/// Makes the joint; its indices count in `bodies`, those of a gear in `joints`.
JointId spawn(World& world, const SceneJoint& joint, std::span<const BodyId> bodies, std::span<const JointId> joints);

}  // namespace islet::samples
