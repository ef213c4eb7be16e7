// Sorting in place, and sorting few or many items by a 32-bit key, for which items with equal keys stay in order.
#pragma once

#include <cstdint>
#include <cstring>

#include "islet/layout.hpp"

namespace islet::detail {

/// Sorts in ascending order, in place: by insertion, after coarser passes over items that are far apart (Shell 1959, with Knuth's gaps). Best for few items.
/// Equal items end in some order, always the same one.
template <class Item, class Less>
void sort_by_gaps(Item* items, std::uint32_t count, Less&& less) {
    std::uint32_t gap = 1;
    while (gap < count / 9) gap = 3 * gap + 1;
    for (; gap > 0; gap /= 3) {
        for (std::uint32_t i = gap; i < count; ++i) {
            const Item item = items[i];
            std::uint32_t to = i;
            for (; to >= gap && less(item, items[to - gap]); to -= gap) items[to] = items[to - gap];
            items[to] = item;
        }
    }
}

/// A key, and below it the item's number. All are different, so every sort gives the same order.
using KeyedItem = std::uint64_t;

constexpr KeyedItem keyed(std::uint32_t key, std::uint32_t number) { return KeyedItem{key} << 32 | number; }
constexpr std::uint32_t number_of(KeyedItem item) { return static_cast<std::uint32_t>(item); }

/// A least-significant-digit radix sort, whose cost is fixed. The items must stand in the order of their numbers. Returns where they are sorted: `items` or
/// `spare`. `counts` has room for sort_digits numbers.
template <std::uint32_t digit_bits>
KeyedItem* sort_by_digits(KeyedItem* items, KeyedItem* spare, std::uint32_t count, std::uint32_t* counts) {
    constexpr std::uint32_t digits = 1u << digit_bits;
    for (std::uint32_t shift = 32; shift < 64; shift += digit_bits) {
        const auto digit_of = [&](KeyedItem item) { return static_cast<std::uint32_t>(item >> shift) & (digits - 1); };
        std::memset(counts, 0, sizeof *counts * digits);
        for (std::uint32_t i = 0; i < count; ++i) ++counts[digit_of(items[i])];
        if (count == 0 || counts[digit_of(items[0])] == count) continue;  // all alike, as the highest digit often is
        std::uint32_t sum = 0;
        for (std::uint32_t d = 0; d < digits; ++d) {
            const std::uint32_t c = counts[d];
            counts[d] = sum;
            sum += c;
        }
        for (std::uint32_t i = 0; i < count; ++i) spare[counts[digit_of(items[i])]++] = items[i];
        KeyedItem* const sorted = spare;
        spare = items;
        items = sorted;
    }
    return items;
}

// Where memory is small so are worlds, and one sort is enough.
inline constexpr bool sorts_by_digits = sort_digits > 0;
static_assert(!sorts_by_digits || sort_digits == 1u << 11);
inline constexpr std::uint32_t few_items = 96;     // up to so many, sorting by gaps takes fewest instructions
inline constexpr std::uint32_t many_items = 1500;  // from so many on, passes over long digits pay for their long tables of counts

/// Sorts items that stand in the order of their numbers, in the way that is best for so many. Returns where they are sorted: `items` or `spare`.
inline KeyedItem* sort_by_key(KeyedItem* items, [[maybe_unused]] KeyedItem* spare, std::uint32_t count, [[maybe_unused]] std::uint32_t* counts) {
    if constexpr (sorts_by_digits) {
        if (count >= many_items) return sort_by_digits<11>(items, spare, count, counts);
        if (count > few_items) return sort_by_digits<8>(items, spare, count, counts);
    }
    sort_by_gaps(items, count, [](KeyedItem a, KeyedItem b) { return a < b; });
    return items;
}

}  // namespace islet::detail
