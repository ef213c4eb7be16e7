// What to go back to: the world as it was before each of the last frames. Either as a ring of whole images, or in a fraction of the memory as the
// newest image and, from each frame, the way back to the one before:
//
//     images:   [94] [95] [96] [97] [98]
//     deltas:    94 <- 95 <- 96 <- 97 <- [98]
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <islet/islet.hpp>

namespace islet::rollback {

enum class Keep : std::uint8_t {
    images,  ///< Fastest: saving and going back are a copy each, and all memory is taken once, at the start.
    deltas,  ///< Smallest: each frame costs a comparison, and going back n frames costs n of them.
};

class History {
public:
    /// Room for the last `frames` frames of a world of this capacity.
    History(const Capacity& capacity, int frames, Keep keep);

    /// Keeps the world as it is before `frame`: 0 at first, then the next one each time. The frame gone back to is kept already, and may be saved again.
    void save(const World& world, int frame);
    /// Goes back to before `frame` and forgets the frames after it. False, and nothing changes, if that frame is not kept.
    bool restore(World& world, int frame);

    /// Bytes of the images and deltas kept now.
    std::size_t bytes() const;

private:
    struct Block {
        std::vector<std::byte> memory;
        std::size_t bytes = 0;  // in use
        std::span<const std::byte> used() const { return std::span(memory).first(bytes); }
    };
    std::size_t slot(int frame) const { return static_cast<std::size_t>(frame) % ring_.size(); }

    Keep keep_;
    int newest_ = -1, kept_ = 0;     // frames newest_ - kept_ + 1 to newest_ are here
    std::vector<Block> ring_;        // by frame modulo its size: its image, or the way back from it
    Block image_, spare_;            // deltas only: the newest image, and room to make the next
    std::vector<std::byte> packed_;  // deltas only: room to pack one
};

}  // namespace islet::rollback
