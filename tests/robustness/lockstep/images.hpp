// Forged images, deltas and recordings.
#pragma once

#include <cstdint>

#include "play.hpp"

namespace islet::lockstep {

/// What mutants are made of and tried with.
class ImageHunt {
public:
    ImageHunt();
    /// Makes mutant `seed` and tries it: load refuses it and changes nothing, or what it loads is sound, and stays so.
    void attack(std::uint64_t seed, Chorus& all);

    /// Of even seeds one lane is compared with eight, of odd ones with four.
    static Setup setup(std::uint64_t seed);
    unsigned long accepted = 0, deltas = 0, replays = 0, complete_replays = 0;
    bool recordings_alone = false;

private:
    struct Base {
        std::vector<std::uint64_t> image, later, delta, recording;
        std::size_t delta_bytes = 0, recording_bytes = 0;
    };
    void fill(std::uint64_t bank);
    Base make_base(std::uint64_t seed);

    bool at_home_[2] = {};  ///< the worlds of even and odd seeds are as home_ says
    std::uint64_t bank_ = ~std::uint64_t{0};
    std::vector<Base> bases_;
    std::vector<std::uint64_t> home_, scratch_;
    Stand stand_;
};

}  // namespace islet::lockstep
