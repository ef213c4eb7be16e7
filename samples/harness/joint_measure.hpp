// Where a joint is and how far it is from what it locks, worked out from the bodies' places and the joint's definition alone, so that engines are
// measured by the same formulas. Only a continuous angle is taken from the engine.
#pragma once

#include "engine.hpp"

namespace islet::samples {

/// What a joint that has just been made is to keep.
JointMemory remember_joint(const Engine& engine, const SceneJoint& joint);

/// Distance of the anchors, way across the axis, or excess of a rod's or rope's length (m), and angle (rad). Beyond an enabled limit counts as
/// error too; what a spring pulls does not.
JointError measure_joint_error(const Engine& engine, std::size_t index);

/// The anchors in the world: of a mouse joint the target and the point that is pulled.
struct Anchors {
    Vec2 a, b;
};
Anchors anchors_of(const Engine& engine, std::size_t index);

}  // namespace islet::samples
