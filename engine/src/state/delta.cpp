// The difference of two images, packed.
//
// The arrays of two images have their records in the same order. So words that did not change are equal at the same place of the same part, even if other
// parts have grown. Each part of the new image is XORed with the same part of the old one (with zeros beyond its end) and packed in groups of eight words:
//
//   mask     a byte: bit i is set if word i differs. 0 is followed by the number of further groups that do not differ, a byte.
//   lengths  two bits a differing word, its significant bytes - 1, in whole bytes
//   bytes    those bytes, low ones first; numbers that change little differ in low bits
#include "../exact.hpp"

#include "islet/snapshot.hpp"

#include "../state/image.hpp"

namespace islet {

using namespace detail;

namespace {

struct DeltaHeader {
    ImageHead head{delta_magic};
    std::uint64_t from_checksum = 0;
    std::uint64_t from_length = 0;
    std::uint64_t to_length = 0;
};
static_assert(sizeof(DeltaHeader) == delta_header_bytes);

constexpr std::uint32_t group = 8;  // words

/// A part of an image: where it starts and how long it is.
struct Parts {
    std::uint64_t start[part_count] = {}, size[part_count] = {};
    std::uint32_t count = 0;

    explicit Parts(const ImageHeader& h) {
        Core nowhere;
        std::uint64_t at = sizeof(ImageHeader);
        for_each_part(nowhere, h, [&](auto&, std::size_t bytes) {
            start[count] = at;
            size[count++] = bytes;
            at += bytes;
        });
    }
};

std::uint32_t word_at(const std::byte* bytes) {
    std::uint32_t w = 0;
    std::memcpy(&w, bytes, 4);
    return w;
}

// The old image's word at a place of a part, or 0 beyond its end.
std::uint32_t old_word(const std::byte* part, std::uint64_t size, std::uint64_t at) { return at < size ? word_at(part + at) : 0; }

std::uint32_t significant_bytes(std::uint32_t word) { return word == 0 ? 0 : (39u - leading_zeros(word)) / 8u; }

/// Packs groups into a span. Once the span is full, the packer writes nothing more and sets `full`.
struct Packer {
    span<std::byte> out;
    std::size_t at = 0;
    std::size_t zeros_at = 0;  // where the count of equal groups stands, or 0
    bool full = false;

    void put(std::uint32_t byte) {
        if (at == out.size()) {
            full = true;
        } else {
            out[at++] = static_cast<std::byte>(byte);
        }
    }

    void put_equal_group() {
        if (zeros_at != 0 && out[zeros_at] != std::byte{255}) {
            out[zeros_at] = static_cast<std::byte>(static_cast<std::uint32_t>(out[zeros_at]) + 1);
            return;
        }
        put(0);
        put(0);
        zeros_at = full ? 0 : at - 1;
    }

    void put_group(const std::uint32_t (&difference)[group]) {
        std::uint32_t mask = 0, lengths = 0, count = 0;
        for (std::uint32_t i = 0; i < group; ++i) {
            if (difference[i] == 0) continue;
            mask |= 1u << i;
            lengths |= (significant_bytes(difference[i]) - 1) << (2 * count++);
        }
        if (mask == 0) return put_equal_group();
        zeros_at = 0;
        put(mask);
        for (std::uint32_t i = 0; i < count; i += 4) put(lengths >> (2 * i) & 0xffu);
        for (const std::uint32_t d : difference)
            for (std::uint32_t rest = d; rest != 0; rest >>= 8) put(rest & 0xffu);
    }
};

/// Unpacks groups. Bytes beyond the end read as 0, and set `broken`.
struct Unpacker {
    span<const std::byte> in;
    std::size_t at = 0;
    std::uint32_t zeros = 0;
    bool broken = false;

    std::uint32_t get() {
        if (at < in.size()) return static_cast<std::uint32_t>(in[at++]);
        broken = true;
        return 0;
    }

