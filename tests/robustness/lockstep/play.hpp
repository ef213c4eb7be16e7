// One world's life out of one seed: what it is made of, and the calls and steps that follow.
#pragma once

#include <cstdint>
#include <string>

#include "fuzz/api/caller.hpp"
#include "support/random.hpp"
#include "support/test_world.hpp"

namespace islet::lockstep {

using test::Chorus;
using test::Deeds;

/// What broke, or Stop's end.
struct Broken {
    std::string what;
};

/// Everything about a life but its calls.
struct Setup {
    std::uint64_t seed = 0;
    std::uint32_t family = 0;
    Capacity capacity = {};
    WorldDef def = {};
    bool threads = false;  ///< real ones
    bool images = false;   ///< for forged images: two worlds only
    bool dense = false;    ///< many calls between steps, in place of some steps after each
};

Setup setup_of(std::uint64_t seed, int family);

/// Memory for worlds, which is used again and again.
class Stand {
public:
    Stand();
    /// Makes the worlds.
    void begin(const Setup& setup, Chorus& all);

    /// So large that what any world here saves can be loaded.
    static const Capacity largest;

private:
    test::Block blocks_[5];
};

/// The whole life, of at most so many calls.
void play(const Setup& setup, Chorus& all, std::uint32_t calls);

/// Makes calls to worlds that are there, with everything from `random`.
class Life : public fuzz::Caller {
public:
    Life(Chorus& worlds, test::Random& random, const Setup& setup)
        : Caller(worlds, fuzz::Reader(nullptr, 0, fuzz::families[setup.family])), random_(random), setup_(setup) {
        refill();
    }
    void furnish();
    void call();
    /// One that changes things: no step.
    void change();

private:
    void refill();
    float usual_step();
    BodyId add(Vec2 at, bool dynamic = true);
    ShapeDef surface();
    void add_shape(BodyId owner, float size);

    test::Random& random_;
    const Setup& setup_;
    std::uint8_t bytes_[160];
};

}  // namespace islet::lockstep
