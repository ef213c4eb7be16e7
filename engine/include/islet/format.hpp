// The format numbers of what Islet writes, and functions that read the format of some bytes without loading them. docs/versions.md lists the formats of each
// version of Islet.
#pragma once

#include <cstddef>
#include <cstdint>

#include "islet/span.hpp"
#include "islet/version.hpp"
#include "islet/visibility.hpp"

ISLET_API_BEGIN
namespace islet {

/// The formats that this version writes, and the only ones it reads. A format number goes up when the meaning of the bytes changes.
inline constexpr std::uint32_t snapshot_format = 4;
inline constexpr std::uint32_t delta_format = snapshot_format;  // a delta leads from snapshot to snapshot
inline constexpr std::uint32_t recording_format = 2;

/// What some bytes are, by how they begin.
enum class FormatKind : std::uint8_t {
    unknown,    ///< nothing of Islet's
    snapshot,   ///< from World::save
    delta,      ///< from delta()
    recording,  ///< from World::start_recording
};

/// What read_format finds.
struct FormatInfo {
    FormatKind kind = FormatKind::unknown;
    std::uint32_t format = 0;       ///< of the bytes; 0 if unknown
    std::uint32_t readable = 0;     ///< the format of this kind that this version reads; 0 if unknown
    bool in_recording = false;      ///< true: the snapshot at the start of a recording. The format of the recording is readable, that of the snapshot is not
    bool other_byte_order = false;  ///< written by a machine of the other byte order
    /// Whether this version reads bytes of this format. They may be damaged nevertheless.
    constexpr bool is_readable() const { return kind != FormatKind::unknown && format == readable && !other_byte_order; }
};

/// Tells the kind and format of a snapshot, a delta or a recording from its first bytes, whatever version wrote it: 8 bytes are enough for the first two, 64
/// for a recording. Takes any bytes, at any alignment, and has no errors.
FormatInfo read_format(span<const std::byte> bytes);

/// Writes a sentence that names the kind, its format, and the version and format that would read it, such as "This is a snapshot of format 3; Islet 0.2.0 reads
/// format 4." `out` gets as much as there is room for, with a zero at its end. Returns the length of the whole sentence without the zero, at most 120.
std::size_t describe_format(const FormatInfo& info, span<char> out);

}  // namespace islet
ISLET_API_END
