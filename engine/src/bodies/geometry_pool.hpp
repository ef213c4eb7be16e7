// Geometries, each stored once. Equal shapes share one record, so a pyramid of 5000 equal boxes keeps one box, which stays in the cache.
#pragma once

#include "../data/core.hpp"

namespace islet::detail {

/// Stores g, or adds a reference to the stored geometry that equals it bit by bit. Returns its index, or null_index if there is no room.
std::uint32_t share_geometry(Core& core, const Geometry& g);
/// The index of the stored geometry that equals g, or null_index.
std::uint32_t find_geometry(const Core& core, const Geometry& g);
void release_geometry(Core& core, std::uint32_t index);

std::uint32_t geometry_hash(const Geometry& g);

/// Fills the buckets anew with all geometries in use, in order.
void rebuild_buckets(Core& core);

}  // namespace islet::detail
