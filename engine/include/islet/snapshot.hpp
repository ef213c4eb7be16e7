// Snapshots: the persistent state of a world as one block of bytes, to roll back to, to keep, or to continue on another machine; and the
// difference of two of them.
//
// Take one with World::save, go back with World::restore (images this program made) or World::load (images from outside). An image holds
// everything the next step depends on, and nothing else: a world that continues from it gives the same bits, ids handed out afterwards included.
// It is the same on all little-endian machines of 32 and 64 bits; a big-endian one writes its own kind, and each refuses the other's
// (Error::other_byte_order).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "islet/layout.hpp"
#include "islet/types.hpp"

ISLET_API_BEGIN
namespace islet {

/// Alignment that World::load demands of an image, bytes. The other functions take any.
inline constexpr std::size_t snapshot_alignment = 8;

/// Most bytes that a snapshot of a world of this capacity can need. World::snapshot_bytes says how many it needs now.
constexpr std::size_t max_snapshot_bytes(const Capacity& capacity) {
    using namespace detail;
    std::size_t bytes = image_header_bytes + capacity.contacts * sizeof(TouchEvent);  // of touches that ended since the last step
    for (const ArrayRow& row : array_rows)
        if (row.kept == Kept::saved) bytes += row.bytes(room_for(row.per, capacity));
    return bytes;
}

/// What an image says about itself.
struct SnapshotInfo {
    std::uint64_t bytes = 0;  ///< of the whole image
    Capacity capacity = {};   ///< of the world it was taken of, as the image claims: a forged image may claim any that holds its records
    Capacity used = {};       ///< the least capacity that can hold it: as many records as the image has
};

/// Reads the head of an image; the rest is not looked at. Errors: not_an_image, other_byte_order, other_version, truncated_image, and corrupt_image if
/// the head contradicts itself.
Error read_snapshot(std::span<const std::byte> image, SnapshotInfo& out);

/// Most bytes that delta() can need, whatever it starts from, when it leads to an image of this size.
constexpr std::size_t max_delta_bytes(std::size_t to_bytes) { return detail::delta_header_bytes + detail::image_header_bytes + to_bytes + to_bytes / 8 + 64; }

/// Packs what changed between two images, for sending or for long histories: apply(from, delta) gives `to` again. Returns the bytes written to
/// `out`, or 0 with *error set if given: what read_snapshot finds wrong with either image, or image_too_small if `out` is. `out` may not
/// overlap the images.
std::size_t delta(std::span<const std::byte> from, std::span<const std::byte> to, std::span<std::byte> out, Error* error = nullptr);

/// The image that `delta` leads to from the image `from`. Returns the bytes written to `out`, or 0 with *error set if given: what read_snapshot finds
/// wrong with the image or, for a delta, would; corrupt_image also if the delta is hostile; wrong_delta if it starts from another image than `from`;
/// image_too_small if `out` is. `out` then holds nothing of use. The result is as trustworthy as the delta: load it, unless this program made both.
/// `out` may not overlap what it is made from.
std::size_t apply(std::span<const std::byte> from, std::span<const std::byte> delta, std::span<std::byte> out, Error* error = nullptr);

}  // namespace islet
ISLET_API_END
