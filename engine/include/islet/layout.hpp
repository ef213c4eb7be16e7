// The layout of a world's block of memory: arrays whose sizes follow from the capacity alone.
//
//   | World + Core (host part: pointers, hook) | persistent: State, bodies, shapes, geometries, contacts, ... | output | scratch |
//
// The persistent region has fixed-width fields, explicit padding and no pointers: its bytes mean the same on 32- and 64-bit machines. Output
// holds the events of the last step. Scratch is meaningful only inside one call.
#pragma once

#include <cstddef>
#include <cstdint>

#include "islet/config.hpp"
#include "islet/joints.hpp"
#include "islet/types.hpp"

ISLET_API_BEGIN
namespace islet {

/// Alignment that World::create demands of its block.
inline constexpr std::size_t world_alignment = 64;

/// No capacity may exceed this.
inline constexpr std::uint32_t max_capacity = sizeof(void*) >= 8 ? 1u << 22 : 1u << 18;

ISLET_INTERNAL_BEGIN
namespace detail {
// In the small profile 16 bits number bodies, shapes and contacts, and both ends of each contact.
inline constexpr std::uint32_t max_bodies = ISLET_SMALL ? 0xffffu : max_capacity;
inline constexpr std::uint32_t max_shapes = max_bodies;
inline constexpr std::uint32_t max_contacts = ISLET_SMALL ? 0x7fffu : max_capacity;
}  // namespace detail
ISLET_INTERNAL_END

/// Whether World::create accepts the capacity. (In the small profile a world has at most 65 535 bodies, as many shapes, and 32 767 contacts.)
constexpr bool is_valid(const Capacity& c) {
    return c.bodies > 0 && c.shapes > 0 && c.contacts > 0 && c.bodies <= detail::max_bodies && c.shapes <= detail::max_shapes &&
           c.contacts <= detail::max_contacts && c.joints <= max_capacity && c.geometries <= max_capacity && c.hits <= max_capacity && c.events <= max_capacity;
}

ISLET_INTERNAL_BEGIN
namespace detail {

#if ISLET_SMALL && !defined(ISLET_WITH_profile)
inline constexpr std::size_t profile_bytes = 0;
#else
inline constexpr std::size_t profile_bytes = 56;
#endif

// The most constraints that an engine for this processor can have in a block decide how constraint rows are padded in scratch. They depend on the processor
// alone, never on compiler flags, because a program and the engine are compiled apart and must agree.
#if defined(__x86_64__) || defined(_M_X64)
inline constexpr std::uint32_t layout_lanes = 8;
#elif defined(__i386__) || defined(_M_IX86) || defined(__aarch64__) || defined(__wasm__)
inline constexpr std::uint32_t layout_lanes = 4;
#else
inline constexpr std::uint32_t layout_lanes = 1;
#endif
inline constexpr std::uint32_t max_lanes = ISLET_MAX_LANES;
inline constexpr std::uint32_t min_lanes = ISLET_MIN_LANES < ISLET_MAX_LANES ? ISLET_MIN_LANES : ISLET_MAX_LANES;
inline constexpr std::uint32_t max_block_lanes = max_lanes < layout_lanes ? max_lanes : layout_lanes;  // constraints in a block; two blocks make sixteen
static_assert(max_lanes <= layout_lanes || (max_lanes == 16 && layout_lanes == 8), "this processor has no such ISLET_MAX_LANES");

// Room for Core inside World.
inline constexpr std::size_t core_bytes = sizeof(void*) >= 8 ? 640 : (layout_lanes > 1 ? 368 : 360) + profile_bytes;

// What arrays begin at a multiple of: a cache line, or what their elements need where there are no lanes, and memory is small.
inline constexpr std::size_t line_bytes = layout_lanes > 1 ? 64 : 8;

constexpr std::size_t align_up(std::size_t n) { return (n + line_bytes - 1) / line_bytes * line_bytes; }

inline constexpr std::size_t host_bytes = align_up(core_bytes);  // room for World at the start of the block

constexpr std::size_t max_of(std::size_t a, std::size_t b) { return a > b ? a : b; }

// Sizes of the records. data/arrays.hpp checks those of the arrays below; the others are checked beside each struct.
inline constexpr std::size_t state_bytes = 256;
inline constexpr std::size_t pose_bytes = 32;
inline constexpr std::size_t motion_bytes = 32;
inline constexpr std::size_t body_bytes = 96;
inline constexpr std::size_t shape_bytes = 80;
inline constexpr std::size_t box_bytes = 16;
inline constexpr std::size_t geometry_bytes = 160;
inline constexpr std::size_t tree_node_bytes = 32;
// Of an index in a contact: 16 bits in the small profile, but not where lanes load whole words of 32. (Tests ask for it there, with one lane.)
#if defined(ISLET_INDEX_BITS)
inline constexpr std::size_t index_bytes = ISLET_INDEX_BITS / 8;
#else
inline constexpr std::size_t index_bytes = ISLET_SMALL && layout_lanes == 1 ? 2 : 4;
#endif
inline constexpr std::size_t contact_bytes = 6 * index_bytes + 8;
inline constexpr std::size_t manifold_bytes = 2 * index_bytes + 88;
inline constexpr std::size_t image_header_bytes = 80;
inline constexpr std::size_t delta_header_bytes = 48;
inline constexpr std::size_t solver_body_bytes = 32;
inline constexpr std::size_t solver_motion_bytes = 32;
#if ISLET_SMALL && !defined(ISLET_WITH_surfaces)
inline constexpr std::size_t surface_bytes = 12;  // of a row, which does without
#else
inline constexpr std::size_t surface_bytes = 0;
#endif
#if ISLET_SMALL && !defined(ISLET_WITH_hits)
inline constexpr std::size_t hit_bytes = 0;      // per contact
inline constexpr std::size_t bounce_bytes = 12;  // of a row, which does without
#else
inline constexpr std::size_t hit_bytes = 4;
inline constexpr std::size_t bounce_bytes = 0;
#endif
#if ISLET_SMALL && !defined(ISLET_WITH_tuning)
inline constexpr std::size_t tuned_bytes = 0;  // of a number that tuning keeps, per body
#else
inline constexpr std::size_t tuned_bytes = 4;
#endif
#if ISLET_SMALL && !defined(ISLET_WITH_tuning) && !defined(ISLET_WITH_sleep)
inline constexpr bool keeps_islands = false;  // through the solve, for those who ask of which island a body is
#else
inline constexpr bool keeps_islands = true;
#endif
inline constexpr std::size_t place_bytes = ISLET_SMALL ? 2 : 4;  // of an index in the plan of a solve: of a body, its slot, its island, a contact
inline constexpr std::size_t lone_row_bytes = 88 + 2 * place_bytes - surface_bytes - bounce_bytes;
inline constexpr std::size_t row_bytes = layout_lanes > 1     ? 128
                                         : sizeof(void*) >= 8 ? (lone_row_bytes + 4 + 7) / 8 * 8
                                                              : lone_row_bytes;  // per contact, in a block of rows
/// An engine and a program whose worlds have another layout do not link.
template <std::size_t...>
struct LayoutName {};
using LaidOut = LayoutName<core_bytes, contact_bytes, place_bytes, row_bytes, hit_bytes, tuned_bytes, keeps_islands>;
inline constexpr std::size_t joint_bytes = 232;
inline constexpr std::size_t joint_row_bytes = 144;  // per joint, in a block of rows: of the longest kind
#define ISLET_ONE(...) +1
inline constexpr std::uint32_t joint_kernel_count = 0 ISLET_JOINT_KERNELS(ISLET_ONE);
#undef ISLET_ONE
inline constexpr std::size_t joint_run_bytes = 24;
inline constexpr std::size_t tree_link_bytes = 184;  // per link of a joint tree
inline constexpr std::size_t batch_bytes = ISLET_SMALL ? 92 : 172;
inline constexpr std::size_t plan_bytes = 168;                                 // of the plan itself, without its arrays
inline constexpr std::uint32_t max_plan_parts = 8;                             // that the touching contacts are cut into while they are planned
inline constexpr std::size_t sweep_bytes = layout_lanes > 1 ? 148 : 108;       // per shape, while pairs are found by sorting
inline constexpr std::uint32_t sort_digits = layout_lanes > 1 ? 1u << 11 : 0;  // counted by the sort; 0: where memory is small it counts none
inline constexpr std::uint32_t color_count = 32;                               // constraint colours: bits of a body's mask
inline constexpr std::uint32_t batch_bodies = 704;  // a batch is full from so many bodies on: with their rows they fit a core's own cache

// Whether a world keeps the plan of a step until something changes that it was made from. Not where memory is small.
inline constexpr bool keeps_plan = max_lanes > 1;

// Where memory is small, no set tells which pairs of shapes have a contact: the shorter list of contacts of their two bodies does.
inline constexpr bool has_pair_set = layout_lanes > 1 || sizeof(void*) >= 8;

constexpr std::uint32_t next_power_of_two(std::uint32_t n) {
    std::uint32_t p = 1;
    while (p < n && p < 0x80000000u) p *= 2;
    return p;
}

constexpr std::size_t words_for(std::uint32_t bits) { return (std::size_t{bits} + 63) / 64; }

constexpr std::uint32_t geometry_capacity(const Capacity& c) { return c.geometries != 0 ? c.geometries : c.shapes; }

constexpr std::uint32_t hit_capacity(const Capacity& c) { return c.hits != 0 ? c.hits : c.contacts / 8 > 8 ? c.contacts / 8 : 8; }

/// Touches that can begin in a step, and that can end, at most. (Contacts too: more than there are cannot begin.)
constexpr std::uint32_t event_capacity(const Capacity& c) { return c.events != 0 && c.events < c.contacts ? c.events : c.contacts; }

/// Batches that the islands of a world can make, at most.
constexpr std::uint32_t batch_capacity(const Capacity& c) { return c.bodies / batch_bodies + 2; }

/// Places of batches, and of the halves of one that has so many bodies that two workers may share it.
inline constexpr std::uint32_t halved_bodies = 768;
constexpr std::uint32_t place_capacity(const Capacity& c) { return batch_capacity(c) + (layout_lanes > 1 && c.bodies >= halved_bodies ? 2 : 0); }

/// Parts that the touching contacts are cut into while they are planned. Small worlds are not cut.
constexpr std::uint32_t plan_parts(const Capacity& c) { return c.contacts < 2048 ? 1 : max_plan_parts; }

/// Contact rows including the padding that fills up the last block of each colour of each batch.
constexpr std::size_t row_capacity(const Capacity& c) {
    const std::size_t colors = std::size_t{batch_capacity(c)} * color_count;
    return c.contacts + (colors < c.contacts ? colors : c.contacts) * (layout_lanes - 1);
}

/// Runs of joints of one kernel and one colour in one batch, at most.
constexpr std::size_t joint_run_capacity(const Capacity& c) {
    const std::size_t runs = std::size_t{batch_capacity(c)} * (color_count + 1) * joint_kernel_count;
    return runs < c.joints ? runs : c.joints;
}

/// Joint rows including the padding that fills up the last block of each run.
constexpr std::size_t joint_row_capacity(const Capacity& c) { return c.joints + joint_run_capacity(c) * (layout_lanes - 1); }

/// Links of joint trees, at most.
constexpr std::uint32_t tree_capacity(const Capacity& c) { return c.joints + (c.bodies < c.joints ? c.bodies : c.joints); }

/// An array has one element for each of these.
enum class Per : std::uint8_t { world, body, shape, geometry, bucket, tree_node, contact, pair, clearance, joint, hit, event };

/// Elements that there is room for.
constexpr std::size_t room_for(Per per, const Capacity& c) {
    switch (per) {
        case Per::world: return 1;
        case Per::body: return c.bodies;
        case Per::shape: return c.shapes;
        case Per::geometry: return geometry_capacity(c);
        case Per::bucket: return next_power_of_two(geometry_capacity(c));
        case Per::tree_node: return std::size_t{2} * c.shapes - 1;
        case Per::contact: return c.contacts;
        case Per::pair: return has_pair_set ? next_power_of_two(2 * c.contacts) : 0;
        case Per::clearance: return layout_lanes > 1 ? c.contacts : 0;
        case Per::joint: return c.joints;
        case Per::hit: return hit_capacity(c);
        case Per::event: return event_capacity(c);
    }
    return 0;
}

/// saved: persistent, and in snapshots. derived: persistent, and made from the other arrays when a snapshot is restored. output: results of the last step.
enum class Kept : std::uint8_t { saved, derived, output };

inline constexpr std::size_t one_bit = 0;  // size of an element of a set of bits, which takes whole words of 64

// The arrays of a world, in the order of its block and of its snapshots. To add one, add a line here and the pointer of that name to Core (data/core.hpp).
// The offset, the pointer's value, snapshots, deltas, the hash and the checks of pools and bits follow. A saved array needs a new image_version.
//   size   bytes of an element, or one_bit
//   hash   the array's turn in World::hash: 1 is first, 0 is never (the state is hashed field by field, before all arrays)
//
//    name              size                      one per    kept     hash
// clang-format off
#define ISLET_ARRAYS(X) \
    X(state,            state_bytes,              world,     saved,    0) \
    X(poses,            pose_bytes,               body,      saved,    1) \
    X(motions,          motion_bytes,             body,      saved,    2) \
    X(bodies,           body_bytes,               body,      saved,    3) \
    X(shapes,           shape_bytes,              shape,     saved,    4) \
    X(boxes,            box_bytes,                shape,     saved,    6) \
    X(geometries,       geometry_bytes,           geometry,  saved,    7) \
    X(geometry_buckets, 4,                        bucket,    derived,  0) \
    X(tree,             tree_node_bytes,          tree_node, saved,   10) \
    X(contacts,         contact_bytes,            contact,   saved,    8) \
    X(manifolds,        manifold_bytes,           contact,   saved,    9) \
    X(pairs,            8,                        pair,      derived,  0) \
    X(clearances,       4,                        clearance, derived,  0) /* never too large; 0, as after a restore, costs time alone */ \
    X(joints,           joint_bytes,              joint,     saved,    5) \
    X(awake_bodies,     one_bit,                  body,      saved,   11) \
    X(awake_contacts,   one_bit,                  contact,   saved,   12) \
    X(awake_joints,     one_bit,                  joint,     saved,   13) \
    X(moved_shapes,     one_bit,                  shape,     saved,   14) \
    X(begins,           one_bit,                  contact,   derived,  0) /* empty between steps */ \
    X(end_events,       sizeof(TouchEvent),       event,     output,   0) /* those that the next step reports are saved and hashed, after all arrays */ \
    X(begin_events,     sizeof(TouchEvent),       event,     output,   0) \
    X(hit_events,       sizeof(HitEvent),         hit,       output,   0) \
    X(moved_events,     sizeof(BodyId),           body,      output,   0) \
    X(slept_events,     sizeof(BodyId),           body,      output,   0) \
    X(break_events,     sizeof(JointBreakEvent),  joint,     output,   0) \
    X(residuals,        4,                        body,      output,   0) /* from the begin events to here, what a step writes at its end */
// clang-format on

/// An array's place in the table.
enum class Array : std::uint32_t {
#define ISLET_NAME(name, ...) name,
    ISLET_ARRAYS(ISLET_NAME)
#undef ISLET_NAME
};

/// Bytes of an element in a snapshot: the same as in the block, but for contacts, whose indices have 32 bits there.
constexpr std::size_t size_in_image(Array array, std::size_t size) { return array == Array::contacts ? 32 : array == Array::manifolds ? 96 : size; }

/// A row of the table.
struct ArrayRow {
    std::uint16_t size;
    std::uint16_t image_size;  // a multiple of 8 if the array is saved
    Per per;
    Kept kept;
    std::uint8_t hash;

