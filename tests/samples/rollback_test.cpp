// The rollback sample: a bad link, two peers on it, and what must hold between them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>
#include <vector>

#include "physics/measure.hpp"
#include "rollback/session.hpp"
#include "support/image.hpp"

namespace islet::test {
namespace {

using namespace rollback;

// -- the link ------------------------------------------------------------------------------------------------------------------------------

struct Delivery {
    std::vector<int> arrivals;  // of each packet, by number; the first copy
    int delivered = 0, doubled = 0;
};

Delivery deliver(const LinkDef& def, int packets) {
    Link<int> link(def);
    Delivery d{std::vector<int>(static_cast<std::size_t>(packets), -1)};
    for (int now = 0; now < packets + 100; ++now) {
        if (now < packets) link.send(now, now);
        link.receive(now, [&](int number) {
            int& arrival = d.arrivals[static_cast<std::size_t>(number)];
            ++(arrival < 0 ? d.delivered : d.doubled);
            if (arrival < 0) arrival = now;
        });
    }
    return d;
}

TEST(Link, LosesAndDoublesAsOftenAsAsked) {
    const Delivery d = deliver({.loss_percent = 20, .double_percent = 5}, 20000);
    EXPECT_NEAR(d.delivered, 16000, 300);
    EXPECT_NEAR(d.doubled, 800, 150);
}

TEST(Link, KeepsItsDelaysAndLetsPacketsOvertakeEachOther) {
    const Delivery d = deliver({.loss_percent = 0, .double_percent = 0, .least_delay = 3, .most_delay = 8}, 5000);
    int least = 100, most = 0, overtaken = 0;
    for (int i = 0; i < 5000; ++i) {
        const int delay = d.arrivals[static_cast<std::size_t>(i)] - i;
        least = std::min(least, delay);
        most = std::max(most, delay);
        if (i > 0 && d.arrivals[static_cast<std::size_t>(i)] < d.arrivals[static_cast<std::size_t>(i - 1)]) ++overtaken;
    }
    EXPECT_EQ(least, 3);
    EXPECT_EQ(most, 8);
    EXPECT_GT(overtaken, 500);
}

// -- the history ---------------------------------------------------------------------------------------------------------------------------

class Histories : public testing::TestWithParam<Keep> {};

TEST_P(Histories, GoBackToEveryFrameTheyKeepAndToNoOther) {
    constexpr int frames = 200;
    Match match(samples::find_scene("ragdoll")->make(), 0);
    History history(match.world().capacity(), window, GetParam());
    std::vector<std::uint64_t> before;  // hash of the world before each frame, when it was first played
    const auto play_from = [&](int frame) {
        for (; frame < frames; ++frame) {
            if (before.size() == static_cast<std::size_t>(frame)) before.push_back(match.world().hash());
            ASSERT_EQ(match.world().hash(), before[static_cast<std::size_t>(frame)]) << "before frame " << frame;
            history.save(match.world(), frame);
            match.advance({pretend(0, frame), pretend(1, frame)});
        }
    };
    play_from(0);
    const std::uint64_t end = match.world().hash();
    EXPECT_FALSE(history.restore(match.world(), frames - window - 1)) << "that one is too long ago";
    EXPECT_FALSE(history.restore(match.world(), frames)) << "that one was not kept yet";
    EXPECT_EQ(match.world().hash(), end);
    for (int depth = 1; depth <= window; ++depth) {
        ASSERT_TRUE(history.restore(match.world(), frames - depth)) << depth << " frames back";
        EXPECT_FALSE(history.restore(match.world(), frames - window - 1)) << "going back brings nothing older with it";
        if (depth > 1) {
            EXPECT_FALSE(history.restore(match.world(), frames - 1)) << "what was gone back over is forgotten";
        }
        play_from(frames - depth);
        ASSERT_EQ(match.world().hash(), end);
    }
}

INSTANTIATE_TEST_SUITE_P(Keep, Histories, testing::Values(Keep::images, Keep::deltas),
                         [](const auto& test) { return test.param == Keep::images ? "images" : "deltas"; });

TEST(History, DeltasTakeLessThanAThirdOfTheMemoryOfImages) {
    Match match(samples::find_scene("ragdoll")->make(), 0);
    History images(match.world().capacity(), window, Keep::images), deltas(match.world().capacity(), window, Keep::deltas);
    std::vector<std::size_t> sizes;
    for (int frame = 0; frame < 300; ++frame) {
        sizes.push_back(match.world().snapshot_bytes());
        images.save(match.world(), frame);
        deltas.save(match.world(), frame);
        match.advance({pretend(0, frame), pretend(1, frame)});
        if (frame < window) continue;
        ASSERT_EQ(images.bytes(), std::accumulate(sizes.end() - window, sizes.end(), std::size_t{0}));
        ASSERT_LT(deltas.bytes(), images.bytes() / 3);
    }
}

// -- a peer alone --------------------------------------------------------------------------------------------------------------------------

/// Two peers who hear each other at once, unless a test steps in.
struct Pair {
    Peer first{0, samples::find_scene("pyramid")->make(), {.lanes = 1}};
    Peer second{1, samples::find_scene("pyramid")->make()};

