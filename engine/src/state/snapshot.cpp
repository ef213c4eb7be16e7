// Saving and restoring a world.
#include "../exact.hpp"

#include "islet/snapshot.hpp"

#include "../bodies/geometry_pool.hpp"
#include "../bodies/joint_changes.hpp"
#include "../calls/recorder.hpp"
#include "../graph/contacts.hpp"
#include "../graph/hooks.hpp"
#include "../graph/joint_graph.hpp"
#include "../graph/sensors.hpp"
#include "../island/joint_trees.hpp"
#include "../math/checksum.hpp"
#include "../solver/hits.hpp"
#include "../solver/joint_solve.hpp"
#include "../solver/ordered_sweep.hpp"
#include "../state/faults.hpp"
#include "../state/image.hpp"
#include "../state/image_records.hpp"
#include "../state/world_copy.hpp"
#include "../step/continuous.hpp"
#include "../step/one_way.hpp"

namespace islet {

using namespace detail;

namespace {

// True if the capacity has room for all that the image uses. Touches that ended need room, too.
bool fits(const Capacity& c, const ImageHeader& h) {
    const Counts& n = h.used;
    return n.bodies <= c.bodies && n.shapes <= c.shapes && n.contacts <= c.contacts && n.joints <= c.joints && n.geometries <= geometry_capacity(c) &&
           n.tree_nodes <= room_for(Per::tree_node, c) && h.ended + h.ended_overlaps <= event_capacity(c);
}

}  // namespace

namespace detail {

ImageHeader header_of(const Core& core) {
    ImageHeader h;
    h.set_capacity(core.capacity);
    h.used = counts_of(*core.state);
    h.ended = core.end_count - core.end_reported;
    h.ended_overlaps = core.sensor_ends.count - core.sensor_ends_reported;
    h.head.length = image_length(h);
    return h;
}

Error read_head(span<const std::byte> bytes, std::uint32_t magic, std::size_t least, ImageHead& head) {
    std::uint32_t kind = 0;
    if (bytes.size() < sizeof kind || bytes.data() == nullptr) return Error::truncated_image;
    std::memcpy(&kind, bytes.data(), sizeof kind);
    if (kind == swapped_bytes(magic)) return Error::other_byte_order;
    if (kind != magic) return Error::not_an_image;
    if (bytes.size() < least) return Error::truncated_image;
    std::memcpy(&head, bytes.data(), sizeof head);
    if (head.version != image_version) return Error::other_version;
    return head.length == bytes.size() ? Error::none : Error::truncated_image;
}

Error read_header(span<const std::byte> image, ImageHeader& h) {
    const Error error = read_head(image, image_magic, sizeof h, h.head);
    if (error != Error::none) return error;
    std::memcpy(&h, image.data(), sizeof h);
    const Counts& n = h.used;
    for (const std::uint32_t count : {n.bodies, n.shapes, n.contacts, n.joints, n.geometries, n.tree_nodes / 2, h.ended, h.ended_overlaps})
        if (count > max_capacity) return Error::corrupt_image;
    return h.head.length == image_length(h) && fits(h.capacity(), h) ? Error::none : Error::corrupt_image;
}

std::uint64_t image_checksum(span<const std::byte> bytes) { return checksum_of(bytes.data() + sizeof(ImageHead), bytes.size() - sizeof(ImageHead)); }

}  // namespace detail

namespace {

/// Copies to an image, and sums what it has copied while the nearest cache still holds it.
class Writer {
public:
    explicit Writer(std::byte* image) : begin_(image + sizeof(ImageHead)), summed_(begin_), at_(begin_) {}

