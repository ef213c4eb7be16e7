// Sets of bodies, joined pair by pair.
#pragma once

#include <cstdint>

namespace islet::detail {

/// Union-find with path halving. The smallest index of a set is its root, so the roots do not depend on the order in which pairs were joined.
struct UnionFind {
    std::uint32_t* parent;  // of each item; a root is its own

    std::uint32_t root_of(std::uint32_t i) const {
        while (parent[i] != i) {
            parent[i] = parent[parent[i]];
            i = parent[i];
        }
        return i;
    }

    /// Joins the sets of two roots; returns the root of both.
    std::uint32_t join(std::uint32_t a, std::uint32_t b) const {
        const std::uint32_t root = a < b ? a : b;
        parent[a < b ? b : a] = root;
        return root;
    }
};

}  // namespace islet::detail
