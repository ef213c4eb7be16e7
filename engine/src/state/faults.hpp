// Finds what is unsound in a world: the invariants behind World::validate, which images from outside must keep, too. So the checks follow no index before it is
// checked, walk no list longer than there are records, and trust no number.
#pragma once

#include "../data/core.hpp"

namespace islet::detail {

/// Null, or a sentence that says what is broken in the arrays of a world, a Core, or of an image, an ImageView. Takes scratch: a word for each shape and joint,
/// two for each body, and a set of pairs.
template <class AnyCore>
const char* find_fault(const AnyCore& core, Arena scratch);

/// The same for the numbers of one live record.
const char* fault_in_numbers(const State& state);
const char* fault_in_numbers(const Body& body, const Pose& pose, const Motion& motion);
const char* fault_in_numbers(const Shape& shape, const Aabb& box);
const char* fault_in_numbers(const Geometry& geometry);
const char* fault_in_numbers(const ImageManifold& manifold);
const char* fault_in_numbers(const Joint& joint);

}  // namespace islet::detail
