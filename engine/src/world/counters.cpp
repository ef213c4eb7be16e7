// World::counters: figures that are counted only when they are read.
#include "../exact.hpp"

#include "../data/core.hpp"

namespace islet {

using namespace detail;

namespace {

void add(WorldCounters& counters, std::uint32_t color) { ++(color == no_color ? counters.uncolored : counters.colors[color]); }

}  // namespace

WorldCounters World::counters() const {
    const Core& c = core();
    const State& state = *c.state;
    WorldCounters counters;
    counters.bytes = world_bytes(c.capacity);
    counters.snapshot_bytes = snapshot_bytes();
    counters.geometries = state.geometry_pool.count;
    counters.tree_shapes = state.tree.leaf_count;
    if (state.tree.root != null_index) counters.tree_height = c.tree[state.tree.root].height + 1;
    for (std::uint32_t i = 0; i < state.contact_pool.high_water; ++i) {
        const bool touches = pool_live(state.contact_pool, c.contacts, i) && (c.manifolds[i].flags & contact_touching) != 0;
        if (touches) add(counters, c.manifolds[i].color());
    }
    for (std::uint32_t i = 0; i < state.joint_pool.high_water; ++i)
        if (pool_live(state.joint_pool, c.joints, i)) add(counters, c.joints[i].color());
    return counters;
}

}  // namespace islet
