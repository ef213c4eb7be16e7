// Many contacts made or removed by several workers at once, with the results of one after another.
//
// The parts of that (contact_parts.hpp) touch different memory. The set of pairs and the free slots are one worker's. The lists of two bodies have nothing in
// common: a worker takes the bodies whose index falls to it, and goes through all contacts in order. So it does with the words of the set of awake contacts.
// Any worker fills in, or clears, the records of a contact.
#pragma once

#include "../data/parallel.hpp"
#include "../graph/contacts.hpp"
#include "islet/span.hpp"

namespace islet::detail {

inline constexpr std::uint32_t least_contact_batch = 32;  // contacts that make workers pay

/// Whether so many contacts are made or removed by several workers. Hooks that are called one after another, and sensors, see each contact in its turn.
inline bool in_batches(const Core& core, std::uint32_t count) {
    if (!has_many_workers(core) || count < least_contact_batch) return false;
    return core.hooks.filter == nullptr && core.hooks.pre_solve == nullptr && (core.state->asked & shape_sensor) == 0;
}

/// Takes a slot for the contact of two shapes, notes these in it, and puts them into the set of pairs. False if the pool is full.
bool name_contact(Core& core, std::uint32_t shape_1, std::uint32_t shape_2, std::uint32_t& contact);
/// Does the rest of create_contact.
void make_contacts(Core& core, span<const std::uint32_t> contacts);

/// Does what destroy_contact does after leave_contact (contact_parts.hpp). Contacts that are not known (is_known) need no leave_contact before.
void remove_contacts(Core& core, span<const std::uint32_t> contacts);

}  // namespace islet::detail
