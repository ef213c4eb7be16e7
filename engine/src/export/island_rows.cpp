// What all rows of an exported island have in common.
#include "../exact.hpp"

#include "../export/island_problem.hpp"
#include "../graph/joint_graph.hpp"
#include "../solver/free_motion.hpp"

namespace islet::detail {

float inv_inertia_of(const Core& core, std::uint32_t body) { return stiffened(core.poses[body].inv_inertia, core.bodies[body].stretch); }

FreeVelocity free_velocity_of(const Core& core, std::uint32_t body, float h) {
    SolverMotion m;
    gather_motion(m, core, body, h);
    // In trees of hinges that are solved exactly spin is scaled with the inertia (solver/tree_solve.hpp).
    bool exact = false;
    if (core.poses[body].inv_inertia > 0)  // the ground has many joints, and no spin to scale
        for_each_joint(core, body, [&](std::uint32_t joint, std::uint32_t) { exact = exact || (core.joints[joint].flags & joint_exact) != 0; });
    if (exact) m.angular_factor *= inv_inertia_of(core, body) / core.poses[body].inv_inertia;
    const float dt = h * static_cast<float>(core.state->solver.substeps);
    return {free_velocity(m, core.motions[body].v, core.state->max_speed), free_turn(m, core.motions[body].w, max_turn_of(dt))};
}

void IslandRows::add_end(IslandRow& row, std::uint32_t body, Vec2 linear, float angular) const {
    RowEnd end{no_body, linear, angular};
    if (core.poses[body].inv_mass > 0) {
        end.body = members.place_of[body];
        for (std::uint32_t i = 0; i < row.end_count; ++i) {
            if (row.ends[i].body != end.body) continue;
            row.ends[i].linear += linear;
            row.ends[i].angular += angular;
            return;
        }
    } else {
        const FreeVelocity free = free_velocity_of(core, body, h);
        row.bias += dot(linear, free.v) + angular * free.w;
    }
    row.ends[row.end_count++] = end;
}

IslandRow IslandRows::between(std::uint32_t a, std::uint32_t b, Vec2 e, float sa, float sb) const {
    IslandRow row;
    add_end(row, a, -e, -sa);
    add_end(row, b, e, sb);
    return row;
}

float IslandRows::coupling(const IslandRow& r, const IslandRow& s) const {
    float sum = 0;
    for (std::uint32_t i = 0; i < r.end_count; ++i) {
        const RowEnd& a = r.ends[i];
        if (a.body == no_body) continue;
        for (std::uint32_t k = 0; k < s.end_count; ++k) {
            const RowEnd& b = s.ends[k];
            if (b.body != a.body) continue;
            const std::uint32_t body = members.bodies[a.body];
            sum += core.poses[body].inv_mass * dot(a.linear, b.linear) + inv_inertia_of(core, body) * (a.angular * b.angular);
        }
    }
    return sum;
}

std::uint32_t IslandRows::add(const IslandRow& row, float low, float high, float impulse, std::uint32_t friction_of) {
    if (!(coupling(row, row) > 0)) return lcp::no_row;
    if (rows != nullptr) {
        rows[count] = row;
        lo[count] = low;
        hi[count] = high;
        const bool of_contact = row.kind == RowKind::normal || row.kind == RowKind::friction || row.kind == RowKind::rolling;
        impulses[count] = (of_contact ? contact_warm : warm) * impulse;
        friction[count] = friction_of;
    }
    return count++;
}

}  // namespace islet::detail
