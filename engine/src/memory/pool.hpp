// Pools: slots with generations. Creation and destruction take O(1), and the same calls give the same ids.
//
// A slot is either live (odd generation) or free (even generation). Free slots that were used before form a list through `next_free`, the one freed last first.
// Slots from `high_water` on were never used. An id holds the generation, so a stale id is recognised.
#pragma once

#include <cstdint>

#include "islet/compiler.hpp"

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

/// Frees a live slot: its generation becomes even. The rest of the record stays as it is.
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

/// Calls visit(slot) for each live slot, in ascending order.
template <class T, class Visit>
ISLET_ALWAYS_INLINE inline void for_each_live(const PoolState& pool, const T* slots, Visit&& visit) {
    for (std::uint32_t i = 0; i < pool.high_water; ++i)
        if ((slots[i].generation & 1u) != 0) visit(i);
}

/// Clears a slot but for its generation.
template <class T>
ISLET_ALWAYS_INLINE inline void clear_slot(T& slot) {
    const std::uint32_t generation = slot.generation;
    slot = T{};
    slot.generation = generation;
}

/// True if the object that an id was handed out for is still there.
template <class T, class Id>
bool pool_holds(const PoolState& pool, const T* slots, Id id) {
    return id.index1 != 0 && pool_live(pool, slots, id.index1 - 1) && slots[id.index1 - 1].generation == id.generation;
}

}  // namespace islet::detail
