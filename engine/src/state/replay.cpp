// Replays: making recorded calls again.
//
// Nothing of a recording is trusted. World::load checks a snapshot, each call checks its arguments, and CallReader checks the bounds of every read. A sum at
// each step shows whether the calls before it are the recorded ones.
#include "../exact.hpp"

#include "islet/recording.hpp"

#include "../calls/checks.hpp"
#include "../calls/recorder.hpp"
#include "islet/snapshot.hpp"

namespace islet {

using namespace detail;

namespace {

class CallReader {
public:
    CallReader(const std::byte* head, std::size_t at, std::size_t end) : head_(head), at_(at), end_(end) {}

    bool at_end() const { return at_ == end_; }
    bool is_bad() const { return bad_; }
    std::uint64_t sum() const { return sum_; }

    /// Returns 0 and notes the fault beyond the end.
    std::uint32_t word() {
        std::uint32_t w = 0;
        if (end_ - at_ < 4) {
            bad_ = true;
            return w;
        }
        std::memcpy(&w, head_ + at_, 4);
        at_ += 4;
        sum_ = mixed(sum_, w);
        return w;
    }
    std::uint64_t long_word() {
        const std::uint64_t low = word();
        return low | std::uint64_t{word()} << 32;
    }
    /// So many bytes, padded to words. Returns none and notes the fault beyond the end.
    span<const std::byte> bytes(std::uint64_t size) {
        const std::size_t begin = at_;
        if (size > end_ - at_) bad_ = true;
        for (std::uint64_t read = 0; read < size && !bad_; read += 4) word();
        return bad_ ? span<const std::byte>{} : span{head_ + begin, static_cast<std::size_t>(size)};
    }
    span<const std::byte> image() {
        const std::uint64_t size = long_word();
        if (at_ % 8 != 0) word();
        return bytes(size);
    }

    template <class T>
    T value() {
        T a{};
        one(a);
        return a;
    }
    template <class... T>
    void operator()(T&... values) {
        (one(values), ...);
    }

private:
    void one(float& a) { a = __builtin_bit_cast(float, word()); }
    void one(bool& a) { a = word() != 0; }
    void one(std::uint32_t& a) { a = word(); }
    void one(std::int32_t& a) { a = static_cast<std::int32_t>(word()); }
    void one(std::uint64_t& a) { a = long_word(); }
    void one(span<const Vec2>& a) {
        const std::uint32_t count = word();
        a = {reinterpret_cast<const Vec2*>(bytes(std::uint64_t{count} * sizeof(Vec2)).data()), bad_ ? 0 : count};
    }
    template <class T>
    void one(T& a) {
        if constexpr (has_members<T>) {
            members(*this, a);
        } else {
            const std::uint32_t w = word();  // an enumeration of a byte
            a = static_cast<T>(w < 256 ? w : 255);
        }
    }

    const std::byte* head_;
    std::size_t at_, end_;
    std::uint64_t sum_ = 0;
    bool bad_ = false;
};

/// Calls function(argument...) with arguments of the given types as they follow. (Braces evaluate from left to right.)
struct Apply {
    template <class Function, class... Args>
    Apply(const CallReader& reader, const Function& function, Args... args) {
        if (!reader.is_bad()) function(args...);
    }
};
// Not inlined, so that the stack holds the arguments of only one call at a time.
template <class... Args, class Function>
ISLET_NEVER_INLINE void make(CallReader& reader, const Function& function) {
    Apply{reader, function, reader.value<Args>()...};
}

// Returns false if there is no such call.
bool make_call(World& world, CallReader& reader, Call call) {
    switch (call) {
#define ISLET_MAKE(name, function, ...) \
    case Call::name: make<__VA_ARGS__>(reader, [&](const auto&... args) { world.function(args...); }); return true;
        ISLET_CALLS(ISLET_MAKE)
#undef ISLET_MAKE
        default: return false;
    }
}

Error read_head(span<const std::byte> recording, RecordingHead& head) {
    if (reinterpret_cast<std::uintptr_t>(recording.data()) % recording_alignment != 0) return Error::image_misaligned;
    if (recording.size() < sizeof head) return Error::not_a_recording;
    std::memcpy(&head, recording.data(), sizeof head);
    if (head.magic == swapped_bytes(recording_magic)) return Error::other_byte_order;
    if (head.magic != recording_magic) return Error::not_a_recording;
    if (head.version != recording_version) return Error::other_version;
    if (head.used > recording.size() || head.size < head.used) return Error::truncated_image;
    const bool fits = head.image_bytes <= head.used && calls_at(head.image_bytes) <= head.used && head.used % 4 == 0;
    return fits && head.bodies <= 1 && head.full <= 1 ? Error::none : Error::corrupt_recording;
}

// Compares the recorded hashes of bodies that follow with the world; finds the first body that came out differently.
BodyId differing_body(const Core& core, CallReader& reader, std::uint32_t recorded) {
    BodyId differs;
    std::uint32_t at = 0;
    core.awake_bodies.for_each([&](std::uint32_t body) {
        if (differs || recorded == 0) return;
        const bool same = at < recorded && reader.word() == body_digest(core, body);
        ++at;
        if (!same) differs = core.body_id(body);
    });
    return differs;
}

// -- the capacity that a replay needs -------------------------------------------------------------------------------------------------

/// Counts the words of what it visits, as CallWriter writes them.
struct WordCount {
    std::uint32_t words = 0;

