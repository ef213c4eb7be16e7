#include "peer.hpp"

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <utility>

namespace islet::rollback {

namespace {

/// Adds the time until it goes to a sum; for the report alone.
class Stopwatch {
public:
    explicit Stopwatch(double& seconds) : seconds_(seconds) {}
    ~Stopwatch() { seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;

private:
    double& seconds_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace

Peer::Peer(int player, samples::Scene scene, const PeerDef& def)
    : match_(std::move(scene), def.lanes),
      own_(player),
      other_(1 - player),
      heed_(def.heed),
      history_(match_.world().capacity(), window, def.keep) {
    inputs_[own_].resize(static_cast<std::size_t>(def.input_delay));  // nothing acts before the first input does
}

void Peer::receive(const Packet& packet) {
    sent_ = std::max(sent_, std::min(packet.known, known(own_)));  // whatever it claims
    for (std::size_t i = 0; i < packet.inputs.size(); ++i) {
        const int frame = packet.first + static_cast<int>(i);
        if (frame != known(other_)) continue;  // had it already, or one before it is still missing
        inputs_[other_].push_back(packet.inputs[i]);
        if (frame < frame_ && guesses_[static_cast<std::size_t>(frame)] != packet.inputs[i]) wrong_ = std::min(wrong_, frame);
    }
    if (packet.checked_frame >= 0 && packet.checked_frame < certain() && hash_after(packet.checked_frame) != packet.checked_hash)
        ++report_.desyncs;
}

bool Peer::play(const Input& own) {
    if (wrong_ < frame_ && heed_) {
        const int from = wrong_;
        go_back_to(from);
        for (int frame = from; frame < frame_; ++frame) play_frame(frame);
        ++report_.rollbacks;
        report_.deepest = std::max(report_.deepest, frame_ - from);
        report_.replayed += frame_ - from;
    }
    wrong_ = frame_;
    if (frame_ - known(other_) >= window) {
        ++report_.waits;
        return false;
    }
    inputs_[own_].push_back(own);
    play_frame(frame_);
    wrong_ = ++frame_;
    ++report_.frames;
    return true;
}

void Peer::play_frame(int frame) {
    remember(frame);
    const auto at = static_cast<std::size_t>(frame);
    if (at == guesses_.size()) {
        guesses_.emplace_back();
        hashes_.emplace_back();
    }
    guesses_[at] = input_of(other_, frame);
    Input inputs[player_count];
    inputs[own_] = input_of(own_, frame);
    inputs[other_] = guesses_[at];
    {
        const Stopwatch watch(report_.seconds_stepping);
        match_.advance(inputs);
    }
    hashes_[at] = match_.world().hash();
}

void Peer::remember(int frame) {
    const Stopwatch watch(report_.seconds_going_back);
    history_.save(match_.world(), frame);
    report_.snapshot_bytes = std::max(report_.snapshot_bytes, match_.world().snapshot_bytes());
    report_.history_bytes = std::max(report_.history_bytes, history_.bytes());
}

void Peer::go_back_to(int frame) {
    const Stopwatch watch(report_.seconds_going_back);
    if (!history_.restore(match_.world(), frame)) throw std::logic_error("rollback: a frame outside the window");
}

// The guess is that a player goes on pushing as he did, and throws nothing.
Input Peer::input_of(int player, int frame) const {
    const std::vector<Input>& inputs = inputs_[player];
    if (frame < known(player)) return inputs[static_cast<std::size_t>(frame)];
    Input guess = inputs.empty() ? Input{} : inputs.back();
    guess.throws = false;
    return guess;
}

Packet Peer::packet() const {
    Packet p;
    p.first = sent_;
    p.inputs.assign(inputs_[own_].begin() + sent_, inputs_[own_].end());
    p.known = known(other_);
    p.checked_frame = certain() - 1;
    if (p.checked_frame >= 0) p.checked_hash = hash_after(p.checked_frame);
    return p;
}

int Peer::certain() const { return std::min({frame_, known(other_), wrong_}); }

}  // namespace islet::rollback
