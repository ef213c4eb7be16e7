// Records calls as they are made.
#pragma once

#include "../calls/calls.hpp"
#include "../calls/checks.hpp"
#include "../math/checksum.hpp"
#include "../math/scalar.hpp"
#include "islet/format.hpp"

namespace islet::detail {

inline constexpr std::uint32_t recording_magic = 0x52746c49u;  // "IltR"
inline constexpr std::uint32_t recording_version = recording_format;

/// Where the calls begin.
constexpr std::size_t calls_at(std::uint64_t image_bytes) { return sizeof(RecordingHead) + (static_cast<std::size_t>(image_bytes) + 7) / 8 * 8; }

/// A hash of a body's pose and velocity.
std::uint32_t body_digest(const Core& core, std::uint32_t body);

/// Records a call. `arguments` points to its arguments, with the types that the table of calls gives.
/// Only programs that record link this function: World::start_recording refers to it, and in other programs core.recording is null.
ISLET_OPTIONAL void write_call(Core& core, Call call, const void* const* arguments);
/// The same for the image that a world was taken back to.
ISLET_OPTIONAL void write_image(Core& core, span<const std::byte> image);
/// The same for the result of a step.
ISLET_OPTIONAL void write_stepped(World& world);

template <class... Args>
struct Signature {};
template <Call call>
struct SignatureOf;
#define ISLET_SIGNATURE(name, function, ...) \
    template <>                              \
    struct SignatureOf<Call::name> {         \
        using Type = Signature<__VA_ARGS__>; \
    };
ISLET_CALLS(ISLET_SIGNATURE)
#undef ISLET_SIGNATURE

/// Records a call, if the world is being recorded, and forgets the plan that the call may change. Each public function that changes a world begins with this.
template <Call call, class... Args>
ISLET_ALWAYS_INLINE inline void note_call(Core& core, const Args&... args) {
    static_assert(__is_same(typename SignatureOf<call>::Type, Signature<Args...>));
    if constexpr (!keeps_plan_of(call)) core.forget_plan();
    if constexpr (has_recorder) {
        if (core.recording == nullptr) [[likely]]
            return;
        const void* const arguments[] = {&args...};
        write_call(core, call, arguments);
    }
}

/// An object that a call changes: the world's core, and the object's slot, or null_index with the error recorded.
struct Found {
    Core& core;
    std::uint32_t slot;
};

/// Begins a call with an id: records it, and finds the object.
template <Call call, class Id, class... Args>
ISLET_ALWAYS_INLINE inline Found begin_call(Core& core, const Id& id, const Args&... args) {
    note_call<call>(core, id, args...);
    return {core, find_slot(core, id)};
}

}  // namespace islet::detail
