// Ids as keys of std::unordered_map and std::unordered_set. Not part of islet.hpp, since <functional> needs a whole standard library.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "islet/joints.hpp"
#include "islet/types.hpp"

ISLET_API_BEGIN
namespace islet::detail {

/// Hashes slot and generation, which together name an object for good.
template <class Id>
struct IdHash {
    std::size_t operator()(Id id) const noexcept { return std::hash<std::uint64_t>{}(std::uint64_t{id.generation} << 32 | id.index1); }
};

}  // namespace islet::detail

template <>
struct std::hash<islet::BodyId> : islet::detail::IdHash<islet::BodyId> {};
template <>
struct std::hash<islet::ShapeId> : islet::detail::IdHash<islet::ShapeId> {};
template <>
struct std::hash<islet::JointId> : islet::detail::IdHash<islet::JointId> {};
ISLET_API_END
