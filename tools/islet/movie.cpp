#include "movie.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace islet::tools {
namespace {

void put_number(std::string& bytes, std::uint32_t n) {
    for (; n >= 0x80; n >>= 7) bytes += static_cast<char>(n | 0x80);
    bytes += static_cast<char>(n);
}

/// 0, -1, 1, -2, ... as 0, 1, 2, 3, ...
std::uint32_t folded(std::int32_t n) { return (static_cast<std::uint32_t>(n) << 1) ^ static_cast<std::uint32_t>(n >> 31); }
std::int32_t unfolded(std::uint32_t n) { return static_cast<std::int32_t>((n >> 1) ^ (0u - (n & 1))); }

void put_signed(std::string& bytes, std::int32_t n) { put_number(bytes, folded(n)); }

std::uint32_t take_number(std::string_view& bytes) {
    std::uint32_t n = 0;
    for (int shift = 0; !bytes.empty() && shift < 32; shift += 7) {
        const auto byte = static_cast<std::uint8_t>(bytes.front());
        bytes.remove_prefix(1);
        n |= static_cast<std::uint32_t>(byte & 0x7f) << shift;
        if (byte < 0x80) break;
    }
    return n;
}

std::int32_t take_signed(std::string_view& bytes) { return unfolded(take_number(bytes)); }

/// Writes the ids for which `is_in` holds, and returns them.
template <class IsIn>
std::vector<std::uint32_t> put_set(std::string& bytes, std::size_t size, const IsIn& is_in) {
    std::vector<std::uint32_t> ids;
    for (std::size_t id = 0; id < size; ++id) {
        if (is_in(id)) ids.push_back(static_cast<std::uint32_t>(id));
    }
    std::string runs;
    std::uint32_t count = 0, end = 0;  // end of the last run
    for (std::size_t i = 0; i < ids.size(); ++count) {
        std::uint32_t length = 1;
        while (i + length < ids.size() && ids[i + length] == ids[i] + length) ++length;
        put_number(runs, ids[i] - end);
        put_number(runs, length);
        end = ids[i] + length;
        i += length;
    }
    put_number(bytes, count);
    bytes += runs;
    return ids;
}

std::vector<std::uint32_t> take_set(std::string_view& bytes) {
    std::vector<std::uint32_t> ids;
    std::uint32_t id = 0;
    for (std::uint32_t runs = take_number(bytes); runs > 0; --runs) {
        id += take_number(bytes);
        for (std::uint32_t length = take_number(bytes); length > 0; --length) ids.push_back(id++);
    }
    return ids;
}

/// The nearest to 0 of the angles that differ from `angle` by whole turns.
std::int32_t wrapped(std::int32_t angle, std::int32_t turn) { return ((angle + turn / 2) & (turn - 1)) - turn / 2; }

Place minus(const Place& a, const Place& b, std::int32_t turn) { return {a.x - b.x, a.y - b.y, wrapped(a.angle - b.angle, turn)}; }
Place plus(const Place& a, const Place& b, std::int32_t turn) { return {a.x + b.x, a.y + b.y, (a.angle + b.angle) & (turn - 1)}; }

constexpr std::int32_t small = 4;  // x and y up to this, and an angle up to 1, make a row of one byte
constexpr std::uint8_t not_small = 255;

void put_place(std::string& bytes, const Place& p) {
    if (std::abs(p.x) <= small && std::abs(p.y) <= small && std::abs(p.angle) <= 1) {
        bytes += static_cast<char>(((p.x + small) * (2 * small + 1) + p.y + small) * 3 + p.angle + 1);
        return;
    }
    bytes += static_cast<char>(not_small);
    put_signed(bytes, p.x);
    put_signed(bytes, p.y);
    put_signed(bytes, p.angle);
}

Place take_place(std::string_view& bytes) {
    const std::int32_t first = bytes.empty() ? 0 : static_cast<std::uint8_t>(bytes.front());
    bytes.remove_prefix(std::min<std::size_t>(1, bytes.size()));
    if (first != not_small) return {first / 3 / (2 * small + 1) - small, first / 3 % (2 * small + 1) - small, first % 3 - 1};
    const std::int32_t x = take_signed(bytes), y = take_signed(bytes), angle = take_signed(bytes);
    return {x, y, angle};
}

/// Writes how `was` becomes `now`; `put_more` writes what else is to be said of one that came.
template <class PutMore>
void put_table(std::string& bytes, const Table<Place>& was, const Table<Place>& now, Motion& motion, const PutMore& put_more) {
    put_set(bytes, now.size(), [&](std::size_t id) { return was.has(id) && !now.has(id); });
    Place before;
    for (const std::uint32_t id : put_set(bytes, now.size(), [&](std::size_t i) { return !was.has(i) && now.has(i); })) {
        put_place(bytes, minus(now.entries[id], before, motion.turn));
        put_more(id);
        before = now.entries[id];
    }
    motion.changes.resize(now.size());
    std::vector<Place> changes(now.size());
    const auto moved = [&](std::size_t id) { return was.has(id) && now.has(id) && was.entries[id] != now.entries[id]; };
    for (const std::uint32_t id : put_set(bytes, now.size(), moved)) {
        const Place expected = plus(was.entries[id], motion.changes[id], motion.turn);
        put_place(bytes, minus(now.entries[id], expected, motion.turn));
        changes[id] = minus(now.entries[id], was.entries[id], motion.turn);
    }
    motion.changes = std::move(changes);
}

template <class TakeMore>
void take_table(std::string_view& bytes, Table<Place>& table, Motion& motion, const TakeMore& take_more) {
    for (const std::uint32_t id : take_set(bytes)) table.live[id] = 0;
    Place before;
    for (const std::uint32_t id : take_set(bytes)) {
        before = plus(before, take_place(bytes), motion.turn);
        table.put(id, before);
        take_more(id);
    }
    motion.changes.resize(table.size());
    std::vector<Place> changes(table.size());
    for (const std::uint32_t id : take_set(bytes)) {
        const Place was = table.entries[id];
        table.entries[id] = plus(plus(was, motion.changes[id], motion.turn), take_place(bytes), motion.turn);
        changes[id] = minus(table.entries[id], was, motion.turn);
    }
    motion.changes = std::move(changes);
}

void put_figure(std::string& bytes, const JointFigure& figure) {
    put_number(bytes, static_cast<std::uint32_t>(figure.size()));
    JointPoint last;
    for (const JointMark& mark : figure) {
        put_number(bytes, 16 * static_cast<std::uint32_t>(mark.points.size()) + 4u * mark.look + mark.kind);
        if (mark.kind == JointMark::ring) put_signed(bytes, mark.radius);
        for (const JointPoint& point : mark.points) {
            if (point.frame != last.frame) last = {};
            put_number(bytes, 8 * folded(point.x - last.x) + point.frame);
            put_signed(bytes, point.y - last.y);
            last = point;
        }
    }
}

JointFigure take_figure(std::string_view& bytes) {
    JointFigure figure;
    JointPoint last;
    for (std::uint32_t marks = take_number(bytes); marks > 0 && !bytes.empty(); --marks) {
        const std::uint32_t head = take_number(bytes);
        JointMark mark{static_cast<JointMark::Kind>(head % 4), static_cast<JointMark::Look>(head / 4 % 4), 0, {}};
        if (mark.kind == JointMark::ring) mark.radius = take_signed(bytes);
        for (std::uint32_t points = head / 16; points > 0 && !bytes.empty(); --points) {
            const std::uint32_t x = take_number(bytes);
            const std::int32_t y = take_signed(bytes);
            const auto frame = static_cast<JointPoint::Frame>(x % 8);
            if (frame != last.frame) last = {};
            last = {frame, last.x + unfolded(x / 8), last.y + y};
            mark.points.push_back(last);
        }
        figure.push_back(std::move(mark));
    }
    return figure;
}

}  // namespace

