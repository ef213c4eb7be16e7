// Sets of bodies, joined pair by pair.
#pragma once

#include "../data/parallel.hpp"

namespace islet::detail {

/// Union-find with path halving. The smallest index of a set is its root, so the roots do not depend on the order in which pairs were joined.
struct UnionFind {
    std::uint32_t* parent;  // of each item; a root is its own

    /// An item's parent, which another thread may be replacing.
    std::uint32_t up_from(std::uint32_t i) const {
#if ISLET_SHARES_WORDS
        return __atomic_load_n(parent + i, __ATOMIC_RELAXED);
#else
        return parent[i];
#endif
    }

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

#if ISLET_SHARES_WORDS
/// The sets of a UnionFind while several threads join them. A parent is only ever replaced by one of its own ancestors, and only a root gets one of another
/// set, so whatever a thread reads is an ancestor still. (Jaiganesh and Burtscher, "A high-performance connected components implementation for GPUs", 2018.)
struct SharedUnionFind : UnionFind {
    std::uint32_t root_of(std::uint32_t i) const {
        for (std::uint32_t up = up_from(i); up != i;) {
            const std::uint32_t next = up_from(up);
            if (next != up) __atomic_store_n(parent + i, next, __ATOMIC_RELAXED);
            i = up;
            up = next;
        }
        return i;
    }

    /// Joins the sets of two items. Each turn but the last found that another thread has just joined a root to another set: there are fewer than items.
    void join(std::uint32_t a, std::uint32_t b) const {
        for (;;) {
            a = root_of(a);
            b = root_of(b);
            if (a == b) return;
            std::uint32_t larger = a < b ? b : a;
            const std::uint32_t at = larger, smaller = a < b ? a : b;
            if (__atomic_compare_exchange_n(parent + at, &larger, smaller, false, __ATOMIC_RELAXED, __ATOMIC_RELAXED)) return;
        }
    }
};
#endif

}  // namespace islet::detail
