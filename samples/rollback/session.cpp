#include "session.hpp"

namespace islet::rollback {

SessionResult play_session(const samples::SceneInfo& scene, int frames, const SessionDef& def) {
    Peer peers[player_count] = {Peer(0, scene.make(), def.first), Peer(1, scene.make(), def.second)};
    Link<Packet> links[player_count] = {Link<Packet>(def.there), Link<Packet>(def.back)};  // from peer i
    SessionResult result;
    const auto certain = [&] { return peers[0].certain() < peers[1].certain() ? peers[0].certain() : peers[1].certain(); };
    // Nobody lags for ever: with any packets arriving at all, a frame is certain every few.
    for (int now = 0; now < 4 * frames + 1000 && certain() < frames; ++now) {
        for (int i = 0; i < player_count; ++i) {
            links[1 - i].receive(now, [&](const Packet& packet) { peers[i].receive(packet); });
            peers[i].play(pretend(i, peers[i].report().frames));
            links[i].send(now, peers[i].packet());
        }
    }
    result.agreed = certain();
    for (int frame = 0; frame < certain(); ++frame) {
        if (peers[0].hash_after(frame) == peers[1].hash_after(frame)) continue;
        result.first_difference = frame;
        result.agreed = frame;
        break;
    }
    for (int i = 0; i < player_count; ++i) {
        result.peers[i] = peers[i].report();
        result.sent[i] = links[i].sent();
        result.lost[i] = links[i].lost();
    }
    return result;
}

}  // namespace islet::rollback
