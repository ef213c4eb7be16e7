#include "../exact.hpp"

#include "../graph/contact_batches.hpp"

#include "../graph/contact_parts.hpp"

#if ISLET_THREADS  // a build that keeps all functions does without these

namespace islet::detail {

namespace {

inline constexpr std::uint32_t record_grain = 64;  // contacts whose records are worth a task

// Calls visit(contact, side, body) for the sides of all contacts that fall to a worker by their body, in order.
template <class Visit>
void for_sides(const Core& core, span<const std::uint32_t> contacts, std::uint32_t worker, Visit&& visit) {
    const std::uint32_t workers = worker_count(core);
    for (const std::uint32_t contact : contacts) {
        const std::uint32_t a = core.manifolds[contact].body_a, b = core.manifolds[contact].body_b;
        if (a % workers == worker) visit(contact, 0u, a);
        if (b % workers == worker) visit(contact, 1u, b);
    }
}

// Calls visit(contact) for those that fall to a worker by their word in a set of bits.
template <class Visit>
void for_words(const Core& core, span<const std::uint32_t> contacts, std::uint32_t worker, Visit&& visit) {
    for (const std::uint32_t contact : contacts)
        if (contact / 64 % worker_count(core) == worker) visit(contact);
}

}  // namespace

bool name_contact(Core& core, std::uint32_t shape_1, std::uint32_t shape_2, std::uint32_t& contact) {
    contact = pool_take(core.state->contact_pool, core.contacts, core.capacity.contacts);
    if (contact == null_index) return false;
    core.contacts[contact].shape_a = static_cast<ContactIndex>(shape_1);
    core.contacts[contact].shape_b = static_cast<ContactIndex>(shape_2);
    core.pairs.insert(pair_key(core, contact));
    return true;
}

void make_contacts(Core& core, span<const std::uint32_t> contacts) {
    for_ranges(core, static_cast<std::uint32_t>(contacts.size()), record_grain, [&](std::uint32_t first, std::uint32_t end) {
        for (std::uint32_t i = first; i < end; ++i) fill_contact(core, contacts[i], core.contacts[contacts[i]].shape_a, core.contacts[contacts[i]].shape_b);
    });
    for_ranges(core, worker_count(core), 1, [&](std::uint32_t first, std::uint32_t end) {
        for (std::uint32_t worker = first; worker < end; ++worker) {
            for_sides(core, contacts, worker,
                      [&](std::uint32_t contact, std::uint32_t side, std::uint32_t body) { attach_contact(core, contact, side, body); });
            for_words(core, contacts, worker, [&](std::uint32_t contact) { note_awake(core, contact); });
        }
    });
}

void remove_contacts(Core& core, span<const std::uint32_t> contacts) {
    for_ranges(core, 1 + worker_count(core), 1, [&](std::uint32_t first, std::uint32_t end) {
        for (std::uint32_t task = first; task < end; ++task) {
            if (task == 0) {
                for (const std::uint32_t contact : contacts) core.pairs.erase(pair_key(core, contact));
                continue;
            }
            for_sides(core, contacts, task - 1,
                      [&](std::uint32_t contact, std::uint32_t side, std::uint32_t body) { detach_contact(core, contact, side, body); });
            for_words(core, contacts, task - 1, [&](std::uint32_t contact) { core.awake_contacts.clear(contact); });
        }
    });
    for_ranges(core, static_cast<std::uint32_t>(contacts.size()), record_grain, [&](std::uint32_t first, std::uint32_t end) {
        for (std::uint32_t i = first; i < end; ++i) clear_contact(core, contacts[i]);
    });
    for (const std::uint32_t contact : contacts) pool_give(core.state->contact_pool, core.contacts, contact);
}

}  // namespace islet::detail

#endif