    /// Bytes of `n` elements in the block, and in a snapshot.
    constexpr std::size_t bytes(std::size_t n) const { return size == one_bit ? words_for(static_cast<std::uint32_t>(n)) * 8 : n * size; }
    constexpr std::size_t image_bytes(std::size_t n) const { return size == one_bit ? bytes(n) : n * image_size; }
};

inline constexpr ArrayRow array_rows[] = {
#define ISLET_ROW(name, size, per, kept, hash) {size, size_in_image(Array::name, size), Per::per, Kept::kept, hash},
    ISLET_ARRAYS(ISLET_ROW)
#undef ISLET_ROW
};
inline constexpr std::uint32_t array_count = sizeof array_rows / sizeof array_rows[0];

/// Offsets from the start of the block, bytes.
struct Layout {
    std::size_t arrays[array_count];
    std::size_t persistent_end, scratch, end;

    constexpr std::size_t operator[](Array a) const { return arrays[static_cast<std::uint32_t>(a)]; }
};

/// Bytes of the arrays that a step writes at its end alone. Until then they are scratch memory, too.
constexpr std::size_t late_bytes(const Capacity& c) {
    std::size_t bytes = 0;
    for (std::uint32_t i = static_cast<std::uint32_t>(Array::begin_events); i <= static_cast<std::uint32_t>(Array::residuals); ++i)
        bytes = align_up(bytes + array_rows[i].bytes(room_for(array_rows[i].per, c)));
    return bytes;
}

// Bytes that the stages of a step take from scratch, at most (tests/unit/scratch_test.cpp checks that). Other calls take less than pairs and collide, or
// what `calls` and `exporting` (an island) say. `lent`: of a world whose scratch does not follow its arrays.
//
//   | late arrays | scratch ...                                         |
//   | planning; then rows and motions            | bodies | plan         |   taken from both ends, the plan and the bodies to stay until the step ends
//   | what a step tells | finishing              | bodies | plan         |
constexpr std::size_t scratch_bytes(const Capacity& c, bool lent = false) {
    // Pairs: sort keys, and boxes as columns. Collide: which contacts changed, and which bodies wake. Plan: bodies and constraints in the order of batches.
    // Planning: islands, and lists of constraints. Weighing: what bodies bear, in place of the rows.
    const std::size_t bodies = std::size_t{c.bodies} + 1;
    const std::size_t pairs = std::size_t{c.shapes} * sweep_bytes + words_for(c.bodies) * 8 + sort_digits * 4 + 12 * 4 * layout_lanes + 20 * line_bytes;
    const std::size_t collide = words_for(c.contacts) * (layout_lanes > 1 ? 32 : 20) + words_for(c.bodies) * 8 + bodies * 4 + 5 * line_bytes;
    const std::size_t calls =
        max_of(std::size_t{next_power_of_two(2 * c.contacts + 1)} * 8, max_of(geometry_capacity(c) * std::size_t{4}, bodies * 8)) + 2 * line_bytes;
    const std::size_t constraints = std::size_t{c.contacts} + c.joints, ends = std::size_t{2} * c.contacts + std::size_t{4} * c.joints;
    const std::size_t exporting = align_up(words_for(c.contacts) * 8) + align_up(words_for(c.joints) * 8) + 2 * align_up(c.bodies * std::size_t{4}) +
                                  2 * align_up((constraints + 1) * 4) + 2 * align_up(ends * 4) + align_up((bodies + 1) * 4);
    const std::size_t plan = align_up(c.bodies * place_bytes) + align_up(bodies * place_bytes) * (keeps_islands ? 2 : 1) + align_up(c.bodies * tuned_bytes) +
                             align_up(place_capacity(c) * batch_bytes) + align_up(row_capacity(c) * place_bytes) + align_up(joint_row_capacity(c) * 4) +
                             align_up(joint_run_capacity(c) * joint_run_bytes) + align_up(tree_capacity(c) * std::size_t{8}) +
                             align_up(tree_capacity(c) * std::size_t{4});
    const std::size_t contact_tables = plan_parts(c) == 1 ? 1 : 2 * plan_parts(c);  // those that land are counted by themselves
    const std::size_t kinds = contact_tables + (c.joints != 0 ? joint_kernel_count : 0);
    const std::size_t tables = std::size_t{place_capacity(c)} * (color_count + 1) * kinds * 4 + 6 * line_bytes;
    const std::size_t trees = c.joints == 0 ? 0 : bodies * 16 + tree_capacity(c) * 8 + 4 * line_bytes;
    const std::size_t planning = bodies * 4 * 4 + words_for(c.bodies) * 8 + (std::size_t{c.contacts} + c.joints) * 16 + 6 * line_bytes + max_of(tables, trees);
    const std::size_t rows = align_up(bodies * solver_motion_bytes) + align_up(row_capacity(c) * row_bytes) + line_bytes +
                             align_up(joint_row_capacity(c) * joint_row_bytes) + joint_run_capacity(c) * line_bytes +
                             align_up(tree_capacity(c) * tree_link_bytes) +
                             (layout_lanes > 1 ? align_up(row_capacity(c) / 4 * place_bytes) : 0);  // of blocks that land
    const std::size_t finish = bodies * (4 + 4) + words_for(c.bodies + 1) * 4 + words_for(c.joints) * 8 + 4 * line_bytes;
    const std::size_t weighing = bodies * 8 + c.contacts * std::size_t{16} + 2 * line_bytes;
    const std::size_t stays = plan + align_up(bodies * solver_body_bytes) + align_up(bodies * tuned_bytes) + align_up(c.contacts * hit_bytes);
    const std::size_t late = lent ? 0 : late_bytes(c);
    const std::size_t step = stays + max_of(max_of(planning, rows), max_of(weighing, late + finish));
    const std::size_t kept = layout_lanes > 1 && !lent ? plan + align_up(plan_bytes) : 0;  // the plan stays while other stages and calls use scratch
    return max_of(step + align_up(layout_lanes > 1 ? plan_bytes : 0), late + kept + max_of(max_of(calls, exporting), max_of(pairs, collide))) - late;
}

/// Worlds of a fleet that a worker steps side by side, so that their contacts share lanes. Larger worlds fill the lanes by themselves.
constexpr std::uint32_t worlds_together(const Capacity& c, std::uint32_t worlds) {
    const std::uint32_t most = c.contacts <= 512 ? layout_lanes : 1;
    return worlds < most ? worlds : most;
}

constexpr Layout layout_of(const Capacity& c) {
    Layout l{};
    std::size_t at = host_bytes;
    for (std::uint32_t i = 0; i < array_count; ++i) {
        l.arrays[i] = at;
        at = align_up(at + array_rows[i].bytes(room_for(array_rows[i].per, c)));
        if (array_rows[i].kept != Kept::output) l.persistent_end = at;
    }
    l.scratch = at;
    l.end = align_up(at + scratch_bytes(c));
    return l;
}

/// Bytes from a world of a fleet to the next, a multiple of World's alignment. Worlds of a group count contacts and bodies from the first world's, so where
/// there are groups it is a multiple of their records, too.
ISLET_ALWAYS_INLINE constexpr std::size_t fleet_stride(const Layout& layout) {
    if constexpr (layout_lanes == 1) return (layout.scratch + 15) / 16 * 16;
    constexpr std::size_t unit = 192;
    static_assert(index_bytes == 2 || (unit % manifold_bytes == 0 && unit % pose_bytes == 0 && unit % 64 == 0));
    return (layout.scratch + unit - 1) / unit * unit;
}

}  // namespace detail
ISLET_INTERNAL_END

/// Bytes of memory a world of this capacity needs, everything included; 0 if the capacity is not valid.
constexpr std::size_t world_bytes(const Capacity& capacity) { return is_valid(capacity) ? detail::layout_of(capacity).end : 0; }

}  // namespace islet
ISLET_API_END
