// Snapshots in tests: images in memory of their own, aligned for load.
#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include <islet/islet.hpp>

namespace islet::test {

class Image {
public:
    Image() = default;
    explicit Image(std::size_t bytes) : words_((bytes + 7) / 8), size_(bytes) {}

    std::span<std::byte> bytes() { return {reinterpret_cast<std::byte*>(words_.data()), size_}; }
    std::span<const std::byte> bytes() const { return {reinterpret_cast<const std::byte*>(words_.data()), size_}; }
    std::byte& operator[](std::size_t i) { return bytes()[i]; }
    friend bool operator==(const Image& a, const Image& b) { return a.size_ == b.size_ && std::memcmp(a.words_.data(), b.words_.data(), a.size_) == 0; }

private:
    std::vector<std::uint64_t> words_;
    std::size_t size_ = 0;
};

inline Image save(const World& world) {
    Image image(world.snapshot_bytes());
    if (world.save(image.bytes()) != image.bytes().size()) return Image{};
    return image;
}

}  // namespace islet::test
