#include "island/batches.hpp"

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

/// A touching contact, as far as the plan is concerned: bodies by number (0: at rest), colour.
struct Edge {
    std::uint32_t contact, a, b, color;
};

constexpr std::uint32_t kinematic_bit = 1u << 31;

}  // namespace

Plan make_plan(const Core& core, Arena& arena) {
    Plan plan;
    const std::uint32_t bodies = core.state->body_pool.high_water;
    const std::uint32_t contacts = core.state->contact_pool.count;
    plan.slot_of = arena.take<std::uint32_t>(bodies);
    plan.body_of = arena.take<std::uint32_t>(bodies + 1);
    plan.island_of = arena.take<std::uint32_t>(bodies + 1);
    plan.batches = arena.take<Batch>(batch_capacity(core.capacity));
    plan.contacts = arena.take<std::uint32_t>(row_capacity(core.capacity));
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

    // Contacts per island, and which islands touch a kinematic body: those all go to batch 0, together with the kinematic bodies, so that no two
    // batches ever share a moving body.
    std::uint32_t* weight = temporary.take<std::uint32_t>(islands + 1);
    std::memset(weight, 0, std::size_t{islands} * 4);
    const auto island_of_edge = [&](const Edge& e) { return island[e.a] != null_index ? island[e.a] : island[e.b]; };
    for (std::uint32_t k = 0; k < edge_count; ++k) {
        const Edge& e = edges[k];
        std::uint32_t& w = weight[island_of_edge(e)];
        ++w;
        if ((e.a != 0 && island[e.a] == null_index) || (e.b != 0 && island[e.b] == null_index)) w |= kinematic_bit;
    }

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
            plan.contacts[padded + plan.batches[e.a].end_overflow++] = e.contact;
        } else {
            plan.contacts[next[e.a * color_count + e.color]++] = e.contact;
        }
    }
    return plan;
}

}  // namespace islet::detail
