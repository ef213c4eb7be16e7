// A set of 64-bit keys of fixed capacity: open addressing, linear probing, backward-shift deletion (Knuth, TAOCP vol. 3, 6.4, algorithm R). The table is at
// most half full, so a probe ends soon. Key 0 marks an empty place.
#pragma once

#include <cstdint>

#include "../math/inlining.hpp"

namespace islet::detail {

struct PairSet {
    std::uint64_t* keys = nullptr;
    std::uint32_t mask = 0;  // table size - 1, a power of two minus one

    /// Key of an unordered pair of slots; never 0.
    static std::uint64_t key(std::uint32_t a, std::uint32_t b) {
        const std::uint64_t low = a < b ? a : b;
        const std::uint64_t high = a < b ? b : a;
        return (high + 1) << 32 | low;
    }

    /// Starts loading the place where the key would be, for a lookup soon after.
    void prefetch(std::uint64_t key) const { ISLET_PREFETCH(keys + home(key)); }

    bool contains(std::uint64_t key) const { return keys[find(key)] == key; }

    /// The key must not be in the set, and the set not full.
    void insert(std::uint64_t key) { keys[find(key)] = key; }

    /// The key must be in the set.
    void erase(std::uint64_t key) {
        std::uint32_t hole = find(key);
        for (std::uint32_t i = (hole + 1) & mask; keys[i] != 0; i = (i + 1) & mask) {
            // The key at i may fill the hole only if its home is not cyclically within (hole, i].
            const std::uint32_t from_home = (i - home(keys[i])) & mask;
            const std::uint32_t from_hole = (i - hole) & mask;
            if (from_home >= from_hole) {
                keys[hole] = keys[i];
                hole = i;
            }
        }
        keys[hole] = 0;
    }

private:
    // Multiplicative mixing with the golden ratio; the high bits are the good ones.
    std::uint32_t home(std::uint64_t key) const { return static_cast<std::uint32_t>((key * 0x9e3779b97f4a7c15ull) >> 32) & mask; }

    ISLET_SHARED std::uint32_t find(std::uint64_t key) const {
        std::uint32_t i = home(key);
        while (keys[i] != 0 && keys[i] != key) i = (i + 1) & mask;
        return i;
    }
};

}  // namespace islet::detail
