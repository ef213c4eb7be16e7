// A set of bits in words of the world's block: a view, like a span. A walk visits indices in ascending order.
#pragma once

#include <cstdint>
#include <cstring>

#include "../math/inlining.hpp"
#include "islet/layout.hpp"

namespace islet::detail {

struct BitSet {
    std::uint64_t* words = nullptr;
    std::uint32_t word_count = 0;

    /// The number of set bits of a word: sums of neighbours two, four and eight bits wide, then of all bytes. (The compiler's own function may be a library
    /// call.)
    static std::uint32_t bits_of(std::uint64_t x) {
        x -= x >> 1 & 0x5555555555555555ull;
        x = (x & 0x3333333333333333ull) + (x >> 2 & 0x3333333333333333ull);
        x = (x + (x >> 4)) & 0x0f0f0f0f0f0f0f0full;
        return static_cast<std::uint32_t>((x * 0x0101010101010101ull) >> 56);
    }

    bool test(std::uint32_t i) const { return (part(i) >> (i % part_bits) & 1) != 0; }
    void set(std::uint32_t i) const { part(i) |= Part{1} << (i % part_bits); }
    void clear(std::uint32_t i) const { part(i) &= ~(Part{1} << (i % part_bits)); }
    void assign(std::uint32_t i, bool on) const { on ? set(i) : clear(i); }
    void clear_all() const { std::memset(words, 0, std::size_t{word_count} * 8); }

    std::uint32_t count() const { return count_in(0, word_count); }
    /// Bits set in the words first <= w < end.
    std::uint32_t count_in(std::uint32_t first, std::uint32_t end) const {
        std::uint32_t n = 0;
#if defined(__OPTIMIZE_SIZE__)
        for_each_in(first, end, [&](std::uint32_t) { ++n; });  // the walk's code is there anyway
#else
        for (std::uint32_t w = first; w < end; ++w) n += bits_of(words[w]);
#endif
        return n;
    }

    /// Calls visit(index) for each set bit in ascending order. Each word is read once, before its bits are visited. So `visit` may clear bits, and a bit that
    /// it sets is visited if it is in a later word, but not if it is in the current one.
    template <class Visit>
    ISLET_ALWAYS_INLINE void for_each(Visit&& visit) const {
        for_each_in(0, word_count, visit);
    }
    /// The same for the words first <= w < end only.
    template <class Visit>
    ISLET_ALWAYS_INLINE void for_each_in(std::uint32_t first, std::uint32_t end, Visit&& visit) const {
#if defined(__OPTIMIZE_SIZE__)
        Walk walk{words, first, end};
        for (std::uint32_t i = walk.next(); i != none; i = walk.next()) visit(i);
#else
        for (std::uint32_t w = first; w < end; ++w)
            for (std::uint64_t bits = words[w]; bits != 0; bits &= bits - 1) visit(64 * w + lowest(bits));
#endif
    }

private:
    // A word, or the half of one that a register holds.
#if UINTPTR_MAX > 0xffffffffu
    using Part = std::uint64_t;
#else
    typedef std::uint32_t Part ISLET_MAY_ALIAS;
#endif
    static constexpr std::uint32_t part_bits = sizeof(Part) * 8;
    static constexpr std::uint32_t first_part = sizeof(Part) < 8 && is_big_endian ? 1 : 0;  // of a word in memory

    Part& part(std::uint32_t i) const { return reinterpret_cast<Part*>(words)[(i / part_bits) ^ first_part]; }

    // Calls no function of the compiler's runtime where registers have 32 bits.
    static std::uint32_t lowest(std::uint64_t all) {
        if constexpr (sizeof(void*) >= 8) return trailing_zeros_of_long(all);
        const auto low = static_cast<std::uint32_t>(all);
        const auto high = static_cast<std::uint32_t>(all >> 32);
        return low != 0 ? trailing_zeros(low) : 32 + trailing_zeros(high);
    }

#if defined(__OPTIMIZE_SIZE__)
    static constexpr std::uint32_t none = 0xffffffffu;

    // The walk, which a build for size has once. Where registers have 32 bits, it looks at one half of a word after the other.
    struct Walk {
        const std::uint64_t* words;
        std::uint32_t word, end;  // the next to look into
#if UINTPTR_MAX > 0xffffffffu || defined(__wasm__)
        std::uint64_t bits = 0;  // left of the one before

        ISLET_COPIED std::uint32_t next() {
            while (bits == 0) {
                if (word >= end) return none;
                bits = words[word++];
            }
            const std::uint64_t all = bits;
            bits &= bits - 1;
            return (word - 1) * 64 + lowest(all);
        }
#else
        std::uint32_t half = 0, high_half = 0;  // what is left of the one before
        std::uint32_t index = 0;                // of the half's lowest bit

        ISLET_COPIED std::uint32_t next() {
            while (half == 0) {
                if (high_half != 0) {
                    half = high_half;
                    high_half = 0;
                    index += 32;
                    break;
                }
                if (word >= end) return none;
                half = static_cast<std::uint32_t>(words[word]);
                high_half = static_cast<std::uint32_t>(words[word] >> 32);
                index = 64 * word++;
            }
            const std::uint32_t i = index + trailing_zeros(half);
            half &= half - 1;
            return i;
        }
#endif
    };
#endif
};

}  // namespace islet::detail
