// Culling: what tells quickly that a shape is part of no new pair.
#pragma once

#include <cstdint>

#include "../math/scalar.hpp"
#include "islet/math.hpp"
#include "islet/types.hpp"

namespace islet::detail {

/// The filters of some shapes, summed up.
struct FilterSum {
    std::uint32_t categories = 0, masks = 0;  // that any has

    void add(const Filter& filter) {
        categories |= filter.category;
        masks |= filter.mask;
    }
    void add(const FilterSum& other) {
        categories |= other.categories;
        masks |= other.masks;
    }
    // True if a filter may agree with another of those summed up.
    bool may_agree(const Filter& filter) const { return filter.group > 0 || ((filter.mask & categories) != 0 && (filter.category & masks) != 0); }
};

/// Which parts of an area hold boxes that changed: 64 times 64 cells, a bit each.
struct ChangedCells {
    static constexpr std::uint32_t least_shapes = 128;  // that make a look at cells pay
    static constexpr std::uint32_t share = 16;          // of the shapes, one in so many may have a changed box

    Vec2 origin, scale;  // m; cells per m
    std::uint64_t rows[64] = {};

    explicit ChangedCells(const Aabb& area) : origin(area.lower) {
        const Vec2 size = area.upper - area.lower;
        scale = {63.0f / max(size.x, 1.0f), 63.0f / max(size.y, 1.0f)};
    }

    // Calls visit(row, bits) for the cells of a box. Rounding never changes the order of two places, so boxes that overlap have a cell in common.
    template <class Visit>
    ISLET_ALWAYS_INLINE void for_cells(const Aabb& box, Visit&& visit) const {
        const std::uint32_t left = cell(box.lower.x, origin.x, scale.x), right = cell(box.upper.x, origin.x, scale.x);
        const std::uint64_t bits = (~std::uint64_t{0} >> (63 - (right - left))) << left;
        const std::uint32_t top = cell(box.upper.y, origin.y, scale.y);
        for (std::uint32_t row = cell(box.lower.y, origin.y, scale.y); row <= top; ++row) visit(row, bits);
    }
    static std::uint32_t cell(float at, float from, float per_metre) { return static_cast<std::uint32_t>(clamp((at - from) * per_metre, 0.0f, 63.0f)); }

    void add(const Aabb& box) {
        for_cells(box, [&](std::uint32_t row, std::uint64_t bits) { rows[row] |= bits; });
    }
    bool reach(const Aabb& box) const {
        std::uint64_t common = 0;
        for_cells(box, [&](std::uint32_t row, std::uint64_t bits) { common |= rows[row] & bits; });
        return common != 0;
    }
};

}  // namespace islet::detail
