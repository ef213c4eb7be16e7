// A run as the player sees it: whole numbers only, and the bytes that hold them.
//
// A recording is one frame after another, and a frame says what changed since the one before; what rests costs nothing. All numbers are
// varints (seven bits a byte, lowest first, the top bit set on all but the last byte); signed ones are folded to 0, -1, 1, -2, ... first.
//
//     frame   =  table of bodies, set of bodies that woke or fell asleep, table of contacts, joints
//     table   =  set of ids that went, set of ids that came + a row for each, set of ids that moved + a row for each
//     joints  =  set of ids that went, set of ids that came + for each: number of points, and the points
//     set     =  number of runs, then for each run: ids skipped since the last run, ids in the run
//     point   =  2 * (id of its body + 1, or 0 for the world) + (1 if it is drawn as a dot), x, y in the body's or the world's frame
//     row     =  x, y, angle, and for a body that came its type and its model
//
// Of an id that came, x, y and angle are told as differences from the row before it in its set; of one that moved, from where it would be if
// it had moved as in the frame before. If x and y are -4 to 4 and the angle is -1 to 1, the three are one byte, ((x + 4) * 9 + y + 4) * 3 +
// angle + 1; otherwise they are three numbers after a byte 255.
//
// Bodies that come are awake. Lengths are whole quanta, of Scale; angles are whole parts of a turn, body_turn or contact_turn of them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace islet::samples {

inline constexpr std::int32_t body_turn = 65536;
inline constexpr std::int32_t contact_turn = 256;
/// No coordinate is farther from 0 than this, in quanta: sums of a few of them still fit.
inline constexpr std::int32_t farthest = 1 << 28;

struct Place {
    std::int32_t x = 0, y = 0, angle = 0;  // 0 <= angle < turn
    friend bool operator==(const Place&, const Place&) = default;
};

/// What a body is besides where it is: an id never changes this.
struct BodyKind {
    std::uint32_t type = 0;   // of BodyType
    std::uint32_t model = 0;  // index of its list of shapes
};

/// A joint is a line through points that are fixed to bodies.
struct JointPoint {
    std::uint32_t frame = 0;  // id of the body + 1; 0: fixed in the world
    bool is_dot = false;
    std::int32_t x = 0, y = 0;
    friend bool operator==(const JointPoint&, const JointPoint&) = default;
};
using JointLine = std::vector<JointPoint>;

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

/// What a moment of a run looks like. `kinds` and `awake` go with `bodies`.
struct Frame {
    Table<Place> bodies;
    std::vector<BodyKind> kinds;
    std::vector<std::uint8_t> awake;
    Table<Place> contacts;
    Table<JointLine> joints;
};

/// How each row of a table changed in the last frame, which is where the next change is told from.
struct Motion {
    std::int32_t turn = body_turn;
    std::vector<Place> changes;
};

class RecordingWriter {
public:
    /// Appends a frame. Tables may grow from one frame to the next, not shrink.
    void add(const Frame& frame);
    const std::string& bytes() const { return bytes_; }
    int frames() const { return frames_; }

private:
    std::string bytes_;
    int frames_ = 0;
    Frame last_;
    Motion bodies_{body_turn, {}}, contacts_{contact_turn, {}};
};

/// Reads back what a RecordingWriter wrote.
class RecordingReader {
public:
    explicit RecordingReader(std::string_view bytes) : bytes_(bytes) {}
    /// Goes to the next frame; false after the last one.
    bool next();
    const Frame& frame() const { return frame_; }

private:
    std::string_view bytes_;
    Frame frame_;
    Motion bodies_{body_turn, {}}, contacts_{contact_turn, {}};
};

}  // namespace islet::samples
