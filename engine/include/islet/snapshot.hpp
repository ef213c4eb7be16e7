// Snapshots: the persistent state of a world as a sequence of bytes (an image), to roll back, to keep a state, or to continue on another machine. A delta is
// the difference of two images.
//
// World::save makes an image. World::restore goes back to an image that this program made, and World::load to one from outside. An image holds everything
// that the next step depends on, and nothing else: a world that continues from it gives the same bits, and the same ids. Images are the same on all
// little-endian machines of 32 and 64 bits. Big-endian machines write another kind; each machine refuses the other's (Error::other_byte_order).
#pragma once

#include <cstddef>
#include <cstdint>

#include "islet/layout.hpp"
#include "islet/span.hpp"
#include "islet/types.hpp"

ISLET_API_BEGIN
namespace islet {

/// Alignment that World::load demands of an image, bytes. The other functions take any.
inline constexpr std::size_t snapshot_alignment = 8;

/// The most bytes that a snapshot of a world of this capacity can need. World::snapshot_bytes says how many it needs now.
constexpr std::size_t max_snapshot_bytes(const Capacity& capacity) {
    using namespace detail;
    std::size_t bytes = image_header_bytes + capacity.contacts * sizeof(TouchEvent);  // of touches that ended since the last step
    for (const ArrayRow& row : array_rows)
        if (row.kept == Kept::saved) bytes += row.image_bytes(room_for(row.per, capacity));
    return bytes;
}

/// What an image says about itself.
struct SnapshotInfo {
    std::uint64_t bytes = 0;  ///< of the whole image
    Capacity capacity = {};   ///< of the saved world, as the image claims; a forged image may claim any that holds its records
    Capacity used = {};       ///< the least capacity that can hold the image: as many records as it has
};

/// Reads the header of an image, and nothing else. Errors: not_an_image; other_byte_order; other_version; truncated_image; corrupt_image if the header
/// contradicts itself.
Error read_snapshot(span<const std::byte> image, SnapshotInfo& out);

/// The most bytes that delta() can need to lead to an image of this size, whatever image it starts from.
constexpr std::size_t max_delta_bytes(std::size_t to_bytes) { return detail::delta_header_bytes + detail::image_header_bytes + to_bytes + to_bytes / 8 + 64; }

/// Packs what changed between two images, for sending or for long histories: apply(from, delta) gives `to` again. Returns the bytes written to `out`, or 0
/// with *error set, if given: the errors of read_snapshot for either image; image_too_small if `out` is too small. `out` must not overlap the images.
std::size_t delta(span<const std::byte> from, span<const std::byte> to, span<std::byte> out, Error* error = nullptr);

/// Writes to `out` the image to which `delta` leads from the image `from`. Returns the bytes written, or 0 with *error set, if given: the errors of
/// read_snapshot, for the image and in the same sense for the delta; corrupt_image also if the delta is hostile; wrong_delta if it starts from another image
/// than `from`; image_too_small if `out` is too small. After an error `out` holds nothing of use. The result can be trusted no more than the delta: use
/// World::load for it, unless this program made both. `out` must not overlap `from` or `delta`.
std::size_t apply(span<const std::byte> from, span<const std::byte> delta, span<std::byte> out, Error* error = nullptr);

class World;

/// Copies a world into another block, for example into a larger one when it has grown full. The new world has the same state, ids, settings, hooks, tasks and
/// clock, but no recording; the old one stays as it is. `image` is memory that is used during the call only, at least from.snapshot_bytes() bytes. Returns null
/// with *error set, if given: the errors of World::create for the block and the capacity; image_too_small; image_too_large if the capacity cannot hold what
/// the world holds; in_step.
World* copy_world(const World& from, span<std::byte> block, const Capacity& capacity, span<std::byte> image, Error* error = nullptr);

}  // namespace islet
ISLET_API_END
