// A link as the internet gives it: packets are lost, delayed, doubled and overtake each other. Time is in frames; nothing here reads a clock.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace islet::rollback {

/// SplitMix64 (Steele, Lea and Flood 2014): the same numbers from the same seed everywhere.
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    /// 0 <= result < n
    int below(int n) {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15ull;
        z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9ull;
        z = (z ^ z >> 27) * 0x94d049bb133111ebull;
        return static_cast<int>((z >> 33) % static_cast<std::uint64_t>(n));
    }

private:
    std::uint64_t state_;
};

/// How bad a link is.
struct LinkDef {
    int loss_percent = 10;
    int double_percent = 3;
    int least_delay = 2;  ///< frames
    int most_delay = 9;   ///< frames; what differs lets packets overtake each other
    std::uint64_t seed = 1;
};

/// One direction of the link.
template <class Packet>
class Link {
public:
    explicit Link(const LinkDef& def) : def_(def), random_(def.seed) {}

    void send(int now, const Packet& packet) {
        ++sent_;
        if (random_.below(100) < def_.loss_percent) {
            ++lost_;
            return;
        }
        const int copies = random_.below(100) < def_.double_percent ? 2 : 1;
        for (int i = 0; i < copies; ++i) flying_.push_back({now + def_.least_delay + random_.below(def_.most_delay - def_.least_delay + 1), packet});
    }

    /// Calls take(packet) for each packet that has arrived by `now`.
    template <class Take>
    void receive(int now, Take&& take) {
        std::size_t kept = 0;
        for (Flying& f : flying_) {
            if (f.arrives <= now) {
                take(f.packet);
            } else {
                std::swap(flying_[kept++], f);
            }
        }
        flying_.resize(kept);
    }

    int sent() const { return sent_; }
    int lost() const { return lost_; }

private:
    struct Flying {
        int arrives = 0;
        Packet packet;
    };
    LinkDef def_;
    Random random_;
    std::vector<Flying> flying_;
    int sent_ = 0, lost_ = 0;
};

}  // namespace islet::rollback
