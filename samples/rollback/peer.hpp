// One peer of a match with rollback (the scheme of GGPO, Cannon 2006): it never waits for the other's input but guesses that he goes on as before, and
// when the truth differs goes back to that frame and plays the frames since anew.
//
//     frame     ... 94  95  96  97  98  99 100
//     own input      x   x   x   x   x   x   x     always known
//     other's        x   x   x   ?   ?   ?   ?     known until 96, guessed since
//                                ^               arrives, and was guessed wrong: restore 97, play 97 to 100
#pragma once

#include <cstdint>
#include <vector>

#include "history.hpp"
#include "match.hpp"

namespace islet::rollback {

/// Frames that a peer may be ahead of what it knows for certain; then it waits.
inline constexpr int window = 12;

/// What peers tell each other, every frame. Inputs are sent until the other says that he has them, so a lost packet costs time and nothing else.
struct Packet {
    int first = 0;              // frame of inputs[0]
    std::vector<Input> inputs;
    int known = 0;              // how many of the receiver's inputs the sender has
    int checked_frame = -1;     // a frame that the sender knows for certain, and the hash of its world after it
    std::uint64_t checked_hash = 0;
};

/// How a peer plays. The two of a match need not be alike.
struct PeerDef {
    std::uint32_t lanes = 0;   ///< as in WorldDef
    int input_delay = 0;       ///< frames, 0 to window, from an input to its effect: as long as it has to reach the other before he must guess
    Keep keep = Keep::images;  ///< how it remembers the frames that it may go back to
    bool heed = true;          ///< false: it never goes back when it guessed wrong, to see what comes of it
};

/// What happened so far.
struct PeerReport {
    int frames = 0;             // played
    int rollbacks = 0;
    int deepest = 0;            // frames of the longest one
    int replayed = 0;           // frames played anew
    int waits = 0;              // frames not played because the other was too far behind
    int desyncs = 0;            // hashes of certain frames that differed from the other's
    std::size_t snapshot_bytes = 0;  // largest
    std::size_t history_bytes = 0;   // most, of all that is kept to go back to
    double seconds_stepping = 0, seconds_going_back = 0;  // save and restore
};

class Peer {
public:
    /// `player` is whose input is this peer's own.
    Peer(int player, samples::Scene scene, const PeerDef& def = {});

    /// Takes in what the other sent.
    void receive(const Packet& packet);
    /// Goes back if a guess was wrong, then plays one frame, unless the other is too far behind. Returns whether it did; if not, the input is not
    /// taken. It acts in this frame, or input_delay frames later.
    bool play(const Input& own);
    /// What to send now.
    Packet packet() const;

    /// Frames of which both players' inputs are known, and which are played with them: these never change again.
    int certain() const;
    /// Hash of the world after a certain frame.
    std::uint64_t hash_after(int frame) const { return hashes_[static_cast<std::size_t>(frame)]; }
    const PeerReport& report() const { return report_; }
    /// The world as it is now, guesses included: to draw. Whatever changes it but play() makes the peers disagree.
    World& world() { return match_.world(); }

private:
    void play_frame(int frame);
    void remember(int frame);
    void go_back_to(int frame);
    Input input_of(int player, int frame) const;
    int known(int player) const { return static_cast<int>(inputs_[player].size()); }

    Match match_;
    int own_, other_;
    bool heed_;
    int frame_ = 0;                               // the next to play
    int wrong_ = 0;                               // the first frame played on a wrong guess; frame_ if there is none
    int sent_ = 0;                                // inputs that the other is known to have
    std::vector<Input> inputs_[player_count];     // by frame, as far as known
    std::vector<Input> guesses_;                  // the other's inputs as they were played
    std::vector<std::uint64_t> hashes_;           // by frame
    History history_;                             // the world before each of the last `window` frames
    PeerReport report_;
};

}  // namespace islet::rollback
