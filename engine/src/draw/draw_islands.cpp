// Islands, for drawing: the sets of dynamic bodies that contacts and joints hold together, awake or not. A step finds those of awake bodies only
// (island/batches.cpp), and does not keep them.
#include "../exact.hpp"

#include "../draw/draw_pen.hpp"
#include "../graph/joint_graph.hpp"
#include "../island/union_find.hpp"

namespace islet::detail {

const std::uint32_t* find_all_islands(const Core& core) {
    const State& state = *core.state;
    Arena arena = core.arena();
    const UnionFind sets{arena.take<std::uint32_t>(state.body_pool.high_water)};
    for (std::uint32_t i = 0; i < state.body_pool.high_water; ++i) {
        const bool links = pool_live(state.body_pool, core.bodies, i) && core.poses[i].inv_mass > 0 && (core.bodies[i].flags & body_disabled) == 0;
        sets.parent[i] = links ? i : null_index;
    }
    const auto moves = [&](std::uint32_t i) { return i != null_index && sets.parent[i] != null_index; };
    const auto link = [&](std::uint32_t a, std::uint32_t b) {
        if (!moves(a) || !moves(b)) return;
        const std::uint32_t root_a = sets.root_of(a), root_b = sets.root_of(b);
        if (root_a != root_b) sets.join(root_a, root_b);
    };
    for_each_live(state.contact_pool, core.contacts, [&](std::uint32_t i) {
        const ContactManifold& m = core.manifolds[i];
        if ((m.flags & contact_touching) != 0) link(m.body_a, m.body_b);
    });
    if constexpr (has_joints) {
        for_each_live(state.joint_pool, core.joints, [&](std::uint32_t i) {
            const Joint& j = core.joints[i];
            // A gear couples up to four bodies. It names one that moves of each of its joints, which link the others themselves.
            if (!is_joint_idle(core, j)) link(j.body_a, j.body_b);
        });
    }
    // The lowest slot of a set is its root. (That of a lower slot is known already, so one look leads there.)
    for (std::uint32_t i = 0; i < state.body_pool.high_water; ++i)
        if (sets.parent[i] != null_index) sets.parent[i] = sets.root_of(i);
    return sets.parent;
}

}  // namespace islet::detail
