// How a world's block of memory is laid out: a handful of arrays whose sizes follow from the capacity alone.
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

namespace islet {

/// Alignment that World::create demands of its block.
inline constexpr std::size_t world_alignment = 64;

/// No capacity may exceed this.
inline constexpr std::uint32_t max_capacity = sizeof(void*) >= 8 ? 1u << 22 : 1u << 18;

/// Whether a world can be made with such a capacity.
constexpr bool is_valid(const Capacity& c) {
    return c.bodies > 0 && c.shapes > 0 && c.contacts > 0 && c.bodies <= max_capacity && c.shapes <= max_capacity && c.contacts <= max_capacity &&
           c.joints <= max_capacity && c.geometries <= max_capacity && c.hits <= max_capacity;
}

namespace detail {

inline constexpr std::size_t core_bytes = 640;  // room for Core inside World
inline constexpr std::size_t host_bytes = 704;  // room for World at the start of the block

// The widest lanes of any engine for this processor decide how the constraint rows are padded in scratch. They depend on the processor alone, never on a
// file's flags: a program and the engine are compiled apart and must agree.
#if defined(__x86_64__) || defined(_M_X64)
inline constexpr std::uint32_t layout_lanes = 8;
#elif defined(__i386__) || defined(_M_IX86) || defined(__aarch64__) || defined(__wasm__)
inline constexpr std::uint32_t layout_lanes = 4;
#else
inline constexpr std::uint32_t layout_lanes = 1;
#endif
inline constexpr std::uint32_t max_lanes = ISLET_MAX_LANES;
static_assert(max_lanes <= layout_lanes, "this processor has no such ISLET_MAX_LANES");

// Sizes of the records, checked against the structs by static_assert in data/records.hpp and core.hpp.
inline constexpr std::size_t state_bytes = 256;
inline constexpr std::size_t pose_bytes = 32;
inline constexpr std::size_t motion_bytes = 32;
inline constexpr std::size_t body_bytes = 96;
inline constexpr std::size_t shape_bytes = 80;
inline constexpr std::size_t box_bytes = 16;
inline constexpr std::size_t geometry_bytes = 160;
inline constexpr std::size_t tree_node_bytes = 32;
inline constexpr std::size_t contact_bytes = 32;
inline constexpr std::size_t manifold_bytes = 96;
inline constexpr std::size_t image_header_bytes = 80;
inline constexpr std::size_t delta_header_bytes = 48;
inline constexpr std::size_t solver_body_bytes = 32;
inline constexpr std::size_t solver_motion_bytes = 32;
inline constexpr std::size_t row_bytes = 128;  // per contact, in a block of rows
inline constexpr std::size_t joint_bytes = 232;
inline constexpr std::size_t joint_row_bytes = 144;  // per joint, in a block of rows: of the longest kind
inline constexpr std::uint32_t joint_kernel_count = 9;
inline constexpr std::size_t joint_run_bytes = 24;
inline constexpr std::size_t tree_link_bytes = 140;  // per body of a tree of joints
inline constexpr std::size_t batch_bytes = 168;
inline constexpr std::uint32_t max_plan_parts = 8;                           // that the touching contacts are cut into while they are planned
inline constexpr std::size_t sweep_bytes = 108;                              // per shape, while pairs are found
inline constexpr std::uint32_t sort_digit_bits = layout_lanes > 1 ? 11 : 8;  // of the sort by which pairs are found: three passes, or four in little memory
inline constexpr std::uint32_t sort_digits = 1u << sort_digit_bits;
inline constexpr std::uint32_t color_count = 32;    // constraint colours: bits of a body's mask
inline constexpr std::uint32_t batch_bodies = 704;  // a batch of islands closes at this many bodies: with their rows they still fit a core's own cache

constexpr std::uint32_t next_power_of_two(std::uint32_t n) {
    std::uint32_t p = 1;
    while (p < n) p *= 2;
    return p;
}

constexpr std::size_t words_for(std::uint32_t bits) { return (std::size_t{bits} + 63) / 64; }

constexpr std::uint32_t geometry_capacity(const Capacity& c) { return c.geometries != 0 ? c.geometries : c.shapes; }

constexpr std::uint32_t hit_capacity(const Capacity& c) { return c.hits != 0 ? c.hits : c.contacts / 8 > 8 ? c.contacts / 8 : 8; }

/// Batches that the islands of a world can make, at most.
constexpr std::uint32_t batch_capacity(const Capacity& c) { return c.bodies / batch_bodies + 2; }

/// Parts that the touching contacts are cut into while they are planned: small worlds are not cut.
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

/// Bodies in trees of joints that are solved exactly, at most.
constexpr std::uint32_t tree_capacity(const Capacity& c) { return c.bodies < 2 * c.joints ? c.bodies : 2 * c.joints; }

/// Offsets from the start of the block, bytes.
struct Layout {
    std::size_t state, poses, motions, bodies, shapes, boxes, geometries, geometry_buckets, tree, contacts, manifolds, pairs, joints;
    std::size_t awake_bodies, awake_contacts, awake_joints, moved_shapes;
    std::size_t persistent_end;
    std::size_t begin_events, end_events, hit_events, moved_events, slept_events, break_events, residuals;
    std::size_t scratch, end;
};

constexpr std::size_t align_up(std::size_t n) { return (n + 63) / 64 * 64; }

constexpr std::size_t max_of(std::size_t a, std::size_t b) { return a > b ? a : b; }

constexpr std::size_t scratch_bytes(const Capacity& c) {
    // Finding pairs: sort keys and the boxes as columns. Collide: which contacts changed, whom to wake. Plan: bodies and contacts in batch order, kept
    // while the solve uses what is left for bodies and contact rows, planning before it for islands and edges, and finishing after it in place of the rows.
    const std::size_t bodies = std::size_t{c.bodies} + 1;
    const std::size_t pairs = std::size_t{c.shapes} * sweep_bytes + sort_digits * 4 + 12 * 4 * layout_lanes + 20 * 64;
    const std::size_t collide = words_for(c.contacts) * (8 * 2 + 4) + words_for(c.bodies) * 8 + bodies * 4 + 5 * 64;
    const std::size_t plan = bodies * 4 * 4 + std::size_t{batch_capacity(c)} * batch_bytes + row_capacity(c) * 4 + joint_row_capacity(c) * 4 +
                             joint_run_capacity(c) * joint_run_bytes + tree_capacity(c) * 12 + 10 * 64;
    const std::size_t tables = std::size_t{batch_capacity(c)} * (color_count + 1) * (plan_parts(c) + joint_kernel_count) * 4 + 5 * 64;
    const std::size_t trees = c.joints == 0 ? 0 : bodies * 16 + tree_capacity(c) * 8 + 4 * 64;
    const std::size_t planning = bodies * 4 * 4 + words_for(c.bodies) * 8 + (std::size_t{c.contacts} + c.joints) * 16 + 6 * 64 + max_of(tables, trees);
    const std::size_t rows =
        row_capacity(c) * row_bytes + joint_row_capacity(c) * joint_row_bytes + joint_run_capacity(c) * 64 + tree_capacity(c) * tree_link_bytes + 5 * 64;
    const std::size_t finish = bodies * (4 + 4) + words_for(c.bodies + 1) * 12 + c.shapes + 5 * 64;
    const std::size_t solve = bodies * (solver_body_bytes + solver_motion_bytes + 4) + c.contacts * std::size_t{4} + max_of(rows, finish) + 4 * 64;
    return max_of(plan + max_of(planning, solve), max_of(pairs, collide));
}

constexpr Layout layout_of(const Capacity& c) {
    Layout l{};
    std::size_t at = host_bytes;
    const auto take = [&at](std::size_t bytes) {
        const std::size_t offset = at;
        at = align_up(at + bytes);
        return offset;
    };
    l.state = take(state_bytes);
    l.poses = take(c.bodies * pose_bytes);
    l.motions = take(c.bodies * motion_bytes);
    l.bodies = take(c.bodies * body_bytes);
    l.shapes = take(c.shapes * shape_bytes);
    l.boxes = take(c.shapes * box_bytes);
    l.geometries = take(geometry_capacity(c) * geometry_bytes);
    l.geometry_buckets = take(next_power_of_two(geometry_capacity(c)) * std::size_t{4});
    l.tree = take(2 * c.shapes * tree_node_bytes);
    l.contacts = take(c.contacts * contact_bytes);
    l.manifolds = take(c.contacts * manifold_bytes);
    l.pairs = take(next_power_of_two(2 * c.contacts) * std::size_t{8});
    l.joints = take(c.joints * joint_bytes);
    l.awake_bodies = take(words_for(c.bodies) * 8);
    l.awake_contacts = take(words_for(c.contacts) * 8);
    l.awake_joints = take(words_for(c.joints) * 8);
    l.moved_shapes = take(words_for(c.shapes) * 8);
    l.persistent_end = at;
    l.begin_events = take(c.contacts * sizeof(TouchEvent));
    l.end_events = take(c.contacts * sizeof(TouchEvent));
    l.hit_events = take(hit_capacity(c) * sizeof(HitEvent));
    l.moved_events = take(c.bodies * sizeof(BodyId));
    l.slept_events = take(c.bodies * sizeof(BodyId));
    l.break_events = take(c.joints * sizeof(JointBreakEvent));
    l.residuals = take(c.bodies * std::size_t{4});
    l.scratch = at;
    l.end = align_up(at + scratch_bytes(c));
    return l;
}

}  // namespace detail

/// Bytes of memory a world of this capacity needs, everything included.
constexpr std::size_t world_bytes(const Capacity& capacity) { return detail::layout_of(capacity).end; }

}  // namespace islet
