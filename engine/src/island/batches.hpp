// Islands and batches: which bodies and constraints are solved together.
//
// An island is a set of dynamic bodies that touching contacts and joints connect. Static and kinematic bodies connect nothing. Islands join as soon as a
// contact touches, and split as soon as one ends: a step finds them anew, by union-find, unless it can take the plan of the last step. Several islands make a
// batch, sized so that its bodies and rows fit a core's cache. Within a batch, contacts are grouped by colour, and joints by colour and kernel.
//
//   slots:   | 0: static | batch 0's bodies | batch 1's bodies | ...
//   rows:    | batch 0: colour 0 (padded to whole blocks), colour 1, ... | batch 1: ... |        + the overflow, in blocks of one
//
// A body's island, batch and slot never change a result: rows of one colour are independent, and so are islands.
#pragma once

#include "../constraint/joint_rows.hpp"
#include "../data/core.hpp"
#include "../data/parallel.hpp"
#include "../island/joint_trees.hpp"

namespace islet::detail {

/// A run of islands solved together, or a half of one. Offsets are in blocks of Core::block_lanes contacts; overflow in contacts.
struct Batch {
    PlanIndex first_slot = 0, body_count = 0;  // slots of its bodies
    PlanIndex first_block[color_count + 1] = {};
    PlanIndex first_overflow = 0, end_overflow = 0;
    PlanIndex first_run = 0, end_run = 0;          // of joints
    PlanIndex weight = 0;                          // an estimate of how long its solve takes, by which workers share batches
    std::uint32_t first_link = 0, link_count = 0;  // of joint trees
    std::uint32_t sweeps = 0;                      // that the solve has made of it

    std::uint32_t end_slot() const { return std::uint32_t{first_slot} + body_count; }
};

/// Joints of one kernel and one colour, in whole blocks of Core::block_lanes joints. Runs without a colour come first and are solved one by one.
struct JointRun {
    JointKernel kernel = JointKernel::point;
    std::uint32_t color = no_color;
    std::uint32_t first = 0;  // in Plan::joints
    std::uint32_t blocks = 0;
    std::uint64_t offset = 0;  // bytes, of its rows in those of all joints; the solve fills it in
};

static_assert(std::size_t{max_bodies / batch_bodies + 2} * (color_count + 1) * joint_kernel_count <= no_plan_index, "runs of joints have no places");
static_assert(sizeof(Batch) == batch_bytes && sizeof(JointRun) == joint_run_bytes);

/// Whether a batch may be cut into halves for two workers.
inline constexpr bool has_halves = has_threads && max_lanes > 1;

/// The plan of one solve, in scratch.
struct Plan {
    std::uint32_t slot_count = 0;    // slot 0 included
    PlanIndex* body_of = nullptr;    // by slot
    PlanIndex* slot_of = nullptr;    // by body; 0 for those at rest
    PlanIndex* island_of = nullptr;  // by slot; no_plan_index for kinematic bodies; null if no one will ask (keeps_islands)
    std::uint32_t island_count = 0;
    Batch* batches = nullptr;
    std::uint32_t batch_count = 0;
    std::uint32_t halved_batch = null_index;  // whose two halves, with some of its contacts, follow the batches (halves.hpp); null_index: none has halves
    PlanIndex* contacts = nullptr;            // by row: blocks first, then overflow; no_plan_index in the padding
    std::uint32_t block_count = 0;
    std::uint32_t overflow_count = 0;
    std::uint32_t* joints = nullptr;  // run by run; null_index in the padding
    JointRun* runs = nullptr;
    std::uint32_t run_count = 0;
    std::uint32_t joint_count = 0;          // in runs
    std::uint32_t awake_joints = 0;         // in runs or joint trees
    bool has_trees = false;                 // joint trees
    std::uint32_t overflow_joints = 0;      // without a colour
    PlannedLink* links = nullptr;           // of joint trees: batch by batch, tree by tree; in each what holds it, then leaves first
    std::uint32_t* parent_links = nullptr;  // by link: its parent's place among the tree's; null_index: a root, whose parent cannot be pushed or is none
    std::uint32_t link_count = 0;
    float* lightness = nullptr;  // by body: the solve takes its mass for so many times smaller (shock propagation); null: all masses as they are
    std::uint32_t colors = 0;    // bits of the colours in use
    std::uint32_t touching_count = 0;

    std::uint32_t half_count() const { return has_halves && halved_batch != null_index ? 2 : 0; }
};

static_assert(sizeof(Plan) <= plan_bytes);

/// Batch 0 holds the kinematic bodies, and all islands that touch one or are joined to one.
inline constexpr std::uint32_t kinematic_batch = 0;

/// An island while the plan is made.
struct Island {
    std::uint32_t bodies = 0;
    std::uint32_t batch = null_index;  // kinematic_batch as soon as a body of the island is known to be guided; other islands get theirs in order
};

/// The islands of a plan, and where each body belongs.
struct Islands {
    Island* islands;
    std::uint32_t* island_of;       // by awake body; null_index for kinematic ones
    std::uint32_t kinematic_count;  // of awake bodies

    std::uint32_t batch_of(std::uint32_t dynamic_body) const { return islands[island_of[dynamic_body]].batch; }
};

/// Lists the links of awake joint trees, tree by tree.
ISLET_OPTIONAL void plan_links(const Core& core, Plan& plan, const Islands& islands, Arena temporary);

/// Makes the plan of all awake bodies. Its arrays are taken from the end of `arena`.
Plan make_plan(const Core& core, Arena& arena);

/// The plan of the last step, if nothing has changed that it was made from (Core::forget_plan). Otherwise a new one, which is kept at the end of scratch, but
/// not if scratch is lent, or if the plan depends on where bodies are (sweep orders, shock propagation).
Plan kept_or_new_plan(Core& core, Arena& arena);

}  // namespace islet::detail
