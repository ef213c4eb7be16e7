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

}  // namespace

std::uint32_t World::contacts(BodyId id, span<ContactInfo> out) const { ISLET_READ(list_contacts(c, i, null_index, out)); }
std::uint32_t World::contacts(ShapeId id, span<ContactInfo> out) const { ISLET_READ(list_contacts(c, c.shapes[i].body, i, out)); }

}  // namespace islet
