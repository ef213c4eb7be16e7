// What is written to a movie is what is read from it, and what rests costs next to nothing.
#include <algorithm>

#include <gtest/gtest.h>

#include "islet/movie.hpp"
#include "scenes/random.hpp"

namespace {

using namespace islet::samples;
using namespace islet::tools;

/// Random frames: ids come and go, and move by little, by much, or not.
class Scribbler {
public:
    const Frame& next() {
        scribble(frame_.bodies, body_turn, 30);
        frame_.models.resize(frame_.bodies.size());
        frame_.looks.resize(frame_.bodies.size());
        for (std::size_t id = 0; id < frame_.bodies.size(); ++id) {
            if (was_live_.size() <= id || was_live_[id] == 0) frame_.models[id] = below(1000);
            if (below(3) == 0) frame_.looks[id] = static_cast<BodyLook>(below(6));
        }
        was_live_ = frame_.bodies.live;
        scribble(frame_.contacts, contact_turn, 60);
        for (std::size_t id = 0; id < 10; ++id) {
            if (frame_.joints.has(id) && below(8) == 0) frame_.joints.live[id] = 0;
            if (below(8) != 0) continue;
            if (below(2) == 0) figures_.push_back(scribbled_figure());
            if (!figures_.empty()) frame_.joints.put(id, {below(static_cast<std::uint32_t>(figures_.size())), below(30), below(30)});
        }
        return frame_;
    }

    const std::vector<JointFigure>& figures() const { return figures_; }

private:
    void scribble(Table<Place>& table, std::int32_t turn, std::size_t ids) {
        for (std::size_t id = 0; id < ids; ++id) {
            if (table.has(id) && below(10) == 0)
                table.live[id] = 0;
            else if (!table.has(id) && below(4) == 0)
                table.put(id, {any(), any(), static_cast<std::int32_t>(below(static_cast<std::uint32_t>(turn)))});
            else if (table.has(id) && below(2) == 0)
                move(table.entries[id], turn);
        }
    }

    std::int32_t mark_place() { return std::clamp(any(), -farthest_mark, farthest_mark); }
    JointFigure scribbled_figure() {
        JointFigure figure(below(4));
        for (JointMark& mark : figure) {
            mark.kind = static_cast<JointMark::Kind>(below(4));
            mark.look = static_cast<JointMark::Look>(below(3));
            if (mark.kind == JointMark::ring) mark.radius = any();
            mark.points.resize(below(12));
            for (JointPoint& p : mark.points) p = {static_cast<JointPoint::Frame>(below(8)), mark_place(), mark_place()};
        }
        return figure;
    }

    void move(Place& place, std::int32_t turn) {
        const bool far = below(10) == 0;
        const auto change = [&] { return far ? any() : static_cast<std::int32_t>(below(13)) - 6; };
        place.x = std::clamp(far ? change() : place.x + change(), -farthest, farthest);
        place.y = std::clamp(far ? change() : place.y + change(), -farthest, farthest);
        place.angle = (place.angle + change()) & (turn - 1);
    }

    std::uint32_t below(std::uint32_t n) { return random_.next() % n; }
    std::int32_t any() {
        if (below(4) == 0) return below(2) == 0 ? farthest : -farthest;
        return static_cast<std::int32_t>(below(2 * static_cast<std::uint32_t>(farthest))) - farthest;
    }

    Random random_{2024};
    Frame frame_;
    std::vector<JointFigure> figures_;
    std::vector<std::uint8_t> was_live_;
};

template <class Entry>
void expect_same(const Table<Entry>& wanted, const Table<Entry>& got) {
    for (std::size_t id = 0; id < wanted.size(); ++id) {
        ASSERT_EQ(wanted.has(id), got.has(id)) << "id " << id;
        if (!wanted.has(id)) continue;
        ASSERT_TRUE(wanted.entries[id] == got.entries[id]) << "id " << id;
    }
}

TEST(Movie, EveryFrameComesBackExactly) {
    MovieWriter writer;
    Scribbler scribbler;
    std::vector<Frame> frames;
    for (int i = 0; i < 300; ++i) {
        frames.push_back(scribbler.next());
        writer.add(frames.back(), scribbler.figures());
    }
    MovieReader reader(writer.bytes());
    for (const Frame& wanted : frames) {
        ASSERT_TRUE(reader.next());
        const Frame& got = reader.frame();
        expect_same(wanted.bodies, got.bodies);
        expect_same(wanted.contacts, got.contacts);
        // Figures are numbered as they are first needed; what counts is what they show.
        for (std::size_t id = 0; id < wanted.joints.size(); ++id) {
            ASSERT_EQ(wanted.joints.has(id), got.joints.has(id));
            if (!wanted.joints.has(id)) continue;
            const JointEntry &a = wanted.joints.entries[id], &b = got.joints.entries[id];
            ASSERT_TRUE(scribbler.figures()[a.figure] == reader.figures()[b.figure]) << "joint " << id;
            ASSERT_EQ(a.body_a, b.body_a);
            ASSERT_EQ(a.body_b, b.body_b);
        }
        for (std::size_t id = 0; id < wanted.bodies.size(); ++id) {
            if (!wanted.bodies.has(id)) continue;
            ASSERT_EQ(wanted.models[id], got.models[id]);
            ASSERT_EQ(wanted.looks[id], got.looks[id]);
        }
    }
    EXPECT_FALSE(reader.next());
}

TEST(Movie, AFrameInWhichNothingMovesIsNineEmptySets) {
    Frame frame;
    for (std::size_t id = 0; id < 1000; ++id) frame.bodies.put(id, {static_cast<std::int32_t>(7 * id), -5, 3});
    frame.models.resize(1000);
    frame.looks.resize(1000);
    MovieWriter writer;
    writer.add(frame, {});
    const std::size_t first = writer.bytes().size();
    writer.add(frame, {});
    EXPECT_EQ(writer.bytes().size() - first, 9u);
}

TEST(Movie, SteadyMotionIsAByteForEachBody) {
    Frame frame;
    for (std::size_t id = 0; id < 100; ++id) frame.bodies.put(id, {0, 0, 0});
    frame.models.resize(100);
    frame.looks.resize(100);
    MovieWriter writer;
    const auto add_moved = [&] {
        for (Place& place : frame.bodies.entries) {
            place.x += 500;
            place.y -= 300;
            place.angle = (place.angle - 1000) & (body_turn - 1);
        }
        writer.add(frame, {});
    };
    for (int i = 0; i < 2; ++i) add_moved();
    add_moved();
    const std::size_t before = writer.bytes().size();
    add_moved();
    EXPECT_LE(writer.bytes().size() - before, 100u + 12u);
}

TEST(Movie, ATornMovieDoesNotReadBeyondItsEnd) {
    MovieWriter writer;
    Scribbler scribbler;
    for (int i = 0; i < 5; ++i) {
        const Frame& frame = scribbler.next();
        writer.add(frame, scribbler.figures());
    }
    for (std::size_t size = 0; size < writer.bytes().size(); ++size) {
        const std::string torn = writer.bytes().substr(0, size);  // sanitizers watch its end
        MovieReader reader(torn);
        int frames = 0;
        while (reader.next()) ++frames;
        EXPECT_LE(frames, 5);
    }
}

}  // namespace
