#include "island/batches.hpp"

#include "constraint/joint_runs.hpp"

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

    Edge* edges = temporary.take<Edge>(contacts);
    std::uint32_t edge_count = 0;
    core.awake_contacts.for_each([&](std::uint32_t i) {
        const ContactManifold& m = core.manifolds[i];
        if ((m.flags & contact_touching) == 0) return;
        const Edge e{i, plan.slot_of[m.body_a], plan.slot_of[m.body_b], m.color()};
        edges[edge_count++] = e;
        if (island[e.a] != null_index && island[e.b] != null_index) join(parent, e.a, e.b);
    });
    plan.touching_count = edge_count;
    Edge* joint_edges = temporary.take<Edge>(joints);
    const BitSet awake_joints = has_joints ? core.awake_joints : BitSet{};
    awake_joints.for_each([&](std::uint32_t i) {
        const Joint& j = core.joints[i];
        const Edge e{i, j.body_a != null_index ? plan.slot_of[j.body_a] : 0u, plan.slot_of[j.body_b], j.color()};
        const bool moves_a = island[e.a] != null_index, moves_b = island[e.b] != null_index;
        if (!moves_a && !moves_b) return;  // both bodies have become static or kinematic
        joint_edges[plan.joint_count++] = e;
        if (moves_a && moves_b) join(parent, e.a, e.b);
    });

    // Number the islands by their roots; a root is the smallest of its island, so one pass in order is enough.
    std::uint32_t islands = 0;
    for (std::uint32_t i = 1; i < n; ++i) {
        if (island[i] == null_index) continue;
        if (parent[i] == i) {
            island[i] = islands++;
        } else {
            parent[i] = find_root(parent, i);
            island[i] = island[parent[i]];
        }
    }
    plan.island_count = islands;

    // Constraints per island, and which islands touch a kinematic body: those all go to batch 0, together with the kinematic bodies, so that no two
    // batches ever share a moving body.
    std::uint32_t* weight = temporary.take<std::uint32_t>(islands + 1);
    std::memset(weight, 0, std::size_t{islands} * 4);
    const auto island_of_edge = [&](const Edge& e) { return island[e.a] != null_index ? island[e.a] : island[e.b]; };
    const auto weigh = [&](const Edge& e) {
        std::uint32_t& w = weight[island_of_edge(e)];
        ++w;
        if ((e.a != 0 && island[e.a] == null_index) || (e.b != 0 && island[e.b] == null_index)) w |= kinematic_bit;
    };
    for (std::uint32_t k = 0; k < edge_count; ++k) weigh(edges[k]);
    for (std::uint32_t k = 0; k < plan.joint_count; ++k) weigh(joint_edges[k]);

    // Islands into batches, in order. `weight` becomes the batch of the island.
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

    // Contacts into (batch, colour) order: count, lay out whole blocks, place.
    const std::uint32_t lanes = core.lanes;
    for (std::uint32_t k = 0; k < edge_count; ++k) {
        Edge& e = edges[k];
        const std::uint32_t b = weight[island_of_edge(e)];
        if (e.color == no_color) {
            ++plan.batches[b].end_overflow;
        } else {
            ++plan.batches[b].first_block[e.color];
            plan.colors |= 1u << e.color;
        }
        e.a = b;
    }
    std::uint32_t block = 0;
    std::uint32_t overflow = 0;
    for (std::uint32_t b = 0; b < plan.batch_count; ++b) {
        for (std::uint32_t& entry : plan.batches[b].first_block) {
            const std::uint32_t count = entry;
            entry = block;
            block += (count + lanes - 1) / lanes;
        }
        const std::uint32_t count = plan.batches[b].end_overflow;
        plan.batches[b].first_overflow = plan.batches[b].end_overflow = overflow;
        overflow += count;
    }
    plan.block_count = block;
    plan.overflow_count = overflow;
    const std::size_t padded = std::size_t{block} * lanes;
    std::memset(plan.contacts, 0xff, padded * 4);

    std::uint32_t* next = temporary.take<std::uint32_t>(std::size_t{plan.batch_count} * color_count);
    for (std::uint32_t b = 0; b < plan.batch_count; ++b)
        for (std::uint32_t c = 0; c < color_count; ++c) next[b * color_count + c] = plan.batches[b].first_block[c] * lanes;
    for (std::uint32_t k = 0; k < edge_count; ++k) {
        const Edge& e = edges[k];
        if (e.color == no_color) {
            plan.contacts[padded + plan.batches[e.a].end_overflow++] = e.constraint;
        } else {
            plan.contacts[next[e.a * color_count + e.color]++] = e.constraint;
        }
    }
    plan_joints(core, plan, joint_edges, [&](const Edge& e) { return weight[island_of_edge(e)]; }, temporary);
    return plan;
}

}  // namespace islet::detail
