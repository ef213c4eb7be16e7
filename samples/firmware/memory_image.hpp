// Start-up of memory, and the measuring of the stack: the same on every board. The names come from firmware.ld.
#pragma once

#include <cstddef>
#include <cstdint>

extern "C" {
extern std::uint32_t image_data_source[], image_data[], image_data_end[], image_bss[], image_bss_end[], image_stack[], image_stack_top[];
}

namespace firmware {

inline constexpr std::uint32_t stack_paint = 0x51ac4ed5u;

/// Copies initialised variables from flash, clears the others, and paints the part of the stack below `here`. Call before anything else.
[[gnu::always_inline]] inline void prepare_memory() {
    const std::uint32_t* from = image_data_source;
    for (std::uint32_t* to = image_data; to != image_data_end;) *to++ = *from++;
    for (std::uint32_t* to = image_bss; to != image_bss_end;) *to++ = 0;
    // Not the few words at the top that the caller itself has there.
    std::uint32_t room = static_cast<std::uint32_t>(image_stack_top - image_stack) - 32;
    for (std::uint32_t* to = image_stack; room != 0; --room) *to++ = stack_paint;
}

/// Bytes of the stack that no longer bear the paint.
inline std::size_t painted_stack_used() {
    const std::uint32_t* at = image_stack;
    while (at != image_stack_top && *at == stack_paint) ++at;
    return static_cast<std::size_t>(image_stack_top - at) * 4;
}

}  // namespace firmware
