#include "../exact.hpp"

#include "../calls/recorder.hpp"

#include "islet/recording.hpp"

namespace islet {

using namespace detail;

namespace detail {

std::uint32_t body_digest(const Core& core, std::uint32_t body) {
    const Pose& pose = core.poses[body];
    const Motion& motion = core.motions[body];
    std::uint64_t sum = mixed(0x9e3779b97f4a7c15ull, body);
    for (const float a : {pose.center.x, pose.center.y, pose.q.c, pose.q.s, motion.v.x, motion.v.y, motion.w}) sum = mixed(sum, bits_of(a));
    return static_cast<std::uint32_t>(sum);
}

namespace {

std::byte* bytes_of(RecordingHead* head) { return reinterpret_cast<std::byte*>(head); }

/// Appends words to the recording. A call that finds no room is left out, and ends the recording.
class CallWriter {
public:
    CallWriter(Core& core, Call call);
    /// Completes the call.
    ~CallWriter();
    CallWriter(const CallWriter&) = delete;
    CallWriter& operator=(const CallWriter&) = delete;

    void word(std::uint32_t w);
    void long_word(std::uint64_t w) {
        word(static_cast<std::uint32_t>(w));
        word(static_cast<std::uint32_t>(w >> 32));
    }
    template <class... T>
    void operator()(T&... values) {
        (one(values), ...);
    }

private:
    void one(float& a) { word(bits_of(a)); }
    void one(bool& a) { word(a ? 1 : 0); }
    void one(std::uint32_t& a) { word(a); }
    void one(std::int32_t& a) { word(static_cast<std::uint32_t>(a)); }
    void one(std::uint64_t& a) { long_word(a); }
    void one(span<const Vec2>& a) {
        word(static_cast<std::uint32_t>(a.size()));
        for (Vec2 p : a) members(*this, p);
    }
    template <class T>
    void one(T& a) {
        if constexpr (has_members<T>) {
            members(*this, a);
        } else {
            word(static_cast<std::uint32_t>(a));  // an enumeration
        }
    }

    Core& core_;
    std::uint64_t begin_;  // of the call, bytes from the head
};

template <class... Args>
ISLET_NEVER_INLINE void write_arguments(CallWriter& writer, const void* const* arguments) {
    const auto write = [&writer](auto copy) { writer(copy); };
    (write(*static_cast<const Args*>(*arguments++)), ...);
}

CallWriter::CallWriter(Core& core, Call call) : core_(core), begin_(core.recording->used) { word(static_cast<std::uint32_t>(call)); }

void CallWriter::word(std::uint32_t w) {
    RecordingHead* head = core_.recording;
    if (head->full != 0) return;
    if (head->size - head->used < 4) {
        head->full = 1;
        return;
    }
    ISLET_MEMCPY(bytes_of(head) + head->used, &w, 4);
    head->used += 4;
}

CallWriter::~CallWriter() {
    RecordingHead* head = core_.recording;
    if (head->full != 0) {
        head->used = begin_;
        core_.recording = nullptr;
        core_.fail(Error::recording_full);
        return;
    }
    for (std::uint64_t at = begin_; at < head->used; at += 4) {
        std::uint32_t w = 0;
        ISLET_MEMCPY(&w, bytes_of(head) + at, 4);
        head->sum = mixed(head->sum, w);
    }
}

}  // namespace

void write_call(Core& core, Call call, const void* const* arguments) {
    if (core.inside != outside) return;  // the call will be refused (in_step), but a replay would make it outside of a step
    CallWriter writer(core, call);
    switch (call) {
#define ISLET_WRITE(name, function, ...) \
    case Call::name: return write_arguments<__VA_ARGS__>(writer, arguments);
        ISLET_CALLS(ISLET_WRITE)
#undef ISLET_WRITE
        default: return;
    }
}

void write_image(Core& core, span<const std::byte> image) {
    CallWriter writer(core, Call::image);
    writer.long_word(image.size());
    if (core.recording->used % 8 != 0) writer.word(0);
    for (std::size_t at = 0; at < image.size(); at += 4) {
        std::uint32_t w = 0;
        ISLET_MEMCPY(&w, image.data() + at, image.size() - at < 4 ? image.size() - at : 4);
        writer.word(w);
    }
}

void write_stepped(World& world) {
    Core& core = Core::of(world);
    const std::uint64_t sum = core.recording->sum;
    CallWriter writer(core, Call::stepped);
    writer.long_word(sum);
    writer.long_word(world.hash());
    if (core.recording->bodies == 0) return writer.word(0);
    writer.word(core.awake_bodies.count());
    core.awake_bodies.for_each([&](std::uint32_t body) { writer.word(body_digest(core, body)); });
}

}  // namespace detail

bool World::start_recording(span<std::byte> buffer, bool bodies) {
    Core& c = core();
    if (!check_open(c) || !check_there(c, has_recorder)) return false;
    if (!check(c, reinterpret_cast<std::uintptr_t>(buffer.data()) % recording_alignment == 0, Error::image_misaligned)) return false;
    const std::size_t image_bytes = snapshot_bytes();
    if (!check(c, buffer.size() >= calls_at(image_bytes), Error::recording_full)) return false;
    RecordingHead head{recording_magic, recording_version, image_bytes, buffer.size() / 8 * 8, calls_at(image_bytes), 0, bodies ? 1u : 0u, 0};
    std::memset(buffer.data() + sizeof head, 0, static_cast<std::size_t>(head.used) - sizeof head);
    save(buffer.subspan(sizeof head, image_bytes));
    std::memcpy(buffer.data(), &head, sizeof head);
    c.recording = reinterpret_cast<RecordingHead*>(buffer.data());
    return true;
}

bool World::is_recording() const { return core().recording != nullptr; }

std::size_t World::recorded_bytes() const { return core().recording != nullptr ? static_cast<std::size_t>(core().recording->used) : 0; }

bool World::move_recording(span<std::byte> buffer) {
    Core& c = core();
    RecordingHead* head = c.recording;
    if (!check_open(c) || !check(c, head != nullptr, Error::not_a_recording)) return false;
    if (!check(c, reinterpret_cast<std::uintptr_t>(buffer.data()) % recording_alignment == 0, Error::image_misaligned)) return false;
    if (!check(c, buffer.size() / 8 * 8 >= head->used, Error::recording_full)) return false;
    std::memmove(buffer.data(), head, static_cast<std::size_t>(head->used));
    c.recording = reinterpret_cast<RecordingHead*>(buffer.data());
    c.recording->size = buffer.size() / 8 * 8;
    return true;
}

std::size_t World::stop_recording() {
    Core& c = core();
    if (!check_open(c) || !check(c, c.recording != nullptr, Error::not_a_recording)) return 0;
    {
        const std::uint64_t sum = c.recording->sum;
        CallWriter writer(c, Call::ended);
        writer.long_word(sum);
    }
    RecordingHead* head = c.recording;
    if (head == nullptr) return 0;  // there was no room even for this (recording_full)
    c.recording = nullptr;
    head->size = head->used;
    return static_cast<std::size_t>(head->used);
}

}  // namespace islet
