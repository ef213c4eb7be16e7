// Slots with generations: creation and destruction in O(1), lowest memory first, the same ids after the same calls.
//
// A slot is either live (odd generation) or free (even generation). Free slots that were used before form a list through `next_free`, last
// freed first; slots at and above `high_water` were never used. An id holds the generation, so a stale one is recognised.
#pragma once

#include <cstdint>

namespace islet::detail {

inline constexpr std::uint32_t null_index = 0xffffffffu;

struct PoolState {
    std::uint32_t free_head = null_index;
    std::uint32_t high_water = 0;
    std::uint32_t count = 0;
};

/// Takes a slot and makes its generation odd, or returns null_index if the pool is full. T needs `generation` and `next_free`.
template <class T>
std::uint32_t pool_take(PoolState& pool, T* slots, std::uint32_t capacity) {
    std::uint32_t index = pool.free_head;
    if (index != null_index) {
        pool.free_head = slots[index].next_free;
    } else {
        if (pool.high_water == capacity) return null_index;
        index = pool.high_water++;
        slots[index].generation = 0;
    }
    ++slots[index].generation;
    ++pool.count;
    return index;
}

/// Gives a live slot back; its generation becomes even. Nothing else in the slot is touched.
template <class T>
void pool_give(PoolState& pool, T* slots, std::uint32_t index) {
    ++slots[index].generation;
    slots[index].next_free = pool.free_head;
    pool.free_head = index;
    --pool.count;
}

template <class T>
bool pool_live(const PoolState& pool, const T* slots, std::uint32_t index) {
    return index < pool.high_water && (slots[index].generation & 1u) != 0;
}

}  // namespace islet::detail
