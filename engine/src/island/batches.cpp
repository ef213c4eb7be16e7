#include "island/batches.hpp"

#include "constraint/joint_runs.hpp"
#include "memory/parallel.hpp"

namespace islet::detail {

namespace {

// Union-find with path halving; the smaller index becomes the root, so the roots do not depend on the order of the links.
std::uint32_t find_root(std::uint32_t* parent, std::uint32_t i) {
    while (parent[i] != i) {
        parent[i] = parent[parent[i]];
        i = parent[i];
    }
    return i;
}

void join(std::uint32_t* parent, std::uint32_t a, std::uint32_t b) {
    if (parent[a] == parent[b]) return;  // as most are: their island was joined by other links
    a = find_root(parent, a);
    b = find_root(parent, b);
    if (a < b) {
        parent[b] = a;
    } else {
        parent[a] = b;
    }
}

/// A touching contact or a joint, as far as the plan is concerned: bodies by number (0: at rest), colour.
struct Edge {
    std::uint32_t constraint, a, b, color;
};

constexpr std::uint32_t kinematic_bit = 1u << 31;

// The touching contacts, cut into parts that are planned side by side: each lists its edges in its own piece of the array, counts them by place, and puts
// them where the counts of all say. What is listed and put is the same however it is cut.
struct EdgeList {
    Edge* edges = nullptr;
    std::uint32_t parts = 1;
    std::uint32_t words = 0;                      // of the set of awake contacts, in a part
    std::uint32_t first[max_plan_parts] = {};     // edge of each part
    std::uint32_t end[max_plan_parts] = {};

