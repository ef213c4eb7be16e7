// Contacts as the user reads them.
#include "../exact.hpp"

#include "../calls/checks.hpp"
#include "../graph/contacts.hpp"
#include "../graph/mixing.hpp"

namespace islet {

using namespace detail;

namespace detail {

void read_contact(const Core& c, std::uint32_t slot, ContactInfo& out) {
    const ContactManifold& m = c.manifolds[slot];
    const Contact& contact = c.contacts[slot];
    const Pose& a = c.poses[m.body_a];
    const Pose& b = c.poses[m.body_b];
    out.shape_a = c.shape_id(contact.shape_a);
    out.shape_b = c.shape_id(contact.shape_b);
    out.normal = m.normal;
    out.point_count = m.count();
    out.friction = m.friction;
    out.restitution = mixed_restitution(c, c.shapes[contact.shape_a], c.shapes[contact.shape_b]);
    for (std::uint32_t i = 0; i < 2; ++i) {
        ContactPoint& p = out.points[i];
        const Vec2 slip = slip_of(m, i, a, b);
        p.point = a.center + rotate(a.q * inverse(m.rotation_a), m.anchors[i]) + 0.5f * slip;
        p.separation = m.separation[i] + dot(m.normal, slip);
        p.normal_impulse = m.normal_impulse[i];
        p.tangent_impulse = m.tangent_impulse[i];
        p.feature = m.ids >> (16 * i) & 0xffffu;
    }
}

}  // namespace detail

bool World::contact_at(std::uint32_t slot, ContactInfo& out) const {
    const Core& c = core();
    if (!pool_live(c.state->contact_pool, c.contacts, slot) || !is_told(c.manifolds[slot])) return false;
    read_contact(c, slot, out);
    return true;
}

namespace {

/// The touching contacts of a body, or with a shape those of this shape alone.
std::uint32_t list_contacts(const Core& c, std::uint32_t body, std::uint32_t shape, span<ContactInfo> out) {
    std::uint32_t n = 0;
    for_each_contact(c, body, [&](std::uint32_t contact, std::uint32_t) {
        const Contact& of = c.contacts[contact];
        if (!is_told(c.manifolds[contact]) || (shape != null_index && of.shape_a != shape && of.shape_b != shape)) return;
        if (n < out.size()) read_contact(c, contact, out[n]);
        ++n;
    });
    return n;
}

/// The first contact after one, or of all, that list_contacts would list: its slot + 1; 0 if there is none.
std::uint32_t next_contact_of(const Core& c, std::uint32_t body, std::uint32_t shape, std::uint32_t after, ContactInfo& out) {
    std::uint32_t key = c.bodies[body].contact_head;
    if (after != 0) {
        const std::uint32_t slot = after - 1;
        const bool of_body = pool_live(c.state->contact_pool, c.contacts, slot) && (c.manifolds[slot].body_a == body || c.manifolds[slot].body_b == body);
        if (!check(c, of_body, Error::out_of_range)) return 0;
        key = c.contacts[slot].next[c.manifolds[slot].body_a == body ? 0 : 1];
    }
    while (key != 0) {
        const std::uint32_t contact = constraint_of_key(key);
        const Contact& of = c.contacts[contact];
        key = of.next[side_of_key(key)];
        if (!is_told(c.manifolds[contact]) || (shape != null_index && of.shape_a != shape && of.shape_b != shape)) continue;
        read_contact(c, contact, out);
        return contact + 1;
    }
    return 0;
}

}  // namespace

std::uint32_t World::contacts(BodyId id, span<ContactInfo> out) const { ISLET_READ(list_contacts(c, i, null_index, out)); }
std::uint32_t World::contacts(ShapeId id, span<ContactInfo> out) const { ISLET_READ(list_contacts(c, c.shapes[i].body, i, out)); }

std::uint32_t World::next_contact(BodyId id, std::uint32_t contact, ContactInfo& out) const { ISLET_READ(next_contact_of(c, i, null_index, contact, out)); }
std::uint32_t World::next_contact(ShapeId id, std::uint32_t contact, ContactInfo& out) const {
    ISLET_READ(next_contact_of(c, c.shapes[i].body, i, contact, out));
}

}  // namespace islet