    /// Writes the records of an array, which take so many bytes in an image.
    template <class Record>
    void write_records(const Record* from, std::size_t size) {
        if constexpr (is_image_record<Record>) {
            write(from, size);
        } else {
            for (std::size_t i = 0; i < size / sizeof(typename ImageRecord<Record>::Type); ++i) {
                const auto record = image_of(from[i]);
                write(&record, sizeof record);
            }
        }
    }
    void write(const void* from, std::size_t size) {
        const auto* bytes = static_cast<const std::byte*>(from);
        constexpr std::size_t chunk = 4096;
        for (std::size_t left = size; left > 0;) {
            const std::size_t n = left < chunk ? left : chunk;
            std::memcpy(at_, bytes, n);
            at_ += n;
            bytes += n;
            left -= n;
            sum();
        }
    }
    std::uint64_t checksum() { return checksum_.finish(summed_, static_cast<std::size_t>(at_ - summed_), static_cast<std::uint64_t>(at_ - begin_)); }

private:
    void sum() {
        const std::size_t blocks = static_cast<std::size_t>(at_ - summed_) / Checksum::block;
        checksum_.add_blocks(summed_, blocks);
        summed_ += blocks * Checksum::block;
    }
    std::byte* begin_;
    std::byte* summed_;  // how far the sum has come
    std::byte* at_;
    Checksum checksum_;
};

// Flags of contacts that no contact has in this build.
constexpr std::uint32_t cut_contact_flags = (has_restitution ? 0u : std::uint32_t{contact_bouncy}) | (has_surfaces ? 0u : std::uint32_t{contact_special}) |
                                            (has_sensors ? 0u : std::uint32_t{contact_sensor | contact_overlap}) |
                                            (has_hits ? 0u : std::uint32_t{contact_hits}) | (has_hooks ? 0u : std::uint32_t{contact_asks}) |
                                            (has_one_way ? 0u : std::uint32_t{contact_one_way | contact_passes | contact_dropped});

// True for a hinge that this build would sweep although the whole engine solves it exactly.
bool is_exact_angle(const Joint& j) { return (j.flags & joint_loaded) != 0 || ((j.flags & joint_exact) != 0 && has_acting_angle(j)); }

// True if the image holds objects that this build leaves out (islet/config.hpp). Trusts no type that it reads.
bool needs_what_is_cut(const ImageView& c) {
    const State& s = *c.state;
    for (std::uint32_t i = 0; !has_all_joints && i < s.joint_pool.high_water; ++i)
        if (pool_live(s.joint_pool, c.joints, i) && !has_joint(static_cast<JointType>(c.joints[i].type))) return true;
    for (std::uint32_t i = 0; has_joint(JointType::revolute) && !has_exact_angles && i < s.joint_pool.high_water; ++i)
        if (pool_live(s.joint_pool, c.joints, i) && is_exact_angle(c.joints[i])) return true;
    for (std::uint32_t i = 0; !has_all_shapes && i < s.geometry_pool.high_water; ++i)
        if (c.geometries[i].references != 0 && !has_shape(static_cast<ShapeType>(c.geometries[i].type))) return true;
    for (std::uint32_t i = 0; has_polygons && !has_hulls && i < s.geometry_pool.high_water; ++i) {
        const Geometry& g = c.geometries[i];
        if (g.references != 0 && static_cast<ShapeType>(g.type) == ShapeType::polygon && !is_box(g.polygon)) return true;
    }
    for (std::uint32_t i = 0; !(has_restitution && has_surfaces && has_sensors && has_hits && has_hooks && has_one_way) && i < s.shape_pool.high_water; ++i) {
        const Shape& shape = c.shapes[i];
        if (!has_restitution && shape.restitution != 0) return true;
        if (!has_surfaces && (shape.rolling_resistance != 0 || shape.tangent_speed != 0)) return true;
        if (!has_sensors && (shape.flags & shape_sensor) != 0) return true;
        if (!has_hits && (shape.flags & shape_hit_events) != 0) return true;
        if (!has_hooks && (shape.flags & shape_pre_solve) != 0) return true;
        if (!has_one_way && (shape.flags & shape_one_way_bits) != 0) return true;
    }
    for (std::uint32_t i = 0; cut_contact_flags != 0 && i < s.contact_pool.high_water; ++i)
        if (pool_live(s.contact_pool, c.contacts, i) && (c.manifolds[i].flags & cut_contact_flags) != 0) return true;
    for (std::uint32_t i = 0; !(has_sleep && has_bullets && has_disabling) && i < s.body_pool.high_water; ++i) {
        if (!pool_live(s.body_pool, c.bodies, i)) continue;
        const std::uint32_t flags = c.bodies[i].flags;
        if (!has_bullets && (flags & body_bullet) != 0) return true;
        if (!has_disabling && (flags & body_disabled) != 0) return true;
        if (!has_sleep && c.bodies[i].type() != BodyType::static_body && !c.is_awake(i) && (flags & body_disabled) == 0) return true;
    }
    return (!has_sleep && s.enable_sleep != 0) || (!has_continuous && s.continuous != 0) || (!has_seamless_floors && s.catching_floors == 0) ||
           (!has_tuning && needs_tuning(unpack(s.solver)));
}

// True if a record has an index that this build's worlds have no room for. (Those of live contacts are sound; a slot that is free may hold anything.)
template <class Record>
bool has_wide_index(const Record* records, std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i) {
        const Record again = image_of(record_of(records[i]));
        if (std::memcmp(&again, &records[i], sizeof again) != 0) return true;
    }
    return false;
}
bool has_wide_index(const ImageView& c) {
    const std::uint32_t contacts = c.state->contact_pool.high_water;
    return !is_image_record<Contact> && (has_wide_index(c.contacts, contacts) || has_wide_index(c.manifolds, contacts));
}

// Clears the bits beyond those copied: they belong to slots that the image never used.
void clear_rest(const BitSet& set, std::uint32_t used) {
    const auto words = static_cast<std::uint32_t>(words_for(used));
    std::memset(set.words + words, 0, std::size_t{set.word_count - words} * 8);
}

void rebuild_pairs(Core& core, const ImageHeader& h) {
    if (!has_pair_set) return;
    std::memset(core.pairs.keys, 0, (std::size_t{core.pairs.mask} + 1) * 8);
    for (std::uint32_t i = 0; i < h.used.contacts; ++i) {
        const Contact& c = core.contacts[i];
        if ((c.generation & 1u) != 0) core.pairs.insert(PairSet::key(c.shape_a, c.shape_b));
    }
}

// True if this build and this program have the parts that the image's shapes need in a step.
bool can_tell(const std::byte* image) {
    std::uint32_t asked = 0;
    std::memcpy(&asked, image + sizeof(ImageHeader) + offsetof(State, asked), sizeof asked);  // the state comes first
    return ((asked & shape_sensor) == 0 || has_sensors) && ((asked & shape_hit_events) == 0 || has_hits) && ((asked & asked_one_way) == 0 || has_one_way);
}

// The end events that wait to be reported, after those that were.
template <class Record>
const Record* waiting(const Core&, const Record* records) {
    return records;
}
const TouchEvent* waiting(const Core& c, const TouchEvent* events) { return events + c.end_reported; }
const SensorEvent* waiting(const Core& c, const SensorEvent* events) { return events + c.sensor_ends_reported; }

// Room for so many ended overlaps: the last of the end events.
SensorEvents sensor_ends_of(const Core& core, std::uint32_t count) {
    return {reinterpret_cast<SensorEvent*>(core.end_events + (event_capacity(core.capacity) - count)), count};
}

// What a step tells is told once: a world that takes over a state has taken no step. (Ended touches that wait to be told belong to the state.)
void tell_nothing(Core& core) {
    core.sensor_ends_reported = core.sensor_begins.count = core.hit_count = 0;
    core.end_reported = core.begin_count = core.moved_count = core.slept_count = core.break_count = 0;
    const State& s = *core.state;
    core.report = {};
    core.forget_plan();
    forget_residuals(core);
    core.report.bodies = s.body_pool.count;
    core.report.awake_bodies = core.awake_bodies.count();
    core.report.shapes = s.shape_pool.count;
    core.report.contacts = s.contact_pool.count;
    core.report.joints = s.joint_pool.count;
}

// Reads the records of an array, which take so many bytes in the image.
template <class Record>
void read_records(Record* to, const std::byte* image, std::size_t size) {
    if constexpr (is_image_record<Record>) {
        std::memcpy(static_cast<void*>(to), image, size);
    } else {
        typename ImageRecord<Record>::Type record;
        for (std::size_t at = 0; at < size; at += sizeof record) {
            std::memcpy(static_cast<void*>(&record), image + at, sizeof record);
            *to++ = record_of(record);
        }
    }
}

// Copies an image that is known to be sound and to fit into the world.
void take_over(Core& core, const ImageHeader& h, const std::byte* image) {
    const std::byte* at = image + sizeof h;
    core.sensor_ends = sensor_ends_of(core, h.ended_overlaps);
    for_each_part(core, h, [&](auto* to, std::size_t bytes) {
        read_records(to, at, bytes);
        at += bytes;
    });
    for_each_bit_set(core, h, clear_rest);
    rebuild_pairs(core, h);
    rebuild_buckets(core);
    if constexpr (max_lanes > 1) std::memset(core.clearances, 0, std::size_t{h.used.contacts} * sizeof(float));

    core.end_count = h.ended;
    tell_nothing(core);
}

// The result must stay const: Core's pointers are not, so the cast is needed.
ImageView view_of(const Core& world, const ImageHeader& h, const std::byte* image) {
    ImageView view;
    view.capacity = world.capacity;
    auto* at = const_cast<std::byte*>(image) + sizeof h;
    for_each_part(view, h, [&](auto& pointer, std::size_t bytes) {
        pointer = reinterpret_cast<std::remove_reference_t<decltype(pointer)>>(at);
        at += bytes;
    });
    for_each_bit_set(view, h, [](BitSet& set, std::uint32_t bits) { set.word_count = static_cast<std::uint32_t>(words_for(bits)); });
    return view;
}

// Copies records. If there are none, the addresses may be null, which memcpy must not be given.
template <class Record>
void copy_records(Record* to, const Record* from, std::uint32_t count) {
    if (count > 0) std::memcpy(to, from, count * sizeof(Record));
}

}  // namespace

