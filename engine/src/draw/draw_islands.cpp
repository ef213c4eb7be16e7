// Islands, for drawing, and colours to tell them apart. Islands are the sets of dynamic bodies that contacts and joints hold together, awake or not. A step
// finds those of awake bodies only (island/batches.cpp), and does not keep them.
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
        const bool connects = pool_live(state.body_pool, core.bodies, i) && core.poses[i].inv_mass > 0 && (core.bodies[i].flags & body_disabled) == 0;
        sets.parent[i] = connects ? i : null_index;
    }
    const auto moves = [&](std::uint32_t i) { return i != null_index && sets.parent[i] != null_index; };
    const auto connect = [&](std::uint32_t a, std::uint32_t b) {
        if (!moves(a) || !moves(b)) return;
        const std::uint32_t root_a = sets.root_of(a), root_b = sets.root_of(b);
        if (root_a != root_b) sets.join(root_a, root_b);
    };
    for_each_live(state.contact_pool, core.contacts, [&](std::uint32_t i) {
        const ContactManifold& m = core.manifolds[i];
        if ((m.flags & contact_touching) != 0) connect(m.body_a, m.body_b);
    });
    if constexpr (has_joints) {
        for_each_live(state.joint_pool, core.joints, [&](std::uint32_t i) {
            const Joint& j = core.joints[i];
            // A gear couples up to four bodies. It names one that moves of each of its joints, which connect the others themselves.
            if (!is_joint_idle(core, j)) connect(j.body_a, j.body_b);
        });
    }
    // The lowest slot of a set is its root. (That of a lower slot is known already, so one look leads there.)
    for (std::uint32_t i = 0; i < state.body_pool.high_water; ++i)
        if (sets.parent[i] != null_index) sets.parent[i] = sets.root_of(i);
    return sets.parent;
}

}  // namespace islet::detail

namespace islet {

// Six hues of 256 tints each; from one number to the next the hue goes on by the golden section of the circle, so that any few in a row are far apart.
// Every other round of sixteen is paler.
DrawColor distinct_color(std::uint32_t n) {
    const std::uint32_t hue = static_cast<std::uint32_t>((std::uint64_t{n * 2654435769u} * 1536u) >> 32);
    const std::uint32_t low = (n & 16u) != 0 ? 128u : 64u;
    constexpr std::uint32_t high = 232;
    const std::uint32_t way = (high - low) * (hue & 255u) / 255u;
    const std::uint32_t up = low + way, down = high - way;
    switch (hue >> 8) {
        case 0: return high << 16 | up << 8 | low;
        case 1: return down << 16 | high << 8 | low;
        case 2: return low << 16 | high << 8 | up;
        case 3: return low << 16 | down << 8 | high;
        case 4: return up << 16 | low << 8 | high;
        default: return high << 16 | low << 8 | down;
    }
}

}  // namespace islet
