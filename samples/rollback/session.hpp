// A whole match: two peers, a link each way, time frame by frame.
#pragma once

#include "link.hpp"
#include "peer.hpp"
#include "scenes/catalogue.hpp"

namespace islet::rollback {

struct SessionDef {
    LinkDef there = {.seed = 1};
    LinkDef back = {.seed = 2};
    // Single lanes and whole images here, the widest lanes and deltas there: the bits are the same.
    PeerDef first = {.lanes = 1};
    PeerDef second = {.keep = Keep::deltas};
};

struct SessionResult {
    PeerReport peers[player_count];
    int sent[player_count] = {}, lost[player_count] = {};  // packets
    int agreed = 0;                                        // frames certain to both, with equal hashes
    int first_difference = -1;                             // the first frame certain to both with different ones
};

/// Plays until both peers are certain of `frames` frames, or give up making progress.
SessionResult play_session(const samples::SceneInfo& scene, int frames, const SessionDef& def = {});

}  // namespace islet::rollback
