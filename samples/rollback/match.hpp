// What two players do to a world. All that the next frame depends on is in the world, so a snapshot of it is the whole state of the match; a game that
// keeps more has to save that beside it.
#pragma once

#include <cstdint>

#include "harness/engine.hpp"

namespace islet::rollback {

/// What a player does in one frame.
struct Input {
    std::int8_t push_x = 0, push_y = 0;  // -1, 0, 1
    bool throws = false;
    friend bool operator==(const Input&, const Input&) = default;
};

inline constexpr int player_count = 2;

/// A scene with a ball for each player, who push them about and throw crates.
class Match {
public:
    static constexpr int most_crates = 8;

    /// `lanes` as in WorldDef: the peers may differ.
    Match(samples::Scene scene, std::uint32_t lanes);

    /// One frame.
    void advance(const Input (&inputs)[player_count]);

    World& world() { return engine_.world(); }

private:
    void throw_crate(int player);

    samples::IsletEngine engine_;
    float dt_;
    BodyId balls_[player_count];  // made before the first frame and never destroyed, so these ids hold in every snapshot
};

/// What a player does in a frame: holds a direction for a while, now and then throws. For demonstrations and tests.
Input pretend(int player, int frame);

}  // namespace islet::rollback