    template <class Visit>
    [[gnu::always_inline]] void for_each(Visit&& visit) const {
        for (std::uint32_t p = 0; p < parts; ++p)
            for (std::uint32_t k = first[p]; k < end[p]; ++k) visit(edges[k]);
    }
};

EdgeList list_edges(const Core& core, const Plan& plan, Edge* edges) {
    const BitSet awake = core.awake_contacts;
    EdgeList list;
    list.edges = edges;
    list.words = awake.word_count;
    if (has_workers(core)) {
        list.words = range_count(awake.word_count, plan_parts(core.capacity));
        list.parts = range_count(awake.word_count, list.words);
        for (std::uint32_t p = 1; p < list.parts; ++p)
            list.first[p] = list.first[p - 1] + awake.count_in((p - 1) * list.words, p * list.words);
    }
    for_ranges(core, awake.word_count, list.words, [&](std::uint32_t first, std::uint32_t end) {
        const std::uint32_t part = first / list.words;
        std::uint32_t at = list.first[part];
        awake.for_each_in(first, end, [&](std::uint32_t i) {
            const ContactManifold& m = core.manifolds[i];
            if ((m.flags & contact_touching) == 0) return;
            edges[at++] = {i, plan.slot_of[m.body_a], plan.slot_of[m.body_b], m.color()};
        });
        list.end[part] = at;
    });
    return list;
}

// Contacts into (batch, colour) order: count, lay out whole blocks, place. batch_of(edge) says which batch.
template <class BatchOf>
void plan_contacts(const Core& core, Plan& plan, const EdgeList& list, BatchOf&& batch_of, Arena temporary) {
    constexpr std::uint32_t places = color_count + 1;  // per batch, the last for what has no colour
    const std::uint32_t lanes = core.lanes;
    const std::size_t part_size = std::size_t{plan.batch_count} * places;
    std::uint32_t* next = temporary.take<std::uint32_t>(part_size * list.parts);
    for_ranges(core, list.parts, 1, [&](std::uint32_t first, std::uint32_t end) {
        for (std::uint32_t p = first; p < end; ++p) {
            std::uint32_t* count = next + p * part_size;
            std::memset(count, 0, part_size * 4);
            for (std::uint32_t k = list.first[p]; k < list.end[p]; ++k) {
                Edge& e = list.edges[k];
                e.a = batch_of(e) * places + (e.color == no_color ? color_count : e.color);
                ++count[e.a];
            }
        }
    });

    std::uint32_t block = 0;
    std::uint32_t overflow = 0;
    const auto place = [&](std::size_t entry, std::uint32_t start) {
        for (std::uint32_t p = 0; p < list.parts; ++p) {
            std::uint32_t& count = next[p * part_size + entry];
            const std::uint32_t here = count;
            count = start;
            start += here;
        }
        return start;
    };
    for (std::uint32_t b = 0; b < plan.batch_count; ++b) {
        Batch& batch = plan.batches[b];
        for (std::uint32_t c = 0; c < color_count; ++c) {
            batch.first_block[c] = block;
            const std::uint32_t end = place(std::size_t{b} * places + c, block * lanes);
            if (end == block * lanes) continue;
            plan.colors |= 1u << c;
            block = (end + lanes - 1) / lanes;
            for (std::uint32_t i = end; i < block * lanes; ++i) plan.contacts[i] = null_index;
        }
        batch.first_block[color_count] = block;
        batch.first_overflow = overflow;
        batch.end_overflow = overflow = place(std::size_t{b} * places + color_count, overflow);
    }
    plan.block_count = block;
    plan.overflow_count = overflow;

    std::uint32_t* const overflows = plan.contacts + std::size_t{block} * lanes;
    for_ranges(core, list.parts, 1, [&](std::uint32_t first, std::uint32_t end) {
        for (std::uint32_t p = first; p < end; ++p) {
            std::uint32_t* at = next + p * part_size;
            for (std::uint32_t k = list.first[p]; k < list.end[p]; ++k) {
                const Edge& e = list.edges[k];
                (e.color == no_color ? overflows : plan.contacts)[at[e.a]++] = e.constraint;
            }
        }
    });
}

// Joints into (batch, colour, kernel) order: count, lay out runs of whole blocks, place. Joints without a colour come first in their batch, in
// blocks of one.
template <class BatchOf>
void plan_joints(const Core& core, Plan& plan, Edge* edges, BatchOf&& batch_of, Arena temporary) {
    constexpr std::uint32_t places = (color_count + 1) * joint_kernel_count;  // per batch
    const auto place_of = [&](const Edge& e) {
        const auto kernel = static_cast<std::uint32_t>(kernel_of(core.joints[e.constraint]));
        return (e.color == no_color ? 0u : e.color + 1) * joint_kernel_count + kernel;
    };
    std::uint32_t* next = temporary.take<std::uint32_t>(std::size_t{plan.batch_count} * places);
    if (!has_joints || plan.joint_count == 0) return;
    std::memset(next, 0, std::size_t{plan.batch_count} * places * 4);
    for (std::uint32_t k = 0; k < plan.joint_count; ++k) {
        Edge& e = edges[k];
        e.a = batch_of(e) * places + place_of(e);
        ++next[e.a];
        if (e.color == no_color) {
            ++plan.overflow_joints;
        } else {
            plan.colors |= 1u << e.color;
        }
    }
    std::uint32_t at = 0;
    for (std::uint32_t b = 0; b < plan.batch_count; ++b) {
        plan.batches[b].first_run = plan.run_count;
        for (std::uint32_t place = 0; place < places; ++place) {
            std::uint32_t& entry = next[b * places + place];
            const std::uint32_t count = entry;
            entry = at;
            if (count == 0) continue;
            const bool overflow = place < joint_kernel_count;
            const std::uint32_t lanes = overflow ? 1 : core.lanes;
            const std::uint32_t blocks = (count + lanes - 1) / lanes;
            plan.runs[plan.run_count++] = {static_cast<JointKernel>(place % joint_kernel_count),
                                           overflow ? no_color : place / joint_kernel_count - 1, at, blocks, 0};
            for (std::uint32_t i = count; i < blocks * lanes; ++i) plan.joints[at + i] = null_index;
            at += blocks * lanes;
        }
        plan.batches[b].end_run = plan.run_count;
    }
    for (std::uint32_t k = 0; k < plan.joint_count; ++k) plan.joints[next[edges[k].a]++] = edges[k].constraint;
}

}  // namespace

Plan make_plan(const Core& core, Arena& arena) {
    Plan plan;
    const std::uint32_t bodies = core.state->body_pool.high_water;
    const std::uint32_t contacts = core.state->contact_pool.count;
    const std::uint32_t joints = core.state->joint_pool.count;
    plan.slot_of = arena.take<std::uint32_t>(bodies);
    plan.body_of = arena.take<std::uint32_t>(bodies + 1);
    plan.island_of = arena.take<std::uint32_t>(bodies + 1);
    plan.batches = arena.take<Batch>(batch_capacity(core.capacity));
    plan.contacts = arena.take<std::uint32_t>(row_capacity(core.capacity));
    plan.joints = arena.take<std::uint32_t>(joint_row_capacity(core.capacity));
    plan.runs = arena.take<JointRun>(joint_run_capacity(core.capacity));
    std::memset(plan.slot_of, 0, std::size_t{bodies} * 4);
    Arena temporary = arena;  // what follows is used only here, so the solve may take the same scratch

    // Awake bodies in slot order get a number from 1; islands are joined over these.
    std::uint32_t* list = temporary.take<std::uint32_t>(bodies + 1);
    std::uint32_t* parent = temporary.take<std::uint32_t>(bodies + 1);
    std::uint32_t* island = temporary.take<std::uint32_t>(bodies + 1);
    std::uint32_t n = 1;
    core.awake_bodies.for_each([&](std::uint32_t body) {
        plan.slot_of[body] = n;
        parent[n] = n;
        island[n] = core.poses[body].inv_mass > 0 ? 0 : null_index;  // kinematic bodies belong to no island
        list[n++] = body;
    });
    island[0] = null_index;
    plan.slot_count = n;

    // How many constraints each body adds to its island, and whether one of them is with a kinematic body.
    std::uint32_t* weight = temporary.take<std::uint32_t>(bodies + 1);
    std::memset(weight, 0, std::size_t{n} * 4);
    const auto add_edge = [&](const Edge& e) {
        const bool moves_a = island[e.a] != null_index, moves_b = island[e.b] != null_index;
        std::uint32_t& w = weight[moves_a ? e.a : e.b];
        ++w;
        if (moves_a && moves_b) {
            join(parent, e.a, e.b);
        } else if ((moves_a ? e.b : e.a) != 0) {
            w |= kinematic_bit;
        }
    };
    const EdgeList edges = list_edges(core, plan, temporary.take<Edge>(contacts));
    edges.for_each(add_edge);
    for (std::uint32_t p = 0; p < edges.parts; ++p) plan.touching_count += edges.end[p] - edges.first[p];
    Edge* joint_edges = temporary.take<Edge>(joints);
    const BitSet awake_joints = has_joints ? core.awake_joints : BitSet{};
    awake_joints.for_each([&](std::uint32_t i) {
        const Joint& j = core.joints[i];
        const Edge e{i, j.body_a != null_index ? plan.slot_of[j.body_a] : 0u, plan.slot_of[j.body_b], j.color()};
        const bool moves_a = island[e.a] != null_index, moves_b = island[e.b] != null_index;
        if (!moves_a && !moves_b) return;  // both bodies have become static or kinematic
        joint_edges[plan.joint_count++] = e;
        add_edge(e);
    });

    // Number the islands by their roots; a root is the smallest of its island, so one pass in order is enough. An island's weight takes its number's place
    // in `weight`, which is never beyond the body whose own weight was just read.
    std::uint32_t islands = 0;
    for (std::uint32_t i = 1; i < n; ++i) {
        if (island[i] == null_index) continue;
        const std::uint32_t own = weight[i];
        if (parent[i] == i) {
            island[i] = islands;
            weight[islands++] = own;
            continue;
        }
        parent[i] = find_root(parent, i);
        island[i] = island[parent[i]];
        weight[island[i]] = ((weight[island[i]] & ~kinematic_bit) + (own & ~kinematic_bit)) | ((weight[island[i]] | own) & kinematic_bit);
    }
    plan.island_count = islands;
    const auto batch_of = [&](const Edge& e) { return weight[island[e.a] != null_index ? island[e.a] : island[e.b]]; };  // once it is known

    // Islands into batches, in order. Those that touch a kinematic body all go to batch 0, together with the kinematic bodies, so that no two batches ever
    // share a moving body. `weight` becomes the batch of the island.
    std::uint32_t batch = 1;
    std::uint32_t filled = 0;
    for (std::uint32_t i = 0; i < islands; ++i) {
        if ((weight[i] & kinematic_bit) != 0) {
            weight[i] = 0;
            continue;
        }
        filled += weight[i];
        weight[i] = batch;
        if (filled < batch_contacts) continue;
        ++batch;
        filled = 0;
    }
    plan.batch_count = batch + 1;
    for (std::uint32_t b = 0; b < plan.batch_count; ++b) plan.batches[b] = Batch{};

    // Bodies into batch order: a counting sort.
    const auto batch_of_number = [&](std::uint32_t i) { return island[i] == null_index ? 0u : weight[island[i]]; };
    for (std::uint32_t i = 1; i < n; ++i) ++plan.batches[batch_of_number(i)].end_slot;
    std::uint32_t at = 1;
    for (std::uint32_t b = 0; b < plan.batch_count; ++b) {
        const std::uint32_t count = plan.batches[b].end_slot;
        plan.batches[b].first_slot = plan.batches[b].end_slot = at;
        at += count;
    }
    plan.body_of[0] = null_index;
    for (std::uint32_t i = 1; i < n; ++i) {
        const std::uint32_t slot = plan.batches[batch_of_number(i)].end_slot++;
        plan.body_of[slot] = list[i];
        plan.island_of[slot] = island[i];
        plan.slot_of[list[i]] = slot;
    }

    plan_contacts(core, plan, edges, batch_of, temporary);
    plan_joints(core, plan, joint_edges, batch_of, temporary);
    return plan;
}

}  // namespace islet::detail
