// Writing calls down as they are made.
#pragma once

#include "math/scalar.hpp"
#include "world/calls.hpp"

namespace islet::detail {

inline constexpr std::uint32_t recording_magic = 0x52746c49u;  // "IltR"
inline constexpr std::uint32_t recording_version = 1;

/// Where the calls begin.
constexpr std::size_t calls_at(std::uint64_t image_bytes) { return sizeof(RecordingHead) + (static_cast<std::size_t>(image_bytes) + 7) / 8 * 8; }

inline std::uint64_t mixed(std::uint64_t sum, std::uint32_t word) {
    sum = (sum ^ word) * 0xd6e8feb86659fd93ull;
    return sum ^ sum >> 32;
}

/// A hash of how a body stands and moves.
std::uint32_t body_digest(const Core& core, std::uint32_t body);

/// Appends words to the recording. A call that finds no room is left out, with all that follow.
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
    void one(std::span<const Vec2>& a) {
        word(static_cast<std::uint32_t>(a.size()));
        for (Vec2 p : a) members(*this, p);
    }
    template <class T>
    void one(T& a) {
        if constexpr (requires { members(*this, a); }) {
            members(*this, a);
        } else {
            word(static_cast<std::uint32_t>(a));  // an enumeration
        }
    }

    Core& core_;
    std::uint64_t begin_;  // of the call, bytes from the head
};

template <class... Args>
[[gnu::noinline]] void write_call(Core& core, Call call, Args... args) {
    CallWriter writer(core, call);
    writer(args...);
}

/// For the beginning of each public function that changes a world: writes the call down if the world is being recorded.
template <class... Args>
[[gnu::always_inline]] inline void note_call(Core& core, Call call, const Args&... args) {
    if constexpr (has_recorder) {
        if (core.recording != nullptr) [[unlikely]] write_call<Args...>(core, call, args...);
    }
}

/// The same for the snapshot a world was taken back to.
void write_image(Core& core, std::span<const std::byte> image);
/// What came of a step.
void write_stepped(Core& core, std::uint64_t hash);

}  // namespace islet::detail
