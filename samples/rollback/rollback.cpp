// Two peers play a match over a bad link, inside one program, and must agree on every frame of it.
//
//     rollback [SCENE [FRAMES]]        both scenes below, 36000 frames (ten minutes), unless given
//
// Exit status 1 if they disagree on a frame.
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "session.hpp"

namespace {

using namespace islet;
using namespace islet::rollback;

bool play(const samples::SceneInfo& info, int frames) {
    const SessionResult r = play_session(info, frames);
    for (int i = 0; i < player_count; ++i) {
        const PeerReport& p = r.peers[i];
        std::printf("%-10s %4d %7d %7d %10d %8.1f %8d %7d %6d %6d %7d %9zu %8zu %8.1f %8d\n", info.name, i, p.frames, r.agreed, p.rollbacks,
                    p.rollbacks > 0 ? static_cast<double>(p.replayed) / p.rollbacks : 0, p.deepest, p.replayed, p.waits, r.sent[i], r.lost[i],
                    p.snapshot_bytes, p.history_bytes, 100 * p.seconds_going_back / (p.seconds_going_back + p.seconds_stepping), p.desyncs);
    }
    if (r.first_difference >= 0) std::printf("%s: the peers differ from frame %d on\n", info.name, r.first_difference);
    return r.first_difference < 0 && r.agreed >= frames;
}

}  // namespace

int main(int argc, char** argv) {
    const int frames = argc > 2 ? std::atoi(argv[2]) : 36000;
    const std::vector<std::string> names = argc > 1 ? std::vector<std::string>{argv[1]} : std::vector<std::string>{"pyramid", "ragdoll"};
    std::printf("%-10s %4s %7s %7s %10s %8s %8s %7s %6s %6s %7s %9s %8s %8s %8s\n", "scene", "peer", "frames", "agreed", "rollbacks", "mean", "deepest",
                "replayed", "waits", "sent", "lost", "snapshot", "history", "% saving", "desyncs");
    bool agree = true;
    for (const std::string& name : names) {
        const samples::SceneInfo* info = samples::find_scene(name);
        if (info == nullptr || frames < 1) {
            std::fprintf(stderr, "usage: rollback [SCENE [FRAMES]]; `islet list` shows the scenes\n");
            return 2;
        }
        agree = play(*info, frames) && agree;
    }
    return agree ? 0 : 1;
}
