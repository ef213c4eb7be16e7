// What the world holds, for who looks into a finding.
#include <cstdio>

#include "data/core.hpp"
#include "player.hpp"

namespace islet::fuzz {

void print(const World& w) {
    const SolverDef d = w.solver();
    std::fprintf(stderr, "  gravity %g %g; schedule %d, %u substeps, %u + %u sweeps, order %d, trees %d, block %d, contacts %g Hz, joints %g Hz, omega %g, "
                         "shock %g, tolerance %g\n",
                 double(w.gravity().x), double(w.gravity().y), int(d.schedule), d.substeps, d.iterations, d.relax_iterations, int(d.sweep_order),
                 int(d.joint_trees), int(d.block_contacts), double(d.contact_hertz), double(d.joint_hertz), double(d.omega), double(d.shock), double(d.tolerance));
    for (std::uint32_t slot = 0; slot < capacity.bodies; ++slot) {
        const BodyId b = w.body_at(slot);
        if (!b) continue;
        const Vec2 p = w.center_of_mass(b), v = w.linear_velocity(b);
        std::fprintf(stderr, "  body %u: type %d, mass %g, inertia %g, at %.9g %.9g turned %g, v %g %g, w %g%s\n", slot, int(w.type(b)), double(w.mass(b)),
                     double(w.rotational_inertia(b)), double(p.x), double(p.y), double(w.angle(b)), double(v.x), double(v.y),
                     double(w.angular_velocity(b)), w.is_awake(b) ? "" : ", asleep");
        const detail::Motion& m = detail::Core::of(w).motions[slot];
        std::fprintf(stderr, "    force %g %g, torque %g, slack %g, at rest for %g s, reach %g\n", double(m.force.x), double(m.force.y), double(m.torque),
                     double(m.slack), double(m.sleep_time), double(detail::Core::of(w).poses[slot].max_extent));
        ShapeId all[capacity.shapes];
        const std::uint32_t n = w.shapes(b, all);
        for (std::uint32_t i = 0; i < n; ++i) {
            const Aabb box = w.aabb(all[i]);
            std::fprintf(stderr, "    shape %u: type %d, %g %g to %g %g, friction %g, restitution %g, rolling %g, surface %g\n", all[i].index1 - 1,
                         int(w.shape_type(all[i])), double(box.lower.x), double(box.lower.y), double(box.upper.x), double(box.upper.y),
                         double(w.friction(all[i])), double(w.restitution(all[i])), double(w.rolling_resistance(all[i])), double(w.tangent_speed(all[i])));
        }
    }
    for (std::uint32_t slot = 0; slot < capacity.joints; ++slot) {
        const JointId j = w.joint_at(slot);
        if (!j) continue;
        const Vec2 force = w.joint_force(j);
        std::fprintf(stderr, "  joint %u: type %d, bodies %u %u, force %g %g, torque %g\n", slot, int(w.joint_type(j)), w.body_a(j).index1 - 1,
                     w.body_b(j).index1 - 1, double(force.x), double(force.y), double(w.joint_torque(j)));
    }
    ContactInfo c;
    for (std::uint32_t slot = 0; slot < capacity.contacts; ++slot) {
        if (!w.contact_at(slot, c)) continue;
        std::fprintf(stderr, "  contact %u: shapes %u %u, normal %g %g, friction %g\n", slot, c.shape_a.index1 - 1, c.shape_b.index1 - 1,
                     double(c.normal.x), double(c.normal.y), double(c.friction));
        for (std::uint32_t i = 0; i < c.point_count; ++i) {
            const ContactPoint& p = c.points[i];
            std::fprintf(stderr, "    %g %g, separation %g, impulses %g %g\n", double(p.point.x), double(p.point.y), double(p.separation),
                         double(p.normal_impulse), double(p.tangent_impulse));
        }
    }
}

}  // namespace islet::fuzz