void detail::copy_state(const Core& from, Core& to) {
    const Layout l = layout_of(from.capacity);
    std::memcpy(static_cast<void*>(to.state), from.state, l.persistent_end - l[Array::state]);  // all arrays that persist, as they lie in the block
    to.end_count = from.end_count - from.end_reported;
    to.sensor_ends = sensor_ends_of(to, from.sensor_ends.count - from.sensor_ends_reported);
    copy_records(to.end_events, waiting(from, from.end_events), to.end_count);
    copy_records(to.sensor_ends.events, waiting(from, from.sensor_ends.events), to.sensor_ends.count);
    tell_nothing(to);
    to.recording = nullptr;
}

Error read_snapshot(span<const std::byte> image, SnapshotInfo& out) {
    ImageHeader h;
    const Error error = read_header(image, h);
    if (error != Error::none) return error;
    const auto at_least_one = [](std::uint32_t n) { return n > 0 ? n : 1u; };
    out.bytes = h.head.length;
    out.capacity = h.capacity();
    const std::uint32_t ends = h.ended + h.ended_overlaps;
    const Counts& n = h.used;
    const std::uint32_t shapes = at_least_one(n.shapes > (n.tree_nodes + 1) / 2 ? n.shapes : (n.tree_nodes + 1) / 2);
    out.used = {at_least_one(n.bodies), shapes, at_least_one(n.contacts > ends ? n.contacts : ends), n.joints, n.geometries, 0};
    return Error::none;
}

