// From a scene's geometry to Box2D 2.4 shapes: what has to be done about their skin, and what cannot be expressed.
#pragma once

#include <memory>

#include <box2d/box2d.h>

#include "box2d_engine.hpp"

namespace islet::engines {

/// The shape, or null if Box2D has none like it (capsules, rounded polygons).
std::unique_ptr<b2Shape> make_box2d_shape(const samples::SceneGeometry& geometry, Skin skin);

/// Mass, centre and inertia about the body's origin, as Box2D computes them from shapes of the scene's sizes.
b2MassData box2d_mass(const samples::SceneBody& body);

}  // namespace islet::engines
