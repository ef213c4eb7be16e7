// A whole match: two peers, a link each way, time frame by frame.
#pragma once

#include "link.hpp"
#include "peer.hpp"

namespace islet::rollback {

struct SessionDef {
    LinkDef there = {.seed = 1};
    LinkDef back = {.seed = 2};
    bool second_heeds = true;  ///< as in Peer
};

struct SessionResult {
    PeerReport peers[player_count];
    int sent[player_count] = {}, lost[player_count] = {};  // packets
    int agreed = 0;                                        // frames certain to both, with equal hashes
    int first_difference = -1;                             // the first frame certain to both with different ones
};

/// Plays until both peers are certain of `frames` frames, or give up making progress. The first peer computes in single lanes, the second in the
/// widest there are: the bits are the same.
SessionResult play_session(const samples::SceneInfo& scene, int frames, const SessionDef& def = {});

}  // namespace islet::rollback
