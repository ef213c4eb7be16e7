// The complementarity problem of a few rows, solved exactly.
//
// Every row of a block is at its lower bound, at its upper bound, or free with w = 0. Of n rows there are 3^n such choices; the right one makes the solution
// that of linear equations. The search changes the rows that are wrong, first all of them at once, then only the first of them. This ends at the solution if M
// is a P-matrix (Murty 1974; with both kinds of step: Judice and Pires 1994). If it fails, all choices are tried.
#pragma once

#include "../lcp/lu.hpp"

namespace islet::lcp {

/// The problem of one block's rows, with all other rows held. `friction` names rows within the block; a friction row whose normal row is outside has ordinary
/// bounds here.
template <class T>
struct Block {
    std::uint32_t size;
    T a[max_block_rows][max_block_rows];
    T b[max_block_rows];
    T lo[max_block_rows];
    T hi[max_block_rows];  // for a friction row its coefficient
    std::uint32_t friction[max_block_rows];
};

enum class Place : std::uint8_t { at_lo, free, at_hi };

template <class T>
Bounds<T> block_bounds(const Block<T>& block, std::uint32_t i, const T* y) {
    if (block.friction[i] == no_row) return {block.lo[i], block.hi[i]};
    const T limit = block.hi[i] * larger(y[block.friction[i]], T(0));
    return {-limit, limit};
}

/// Finds the y of a choice of places; returns false if there is no unique one.
template <class T>
bool solve_places(const Block<T>& block, const Place* places, T* y) {
    // A row at a bound is a constant; a friction row is a multiple of its normal row, which is free or itself a constant.
    T slope[max_block_rows];
    std::uint32_t index[max_block_rows], rows[max_block_rows], count = 0;
    for (std::uint32_t i = 0; i < block.size; ++i) {
        slope[i] = T(0);
        y[i] = T(0);
        if (places[i] == Place::free) {
            index[i] = count;
            rows[count++] = i;
        } else if (block.friction[i] == no_row) {
            y[i] = places[i] == Place::at_lo ? block.lo[i] : block.hi[i];
            if (!is_finite(y[i])) return false;
        }
    }
    for (std::uint32_t i = 0; i < block.size; ++i) {
        if (places[i] == Place::free || block.friction[i] == no_row) continue;
        slope[i] = places[i] == Place::at_lo ? -block.hi[i] : block.hi[i];
        if (places[block.friction[i]] == Place::free) continue;
        y[i] = slope[i] * larger(y[block.friction[i]], T(0));
        slope[i] = T(0);
    }

    T a[max_block_rows * max_block_rows], b[max_block_rows], scales[max_block_rows];
    for (std::uint32_t k = 0; k < count; ++k) {
        const std::uint32_t i = rows[k];
        b[k] = -block.b[i];
        for (std::uint32_t j = 0; j < count; ++j) a[k * max_block_rows + j] = block.a[i][rows[j]];
        for (std::uint32_t j = 0; j < block.size; ++j) {
            if (places[j] == Place::free) continue;
            b[k] -= block.a[i][j] * y[j];
            if (slope[j] != T(0)) a[k * max_block_rows + index[block.friction[j]]] += block.a[i][j] * slope[j];
        }
    }
    if (solve_linear(a, max_block_rows, count, b, scales) != no_row) return false;
    for (std::uint32_t k = 0; k < count; ++k) y[rows[k]] = b[k];
    for (std::uint32_t i = 0; i < block.size; ++i)
        if (slope[i] != T(0)) y[i] = slope[i] * larger(y[block.friction[i]], T(0));
    return true;
}

/// Corrects the place of the first row that is wrong, or of all wrong rows; returns false if none is wrong.
template <class T>
bool exchange_places(const Block<T>& block, const T* y, bool all, Place* places) {
    bool changed = false;
    T size = T(0);  // of y; rounding is measured by it
    for (std::uint32_t i = 0; i < block.size; ++i) size = larger(size, magnitude(y[i]));
    for (std::uint32_t i = 0; i < block.size; ++i) {
        T w = block.b[i], terms = magnitude(block.b[i]);
        for (std::uint32_t j = 0; j < block.size; ++j) {
            w += block.a[i][j] * y[j];
            terms += magnitude(block.a[i][j] * y[j]);
        }
        const Bounds<T> bounds = block_bounds(block, i, y);
        const T slack = T(32) * Numbers<T>::epsilon;
        Place right = places[i];
        if (places[i] == Place::free) {
            if (y[i] < bounds.lo - slack * size) right = Place::at_lo;
            if (y[i] > bounds.hi + slack * size) right = Place::at_hi;
        } else if (bounds.lo < bounds.hi) {
            if (places[i] == Place::at_lo ? w < -slack * terms : w > slack * terms) right = Place::free;
        }
        if (right == places[i]) continue;
        places[i] = right;
        changed = true;
        if (!all) return true;
    }
    return changed;
}

template <class T>
bool search_from(const Block<T>& block, Place* places, T* y) {
    const std::uint32_t together = block.size + 2, patience = 4 * together;
    for (std::uint32_t round = 0; round < patience; ++round) {
        if (!solve_places(block, places, y)) return false;
        if (!exchange_places(block, y, round < together, places)) return true;
    }
    return false;
}

template <class T>
bool search_all(const Block<T>& block, T* y) {
    std::uint32_t choices = 1;
    for (std::uint32_t i = 0; i < block.size; ++i) choices *= 3;
    for (std::uint32_t choice = 0; choice < choices; ++choice) {
        Place places[max_block_rows] = {};
        std::uint32_t rest = choice;
        for (std::uint32_t i = 0; i < block.size; ++i, rest /= 3) places[i] = static_cast<Place>(rest % 3);
        if (solve_places(block, places, y) && !exchange_places(block, y, false, places)) return true;
    }
    return false;
}

/// Starts from y and leaves the solution in it. Returns false if it finds none: there is none, or the equations of the free rows have no unique solution.
template <class T>
bool solve_block(const Block<T>& block, T* y) {
    Place places[max_block_rows] = {};
    for (std::uint32_t i = 0; i < block.size; ++i) {
        const Bounds<T> b = block_bounds(block, i, y);
        places[i] = y[i] <= b.lo ? Place::at_lo : (y[i] >= b.hi ? Place::at_hi : Place::free);
    }
    T found[max_block_rows];
    if (!search_from(block, places, found) && !search_all(block, found)) return false;
    for (std::uint32_t i = 0; i < block.size; ++i) {
        const Bounds<T> b = block_bounds(block, i, found);
        y[i] = clamp(found[i], b.lo, b.hi);
    }
    return true;
}

}  // namespace islet::lcp
