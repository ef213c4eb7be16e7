// Sorting in place, in bounded time.
#pragma once

#include <cstdint>

namespace islet::detail {

/// Sorts in ascending order. Equal items end in some order, always the same one. (Williams, "Algorithm 232: Heapsort", 1964.)
template <class T, class Less>
void heap_sort(T* items, std::uint32_t count, Less&& less) {
    // Moves the item at `top` down until neither item below it is greater.
    const auto sink = [&](std::uint32_t top, std::uint32_t end) {
        const T item = items[top];
        for (std::uint32_t below = 2 * top + 1; below < end; below = 2 * top + 1) {
            if (below + 1 < end && less(items[below], items[below + 1])) ++below;
            if (!less(item, items[below])) break;
            items[top] = items[below];
            top = below;
        }
        items[top] = item;
    };
    for (std::uint32_t i = count / 2; i-- > 0;) sink(i, count);
    for (std::uint32_t end = count; end > 1;) {
        --end;
        const T largest = items[0];
        items[0] = items[end];
        items[end] = largest;
        sink(0, end);
    }
}

}  // namespace islet::detail
