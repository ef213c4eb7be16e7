// The table of a world's arrays (islet/layout.hpp) together with their pointers in Core: walks over all of them.
#pragma once

#include "../data/core.hpp"

namespace islet::detail {

/// The row of an array, as a type: what a walk does with an array is chosen when it is compiled.
template <Array a>
struct Row {
    static constexpr Array array = a;
    static constexpr std::uint32_t place = static_cast<std::uint32_t>(a);
    static constexpr std::size_t size = array_rows[place].size;
    static constexpr std::size_t image_size = array_rows[place].image_size;
    static constexpr Per per = array_rows[place].per;
    static constexpr Kept kept = array_rows[place].kept;
    static constexpr std::uint32_t hash = array_rows[place].hash;
    static constexpr bool is_there = room_for(per, {1, 1, 1, 1, 1, 1, 1}) != 0;  // in this build

    /// Bytes of `n` elements in an image. (With the size as a constant, for the compiler's sake.)
    static constexpr std::size_t image_bytes(std::uint32_t n) { return (size == one_bit ? words_for(n) : n) * (size == one_bit ? 8 : image_size); }
};

/// Calls visit(array, row) for each array in the order of the block: the pointer or set in `core`, which may be const, and its Row.
template <class AnyCore, class Visit>
ISLET_ALWAYS_INLINE inline void for_each_array(AnyCore& core, Visit&& visit) {
#define ISLET_VISIT(name, ...) visit(core.name, Row<Array::name>{});
    ISLET_ARRAYS(ISLET_VISIT)
#undef ISLET_VISIT
}

/// The same for those that the hash depends on, in its order.
template <class AnyCore, class Visit>
ISLET_ALWAYS_INLINE inline void for_each_hashed(AnyCore& core, Visit&& visit) {
    for_each_array(core, [&](auto&, auto turn) {  // there are more turns than needed, by those that are not hashed
        for_each_array(core, [&](auto& array, auto row) {
            if constexpr (row.hash == turn.place + 1) visit(array, row);
        });
    });
}

// The pointer to what an array holds.
template <class Record>
constexpr auto& memory_of(Record& array) {
    return array;
}
constexpr auto& memory_of(BitSet& set) { return set.words; }
constexpr auto& memory_of(const BitSet& set) { return set.words; }

/// Elements in use: those that were used since the world was made, for an index is never given up. In snapshots, six words.
struct Counts {
    std::uint32_t bodies = 0, shapes = 0, contacts = 0, joints = 0, geometries = 0, tree_nodes = 0;

    template <Per per>
    constexpr std::uint32_t of() const {
        static_assert(per != Per::bucket && per != Per::pair && per != Per::clearance && per != Per::hit && per != Per::event, "nobody counts these");
        if constexpr (per == Per::world) return 1;
        if constexpr (per == Per::body) return bodies;
        if constexpr (per == Per::shape) return shapes;
        if constexpr (per == Per::geometry) return geometries;
        if constexpr (per == Per::tree_node) return tree_nodes;
        if constexpr (per == Per::contact) return contacts;
        if constexpr (per == Per::joint) return joints;
    }
    ISLET_EQUAL_IF(Counts, a.bodies == b.bodies && a.shapes == b.shapes && a.contacts == b.contacts && a.joints == b.joints && a.geometries == b.geometries &&
                               a.tree_nodes == b.tree_nodes)
};

inline Counts counts_of(const State& s) {
    return {s.body_pool.high_water, s.shape_pool.high_water, s.contact_pool.high_water, s.joint_pool.high_water, s.geometry_pool.high_water, s.tree.high_water};
}

// -- the table is right ----------------------------------------------------------------------------------------------------------------

template <class Held>
inline constexpr std::size_t element_size = 0;
template <class T>
inline constexpr std::size_t element_size<T*> = sizeof(T);
template <>
inline constexpr std::size_t element_size<BitSet> = one_bit;
template <>
inline constexpr std::size_t element_size<PairSet> = sizeof(std::uint64_t);

#define ISLET_CHECK(name, size, ...) static_assert(element_size<decltype(Core::name)> == (size), "ISLET_ARRAYS: the size of " #name);
ISLET_ARRAYS(ISLET_CHECK)
#undef ISLET_CHECK

/// Output stands behind all that persists, sets of bits behind the slots they are about; what an image holds is aligned to 8 bytes; and the hash takes its
/// turns one by one.
constexpr bool is_in_order() {
    std::uint32_t hashed = 0, turns = 0;
    for (std::uint32_t i = 0; i < array_count; ++i) {
        const ArrayRow& row = array_rows[i];
        if (i > 0 && row.kept != Kept::output && array_rows[i - 1].kept == Kept::output) return false;
        if (i > 0 && row.kept == Kept::saved && row.size != one_bit && array_rows[i - 1].size == one_bit) return false;
        if (row.kept == Kept::saved && row.image_size % 8 != 0) return false;
        if (row.hash == 0) continue;
        ++hashed;
        turns |= 1u << (row.hash - 1);
    }
    return turns == (1u << hashed) - 1;
}
static_assert(is_in_order());

}  // namespace islet::detail
