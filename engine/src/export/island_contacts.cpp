// The rows of a contact, as its kernel has them (constraint/contact.hpp): with r the arms from the two centres to the contact point,
//     normal    J = (-n, -ra x n, n, rb x n),  n from A to B
//     friction  the same along t = right_perp(n)
//     rolling   J = (0, -1, 0, 1)
#include "../exact.hpp"

#include "../export/island_problem.hpp"
#include "../graph/contacts.hpp"
#include "../graph/mixing.hpp"

namespace islet::detail {

void add_contact_rows(IslandRows& to, std::uint32_t contact) {
    constexpr float infinity = __builtin_huge_valf();
    const ContactManifold& m = to.core.manifolds[contact];
    const Pose& a = to.core.poses[m.body_a];
    const Pose& b = to.core.poses[m.body_b];
    const Vec2 n = m.normal, t = right_perp(n);
    MixedSurface surface;
    if (has_surfaces && (m.flags & contact_special) != 0) surface = surface_of(to.core, contact);

    const auto row_along = [&](RowKind kind, std::uint32_t point, Vec2 e) {
        const Vec2 ra = m.anchors[point];
        IslandRow row = to.between(m.body_a, m.body_b, e, cross(ra, e), cross(ra - m.offset, e));
        row.kind = kind;
        row.slot = contact;
        row.index = point;
        return row;
    };

    std::uint32_t normal_row[2] = {lcp::no_row, lcp::no_row};
    float pressed = 0;  // N s
    for (std::uint32_t i = 0; i < m.count(); ++i) {
        IslandRow row = row_along(RowKind::normal, i, n);
        row.bias += max(m.separation[i] + dot(n, slip_of(m, i, a, b)), 0.0f) * to.inv_h;
        normal_row[i] = to.add(row, 0, infinity, m.normal_impulse[i]);
        pressed += to.contact_warm * m.normal_impulse[i];
    }
    for (std::uint32_t i = 0; i < m.count(); ++i) {
        IslandRow row = row_along(RowKind::friction, i, t);
        row.bias -= surface.tangent_speed;
        to.add(row, 0, m.friction, m.tangent_impulse[i], normal_row[i]);
    }
    if (surface.rolling_resistance > 0) {
        IslandRow row = to.between(m.body_a, m.body_b, {0, 0}, 1, 1);
        row.kind = RowKind::rolling;
        row.slot = contact;
        const float bound = surface.rolling_resistance * pressed;
        to.add(row, -bound, bound, m.rolling_impulse);
    }
}

}  // namespace islet::detail