void MovieWriter::add(const Frame& frame, const std::vector<JointFigure>& figures) {
    last_.looks.resize(frame.bodies.size());
    put_table(bytes_, last_.bodies, frame.bodies, bodies_, [&](std::uint32_t id) {
        put_number(bytes_, static_cast<std::uint32_t>(frame.looks[id]));
        put_number(bytes_, frame.models[id]);
        last_.looks[id] = frame.looks[id];
    });
    const auto looks_otherwise = [&](std::size_t id) { return frame.bodies.has(id) && frame.looks[id] != last_.looks[id]; };
    for (const std::uint32_t id : put_set(bytes_, frame.bodies.size(), looks_otherwise)) put_number(bytes_, static_cast<std::uint32_t>(frame.looks[id]));
    put_table(bytes_, last_.contacts, frame.contacts, contacts_, [](std::uint32_t) {});
    put_joints(frame.joints, figures);
    last_ = frame;
    ++frames_;
}

void MovieWriter::put_joints(const Table<JointEntry>& joints, const std::vector<JointFigure>& figures) {
    const Table<JointEntry>& was = last_.joints;
    const auto same = [&](std::size_t id) { return was.has(id) && joints.has(id) && was.entries[id] == joints.entries[id]; };
    put_set(bytes_, joints.size(), [&](std::size_t id) { return was.has(id) && !same(id); });
    numbers_.resize(figures.size());
    for (const std::uint32_t id : put_set(bytes_, joints.size(), [&](std::size_t i) { return joints.has(i) && !same(i); })) {
        const JointEntry& entry = joints.entries[id];
        std::uint32_t& number = numbers_[entry.figure];
        if (number != 0) {
            put_number(bytes_, number - 1);
        } else {
            put_number(bytes_, written_);
            put_figure(bytes_, figures[entry.figure]);
            number = ++written_;
        }
        put_number(bytes_, entry.body_b);
        put_number(bytes_, entry.body_a);
        if (entry.body_a != 0) continue;
        put_signed(bytes_, entry.x);
        put_signed(bytes_, entry.y);
    }
}

bool MovieReader::next() {
    if (bytes_.empty()) return false;
    const auto take_look = [this] { return static_cast<BodyLook>(take_number(bytes_)); };
    take_table(bytes_, frame_.bodies, bodies_, [&](std::uint32_t id) {
        frame_.models.resize(frame_.bodies.size());
        frame_.looks.resize(frame_.bodies.size());
        frame_.looks[id] = take_look();
        frame_.models[id] = take_number(bytes_);
    });
    for (const std::uint32_t id : take_set(bytes_)) frame_.looks[id] = take_look();
    take_table(bytes_, frame_.contacts, contacts_, [](std::uint32_t) {});
    take_joints();
    return true;
}

void MovieReader::take_joints() {
    for (const std::uint32_t id : take_set(bytes_)) frame_.joints.live[id] = 0;
    for (const std::uint32_t id : take_set(bytes_)) {
        JointEntry entry;
        entry.figure = take_number(bytes_);
        if (entry.figure == figures_.size()) figures_.push_back(take_figure(bytes_));
        entry.body_b = take_number(bytes_);
        entry.body_a = take_number(bytes_);
        if (entry.body_a == 0) {
            entry.x = take_signed(bytes_);
            entry.y = take_signed(bytes_);
        }
        frame_.joints.put(id, entry);
    }
}

}  // namespace islet::tools
