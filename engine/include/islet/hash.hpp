// Ids as keys of unordered containers: std::unordered_map<islet::BodyId, Player, islet::IdHash>.
#pragma once

#include <cstddef>
#include <cstdint>

#include "islet/joints.hpp"
#include "islet/types.hpp"

ISLET_API_BEGIN
namespace islet {

/// Hashes the id of a body, a shape or a joint: its slot and its generation, which together name an object for good.
struct IdHash {
    template <class Id>
    constexpr std::size_t operator()(const Id& id) const noexcept {
        const std::uint64_t mixed = (std::uint64_t{id.generation} << 32 | id.index1) * 0x9e3779b97f4a7c15u;
        return static_cast<std::size_t>(mixed >> 32 ^ mixed);
    }
};

}  // namespace islet
ISLET_API_END
