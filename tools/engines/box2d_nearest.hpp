// What a user of Box2D 2.4 would build instead of the shapes and joints that it has not, so that speed can be compared on scenes that use them.
//
//   capsule            octagon through its ends and sides
//   rounded polygon    the polygon grown by its radius, corners cut
//   spring of a hinge or slider     left out
//   friction beside a motor         left out
//
// Each stands in with a single shape and fewer constraints: the substitute is never more work than the original.
#pragma once

#include "harness/scene.hpp"

namespace islet::engines {

samples::SceneBody box2d_nearest(samples::SceneBody body);
samples::SceneJoint box2d_nearest(samples::SceneJoint joint);
samples::Scene box2d_nearest(samples::Scene scene);

}  // namespace islet::engines
