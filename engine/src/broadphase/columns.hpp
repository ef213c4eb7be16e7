// Boxes as columns of numbers, sorted along an axis, so that a box can be compared with many at once.
#pragma once

#include "../math/lanes.hpp"
#include "islet/layout.hpp"

namespace islet::detail {

/// Boxes sorted by `lower`. After the last one stand as many boxes as there can be lanes, which begin beyond all others: so whole lanes can always be loaded,
/// and every scan ends.
struct Columns {
    float* lower = nullptr;  // along the sorted axis
    float* upper = nullptr;
    float* lower2 = nullptr;  // across it
    float* upper2 = nullptr;
    std::uint32_t* shape = nullptr;
    std::uint32_t* place = nullptr;  // of the box in the columns of all shapes in motion
    std::uint32_t count = 0;
};

/// Writes to `out`, in order, which boxes of `c` from `first` on overlap box i of `from`, up to the first one that begins beyond it; returns how many there
/// are. L has several lanes.
template <class L>
ISLET_LANE std::uint32_t scan_columns(const Columns& c, std::uint32_t first, const Columns& from, std::uint32_t i, std::uint32_t* out) {
    const auto upper = L::splat(from.upper[i]);
    const auto lower2 = L::splat(from.lower2[i]);
    const auto upper2 = L::splat(from.upper2[i]);
    constexpr std::uint32_t all = (1u << L::width) - 1;
    std::uint32_t count = 0;
    for (std::uint32_t j = first;; j += L::width) {
        const std::uint32_t begun = L::bits(L::load(c.lower + j) <= upper);
        const std::uint32_t across = L::bits((L::load(c.lower2 + j) <= upper2) & (L::load(c.upper2 + j) >= lower2));
        count += L::list(begun & across, j, out + count);
        if (begun != all) return count;
    }
}

/// The same with eight lanes (columns_avx2.cpp), for processors with AVX2 alone.
std::uint32_t scan_columns_8(const Columns& c, std::uint32_t first, const Columns& from, std::uint32_t i, std::uint32_t* out);

}  // namespace islet::detail
