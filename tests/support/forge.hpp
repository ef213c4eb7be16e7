// Images as an attacker would make them: changed at will, with a checksum that is right again.
#pragma once

#include "image.hpp"
#include "state/image.hpp"

namespace islet::test {

inline detail::ImageHeader header_of(std::span<const std::byte> image) {
    detail::ImageHeader h;
    std::memcpy(&h, image.data(), sizeof h);
    return h;
}

/// Makes the checksum of an image or a delta right, if it is long enough to have one.
inline void seal(std::span<std::byte> image) {
    detail::ImageHead head;
    if (image.size() < sizeof head) return;
    std::memcpy(&head, image.data(), sizeof head);
    head.checksum = detail::image_checksum(image);
    std::memcpy(image.data(), &head, sizeof head);
}

inline std::uint32_t word(const Image& image, std::size_t i) {
    std::uint32_t w = 0;
    std::memcpy(&w, image.bytes().data() + 4 * i, 4);
    return w;
}

inline void set_word(Image& image, std::size_t i, std::uint32_t w) { std::memcpy(image.bytes().data() + 4 * i, &w, 4); }

}  // namespace islet::test
