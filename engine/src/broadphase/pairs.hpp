// Finding pairs: every two shapes whose fat boxes began to overlap get a contact.
#pragma once

#include "../data/core.hpp"

namespace islet::detail {

inline constexpr float max_box_margin = 0.05f;  // m, by which a fat box exceeds its shape: so far a body can move before its pairs are found anew

/// Creates contacts for the shapes whose fat boxes changed since the last call, and for fast bodies with the static shapes they may reach within dt.
/// The cost follows what moved; nothing moved costs nothing. Pairs that find no room are counted in report.dropped_contacts and tried again in every
/// later call. The search ends once as many were dropped as the capacity has contacts, so its cost does not grow with the number of pairs that find no room.
void find_pairs(Core& core, float dt);

/// The fat box of a shape of a fast body, grown by as far as the body may come in dt.
Aabb box_ahead(const Core& core, std::uint32_t shape, float dt);

/// A fast body is alone (pose_alone) if nothing at rest is so near to its shapes, m: while it goes no farther there is nothing it could pass through.
inline float surroundings(const Pose& pose) { return 4.0f * pose.max_extent; }

/// Marks a shape's fat box as changed.
void mark_moved(Core& core, std::uint32_t shape);

}  // namespace islet::detail
