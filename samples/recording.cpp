#include "recording.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace islet::samples {
namespace {

void put_number(std::string& bytes, std::uint32_t n) {
    for (; n >= 0x80; n >>= 7) bytes += static_cast<char>(n | 0x80);
    bytes += static_cast<char>(n);
}

void put_signed(std::string& bytes, std::int32_t n) {
    put_number(bytes, (static_cast<std::uint32_t>(n) << 1) ^ static_cast<std::uint32_t>(n >> 31));
}

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

std::int32_t take_signed(std::string_view& bytes) {
    const std::uint32_t n = take_number(bytes);
    return static_cast<std::int32_t>((n >> 1) ^ (0u - (n & 1)));
}

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

void put_joints(std::string& bytes, const Table<JointLine>& was, const Table<JointLine>& now) {
    const auto same = [&](std::size_t id) { return was.has(id) && now.has(id) && was.entries[id] == now.entries[id]; };
    put_set(bytes, now.size(), [&](std::size_t id) { return was.has(id) && !same(id); });
    for (const std::uint32_t id : put_set(bytes, now.size(), [&](std::size_t i) { return now.has(i) && !same(i); })) {
        put_number(bytes, static_cast<std::uint32_t>(now.entries[id].size()));
        for (const JointPoint& point : now.entries[id]) {
            put_number(bytes, 2 * point.frame + (point.is_dot ? 1 : 0));
            put_signed(bytes, point.x);
            put_signed(bytes, point.y);
        }
    }
}

void take_joints(std::string_view& bytes, Table<JointLine>& joints) {
    for (const std::uint32_t id : take_set(bytes)) joints.live[id] = 0;
    for (const std::uint32_t id : take_set(bytes)) {
        JointLine line;
        for (std::uint32_t count = take_number(bytes); count > 0 && !bytes.empty(); --count) {
            const std::uint32_t frame = take_number(bytes);
            const std::int32_t x = take_signed(bytes), y = take_signed(bytes);
            line.push_back({frame / 2, frame % 2 != 0, x, y});
        }
        joints.put(id, line);
    }
}

}  // namespace

void RecordingWriter::add(const Frame& frame) {
    last_.awake.resize(frame.bodies.size());
    put_table(bytes_, last_.bodies, frame.bodies, bodies_, [&](std::uint32_t id) {
        put_number(bytes_, frame.kinds[id].type);
        put_number(bytes_, frame.kinds[id].model);
        last_.awake[id] = 1;
    });
    put_set(bytes_, frame.bodies.size(), [&](std::size_t id) { return frame.bodies.has(id) && frame.awake[id] != last_.awake[id]; });
    put_table(bytes_, last_.contacts, frame.contacts, contacts_, [](std::uint32_t) {});
    put_joints(bytes_, last_.joints, frame.joints);
    last_ = frame;
    ++frames_;
}

bool RecordingReader::next() {
    if (bytes_.empty()) return false;
    take_table(bytes_, frame_.bodies, bodies_, [&](std::uint32_t id) {
        frame_.kinds.resize(frame_.bodies.size());
        frame_.awake.resize(frame_.bodies.size());
        frame_.kinds[id].type = take_number(bytes_);
        frame_.kinds[id].model = take_number(bytes_);
        frame_.awake[id] = 1;
    });
    for (const std::uint32_t id : take_set(bytes_)) frame_.awake[id] ^= 1;
    take_table(bytes_, frame_.contacts, contacts_, [](std::uint32_t) {});
    take_joints(bytes_, frame_.joints);
    return true;
}

}  // namespace islet::samples