    /// `spoil` may change what the first tells the second.
    template <class Spoil>
    void play(int frames, Spoil&& spoil) {
        for (int i = 0; i < frames; ++i) {
            first.play(pretend(0, first.report().frames));
            Packet packet = first.packet();
            spoil(packet);
            second.receive(packet);
            second.play(pretend(1, second.report().frames));
            first.receive(second.packet());
        }
    }
    void play(int frames) {
        play(frames, [](Packet&) {});
    }
    int desyncs() const { return first.report().desyncs + second.report().desyncs; }
};

/// What the first player did in some frames, as a packet.
Packet told(int first, int count) {
    Packet packet;
    packet.first = first;
    for (int i = 0; i < count; ++i) packet.inputs.push_back(pretend(0, first + i));
    return packet;
}

TEST(Peer, TakesEachInputOnceAndInOrderHoweverPacketsArrive) {
    Peer peer(1, samples::find_scene("pyramid")->make());
    for (int i = 0; i < window; ++i) peer.play(pretend(1, i));
    EXPECT_EQ(peer.certain(), 0);
    peer.receive(told(0, 3));
    EXPECT_EQ(peer.packet().known, 3);
    peer.receive(told(0, 3));
    EXPECT_EQ(peer.packet().known, 3) << "a packet that came twice counted twice";
    peer.receive(told(5, 2));
    EXPECT_EQ(peer.packet().known, 3) << "frames 3 and 4 are missing";
    peer.receive(told(1, 6));
    EXPECT_EQ(peer.packet().known, 7);
    peer.receive(told(0, 2));
    EXPECT_EQ(peer.packet().known, 7) << "an old packet took something away";
}

TEST(Peer, TellsItsInputsUntilTheOtherHasThem) {
    Peer peer(0, samples::find_scene("pyramid")->make());
    for (int i = 0; i < 5; ++i) peer.play(pretend(0, i));
    EXPECT_EQ(peer.packet().first, 0);
    EXPECT_EQ(peer.packet().inputs, told(0, 5).inputs);
    Packet heard;
    heard.known = 3;
    peer.receive(heard);
    EXPECT_EQ(peer.packet().first, 3);
    EXPECT_EQ(peer.packet().inputs, told(3, 2).inputs);
    heard.known = 1;
    peer.receive(heard);
    EXPECT_EQ(peer.packet().first, 3) << "an old packet took something away";
}

TEST(Peer, WaitsAtTheEndOfTheWindowAndGoesOnWhenItHearsAgain) {
    Pair pair;
    pair.play(20);
    int silent = 0;
    while (silent <= window && pair.second.play(pretend(1, pair.second.report().frames))) ++silent;
    EXPECT_EQ(silent, window);
    EXPECT_FALSE(pair.second.play({})) << "waiting is not for one frame only";
    pair.play(200);
    EXPECT_GE(pair.second.certain(), 200);
    EXPECT_LE(pair.second.report().deepest, window);
    EXPECT_EQ(pair.desyncs(), 0);
}

TEST(Peer, GivesNoFalseAlarmWhenAskedForAPacketBeforeItHasGoneBack) {
    Pair pair;
    for (int i = 0; i < 600; ++i) {
        pair.first.play(pretend(0, i));
        pair.second.play(pretend(1, i));
        const Packet packet = pair.first.packet();
        pair.second.receive(packet);
        pair.first.receive(pair.second.packet());  // the second has heard of wrong guesses and has not yet played
    }
    EXPECT_GT(pair.second.report().rollbacks, 5);
    EXPECT_EQ(pair.desyncs(), 0);
}

// -- the match -----------------------------------------------------------------------------------------------------------------------------

constexpr int ten_minutes = slow_build ? 1500 : 36000;

class TenMinutes : public testing::TestWithParam<const char*> {};

TEST_P(TenMinutes, PeersAgreeOnEveryFrameOverABadLink) {
    const SessionResult r = play_session(*samples::find_scene(GetParam()), ten_minutes);
    EXPECT_EQ(r.first_difference, -1);
    EXPECT_GE(r.agreed, ten_minutes) << "the match did not go on to its end";
    for (int i = 0; i < player_count; ++i) {
        const PeerReport& p = r.peers[i];
        EXPECT_EQ(p.desyncs, 0);
        EXPECT_LE(p.deepest, window);
        // Otherwise nothing was put to the test.
        EXPECT_GT(p.rollbacks, ten_minutes / 60);
        EXPECT_GT(p.replayed, p.rollbacks);
        EXPECT_GT(r.lost[i], r.sent[i] / 20);
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, TenMinutes, testing::Values("pyramid", "ragdoll"), [](const auto& test) { return std::string(test.param); });

TEST(Rollback, APeerThatDoesNotGoBackIsFoundOut) {
    const SessionResult r = play_session(*samples::find_scene("pyramid"), 600, {.second = {.heed = false}});
    EXPECT_GE(r.first_difference, 0);
    EXPECT_GT(r.peers[0].desyncs, 0) << "the other did not notice";
    EXPECT_GT(r.peers[1].desyncs, 0) << "it did not notice itself";
}

TEST(Rollback, AnInputThatActsAFrameLateIsFoundOut) {
    Pair pair;
    pair.play(120);
    ASSERT_EQ(pair.desyncs(), 0);
    pair.play(120, [](Packet& packet) {
        for (std::size_t i = 0; i < packet.inputs.size(); ++i) packet.inputs[i] = pretend(0, packet.first + static_cast<int>(i) - 1);
    });
    EXPECT_GT(pair.first.report().desyncs, 0);
    EXPECT_GT(pair.second.report().desyncs, 0);
}

TEST(Rollback, ARestoreThatIsWrongByOneBitIsFoundOut) {
    Pair pair;
    pair.play(120);
    World& world = pair.second.world();  // this peer always hears in time and never goes back, so nothing mends what is spoilt here
    const Image sound = save(world);
    ASSERT_TRUE(world.restore(sound.bytes()));
    pair.play(30);
    ASSERT_EQ(pair.desyncs(), 0);

    Image spoilt = save(world);
    const BodyId ball = world.moved_bodies().back();
    const auto speed = std::bit_cast<std::array<std::byte, sizeof(float)>>(world.linear_velocity(ball).x);
    const auto found = std::search(spoilt.bytes().begin(), spoilt.bytes().end(), speed.begin(), speed.end());
    ASSERT_NE(found, spoilt.bytes().end());
    found[1] ^= std::byte{1};
    ASSERT_TRUE(world.restore(spoilt.bytes()));
    ASSERT_EQ(pair.desyncs(), 0);
    pair.play(30);
    EXPECT_GT(pair.first.report().desyncs, 0);
    EXPECT_GT(pair.second.report().desyncs, 0);
}

TEST(Rollback, InputDelaySparesFramesAndChangesNothingElse) {
    const samples::SceneInfo& scene = *samples::find_scene("ragdoll");
    const SessionResult at_once = play_session(scene, 1200);
    const SessionResult later = play_session(scene, 1200, {.first = {.input_delay = 4}, .second = {.input_delay = 2}});
    const SessionResult much_later = play_session(scene, 1200, {.there = {.loss_percent = 0}, .back = {.loss_percent = 0},
                                                                .first = {.input_delay = 10}, .second = {.input_delay = 10}});
    for (const SessionResult* r : {&later, &much_later}) {
        EXPECT_EQ(r->first_difference, -1);
        EXPECT_GE(r->agreed, 1200);
    }
    for (int i = 0; i < player_count; ++i) {
        EXPECT_LT(later.peers[i].replayed, at_once.peers[i].replayed);
        EXPECT_EQ(much_later.peers[i].rollbacks, 0) << "no packet takes as long as an input waits";
    }
}

TEST(Rollback, AVeryBadLinkSlowsTheMatchAndSpoilsNothing) {
    const LinkDef bad{.loss_percent = 60, .double_percent = 20, .least_delay = 5, .most_delay = 25, .seed = 5};
    LinkDef worse = bad;
    worse.seed = 6;
    const SessionResult r = play_session(*samples::find_scene("ragdoll"), 600, {.there = bad, .back = worse});
    EXPECT_EQ(r.first_difference, -1);
    EXPECT_GE(r.agreed, 600);
    for (const PeerReport& p : r.peers) {
        EXPECT_GT(p.waits, 100);
        EXPECT_EQ(p.deepest, window) << "the window was never used up, or passed";
        EXPECT_EQ(p.desyncs, 0);
    }
}

TEST(Rollback, WithoutDelayNothingIsEverPlayedTwiceForLong) {
    const LinkDef good{.loss_percent = 0, .double_percent = 0, .least_delay = 0, .most_delay = 0};
    const SessionResult r = play_session(*samples::find_scene("pyramid"), 300, {.there = good, .back = good});
    EXPECT_EQ(r.first_difference, -1);
    for (const PeerReport& p : r.peers) EXPECT_LE(p.deepest, 1);
}

// A packet comes from outside: what it says may be anything.
TEST(APeerAlone, BelievesNobodyWhoClaimsInputsThatWereNeverSent) {
    Peer peer(0, samples::find_scene("pyramid")->make());
    for (int i = 0; i < 5; ++i) peer.play(pretend(0, i));
    Packet liar;
    liar.known = 1000;
    peer.receive(liar);
    EXPECT_LE(peer.packet().inputs.size(), 5u);
}

}  // namespace
}  // namespace islet::test