    void get_group(std::uint32_t (&difference)[group]) {
        for (std::uint32_t& d : difference) d = 0;
        if (zeros > 0) {
            --zeros;
            return;
        }
        const std::uint32_t mask = get();
        if (mask == 0) {
            zeros = get();
            return;
        }
        std::uint32_t count = 0, lengths = 0;
        for (std::uint32_t bits = mask; bits != 0; bits &= bits - 1) ++count;
        for (std::uint32_t i = 0; i < count; i += 4) lengths |= get() << (2 * i);
        for (std::uint32_t i = 0; i < group; ++i) {
            if ((mask >> i & 1u) == 0) continue;
            const std::uint32_t bytes = (lengths & 3u) + 1;
            lengths >>= 2;
            for (std::uint32_t k = 0; k < bytes; ++k) difference[i] |= get() << (8 * k);
        }
    }
};

/// Calls word(old word, place in the new image, number of the word in its group) for each word of the new image behind its header; done() after
/// each group.
template <class Word, class Done>
void for_each_word(span<const std::byte> from, const Parts& old_parts, const Parts& new_parts, Word&& word, Done&& done) {
    for (std::uint32_t p = 0; p < new_parts.count; ++p) {
        const std::byte* old_part = from.data() + old_parts.start[p];
        std::uint32_t in_group = 0;
        for (std::uint64_t at = 0; at < new_parts.size[p]; at += 4) {
            word(old_word(old_part, old_parts.size[p], at), static_cast<std::size_t>(new_parts.start[p] + at), in_group);
            if (++in_group < group && at + 4 < new_parts.size[p]) continue;
            if (!done()) return;
            in_group = 0;
        }
    }
}

std::size_t failed(Error* error, Error why) {
    if (error != nullptr) *error = why;
    return 0;
}

Error read_delta_header(span<const std::byte> bytes, DeltaHeader& h) {
    const Error error = read_head(bytes, delta_magic, sizeof h + sizeof(ImageHeader), h.head);
    if (error != Error::none) return error;
    std::memcpy(&h, bytes.data(), sizeof h);
    return image_checksum(bytes) == h.head.checksum ? Error::none : Error::corrupt_image;
}

}  // namespace

std::size_t delta(span<const std::byte> from, span<const std::byte> to, span<std::byte> out, Error* error) {
    if (error != nullptr) *error = Error::none;
    ImageHeader old_header, new_header;
    Error problem = read_header(from, old_header);
    if (problem == Error::none) problem = read_header(to, new_header);
    if (problem != Error::none) return failed(error, problem);
    if (out.size() < sizeof(DeltaHeader) + sizeof(ImageHeader)) return failed(error, Error::image_too_small);

    Packer packer{out, sizeof(DeltaHeader) + sizeof(ImageHeader)};
    std::uint32_t difference[group] = {};
    for_each_word(
        from, Parts(old_header), Parts(new_header),
        [&](std::uint32_t old, std::size_t place, std::uint32_t i) { difference[i] = old ^ word_at(to.data() + place); },
        [&] {
            packer.put_group(difference);
            for (std::uint32_t& d : difference) d = 0;
            return !packer.full;
        });
    if (packer.full) return failed(error, Error::image_too_small);

    DeltaHeader h;
    h.head.length = packer.at;
    h.from_checksum = old_header.head.checksum;
    h.from_length = old_header.head.length;
    h.to_length = new_header.head.length;
    std::memcpy(out.data(), &h, sizeof h);
    std::memcpy(out.data() + sizeof h, &new_header, sizeof new_header);
    h.head.checksum = image_checksum(out.first(packer.at));
    std::memcpy(out.data(), &h.head, sizeof h.head);
    return packer.at;
}

std::size_t apply(span<const std::byte> from, span<const std::byte> delta, span<std::byte> out, Error* error) {
    if (error != nullptr) *error = Error::none;
    ImageHeader old_header, new_header;
    Error problem = read_header(from, old_header);
    DeltaHeader h;
    if (problem == Error::none) problem = read_delta_header(delta, h);
    if (problem != Error::none) return failed(error, problem);
    if (h.from_checksum != old_header.head.checksum || h.from_length != old_header.head.length) return failed(error, Error::wrong_delta);
    if (out.size() < h.to_length) return failed(error, Error::image_too_small);
    // The delta contains the new image's header unchanged. It must be the header of an image of that length.
    std::memcpy(&new_header, delta.data() + sizeof h, sizeof new_header);
    if (h.to_length < sizeof new_header) return failed(error, Error::corrupt_image);
    std::memcpy(out.data(), &new_header, sizeof new_header);
    const span<std::byte> image = out.first(static_cast<std::size_t>(h.to_length));
    if (read_header(image, new_header) != Error::none) return failed(error, Error::corrupt_image);

    Unpacker unpacker{delta, sizeof h + sizeof new_header};
    std::uint32_t difference[group];
    for_each_word(
        from, Parts(old_header), Parts(new_header),
        [&](std::uint32_t old, std::size_t place, std::uint32_t i) {
            if (i == 0) unpacker.get_group(difference);
            const std::uint32_t word = old ^ difference[i];
            std::memcpy(image.data() + place, &word, 4);
        },
        [&] { return !unpacker.broken; });
    const bool sound = !unpacker.broken && unpacker.at == delta.size() && unpacker.zeros == 0 && image_checksum(image) == new_header.head.checksum;
    return sound ? image.size() : failed(error, Error::corrupt_image);
}

}  // namespace islet
