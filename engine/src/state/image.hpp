// The format of a snapshot: a header, then the used prefixes of the world's arrays, one after the other, each a straight copy.
//
// Every part is a multiple of 8 bytes long, so all of them are aligned as their records need. What can be worked out again is left out: the set of
// pairs follows from the contacts, the buckets of geometries from the geometries.
#pragma once

#include "../data/core.hpp"

namespace islet::detail {

inline constexpr std::uint32_t image_magic = 0x544c5349u;  // "ISLT" on a little-endian machine, "TLSI" on a big-endian one
inline constexpr std::uint32_t delta_magic = 0x444c5349u;  // "ISLD"
inline constexpr std::uint32_t image_version = 4;          // goes up when a record changes

/// What images and deltas begin with.
struct ImageHead {
    std::uint32_t magic = 0;
    std::uint32_t version = image_version;
    std::uint64_t length = 0;    // bytes, all of them
    std::uint64_t checksum = 0;  // of all that follows
};

struct ImageHeader {
    ImageHead head{image_magic};
    Capacity capacity;  // of the world that was saved
    // Records in use.
    std::uint32_t bodies = 0, shapes = 0, contacts = 0, joints = 0, geometries = 0, tree_nodes = 0;
    std::uint32_t ended = 0;           // touches that ended since the last step, not yet reported
    std::uint32_t ended_overlaps = 0;  // of sensors
};

static_assert(sizeof(ImageHeader) == image_header_bytes && sizeof(ImageHeader) % 8 == 0);

/// Calls visit(pointer, bytes) for each array of the world in the order of the image, with the length that the header gives its used prefix.
/// `core` may be const; a pointer may be set.
template <class AnyCore, class Visit>
void for_each_part(AnyCore& core, const ImageHeader& h, Visit&& visit) {
    const auto part = [&](auto& pointer, std::uint64_t records) { visit(pointer, records * sizeof(*pointer)); };
    const auto bits = [&](auto& set, std::uint32_t records) { visit(set.words, std::uint64_t{words_for(records)} * 8); };
    part(core.state, 1);
    part(core.poses, h.bodies);
    part(core.motions, h.bodies);
    part(core.bodies, h.bodies);
    part(core.shapes, h.shapes);
    part(core.boxes, h.shapes);
    part(core.geometries, h.geometries);
    part(core.tree, h.tree_nodes);
    part(core.contacts, h.contacts);
    part(core.manifolds, h.contacts);
    part(core.joints, h.joints);
    bits(core.awake_bodies, h.bodies);
    bits(core.awake_contacts, h.contacts);
    bits(core.awake_joints, h.joints);
    bits(core.moved_shapes, h.shapes);
    part(core.end_events, h.ended);
    part(core.sensor_ends.events, h.ended_overlaps);
}

/// Bytes of an image with this header.
inline std::uint64_t image_length(const ImageHeader& h) {
    std::uint64_t bytes = sizeof(ImageHeader);
    Core nowhere;
    for_each_part(nowhere, h, [&](auto&, std::uint64_t part) { bytes += part; });
    return bytes;
}

/// Reads the head of an image or a delta that is at least `least` bytes long. Returns what is wrong with it alone: kind, byte order, version, length.
Error read_head(std::span<const std::byte> bytes, std::uint32_t magic, std::size_t least, ImageHead& head);

/// The same for the whole header of an image, with its counts.
Error read_header(std::span<const std::byte> image, ImageHeader& h);

/// Checksum of an image or a delta: of what follows its head.
std::uint64_t image_checksum(std::span<const std::byte> bytes);

/// The header of an image of the world as it is now, without checksum.
ImageHeader header_of(const Core& core);

}  // namespace islet::detail
