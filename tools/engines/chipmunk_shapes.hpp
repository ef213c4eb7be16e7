// From a scene's shapes and bodies to Chipmunk's shapes and masses, and what cannot be expressed.
#pragma once

#include <vector>

#include <chipmunk/chipmunk.h>

#include "chipmunk_engine.hpp"

namespace islet::engines {

inline cpVect to_cp(Vec2 v) { return cpv(static_cast<cpFloat>(v.x), static_cast<cpFloat>(v.y)); }
inline Vec2 from_cp(cpVect v) { return {static_cast<float>(v.x), static_cast<float>(v.y)}; }

/// The shapes for one shape of the scene, material and filter set, not yet in a space: one, or one for each link of a chain.
std::vector<cpShape*> make_chipmunk_shapes(cpBody* body, const samples::SceneShape& shape);

/// Mass, centre and inertia about that centre, as Islet has them: Chipmunk's own inertias of capsules and rounded polygons are approximate.
MassData chipmunk_mass(const samples::SceneBody& body);

/// m/s, below which bodies of the scene may fall asleep: the threshold of its dynamic bodies, of which Chipmunk takes one for all.
double chipmunk_idle_speed(const samples::Scene& scene);

}  // namespace islet::engines
