// The format of a snapshot: a header, then the used prefixes of the world's arrays, one after the other, each a straight copy. (In the small profile contacts
// are widened to what the whole engine has: image_records.hpp.)
//
// Every part is a multiple of 8 bytes long, so all parts are aligned as their records need. Arrays that follow from others are left out: the set of pairs
// follows from the contacts, and the buckets from the geometries.
#pragma once

#include <cstring>
#include <type_traits>

#include "../data/arrays.hpp"
#include "../state/image_records.hpp"
#include "islet/format.hpp"

namespace islet::detail {

inline constexpr std::uint32_t image_magic = 0x544c5349u;        // "ISLT" on a little-endian machine, "TLSI" on a big-endian one
inline constexpr std::uint32_t delta_magic = 0x444c5349u;        // "ISLD"
inline constexpr std::uint32_t image_version = snapshot_format;  // goes up when a record changes

/// The beginning of images and deltas.
struct ImageHead {
    std::uint32_t magic = 0;
    std::uint32_t version = image_version;
    std::uint64_t length = 0;    // bytes, all of them
    std::uint64_t checksum = 0;  // of all bytes after it
};

struct ImageHeader {
    ImageHead head{image_magic};
    std::uint32_t room[6] = {};  // the capacity of the world that was saved: bodies, shapes, contacts, joints, geometries, hits
    Counts used;
    std::uint32_t ended = 0;           // touches that ended since the last step, not yet reported
    std::uint32_t ended_overlaps = 0;  // of sensors

    Capacity capacity() const { return {room[0], room[1], room[2], room[3], room[4], room[5]}; }
    void set_capacity(const Capacity& c) {
        const std::uint32_t all[] = {c.bodies, c.shapes, c.contacts, c.joints, c.geometries, c.hits};
        std::memcpy(room, all, sizeof room);
    }
};

static_assert(sizeof(ImageHeader) == image_header_bytes && sizeof(ImageHeader) % 8 == 0);

/// An image seen as the arrays of a world, without copying it: a Core, with contacts as images have them.
struct WideContactsView : Core {
    const ImageContact* contacts = nullptr;
    const ImageManifold* manifolds = nullptr;
};
using ImageView = std::conditional_t<is_image_record<Contact>, Core, WideContactsView>;

/// Calls visit(pointer, bytes) for each array of the image, in its order, with the length that the header gives its used prefix. No count in the header may
/// exceed max_capacity. `core` may be const; otherwise `visit` may set the pointer.
template <class AnyCore, class Visit>
void for_each_part(AnyCore& core, const ImageHeader& h, Visit&& visit) {
    for_each_array(core, [&](auto& array, auto row) {
        if constexpr (row.kept == Kept::saved) visit(memory_of(array), row.image_bytes(h.used.of<row.per>()));
    });
    visit(core.end_events, std::size_t{h.ended} * sizeof(TouchEvent));
    visit(core.sensor_ends.events, std::size_t{h.ended_overlaps} * sizeof(SensorEvent));
}

/// The number of arrays in an image.
inline constexpr std::uint32_t part_count = [] {
    std::uint32_t n = 2;  // the two of events
    for (const ArrayRow& row : array_rows) n += row.kept == Kept::saved ? 1u : 0u;
    return n;
}();

/// Calls visit(set, bits in use) for each set of bits that an image holds.
template <class Visit>
void for_each_bit_set(Core& core, const ImageHeader& h, Visit&& visit) {
    for_each_array(core, [&](auto& array, auto row) {
        if constexpr (row.size == one_bit && row.kept == Kept::saved) visit(array, h.used.of<row.per>());
    });
}

/// Bytes of an image with this header.
inline std::uint64_t image_length(const ImageHeader& h) {
    std::uint64_t bytes = sizeof(ImageHeader);
    Core nowhere;
    for_each_part(nowhere, h, [&](auto&, std::size_t part) { bytes += part; });
    return bytes;
}

/// Reads the head of an image or a delta that must be at least `least` bytes long. Returns an error of the head alone: kind, byte order, version or length.
Error read_head(span<const std::byte> bytes, std::uint32_t magic, std::size_t least, ImageHead& head);

/// The same for the whole header of an image, including its counts.
Error read_header(span<const std::byte> image, ImageHeader& h);

/// The checksum of an image or a delta: of all bytes after its head.
std::uint64_t image_checksum(span<const std::byte> bytes);

/// The header of an image of the world as it is now, without checksum.
ImageHeader header_of(const Core& core);

}  // namespace islet::detail
