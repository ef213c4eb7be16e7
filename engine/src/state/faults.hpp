// What is unsound in a world, if anything: the invariants behind World::validate, and the gate that images from outside must pass. So no index is
// followed before it is checked, no walk goes on longer than there are records, and no number is trusted.
#pragma once

#include "../data/core.hpp"

namespace islet::detail {

/// Null, or a sentence naming what is broken in the world's arrays. Takes scratch for a word a shape and a joint, two a body,
/// and for a set of pairs.
const char* find_fault(const Core& core, Arena scratch);

/// The same for the numbers of one live record.
const char* fault_in_numbers(const State& state);
const char* fault_in_numbers(const Body& body, const Pose& pose, const Motion& motion);
const char* fault_in_numbers(const Shape& shape, const Aabb& box);
const char* fault_in_numbers(const Geometry& geometry);
const char* fault_in_numbers(const ContactManifold& manifold);
const char* fault_in_numbers(const Joint& joint);

}  // namespace islet::detail
