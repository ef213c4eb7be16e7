// A fixed set of bits over words that live in the world's block: a view, like a span. Walking it visits indices in ascending order.
#pragma once

#include <cstdint>
#include <cstring>

#include "islet/layout.hpp"

namespace islet::detail {

struct BitSet {
    std::uint64_t* words = nullptr;
    std::uint32_t word_count = 0;

    /// Set bits of a word: sums of neighbours two, four and eight bits wide, then all bytes at once. (The compiler's own may be a library call.)
    static std::uint32_t bits_of(std::uint64_t x) {
        x -= x >> 1 & 0x5555555555555555ull;
        x = (x & 0x3333333333333333ull) + (x >> 2 & 0x3333333333333333ull);
        x = (x + (x >> 4)) & 0x0f0f0f0f0f0f0f0full;
        return static_cast<std::uint32_t>((x * 0x0101010101010101ull) >> 56);
    }

    bool test(std::uint32_t i) const { return (words[i / 64] >> (i % 64) & 1) != 0; }
    void set(std::uint32_t i) const { words[i / 64] |= std::uint64_t{1} << (i % 64); }
    void clear(std::uint32_t i) const { words[i / 64] &= ~(std::uint64_t{1} << (i % 64)); }
    void assign(std::uint32_t i, bool on) const { on ? set(i) : clear(i); }
    void clear_all() const { std::memset(words, 0, std::size_t{word_count} * 8); }

    std::uint32_t count() const {
        return count_in(0, word_count);
    }
    /// Bits set in the words first <= w < end.
    std::uint32_t count_in(std::uint32_t first, std::uint32_t end) const {
        std::uint32_t n = 0;
        for (std::uint32_t w = first; w < end; ++w) n += bits_of(words[w]);
        return n;
    }

    /// Calls visit(index) for each set bit in ascending order. A word is read once before its bits are visited, so `visit` may clear
    /// bits freely; bits set in later words are visited, those set in the current one are not.
    template <class Visit>
    [[gnu::always_inline]] void for_each(Visit&& visit) const {
        for_each_in(0, word_count, visit);
    }
    /// The same for the words first <= w < end only.
    template <class Visit>
    [[gnu::always_inline]] void for_each_in(std::uint32_t first, std::uint32_t end, Visit&& visit) const {
        for (std::uint32_t w = first; w < end; ++w)
            for (std::uint64_t bits = words[w]; bits != 0; bits &= bits - 1)
                visit(w * 64 + static_cast<std::uint32_t>(__builtin_ctzll(bits)));
    }
};

}  // namespace islet::detail
