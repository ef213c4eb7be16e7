// A checksum as fast as memcpy: Fletcher's (IEEE Trans. Comm. 30, 1982) on sixteen lanes of 32-bit words, with additions only.
//
// It finds accidents: one changed word for certain, any other change but for one case in about 2^64. It does not stop forgers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "islet/compiler.hpp"

namespace islet::detail {

/// Mixes `word` into `sum`: one round of multiply and xor-shift.
inline std::uint64_t mixed(std::uint64_t sum, std::uint32_t word) {
    sum = (sum ^ word) * 0xd6e8feb86659fd93ull;
    return sum ^ sum >> 32;
}

class Checksum {
public:
    static constexpr std::size_t block = 64;  // bytes

    /// Adds whole blocks.
    void add_blocks(const std::byte* bytes, std::size_t blocks) {
        Four a[fours], b[fours];  // local, so that they stay in registers
        std::memcpy(a, sum_, sizeof a);
        std::memcpy(b, sum_of_sums_, sizeof b);
        for (std::size_t i = 0; i < blocks; ++i) {
            for (std::uint32_t k = 0; k < fours; ++k) {
                Four w;
                std::memcpy(&w, bytes + i * block + k * sizeof w, sizeof w);
                a[k] += w;
                b[k] += a[k];
            }
        }
        std::memcpy(sum_, a, sizeof a);
        std::memcpy(sum_of_sums_, b, sizeof b);
    }

    /// Adds the last `size` bytes, fewer than a block, and returns the checksum. `length` is the number of all bytes.
    std::uint64_t finish(const std::byte* bytes, std::size_t size, std::uint64_t length) {
        std::byte last[block] = {};
        std::memcpy(last, bytes, size);
        add_blocks(last, 1);
        std::uint64_t h = length;
        for (const Word w : sum_) h = mixed(h, w);
        for (const Word w : sum_of_sums_) h = mixed(h, w);
        return h;
    }

private:
    using Word = std::uint32_t;
#if ISLET_FOR_MSVC
    using Four = Word;
#else
    typedef Word Four __attribute__((vector_size(16)));  // the compiler's vector extension: plain code where there is none
#endif
    static constexpr std::uint32_t lanes = block / sizeof(Word);
    static constexpr std::uint32_t fours = block / sizeof(Four);
    Word sum_[lanes] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
    Word sum_of_sums_[lanes] = {};
};

inline std::uint64_t checksum_of(const std::byte* bytes, std::size_t size) {
    Checksum sum;
    const std::size_t blocks = size / Checksum::block;
    sum.add_blocks(bytes, blocks);
    return sum.finish(bytes + blocks * Checksum::block, size % Checksum::block, size);
}

}  // namespace islet::detail
