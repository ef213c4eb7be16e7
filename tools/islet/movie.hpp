// A movie: a run as the player shows it, in whole numbers, and the bytes that hold them. (A recording is something else: all calls to a world, which
// `islet replay` makes again; see islet/recording.hpp.)
//
// A movie is one frame after another, and a frame says what changed since the one before; what rests costs nothing. All numbers are
// varints (seven bits a byte, lowest first, the top bit set on all but the last byte); signed ones are folded to 0, -1, 1, -2, ... first.
//
//     frame   =  table of bodies, set of bodies that look otherwise + the new look of each, table of contacts, joints
//     table   =  set of ids that went, set of ids that came + a row for each, set of ids that moved + a row for each
//     row     =  x, y, angle, and for a body that came its look and its model
//     joints  =  set of ids that went, set of ids that came + for each: number of its figure, that figure if it is the next one of all, and the ids + 1
//                of its bodies B and A, 0 for one of which nothing is drawn; for such a body A, x and y of the joint's first end follow
//     figure  =  number of its marks, then for each: 16 * number of its points + 4 * its look + its kind, for a ring the radius, and the points
//     point   =  8 * x (folded) + the frame it is fixed in, y: as differences from the point before it in the figure, if that has the same frame
//     set     =  number of runs, then for each run: ids skipped since the last run, ids in the run
//
// Of an id that came, x, y and angle are told as differences from the row before it in its set; of one that moved, from where it would be if
// it had moved as in the frame before. If x and y are -4 to 4 and the angle is -1 to 1, the three are one byte, ((x + 4) * 9 + y + 4) * 3 +
// angle + 1; otherwise they are three numbers after a byte 255.
//
// What is drawn of a joint stays where it is in a frame that goes with its bodies or its ends: so it is told once, and joints
// that are alike share it. Lengths are whole quanta, of Scale; angles are whole parts of a turn, body_turn or contact_turn of them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace islet::tools {

inline constexpr std::int32_t body_turn = 65536;
inline constexpr std::int32_t contact_turn = 256;
/// No coordinate is farther from 0 than this, in quanta: sums of a few of them still fit.
inline constexpr std::int32_t farthest = 1 << 28;

struct Place {
    std::int32_t x = 0, y = 0, angle = 0;  // 0 <= angle < turn
    friend bool operator==(const Place&, const Place&) = default;
};

/// What a body's shapes look like: one of the colours of DebugDraw.
enum class BodyLook : std::uint8_t { static_body, kinematic, awake, asleep, bullet, disabled };

/// A point of what is drawn of a joint. A joint has two ends: its dots, where it holds body A and body B, or if it has none, as gears, the middles of its
/// first two rings. They may come apart, and what is drawn at one may turn with the other's body.
struct JointPoint {
    enum Frame : std::uint8_t {
        world,         // x, y from the movie's origin
        body_a,        // in the body's frame; without a body from the first end
        body_b,
        end_a_turn_b,  // from the first end, turned as body B is
        end_b_turn_a,  // from the second end, turned as body A is
        end_a_way,     // from the first end, x along the way to the second
        end_b_way,     // from the second end, the same way
        between,       // as from the first end, but for x, which counts parts of the way: `between_parts` in all
    };
    Frame frame = world;
    std::int32_t x = 0, y = 0;  // quanta, up to farthest_mark either way
    friend bool operator==(const JointPoint&, const JointPoint&) = default;
};
inline constexpr std::int32_t between_parts = 4096;
inline constexpr std::int32_t farthest_mark = farthest / 4;

struct JointMark {
    enum Kind : std::uint8_t { dot, line, loop, ring };
    enum Look : std::uint8_t { plain, idle, limit };
    Kind kind = dot;
    Look look = plain;
    std::int32_t radius = 0;  // quanta, of a ring
    std::vector<JointPoint> points;
    friend bool operator==(const JointMark&, const JointMark&) = default;
};
using JointFigure = std::vector<JointMark>;

struct JointEntry {
    std::uint32_t figure = 0;
    std::uint32_t body_a = 0, body_b = 0;  // ids + 1; 0: none
    std::int32_t x = 0, y = 0;             // of the first end if there is no body A
    friend bool operator==(const JointEntry&, const JointEntry&) = default;
};

/// Entries by id, of which some are live.
template <class Entry>
struct Table {
    std::vector<Entry> entries;
    std::vector<std::uint8_t> live;

    std::size_t size() const { return entries.size(); }
    bool has(std::size_t id) const { return id < live.size() && live[id] != 0; }
    void put(std::size_t id, const Entry& entry) {
        if (id >= entries.size()) resize(id + 1);
        entries[id] = entry;
        live[id] = 1;
    }
    void resize(std::size_t size) {
        entries.resize(size);
        live.resize(size);
    }
    void clear() { live.assign(live.size(), 0); }
};

/// What a moment of a run looks like. `models` and `looks` go with `bodies`.
struct Frame {
    Table<Place> bodies;
    std::vector<std::uint32_t> models;  // an id never changes its own
    std::vector<BodyLook> looks;
    Table<Place> contacts;
    Table<JointEntry> joints;
};

/// How each row of a table changed in the last frame, which is where the next change is told from.
struct Motion {
    std::int32_t turn = body_turn;
    std::vector<Place> changes;
};

class MovieWriter {
public:
    /// Appends a frame, whose joints are drawn as `figures` say. Tables and figures may grow from one frame to the next, not shrink.
    void add(const Frame& frame, const std::vector<JointFigure>& figures);
    const std::string& bytes() const { return bytes_; }
    int frames() const { return frames_; }

private:
    void put_joints(const Table<JointEntry>& joints, const std::vector<JointFigure>& figures);

    std::string bytes_;
    int frames_ = 0;
    Frame last_;
    std::vector<std::uint32_t> numbers_;  // of figures that were written, + 1
    std::uint32_t written_ = 0;           // of them
    Motion bodies_{body_turn, {}}, contacts_{contact_turn, {}};
};

/// Reads back what a MovieWriter wrote.
class MovieReader {
public:
    explicit MovieReader(std::string_view bytes) : bytes_(bytes) {}
    /// Goes to the next frame; false after the last one.
    bool next();
    const Frame& frame() const { return frame_; }
    const std::vector<JointFigure>& figures() const { return figures_; }

private:
    void take_joints();

    std::string_view bytes_;
    Frame frame_;
    std::vector<JointFigure> figures_;
    Motion bodies_{body_turn, {}}, contacts_{contact_turn, {}};
};

}  // namespace islet::tools
