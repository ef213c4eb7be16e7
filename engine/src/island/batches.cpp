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

template <class Visit>
void for_each_touching(const Core& core, Visit&& visit) {
    core.awake_contacts.for_each([&](std::uint32_t i) {
        const ContactManifold& m = core.manifolds[i];
        if ((m.flags & contact_touching) != 0) visit(i, m);
    });
}

}  // namespace

Plan make_plan(const Core& core, Arena& arena) {
    Plan plan;
    const std::uint32_t room = core.state->body_pool.high_water;
    plan.slot_of = arena.take<std::uint32_t>(room);
    std::memset(plan.slot_of, 0, std::size_t{room} * 4);

    // Awake bodies in slot order get a number from 1; islands are joined over these.
    std::uint32_t* list = arena.take<std::uint32_t>(room + 1);
    std::uint32_t* parent = arena.take<std::uint32_t>(room + 1);
    std::uint32_t n = 1;
    core.awake_bodies.for_each([&](std::uint32_t body) {
        plan.slot_of[body] = n;
        parent[n] = n;
        list[n++] = body;
    });
    plan.slot_count = n;

    std::uint32_t touching = 0;
    for_each_touching(core, [&](std::uint32_t, const ContactManifold& m) {
        ++touching;
        if (core.is_dynamic(m.body_a) && core.is_dynamic(m.body_b)) join(parent, plan.slot_of[m.body_a], plan.slot_of[m.body_b]);
    });
    plan.touching_count = touching;

    // Number the islands by their roots; a root is the smallest of its island, so one pass in order is enough. `island` still goes by number.
    std::uint32_t* island = arena.take<std::uint32_t>(room + 1);
    std::uint32_t islands = 0;
    for (std::uint32_t i = 1; i < n; ++i) {
        if (!core.is_dynamic(list[i])) {
            island[i] = null_index;
        } else if (parent[i] == i) {
            island[i] = islands++;
        } else {
            parent[i] = find_root(parent, i);
            island[i] = island[parent[i]];
        }
    }
    plan.island_count = islands;

    // Contacts per island, and which islands touch a kinematic body: those all go to batch 0, together with the kinematic bodies, so that no two
    // batches ever share a moving body.
    std::uint32_t* weight = arena.take<std::uint32_t>(islands + 1);
    constexpr std::uint32_t kinematic_bit = 1u << 31;
    std::memset(weight, 0, std::size_t{islands} * 4);
    const auto island_of_contact = [&](const ContactManifold& m) {
        const std::uint32_t a = plan.slot_of[m.body_a];
        if (a != 0 && island[a] != null_index) return island[a];
        return island[plan.slot_of[m.body_b]];
    };
    for_each_touching(core, [&](std::uint32_t, const ContactManifold& m) {
        const std::uint32_t i = island_of_contact(m);
        ++weight[i];
        const std::uint32_t a = plan.slot_of[m.body_a];
        const std::uint32_t b = plan.slot_of[m.body_b];
        if ((a != 0 && island[a] == null_index) || (b != 0 && island[b] == null_index)) weight[i] |= kinematic_bit;
    });

    // Islands into batches, in order. `weight` becomes the batch of the island.
    std::uint32_t batch = 1;
    std::uint32_t filled = 0;
    for (std::uint32_t i = 0; i < islands; ++i) {
        const std::uint32_t contacts = weight[i] & ~kinematic_bit;
        if ((weight[i] & kinematic_bit) != 0) {
            weight[i] = 0;
            continue;
        }
        weight[i] = batch;
        filled += contacts;
        if (filled >= batch_contacts) {
            ++batch;
            filled = 0;
        }
    }
    plan.batch_count = batch + 1;
    plan.batches = arena.take<Batch>(plan.batch_count);
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
    plan.body_of = arena.take<std::uint32_t>(room + 1);
    plan.island_of = parent;
    plan.body_of[0] = null_index;
    // `parent` is read no more, so it can take the islands by slot; list and island still go by number.
    for (std::uint32_t i = 1; i < n; ++i) {
        const std::uint32_t slot = plan.batches[batch_of_number(i)].end_slot++;
        plan.body_of[slot] = list[i];
        plan.island_of[slot] = island[i];
    }
    for (std::uint32_t slot = 1; slot < n; ++slot) plan.slot_of[plan.body_of[slot]] = slot;

    // Contacts into (batch, colour) order: count, lay out whole blocks, place.
    const auto batch_of_contact = [&](const ContactManifold& m) {
        const std::uint32_t a = plan.slot_of[m.body_a];
        const std::uint32_t i = a != 0 && plan.island_of[a] != null_index ? plan.island_of[a] : plan.island_of[plan.slot_of[m.body_b]];
        return weight[i];
    };
    const std::uint32_t lanes = core.lanes;
    for_each_touching(core, [&](std::uint32_t, const ContactManifold& m) {
        Batch& b = plan.batches[batch_of_contact(m)];
        const std::uint32_t color = m.color();
        if (color == no_color) {
            ++b.end_overflow;
        } else {
            ++b.first_block[color];
            plan.colors |= 1u << color;
        }
    });
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
    plan.contacts = arena.take<std::uint32_t>(padded + overflow);
    std::memset(plan.contacts, 0xff, padded * 4);

    std::uint32_t* next = arena.take<std::uint32_t>(std::size_t{plan.batch_count} * color_count);
    for (std::uint32_t b = 0; b < plan.batch_count; ++b)
        for (std::uint32_t c = 0; c < color_count; ++c) next[b * color_count + c] = plan.batches[b].first_block[c] * lanes;
    for_each_touching(core, [&](std::uint32_t contact, const ContactManifold& m) {
        const std::uint32_t b = batch_of_contact(m);
        const std::uint32_t color = m.color();
        if (color == no_color) {
            plan.contacts[padded + plan.batches[b].end_overflow++] = contact;
        } else {
            plan.contacts[next[b * color_count + color]++] = contact;
        }
    });
    return plan;
}

}  // namespace islet::detail
