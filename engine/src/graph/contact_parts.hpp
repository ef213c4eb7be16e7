// The parts of making and of removing a contact. contacts.cpp does one after another for a contact; contact_batches.cpp does them side by side for many.
#pragma once

#include "../data/core.hpp"
#include "../graph/colors.hpp"
#include "../graph/constraint_list.hpp"
#include "../graph/contacts.hpp"
#include "../graph/sensors.hpp"
#include "../math/inlining.hpp"

namespace islet::detail {

/// Fills in a contact's own records.
ISLET_PART void fill_contact(Core& core, std::uint32_t index, std::uint32_t shape_1, std::uint32_t shape_2) {
    const bool in_order = in_contact_order(core, shape_1, shape_2);
    Contact& c = core.contacts[index];
    c.shape_a = static_cast<ContactIndex>(in_order ? shape_1 : shape_2);
    c.shape_b = static_cast<ContactIndex>(in_order ? shape_2 : shape_1);
    ContactManifold& m = core.manifolds[index];
    m = ContactManifold{};
    m.body_a = static_cast<ContactIndex>(core.shapes[c.shape_a].body);
    m.body_b = static_cast<ContactIndex>(core.shapes[c.shape_b].body);
    m.set_color(no_color);
    if (is_sensor(core, shape_1) || is_sensor(core, shape_2)) m.flags |= contact_sensor;
    mix_materials(core, index);
}

/// Puts one side of it into its body's list, or takes it out.
inline void attach_contact(Core& core, std::uint32_t contact, std::uint32_t side, std::uint32_t body) {
    add_to_list(core.contacts, contact, side, core.bodies[body].contact_head, core.bodies[body].contact_count);
}
inline void detach_contact(Core& core, std::uint32_t contact, std::uint32_t side, std::uint32_t body) {
    remove_from_list(core.contacts, contact, side, core.bodies[body].contact_head, core.bodies[body].contact_count);
}

/// Notes whether it is awake: whether one of its bodies is. Returns that.
inline bool note_awake(Core& core, std::uint32_t contact) {
    const bool awake = core.is_awake(core.manifolds[contact].body_a) || core.is_awake(core.manifolds[contact].body_b);
    core.awake_contacts.assign(contact, awake);
    return awake;
}

/// True if others know of it: it touches, or has a colour.
inline bool is_known(const ContactManifold& m) { return (m.flags & (contact_touching | contact_overlap)) != 0 || m.color() != no_color; }

/// Ends its touch, and frees its colour.
ISLET_PART void leave_contact(Core& core, std::uint32_t index) {
    ContactManifold& m = core.manifolds[index];
    if (is_told(m)) record_end_event(core, index);
    if (has_sensors && (m.flags & contact_overlap) != 0) end_overlap(core, index);
    if ((m.flags & contact_touching) != 0) {
        core.forget_plan();
        m.flags &= ~static_cast<std::uint32_t>(contact_touching);
        count_sharers(core, index);
    }
    release_color(core, index);
}

/// The key of its shapes in the set of pairs.
inline std::uint64_t pair_key(const Core& core, std::uint32_t contact) { return PairSet::key(core.contacts[contact].shape_a, core.contacts[contact].shape_b); }

/// Clears its own records.
ISLET_PART void clear_contact(Core& core, std::uint32_t index) {
    clear_slot(core.contacts[index]);
    core.manifolds[index] = ContactManifold{};
}

}  // namespace islet::detail
