// The state hash: all persistent state that affects the future, word by word. It does not depend on the byte order of the machine, nor on the capacity.
#include "../exact.hpp"

#include <cstddef>

#include "../calls/checks.hpp"
#include "../data/arrays.hpp"
#include "../math/checksum.hpp"
#include "../math/inlining.hpp"
#include "../math/scalar.hpp"
#include "../state/image_records.hpp"

namespace islet {

using namespace detail;

namespace {

template <class Record, class = void>
constexpr bool has_user_data = false;
template <class Record>
constexpr bool has_user_data<Record, decltype(void(Record::user_data))> = true;

struct Hasher {
    std::uint64_t h = 0x9e3779b97f4a7c15ull;

    void word(std::uint32_t w) { h = mixed(h, w); }
    void number(float f) { word(bits_of(f)); }
    void long_word(std::uint64_t w) {
        word(static_cast<std::uint32_t>(w));
        word(static_cast<std::uint32_t>(w >> 32));
    }
    /// `size` bytes that are 32-bit words.
    ISLET_SHARED void words(const void* from, std::size_t size) {
        const auto* bytes = static_cast<const std::byte*>(from);
        for (std::size_t i = 0; i < size; i += 4) {
            std::uint32_t w = 0;
            ISLET_MEMCPY(&w, bytes + i, 4);  // std::memcpy may be a call (-ffreestanding)
            word(w);
        }
    }
    /// Records made of 32-bit words only.
    template <class T>
    void records(const T* items, std::uint32_t count) {
        static_assert(sizeof(T) % 4 == 0);
        words(items, std::size_t{count} * sizeof(T));
    }
    /// The first `count` elements of an array, as images have them. User data does not affect the future, so it counts as zeros.
    template <class T>
    void array(const T* items, std::uint32_t count) {
        if constexpr (has_user_data<T>) {
            for (std::uint32_t i = 0; i < count; ++i) but_data(items + i, offsetof(T, user_data), sizeof(T));
        } else if constexpr (!is_image_record<T>) {
            for (std::uint32_t i = 0; i < count; ++i) {
                const auto record = image_of(items[i]);
                records(&record, 1);
            }
        } else {
            records(items, count);
        }
    }
    /// The place of a geometry in its bucket is left out: it depends on the number of buckets, and so on the capacity.
    void array(const Geometry* geometries, std::uint32_t count) {
        for (std::uint32_t i = 0; i < count; ++i) {
            Geometry g = geometries[i];
            if (g.references != 0) g.next = null_index;
            records(&g, 1);
        }
    }
    /// The words of the first `count` bits; the words after them depend on the capacity.
    void array(const BitSet& set, std::uint32_t count) {
        for (std::uint32_t i = 0; i < words_for(count); ++i) long_word(set.words[i]);
    }
    void pool(const PoolState& p) { records(&p, 1); }

private:
    ISLET_SHARED void but_data(const void* record, std::size_t user_data, std::size_t size) {
        const auto* bytes = static_cast<const std::byte*>(record);
        words(bytes, user_data);
        long_word(0);
        words(bytes + user_data + 8, size - user_data - 8);
    }
};

}  // namespace

std::uint64_t World::hash() const {
    const Core& c = core();
    if (!check_open(c)) return 0;
    const State& s = *c.state;
    Hasher h;
    h.pool(s.body_pool);
    h.pool(s.shape_pool);
    h.pool(s.contact_pool);
    h.pool(s.geometry_pool);
    h.pool(s.joint_pool);
    h.records(&s.tree, 1);
    h.number(s.gravity.x);
    h.number(s.gravity.y);
    h.number(s.restitution_threshold);
    h.number(s.max_speed);
    h.word(s.enable_sleep);
    h.number(s.last_substep);
    h.word(s.moved_count);
    h.word(s.trees_stale);
    h.word(s.exact_joints);
    h.word(s.continuous | s.catching_floors << 1);
    h.number(s.hit_threshold);

    SolverState solver = s.solver;
    solver.measure_residual = 0;  // does not affect the future
    h.records(&solver, 1);

    const Counts used = counts_of(s);
    for_each_hashed(c, [&](const auto& array, auto row) { h.array(array, used.of<row.per>()); });

    // Touches that ended since the last step, which the next step reports.
    const std::uint32_t touches = c.end_count - c.end_reported, overlaps = c.sensor_ends.count - c.sensor_ends_reported;
    if (touches + overlaps != 0) {
        h.word(touches);
        h.records(c.end_events + c.end_reported, touches);
        h.records(c.sensor_ends.events + c.sensor_ends_reported, overlaps);
    }
    return h.h;
}

}  // namespace islet