std::size_t World::snapshot_bytes() const { return static_cast<std::size_t>(header_of(core()).head.length); }

std::size_t World::save(span<std::byte> out) const {
    const Core& c = core();
    ImageHeader h = header_of(c);
    if (!check_open(c) || !check(c, out.data() != nullptr && out.size() >= h.head.length, Error::image_too_small)) return 0;
    Writer writer(out.data());
    writer.write(reinterpret_cast<const std::byte*>(&h) + sizeof h.head, sizeof h - sizeof h.head);
    for_each_part(c, h, [&](const auto* from, std::size_t bytes) { writer.write_records(waiting(c, from), bytes); });
    h.head.checksum = writer.checksum();
    std::memcpy(out.data(), &h.head, sizeof h.head);
    return static_cast<std::size_t>(h.head.length);
}

bool World::restore(span<const std::byte> image) {
    Core& c = core();
    ImageHeader h;
    const Error error = read_header(image, h);
    if (!check_open(c) || !check(c, error == Error::none, error) || !check(c, fits(c.capacity, h), Error::image_too_large)) return false;
    if (!check_there(c, h.used.joints == 0 || joint_solve_is_linked())) return false;
    if (!check_there(c, can_tell(image.data()))) return false;
    take_over(c, h, image.data());
    if (has_recorder && c.recording != nullptr) write_image(c, image.first(static_cast<std::size_t>(h.head.length)));
    return true;
}

bool World::load(span<const std::byte> image) {
    Core& c = core();
    ImageHeader h;
    const Error error = read_header(image, h);
    if (!check_open(c) || !check(c, error == Error::none, error)) return false;
    if (!check(c, reinterpret_cast<std::uintptr_t>(image.data()) % snapshot_alignment == 0, Error::image_misaligned)) return false;
    if (!check(c, image_checksum(image) == h.head.checksum, Error::corrupt_image)) return false;
    if (!check(c, fits(c.capacity, h), Error::image_too_large)) return false;
    const ImageView view = view_of(c, h, image.data());
    if (!check(c, h.used == counts_of(*view.state), Error::unsound_image) || !check_there(c, !needs_what_is_cut(view))) return false;
    if (!check(c, find_fault(view, c.arena()) == nullptr && !has_wide_index(view), Error::unsound_image)) return false;
    link_joint_solve();  // an image may hold objects that the program itself never makes
    link_joint_changes();
    take_over(c, h, image.data());
    if (has_recorder && c.recording != nullptr) write_image(c, image.first(static_cast<std::size_t>(h.head.length)));
    return true;
}

}  // namespace islet