    template <class... T>
    constexpr void operator()(T&... values) {
        (one(values), ...);
    }
    template <class T>
    constexpr void one(T& a) {
        if constexpr (has_members<T>) {
            members(*this, a);
        } else {
            words += sizeof(T) == 8 ? 2 : 1;
        }
    }
    constexpr void one(span<const Vec2>&) { ++words; }  // their number; they follow
};

template <class... Args>
constexpr std::uint8_t words_of() {
    WordCount count;
    const auto add = [&count](auto a) { count(a); };
    (add(Args{}), ...);
    return static_cast<std::uint8_t>(count.words);
}

// Words that the arguments of each call take, in the order of the table, whose first call is first_call.
constexpr std::uint8_t argument_words[] = {
#define ISLET_WORDS(name, function, ...) words_of<__VA_ARGS__>(),
    ISLET_CALLS(ISLET_WORDS)
#undef ISLET_WORDS
};
constexpr auto first_call = static_cast<std::uint32_t>(Call::image) + 1;

bool makes_joint(Call call) {
#define ISLET_IS(type, definition) || call == Call::create_##type##_joint
    return false ISLET_JOINT_TYPES(ISLET_IS);
#undef ISLET_IS
}

bool is_between(Call call, Call first, Call last) { return call >= first && call <= last; }

void raise_to(std::uint32_t& a, std::uint32_t b) { a = a > b ? a : b; }

/// What the snapshots of a recording hold, and what its calls create. The walk ends at the first unsound call, as a replay does.
struct Contents {
    Capacity held;
    std::uint64_t bodies = 0, shapes = 0, joints = 0;  // made

    void add(span<const std::byte> image) {
        SnapshotInfo info;
        if (read_snapshot(image, info) != Error::none) return;
        raise_to(held.bodies, info.used.bodies);
        raise_to(held.shapes, info.used.shapes);
        raise_to(held.contacts, info.used.contacts);
        raise_to(held.joints, info.used.joints);
        raise_to(held.geometries, info.used.geometries);
    }

    // Reads one call. False at the end, or if the call is not sound.
    bool add_call(CallReader& reader) {
        const std::uint32_t number = reader.word();
        const auto call = static_cast<Call>(number);
        if (reader.is_bad() || call == Call::ended) return false;
        if (call == Call::image) {
            add(reader.image());
        } else if (call == Call::stepped) {
            reader.bytes(16);
            reader.bytes(std::uint64_t{4} * reader.word());
        } else if (number - first_call < sizeof argument_words) {
            if (call == Call::create_body) ++bodies;
            if (is_between(call, Call::create_circle, Call::create_chain_segment)) ++shapes;
            if (makes_joint(call)) ++joints;
            const std::uint32_t words = argument_words[number - first_call];
            if (call == Call::create_chain) {
                reader.bytes(8);  // the body
                const std::uint64_t points = reader.word();
                reader.bytes(8 * points + 4 * (words - 3));
                shapes += points;
            } else {
                reader.bytes(std::uint64_t{4} * words);
            }
        } else {
            return false;
        }
        return !reader.is_bad();
    }

