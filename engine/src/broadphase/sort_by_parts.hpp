// Sorting boxes by their keys, by all workers.
#pragma once

#include "../data/parallel.hpp"
#include "../math/key_sort.hpp"

namespace islet::detail {

/// How boxes are cut for workers.
using BoxCut = RangeCut<8>;

/// What sort_by_key does, by parts of the items, which stand in the order of their numbers: a radix sort by digits of eight bits, in which each part counts its
/// digits, and knows from the counts of all where its items go. Returns where they are sorted: `items` or `spare`. `counts` has room for sort_digits numbers.
inline KeyedItem* sort_by_parts(const Core& core, const BoxCut& cut, KeyedItem* items, KeyedItem* spare, std::uint32_t n, std::uint32_t* counts) {
    constexpr std::uint32_t digits = 256;
    static_assert(!sorts_by_digits || BoxCut::room * digits <= sort_digits);
    for (std::uint32_t shift = 32; shift < 64; shift += 8) {
        const auto digit_of = [&](KeyedItem item) { return static_cast<std::uint32_t>(item >> shift) & (digits - 1); };
        for_ranges(core, n, cut.grain, [&](std::uint32_t first, std::uint32_t end) {
            std::uint32_t* const count = counts + cut.of(first) * digits;
            std::memset(count, 0, digits * sizeof *count);
            for (std::uint32_t i = first; i < end; ++i) ++count[digit_of(items[i])];
        });
        std::uint32_t place = 0, most = 0;
        for (std::uint32_t d = 0; d < digits; ++d) {
            const std::uint32_t first = place;
            for (std::uint32_t p = 0; p < cut.count; ++p) {
                std::uint32_t& count = counts[p * digits + d];
                const std::uint32_t items_of_part = count;
                count = place;
                place += items_of_part;
            }
            most = most < place - first ? place - first : most;
        }
        if (most == n) continue;  // all alike, as the highest digit often is
        for_ranges(core, n, cut.grain, [&](std::uint32_t first, std::uint32_t end) {
            std::uint32_t* const to = counts + cut.of(first) * digits;
            for (std::uint32_t i = first; i < end; ++i) spare[to[digit_of(items[i])]++] = items[i];
        });
        KeyedItem* const sorted = spare;
        spare = items;
        items = sorted;
    }
    return items;
}

}  // namespace islet::detail
