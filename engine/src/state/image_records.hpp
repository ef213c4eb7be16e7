// The records of contacts in images and in the hash, where their indices have 32 bits. In the small profile a world's own have 16 (data/records.hpp), so that
// image and hash are those of the whole engine. All other records, and with the whole engine these too, are in images as they are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "../data/records.hpp"

namespace islet::detail {

/// The record that images have for a record of a world.
template <class Record>
struct ImageRecord {
    using Type = Record;
};
template <>
struct ImageRecord<Contact> {
    using Type = ImageContact;
};
template <>
struct ImageRecord<ContactManifold> {
    using Type = ImageManifold;
};

template <class Record>
inline constexpr bool is_image_record = std::is_same_v<Record, typename ImageRecord<Record>::Type>;

/// An index in another width; none stays none. Of an index that is too wide the low bits are left.
template <class To, class From>
constexpr To index_as(From index) {
    return index == static_cast<From>(null_index) ? static_cast<To>(null_index) : static_cast<To>(index);
}

/// The same contact with indices of another width.
template <class To, class From>
ContactWith<To> contact_with(const ContactWith<From>& from) {
    ContactWith<To> c;
    c.shape_a = index_as<To>(from.shape_a);
    c.shape_b = index_as<To>(from.shape_b);
    for (std::uint32_t side = 0; side < 2; ++side) {
        c.next[side] = index_as<To>(from.next[side]);
        c.prev[side] = index_as<To>(from.prev[side]);
    }
    c.generation = from.generation;
    c.next_free = from.next_free;  // or the own speed's bits
    return c;
}
template <class To, class From>
ManifoldWith<To> manifold_with(const ManifoldWith<From>& from) {
    ManifoldWith<To> m;
    m.body_a = index_as<To>(from.body_a);
    m.body_b = index_as<To>(from.body_b);
    std::memcpy(&m.flags, &from.flags, sizeof m - offsetof(ManifoldWith<To>, flags));
    return m;
}

/// A contact as images have it.
inline const ImageContact& image_of(const ImageContact& c) { return c; }
inline const ImageManifold& image_of(const ImageManifold& m) { return m; }
inline ImageContact image_of(const ContactWith<std::uint16_t>& c) { return contact_with<std::uint32_t>(c); }
inline ImageManifold image_of(const ManifoldWith<std::uint16_t>& m) { return manifold_with<std::uint32_t>(m); }

/// And as this build's worlds have it.
inline Contact record_of(const ImageContact& c) { return contact_with<ContactIndex>(c); }
inline ContactManifold record_of(const ImageManifold& m) { return manifold_with<ContactIndex>(m); }

}  // namespace islet::detail