    /// The part of this capacity that the recording could ever fill.
    Capacity bounded(const Capacity& c) const {
        const auto least = [](std::uint32_t room, std::uint64_t wanted) { return static_cast<std::uint32_t>(room < wanted ? room : wanted); };
        Capacity n;
        n.bodies = least(c.bodies, held.bodies + bodies);
        n.shapes = least(c.shapes, held.shapes + shapes);
        // Each pair of shapes has at most one contact. Its touch may end in a step and once more before the next, and ended touches need as much room.
        const std::uint64_t twice_pairs = std::uint64_t{n.shapes} * n.shapes;
        n.contacts = least(c.contacts, twice_pairs > held.contacts ? twice_pairs : held.contacts);
        n.joints = least(c.joints, held.joints + joints);
        n.geometries = least(geometry_capacity(c), n.shapes > held.geometries ? n.shapes : held.geometries);
        n.hits = least(hit_capacity(c), n.contacts);
        return n;
    }
};

ReplayResult refused(Error error, std::uint64_t steps) { return {ReplayEnd::refused, error, steps, 0, 0, {}}; }

// Compares the result of a step with the recorded one. The replay goes on while result.end is complete.
void compare(World& world, CallReader& reader, std::uint64_t sum, bool bodies, ReplayResult& result) {
    const Core& core = Core::of(world);
    const std::uint64_t recorded_sum = reader.long_word();
    result.recorded_hash = reader.long_word();
    result.hash = world.hash();
    const std::uint32_t count = reader.word();
    if (reader.is_bad() || recorded_sum != sum || (count != 0 && !bodies)) {
        result = refused(Error::corrupt_recording, result.steps);
    } else if (result.hash != result.recorded_hash) {
        result.end = ReplayEnd::differs;
        result.body = differing_body(core, reader, count);
    } else {
        for (std::uint32_t i = 0; i < count && !reader.is_bad(); ++i) reader.word();
    }
}

}  // namespace

Error read_recording(span<const std::byte> recording, RecordingInfo& out) {
    RecordingHead head;
    const Error error = read_head(recording, head);
    if (error != Error::none) return error;
    SnapshotInfo info;
    const Error wrong = read_snapshot(recording.subspan(sizeof head, static_cast<std::size_t>(head.image_bytes)), info);
    if (wrong != Error::none) return wrong;
    Contents contents;
    contents.add(recording.subspan(sizeof head, static_cast<std::size_t>(head.image_bytes)));
    CallReader reader(recording.data(), calls_at(head.image_bytes), static_cast<std::size_t>(head.used));
    while (!reader.at_end() && contents.add_call(reader)) {}
    out = {info.capacity, contents.bounded(info.capacity), head.used, head.bodies != 0};
    return Error::none;
}

ReplayResult replay(World& world, span<const std::byte> recording, std::uint64_t steps) {
    RecordingHead head;
    const Error error = read_head(recording, head);
    if (error != Error::none) return refused(error, 0);
    if (!world.load(recording.subspan(sizeof head, static_cast<std::size_t>(head.image_bytes)))) return refused(world.last_error(), 0);
    const std::size_t first = calls_at(head.image_bytes);
    for (std::size_t at = sizeof head + static_cast<std::size_t>(head.image_bytes); at < first; ++at)
        if (recording[at] != std::byte{0}) return refused(Error::corrupt_recording, 0);

    CallReader reader(recording.data(), first, static_cast<std::size_t>(head.used));
    ReplayResult result;
    while (!reader.at_end()) {
        if (result.steps == steps) {
            result.end = ReplayEnd::stopped;
            return result;
        }
        const std::uint64_t sum = reader.sum();
        const auto call = static_cast<Call>(reader.word());
        if (call == Call::ended) {
            const bool whole = reader.long_word() == sum && reader.at_end() && reader.sum() == head.sum && head.size == head.used && head.full == 0;
            return whole ? result : refused(Error::corrupt_recording, result.steps);
        }
        if (call == Call::stepped) {
            ++result.steps;
            compare(world, reader, sum, head.bodies != 0, result);
            if (result.end != ReplayEnd::complete) return result;
        } else if (call == Call::image) {
            const span<const std::byte> image = reader.image();
            if (reader.is_bad() || !world.load(image)) return refused(Error::corrupt_recording, result.steps);
        } else if (!make_call(world, reader, call)) {
            return refused(Error::corrupt_recording, result.steps);
        }
        if (reader.is_bad()) return refused(Error::corrupt_recording, result.steps);
    }
    return result;  // the recording was never ended: the program stopped, or there was no more room
}

}  // namespace islet
