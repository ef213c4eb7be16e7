// Geometries, each stored once: equal shapes share one record, so a pyramid of 5000 equal boxes keeps one box, in the cache.
#pragma once

#include "../data/core.hpp"

namespace islet::detail {

/// Index of the stored geometry that equals g (bit by bit), with one more reference; null_index if there is no room for a new one.
std::uint32_t share_geometry(Core& core, const Geometry& g);
/// Index of the stored geometry that equals g, or null_index.
std::uint32_t find_geometry(const Core& core, const Geometry& g);
void release_geometry(Core& core, std::uint32_t index);

std::uint32_t geometry_hash(const Geometry& g);

/// Puts every geometry in use into its bucket anew, in order.
void rebuild_buckets(Core& core);

}  // namespace islet::detail
