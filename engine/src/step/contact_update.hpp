// The narrow phase over all awake contacts: manifolds, begin and end touch.
#pragma once

#include "../data/core.hpp"

namespace islet::detail {

void update_contacts(Core& core, float dt);

/// How far B's material has moved from A's at a contact point since the manifold was made, m. Their velocity apart is its rate of change.
inline Vec2 slip_of(const ContactManifold& m, std::uint32_t point, const Pose& a, const Pose& b) {
    const Vec2 ra = m.anchors[point];
    const Vec2 rb = ra - m.offset;
    return (b.center - a.center) + rotate(b.q * inverse(m.rotation_b), rb) - rotate(a.q * inverse(m.rotation_a), ra);
}

}  // namespace islet::detail
